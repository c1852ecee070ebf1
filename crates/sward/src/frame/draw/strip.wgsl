// Strips (O section 4): a plant is two textured triangle strips that share their middle line, each
// turned out of the blade's plane. One instance is 64 plants.

struct StripVertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) @interpolate(perspective, centroid) normal: vec3<f32>,
    @location(1) @interpolate(perspective, centroid) side: vec3<f32>,
    @location(2) @interpolate(perspective, centroid) tint: vec3<f32>,
    @location(3) @interpolate(perspective, centroid) position: vec3<f32>,
    // Across -1..1, share of the length 0..1
    @location(4) @interpolate(perspective, centroid) place: vec2<f32>,
    @location(5) @interpolate(flat) up: vec3<f32>,
    // Light at the roots, lean
    @location(6) @interpolate(flat) canopy: vec2<f32>,
    // Layer of its picture, species
    @location(7) @interpolate(flat) look: vec2<u32>,
}

// Dry grass, which O mixes into the tint of each blade by chance.
const ORANGE: vec3<f32> = vec3<f32>(0.42, 0.2, 0.035);
// Share of the light that a strip's own picture takes off in the mean.
const PICTURE_MEAN: f32 = 0.55;

fn strip_width(blade: Blade, fade: f32) -> f32 {
    let distance = distance_to(blade.root + blade.up * (0.5 * blade.height));
    let width = blade.width * fade;
    if has(CULL_DISTANCE) && !has(CULL_PAPER) {
        return width * widening(keep_share(blade.width * pixels_per_metre(distance)));
    }
    return width;
}

fn strip_vertex(vertex: u32, instance: u32) -> StripVertex {
    let listed = listed_plant(vertex, instance);
    var out: StripVertex;
    out.clip = HIDDEN;
    if listed.hidden {
        return out;
    }
    let blade = unpack_blade(listed.index);
    let tip = unpack_state(blade, dynamics[listed.index]).tip;
    let kind = page.species[blade.species];
    let corner = vertex % VERTICES;
    let ring = corner / 3u;
    let across = f32(corner % 3u) - 1.0;
    let sway = sway_of(blade, tip);
    let width = strip_width(blade, listed.fade);
    let point = morphed_point(blade, tip, sway, width, ring, across, listed.morph);
    out.clip = view.clip_from_world * vec4<f32>(point.position, 1.0);
    out.position = point.position;
    out.normal = point.normal;
    out.side = point.side;
    let share = point.share;
    let own = blade_color(blade, share * (1.5 - 0.5 * share));
    let dry = hash01(blade.id, 23u);
    out.tint = mix(own, ORANGE * (0.4 + 0.6 * share), dry * dry * strip_values(blade.species).z);
    out.place = vec2<f32>(across, share);
    out.up = blade.up;
    let lean = lean_of(blade, tip);
    out.canopy = vec2<f32>(kind.form.z, lean);
    out.look = vec2<u32>(strip_layer(blade), blade.species);
    return out;
}

@vertex
fn vs_strip(
    @builtin(vertex_index) vertex: u32,
    @builtin(instance_index) instance: u32,
) -> StripVertex {
    return strip_vertex(vertex, instance);
}

// Which of its species' pictures a plant has.
fn strip_layer(blade: Blade) -> u32 {
    let look = page.species[blade.species].look;
    if look.x != FORM_STRIP {
        // The last is the plain blade of strips
        return textureNumLayers(plant_color) - 1u;
    }
    let pick = u32(hash01(blade.id, 25u) * f32(look.z));
    return look.y + min(pick, max(look.z, 1u) - 1u);
}

// The strip that a point across lies on, roughened by its picture, on the eye's side.
fn strip_normal(in: StripVertex, picture: vec3<f32>, to_eye: vec3<f32>) -> vec3<f32> {
    let fold = 0.5 * strip_values(in.look.y).x;
    let hand = select(-1.0, 1.0, in.place.x >= 0.0);
    let face = in.normal * cos(fold) - in.side * (hand * sin(fold));
    let around = in.side * cos(fold) + in.normal * (hand * sin(fold));
    let bent = unit_or(face + around * (picture.x * 2.0 - 1.0), in.up);
    return select(-bent, bent, dot(face, to_eye) >= 0.0);
}

@fragment
fn fs_strip(in: StripVertex) -> @location(0) vec4<f32> {
    // Row 0 of a picture is the tip
    let uv = vec2<f32>(0.5 + 0.5 * in.place.x, 1.0 - in.place.y);
    let texel = textureSample(plant_color, picture_sampler, uv, in.look.x);
    let relief = textureSample(plant_normal, picture_sampler, uv, in.look.x);
    let alpha = outline_alpha(texel.a, 1.0);
    if alpha < least_alpha() {
        discard;
    }
    let to_eye = -view_ray(in.position);
    var surface: BladeSurface;
    // Square root encoded
    surface.albedo = in.tint * texel.rgb * texel.rgb / PICTURE_MEAN;
    surface.normal = strip_normal(in, relief.xyz, to_eye);
    surface.up = in.up;
    surface.height_share = in.place.y;
    surface.root_open = in.canopy.x;
    surface.lean = in.canopy.y;
    surface.shaded = sun_shade(in.position);
    let color = with_haze(shade_blade(surface, to_eye), distance_to(in.position));
    return vec4<f32>(max(color, vec3<f32>(0.0)), alpha);
}

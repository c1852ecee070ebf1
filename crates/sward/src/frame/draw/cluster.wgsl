// Clusters: a picture of 32 blades each, on a card through the cylinder that holds them. The card
// runs from the cylinder's near foot to its far top, so that it covers what the cylinder does on the
// screen from any elevation, and never goes under the ground.

struct ClusterVertex {
    @builtin(position) clip: vec4<f32>,
    @location(0) @interpolate(perspective, centroid) uv: vec2<f32>,
    // The colour of a texel t is `base` + `gain` t t
    @location(1) @interpolate(flat) base: vec3<f32>,
    @location(2) @interpolate(flat) gain: vec3<f32>,
    // Cells of the grain, across and along
    @location(3) @interpolate(flat) cells: vec2<f32>,
    @location(4) @interpolate(flat) layer: u32,
    @location(5) @interpolate(flat) seed: u32,
    // What its texels' alpha is multiplied by
    @location(6) @interpolate(flat) alpha: f32,
    // Which of the picture's sizes
    @location(7) @interpolate(flat) mip: f32,
}

// What moves the top of a patch's clusters, in heights: what the wind has moved its blades' tips by
// from where they rest. At rest the tips are so high in the mean.
fn sway_of(index: u32, up: vec3<f32>) -> vec3<f32> {
    let sway = unpack_sway(bands[(index / page.field.patch_size) * bands_per_patch()].sway);
    let rise = dot(sway, up);
    return sway - up * (rise - min(rise / max(canopy.pose.w, 0.05), 0.0));
}

fn cluster_vertex(vertex: u32, instance: u32) -> ClusterVertex {
    var out: ClusterVertex;
    out.clip = HIDDEN;
    let listed = listed_plant(vertex, instance);
    if listed.hidden {
        return out;
    }
    let blade = unpack_blade(listed.index);
    let cluster = page.field.cluster;
    let distance = distance_to(blade.root + blade.up * (0.5 * blade.height));
    let to_eye = -view_ray(blade.root + blade.up * (0.5 * cluster.z));
    let facing = facing_of(blade.up, to_eye);
    let sway = sway_of(listed.index, blade.up);
    let scale = pixels_per_metre(distance);
    let count = patch_blades(listed.index / page.field.patch_size);
    let elevation = asin(clamp(facing.sine, 0.0, 1.0)) * (3.0 / 1.5707963);
    let met = patch_light[listed.index / page.field.patch_size].a;
    // Narrow cards of blades are narrow blades; of flowers they would be streaks, which come texel by texel
    let dissolves = form_of(blade.species) == FORM_BILLBOARD;
    let wide = select(listed.fade, 1.0, dissolves) * cluster_widening(cluster, scale, count)
        * wider(elevation, facing, sway, met, clusters_grown(cluster_progress(cluster.x * scale)));
    let corner = vertex % VERTICES;
    let position = blade.root
        + card_corner(corner, facing, blade.up, cluster.y, cluster.z, wide, sway);
    out.clip = view.clip_from_world * vec4<f32>(position, 1.0);
    out.uv = vec2<f32>(f32(corner & 1u), f32(corner < 2u));
    let picture = picture_of(blade.id, elevation);
    out.layer = picture.layer;
    out.alpha = picture.alpha * select(1.0, listed.fade, dissolves);
    out.seed = hash_u32(blade.id);
    let size_m = vec2<f32>(2.0 * cluster.y * wide, card_height(elevation));
    let size_px = max(size_m * scale, vec2<f32>(1e-3));
    out.mip = mip_of(size_px, out.seed);
    out.cells = grain_cells(size_px);
    let haze = select(1.0 - exp(-frame.haze.w * distance), 0.0, frame.haze.w == 0.0);
    let look = thin_look(listed.index, 2.0 * cluster.w * scale);
    var texels = card_tone(elevation, facing.sine);
    if TINTED {
        texels = vec3<f32>(canopy_luminance(texels));
    }
    out.base = mix(look.rgb * (1.0 - look.a), frame.haze.rgb, haze);
    out.gain = look.rgb * look.a * (1.0 - haze) / texels;
    return out;
}

// The picture's size that has a texel a pixel lies between two: either by chance, so that one is read
// where the mean of two would be.
fn mip_of(size_px: vec2<f32>, seed: u32) -> f32 {
    let texels = f32(textureDimensions(cluster_color).x);
    let between = max(log2(texels / min(size_px.x, size_px.y)), 0.0);
    return floor(between + hash01(seed, 53u));
}

// Cells are about a pixel wide and four high, as the blades are that are narrower than that.
fn grain_cells(size_px: vec2<f32>) -> vec2<f32> {
    return exp2(floor(log2(max(size_px, vec2<f32>(1.0))))) * vec2<f32>(1.0, 0.25);
}

@vertex
fn vs_cluster(
    @builtin(vertex_index) vertex: u32,
    @builtin(instance_index) instance: u32,
) -> ClusterVertex {
    return cluster_vertex(vertex, instance);
}

// A random number a cell of the picture, 0 to 1. Cells belong to the cluster, so they move with it.
fn grain(uv: vec2<f32>, cells: vec2<f32>, seed: u32) -> f32 {
    let cell = vec2<u32>(max(uv, vec2<f32>(0.0)) * cells);
    return hash01(cell.x + (cell.y << 16u), seed);
}

// The samples of a pixel that so much alpha covers: as many in the mean, one more or fewer by the
// grain. Each cell begins at another one, so that clusters that lie over each other do not all cover
// the same.
fn samples_covered(alpha: f32, grain: f32, seed: u32) -> u32 {
    let count = u32(clamp(alpha * f32(SAMPLES) + grain, 0.0, f32(SAMPLES)));
    let whole = (1u << SAMPLES) - 1u;
    let mask = (1u << count) - 1u;
    let turn = (seed + u32(grain * 64.0)) % SAMPLES;
    return ((mask << turn) | (mask >> (SAMPLES - turn))) & whole;
}

struct ClusterPixel {
    @location(0) color: vec4<f32>,
    @builtin(sample_mask) samples: u32,
}

fn cluster_texel(in: ClusterVertex) -> vec4<f32> {
    return textureSampleLevel(cluster_color, picture_sampler, in.uv, in.layer, in.mip);
}

fn cluster_radiance(in: ClusterVertex, texel: vec3<f32>) -> vec4<f32> {
    var own = texel * texel;
    if TINTED {
        // The baked colours are of other places: what is brighter there is brighter here
        own = vec3<f32>(canopy_luminance(own));
    }
    return vec4<f32>(in.base + in.gain * own, 1.0);
}

@fragment
fn fs_cluster(in: ClusterVertex) -> ClusterPixel {
    let texel = cluster_texel(in);
    let samples = samples_covered(texel.a * in.alpha, grain(in.uv, in.cells, in.seed), in.seed);
    if samples == 0u {
        discard;
    }
    return ClusterPixel(cluster_radiance(in, texel.rgb), samples);
}

// Where a pixel has one sample.
@fragment
fn fs_cluster_single(in: ClusterVertex) -> @location(0) vec4<f32> {
    let texel = cluster_texel(in);
    if texel.a * in.alpha + grain(in.uv, in.cells, in.seed) < 1.0 {
        discard;
    }
    return cluster_radiance(in, texel.rgb);
}

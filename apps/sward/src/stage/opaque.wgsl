// The scene's opaque things: Lambert sun and sky, a little gloss.

@group(1) @binding(0) var base_texture: texture_2d<f32>;
@group(1) @binding(1) var base_sampler: sampler;
@group(1) @binding(2) var<uniform> canopy: GpuCanopy;
// x how far grass stands upright: 0 along the surface's normal, 1 straight up; yzw how far the wind moves
// its mean tip, in heights
@group(1) @binding(3) var<uniform> stance: vec4<f32>;

// Whether the scene has moving shade
override SHADED: bool = true;
// Whether ground may show the look of grass in the place of grass
override CANOPY: bool = true;

struct VertexIn {
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) uv: vec2<f32>,
    @location(3) color: vec4<f32>,
    // xyz place, w scale
    @location(4) placement: vec4<f32>,
    // A quaternion
    @location(5) rotation: vec4<f32>,
    // rgb reflectance, w roughness
    @location(6) material: vec4<f32>,
    // rgb of the grass that grows on it, w its share; below 0 where it carries none
    @location(7) grass: vec4<f32>,
    // rgb of every other stripe, w how many there are
    @location(8) stripe: vec4<f32>,
}

struct Surfel {
    // The depth pass and the colour pass must agree to the last bit
    @builtin(position) @invariant position: vec4<f32>,
    @location(0) world: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) uv: vec2<f32>,
    @location(3) color: vec3<f32>,
    @location(4) @interpolate(flat) material: vec4<f32>,
    @location(5) @interpolate(flat) grass: vec4<f32>,
    @location(6) @interpolate(flat) stripe: vec4<f32>,
}

fn turned(q: vec4<f32>, v: vec3<f32>) -> vec3<f32> {
    return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v);
}

@vertex
fn opaque_vertex(in: VertexIn) -> Surfel {
    let world = turned(in.rotation, in.position * in.placement.w) + in.placement.xyz;
    return Surfel(
        frame.clip_from_world * vec4(world, 1.0),
        world,
        turned(in.rotation, in.normal),
        in.uv,
        in.color.rgb,
        in.material,
        in.grass,
        in.stripe,
    );
}

// A beach ball: stripes along the longitudes and a cap at each pole, their edges a pixel wide.
fn striped(plain: vec3<f32>, stripe: vec4<f32>, uv: vec2<f32>) -> vec3<f32> {
    // The seam of the longitudes jumps; it lies where a stripe ends, so its width may be that of v
    let along = abs(fract(uv.x * stripe.w) - 0.5) - 0.25;
    let along_px = max(length(vec2(dpdx(uv.y), dpdy(uv.y))) * frame.samples_a_side * stripe.w, 1e-6);
    let cap = abs(uv.y - 0.5) - 0.44;
    let cap_px = max(fwidth(uv.y) * frame.samples_a_side, 1e-6);
    let share = max(
        clamp(along / along_px + 0.5, 0.0, 1.0),
        clamp(cap / cap_px + 0.5, 0.0, 1.0),
    );
    return mix(plain, stripe.rgb, share * f32(stripe.w > 0.0));
}

// Specular of a dielectric: GGX with Schlick's Fresnel and a cheap visibility term.
fn gloss(n: vec3<f32>, v: vec3<f32>, l: vec3<f32>, roughness: f32) -> f32 {
    let h = normalize(v + l + vec3(0.0, 1e-6, 0.0));
    let a = max(roughness * roughness, 0.02);
    let nh = max(dot(n, h), 0.0);
    let lh = max(dot(l, h), 0.05);
    let d = nh * nh * (a * a - 1.0) + 1.0;
    let fresnel = 0.04 + 0.96 * pow(1.0 - lh, 5.0);
    return a * a / (PI * d * d) * fresnel * 0.25 / (lh * lh * (roughness + 0.5));
}

@fragment
fn opaque_fragment(in: Surfel, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    let pixel_m = length(fwidth(in.world)) * frame.samples_a_side;
    let texel = textureSampleBias(base_texture, base_sampler, in.uv, log2(frame.samples_a_side)).rgb;
    let v = normalize(frame.eye.xyz - in.world);
    // A zero normal, as a degenerate corner has, must not become NaN.
    let outward = in.normal / max(length(in.normal), 1e-12);
    var n = select(-outward, outward, front);
    let base = striped(in.material.rgb, in.stripe, in.uv) * in.color * texel;
    var albedo = base;
    let up = normalize(mix(outward, vec3(0.0, 1.0, 0.0), stance.x) + vec3(0.0, 1e-6, 0.0));
    var grass = 0.0;
    if CANOPY {
        // Grass grows outward: who looks from behind sees none
        grass = grass_on_ground(up, in.world, v) * f32(dot(outward, v) > 0.0);
    }
    var sunlit = 0.0;
    if in.grass.w >= 0.0 {
        let ground = ground_material(in.world, n, albedo, in.grass, pixel_m);
        albedo = ground.albedo;
        n = ground.normal;
        sunlit = ground.canopy;
    }
    let l = frame.to_sun.xyz;
    let lit = max(dot(n, l), 0.0);
    let ambient = mix(frame.ground.rgb, frame.sky.rgb, n.y * 0.5 + 0.5);
    // Blades stand across the ground: the canopy is lit from the side too.
    let received = mix(lit, 0.35 + 0.65 * lit, sunlit * smoothstep(-0.3, 0.2, dot(n, l)));
    var shaded = 0.0;
    if SHADED {
        shaded = shade_pattern(in.world, l, frame.shade, frame.shade_offset);
    }
    let sun = frame.sun.rgb * (1.0 - shaded);
    var color = albedo * (sun * received / PI + ambient);
    if in.grass.w < 0.0 {
        color += sun * lit * gloss(n, v, l, in.material.w);
    }
    if CANOPY && grass > 0.002 {
        let look = canopy_tinted(canopy_radiance(up, v, stance.yzw, shaded), base);
        color = mix(color, look, grass);
    }
    let clear = exp(-frame.haze.w * distance(frame.eye.xyz, in.world));
    // Below 0: ground that stands for grass, and how much of it does
    return vec4(mix(frame.haze.rgb, color, clear), -mix(sunlit, 1.0, grass));
}

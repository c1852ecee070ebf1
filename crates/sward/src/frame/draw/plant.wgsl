// What drawing reads, whichever form a plant has: one instance is 64 plants of one bucket.

// Which bucket, see field.wgsl
override BUCKET: u32 = 0u;
// Vertices a plant
override VERTICES: u32 = 17u;
// Samples a pixel of the target
override SAMPLES: u32 = 1u;
// Whether `tints` holds a colour for each blade
override TINTED: bool = false;

@group(1) @binding(3) var<storage, read> dynamics: array<vec2<u32>>;
// The colour of the surface at each root, where TINTED
@group(1) @binding(4) var<storage, read> tints: array<u32>;
@group(2) @binding(1) var<storage, read> list: array<u32>;
@group(2) @binding(2) var<uniform> draws: array<GpuDraw, 16>;

// Behind the near plane: where vertices go that nothing shows of.
const HIDDEN: vec4<f32> = vec4<f32>(0.0, 0.0, -1.0, 1.0);

// An entry of the draw list.
struct Listed {
    index: u32,
    // 0: the level's own form; 1: the next level's
    morph: f32,
    // What is left of its width, 0..1
    fade: f32,
    // Beyond the end of the list
    hidden: bool,
}

fn listed_plant(vertex: u32, instance: u32) -> Listed {
    let slot = instance * BAND + vertex / VERTICES;
    if slot >= draws[BUCKET].count {
        return Listed(0u, 0.0, 0.0, true);
    }
    let entry = list[draws[BUCKET].start + slot];
    let morph = f32((entry >> 22u) & 31u) / 31.0;
    return Listed(entry & 0x3fffffu, morph, f32(entry >> 27u) / 31.0, false);
}

// How far a plant lies over, from its tip in heights: 0 upright, 1 flat.
fn lean_of(blade: Blade, tip: vec3<f32>) -> f32 {
    return min(length(tip - blade.up * dot(tip, blade.up)), 1.0);
}

// 10 bits a channel, square root encoded.
fn unpack_color(bits: u32) -> vec3<f32> {
    let c = vec3<f32>(f32(bits & 0x3ffu), f32((bits >> 10u) & 0x3ffu), f32(bits >> 20u)) / 1023.0;
    return c * c;
}

// `tone` runs from the root's colour, 0, to the tip's, 1.
fn blade_color(blade: Blade, tone: f32) -> vec3<f32> {
    let pick = hash01(blade.id, 21u);
    let other = hash01(blade.id, 22u);
    let colors = page.species[blade.species].colors;
    let root = mix(unpack_color(colors.x), unpack_color(colors.y), other);
    let tip = mix(unpack_color(colors.z), unpack_color(colors.w), pick);
    var color = mix(root, tip, tone);
    if TINTED {
        let own = unpack_color(tints[blade.id - page.field.first_id]);
        color = mix(color, own * mix(0.8, 1.05, tone), page.species[blade.species].tint);
    }
    return color * (0.85 + 0.3 * other);
}

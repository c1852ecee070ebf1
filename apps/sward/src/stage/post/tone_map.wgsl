// Exposure, tone mapping, sRGB encoding.

override AGX: bool = false;

@group(1) @binding(0) var color: texture_2d<f32>;

// Khronos PBR Neutral: colours below the shoulder stay as they are, brighter ones roll off to white.
fn tone_map_pbr_neutral(light: vec3<f32>) -> vec3<f32> {
    const SHOULDER = 0.76;
    const DESATURATION = 0.15;
    let least = min(light.r, min(light.g, light.b));
    // Takes off the 4 % that a dielectric reflects, so that dark colours stay saturated.
    let base = light - select(0.04, least - 6.25 * least * least, least < 0.08);
    let peak = max(base.r, max(base.g, base.b));
    if peak < SHOULDER {
        return base;
    }
    let room = 1.0 - SHOULDER;
    let rolled = 1.0 - room * room / (peak + room - SHOULDER);
    let whiteness = 1.0 - 1.0 / (DESATURATION * (peak - rolled) + 1.0);
    return mix(base * (rolled / peak), vec3(rolled), whiteness);
}

fn srgb_encode(linear: vec3<f32>) -> vec3<f32> {
    let high = 1.055 * pow(max(linear, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
    return select(high, linear * 12.92, linear <= vec3(0.0031308));
}

// By the moon eyes see hardly any colour, and blue best (Purkinje).
fn by_rods(light: vec3<f32>) -> vec3<f32> {
    let seen = dot(light, vec3(0.06, 0.6, 0.34));
    return mix(light, seen * vec3(0.8, 1.0, 1.25), frame.rods);
}

@fragment
fn tone_map(in: Fullscreen) -> @location(0) vec4<f32> {
    let light = textureLoad(color, vec2<i32>(in.position.xy), 0).rgb * frame.exposure;
    if AGX {
        let shown = srgb_encode(clamp(tone_map_agx(by_rods(light)), vec3(0.0), vec3(1.0)));
        // Dark even skies would show steps: half a step of fixed noise hides them
        let noise = fract(52.982918 * fract(dot(in.position.xy, vec2(0.06711056, 0.00583715))));
        return vec4(shown + (noise - 0.5) / 255.0, 1.0);
    }
    return vec4(srgb_encode(clamp(tone_map_pbr_neutral(light), vec3(0.0), vec3(1.0))), 1.0);
}

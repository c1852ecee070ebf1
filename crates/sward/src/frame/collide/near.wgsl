// Goes over the primitives near a blade: the members that its patch lists, chunk by chunk, less the
// chunks that the blade is not near. What found no place in a full list is looked for from the
// chunks themselves: slower, but nothing is missed.

// False in pipelines for steps without colliders.
override COLLIDERS: bool = true;

const NO_PRIMITIVE: u32 = 0xffffffffu;

struct Near {
    // Ball round the blade, metres
    center: vec3<f32>,
    radius_squared: f32,
    // Next slot and their end, in words
    slot: u32,
    end: u32,
    // Next chunk without a slot
    rest: u32,
    // First member of the present chunk, and those left of it
    first: u32,
    bits: vec2<u32>,
}

fn near_begin(patch_index: u32, center: vec3<f32>, radius: f32) -> Near {
    let list = patch_index * NEAR_STRIDE;
    let slots = list + 2u;
    let end = slots + 3u * ((near[list] >> 8u) & 0xffu);
    return Near(center, radius * radius, slots, end, near[list + 1u], 0u, vec2<u32>(0u));
}

fn all_members(count: u32) -> vec2<u32> {
    let low = select((1u << count) - 1u, 0xffffffffu, count >= 32u);
    let high = select(0u, select((1u << (count - 32u)) - 1u, 0xffffffffu, count >= 64u), count > 32u);
    return vec2<u32>(low, high);
}

// Index of the next primitive, or NO_PRIMITIVE.
fn near_next(at: ptr<function, Near>) -> u32 {
    loop {
        let bits = (*at).bits;
        if bits.x != 0u {
            (*at).bits.x = bits.x & (bits.x - 1u);
            return (*at).first + firstTrailingBit(bits.x);
        }
        if bits.y != 0u {
            (*at).bits.y = bits.y & (bits.y - 1u);
            return (*at).first + 32u + firstTrailingBit(bits.y);
        }
        var chunk = (*at).rest;
        if (*at).slot < (*at).end {
            chunk = near[(*at).slot];
            (*at).bits = vec2<u32>(near[(*at).slot + 1u], near[(*at).slot + 2u]);
            (*at).slot += 3u;
        } else if chunk < frame.chunk_count {
            (*at).bits = all_members(primitives[chunk * CHUNK_STRIDE].a.w);
            (*at).rest++;
        } else {
            return NO_PRIMITIVE;
        }
        let entry = primitives[chunk * CHUNK_STRIDE];
        (*at).first = chunk * CHUNK_STRIDE + 1u;
        let low = bitcast<vec3<f32>>(entry.a.xyz);
        let high = bitcast<vec3<f32>>(entry.b.xyz);
        if to_box_squared((*at).center, low, high) >= (*at).radius_squared {
            (*at).bits = vec2<u32>(0u);
        }
    }
    return NO_PRIMITIVE;
}

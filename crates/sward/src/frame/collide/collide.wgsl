// Colliders near each patch: one thread a patch. A blade then tests only those.

@group(2) @binding(0) var<storage, read_write> near: array<u32>;
@group(2) @binding(1) var<storage, read_write> work: array<vec2<u32>>;
// Dispatch size in words 0 to 2; word 4 visible blades, word 5 spheres beyond the lists
@group(2) @binding(2) var<storage, read_write> work_size: array<atomic<u32>, 8>;


@compute @workgroup_size(64)
fn collide(@builtin(global_invocation_id) thread: vec3<u32>) {
    let index = thread.x;
    if index >= field.patch_count {
        return;
    }
    let low = patches[index].reach_min;
    let high = patches[index].reach_max;
    let first = index * NEAR_STRIDE;
    var count = 0u;
    var beyond = 0u;
    for (var s = 0u; s < frame.sphere_count; s++) {
        let sphere = spheres[s];
        let away = sphere.xyz - clamp(sphere.xyz, low, high);
        if dot(away, away) < sphere.w * sphere.w {
            if count < NEAR_STRIDE - 1u {
                count++;
                near[first + count] = s;
            } else {
                beyond++;
            }
        }
    }
    near[first] = count;
    if count > 0u {
        let slot = atomicAdd(&work_size[0], 1u);
        work[slot] = vec2<u32>(index, patch_blades(index));
    }
    if beyond > 0u {
        atomicAdd(&work_size[5], beyond);
    }
}

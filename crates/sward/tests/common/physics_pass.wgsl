// Runs a model on each blade of a list: the entry of a test, not of the library.

const COLLIDERS: bool = true;

@group(1) @binding(0) var<storage, read> test_blades: array<Blade>;
@group(1) @binding(1) var<storage, read_write> test_states: array<BladeState>;
@group(1) @binding(2) var<storage, read> test_gaps: array<f32>;

const NO_PRIMITIVE: u32 = 0xffffffffu;

// Each blade has as many primitives.
struct Near {
    next: u32,
    end: u32,
}

fn near_begin(list: u32, center: vec3<f32>, radius: f32) -> Near {
    return Near(list * frame.chunk_count, (list + 1u) * frame.chunk_count);
}

fn near_next(at: ptr<function, Near>) -> u32 {
    if (*at).next >= (*at).end {
        return NO_PRIMITIVE;
    }
    (*at).next++;
    return (*at).next - 1u;
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) thread: vec3<u32>) {
    let i = thread.x;
    if i >= arrayLength(&test_blades) {
        return;
    }
    let blade = test_blades[i];
    let state = test_states[i];
    switch frame.physics_model {
        case 0u: {
            test_states[i] = advance_sward(blade, state, test_gaps[i], i);
        }
        case 1u: {
            test_states[i] = advance_paper(blade, state, test_gaps[i], i);
        }
        default: {
            test_states[i] = BladeState(settled_tip(blade), 0.0);
        }
    }
}

// The tip of an undisturbed blade: the equilibrium of recovery and gravity.
fn settled_tip(blade: Blade) -> vec3<f32> {
    let dt_s = 0.5 / blade.response;
    var tip = blade.up;
    for (var i = 0u; i < 32u; i++) {
        tip = substep(blade, tip, vec3<f32>(0.0), blade.response, dt_s);
    }
    return select(blade.up, tip, is_finite3(tip));
}

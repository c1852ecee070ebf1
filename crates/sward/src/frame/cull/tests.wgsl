// The four tests of a blade (J section 4.2, equations 17 to 20 with the errata), and ours.

struct Pose {
    root: vec3<f32>,
    middle: vec3<f32>,
    tip: vec3<f32>,
    // v1
    knee: vec3<f32>,
}

fn pose_of(blade: Blade, state: BladeState) -> Pose {
    let knee = middle_point(state.tip, blade.up, blade.arch);
    var pose: Pose;
    pose.root = blade.root;
    pose.tip = blade.root + state.tip * blade.height;
    pose.knee = blade.root + knee * blade.height;
    pose.middle = 0.25 * pose.root + 0.5 * pose.knee + 0.25 * pose.tip;
    return pose;
}

// A ball round the curve's hull misses the frustum.
fn ball_outside(pose: Pose, width: f32) -> bool {
    let center = 0.5 * (pose.root + pose.tip);
    let radius = max(distance(pose.root, center), distance(pose.knee, center)) + width;
    for (var i = 0u; i < 6u; i++) {
        if dot(view.planes[i].xyz, center) + view.planes[i].w < -radius {
            return true;
        }
    }
    return false;
}

fn point_outside(p: vec3<f32>) -> bool {
    let c = view.clip_from_world * vec4<f32>(p, 1.0);
    // The paper's tolerance, here a share of w
    let w = c.w * 1.05 + 0.05;
    return abs(c.x) > w || abs(c.y) > w || c.z > w || c.z < -0.05;
}

fn fails_frustum(pose: Pose, width: f32) -> bool {
    if has(CULL_PAPER) {
        return point_outside(pose.root) && point_outside(pose.middle) && point_outside(pose.tip);
    }
    return ball_outside(pose, width);
}

// Equation 17: seen along its width.
fn fails_orientation_paper(blade: Blade) -> bool {
    let side = cross(blade.up, blade.facing);
    let ray = view_ray(blade.root);
    let flat_ray = ray - blade.up * dot(ray, blade.up);
    let length = sqrt(dot(flat_ray, flat_ray));
    return abs(dot(flat_ray, side)) > 0.9 * max(length, 1e-6);
}

// Pixels that show of a width, given how the blade is turned to the eye.
fn shown_width(blade: Blade, pose: Pose, width_px: f32, ridge: f32) -> f32 {
    let side = cross(blade.up, blade.facing);
    let along = dot(view_ray(pose.middle), side);
    let flat_part = sqrt(max(1.0 - along * along, 0.0));
    return width_px * max(flat_part, 0.5 * ridge);
}

// Equations 19 and 20: thins by distance along the ground, in even steps of `local`.
fn fails_distance_paper(blade: Blade, local: u32) -> bool {
    let n = 16u;
    let offset = blade.root - view.eye.xyz;
    let level = offset - blade.up * dot(offset, blade.up);
    let d = sqrt(dot(level, level));
    let keep = ceil(f32(n) * (1.0 - d / view.max_distance));
    return f32(local % n) >= keep;
}

fn point_hidden(p: vec3<f32>) -> bool {
    let c = view.clip_from_world * vec4<f32>(p, 1.0);
    if c.w <= 0.0 {
        return false;
    }
    let uv = vec2<f32>(c.x, -c.y) / c.w * 0.5 + 0.5;
    if any(uv < vec2<f32>(0.0)) || any(uv >= vec2<f32>(1.0)) {
        return false;
    }
    let d = opaque_depth_at(vec2<i32>(uv * view.size));
    let k = view.depth_from_value;
    let opaque_distance = (k.x - d * k.y) / (d * k.z - k.w);
    let own_distance = dot(view.depth_row.xyz, p) + view.depth_row.w;
    // Bias: a root stands in the ground, which must not hide it
    return own_distance > opaque_distance * 1.01 + 0.05;
}

fn fails_occlusion(pose: Pose) -> bool {
    return point_hidden(pose.root) && point_hidden(pose.middle) && point_hidden(pose.tip);
}

// Of something that reaches so far to both sides of a blade: its upper corners count as well.
fn fails_occlusion_wide(pose: Pose, up: vec3<f32>, margin: f32) -> bool {
    if !fails_occlusion(pose) {
        return false;
    }
    let aside = cross(up, view_ray(pose.root)) * margin;
    return point_hidden(pose.tip + aside) && point_hidden(pose.tip - aside);
}

//! The leaf's light by its shipped text, against its twin.

use super::ask;
use crate::shared::leaf_twin::{Face, Leaf, passes};
use crate::shared::noise_twin::hash01;
use glam::{DVec3, Vec4};
use wgpu::BufferUsages as U;

/// Three vectors each: v and wetness, l and thickness, reflectance.
const RUN: &str = "
@group(0) @binding(0) var<storage, read> given: array<vec4<f32>>;
@group(0) @binding(1) var<storage, read_write> found: array<vec4<f32>>;
@compute @workgroup_size(64)
fn of_leaf(@builtin(global_invocation_id) id: vec3<u32>) {
    let v = given[3u * id.x];
    let l = given[3u * id.x + 1u];
    var leaf = leaf_face(v.w);
    leaf.reflects = given[3u * id.x + 2u].xyz;
    leaf.passes = leaf_passes(leaf.reflects, l.w);
    found[id.x] = vec4<f32>(leaf_bsdf(leaf, v.xyz, l.xyz), leaf_mirrored(leaf.rough, v.xyz));
}
";

#[derive(Debug, Clone, Copy)]
struct Case {
    v: DVec3,
    l: DVec3,
    wetness: f64,
    thickness: f64,
    reflects: DVec3,
}

impl Case {
    fn leaf(&self) -> Leaf {
        let reflects = self.reflects;
        Leaf { reflects, passes: passes(reflects, self.thickness), face: Face::new(self.wetness) }
    }

    fn turned(self) -> Self {
        Self { v: self.l, l: self.v, ..self }
    }
}

/// Directions on both sides, one in eight of them along the leaf's plane.
fn cases(count: u32) -> Vec<Case> {
    let direction = |i: u32, salt: u32| {
        let part = |k: u32| 2.0 * f64::from(hash01(i, 3 * salt + k)) - 1.0;
        let flat = if i.is_multiple_of(8) { 1e-4 } else { 1.0 };
        DVec3::new(part(0), part(1), part(2) * flat).normalize_or(DVec3::Z)
    };
    let mut list = Vec::new();
    for i in 0..count {
        let share = |step: f64| (f64::from(i) * step).fract();
        list.push(Case {
            v: direction(i, 1),
            l: direction(i / 3, 2),
            wetness: share(0.618_034),
            thickness: 0.3 + 2.0 * share(0.754_877),
            reflects: DVec3::new(share(0.569_84), share(0.324_717), share(0.839_286)),
        });
    }
    list
}

fn on_gpu(cases: &[Case]) -> Vec<Vec4> {
    let vector = |v: DVec3, w: f64| v.as_vec3().extend(w as f32).to_array();
    let given: Vec<[f32; 4]> = cases
        .iter()
        .flat_map(|c| [vector(c.v, c.wetness), vector(c.l, c.thickness), vector(c.reflects, 0.0)])
        .collect();
    let source = [include_str!("../shared/leaf.wgsl"), RUN].concat();
    let entry = ask::Entry { source, name: "of_leaf", constants: &[] };
    let given = [(0, 0, U::STORAGE, bytemuck::cast_slice(&given))];
    ask::run(&entry, &given, ((0, 1), cases.len()), cases.len() as u32 / 64)
}

#[test]
fn leaf_is_its_twin_and_reciprocal() {
    let cases = cases(8192);
    let turned: Vec<Case> = cases.iter().map(|case| case.turned()).collect();
    let (there, back) = (on_gpu(&cases), on_gpu(&turned));
    let mut sides = [0; 2];
    for ((case, found), back) in cases.iter().zip(&there).zip(&back) {
        assert!(found.is_finite() && found.min_element() >= 0.0, "{case:?}: {found}");
        let turned = (found.truncate() - back.truncate()).abs().max_element();
        assert!(turned <= 2e-6 * found.max_element(), "{case:?}: {found} and {back}");
        // Light from just where it goes to, all within the leaf, has no half-way direction
        if (case.v + case.l).length() > 0.05 {
            let expected = case.leaf().bsdf(case.v, case.l);
            let off = (found.truncate().as_dvec3() - expected).abs().max_element();
            assert!(off < 2e-3 * expected.max_element() + 1e-5, "{case:?}: {found}, {expected}");
        }
        assert!((f64::from(found.w) - case.leaf().face.mirrored(case.v)).abs() < 1e-4);
        sides[usize::from(case.v.z * case.l.z > 0.0)] += 1;
    }
    assert!(sides[0] > 3000 && sides[1] > 3000, "{sides:?}");
}

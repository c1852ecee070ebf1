//! Views by strips: the sweep in place of the patches' frustum test, and how many rings a plant has.

use super::decoded::decode;
use super::rig::Rig;
use super::scenes::{
    field_of, no_culling, random_blades, random_field, random_view, see_all, species,
};
use crate::frame::cull::twin::{kept_blades, pixels_per_metre};
use crate::frame::level::strips_twin::strip_level;
use crate::gpu::layout::STRIP_BUCKETS;
use crate::gpu::quantize::gpu_patch;
use crate::gpu::shaders::Shader;
use crate::gpu::view::gpu_view;
use crate::shared::noise_twin::hash01;
use crate::{Culling, Form, Species, Strip, Technique, View};
use glam::Vec4;

fn by_strips(view: View) -> View {
    View { technique: Technique::Strips, ..view }
}

/// Every patch that passes the frustum test is found through its cell, and few that do not.
#[test]
fn swept_patches_hold_all_that_the_frustum_sees() {
    let mut rig = Rig::new(random_field(31, 12_000, 30.0, 64));
    let culling = Culling { frustum: true, ..no_culling() };
    let (mut seen, mut extra, mut swept) = (0, 0, 0);
    for seed in 0..24 {
        let view = by_strips(View { culling, ..random_view(seed, 30.0) });
        rig.cull(&[view]);
        let listed: Vec<u32> = rig.work().iter().map(|(patch, ..)| *patch).collect();
        let uniform = gpu_view(&view, u32::MAX);
        swept += usize::from(rig.page(0).grid.is_some());
        for (index, patch) in (0..).zip(rig.field.patches()) {
            let width = gpu_patch(patch, rig.field.blades()).max_width;
            let kept =
                kept_blades(&uniform, patch.reach_min, patch.reach_max, width, patch.count) > 0;
            let is_listed = listed.binary_search(&index).is_ok();
            assert!(is_listed || !kept, "patch {index} of view {seed} is missed");
            seen += usize::from(kept);
            extra += usize::from(is_listed && !kept);
        }
    }
    println!("{seen} patches seen, {extra} more listed");
    assert!(swept == 24 && seen > 500 && extra * 2 < seen, "{seen} {extra}");
}

/// Without the frustum test, and for fields that stand on end, patches are not swept.
#[test]
fn only_views_that_test_the_frustum_sweep() {
    let mut rig = Rig::new(random_field(32, 2000, 10.0, 64));
    rig.cull(&[by_strips(see_all())]);
    assert_eq!(rig.work().len(), rig.field.patches().len());
    let tower = |mut blade: crate::grow::Blade| {
        blade.root = glam::Vec3::new(0.1 * blade.root.x, 3.0 * blade.root.x, 0.1 * blade.root.z);
        blade
    };
    let blades: Vec<_> = random_blades(33, 2000, 10.0).into_iter().map(tower).collect();
    rig.replace(field_of(species(), &blades, 64));
    assert!(rig.page(0).grid.is_none());
    let culling = Culling { frustum: true, ..no_culling() };
    rig.cull(&[by_strips(View { culling, ..random_view(2, 10.0) })]);
}

/// Every plant is a strip, of as many rings as the reference says, whatever its species' own form.
#[test]
fn rings_equal_the_reference() {
    let own = Strip { few_rings_px: 8.0, ..Strip::default() };
    let mut kinds = species();
    kinds[0] = Species { form: Form::Strip(own), ..kinds[0].clone() };
    let mut rig = Rig::new(field_of(kinds, &random_blades(34, 3000, 8.0), 256));
    let (mut compared, mut other, mut few) = (0, 0, 0);
    for seed in 0..6 {
        let view = by_strips(View { culling: no_culling(), ..random_view(2 * seed, 8.0) });
        rig.cull(&[view]);
        let uniform = gpu_view(&view, u32::MAX);
        let eye = Vec4::from(uniform.eye).truncate();
        for (index, (decoded, bits)) in (0..).zip(decode(&rig.field).iter().zip(rig.decisions())) {
            let bits = bits.expect("all are dispatched");
            let blade = &decoded.blade;
            let middle = blade.root + blade.up * (0.5 * blade.height);
            let height_px = blade.height * pixels_per_metre(&uniform, middle.distance(eye));
            let few_px = if blade.species == 0 { 8.0 } else { Strip::default().few_rings_px };
            let (level, morph) = strip_level(height_px, few_px, hash01(index, 26));
            compared += 1;
            few += level;
            let off = (f32::from(bits >> 4 & 31) - 31.0 * morph).abs() > 1.0;
            other += u32::from(usize::from(bits & 15) != STRIP_BUCKETS[level as usize] || off);
        }
    }
    println!("{compared} plants, {few} of few rings, {other} differ");
    assert!(few > 1000 && few < compared - 1000, "{few}");
    assert!(other * 500 < compared, "{other} of {compared}");
}

/// A plain strip in the shaders is the library's default.
#[test]
fn a_plain_strip_is_the_default() {
    let module = naga::front::wgsl::parse_str(&Shader::DrawStrip.source()).expect("valid");
    let plain = module.constants.iter().find(|(_, c)| c.name.as_deref() == Some("PLAIN_STRIP"));
    let (_, plain) = plain.expect("the constant is there");
    let naga::Expression::Compose { components, .. } = &module.global_expressions[plain.init]
    else {
        panic!("no vector")
    };
    for (component, expected) in components.iter().zip(Strip::default().values()) {
        let naga::Expression::Literal(naga::Literal::F32(value)) =
            module.global_expressions[*component]
        else {
            panic!("no number")
        };
        assert!((value - expected).abs() < 1e-6, "{value} {expected}");
    }
}

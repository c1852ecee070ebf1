//! Fields that do not fit one binding, and fields that do not fit at all.

use super::rig::{Gpu, Rig, shared};
use super::scenes::{breeze, field_of, random_field, random_view, see_all};
use crate::gpu::limits::{check_blades, check_device, page_blades};
use crate::gpu::test_device;
use crate::{
    Collider, Error, Frame, Plant, Range, Renderer, Species, Sphere, Targets, Technique, View,
};
use glam::Vec3;

/// A device whose storage bindings hold few blades.
pub(super) fn small(bytes: u64) -> Gpu {
    test_device::with_limits(wgpu::Limits {
        max_storage_buffer_binding_size: bytes,
        ..wgpu::Limits::default()
    })
}

/// Of every page, bucket by bucket: blade of the field, and how it is drawn.
fn drawn(rig: &Rig) -> Vec<Vec<(u32, u32)>> {
    let mut buckets = vec![Vec::new(); crate::gpu::layout::BUCKETS];
    for page in rig.renderer.pages() {
        let lists = &page.views[0];
        let draws: Vec<crate::gpu::layout::GpuDraw> = rig.read(&lists.draws);
        let list: Vec<u32> = rig.read(&lists.list);
        for (bucket, draw) in buckets.iter_mut().zip(draws) {
            let own = &list[draw.start as usize..(draw.start + draw.count) as usize];
            bucket.extend(own.iter().map(|e| (page.field.first_id + (e & 0x3f_ffff), e >> 22)));
        }
    }
    buckets
}

#[test]
fn several_pages_draw_what_one_does() {
    let tight = small(1 << 15);
    for patch_size in [64, 256, 1024] {
        let field = random_field(patch_size, 7000, 5.0, patch_size);
        let mut one = Rig::on(shared(), field.clone());
        let mut several = Rig::on(tight.clone(), field);
        assert_eq!((one.renderer.pages().len(), several.renderer.pages().len()), (1, 4));
        let mut wind = breeze();
        let ball = [Collider::ball(Sphere { center: Vec3::new(0.5, 0.1, 0.0), radius: 0.6 })];
        for step in 0..4 {
            wind.advance(0.03);
            let view = random_view(step, 5.0);
            let frame = Frame { colliders: &ball, ..Frame::new(0.03, &wind) };
            one.step(&frame, &[view]);
            several.step(&frame, &[view]);
            assert_eq!(one.statistics(), several.statistics());
            assert_eq!(drawn(&one), drawn(&several), "patches of {patch_size}, step {step}");
        }
        assert!(one.statistics().blades_drawn > 0 && one.statistics().spheres_tested > 0);
        one.cull(&[see_all()]);
        several.cull(&[see_all()]);
        assert_eq!(several.statistics().blades_drawn, 7000);
        assert_eq!(drawn(&one), drawn(&several));
    }
}

#[test]
fn too_many_blades_are_an_error_that_says_how_many_fit() {
    let (device, _) = small(1 << 15);
    let targets = Targets::single_sampled(wgpu::TextureFormat::Rgba8Unorm);
    let mut renderer = Renderer::new(&device, targets).expect("the limits suffice");
    let most = Renderer::max_blades(&device.limits(), 64);
    assert_eq!(most, 16 * 2048);
    let fits = random_field(1, most as u32, 20.0, 64);
    renderer.add_field(&device, &fits).expect("as many as fit");
    let field = random_field(1, most as u32 + 1, 20.0, 64);
    let error = renderer.add_field(&device, &field).expect_err("one too many");
    let text = error.to_string();
    assert!(text.contains("max_storage_buffer_binding_size"), "{text}");
    assert!(text.contains("32769 blades") && text.contains("32768 blades fit"), "{text}");
    let Error::Limit { needed, available, .. } = error else { panic!("{error}") };
    assert!(needed > available, "{needed} > {available}");
}

#[test]
fn a_page_holds_what_binding_dispatch_and_index_hold() {
    let limits = wgpu::Limits::default();
    assert_eq!(page_blades(&limits, 64), 65_535 * 64, "one workgroup a band");
    assert_eq!(page_blades(&limits, 256), 65_532 * 64, "whole patches");
    let few = wgpu::Limits { max_storage_buffer_binding_size: 16 * 1000, ..limits.clone() };
    assert_eq!(page_blades(&few, 256), 768, "whole patches");
    let wide = wgpu::Limits {
        max_compute_workgroups_per_dimension: 1 << 20,
        max_storage_buffer_binding_size: 1 << 30,
        ..limits.clone()
    };
    // What binds is what the error names
    for (limits, size, name) in [
        (&wide, 256, "draw list"),
        (&limits, 64, "max_compute_workgroups_per_dimension"),
        (&few, 256, "max_storage_buffer_binding_size"),
    ] {
        let most = Renderer::max_blades(limits, size);
        check_blades(limits, size, most).expect("fits");
        let error = check_blades(limits, size, most + 1).expect_err("does not fit");
        assert!(error.to_string().contains(name), "{error}");
        let Error::Limit { needed, available, .. } = error else { panic!("{error}") };
        assert!(needed > available, "{name}: {needed} > {available}");
    }
}

#[test]
fn a_device_that_lacks_a_limit_is_refused() {
    check_device(&wgpu::Limits::default()).expect("the defaults suffice");
    type Lower = fn(&mut wgpu::Limits);
    let lower: [(&str, Lower); 5] = [
        ("max_storage_buffers_per_shader_stage", |l| l.max_storage_buffers_per_shader_stage = 7),
        ("max_compute_invocations_per_workgroup", |l| {
            l.max_compute_invocations_per_workgroup = 128
        }),
        ("max_compute_workgroup_size_x", |l| l.max_compute_workgroup_size_x = 128),
        ("max_bind_groups", |l| l.max_bind_groups = 3),
        ("max_uniform_buffer_binding_size", |l| l.max_uniform_buffer_binding_size = 16384),
    ];
    for (name, lower) in lower {
        let mut limits = wgpu::Limits::default();
        lower(&mut limits);
        let error = check_device(&limits).expect_err(name);
        assert!(error.to_string().contains(name), "{error}");
    }
}

#[test]
fn the_renderer_is_refused_before_its_pipelines_are_made() {
    let limits = wgpu::Limits { max_bind_groups: 3, ..wgpu::Limits::default() };
    let (device, _) = test_device::with_limits(limits);
    let targets = Targets::single_sampled(wgpu::TextureFormat::Rgba8Unorm);
    let error = Renderer::new(&device, targets).expect_err("three groups are too few");
    assert!(matches!(error, Error::Limit { limit: "max_bind_groups", .. }), "{error}");
}

/// Textures and canopies count, those that pages share once.
#[test]
fn bytes_on_the_gpu_are_those_of_blades_and_pictures() {
    let pictures = |rig: &Rig| rig.renderer.gpu_bytes() - rig.renderer.blade_bytes();
    let continuum = [View { technique: Technique::Continuum, ..see_all() }];
    let field = random_field(1, 3000, 3.0, 64);
    let mut one = Rig::on(shared(), field.clone());
    let mut several = Rig::on(small(1 << 14), field.clone());
    assert!(several.renderer.pages().len() > 2);
    let plain = pictures(&one);
    assert!(plain > 0 && plain == pictures(&several));
    for rig in [&mut one, &mut several] {
        rig.cull(&continuum);
    }
    let clusters = &one.page(0).pictures.cluster_color.texture().size();
    let texels = clusters.width * clusters.height * clusters.depth_or_array_layers;
    let more = (pictures(&one) - plain) as f64 / f64::from(2 * 4 * texels);
    assert!((1.2..1.4).contains(&more), "two arrays with mips: {more}");
    assert_eq!(pictures(&one), pictures(&several));
    // Four variants from three sides each, in two arrays with mips; and a row of points a variant
    let daisies = Species {
        height_m: Range::new(0.01, 2.0),
        width_m: Range::new(0.001, 1.0),
        ..Species::plant(Plant::Daisy)
    };
    one.replace(field_of(vec![daisies.clone(), daisies], field.blades(), 64));
    let layers = (pictures(&one) - plain - 3 * 640 * 16) as f64 / f64::from(2 * 4 * 128 * 128);
    assert!((12.0 * 1.3..12.0 * 1.34).contains(&layers), "{layers}");
}

//! Tone mapping as shipped, against its twin and by what must hold.

use super::tests::Rig;
use super::{Drawn, Post, twin};
use crate::stage::readback;
use crate::stage::targets::texture;
use glam::{DVec3, Vec3};
use image::RgbImage;
use sward_scene::Tone;

/// What AgX makes of lights, row by row, with a step of noise.
fn toned(lights: &[Vec3]) -> RgbImage {
    let size = [16, lights.len().div_ceil(16) as u32];
    let mut rig = Rig::new("", size, 1);
    rig.options.tone = Tone::Agx;
    let mut texels: Vec<_> = lights.iter().map(|light| light.extend(0.0)).collect();
    texels.resize((size[0] * size[1]) as usize, glam::Vec4::ZERO);
    let color = rig.texture(&texels);
    let device = &rig.gpu.device;
    use wgpu::TextureUsages as U;
    let format = wgpu::TextureFormat::Rgba8Unorm;
    let picture = texture(device, "test", size, format, 1, U::RENDER_ATTACHMENT | U::COPY_SRC);
    let post = Post::new(device, &rig.frame, format, &rig.options);
    let mut encoder = device.create_command_encoder(&Default::default());
    let drawn = Drawn { color: &color, position: None };
    post.run(device, &mut encoder, &rig.frame, drawn, &picture.create_view(&Default::default()));
    rig.gpu.queue.submit([encoder.finish()]);
    readback::read(&rig.gpu, &picture).unwrap()
}

#[test]
fn agx_equals_its_twin_and_never_breaks() {
    let mut lights = Vec::new();
    for stop in -14..8 {
        let light = 0.18 * 2.0_f32.powi(stop);
        let hues = [[1.0, 1.0, 1.0], [1.0, 0.1, 0.0], [0.2, 1.0, 0.1], [0.0, 0.2, 1.0]];
        lights.extend(hues.map(|hue| Vec3::from(hue) * light));
    }
    lights.extend([Vec3::ZERO, Vec3::splat(65_000.0)]);
    let picture = toned(&lights);
    for (light, pixel) in lights.iter().zip(picture.pixels()) {
        let expected = twin::agx(light.as_dvec3()).map(|x| 255.0 * twin::srgb(x.clamp(0.0, 1.0)));
        let got = DVec3::from_array(pixel.0.map(f64::from));
        assert!((got - expected).abs().max_element() < 1.6, "{light}: {got}, not {expected}");
    }
    let (black, white) = (picture.get_pixel(88 % 16, 5).0, picture.get_pixel(89 % 16, 5).0);
    assert!(
        black.iter().all(|&v| v <= 1) && white.iter().all(|&v| v >= 254),
        "{black:?} {white:?}"
    );
}

/// Grey stays grey, and more light is never darker.
#[test]
fn agx_keeps_grey_and_order() {
    let lights: Vec<_> = (0..320).map(|i| Vec3::splat((i as f32 * 0.05 - 12.0).exp2())).collect();
    let picture = toned(&lights);
    let mut last = 0;
    for (light, pixel) in lights.iter().zip(picture.pixels()) {
        let [r, g, b] = pixel.0;
        assert!(r.abs_diff(g) <= 1 && g.abs_diff(b) <= 1, "{light}: {pixel:?}");
        // The noise is a step
        assert!(g + 1 >= last, "{light}: {pixel:?} after {last}");
        last = last.max(g);
    }
    let of = |x: f64| twin::agx(DVec3::splat(x));
    let exact: Vec<_> = (0..1000).map(|i| of((f64::from(i) * 0.018 - 13.0).exp2())).collect();
    assert!(exact.windows(2).all(|pair| pair[1].cmpge(pair[0] - 1e-12).all()));
    assert!(exact.iter().all(|grey| (grey.max_element() - grey.min_element()) < 1e-9));
}

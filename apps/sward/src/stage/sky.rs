//! The background: a gradient of the scene's colours, or the table of a sky by physics.

use super::frame::FrameUniform;
use super::fullscreen::{Fullscreen, FullscreenDesc, Input};
use super::targets::texture;
use crate::gpu::{COLOR_FORMAT, Gpu};
use sward_scene::atmosphere::Dome;

/// What is seen where nothing is.
#[derive(Debug)]
pub(super) struct Sky {
    pass: Fullscreen,
    inputs: wgpu::BindGroup,
    table: Option<wgpu::Texture>,
}

impl Sky {
    pub fn new(gpu: &Gpu, frame: &FrameUniform, samples: u32, dome: Option<&Dome>) -> Self {
        const GRADIENT: &str = concat!(include_str!("sky_model.wgsl"), include_str!("sky.wgsl"));
        const TABLE: &str = concat!(include_str!("sky_table.wgsl"), include_str!("sky.wgsl"));
        let device = &gpu.device;
        let (source, inputs): (_, &[Input]) = match dome {
            None => (GRADIENT, &[]),
            Some(_) => (TABLE, &[Input::Color]),
        };
        let desc = FullscreenDesc {
            name: "sky",
            source,
            formats: &[COLOR_FORMAT],
            samples,
            inputs,
            constants: &[],
            background: true,
        };
        let pass = Fullscreen::new(device, &frame.layout, &desc);
        let table = dome.map(|_| {
            use wgpu::TextureUsages as U;
            let size = [Dome::COLUMNS as u32, Dome::ROWS as u32];
            let usage = U::TEXTURE_BINDING | U::COPY_DST;
            texture(device, "sward.stage.sky", size, COLOR_FORMAT, 1, usage)
        });
        let view = table.as_ref().map(|table| table.create_view(&Default::default()));
        let inputs = pass.bind(device, view.as_ref().as_slice());
        let sky = Self { pass, inputs, table };
        if let Some(dome) = dome {
            sky.set_dome(&gpu.queue, dome);
        }
        sky
    }

    /// Another sky, where it is a table.
    pub fn set_dome(&self, queue: &wgpu::Queue, dome: &Dome) {
        let Some(table) = &self.table else { return };
        let texels = dome.texels().iter();
        let halves =
            texels.flat_map(|light| [half(light.x), half(light.y), half(light.z), half(1.0)]);
        let bytes: Vec<u8> = halves.flat_map(u16::to_le_bytes).collect();
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(Dome::COLUMNS as u32 * 8),
            rows_per_image: None,
        };
        queue.write_texture(table.as_image_copy(), &bytes, layout, table.size());
    }

    /// Fills the background of an open pass.
    pub fn draw(&self, pass: &mut wgpu::RenderPass, frame: &FrameUniform) {
        self.pass.draw(pass, &frame.group, &self.inputs);
    }
}

/// The nearest half-precision number of one that is 0 or more; what is too large becomes the largest.
fn half(value: f32) -> u16 {
    // Below 2^-14 halves are even steps of 2^-24
    if value < 2.0_f32.powi(-14) {
        return (value.max(0.0) * 2.0_f32.powi(24)).round() as u16;
    }
    let bits = value.min(65_504.0).to_bits();
    // Exponents are biased by 127 and 15; 13 bits of the fraction go, rounded
    let rounded = bits + 0x0fff + (bits >> 13 & 1);
    ((rounded >> 13) - ((127 - 15) << 10)) as u16
}

#[cfg(test)]
mod tests {
    use super::half;
    use crate::gpu::Gpu;
    use crate::stage::frame::CameraMatrices;
    use crate::stage::reference::Crop;
    use crate::stage::{Stage, StageOptions};
    use glam::{Vec3, Vec4Swizzles, vec4};
    use std::path::Path;

    /// The sky as drawn is the table as it is read on the CPU, and the sun's disc is where the sun is.
    #[test]
    fn the_drawn_sky_is_the_table() {
        let gpu = Gpu::headless().expect("a graphics adapter");
        let text = "(fields: [(on: Plane(), density: 1)], light: (time_h: 16.5), warm_up_s: 0,
                     cameras: [(eye: (0, 2, 0), target: (-3, 3.6, 0.8), vertical_fov_deg: 95)])";
        let scene = sward_scene::parse(text, Path::new("s.ron")).unwrap();
        let fields = crate::grow::grow(&scene, &gpu.device.limits(), Default::default()).unwrap();
        let size = [64, 48];
        let options = StageOptions::new(&scene, None, size, 1).unwrap();
        let camera = CameraMatrices::new(&options.camera, size, Crop::whole(size));
        let (world, view) = (camera.view_from_world.inverse(), camera.clip_from_view.inverse());
        let mut stage = Stage::new(&gpu, &scene, &fields, options).unwrap();
        stage.warm_up().unwrap();
        let picture = stage.linear_picture().unwrap();
        let light = scene.light_at(0.0);
        let (dome, to_sun) = (light.dome.unwrap(), light.sun.to_sun());
        let (mut compared, mut suns) = (0, 0);
        for (x, y, pixel) in picture.enumerate_pixels() {
            let ndc = [(x as f32 + 0.5) / 32.0 - 1.0, 1.0 - (y as f32 + 0.5) / 24.0];
            let far = view * vec4(ndc[0], ndc[1], 1.0, 1.0);
            let way = (world * (far.xyz() / far.w).extend(0.0)).xyz().normalize();
            let (drawn, off) = (Vec3::from(pixel.0), way.distance(to_sun));
            if off < 0.04 {
                suns += u32::from(drawn.max_element() > 2.0 * dome.radiance(way).max_element());
            } else if way.y > 0.02 {
                let wrong = ((drawn - dome.radiance(way)) / dome.radiance(way)).abs();
                assert!(wrong.max_element() < 0.01, "{way}: {drawn}, not {}", dome.radiance(way));
                compared += 1;
            }
        }
        assert!(compared > 1000 && (1..=6).contains(&suns), "{compared} {suns}");
    }

    #[test]
    fn halves_are_the_nearest() {
        let pairs = [(0.0, 0), (1.0, 0x3c00), (0.1, 0x2e66), (65_504.0, 0x7bff), (1e9, 0x7bff)];
        for (value, bits) in pairs {
            assert_eq!(half(value), bits, "{value}");
        }
        assert_eq!([half(2.0_f32.powi(-24)), half(6e-5), half(f32::NAN)], [1, 0x03ef, 0x7bff]);
        assert_eq!(half(6.2e-5), 0x0410);
    }
}

//! What every pass round the grass reads: camera, light, settings.

use super::StageOptions;
use super::post::lens;
use super::reference::Crop;
use bytemuck::{Pod, Zeroable};
use glam::{Mat4, Vec2, Vec4};
use sward::{Light, Shade};
use sward_scene::{Camera, DepthOfFieldSettings, FogSettings, SceneLight, SkySettings};
use wgpu::util::DeviceExt;

/// The WGSL twin is `GpuStageFrame` in `frame.wgsl`; a test compares the two.
#[repr(C)]
#[derive(Debug, Clone, Copy, Pod, Zeroable)]
pub(super) struct GpuStageFrame {
    clip_from_world: Mat4,
    view_from_clip: Mat4,
    world_from_view: Mat4,
    eye: Vec4,
    to_sun: Vec4,
    sun: Vec4,
    sky: Vec4,
    ground: Vec4,
    zenith: Vec4,
    horizon: Vec4,
    haze: Vec4,
    fog: Vec4,
    fog_shape: Vec4,
    lens: Vec4,
    exposure: f32,
    samples_a_side: f32,
    stands_in: f32,
    rods: f32,
    shade: Vec4,
    shade_offset: Vec2,
    reserved_more: Vec2,
}

/// The frame's uniform buffer and its bind group, group 0 of every pass of the stage.
#[derive(Debug)]
pub(super) struct FrameUniform {
    values: GpuStageFrame,
    camera: CameraMatrices,
    fog: Option<FogSettings>,
    depth_of_field: Option<DepthOfFieldSettings>,
    height_px: f32,
    buffer: wgpu::Buffer,
    pub layout: wgpu::BindGroupLayout,
    pub group: wgpu::BindGroup,
}

/// A camera's two matrices for a target of a size.
#[derive(Debug, Clone, Copy)]
pub(super) struct CameraMatrices {
    pub view_from_world: Mat4,
    pub clip_from_view: Mat4,
}

impl CameraMatrices {
    /// `size` is that of the whole picture.
    pub fn new(camera: &Camera, size: [u32; 2], crop: Crop) -> Self {
        let [width, height] = size.map(|side| side as f32);
        Self {
            view_from_world: camera.view_from_world(),
            clip_from_view: crop.clip_from_picture(size) * camera.clip_from_view(width / height),
        }
    }
}

impl FrameUniform {
    /// Light is all dark until it is set.
    pub fn new(device: &wgpu::Device, options: &StageOptions) -> Self {
        let values = GpuStageFrame {
            exposure: 1.0,
            samples_a_side: 1.0,
            stands_in: if options.draws_all() { 0.0 } else { 1.0 },
            ..bytemuck::Zeroable::zeroed()
        };
        let buffer = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some("sward.stage.frame"),
            contents: bytemuck::bytes_of(&values),
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        });
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("sward.stage.frame"),
            entries: &[wgpu::BindGroupLayoutEntry {
                binding: 0,
                visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
                ty: wgpu::BindingType::Buffer {
                    ty: wgpu::BufferBindingType::Uniform,
                    has_dynamic_offset: false,
                    min_binding_size: None,
                },
                count: None,
            }],
        });
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("sward.stage.frame"),
            layout: &layout,
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: buffer.as_entire_binding() }],
        });
        let camera =
            CameraMatrices { view_from_world: Mat4::IDENTITY, clip_from_view: Mat4::IDENTITY };
        Self {
            values,
            camera,
            fog: options.fog,
            depth_of_field: options.depth_of_field,
            height_px: options.size[1] as f32,
            buffer,
            layout,
            group,
        }
    }

    /// Pixels of the picture that a metre covers at distance 1.
    pub fn focal_px(&self) -> f32 {
        0.5 * self.height_px * self.camera.clip_from_view.y_axis.y.abs()
    }

    /// The camera that was written last.
    pub fn camera(&self) -> CameraMatrices {
        self.camera
    }

    /// Takes effect when the camera is next written.
    pub fn set_light(&mut self, light: &Light, sky: &SkySettings) {
        let values = &mut self.values;
        values.to_sun = light.to_sun.extend(0.0);
        values.sun = light.sun.extend(0.0);
        values.sky = light.sky.extend(0.0);
        values.ground = light.ground.extend(0.0);
        values.zenith = sky.zenith.extend(0.0);
        values.horizon = sky.horizon.extend(0.0);
        values.haze = light.haze.extend(light.haze_per_m);
        if let Some(fog) = self.fog {
            values.fog = fog.color.unwrap_or(sky.horizon).extend(fog.density_per_m);
            let thins = fog.falloff_m.recip();
            values.fog_shape = Vec4::new(fog.start_m, fog.base_m, thins, 0.0);
        }
    }

    /// What the sky and the picture need beside the light, after [`FrameUniform::set_light`]: where the
    /// sky's table lies, exposure, how far colours are seen.
    pub fn set_picture(&mut self, now: &SceneLight) {
        let values = &mut self.values;
        (values.exposure, values.rods) = (now.exposure_ev.exp2(), now.rods);
        if let Some(dome) = &now.dome {
            values.to_sun.w = dome.disc;
            (values.zenith.w, values.horizon.w) = dome.toward_sun.into();
        }
    }

    /// Neither haze nor fog nor a lens from the next writing on.
    pub fn clear_air(&mut self) {
        self.values.haze.w = 0.0;
        (self.fog, self.depth_of_field) = (None, None);
    }

    /// What moves between the ground and the sun; written with the camera.
    pub fn set_shade(&mut self, shade: &Shade) {
        let (pattern, offset) = shade.pattern();
        self.values.shade = Vec4::from(pattern);
        self.values.shade_offset = Vec2::from(offset);
    }

    /// Takes effect with the next submission.
    pub fn write(&mut self, queue: &wgpu::Queue, camera: CameraMatrices, samples_a_side: f32) {
        let world_from_view = camera.view_from_world.inverse();
        self.camera = camera;
        self.values.clip_from_world = camera.clip_from_view * camera.view_from_world;
        self.values.view_from_clip = camera.clip_from_view.inverse();
        self.values.world_from_view = world_from_view;
        self.values.eye = world_from_view.w_axis;
        let focal = camera.clip_from_view.y_axis.y;
        self.values.lens = lens(self.depth_of_field, focal, self.height_px).into();
        self.values.samples_a_side = samples_a_side;
        queue.write_buffer(&self.buffer, 0, bytemuck::bytes_of(&self.values));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::mem::offset_of;

    #[test]
    fn layout_equals_the_shaders() {
        let module = naga::front::wgsl::parse_str(include_str!("frame.wgsl")).unwrap();
        let (members, span) = module
            .types
            .iter()
            .find_map(|(_, ty)| match &ty.inner {
                naga::TypeInner::Struct { members, span }
                    if ty.name.as_deref() == Some("GpuStageFrame") =>
                {
                    Some((members, *span))
                }
                _ => None,
            })
            .unwrap();
        macro_rules! fields {
            ($($name:ident),*) => { vec![$((stringify!($name), offset_of!(GpuStageFrame, $name))),*] };
        }
        let ours = fields![
            clip_from_world,
            view_from_clip,
            world_from_view,
            eye,
            to_sun,
            sun,
            sky,
            ground,
            zenith,
            horizon,
            haze,
            fog,
            fog_shape,
            lens,
            exposure,
            samples_a_side,
            stands_in,
            rods,
            shade,
            shade_offset,
            reserved_more
        ];
        let theirs: Vec<_> = members
            .iter()
            .map(|m| (m.name.as_deref().unwrap_or_default(), m.offset as usize))
            .collect();
        assert_eq!(ours, theirs);
        assert_eq!(size_of::<GpuStageFrame>(), span as usize);
    }
}

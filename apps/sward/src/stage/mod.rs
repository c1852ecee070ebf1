//! The stage: a headless host of the grass. It draws what stands round the grass (things, sky,
//! light), drives the renderer, and ends with tone mapping and a picture.
//!
//! A frame is: `simulate`, opaque things, `cull` (which reads their depth), grass and sky, post.

mod clock;
mod daylight;
mod frame;
mod fullscreen;
mod grass_look;
mod light;
mod meshes;
mod movers;
mod opaque;
mod options;
mod parts;
mod post;
mod readback;
mod reference;
mod resume;
mod shapes;
mod sky;
mod swept;
mod targets;
mod texture;

pub use clock::Clock;
pub use light::LightMap;
pub use options::{StageOptions, no_culling};

use crate::gpu::{COLOR_FORMAT, DEPTH_FORMAT, Gpu};
use anyhow::{Context, Result};
use frame::{CameraMatrices, FrameUniform};
use grass_look::GrassLook;
use image::RgbImage;
use light::Readable;
use movers::Movers;
use opaque::Opaque;
use options::view;
use post::{Drawn, Post};
use reference::{Crop, Supersampled};
use sky::Sky;
use sward::{Field, Frame, Light, Renderer, Statistics, View, Wind};
use sward_scene::{Heavens, Scene, SceneWind, ShadeSettings};
use targets::Targets;

/// A scene with its grass, ready to be stepped and drawn.
#[derive(Debug)]
pub struct Stage {
    gpu: Gpu,
    options: StageOptions,
    renderer: Renderer,
    targets: Targets,
    uniform: FrameUniform,
    opaque: Opaque,
    sky: Sky,
    post: Post,
    wind: Wind,
    wind_paths: Vec<SceneWind>,
    light: Light,
    /// Where the light changes with the time.
    heavens: Option<Heavens>,
    shade: Option<ShadeSettings>,
    gravity: sward::Gravity,
    movers: Movers,
    time_s: f64,
    /// At the step before.
    last_time_s: f64,
    warm_up_s: f64,
    /// The part of the picture that is drawn.
    crop: Crop,
    /// What a reference is drawn to, once there was one.
    supersampled: Option<Supersampled>,
    /// What [`Stage::light_map`] draws to.
    readable: Option<Readable>,
    /// Whether the depth target holds the opaque things of this time, and nothing else.
    depth_is_opaque: bool,
}

impl Stage {
    /// Uploads a scene and its grown fields. Time starts at the scene's warm-up, before 0:
    /// see [`Stage::warm_up`].
    ///
    /// # Errors
    /// Where the fields do not fit the device.
    pub fn new(gpu: &Gpu, scene: &Scene, fields: &[Field], options: StageOptions) -> Result<Self> {
        let device = &gpu.device;
        let grey;
        let scene = if options.debug.is_some() {
            grey = options::on_grey_ground(scene);
            &grey
        } else {
            scene
        };
        let samples = if options.reference { 1 } else { options.samples };
        let formats = sward::Targets { color: COLOR_FORMAT, depth: DEPTH_FORMAT, samples };
        let mut renderer = Renderer::new(device, formats)?;
        for (field, grown) in scene.fields.iter().zip(fields) {
            renderer
                .add_field(device, grown)
                .with_context(|| format!("{}: field '{}'", scene.path.display(), field.name))?;
        }
        let mut uniform = FrameUniform::new(device, &options);
        let warm_up_s = f64::from(scene.warm_up_s);
        let now = options.seen(scene.light_at(-warm_up_s));
        let light = Light { shade: scene.shade_at(0.0), ..options::light(&options, &now) };
        uniform.set_light(&light, &now.sky);
        uniform.set_picture(&now);
        let targets = Targets::new(device, options.size, samples);
        let crop = Crop::whole(options.size);
        let movers = Movers::new(scene);
        let wind = Wind::new(scene.wind_at(-warm_up_s))?;
        let grass = GrassLook::of_objects(scene, fields, &options, &wind);
        let opaque =
            Opaque::new(gpu, &uniform, scene, &movers, &grass, (samples, options.technique));
        let sky = Sky::new(gpu, &uniform, samples, now.dome.as_ref());
        let post = Post::new(device, &uniform, targets.picture.format(), &options);
        let mut stage = Self {
            gpu: gpu.clone(),
            options,
            renderer,
            targets,
            uniform,
            opaque,
            sky,
            post,
            wind,
            wind_paths: scene.wind.clone(),
            light,
            heavens: scene.heavens.clone().filter(Heavens::moves),
            shade: scene.shade,
            gravity: scene.gravity,
            movers,
            time_s: -warm_up_s,
            last_time_s: -warm_up_s,
            warm_up_s,
            crop,
            supersampled: None,
            readable: None,
            depth_is_opaque: false,
        };
        stage.write_camera();
        stage.gpu.wait()?;
        Ok(stage)
    }

    /// Simulates the scene's warm-up, which ends at time 0. Blades that no sphere touches sleep
    /// through it and wake at its end, which costs one step for them and not hundreds.
    ///
    /// # Errors
    /// Where the device fails.
    pub fn warm_up(&mut self) -> Result<()> {
        for dt_s in self.warm_up_steps() {
            let mut encoder = self.encoder();
            // Nobody looks before time 0: its light need not be worked out
            let heavens = self.heavens.take();
            let stepped = self.encode_simulate(&mut encoder, dt_s);
            self.heavens = heavens;
            stepped?;
            self.submit(encoder);
            self.gpu.wait()?;
        }
        self.time_s = 0.0;
        // A step of no time: the first picture needs blades in place.
        self.step(0.0)
    }

    /// Advances the time, and the blades that the camera sees.
    ///
    /// # Errors
    /// Where the device fails.
    pub fn step(&mut self, dt_s: f64) -> Result<()> {
        let mut encoder = self.encoder();
        self.encode_simulate(&mut encoder, dt_s)?;
        self.look(true);
        self.encode_opaque(&mut encoder);
        self.encode_cull(&mut encoder)?;
        self.submit(encoder);
        self.gpu.wait()
    }

    /// Draws what the last [`Stage::step`] left.
    ///
    /// # Errors
    /// Where the device fails.
    pub fn render(&mut self) -> Result<RgbImage> {
        self.draw_picture()?;
        readback::read(&self.gpu, &self.targets.picture)
    }

    /// Draws, up to the picture's target.
    fn draw_picture(&mut self) -> Result<()> {
        if self.options.reference {
            self.render_reference()?;
        } else {
            self.look(false);
            let mut encoder = self.encoder();
            self.encode_draw(&mut encoder);
            self.encode_post(&mut encoder);
            self.submit(encoder);
        }
        Ok(())
    }

    /// Records one step of the simulation.
    ///
    /// # Errors
    /// Where wind or spheres are more than fit, or not finite.
    pub fn encode_simulate(&mut self, encoder: &mut wgpu::CommandEncoder, dt_s: f64) -> Result<()> {
        self.follow(dt_s);
        if self.opaque.place(&self.gpu.queue, self.movers.placements(self.time_s)) {
            self.depth_is_opaque = false;
        }
        let colliders: Vec<_> = match self.options.collisions {
            true => self.movers.colliders(self.time_s, self.last_time_s),
            false => Vec::new(),
        };
        let frame = Frame {
            dt_s: dt_s as f32,
            wind: &self.wind,
            colliders: &colliders,
            gravity: self.gravity,
            light: self.light,
            physics: self.options.physics,
        };
        Ok(self.renderer.simulate(&self.gpu.device, encoder, &frame)?)
    }

    /// Records the depth of the opaque things, unless it is there already.
    pub fn encode_opaque(&mut self, encoder: &mut wgpu::CommandEncoder) {
        if self.depth_is_opaque {
            return;
        }
        let camera = self.uniform.camera();
        let seen = View::new(camera.view_from_world, camera.clip_from_view, self.crop.size);
        self.opaque.sweep(&self.gpu.device, encoder, &seen);
        let clear = wgpu::LoadOp::Clear(1.0);
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("sward.stage.depth"),
            depth_stencil_attachment: Some(self.depth_attachment(clear)),
            ..Default::default()
        });
        self.opaque.draw_depth(&mut pass, &self.uniform);
        drop(pass);
        self.depth_is_opaque = true;
    }

    /// Records the culling of the camera's view against the opaque depth.
    ///
    /// # Errors
    /// Where the camera is none.
    pub fn encode_cull(&mut self, encoder: &mut wgpu::CommandEncoder) -> Result<()> {
        let view = view(&self.options, self.matrices(), self.crop.size, &self.targets.depth);
        Ok(self.renderer.cull(&self.gpu.device, encoder, &[view])?)
    }

    /// Records the settings of the view; before [`Stage::encode_stage`].
    ///
    /// # Errors
    /// Where the camera is none.
    pub fn encode_prepare(&mut self, encoder: &mut wgpu::CommandEncoder) -> Result<()> {
        let view = view(&self.options, self.matrices(), self.crop.size, &self.targets.depth);
        Ok(self.renderer.prepare_view(&self.gpu.device, encoder, 0, &view)?)
    }

    /// Records one stage of [`Stage::encode_cull`], so that it can be timed.
    pub fn encode_stage(&self, encoder: &mut wgpu::CommandEncoder, stage: sward::Stage) {
        let view = view(&self.options, self.matrices(), self.crop.size, &self.targets.depth);
        self.renderer.encode_stage(&self.gpu.device, encoder, stage, 0, &view);
    }

    /// Records grass, then what shows of the opaque things and of the sky, then the resolve.
    pub fn encode_draw(&mut self, encoder: &mut wgpu::CommandEncoder) {
        self.encode_opaque(encoder);
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("sward.stage.draw"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &self.targets.color,
                depth_slice: None,
                resolve_target: self.targets.resolved.as_ref(),
                ops: wgpu::Operations::default(),
            })],
            depth_stencil_attachment: Some(self.depth_attachment(wgpu::LoadOp::Load)),
            ..Default::default()
        });
        self.renderer.draw(&mut pass, 0);
        self.opaque.draw_color(&mut pass, &self.uniform);
        if self.options.sky {
            self.sky.draw(&mut pass, &self.uniform);
        }
        drop(pass);
        self.depth_is_opaque = false;
    }

    /// Records what is done to the picture once it is drawn: fog and depth of field where the
    /// options have them, tone mapping, encoding.
    pub fn encode_post(&mut self, encoder: &mut wgpu::CommandEncoder) {
        let (device, frame, targets) = (&self.gpu.device, &self.uniform, &self.targets);
        let position = self.post.position(device, encoder, frame, &targets.depth);
        let drawn = Drawn { color: targets.linear(), position };
        self.post.run(device, encoder, frame, drawn, &targets.picture_view);
    }

    fn depth_attachment(
        &self,
        load: wgpu::LoadOp<f32>,
    ) -> wgpu::RenderPassDepthStencilAttachment<'_> {
        wgpu::RenderPassDepthStencilAttachment {
            view: &self.targets.depth,
            depth_ops: Some(wgpu::Operations { load, store: wgpu::StoreOp::Store }),
            stencil_ops: None,
        }
    }

    /// Shows another debug view of the same moment, or the blades' own look.
    ///
    /// # Errors
    /// Where the device fails.
    pub fn show(&mut self, debug: Option<sward::DebugView>) -> Result<()> {
        self.options.debug = debug;
        self.depth_is_opaque = false;
        self.look(true);
        let mut encoder = self.encoder();
        self.encode_opaque(&mut encoder);
        self.encode_cull(&mut encoder)?;
        self.submit(encoder);
        self.gpu.wait()
    }

    /// Points the stage's camera where blades are culled, or drawn, where that is not the same.
    fn look(&mut self, culling: bool) {
        if self.options.culling_camera.is_none() {
            return;
        }
        self.depth_is_opaque = false;
        let camera = if culling { self.matrices() } else { self.options.drawn_from(self.crop) };
        self.uniform.write(&self.gpu.queue, camera, self.crop.side);
    }

    /// The camera that blades are culled for.
    fn matrices(&self) -> CameraMatrices {
        self.options.culled_from(self.crop)
    }

    fn write_camera(&mut self) {
        let camera = self.matrices();
        self.uniform.write(&self.gpu.queue, camera, self.crop.side);
    }

    /// An encoder to record into.
    pub fn encoder(&self) -> wgpu::CommandEncoder {
        self.gpu.device.create_command_encoder(&Default::default())
    }

    /// Submits what was recorded.
    pub fn submit(&self, encoder: wgpu::CommandEncoder) {
        self.gpu.queue.submit([encoder.finish()]);
    }

    /// Seconds since the scene's time 0.
    pub fn time_s(&self) -> f64 {
        self.time_s
    }

    /// The newest counts that have come back.
    pub fn statistics(&mut self) -> Option<Statistics> {
        self.renderer.statistics(&self.gpu.device)
    }

    /// Bytes that the grass takes on the GPU: all, and those that grow with the blades.
    pub fn gpu_bytes(&self) -> (u64, u64) {
        (self.renderer.gpu_bytes(), self.renderer.blade_bytes())
    }
}

/// A module of the stage: `frame.wgsl` and the given parts.
fn shader(device: &wgpu::Device, label: &str, parts: &[&str]) -> wgpu::ShaderModule {
    let source = [&[include_str!("frame.wgsl")], parts].concat().join("\n");
    device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(label),
        source: wgpu::ShaderSource::Wgsl(source.into()),
    })
}

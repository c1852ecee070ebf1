//! Real-time grass that responds: every blade is a curve that gravity, wind and colliders move, on
//! any triangle mesh, drawn with [wgpu].
//!
//! The library draws into the host's render pass. It owns no window, no frame graph and no loop, it
//! reads no file and prints nothing, and bad input is an [`Error`] that names cause and remedy. It
//! follows K. Jahrmann and M. Wimmer, "Responsive Real-Time Grass Rendering for General 3D Scenes",
//! I3D 2017, called J in these pages, with its own defaults where they hold better.
//!
//! # Quick start
//! ```no_run
//! use glam::{Mat4, UVec2, Vec2, Vec3};
//! use sward::{Field, FieldDesc, Frame, Gusts, Mesh, Renderer, Surface, Targets, View, Wind};
//!
//! # fn host(
//! #     (device, queue): (wgpu::Device, wgpu::Queue),
//! #     (view_from_world, clip_from_view): (Mat4, Mat4),
//! # ) -> Result<(), sward::Error> {
//! // Once
//! let surface = Surface::new(Mesh::plane(Vec2::splat(20.0), UVec2::ONE)?)?;
//! let field = Field::grow(&surface, &FieldDesc { density: 300.0, ..Default::default() })?;
//! let mut renderer = Renderer::new(
//!     &device,
//!     Targets::single_sampled(wgpu::TextureFormat::Rgba16Float),
//! )?;
//! renderer.add_field(&device, &field)?;
//! let mut wind = Wind::new(vec![sward::WindSource::Gusts(Gusts::default())])?;
//!
//! // Each frame
//! let dt_s = 1.0 / 60.0;
//! wind.advance(dt_s);
//! let view = View::new(view_from_world, clip_from_view, [1280, 720]);
//! let mut encoder = device.create_command_encoder(&Default::default());
//! renderer.simulate(&device, &mut encoder, &Frame::new(dt_s as f32, &wind))?;
//! renderer.cull(&device, &mut encoder, &[view])?;
//! # let render_pass_of_the_host = wgpu::RenderPassDescriptor::default();
//! let mut pass = encoder.begin_render_pass(&render_pass_of_the_host);
//! renderer.draw(&mut pass, 0);
//! drop(pass);
//! queue.submit([encoder.finish()]);
//! # Ok(())
//! # }
//! ```
//! `examples/minimal.rs` is a whole program, with its device and targets.
//!
//! # How data flow
//! Once, on the CPU: [`Mesh`] -> [`Surface`] -> [`Field::grow`] (roots, then blades, then patches) ->
//! [`Renderer::add_field`], which quantises and uploads.
//!
//! Each frame, on the GPU, with nothing read back on the way:
//! 1. [`Renderer::simulate`] takes time, wind, colliders, gravity and light, and moves the blades of the
//!    patches that they touch.
//! 2. [`Renderer::cull`] lists for each [`View`] the patches that it sees, then moves, tests and
//!    grades their blades, and makes the draw lists.
//! 3. [`Renderer::draw`] draws a view's lists, one indirect draw for each level of detail.
//!
//! Blades that no view sees sleep: they catch up on the time that they missed when one sees them
//! again. [`Renderer::statistics`] reports a frame or more late. To time or interleave the stages,
//! use [`Renderer::prepare_view`] and [`Renderer::encode_stage`] in place of `cull`.
//!
//! # Words
//! | word | meaning |
//! |---|---|
//! | surface | the mesh that grass grows on |
//! | species | one kind of plant: outline, sizes, stiffness, colours, share of the mix |
//! | blade | one plant: a quadratic curve from its root, with an up and a facing direction |
//! | tuft | blades that stand together round one point |
//! | patch | a fixed number of blades near each other: culled and put to sleep together |
//! | field | all that grows on one surface |
//! | response, droop, gust | how fast a blade returns, how far gravity and wind bend it; all relative to its own height, so that one setting fits any size |
//! | arch | how far a tip may hang over |
//! | crush | how far a collision still holds a blade down; it fades with time |
//! | level | how many segments a blade is drawn with: 8, 4, 2 or 1 |
//! | detail | how large blades count on the screen when levels and thinning are chosen |
//!
//! # Units and spaces
//! Metres, seconds, radians where a name does not say degrees (`_deg`). World space is right-handed;
//! heights and slopes are measured along y. Views look along -z, and clip z runs from 0 (near) to w
//! (far). Colours and light are linear, with the primaries of sRGB; the picture needs tone mapping
//! and encoding by the host. The strength of wind is relative: 0.4 is a breeze, 1.2 a strong gust,
//! for turf and reed alike.

mod bake;
pub mod bands;
pub mod billboard;
pub mod canopy;
pub mod changes;
pub mod collider;
pub mod color_map;
pub mod debug;
pub mod error;
pub mod field;
pub mod frame;
mod gpu;
pub mod grow;
pub mod mix;
pub mod plants;
pub mod renderer;
pub mod shared;
pub mod simulation;
pub mod solid;
pub mod species;
pub mod statistics;
pub mod technique;
pub mod view;

#[cfg(test)]
mod pipeline_tests;

pub use bands::Bands;
pub use billboard::{Billboard, Sizes};
pub use canopy::Canopy;
pub use changes::Change;
pub use collider::{Collider, ColliderShape, Pose};
pub use color_map::{ColorImage, ColorMap};
pub use debug::{DebugColor, DebugView, Observer};
pub use error::Error;
pub use field::{BladeOrder, DensityMap, Field, FieldDesc, Metric, Tufts};
pub use frame::sweep::plan::{GroundCorner, SweepMethod, ground_corners};
pub use frame::sweep::terrain::Sweep;
pub use frame::wind::{
    Cosine, Fan, Gusts, Rotor, Vortex, Waves, Wind, WindMap, WindSource, WindTexture,
};
pub use grow::obstacles::Obstacle;
pub use grow::surface::{Mesh, Surface};
pub use mix::{Kind, Mix, Mixed};
pub use plants::{Look, Picture, Plant};
pub use renderer::{Renderer, Stage, Targets};
pub use simulation::{Frame, Gravity, Light, PhysicsModel, Shade, Sphere};
pub use solid::{PackDesc, Packing, Solid};
pub use species::{ColorRange, Form, Range, Shape, Species, Strip};
pub use statistics::Statistics;
pub use technique::Technique;
pub use view::{Culling, View};

/// The README's program compiles.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

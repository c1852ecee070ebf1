//! The pictures under test and their references: the same blades, in the same state, at one moment.

use super::Still;
use crate::gpu::Gpu;
use crate::stage::{LightMap, Stage, StageOptions};
use anyhow::Result;
use glam::Vec3;
use image::RgbImage;
use sward::Field;
use sward_scene::{Camera, Scene};

/// Two stages.
pub(super) struct Pair {
    test: Stage,
    reference: Stage,
}

impl Pair {
    /// Both at the scene's time 0. The blades' states are simulated once, for all blades, so that
    /// none differs because it slept unseen.
    pub fn new(gpu: &Gpu, scene: &Scene, fields: &[Field], options: &StageOptions) -> Result<Self> {
        let all = StageOptions { reference: true, ..options.clone() };
        let mut reference = Stage::new(gpu, scene, fields, all)?;
        reference.warm_up()?;
        let mut test = Stage::new(gpu, scene, fields, options.clone())?;
        test.resume(&reference.save_state()?, std::iter::empty())?;
        test.step(0.0)?;
        reference.draw_in_view_only();
        Ok(Self { test, reference })
    }

    pub fn look_from(&mut self, camera: &Camera) -> Result<()> {
        self.test.look_from(camera)?;
        self.reference.look_from(camera)
    }

    pub fn clear_air(&mut self) -> Result<()> {
        self.test.clear_air()?;
        self.reference.clear_air()
    }

    pub fn show_sky(&mut self, shown: bool) {
        self.test.show_sky(shown);
        self.reference.show_sky(shown);
    }

    /// The reference, and what is under test.
    pub fn pictures(&mut self) -> Result<(RgbImage, RgbImage)> {
        Ok((self.reference.render()?, self.test.render()?))
    }

    /// The same in linear light.
    pub fn light_maps(&mut self) -> Result<(LightMap, LightMap)> {
        Ok((self.reference.light_map()?, self.test.light_map()?))
    }

    /// What each pixel would show without grass.
    pub fn opaque_places(&mut self) -> Result<Vec<Option<Vec3>>> {
        self.test.opaque_places()
    }

    /// Share of each pixel that is grass in the reference.
    pub fn reference_grass(&mut self) -> Result<Vec<f32>> {
        Ok(self.reference.light_map()?.pixels().map(|(_, grass)| grass).collect())
    }

    /// Frames of a camera and a time that stand still.
    pub fn still(&mut self, frames: u32, step: &dyn Fn()) -> Result<Still> {
        let mut first = None;
        let mut equal = true;
        for _ in 0..frames {
            self.test.step(0.0)?;
            let picture = self.test.render()?;
            equal &= *first.get_or_insert_with(|| picture.clone()) == picture;
            step();
        }
        Ok(Still { equal, frames })
    }
}

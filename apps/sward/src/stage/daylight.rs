//! What changes of the stage without the grass, as time goes on: light, wind, things and bodies.

use super::post::Post;
use super::sky::Sky;
use super::{Stage, options};
use anyhow::Result;
use sward::Light;
use sward_scene::{Heavens, Scene, SceneLight};

impl Stage {
    /// What moves by itself: time, sun, wind, things and bodies.
    pub(super) fn follow(&mut self, dt_s: f64) {
        self.last_time_s = self.time_s;
        self.time_s += dt_s;
        self.wind.sources = self.wind_paths.iter().map(|wind| wind.at(self.time_s)).collect();
        self.wind.advance(dt_s);
        self.movers.advance(self.time_s);
        self.move_light();
    }

    /// Moves the sun, and what is between it and the field.
    fn move_light(&mut self) {
        if self.heavens.is_none() && self.shade.is_none() {
            return;
        }
        if let Some(heavens) = &self.heavens {
            let now = heavens.at(self.time_s);
            self.take_light(now);
        }
        if let Some(shade) = &self.shade {
            self.light.shade = shade.at(self.time_s);
            self.uniform.set_shade(&self.light.shade);
        }
        self.write_camera();
    }

    fn take_light(&mut self, now: SceneLight) {
        let now = self.options.seen(now);
        let shade = self.light.shade;
        self.light = Light { shade, ..options::light(&self.options, &now) };
        self.uniform.set_light(&self.light, &now.sky);
        self.uniform.set_picture(&now);
        if let Some(dome) = &now.dome {
            self.sky.set_dome(&self.gpu.queue, dome);
        }
    }

    /// Lights the same moment by another scene's sun and sky, exposed and toned as that scene has it.
    ///
    /// # Errors
    /// Where the device fails.
    pub fn relight(&mut self, scene: &Scene) -> Result<()> {
        (self.options.tone, self.options.exposure_ev) = (scene.tone(), scene.exposure_ev);
        let now = scene.light_at(self.time_s);
        let samples = if self.options.reference { 1 } else { self.options.samples };
        self.sky = Sky::new(&self.gpu, &self.uniform, samples, now.dome.as_ref());
        let format = self.targets.picture.format();
        self.post = Post::new(&self.gpu.device, &self.uniform, format, &self.options);
        self.heavens = scene.heavens.clone().filter(Heavens::moves);
        self.take_light(now);
        self.write_camera();
        // The renderer takes its light with a step
        self.step(0.0)
    }
}

//! Debug views of the position target: where in the world each pixel is, and how far from the eye.

use super::look::DebugChoice;
use glam::Vec3;
use image::{Rgb, RgbImage};
use sward_app::picture::{Color, Legend, ramp};
use sward_app::stage::StageOptions;
use sward_scene::Scene;

/// What shows nothing but the sky.
const SKY: Color = [116, 122, 130];
/// Least place between ticks of the bar, so that their labels do not touch.
const TICKS_APART: f32 = 0.16;

/// How places become colours.
#[derive(Debug, Clone, Copy, Default)]
pub struct Places {
    eye: Vec3,
    /// Box of the scene's objects and the grass on them, whole metres.
    least: Vec3,
    most: Vec3,
}

impl Places {
    /// The box and the eye stay, so that the pictures of a run can be compared.
    pub fn new(scene: &Scene, options: &StageOptions) -> Self {
        let all = scene.objects.iter().flat_map(|object| &object.mesh.positions);
        let (low, high) = all.fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), p| {
            (low.min(*p), high.max(*p))
        });
        let species = scene.fields.iter().flat_map(|field| &field.desc.species);
        let tallest = species.map(|species| species.height_m.max).fold(0.0, f32::max);
        Self {
            eye: options.camera.eye,
            least: low.floor(),
            most: (high + Vec3::Y * tallest).ceil().max(low.floor() + 1.0),
        }
    }

    /// Colours the places of a picture's pixels.
    pub fn picture(
        &self,
        choice: DebugChoice,
        (width, height): (u32, u32),
        places: &[Option<Vec3>],
    ) -> RgbImage {
        RgbImage::from_fn(width, height, |x, y| {
            let place = places.get((y * width + x) as usize).copied().flatten();
            Rgb(place.map_or(SKY, |place| self.color(choice, place)))
        })
    }

    fn color(&self, choice: DebugChoice, place: Vec3) -> Color {
        if choice == DebugChoice::Distance {
            return by_share(place.distance(self.eye) / self.farthest());
        }
        let share = ((place - self.least) / (self.most - self.least)).clamp(Vec3::ZERO, Vec3::ONE);
        (share * 255.0).round().to_array().map(|channel| channel as u8)
    }

    /// What the colours mean.
    pub fn legend(&self, choice: DebugChoice) -> Legend {
        if choice == DebugChoice::Distance {
            let bar = |place: f32| by_share(place * place);
            return Legend::new("distance from the eye, m")
                .entry(SKY, "sky")
                .bar(bar, self.ticks());
        }
        let range = |i: usize, axis| format!("{axis}: {} to {} m", self.least[i], self.most[i]);
        Legend::new("position")
            .entry([255, 0, 0], range(0, "x"))
            .entry([0, 255, 0], range(1, "y"))
            .entry([0, 0, 255], range(2, "z"))
            .entry(SKY, "sky")
    }

    /// Farthest corner of the box from the eye.
    fn farthest(&self) -> f32 {
        (self.eye - self.least).abs().max((self.eye - self.most).abs()).length()
    }

    /// Round distances, from far to near, as near as labels allow.
    fn ticks(&self) -> Vec<(f32, String)> {
        let farthest = self.farthest();
        let decades = (-2..7).rev().flat_map(|power| [5, 2, 1].map(|n| (n, power)));
        let mut ticks = vec![];
        let mut last = 1.0 + TICKS_APART;
        for (n, power) in decades {
            let distance = n as f32 * 10_f32.powi(power);
            let place = (distance / farthest).sqrt();
            if place <= last - TICKS_APART && place > TICKS_APART {
                ticks.push((place, format!("{distance}")));
                last = place;
            }
        }
        ticks.push((0.0, "0".into()));
        ticks
    }
}

/// Colour of a share of the farthest distance, whose root runs evenly: what is near shows too.
fn by_share(share: f32) -> Color {
    ramp(share.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLACES: Places = Places {
        eye: Vec3::ZERO,
        least: Vec3::new(-2.0, 0.0, -4.0),
        most: Vec3::new(2.0, 1.0, 0.0),
    };

    #[test]
    fn colours_are_shares_of_the_box() {
        let color = |x, y, z| PLACES.color(DebugChoice::Position, Vec3::new(x, y, z));
        assert_eq!(color(-2.0, 0.0, -4.0), [0, 0, 0]);
        assert_eq!(color(2.0, 1.0, 0.0), [255; 3]);
        assert_eq!(color(0.0, 9.0, -3.0), [128, 255, 64]);
        let picture = PLACES.picture(DebugChoice::Position, (2, 1), &[None, Some(Vec3::ZERO)]);
        assert_eq!(picture.as_raw()[..], [SKY[0], SKY[1], SKY[2], 128, 0, 255]);
    }

    /// A tick's colour is that of its distance.
    #[test]
    fn the_bar_is_what_the_picture_shows() {
        let farthest = PLACES.farthest();
        assert!((farthest - 21_f32.sqrt()).abs() < 1e-6);
        let bar = PLACES.legend(DebugChoice::Distance).bar.unwrap();
        assert_eq!(
            bar.ticks.iter().map(|t| t.1.as_str()).collect::<Vec<_>>(),
            ["2", "1", "0.2", "0"]
        );
        for (place, label) in &bar.ticks {
            let at = Vec3::NEG_Z * label.parse::<f32>().unwrap();
            let (shown, told) = (PLACES.color(DebugChoice::Distance, at), (bar.color)(*place));
            assert!(shown.iter().zip(told).all(|(a, b)| a.abs_diff(b) <= 1), "{label}");
        }
    }
}

//! What is shown beside or in place of the blades' own look: debug views with their legends, names,
//! the frustum that blades were culled by.

use super::places::Places;
use crate::table::thousands;
use anyhow::{Context, Result};
use glam::{IVec2, Mat4, Vec2, Vec3, Vec4};
use image::RgbImage;
use sward::{DebugView, Field, Statistics};
use sward_app::picture::{Align, Canvas, Color, Corner, INK, Legend, PAPER, Type, ticks};
use sward_app::stage::{Stage, StageOptions};
use sward_scene::{Camera, Scene};

/// What `--debug` takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum DebugChoice {
    /// A colour for each patch
    Patches,
    /// Blades that a test drops, in the colour of the test
    Culling,
    /// How many segments each blade has
    Level,
    /// Blades that this step moved, and those that sleep
    Awake,
    /// How far collisions hold each blade down
    Crush,
    /// Edges of the triangles
    Wireframe,
    /// The same, on the right half only
    HalfWireframe,
    /// The ground from above: what the camera sees of it, and the cells that a sweep finds
    Frustum,
    /// The target of world positions, by which fog and depth of field are laid
    Position,
    /// Distance from the eye, by the same target
    Distance,
}

impl DebugChoice {
    /// The library's view; none where the view is of something else.
    fn view(self) -> Option<DebugView> {
        Some(match self {
            Self::Patches => DebugView::Patches,
            Self::Culling => DebugView::Culling,
            Self::Level => DebugView::Level,
            Self::Awake => DebugView::Awake,
            Self::Crush => DebugView::Crush,
            Self::Wireframe | Self::HalfWireframe => DebugView::Wireframe,
            Self::Position | Self::Distance | Self::Frustum => return None,
        })
    }
}

/// How the stage's pictures are taken.
#[derive(Debug, Default)]
pub struct Look {
    debug: Option<DebugChoice>,
    places: Places,
    /// Names, and the points under which they are written: where the roots end, towards +z.
    labels: Vec<(String, Vec3)>,
    clip_from_world: Mat4,
    /// Edges of the frustum that culls, metres.
    frustum: Vec<[Vec3; 2]>,
}

impl Look {
    /// Sets what the stage has to know.
    pub fn prepare(debug: Option<DebugChoice>, options: &mut StageOptions) {
        let whole = debug.filter(|d| *d != DebugChoice::HalfWireframe);
        options.debug = whole.and_then(DebugChoice::view);
        if debug.is_some() {
            // The legend's colours are the picture's
            (options.fog, options.depth_of_field) = (None, None);
            (options.tone, options.exposure_ev) = (sward_scene::Tone::Neutral, Some(0.0));
        }
    }

    /// `labels`: write the fields' names.
    pub fn new(
        debug: Option<DebugChoice>,
        labels: bool,
        (scene, fields): (&Scene, &[Field]),
        options: &StageOptions,
    ) -> Self {
        let aspect = options.size[0] as f32 / options.size[1] as f32;
        let label = |(named, grown): (&sward_scene::SceneField, &Field)| {
            let boxes = grown.patches().iter().map(|patch| (patch.root_min, patch.root_max));
            let join = |(a, b): (Vec3, Vec3), (c, d): (Vec3, Vec3)| (a.min(c), b.max(d));
            let (low, high) = boxes.reduce(join).unwrap_or_default();
            (named.name.clone(), Vec3::new(0.5 * (low.x + high.x), low.y, high.z))
        };
        let named = scene.fields.iter().zip(fields).filter(|_| labels);
        let frustum = options.culling_camera.as_ref().map(|camera| edges(camera, aspect));
        Self {
            debug,
            places: Places::new(scene, options),
            labels: named.map(label).collect(),
            clip_from_world: clip_from_world(&options.camera, aspect),
            frustum: frustum.unwrap_or_default(),
        }
    }

    /// Takes a picture of what the last step left.
    pub fn picture(&self, stage: &mut Stage) -> Result<RgbImage> {
        let mut picture = stage.render()?;
        let statistics = stage.statistics();
        if self.debug == Some(DebugChoice::HalfWireframe) {
            stage.show(Some(DebugView::Wireframe))?;
            let lines = stage.render()?;
            stage.show(None)?;
            join_halves(&mut picture, &lines);
        }
        let places = self.debug.filter(|debug| debug.view().is_none());
        if let Some(debug) = places {
            picture = self.places.picture(debug, picture.dimensions(), &stage.positions()?);
        }
        self.draw_frustum(&mut picture);
        self.draw_labels(&mut picture);
        if let Some(debug) = self.debug {
            let legend = match debug.view() {
                None => self.places.legend(debug),
                Some(view) => {
                    legend(view, &statistics.context("the device gave no statistics back")?)
                }
            };
            legend.draw(&mut picture, Corner::TopLeft);
        }
        Ok(picture)
    }

    fn draw_labels(&self, picture: &mut RgbImage) {
        let letters = Type::of(picture.dimensions());
        for (name, place) in &self.labels {
            let Some(at) = self.project(self.clip_from_world * place.extend(1.0), picture) else {
                continue;
            };
            let at = at.as_ivec2() + IVec2::Y * (letters.line() / 3);
            Canvas::new(picture).text_on_picture(at, name, letters, [PAPER, INK], Align::Center);
        }
    }

    fn draw_frustum(&self, picture: &mut RgbImage) {
        let width = Type::of(picture.dimensions()).stroke();
        for ends in &self.frustum {
            let [a, b] = ends.map(|end| self.clip_from_world * end.extend(1.0));
            let Some((a, b)) = before_the_eye(a, b) else { continue };
            let (Some(a), Some(b)) = (self.project(a, picture), self.project(b, picture)) else {
                continue;
            };
            let mut canvas = Canvas::new(picture);
            canvas.line(a, b, 3.0 * width, INK);
            canvas.line(a, b, width, PAPER);
        }
    }

    /// Pixel that shows a point; none behind the eye.
    fn project(&self, clip: Vec4, picture: &RgbImage) -> Option<Vec2> {
        let size = Vec2::new(picture.width() as f32, picture.height() as f32);
        let at = Vec2::new(clip.x, -clip.y) / clip.w * 0.5 + 0.5;
        (clip.w > 0.0).then_some(at * size)
    }
}

fn clip_from_world(camera: &Camera, aspect: f32) -> Mat4 {
    camera.clip_from_view(aspect) * camera.view_from_world()
}

/// The twelve edges of what a camera sees.
fn edges(camera: &Camera, aspect: f32) -> Vec<[Vec3; 2]> {
    let world = clip_from_world(camera, aspect).inverse();
    let corner = |x: f32, y: f32, z: f32| world.project_point3(Vec3::new(x, y, z));
    let ring = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let side = |i: usize| {
        let ((x, y), (u, v)) = (ring[i], ring[(i + 1) % 4]);
        let flat = |z| [corner(x, y, z), corner(u, v, z)];
        [flat(0.0), flat(1.0), [corner(x, y, 0.0), corner(x, y, 1.0)]]
    };
    (0..4).flat_map(side).collect()
}

/// The part of a line in clip space that lies before the eye.
fn before_the_eye(a: Vec4, b: Vec4) -> Option<(Vec4, Vec4)> {
    const NEAR: f32 = 1e-2;
    let cut = |inside: Vec4, outside: Vec4| {
        inside.lerp(outside, (inside.w - NEAR) / (inside.w - outside.w))
    };
    match (a.w > NEAR, b.w > NEAR) {
        (true, true) => Some((a, b)),
        (true, false) => Some((a, cut(a, b))),
        (false, true) => Some((cut(b, a), b)),
        (false, false) => None,
    }
}

/// The left half of one picture and the right half of the other.
fn join_halves(picture: &mut RgbImage, right: &RgbImage) {
    let middle = picture.width() / 2;
    for (x, y, pixel) in right.enumerate_pixels().filter(|(x, ..)| *x >= middle) {
        picture.put_pixel(x, y, *pixel);
    }
    let height = picture.height() as i32;
    let width = Type::of(picture.dimensions()).stroke() as i32;
    let left = middle as i32 - width / 2;
    Canvas::new(picture).fill(
        IVec2::new(left, 0),
        IVec2::new(left + width.max(1), height),
        PAPER,
        1.0,
    );
}

/// A debug colour as the picture shows it: it lies below the tone mapping's shoulder, so that only
/// the reflection of a dielectric is taken off.
fn srgb(linear: [f32; 3]) -> Color {
    let least = linear.into_iter().fold(1.0, f32::min);
    let off = if least < 0.08 { least - 6.25 * least * least } else { 0.04 };
    linear.map(|x| {
        let x = (x - off).clamp(0.0, 1.0);
        let encoded = if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 };
        (encoded * 255.0).round() as u8
    })
}

fn legend(view: DebugView, counted: &Statistics) -> Legend {
    let of_all = |n: u64| format!("{} of {}", thousands(n), thousands(counted.blades));
    let title = match view {
        DebugView::Patches => {
            let (seen, all) = (thousands(counted.patches_visible), thousands(counted.patches));
            format!("patches: {seen} of {all} seen")
        }
        DebugView::Culling => format!("drawn: {} blades", of_all(counted.blades_drawn)),
        DebugView::Level => return level_legend(counted),
        DebugView::Awake => format!("moved: {} blades", of_all(counted.blades_moved)),
        DebugView::Crush => return crush_legend(),
        _ => {
            let drawn = (thousands(counted.blades_drawn), thousands(counted.vertices));
            format!("{} blades, {} vertices", drawn.0, drawn.1)
        }
    };
    let mut legend = Legend::new(title);
    for (meaning, color) in view.colors() {
        let label = match view {
            DebugView::Culling => culled(meaning, counted),
            _ => (*meaning).to_owned(),
        };
        legend = legend.entry(srgb(*color), label);
    }
    legend
}

/// Blades by level, and of the other forms those that are drawn: both colours of a form that has two
/// beside the count of both.
fn level_legend(counted: &Statistics) -> Legend {
    let mut legend = Legend::new("level: drawn");
    let (mut levels, others) = DebugView::Level.colors().split_at(counted.drawn_by_level.len());
    let forms = [
        (1, counted.clusters_drawn),
        (2, counted.strips_drawn),
        (2, counted.billboards_drawn),
        (1, counted.models_drawn),
    ];
    if counted.drawn_by_level == [0; 4] && forms.iter().any(|(_, count)| *count > 0) {
        levels = &[];
    }
    for ((meaning, color), count) in levels.iter().zip(counted.drawn_by_level) {
        legend = legend.entry(srgb(*color), format!("{meaning}: {}", thousands(count)));
    }
    let mut rest = others.iter();
    for (colors, count) in forms {
        for (i, (meaning, color)) in rest.by_ref().take(colors).enumerate() {
            let label = match i {
                0 => format!("{meaning}: {}", thousands(count)),
                _ => format!("{meaning} (in the same count)"),
            };
            if count > 0 {
                legend = legend.entry(srgb(*color), label);
            }
        }
    }
    legend
}

/// Tests that single blades failed are counted in the patches that are seen.
fn culled(meaning: &str, counted: &Statistics) -> String {
    let hidden = counted.blades.saturating_sub(counted.blades_visible);
    match meaning {
        "frustum" => format!(
            "frustum: {} and {} in unseen patches",
            thousands(counted.culled_frustum),
            thousands(hidden)
        ),
        "distance" => format!("distance: {}", thousands(counted.culled_distance)),
        "occlusion" => format!("occlusion: {}", thousands(counted.culled_occlusion)),
        "orientation" => format!("orientation: {}", thousands(counted.culled_orientation)),
        _ => meaning.to_owned(),
    }
}

fn crush_legend() -> Legend {
    let color = |at: f32| {
        let colors = DebugView::Crush.colors();
        let [low, middle, high] = [0, 1, 2].map(|i| colors.get(i).map_or([0.0; 3], |c| c.1));
        let mix = |a: [f32; 3], b: [f32; 3], t: f32| {
            srgb(Vec3::from(a).lerp(Vec3::from(b), t).to_array())
        };
        if at < 0.5 { mix(low, middle, 2.0 * at) } else { mix(middle, high, 2.0 * at - 1.0) }
    };
    Legend::new("crush: how far collisions hold down").bar(color, ticks(0.0, 2.0, 4))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_cut_before_the_eye() {
        let (ahead, behind) = (Vec4::new(0.0, 0.0, 1.0, 2.0), Vec4::new(4.0, 0.0, 1.0, -2.0));
        let (a, b) = before_the_eye(ahead, behind).unwrap();
        assert!(a == ahead && b.w > 0.0 && b.x > 1.9 && b.x < 2.0, "{b}");
        assert_eq!(before_the_eye(behind, ahead).unwrap().1, ahead);
        assert!(before_the_eye(behind, behind).is_none());
    }

    #[test]
    fn every_view_has_a_legend_with_its_counts() {
        let counted =
            Statistics { blades: 5000, drawn_by_level: [1, 2, 3, 4], ..Default::default() };
        let level = legend(DebugView::Level, &counted);
        assert_eq!(level.entries[2].1, "2 segments: 3");
        assert_eq!(level.entries.len(), 4, "forms that are not drawn take no room");
        let strips = Statistics { strips_drawn: 7, models_drawn: 2, ..Default::default() };
        let rows: Vec<_> = legend(DebugView::Level, &strips).entries;
        let rows: Vec<_> = rows.iter().map(|(_, label)| label.as_str()).collect();
        let few = "strip of 3 pieces (in the same count)";
        assert_eq!(rows, ["strip of 12 pieces: 7", few, "model: 2"]);
        let culling = legend(DebugView::Culling, &counted);
        assert!(culling.entries[1].1.contains("5,000 in unseen patches"), "{culling:?}");
        assert!(legend(DebugView::Crush, &counted).bar.is_some());
    }

    /// Debug colours keep below what tone mapping bends: the legend's colours are the picture's.
    #[test]
    fn debug_colours_are_below_the_shoulder() {
        for view in DebugView::ALL {
            for (meaning, color) in view.colors() {
                assert!(color.iter().all(|x| (0.0..0.76).contains(x)), "{view:?}: {meaning}");
            }
        }
    }
}

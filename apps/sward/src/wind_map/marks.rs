//! Sources, scale and compass on a map.

use super::Frame;
use crate::picture::{Align, Canvas, INK, PAPER, Type};
use glam::{IVec2, Vec2};
use sward::{Fan, Wind, WindSource};

/// Draws them all.
pub(super) fn draw(canvas: &mut Canvas, frame: &Frame, wind: &Wind) {
    let letters = Type::of((frame.size.x as u32, frame.size.y as u32));
    for source in &wind.sources {
        draw_source(canvas, frame, letters, source);
    }
    draw_scale(canvas, frame, letters);
    draw_compass(canvas, frame, letters);
}

fn draw_source(canvas: &mut Canvas, frame: &Frame, letters: Type, source: &WindSource) {
    let (name, radius_m) = match source {
        WindSource::Rotor(rotor) => ("rotor", rotor.radius_m),
        WindSource::Vortex(vortex) => ("vortex", vortex.radius_m),
        WindSource::Fan(fan) => {
            draw_cone(canvas, frame, letters, fan);
            ("fan", fan.radius_m)
        }
        _ => return,
    };
    let Some(position) = source.position() else { return };
    let at = frame.pixel(Vec2::new(position.x, position.z));
    let radius = (radius_m / frame.metres_a_pixel).max(letters.line() as f32 * 0.3);
    let width = letters.stroke() * 1.5;
    canvas.circle(at, radius, 2.0 * width, INK);
    canvas.circle(at, radius, width, PAPER);
    canvas.circle(at, width, width, PAPER);
    let below = at + Vec2::Y * (radius + width);
    canvas.text_on_picture(below.as_ivec2(), name, letters, [PAPER, INK], Align::Center);
}

/// The edges of a fan's cone, as far as it reaches.
fn draw_cone(canvas: &mut Canvas, frame: &Frame, letters: Type, fan: &Fan) {
    let place = |v: glam::Vec3| Vec2::new(v.x, v.z);
    let axis = fan.direction.normalize_or_zero();
    let Some(side) = place(axis).perp().try_normalize() else { return };
    let spread = fan.half_angle_deg.to_radians().tan();
    let (near, far) = (place(fan.position), place(fan.position + axis * fan.range_m));
    for side in [side, -side] {
        let from = frame.pixel(near + side * fan.radius_m);
        let to = frame.pixel(far + side * (fan.radius_m + fan.range_m * spread));
        canvas.line(from, to, letters.stroke(), PAPER);
    }
}

/// A bar of a round length.
fn draw_scale(canvas: &mut Canvas, frame: &Frame, letters: Type) {
    let longest = frame.size.x as f32 * 0.25 * frame.metres_a_pixel;
    let decade = 10_f32.powf(longest.log10().floor());
    let steps = [5.0, 2.0, 1.0].map(|step| step * decade);
    let length_m = steps.into_iter().find(|step| *step <= longest).unwrap_or(decade);
    let line = letters.line();
    let start = IVec2::new(line, frame.size.y - line);
    let end = start.as_vec2() + Vec2::X * (length_m / frame.metres_a_pixel);
    let width = letters.stroke() * 2.0;
    for (extra, color) in [(width, INK), (0.0, PAPER)] {
        canvas.line(start.as_vec2(), end, width + extra, color);
        for at in [start.as_vec2(), end] {
            let up = Vec2::Y * (line as f32 * 0.3);
            canvas.line(at - up, at + up, width + extra, color);
        }
    }
    let text = format!("{length_m} m");
    let above = start - IVec2::Y * (line * 3 / 2);
    canvas.text_on_picture(above, &text, letters, [PAPER, INK], Align::Left);
}

/// North, and the axes x (east) and z (south).
fn draw_compass(canvas: &mut Canvas, frame: &Frame, letters: Type) {
    let line = letters.line() as f32;
    let (arm, width) = (line * 2.0, letters.stroke() * 1.5);
    let center = Vec2::new(frame.size.x as f32 - arm - 2.0 * line, arm + 1.5 * line);
    for (way, name) in [(Vec2::NEG_Y, "N"), (Vec2::X, "x"), (Vec2::Y, "z")] {
        let tip = center + way * arm;
        let shadow = Vec2::splat(width * 0.8);
        canvas.arrow(center + shadow, tip + shadow, width, INK);
        canvas.arrow(center, tip, width, PAPER);
        let middle = (tip + way * line * 0.7).as_ivec2() - IVec2::Y * (letters.line() / 2);
        canvas.text_on_picture(middle, name, letters, [PAPER, INK], Align::Center);
    }
}

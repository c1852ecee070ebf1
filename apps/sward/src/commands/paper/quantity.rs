//! What is measured: two scenes, three conditions, and the quantities of the tables.

use crate::measure::{Percentiles, Report};
use crate::table::thousands;
use serde::{Deserialize, Serialize};

/// A scene of the evaluation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SceneName {
    /// Hills with a bunny, balls, rocks and trees.
    Nature,
    /// A wide field under a rotor.
    Helicopter,
}

impl SceneName {
    pub const ALL: [Self; 2] = [Self::Nature, Self::Helicopter];

    /// As in files, and the stem of the scene's own.
    pub fn key(self) -> &'static str {
        match self {
            Self::Nature => "nature",
            Self::Helicopter => "helicopter",
        }
    }
}

/// What was left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Condition {
    /// Nothing.
    #[serde(rename = "everything_on")]
    All,
    /// Colliders push no blades.
    #[serde(rename = "collisions_off")]
    NoCollisions,
    /// Every blade is drawn.
    #[serde(rename = "culling_off")]
    NoCulling,
}

impl Condition {
    pub const ALL: [Self; 3] = [Self::All, Self::NoCollisions, Self::NoCulling];

    /// As in files.
    pub fn key(self) -> &'static str {
        match self {
            Self::All => "everything_on",
            Self::NoCollisions => "collisions_off",
            Self::NoCulling => "culling_off",
        }
    }
}

/// A row of the tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    BladesTotal,
    BladesVisible,
    CulledOrientation,
    CulledFrustum,
    CulledDistance,
    CulledOcclusion,
    CulledAny,
    BladesDrawn,
    Spheres,
    SpheresTested,
    PhysicsMs,
    VisibilityMs,
    DrawMs,
    PostMs,
    FrameMs,
    Fps,
}

/// A measured value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// A count.
    Count(u64),
    /// Milliseconds: median and 99th percentile.
    Ms(f32, f32),
    /// Of the median frame.
    Fps(f32),
}

impl Quantity {
    /// Rows of the tables of times.
    pub const COSTS: [Self; 10] = [
        Self::BladesTotal,
        Self::BladesDrawn,
        Self::Spheres,
        Self::SpheresTested,
        Self::PhysicsMs,
        Self::VisibilityMs,
        Self::DrawMs,
        Self::PostMs,
        Self::FrameMs,
        Self::Fps,
    ];

    /// Rows of the table of culled blades.
    pub const CULLED: [Self; 8] = [
        Self::BladesTotal,
        Self::BladesVisible,
        Self::CulledOrientation,
        Self::CulledFrustum,
        Self::CulledDistance,
        Self::CulledOcclusion,
        Self::CulledAny,
        Self::BladesDrawn,
    ];

    /// As in files.
    pub fn key(self) -> &'static str {
        match self {
            Self::BladesTotal => "blades_total",
            Self::BladesVisible => "blades_visible",
            Self::CulledOrientation => "culled_orientation",
            Self::CulledFrustum => "culled_frustum",
            Self::CulledDistance => "culled_distance",
            Self::CulledOcclusion => "culled_occlusion",
            Self::CulledAny => "culled_any",
            Self::BladesDrawn => "blades_drawn",
            Self::Spheres => "spheres",
            Self::SpheresTested => "spheres_tested",
            Self::PhysicsMs => "physics_ms",
            Self::VisibilityMs => "visibility_ms",
            Self::DrawMs => "draw_ms",
            Self::PostMs => "post_ms",
            Self::FrameMs => "frame_ms",
            Self::Fps => "fps",
        }
    }

    /// As in text.
    pub fn name(self) -> &'static str {
        match self {
            Self::BladesTotal => "blades",
            Self::BladesVisible => "blades in visible patches",
            Self::CulledOrientation => "culled by orientation",
            Self::CulledFrustum => "culled by frustum",
            Self::CulledDistance => "culled by distance",
            Self::CulledOcclusion => "culled by occlusion",
            Self::CulledAny => "culled by any of them",
            Self::BladesDrawn => "blades drawn",
            Self::Spheres => "spheres of the colliders",
            Self::SpheresTested => "sphere tests of blades",
            Self::PhysicsMs => "physics, ms",
            Self::VisibilityMs => "visibility, ms",
            Self::DrawMs => "draw, ms",
            Self::PostMs => "tone mapping, ms",
            Self::FrameMs => "whole frame, ms",
            Self::Fps => "frames a second",
        }
    }

    /// Ours.
    pub fn measured(self, report: &Report, spheres: u64) -> Value {
        let ms = |of: Percentiles| Value::Ms(of.p50, of.p99);
        match self {
            Self::BladesTotal => Value::Count(report.blades_total),
            Self::BladesVisible => Value::Count(report.blades_visible),
            Self::CulledOrientation => Value::Count(report.blades_culled.orientation),
            Self::CulledFrustum => Value::Count(report.blades_culled.frustum),
            Self::CulledDistance => Value::Count(report.blades_culled.distance),
            Self::CulledOcclusion => Value::Count(report.blades_culled.occlusion),
            Self::CulledAny => Value::Count(
                report.blades_visible.saturating_sub(report.blades_drawn + report.blades_dropped),
            ),
            Self::BladesDrawn => Value::Count(report.blades_drawn),
            Self::Spheres => Value::Count(spheres),
            Self::SpheresTested => Value::Count(report.spheres_tested),
            Self::PhysicsMs => ms(report.ms.physics),
            Self::VisibilityMs => ms(report.ms.visibility),
            Self::DrawMs => ms(report.ms.draw),
            Self::PostMs => ms(report.ms.post),
            Self::FrameMs => ms(report.ms.frame),
            Self::Fps => Value::Fps(1e3 / report.ms.frame.p50.max(1e-6)),
        }
    }

    /// A published value, written as ours are.
    pub fn write_published(self, value: f64) -> String {
        match self {
            Self::PhysicsMs | Self::VisibilityMs | Self::DrawMs | Self::PostMs | Self::FrameMs => {
                format!("{value:.2}")
            }
            Self::Fps => format!("{value:.1}"),
            _ => thousands(value.round() as u64),
        }
    }
}

impl Value {
    /// As a cell of a table.
    pub fn write(self) -> String {
        match self {
            Self::Count(count) => thousands(count),
            Self::Ms(p50, p99) => format!("{p50:.2} (p99 {p99:.2})"),
            Self::Fps(fps) => format!("{fps:.1}"),
        }
    }

    /// As a member of the JSON file.
    pub fn json(self) -> serde_json::Value {
        match self {
            Self::Count(count) => count.into(),
            Self::Ms(p50, p99) => serde_json::json!({ "p50": p50, "p99": p99 }),
            Self::Fps(fps) => fps.into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Files say what the code says.
    #[test]
    fn keys_are_the_names_in_files() {
        let written = |value: &dyn Fn() -> serde_json::Result<serde_json::Value>| {
            value().unwrap().as_str().unwrap().to_string()
        };
        for quantity in Quantity::COSTS.into_iter().chain(Quantity::CULLED) {
            assert_eq!(written(&|| serde_json::to_value(quantity)), quantity.key());
        }
        for condition in Condition::ALL {
            assert_eq!(written(&|| serde_json::to_value(condition)), condition.key());
        }
        for scene in SceneName::ALL {
            assert_eq!(written(&|| serde_json::to_value(scene)), scene.key());
        }
    }
}

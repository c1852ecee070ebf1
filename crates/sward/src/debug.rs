//! Views of what is otherwise not seen: patches, culling, levels, sleep, crush, triangles.

use glam::Mat4;

/// What a view shows in place of the blades' own look. Debug views have pipelines of their own, made
/// when one is first used, and 4 bytes a blade more; other views do not pay for them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum DebugView {
    /// A colour for each patch.
    Patches,
    /// Every blade, those that a test drops in the colour of the first test that drops them: frustum,
    /// distance, occlusion, orientation. Blades that fail with their whole patch count as well.
    Culling,
    /// Which form a plant is drawn in, and how many segments a blade has; colours blend while one level
    /// turns into the next.
    Level,
    /// Every blade, those that this step moved apart from those that sleep.
    Awake,
    /// How far collisions still hold a blade down.
    Crush,
    /// The edges of the triangles; what lies between them is left out.
    Wireframe,
}

/// A meaning and its colour, linear RGB: blades have it at their tips, and darker towards their roots.
pub type DebugColor = (&'static str, [f32; 3]);

impl DebugView {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Patches, Self::Culling, Self::Level, Self::Awake, Self::Crush, Self::Wireframe];

    /// What its colours mean, for a legend. Of [`DebugView::Crush`] the crush `eta` at which each
    /// colour is reached; patches have no fixed colours.
    pub fn colors(self) -> &'static [DebugColor] {
        match self {
            Self::Patches => &[],
            Self::Culling => &[
                ("drawn", [0.13, 0.4, 0.06]),
                ("frustum", [0.05, 0.16, 0.7]),
                ("distance", [0.6, 0.05, 0.45]),
                ("occlusion", [0.7, 0.2, 0.02]),
                ("orientation", [0.72, 0.62, 0.08]),
            ],
            Self::Level => &[
                ("8 segments", [0.7, 0.09, 0.04]),
                ("4 segments", [0.72, 0.5, 0.05]),
                ("2 segments", [0.12, 0.5, 0.1]),
                ("1 segment", [0.06, 0.2, 0.7]),
                ("cluster of 32", [0.6, 0.1, 0.55]),
                ("strip of 12 pieces", [0.74, 0.28, 0.03]),
                ("strip of 3 pieces", [0.05, 0.42, 0.4]),
                ("all quads", [0.45, 0.62, 0.06]),
                ("half of the quads", [0.16, 0.14, 0.6]),
                ("model", [0.7, 0.06, 0.2]),
            ],
            Self::Awake => &[
                ("moved, seen", [0.16, 0.5, 0.08]),
                ("moved, near a collider", [0.72, 0.28, 0.03]),
                ("asleep", [0.09, 0.12, 0.26]),
            ],
            Self::Crush => {
                &[("0", [0.06, 0.13, 0.2]), ("1", [0.65, 0.14, 0.04]), ("2", [0.74, 0.68, 0.3])]
            }
            Self::Wireframe => &[("edge of a triangle", [0.6, 0.7, 0.5])],
        }
    }

    /// Number in the shader.
    pub(crate) fn mode(self) -> u32 {
        self as u32
    }

    /// Whether it shows blades that are not drawn otherwise.
    pub(crate) fn shows_all(self) -> bool {
        matches!(self, Self::Culling | Self::Awake)
    }
}

/// Another camera that looks at what a view culled: it shows what the view leaves out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Observer {
    /// World to view.
    pub view_from_world: Mat4,
    /// View to clip, z in 0..w.
    pub clip_from_view: Mat4,
}

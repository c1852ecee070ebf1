//! Counted work.

/// Counted work of one frame, read back a frame or more late.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Statistics {
    /// Blades of the field.
    pub blades: u64,
    /// Patches of the field.
    pub patches: u64,
    /// Patches that passed the coarse tests.
    pub patches_visible: u64,
    /// Blades in those patches.
    pub blades_visible: u64,
    /// Plants drawn, each in one form: the sum of the five counts that follow.
    pub blades_drawn: u64,
    /// Those drawn as single blades, by level: with 8, 4, 2 and 1 segments.
    pub drawn_by_level: [u64; 4],
    /// Those drawn as clusters, each of which stands for 32 blades.
    pub clusters_drawn: u64,
    /// Those drawn as strips.
    pub strips_drawn: u64,
    /// Those drawn as billboards.
    pub billboards_drawn: u64,
    /// Those drawn as modelled plants.
    pub models_drawn: u64,
    /// Blades that the step moved, in the blocks of patches that the view may see; the others sleep.
    pub blades_moved: u64,
    /// Failed the orientation test (a blade that fails two tests counts in both).
    pub culled_orientation: u64,
    /// Failed the frustum test.
    pub culled_frustum: u64,
    /// Failed the distance test.
    pub culled_distance: u64,
    /// Failed the occlusion test.
    pub culled_occlusion: u64,
    /// Survivors that did not fit the list.
    pub dropped: u64,
    /// Tests of blades against spheres, capsules and boxes, in the same blocks.
    pub spheres_tested: u64,
    /// Patches that are near more chunks of 64 colliders than their list has room for: their blades
    /// look for the rest themselves, which takes longer. Nothing is left out.
    pub patches_crowded: u64,
    /// Vertices drawn.
    pub vertices: u64,
}

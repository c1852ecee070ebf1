//! Which triangles a blade is made of, in each bucket of blades.

use crate::gpu::quantize::SEGMENTS;

/// Blades of one instance: fewer, larger instances cost less than one a blade.
pub(crate) const BLADES_PER_INSTANCE: u32 = 64;

/// How a bucket's blades are tessellated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Topology {
    /// Segments along the blade.
    pub segments: u32,
    /// Vertices a ring: 2, or 3 where the ridge shows.
    pub ring: u32,
    /// Ends in an edge.
    pub flat_tip: bool,
}

impl Topology {
    /// Of a bucket: level and kind of tip. Only the first two levels show the ridge.
    pub(crate) fn of(bucket: usize) -> Self {
        let level = bucket % 4;
        Self {
            segments: SEGMENTS[level],
            ring: if level <= 1 { 3 } else { 2 },
            flat_tip: bucket >= 4,
        }
    }

    /// Vertices a blade: n rings, then an edge or a point.
    pub(crate) fn vertices(self) -> u32 {
        self.segments * self.ring + if self.flat_tip { self.ring } else { 1 }
    }

    /// Triangles of one blade, root to tip.
    pub(crate) fn indices(self) -> Vec<u16> {
        let (segments, ring) = (self.segments as u16, self.ring as u16);
        let mut list = Vec::new();
        for k in 0..segments {
            let (low, high) = (k * ring, (k + 1) * ring);
            let pointed = k + 1 == segments && !self.flat_tip;
            for side in 0..ring - 1 {
                let (a, b) = (low + side, low + side + 1);
                if pointed {
                    list.extend([a, b, high]);
                } else {
                    let (c, d) = (high + side, high + side + 1);
                    list.extend([a, b, c, b, d, c]);
                }
            }
        }
        list
    }
}

#[cfg(test)]
mod tests {
    use super::Topology;

    #[test]
    fn vertex_counts_are_the_papers() {
        let blade = |segments, ring, flat_tip| Topology { segments, ring, flat_tip };
        assert_eq!(blade(8, 2, false).vertices(), 17);
        assert_eq!(blade(8, 2, true).vertices(), 18);
        assert_eq!(blade(8, 3, false).vertices(), 25);
        assert_eq!(blade(1, 2, false).vertices(), 3);
        assert_eq!(blade(2, 3, true).vertices(), 9);
    }

    #[test]
    fn every_vertex_is_used_and_none_beyond() {
        for bucket in 0..8 {
            let topology = Topology::of(bucket);
            let mut used: Vec<_> = topology.indices();
            let triangles = used.len() / 3;
            used.sort_unstable();
            used.dedup();
            assert_eq!(used, (0..topology.vertices() as u16).collect::<Vec<_>>());
            let sides = (topology.ring - 1) as usize;
            let last = if topology.flat_tip { 2 } else { 1 };
            assert_eq!(triangles, sides * (2 * (topology.segments as usize - 1) + last));
        }
    }
}

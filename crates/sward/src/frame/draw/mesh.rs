//! The triangles of a plant, in each bucket.

use super::topology::{BLADES_PER_INSTANCE, Topology};
use crate::billboard::MAX_QUADS;
use crate::gpu::layout::{BILLBOARD_BUCKETS, BLADE_BUCKETS, BUCKETS, MODEL_BUCKET, STRIP_BUCKETS};
use crate::plants::mesh::PIECES;
use crate::plants::model::MAX_RIBBONS;

/// Segments of a strip with many rings, and with few, which divide it.
pub(crate) const STRIP_SEGMENTS: [u32; 2] = [12, 3];

/// What a plant of a bucket is made of.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Mesh {
    /// Vertices a plant: at most 1024, as an instance of 64 plants is indexed with 16 bits.
    pub vertices: u32,
    /// Triangles of one plant.
    pub indices: Vec<u16>,
}

impl Mesh {
    /// Of a bucket.
    pub(crate) fn of(bucket: usize) -> Self {
        if bucket < BLADE_BUCKETS {
            let topology = Topology::of(bucket);
            return Self { vertices: topology.vertices(), indices: topology.indices() };
        }
        let [middle, far] = BILLBOARD_BUCKETS;
        match bucket {
            _ if bucket == STRIP_BUCKETS[0] => Self::strips(STRIP_SEGMENTS[0]),
            _ if bucket == STRIP_BUCKETS[1] => Self::strips(STRIP_SEGMENTS[1]),
            _ if bucket == middle => Self::quads(MAX_QUADS, 2),
            _ if bucket == far => Self::quads(MAX_QUADS.div_ceil(2), 1),
            // Ribbons are cards of several pieces, too
            MODEL_BUCKET => Self::quads(MAX_RIBBONS as u32, PIECES),
            _ => Self::card(),
        }
    }

    /// Two strips along a shared middle line: rings of left, middle, right.
    fn strips(segments: u32) -> Self {
        let quads = (0..segments as u16).flat_map(|s| [3 * s, 3 * s + 1]);
        let indices = quads.flat_map(|i| [i, i + 1, i + 3, i + 1, i + 4, i + 3]);
        Self { vertices: 3 * (segments + 1), indices: indices.collect() }
    }

    /// Cards, each of so many pieces from bottom to top.
    fn quads(quads: u32, pieces: u32) -> Self {
        let rows = pieces as u16 + 1;
        let piece = |quad: u16, piece: u16| {
            let first = 2 * (quad * rows + piece);
            Self::card().indices.into_iter().map(move |i| first + i)
        };
        let indices =
            (0..quads as u16).flat_map(|q| (0..pieces as u16).flat_map(move |p| piece(q, p)));
        Self { vertices: 2 * quads * u32::from(rows), indices: indices.collect() }
    }

    /// Two triangles: from the left of the bottom on, counterclockwise by rows.
    pub(crate) fn card() -> Self {
        Self { vertices: 4, indices: vec![0, 1, 2, 1, 3, 2] }
    }

    /// Triangles of an instance.
    pub(crate) fn instance_indices(&self) -> Vec<u16> {
        (0..BLADES_PER_INSTANCE as u16)
            .flat_map(|plant| {
                let first = plant * self.vertices as u16;
                self.indices.iter().map(move |i| first + i)
            })
            .collect()
    }
}

/// Vertices a plant, by bucket.
pub(crate) fn vertices_by_bucket() -> [u32; BUCKETS] {
    std::array::from_fn(|bucket| Mesh::of(bucket).vertices)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_instance_is_64_plants_within_16_bits() {
        for bucket in 0..BUCKETS {
            let mesh = Mesh::of(bucket);
            assert!(mesh.vertices <= 1024, "bucket {bucket}");
            assert!(mesh.indices.iter().all(|i| u32::from(*i) < mesh.vertices));
            let all = mesh.instance_indices();
            assert_eq!(all.len(), 64 * mesh.indices.len());
            assert_eq!(u32::from(all.iter().copied().max().unwrap_or(0)), 64 * mesh.vertices - 1);
        }
    }
}

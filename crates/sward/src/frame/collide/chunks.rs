//! Primitives ordered in space and cut into chunks, so that patches and blades pass over many at
//! once.

use super::primitive::{Bounds, GpuPrimitive, Primitive};
use crate::gpu::layout::{CHUNK, CHUNK_STRIDE};
use bytemuck::Zeroable;
use glam::Vec3;
use rayon::prelude::*;

/// Fewer than this are sorted on one thread.
const PARALLEL: usize = 1 << 16;

/// Primitives as the GPU reads them: chunks of a box, then up to 64 primitives.
#[derive(Debug, Default, Clone, PartialEq)]
pub(crate) struct Chunks {
    /// [`CHUNK_STRIDE`] entries a chunk.
    pub(crate) entries: Vec<GpuPrimitive>,
}

impl Chunks {
    /// Orders primitives by size, then along a Morton curve, and cuts them.
    pub(crate) fn new(primitives: &[Primitive]) -> Self {
        let order = spatial_order(primitives);
        let mut entries = Vec::with_capacity(chunk_count(primitives.len()) * CHUNK_STRIDE);
        for members in order.chunks(CHUNK) {
            let members = members.iter().map(|i| &primitives[*i as usize]);
            let start = entries.len();
            let bounds = members.clone().fold(Bounds::NONE, |bounds, p| bounds.union(p.bounds()));
            entries.push(header(bounds, members.len()));
            entries.extend(members.map(GpuPrimitive::from));
            entries.resize(start + CHUNK_STRIDE, GpuPrimitive::zeroed());
        }
        Self { entries }
    }

    /// How many there are.
    pub(crate) fn count(&self) -> usize {
        self.entries.len() / CHUNK_STRIDE
    }
}

/// Chunks that so many primitives fill.
pub(crate) fn chunk_count(primitives: usize) -> usize {
    primitives.div_ceil(CHUNK)
}

fn header(bounds: Bounds, members: usize) -> GpuPrimitive {
    let bits = |v: Vec3, w| [v.x.to_bits(), v.y.to_bits(), v.z.to_bits(), w];
    GpuPrimitive { a: bits(bounds.min, members as u32), b: bits(bounds.max, 0) }
}

/// Indices in the order of chunks. Depends on the primitives alone.
fn spatial_order(primitives: &[Primitive]) -> Vec<u32> {
    let balls: Vec<_> = primitives.iter().map(Primitive::ball).collect();
    let all = balls.iter().fold(Bounds::NONE, |bounds, (center, _)| {
        bounds.union(Bounds { min: *center, max: *center })
    });
    let scale = 1023.0 / (all.max - all.min).max_element().max(1e-6);
    let smallest = balls.iter().fold(f32::INFINITY, |least, (_, radius)| least.min(*radius));
    let mut keys: Vec<u64> = (0..)
        .zip(&balls)
        .map(|(index, (center, radius))| {
            // A chunk of small ones with a large one in it would be near everything
            let class = ((radius / smallest).log2() * 0.5).clamp(0.0, 3.0) as u64;
            let cell = (*center - all.min) * scale;
            class << 62 | morton(cell) << 32 | u64::from(index as u32)
        })
        .collect();
    if keys.len() < PARALLEL {
        keys.sort_unstable();
    } else {
        keys.par_sort_unstable();
    }
    keys.into_iter().map(|key| key as u32).collect()
}

/// Bits of a cell of 0 to 1023 a side, by turns.
fn morton(cell: Vec3) -> u64 {
    let spread = |x: f32| {
        let mut bits = (x as u64).min(1023);
        bits = (bits | bits << 16) & 0x0300_00ff;
        bits = (bits | bits << 8) & 0x0300_f00f;
        bits = (bits | bits << 4) & 0x030c_30c3;
        (bits | bits << 2) & 0x0924_9249
    };
    spread(cell.x) | spread(cell.y) << 1 | spread(cell.z) << 2
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ball(center: Vec3, radius: f32) -> Primitive {
        Primitive::Capsule { from: center, to: center, radius }
    }

    #[test]
    fn every_primitive_is_in_one_chunk_whose_box_holds_it() {
        let at = |i: u32| Vec3::new((i * 37 % 101) as f32, (i * 17 % 13) as f32, (i % 7) as f32);
        let balls: Vec<_> = (0..200).map(|i| ball(at(i), 0.1 + (i % 9) as f32)).collect();
        let chunks = Chunks::new(&balls);
        assert_eq!(chunks.count(), 4);
        let mut found = Vec::new();
        for chunk in chunks.entries.chunks(CHUNK_STRIDE) {
            let count = chunk[0].a[3] as usize;
            let f = |bits: u32| f32::from_bits(bits);
            for member in &chunk[1..=count] {
                let [x, y, z, radius] = member.a.map(f);
                let bounds = ball(Vec3::new(x, y, z), radius).bounds();
                let min = Vec3::new(f(chunk[0].a[0]), f(chunk[0].a[1]), f(chunk[0].a[2]));
                let max = Vec3::new(f(chunk[0].b[0]), f(chunk[0].b[1]), f(chunk[0].b[2]));
                assert!(min.cmple(bounds.min).all() && bounds.max.cmple(max).all());
                found.push(member.a);
            }
        }
        let mut all: Vec<_> = balls.iter().map(|b| GpuPrimitive::from(b).a).collect();
        all.sort_unstable();
        found.sort_unstable();
        assert_eq!(found, all);
    }

    #[test]
    fn chunks_are_compact() {
        let at = |i: u32| Vec3::new((i * 37 % 100) as f32, 0.0, (i * 61 % 97) as f32);
        let balls: Vec<_> = (0..6400).map(|i| ball(at(i), 0.2)).collect();
        let chunks = Chunks::new(&balls);
        let area = |chunk: &[GpuPrimitive]| {
            let side = |i| f32::from_bits(chunk[0].b[i]) - f32::from_bits(chunk[0].a[i]);
            side(0) * side(2)
        };
        let total: f32 = chunks.entries.chunks(CHUNK_STRIDE).map(area).sum();
        // 100 chunks tile the square of 100 m; along a Morton curve some overlap
        assert!(total < 3.0 * 100.0 * 97.0, "{total}");
    }

    #[test]
    fn nothing_gives_no_chunks() {
        assert_eq!(Chunks::new(&[]).count(), 0);
        let same = vec![ball(Vec3::ONE, 1.0); 65];
        assert_eq!(Chunks::new(&same).count(), 2);
    }
}

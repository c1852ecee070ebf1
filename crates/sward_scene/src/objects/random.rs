//! A small seeded generator (`SplitMix64`, Steele et al. 2014): the same on every machine.

use glam::Vec3;

pub(crate) struct Random(u64);

impl Random {
    /// Different streams of one seed do not meet.
    pub(crate) fn new(seed: u64, stream: u64) -> Self {
        let mut random = Self(seed ^ stream.wrapping_mul(0xd134_2543_de82_ef95));
        random.next();
        random
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub(crate) fn between(&mut self, min: f32, max: f32) -> f32 {
        min + (max - min) * ((self.next() >> 40) as f32 / (1_u64 << 24) as f32)
    }

    /// Uniform over the sphere.
    pub(crate) fn direction(&mut self) -> Vec3 {
        let y = self.between(-1.0, 1.0);
        let (sin, cos) = self.between(0.0, std::f32::consts::TAU).sin_cos();
        let flat = (1.0 - y * y).max(0.0).sqrt();
        Vec3::new(flat * sin, y, flat * cos)
    }
}

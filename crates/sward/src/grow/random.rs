//! Random numbers by counter: draw `i` of a stream depends on the seed, the purpose and `i` alone,
//! so that any number of threads draws the same.

/// What a stream is for: streams of one seed are independent of each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Purpose {
    Single = 1,
    Dart,
    Tuft,
    TuftBlade,
    SingleShape,
    BladeShape,
    TuftShape,
    Meadow,
    Terrain,
    Plant,
}

/// The finaliser of SplitMix64: every bit of the input changes about half of the output's.
pub(crate) fn mix(mut x: u64) -> u64 {
    x ^= x >> 30;
    x = x.wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x ^= x >> 27;
    x = x.wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// All draws of one purpose.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stream {
    key: u64,
}

impl Stream {
    pub(crate) fn new(seed: u64, purpose: Purpose) -> Self {
        Self { key: mix(mix(seed ^ GOLDEN).wrapping_add(GOLDEN.wrapping_mul(purpose as u64))) }
    }

    /// The draws of one index.
    pub(crate) fn at(self, index: u64) -> Draws {
        Draws { state: mix(self.key ^ mix(index.wrapping_add(GOLDEN))) }
    }
}

/// A sequence of draws (SplitMix64).
#[derive(Debug, Clone)]
pub(crate) struct Draws {
    state: u64,
}

impl Draws {
    pub(crate) fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(GOLDEN);
        mix(self.state)
    }

    /// Uniform in 0..1, 1 excluded, in steps of 2^-24.
    pub(crate) fn unit(&mut self) -> f32 {
        (self.bits() >> 40) as f32 * (1.0 / 16_777_216.0)
    }

    /// Uniform in 0..1, 1 excluded, in steps of 2^-53.
    pub(crate) fn unit_f64(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * (1.0 / 9_007_199_254_740_992.0)
    }

    /// Uniform in 0..count.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        ((u128::from(self.bits()) * count as u128) >> 64) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn draws_are_uniform_and_streams_differ() {
        let stream = Stream::new(3, Purpose::Single);
        let mean = (0..10_000).map(|i| stream.at(i).unit_f64()).sum::<f64>() / 1e4;
        assert!((mean - 0.5).abs() < 0.01, "{mean}");
        let other = Stream::new(3, Purpose::Dart);
        assert_ne!(stream.at(0).bits(), other.at(0).bits());
        assert_ne!(stream.at(0).bits(), Stream::new(4, Purpose::Single).at(0).bits());
        let mut draws = stream.at(0);
        let mut seen = [0; 3];
        for _ in 0..3000 {
            seen[draws.below(3)] += 1;
        }
        assert!(seen.iter().all(|&n| (850..1150).contains(&n)), "{seen:?}");
    }
}

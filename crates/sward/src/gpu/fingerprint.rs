//! A short number that stands for much data: equal data have equal ones, and data that changed by
//! accident almost surely have others. It guards against mistakes, not against malice.

use rayon::prelude::*;

const PRIME: u64 = 0x9e37_79b9_7f4a_7c15;
const BLOCK: usize = 1 << 20;

/// Folds a number in.
pub fn fold(print: u64, word: u64) -> u64 {
    let mixed = (print.rotate_left(23) ^ word).wrapping_mul(PRIME);
    mixed ^ (mixed >> 29)
}

/// The fingerprint of bytes, on all cores; the same for any number of them.
pub fn of(bytes: &[u8]) -> u64 {
    let blocks: Vec<u64> = bytes.par_chunks(BLOCK).map(block).collect();
    blocks.into_iter().fold(bytes.len() as u64, fold)
}

fn block(bytes: &[u8]) -> u64 {
    let (words, rest) = bytes.as_chunks::<8>();
    let print = words.iter().fold(1, |print, word| fold(print, u64::from_le_bytes(*word)));
    rest.iter().fold(print, |print, byte| fold(print, u64::from(*byte)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_bit_and_the_length_count() {
        let bytes: Vec<u8> = (0..3 * BLOCK + 5).map(|i| (i % 251) as u8).collect();
        let print = of(&bytes);
        assert_eq!(of(&bytes.clone()), print);
        for at in [0, 7, 8, BLOCK - 1, BLOCK, 3 * BLOCK + 4] {
            for bit in [1_u8, 128] {
                let mut changed = bytes.clone();
                changed[at] ^= bit;
                assert_ne!(of(&changed), print, "{at}");
            }
        }
        assert_ne!(of(&bytes[..bytes.len() - 1]), print);
        assert_ne!(of(&[0; 8]), of(&[0; 16]));
        let mut swapped = bytes;
        swapped.swap(3, 12);
        assert_ne!(of(&swapped), print);
    }
}

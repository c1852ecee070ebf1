//! Distance from each point of a grid to the nearest point that is 0, exactly: P. Felzenszwalb and
//! D. Huttenlocher, "Distance Transforms of Sampled Functions", 2012. Squared distances are the
//! lower envelope of parabolas, one axis after the other.

use glam::UVec3;
use rayon::prelude::*;

/// Distances in steps of the grid; far larger than the grid where nothing is 0.
pub(super) fn to_zeros(size: UVec3, values: &[f32]) -> Vec<f32> {
    let far = size.as_vec3().length_squared();
    let mut squared: Vec<f32> =
        values.iter().map(|&value| if value == 0.0 { 0.0 } else { far }).collect();
    let [x, y, z] = size.to_array().map(|side| side as usize);
    for (length, stride) in [(x, 1), (y, x), (z, x * y)] {
        let starts = (0..squared.len()).into_par_iter().filter(|i| i / stride % length == 0);
        let lines: Vec<(usize, Vec<f32>)> = starts
            .map(|start| {
                let line: Vec<f32> = (0..length).map(|i| squared[start + i * stride]).collect();
                (start, envelope(&line))
            })
            .collect();
        for (start, line) in lines {
            for (i, value) in line.into_iter().enumerate() {
                squared[start + i * stride] = value;
            }
        }
    }
    squared.into_iter().map(f32::sqrt).collect()
}

/// For each place the least of `line[i]` plus the squared distance to place `i`.
fn envelope(line: &[f32]) -> Vec<f32> {
    // Parabolas of the envelope, and from where on each is the lowest.
    let mut lowest: Vec<(usize, f32)> = Vec::with_capacity(line.len());
    for (i, &value) in line.iter().enumerate() {
        let meets = |j: usize| {
            let (a, b) = (i as f32, j as f32);
            ((value + a * a) - (line[j] + b * b)) / (2.0 * (a - b))
        };
        while lowest.last().is_some_and(|&(j, from)| meets(j) <= from) {
            lowest.pop();
        }
        let from = lowest.last().map_or(f32::NEG_INFINITY, |&(j, _)| meets(j));
        lowest.push((i, from));
    }
    let mut at = 0;
    (0..line.len())
        .map(|place| {
            while lowest.get(at + 1).is_some_and(|&(_, from)| from < place as f32) {
                at += 1;
            }
            let i = lowest[at].0;
            line[i] + (place as f32 - i as f32).powi(2)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shared::noise_twin::hash01;

    #[test]
    fn equals_brute_force() {
        let size = UVec3::new(9, 6, 7);
        let cells = || (0..7_u32 * 6 * 9).map(|i| UVec3::new(i % 9, i / 9 % 6, i / 54));
        let values: Vec<f32> = (0..7 * 6 * 9).map(|i| f32::from(hash01(i, 5) > 0.03)).collect();
        assert!(values.contains(&0.0));
        let found = to_zeros(size, &values);
        for (cell, found) in cells().zip(found) {
            let zeros = cells().zip(&values).filter(|(_, value)| **value == 0.0);
            let nearest = zeros.map(|(zero, _)| zero.as_vec3().distance(cell.as_vec3()));
            let nearest = nearest.fold(f32::INFINITY, f32::min);
            assert!((found - nearest).abs() < 1e-4, "{cell}: {found}, not {nearest}");
        }
    }

    #[test]
    fn without_a_zero_all_is_far() {
        assert!(to_zeros(UVec3::splat(3), &[1.0; 27]).iter().all(|&d| d >= 5.0));
    }
}

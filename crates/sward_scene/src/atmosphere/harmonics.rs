//! The light of the whole sky in nine numbers a colour.

use glam::Vec3;
use std::f32::consts::PI;

/// Radiance from all directions as spherical harmonics up to order 2, which holds irradiance to a
/// few per cent (Ramamoorthi and Hanrahan 2001). Order 0, then 1 for y, z, x, then 2 for xy, yz,
/// 3z^2 - 1, xz, x^2 - y^2.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SkyHarmonics {
    /// Coefficients, linear RGB.
    pub coefficients: [Vec3; 9],
}

/// The basis in a direction.
fn basis(d: Vec3) -> [f32; 9] {
    let one = (3.0 / (4.0 * PI)).sqrt();
    let two = (15.0 / (4.0 * PI)).sqrt();
    [
        (1.0 / (4.0 * PI)).sqrt(),
        one * d.y,
        one * d.z,
        one * d.x,
        two * d.x * d.y,
        two * d.y * d.z,
        (5.0 / (16.0 * PI)).sqrt() * (3.0 * d.z * d.z - 1.0),
        two * d.x * d.z,
        0.5 * two * (d.x * d.x - d.y * d.y),
    ]
}

impl SkyHarmonics {
    /// Adds radiance from a direction, times the solid angle that it comes from.
    pub fn add(&mut self, direction: Vec3, light: Vec3) {
        for (sum, share) in self.coefficients.iter_mut().zip(basis(direction)) {
            *sum += light * share;
        }
    }

    /// Irradiance of a surface with this unit normal.
    pub fn irradiance(&self, normal: Vec3) -> Vec3 {
        const ORDER: [f32; 9] = {
            let (none, one, two) = (PI, 2.0 * PI / 3.0, PI / 4.0);
            [none, one, one, one, two, two, two, two, two]
        };
        let terms = self.coefficients.iter().zip(basis(normal)).zip(ORDER);
        // Three orders ring: they may fall below 0 on the side without light
        terms.map(|((light, share), order)| *light * (share * order)).sum::<Vec3>().max(Vec3::ZERO)
    }
}

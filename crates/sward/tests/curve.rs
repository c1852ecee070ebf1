//! The blade's curve has the blade's length.

use glam::{DVec3, dvec3};
use sward::shared::curve_twin::{arc_length, middle_point, reach};

#[test]
fn true_arc_length_is_the_height_within_two_percent() {
    let mut worst = 0.0_f64;
    for arch in (0..=50).map(|i| f64::from(i) / 50.0) {
        for lean in (0..=180).map(|i| f64::from(i).to_radians() / 2.0) {
            let (sin, cos) = lean.sin_cos();
            let tip = dvec3(sin, cos, 0.0) * reach(cos, sin, arch);
            let length = arc_length(middle_point(tip, DVec3::Y, arch), tip, 400);
            worst = worst.max((length - 1.0).abs());
        }
    }
    println!("worst error of the true length: {worst:.4}");
    assert!(worst < 0.02, "{worst}");
}

#[test]
fn js_length_rule_holds_exactly_without_arch() {
    for lean in (0..=90).map(|i| f64::from(i).to_radians()) {
        let (sin, cos) = lean.sin_cos();
        let tip = dvec3(sin, cos, 0.0) * reach(cos, sin, 0.0);
        let middle = middle_point(tip, DVec3::Y, 0.0);
        let length = (2.0 * tip.length() + middle.length() + tip.distance(middle)) / 3.0;
        assert!((length - 1.0).abs() < 1e-9, "{lean}: {length}");
    }
}

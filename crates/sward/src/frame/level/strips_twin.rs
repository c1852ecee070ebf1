//! The CPU reference of strips.wgsl: how many rings a strip has.

const STRIP_SPREAD: f32 = 1.0;
const STRIP_MORPH: f32 = 0.7;

/// 0 many rings, 1 few; and how far many have turned into few.
pub(crate) fn strip_level(height_px: f32, few_px: f32, threshold: f32) -> (u32, f32) {
    let change = few_px * ((threshold - 0.5) * STRIP_SPREAD).exp2();
    let octaves = (height_px.max(1e-3) / change).log2().clamp(-30.0, 30.0);
    if octaves < 0.0 {
        return (1, 0.0);
    }
    let t = 1.0 - (octaves / STRIP_MORPH).clamp(0.0, 1.0);
    (0, t * t * (3.0 - 2.0 * t))
}

#[cfg(test)]
mod tests {
    use super::strip_level;

    /// A plant that comes nearer goes from few rings to many that look like few, and then unfolds.
    #[test]
    fn a_strip_changes_without_a_jump() {
        for threshold in [0.0, 0.3, 0.999] {
            let mut last = strip_level(1.0, 70.0, threshold);
            assert_eq!(last, (1, 0.0));
            let mut changes = 0;
            for step in 0..1400 {
                let next = strip_level(1.005_f32.powi(step), 70.0, threshold);
                let as_few = |(level, morph): (u32, f32)| if level == 1 { 1.0 } else { morph };
                assert!((as_few(next) - as_few(last)).abs() < 0.03, "{last:?} {next:?}");
                assert!(as_few(next) <= as_few(last));
                changes += u32::from(next.0 != last.0);
                last = next;
            }
            assert_eq!((changes, last), (1, (0, 0.0)));
        }
    }

    #[test]
    fn plants_change_at_heights_of_their_own() {
        let few = |px| (0..100).filter(|i| strip_level(px, 70.0, *i as f32 / 100.0).0 == 1).count();
        let counts = [few(40.0), few(60.0), few(70.0), few(80.0), few(110.0)];
        assert!(counts.is_sorted_by(|a, b| a > b), "{counts:?}");
        assert_eq!((counts[0], counts[4]), (100, 0));
    }
}

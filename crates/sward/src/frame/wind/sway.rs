//! The sinusoid that all strips sway on, each with a phase of its own (O section 4).

use super::GpuWindSource;
use glam::Vec2;
use std::f64::consts::TAU;

/// Radians a second where the wind has no period: a light blade's own.
const OWN_RATE: f64 = 3.7;

const WAVES: u32 = 0;
const GUSTS: u32 = 1;
const COSINE: u32 = 2;
const TEXTURE: u32 = 6;

/// Wind in the xz plane at the crest, and the phase now, radians. The strongest cosine gives its own;
/// without one the strongest of the winds that blow everywhere gives its strength, and waves their
/// phase too. `GpuFrame::sway`.
pub(crate) fn sway(sources: &[GpuWindSource], time_s: f64) -> [f32; 4] {
    let strength = |source: &GpuWindSource| match source.kind {
        // Waves blow round a mean
        WAVES => source.strength[1].abs(),
        GUSTS | COSINE | TEXTURE => source.strength[0].abs(),
        _ => 0.0,
    };
    let rank = |source: &GpuWindSource| (source.kind == COSINE, strength(source));
    let mut best: Option<&GpuWindSource> = None;
    for source in sources.iter().filter(|source| strength(source) > 0.0) {
        if best.is_none_or(|known| rank(source) > rank(known)) {
            best = Some(source);
        }
    }
    let Some(best) = best else { return [0.0; 4] };
    let wind = Vec2::from(best.direction) * strength(best);
    let phase = match best.kind {
        WAVES | COSINE => best.phase[0],
        _ => (OWN_RATE * time_s).rem_euclid(TAU) as f32,
    };
    [wind.x, wind.y, phase, 0.0]
}

#[cfg(test)]
mod tests {
    use super::sway;
    use crate::{Cosine, Gusts, Waves, Wind, WindSource};
    use glam::Vec2;

    #[test]
    fn a_cosine_leads_and_still_air_does_not_sway() {
        let waves = WindSource::Waves(Waves { amplitude: 2.0, ..Waves::default() });
        let gusts = WindSource::Gusts(Gusts { strength: 1.5, ..Gusts::default() });
        let cosine = WindSource::Cosine(Cosine {
            strength: 0.5,
            direction: Vec2::Y,
            period_s: 2.0,
            ..Cosine::default()
        });
        let of = |sources: &[WindSource], time_s: f64| {
            let mut wind = Wind::new(sources.to_vec()).expect("valid wind");
            wind.advance(time_s);
            sway(&wind.gpu_sources(), time_s)
        };
        assert_eq!(of(&[], 1.0), [0.0; 4]);
        let led = of(&[waves.clone(), cosine, gusts.clone()], 0.5);
        assert_eq!(led[..2], [0.0, 0.5]);
        assert!((led[2] - std::f32::consts::FRAC_PI_2).abs() < 1e-3, "{led:?}");
        let strongest = of(&[gusts.clone(), waves], 0.5);
        assert!((Vec2::new(strongest[0], strongest[1]).length() - 2.0).abs() < 1e-5);
        let (early, late) = (of(std::slice::from_ref(&gusts), 0.1), of(&[gusts], 0.3));
        assert!((late[2] - early[2] - 0.74).abs() < 1e-3, "its own rate: {early:?} {late:?}");
    }
}

//! What are sine and cosine of an `f32`? Reads an angle; writes both, by single-precision arithmetic alone.
//!
//! `libm` takes both in `f64`, which a unit for single precision leaves to software: 2,439 instructions
//! on a Cortex-M4F, and 5.5 KB with the arithmetic. Here it is + − · alone, so every target gets the same bits.

use core::f32::consts::FRAC_2_PI;

/// π/2 in three parts. The first two are multiples of 2⁻¹¹ and 2⁻²⁴: 2¹² times each, and what is left of an
/// angle without them, is exact.
const QUARTER: [f32; 3] = [1.570_800_8, -4.470_348_4e-6, 1.589_325_5e-8];
/// Beyond this there is no answer.
const MOST: f32 = 6400.0;

/// Sine and cosine, each within 1.3·2⁻²⁴, small sines within one unit in their last place; NaN beyond ±6400.
///
/// Half a unit each by the reduction, by the last sum, and by what is rounded before it.
///
/// # Units
/// Radians.
pub fn sin_cos(angle: f32) -> (f32, f32) {
    if !(angle.abs() <= MOST) {
        return (f32::NAN, f32::NAN);
    }
    let half = if angle < 0.0 { -0.5 } else { 0.5 };
    let quarters = (angle * FRAC_2_PI + half) as i32;
    let rest = QUARTER.iter().fold(angle, |rest, part| rest - quarters as f32 * part);
    let (sine, cosine) = within_an_eighth(rest);
    let (sine, cosine) = if quarters & 1 == 0 { (sine, cosine) } else { (cosine, -sine) };
    if quarters & 2 == 0 { (sine, cosine) } else { (-sine, -cosine) }
}

/// For |x| ≤ π/4. The polynomials are minimax fits: 4·10⁻⁹ of the sine, 10⁻¹⁰ of one.
fn within_an_eighth(x: f32) -> (f32, f32) {
    let y = x * x;
    let sine = y * (-0.166_666_55 + y * (0.008_332_174 + y * -1.951_665_6e-4));
    let cosine = y * y * (0.041_666_646 + y * (-0.001_388_736_1 + y * 2.443_773e-5));
    (x + x * sine, 1.0 - (0.5 * y - cosine))
}

#[cfg(test)]
mod tests {
    use super::sin_cos;

    /// The larger error in units of 2⁻²⁴.
    fn error(angle: f32) -> f64 {
        let (sine, cosine) = sin_cos(angle);
        let (s, c) = libm::sincos(angle.into());
        (f64::from(sine) - s).abs().max((f64::from(cosine) - c).abs()) * 16_777_216.0
    }

    #[test]
    fn errors_are_as_stated() {
        let turn = |k: u32| (f64::from(k) / 1e5 - 1.0) * 2.0 * core::f64::consts::PI;
        let worst = (0..200_000).map(|k| error(turn(k) as f32)).fold(0.0, f64::max);
        assert!(worst < 1.3, "{worst}");
        let worst = (0..200_000).map(|k| error(turn(k) as f32 * 1018.0)).fold(0.0, f64::max);
        assert!(worst < 1.3, "{worst}");
    }

    #[test]
    fn small_sines_are_good_to_one_unit_in_their_own_last_place() {
        for k in 0..100_000 {
            let angle = libm::exp(-f64::from(k) * 5e-4) as f32 * 0.785;
            let sine = f64::from(sin_cos(angle).0);
            let exact = libm::sin(angle.into());
            assert!((sine / exact - 1.0).abs() < 1.2e-7, "{angle}");
        }
    }

    #[test]
    fn the_multiples_of_a_right_angle_are_what_they_are() {
        for k in -4000_i32..4000 {
            let angle = (f64::from(k) * core::f64::consts::FRAC_PI_2) as f32;
            assert!(error(angle) < 1.3, "{angle}");
        }
        assert_eq!(sin_cos(0.0), (0.0, 1.0));
        assert!(sin_cos(f32::INFINITY).0.is_nan() && sin_cos(7e3).1.is_nan());
    }
}

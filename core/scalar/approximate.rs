//! What may be rough? Angles and lengths for sensors and displays, by `micromath`; reads and writes `f32`, no event uses it.
//!
//! A firmware turns an angle into gravity, a reading of the accelerometer into an angle, a velocity into
//! the brightness of a lamp. None of that needs the last place, and nothing in here is called between a
//! prediction and its event: the engine's own functions are exact to the last place or nearly so, the same
//! on every target.
//!
//! Largest errors, which the tests of this file find again, and what a call takes on a Cortex-M4F:
//! instructions as QEMU counts them (mean over a turn) and bytes of linked code, at `opt-level = "s"`.
//!
//! | function | largest error | instructions, bytes | by `libm` |
//! |---|---|---|---|
//! | [`sin_cos`] | 1.1e-3; 1.2e-3 beyond ±2π | 51, 200 | 2,439, 5,500 (`f64` in software) |
//! | [`atan2`] | 2.9e-3 rad | 44, 164 | 84, 248 |
//! | [`length`] in 2D | up to 6.1 % too long, never too short | 46, 116 | 82, 492 |
//!
//! An image that runs [`crate::law::Soft`] in `f32` carries the engine's sine, cosine and root anyway: there
//! `micromath` saves no flash.

use micromath::F32Ext;

/// Sine and cosine of an angle.
///
/// # Units
/// The angle in radians, within ±1000.
///
/// ```
/// let (sine, cosine) = carom::scalar::approximate::sin_cos(0.5);
/// assert!((sine - 0.479).abs() < 2e-3 && (cosine - 0.878).abs() < 2e-3);
/// ```
#[must_use]
pub fn sin_cos(angle: f32) -> (f32, f32) {
    F32Ext::sin_cos(angle)
}

/// The angle of the direction (x, y), from −π to π; 0 where there is none.
///
/// # Units
/// Radians.
#[must_use]
pub fn atan2(y: f32, x: f32) -> f32 {
    if x == 0.0 && y == 0.0 { 0.0 } else { F32Ext::atan2(y, x) }
}

/// The length of a vector; its square must not overflow.
///
/// # Units
/// Those of its components.
#[must_use]
pub fn length<const D: usize>(vector: [f32; D]) -> f32 {
    F32Ext::sqrt(vector.iter().map(|x| x * x).sum::<f32>())
}

/// Gravity in a box that was turned by an angle, clockwise: what [`crate::World::set_gravity`] is told.
///
/// # Units
/// The angle in radians, the strength in units of acceleration.
///
/// ```
/// let [right, up] = carom::scalar::approximate::tilted(0.0, 9.81);
/// assert!(right.abs() < 0.02 && (up + 9.81).abs() < 0.02);
/// ```
#[must_use]
pub fn tilted(angle: f32, strength: f32) -> [f32; 2] {
    let (sine, cosine) = sin_cos(angle);
    [strength * sine, -strength * cosine]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const SIN_COS: f64 = 1.1e-3;
    const ATAN2: f64 = 2.9e-3;
    const LENGTH: f64 = 6.1e-2;

    fn sin_cos_error(angle: f32) -> f64 {
        let (sine, cosine) = sin_cos(angle);
        let (s, c) = libm::sincos(angle.into());
        (f64::from(sine) - s).abs().max((f64::from(cosine) - c).abs())
    }

    fn atan2_error(y: f32, x: f32) -> f64 {
        let off = (f64::from(atan2(y, x)) - libm::atan2(y.into(), x.into())).abs();
        off.min(2.0 * core::f64::consts::PI - off)
    }

    fn length_error<const D: usize>(vector: [f32; D]) -> f64 {
        let exact = libm::sqrt(vector.iter().map(|&x| f64::from(x) * f64::from(x)).sum::<f64>());
        (f64::from(length(vector)) / exact - 1.0).abs()
    }

    /// The table in the documentation: a dense sweep finds the errors it states, neither more nor much less.
    #[test]
    fn the_stated_errors_are_the_largest() {
        let turn = |k: u32| (f64::from(k) / 100_000.0 * 4.0 * core::f64::consts::PI) as f32;
        let (mut angle, mut direction, mut size) = (0.0_f64, 0.0_f64, 0.0_f64);
        for k in 0..100_000 {
            angle = angle.max(sin_cos_error(turn(k) - turn(50_000)));
            let (sine, cosine) = libm::sincosf(turn(k));
            direction = direction.max(atan2_error(sine, cosine));
            size = size.max(length_error([1.0 + 3.0 * k as f32 / 100_000.0, 0.0]));
        }
        for (found, stated) in [(angle, SIN_COS), (direction, ATAN2), (size, LENGTH)] {
            assert!(found <= stated && found > 0.9 * stated, "{found:e}, stated as {stated:e}");
        }
    }

    proptest! {
        #[test]
        fn no_error_is_larger(angle in -1000.0_f32..1000.0, [x, y, z] in [-1e6_f32..1e6, -1e3_f32..1e3, -1.0_f32..1.0]) {
            prop_assert!(sin_cos_error(angle) <= SIN_COS + 1e-4, "{}", angle);
            prop_assert!(atan2_error(y, x) <= ATAN2 && atan2_error(z, y) <= ATAN2);
            prop_assert!(length_error([x, y, z]) <= LENGTH && length_error([y, z]) <= LENGTH);
        }
    }
}

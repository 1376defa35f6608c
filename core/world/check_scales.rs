//! Do the sizes and speeds of a world fit its number type? Reads bodies, boundaries and gravity; writes nothing.
//!
//! When two grains touch depends on squares of r·v. Where those leave the range, meetings would be wrong or lost
//! without a word; so such worlds are refused at the start.

use crate::error::{Error, Subject};
use crate::particle::Body;
use crate::scalar::{Scalar, Vector, max_abs};
use crate::space::Boundary;

const LENGTH: &str =
    "a length whose square the number type holds to its last place: choose another unit of length";
const SPEED: &str = "a speed whose square, and whose square times that of every length, the number type holds to its last place: \
     choose other units";
const GRAVITY: &str =
    "so weak that its product with every length is the square of a speed that fits";

/// Every length, the largest speed, and products of both must have squares. Fixed point has limits of its own.
pub(super) fn scales<S: Scalar, const D: usize>(
    boundary: &Boundary<S, D>,
    gravity: &Vector<S, D>,
    bodies: &[Body<S, D>],
) -> Result<(), Error> {
    let [mut near, mut far] = [S::NEVER, S::zero()];
    for (_, periodic) in boundary.periodic_axes() {
        far = far.max(periodic.length).max(periodic.low.abs());
    }
    far = boundary.planes().iter().fold(far, |far, plane| far.max(plane.offset.abs()));
    for (i, body) in bodies.iter().enumerate() {
        let place = max_abs(&body.position);
        refuse(Subject::Grain(i), "radius", body.radius, body.radius.has_square(), LENGTH)?;
        let fits = place <= body.radius || place.has_square();
        refuse(Subject::Grain(i), "position", place, fits, LENGTH)?;
        (near, far) = (near.min(body.radius), far.max(body.radius).max(place));
    }
    self::gravity(gravity, far)?;
    let fastest = bodies.iter().enumerate().map(|(i, body)| (i, max_abs(&body.velocity)));
    let fastest = fastest.fold((0, S::zero()), |a, b| if b.1 > a.1 { b } else { a });
    if fastest.1 > S::zero() {
        let falls = max_abs(gravity) > S::zero();
        let is_fast_enough = falls || (fastest.1.has_square() && (fastest.1 * near).has_square());
        let is_slow_enough = fastest.1 < S::one() || fastest.1.has_square();
        let product = fastest.1 * far;
        let fits = is_fast_enough && is_slow_enough && (product < S::one() || product.has_square());
        refuse(Subject::Grain(fastest.0), "velocity", fastest.1, fits, SPEED)?;
    }
    Ok(())
}

/// Gravity times the farthest length is the square of a speed.
pub(super) fn gravity<S: Scalar, const D: usize>(g: &Vector<S, D>, far: S) -> Result<(), Error> {
    let most = max_abs(g);
    let fits = [most, most * far, most * far * far].iter().all(|&x| x < S::one() || x.has_square());
    refuse(Subject::World, "gravity", most, fits, GRAVITY)
}

fn refuse<S: Scalar>(
    subject: Subject,
    field: &'static str,
    value: S,
    fits: bool,
    wanted: &'static str,
) -> Result<(), Error> {
    if fits || S::RANGE.is_some() {
        return Ok(());
    }
    Err(Error::input(subject, field, value.to_f64(), wanted))
}

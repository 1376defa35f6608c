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

/// Of bodies with numbers from this one on: every length, the largest speed, and products of both must have squares. Fixed point has limits of its own.
///
/// Not inlined: its stack is free again before the world is put together.
#[inline(never)]
pub(super) fn scales<S: Scalar, const D: usize>(
    boundary: &Boundary<S, D>,
    gravity: &Vector<S, D>,
    (number, bodies): (usize, &[Body<S, D>]),
) -> Result<(), Error> {
    if S::RANGE.is_some() {
        return Ok(());
    }
    let [mut near, mut far, mut fastest] = [S::NEVER, S::zero(), S::zero()];
    for (_, periodic) in boundary.periodic_axes() {
        far = far.max(periodic.length).max(periodic.low.abs());
    }
    for plane in boundary.planes() {
        far = far.max(plane.offset.abs());
    }
    far = boundary.obstacles().map_or(far, |obstacles| far.max(obstacles.far()));
    for (i, body) in (number..).zip(bodies).filter(|(_, body)| !body.is_vacant()) {
        let place = max_abs(&body.position);
        refuse(Subject::Grain(i), "radius", body.radius, has_square(body.radius), LENGTH)?;
        let fits = place <= body.radius || has_square(place);
        refuse(Subject::Grain(i), "position", place, fits, LENGTH)?;
        near = near.min(body.radius);
        far = far.max(body.radius).max(place);
        fastest = fastest.max(max_abs(&body.velocity));
    }
    self::gravity(gravity, far)?;
    let falls = max_abs(gravity) > S::zero();
    let is_fast_enough = falls || (has_square(fastest) && has_square(fastest * near));
    if fastest <= S::zero()
        || (is_fast_enough && is_in_range(fastest) && is_in_range(fastest * far))
    {
        return Ok(());
    }
    let grain = bodies.iter().position(|body| max_abs(&body.velocity) == fastest);
    refuse(Subject::Grain(number + grain.unwrap_or(0)), "velocity", fastest, false, SPEED)
}

/// Called, not inlined: the start of a world is not to take flash.
#[inline(never)]
fn has_square<S: Scalar>(x: S) -> bool {
    x.has_square()
}

/// Whether the square does not leave the range above.
fn is_in_range<S: Scalar>(x: S) -> bool {
    x < S::one() || has_square(x)
}

/// Gravity times the farthest length is the square of a speed.
#[inline(never)]
pub(super) fn gravity<S: Scalar, const D: usize>(g: &Vector<S, D>, far: S) -> Result<(), Error> {
    let most = max_abs(g);
    let fits = is_in_range(most) && is_in_range(most * far) && is_in_range(most * far * far);
    refuse(Subject::World, "gravity", most, fits, GRAVITY)
}

#[inline(never)]
fn refuse<S: Scalar>(
    subject: Subject,
    field: &'static str,
    value: S,
    fits: bool,
    wanted: &'static str,
) -> Result<(), Error> {
    if fits {
        return Ok(());
    }
    Err(Error::input(subject, field, value.to_f64(), wanted))
}

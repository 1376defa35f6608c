//! Where is a body that moves, at one instant? Turns positions and directions into its own frame and back; reads numbers, writes nothing.

use crate::scalar::{Axial, Scalar, Vector, component, dot, swept, unit};

/// A rigid body as it is at one instant: shifted from where it was described, or turned about a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pose<S: Scalar, const D: usize> {
    /// How far it is shifted, or the point about which it is turned.
    origin: Vector<S, D>,
    /// The velocity of all its points, if it is shifted.
    velocity: Vector<S, D>,
    turned: Option<Turned<S>>,
}

/// Turned by an angle about an axis.
#[derive(Clone, Copy, Debug)]
struct Turned<S: Scalar> {
    axis: Axial<S>,
    sin: S,
    cos: S,
    angular_velocity: Axial<S>,
}

impl<S: Scalar, const D: usize> Pose<S, D> {
    /// Shifted so far, and moving so.
    pub fn shifted(shift: Vector<S, D>, velocity: Vector<S, D>) -> Self {
        Self { origin: shift, velocity, turned: None }
    }

    /// Turned about a centre.
    pub fn turned(
        centre: Vector<S, D>,
        angular_velocity: Axial<S>,
        (axis, (sin, cos)): (Axial<S>, (S, S)),
    ) -> Self {
        let turned = Some(Turned { axis, sin, cos, angular_velocity });
        Self { origin: centre, velocity: Vector::zeros(), turned }
    }

    /// Where a position is in the body's own frame, in which its corners were described.
    pub fn inside(&self, position: &Vector<S, D>) -> Vector<S, D> {
        let from = position - self.origin;
        match &self.turned {
            None => from,
            Some(turned) => self.origin + turned.back(&from),
        }
    }

    /// The same of the velocity of something that is at this position.
    pub fn velocity_inside(
        &self,
        position: &Vector<S, D>,
        velocity: &Vector<S, D>,
    ) -> Vector<S, D> {
        let relative = velocity - self.velocity_at(position);
        self.turned.as_ref().map_or(relative, |turned| turned.back(&relative))
    }

    /// A position in the body's own frame, where it is.
    pub fn outside(&self, position: &Vector<S, D>) -> Vector<S, D> {
        match &self.turned {
            None => position + self.origin,
            Some(turned) => self.origin + turned.on(&(position - self.origin)),
        }
    }

    /// A unit vector in the body's own frame, as it is turned.
    pub fn direction(&self, direction: &Vector<S, D>) -> Vector<S, D> {
        self.turned.as_ref().map_or(*direction, |turned| unit(&turned.on(direction)))
    }

    /// A vector in the body's own frame, as it is turned.
    pub fn vector(&self, vector: &Vector<S, D>) -> Vector<S, D> {
        self.turned.as_ref().map_or(*vector, |turned| turned.on(vector))
    }

    /// The velocity of the body's point that is at this position now.
    pub fn velocity_at(&self, position: &Vector<S, D>) -> Vector<S, D> {
        match &self.turned {
            None => self.velocity,
            Some(turned) => swept(&turned.angular_velocity, &(position - self.origin)),
        }
    }
}

impl<S: Scalar> Turned<S> {
    fn on<const D: usize>(&self, r: &Vector<S, D>) -> Vector<S, D> {
        self.by(r, self.sin)
    }

    fn back<const D: usize>(&self, r: &Vector<S, D>) -> Vector<S, D> {
        self.by(r, -self.sin)
    }

    /// Rodrigues' rotation: r cos θ + a × r sin θ + a (a · r)(1 − cos θ).
    fn by<const D: usize>(&self, r: &Vector<S, D>, sin: S) -> Vector<S, D> {
        let across = r * self.cos + swept(&self.axis, r) * sin;
        if D < 3 {
            return across;
        }
        let axis = Vector::<S, D>::from_fn(|k, _| component(&self.axis, k));
        across + axis * (dot(&axis, r) * (S::one() - self.cos))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inside_and_outside_are_each_other_s_inverse() {
        let axis = unit(&Axial::new(1.0, -2.0, 0.5));
        let centre = Vector::from([0.3, 0.1, -0.7]);
        let pose = Pose::turned(centre, axis * 2.0, (axis, libm::sincos(0.8)));
        let x = Vector::from([1.0, 2.0, 3.0]);
        let there = pose.inside(&x);
        assert!((pose.outside(&there) - x).norm() < 1e-15);
        assert!(((there - centre).norm() - (x - centre).norm()).abs() < 1e-15);
        // What turns with the body stands still in its frame.
        let still = pose.velocity_inside(&x, &pose.velocity_at(&x));
        assert!(still.norm() < 1e-15);
    }

    #[test]
    fn a_quarter_turn_in_the_plane_is_anticlockwise() {
        let up = Axial::new(0.0, 0.0, 1.0);
        let pose = Pose::turned(Vector::from([0.0, 0.0]), up, (up, (1.0, 0.0)));
        assert_eq!(pose.outside(&Vector::from([1.0, 0.0])), Vector::from([0.0, 1.0]));
        assert_eq!(pose.velocity_at(&Vector::from([0.0, 1.0])), Vector::from([-1.0, 0.0]));
    }
}

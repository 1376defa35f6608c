//! How do grains rotate? Angular velocities in memory that is lent apart from the bodies; reads and writes it.
//!
//! Smooth grains have none of it.

use crate::scalar::{Axial, Scalar, axes};

/// What a world of rough grains borrows beside [`Buffers`](crate::world::Buffers)' other slices: D (D − 1)/2 numbers
/// for each grain in each. Empty, the default, where grains are smooth.
#[derive(Debug)]
pub struct RotationBuffers<'m, S> {
    /// Angular velocities: those at the start, and from then on those of the world.
    pub velocities: &'m mut [S],
    /// Angular accelerations in the last step, where contacts last or crowd.
    pub accelerations: &'m mut [S],
    /// What adds up to them in a step.
    pub sums: &'m mut [S],
}

impl<S> Default for RotationBuffers<'_, S> {
    fn default() -> Self {
        Self { velocities: &mut [], accelerations: &mut [], sums: &mut [] }
    }
}

impl<'m, S: Scalar> RotationBuffers<'m, S> {
    /// For how many grains there is room.
    pub(crate) fn capacity<const D: usize>(&self) -> usize {
        let shortest = self.accelerations.len().min(self.sums.len()).min(self.velocities.len());
        shortest.checked_div(axes::<D>()).unwrap_or(0)
    }

    /// The same memory, lent for a while.
    pub(crate) fn lent(&mut self) -> RotationBuffers<'_, S> {
        RotationBuffers {
            velocities: self.velocities,
            accelerations: self.accelerations,
            sums: self.sums,
        }
    }

    /// The places of so many grains.
    pub(crate) fn of<const D: usize>(self, grains: usize) -> Self {
        let count = grains * axes::<D>();
        let cut = |slice: &'m mut [S]| slice.get_mut(..count).unwrap_or_default();
        Self {
            velocities: cut(self.velocities),
            accelerations: cut(self.accelerations),
            sums: cut(self.sums),
        }
    }

    /// ω of a grain; zero where there is none.
    pub(crate) fn velocity<const D: usize>(&self, grain: usize) -> Axial<S> {
        read::<S, D>(self.velocities, grain)
    }

    /// The first half of a step: ω goes on with the last acceleration, and nothing has turned the grain yet.
    pub(crate) fn go_to_middle<const D: usize>(&mut self, grain: usize, half: S) {
        let last = read::<S, D>(self.accelerations, grain);
        let middle = self.velocity::<D>(grain) + last * half;
        self.set_velocity::<D>(grain, &middle);
        write::<S, D>(self.sums, grain, &Axial::zeros());
    }

    /// Something turns a grain.
    pub(crate) fn accelerate<const D: usize>(&mut self, grain: usize, by: &Axial<S>) {
        let sum = read::<S, D>(self.sums, grain) + by;
        write::<S, D>(self.sums, grain, &sum);
    }

    /// The second half; returns ω.
    pub(crate) fn go_to_end<const D: usize>(&mut self, grain: usize, step: S) -> Axial<S> {
        let [last, now] = [&*self.accelerations, &*self.sums].map(|row| read::<S, D>(row, grain));
        let end = self.velocity::<D>(grain) - last * (step * S::half()) + now * step;
        self.set_velocity::<D>(grain, &end);
        write::<S, D>(self.accelerations, grain, &now);
        end
    }

    /// Nothing has turned a grain lately.
    pub(crate) fn set_free<const D: usize>(&mut self, grain: usize) {
        write::<S, D>(self.accelerations, grain, &Axial::zeros());
    }

    /// Gives a grain another ω.
    pub(crate) fn set_velocity<const D: usize>(&mut self, grain: usize, w: &Axial<S>) {
        write::<S, D>(self.velocities, grain, w);
    }
}

/// What a slice says of a grain.
fn read<S: Scalar, const D: usize>(slice: &[S], grain: usize) -> Axial<S> {
    let first = grain * axes::<D>();
    let at = |k: usize| slice.get(first + k).copied().unwrap_or(S::zero());
    match D {
        2 => Axial::new(S::zero(), S::zero(), at(0)),
        3 => Axial::new(at(0), at(1), at(2)),
        _ => Axial::zeros(),
    }
}

/// Says it of a grain.
fn write<S: Scalar, const D: usize>(slice: &mut [S], grain: usize, w: &Axial<S>) {
    let count = axes::<D>();
    let Some(places) = slice.get_mut(grain * count..(grain + 1) * count) else { return };
    // In the plane it is the last one.
    let from = w.iter().skip(3_usize.saturating_sub(count));
    places.iter_mut().zip(from).for_each(|(place, &x)| *place = x);
}

//! How does a plane move without the feature `plates`? Not at all: what would say how has no value and takes no memory.

use super::plane_motion::PlaneMotion;
use crate::scalar::{Instant, Scalar};
use core::marker::PhantomData;

/// What has this in it has no value, and nothing is compiled for it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
enum Never {}

/// A plate's sinusoidal motion along its normal. There are such planes with the feature `plates`, which is on by default;
/// without it a program has no code and no memory for them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Vibration<S> {
    never: Never,
    of: PhantomData<S>,
}

/// A plane's steady motion along its normal. There are such planes with the feature `plates`, which is on by default.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Drift<S> {
    never: Never,
    of: PhantomData<S>,
}

impl<S: Scalar> Drift<S> {
    pub(crate) fn rate(&self) -> S {
        match self.never {}
    }

    pub(crate) fn at(&self, _: S) -> PlaneMotion<S> {
        match self.never {}
    }

    pub(super) fn set_epoch(&mut self, _: Instant) {
        match self.never {}
    }
}

impl<S: Scalar> Vibration<S> {
    pub(crate) fn parameters(&self) -> [S; 3] {
        match self.never {}
    }

    pub(crate) fn swing(&self) -> S {
        match self.never {}
    }

    /// ω = 2π f.
    #[must_use]
    pub fn angular_frequency(&self) -> S {
        match self.never {}
    }

    /// |A₀| ω.
    #[must_use]
    pub fn peak_speed(&self) -> S {
        match self.never {}
    }

    /// |A₀| ω².
    #[must_use]
    pub fn peak_acceleration(&self) -> S {
        match self.never {}
    }

    pub(crate) fn phase_at(&self, _: S) -> (S, S) {
        match self.never {}
    }

    pub(crate) fn at(&self, _: S) -> PlaneMotion<S> {
        match self.never {}
    }

    pub(super) fn set_epoch(&mut self, _: Instant) {
        match self.never {}
    }
}

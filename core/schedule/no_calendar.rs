//! Who is next without the feature `alloc`? Always the tree knows: small machines carry no calendar; reads and writes nothing.

use crate::detect::ScheduledEvent;
use crate::scalar::Scalar;
use core::marker::PhantomData;

/// A calendar that is never open.
pub(super) struct Calendar<'m>(PhantomData<&'m ()>);

/// What it never finds.
#[derive(Clone, Copy)]
pub(super) struct Earliest {
    pub grain: u32,
    pub ties: u32,
}

impl<'m> Calendar<'m> {
    pub fn new(_: &'m mut [[u32; 2]], _: usize) -> Self {
        Self(PhantomData)
    }

    #[inline(always)]
    pub fn is_open(&self) -> bool {
        false
    }

    pub fn ties(&self) -> u32 {
        0
    }

    pub fn close(&mut self) {}

    pub fn open<S: Scalar>(&mut self, _: &[ScheduledEvent<S>]) {}

    pub fn has_served(&self) -> bool {
        false
    }

    #[inline(always)]
    pub fn has_rested(&mut self) -> bool {
        false
    }

    pub fn set<S: Scalar>(&mut self, _: usize, _: S) {}

    pub fn earliest<S: Scalar>(&self, _: &[ScheduledEvent<S>]) -> Option<Earliest> {
        None
    }

    pub fn go_to(&mut self, _: &Earliest) -> bool {
        false
    }

    pub fn due_at<S: Scalar>(&self, _: &[ScheduledEvent<S>], _: S, _: impl FnMut(u32)) {}
}

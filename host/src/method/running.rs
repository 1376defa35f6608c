//! Who owns what a method works with? Keeps a method beside the memory and the rules that it borrows; reads and writes nothing itself.

use super::interface::Method;
use crate::any_rule::AnyRule;
use anyhow::{Context, Result};
use self_cell::{MutBorrow, self_cell};
use std::any::Any;
use std::fmt;

/// A method that borrows.
pub(super) type Borrower<'a> = Box<dyn Method + Send + 'a>;

/// What it borrows: memory for a world of some dimension, and rules.
struct Ground {
    memory: MutBorrow<Box<dyn Any + Send>>,
    rules: Vec<AnyRule<'static>>,
}

self_cell!(
    struct Pair {
        owner: Ground,
        #[not_covariant]
        dependent: Borrower,
    }
);

/// A running method that owns all it needs: it can be kept, and go from thread to thread.
///
/// [`begin`](super::begin) makes one.
pub struct Running(Pair);

impl Running {
    /// A method that borrows nothing.
    pub(super) fn alone(method: impl Method + Send + 'static) -> Self {
        let ground = Ground { memory: MutBorrow::new(Box::new(())), rules: Vec::new() };
        Self(Pair::new(ground, |_| Box::new(method)))
    }

    /// A method that borrows this memory and these rules.
    ///
    /// # Errors
    /// Those of `begin`.
    pub(super) fn on<M: Send + 'static>(
        memory: M,
        rules: Vec<AnyRule<'static>>,
        begin: impl for<'a> FnOnce(&'a mut M, &'a [AnyRule<'static>]) -> Result<Borrower<'a>>,
    ) -> Result<Self> {
        let ground = Ground { memory: MutBorrow::new(Box::new(memory)), rules };
        let pair = Pair::try_new(ground, |ground| {
            let memory = ground.memory.borrow_mut().downcast_mut::<M>();
            begin(memory.context("memory is of another kind")?, &ground.rules)
        });
        pair.map(Self)
    }

    /// Works with the method.
    pub fn with<T>(&mut self, work: impl FnOnce(&mut dyn Method) -> T) -> T {
        self.0.with_dependent_mut(|_, method| work(&mut **method))
    }
}

impl fmt::Debug for Running {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Running")
    }
}

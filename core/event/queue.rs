//! Who is next? One pending event per grain in a tournament tree; reads and writes slots and tree.
//!
//! Every grain has one slot: its own earliest event. The tree's root names the earliest of all, so
//! the capacity is exactly the number of grains and nothing can overflow. Equal times are decided
//! by the grain's number, so ties break the same way on every target.

use crate::matter::Partner;
use crate::number::Scalar;

/// What a grain's next event is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Kind {
    /// It meets its partner: a grain or a plane (E^φ of MP13, or an instantaneous collision).
    Meet,
    /// Its contact ends (E^v of MP13).
    Release,
    /// The plate that carries it falls away faster than it falls.
    TakeOff,
    /// What holds it may have gone.
    Check,
    /// It leaves its cell, or has flown so far that its neighbours must be looked at again.
    Wander,
    /// Nothing will happen to it.
    Nothing,
}

/// A grain's earliest event.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Slot<S: Scalar> {
    pub(crate) time: S,
    pub(crate) kind: Kind,
    pub(crate) partner: Partner,
    /// The partner's stamp when this was predicted.
    pub(crate) stamp: u32,
}

impl<S: Scalar> Slot<S> {
    /// Nothing, ever.
    pub(crate) const EMPTY: Self =
        Self { time: S::NEVER, kind: Kind::Nothing, partner: Partner::NOTHING, stamp: 0 };

    /// An event without a partner.
    pub(crate) fn alone(time: S, kind: Kind) -> Self {
        Self { time, kind, ..Self::EMPTY }
    }
}

impl<S: Scalar> Default for Slot<S> {
    fn default() -> Self {
        Self::EMPTY
    }
}

/// The tree over the slots of all grains. Node n has the children 2n and 2n + 1; leaf i is node N + i.
pub(crate) struct Queue<'m, S: Scalar> {
    pub(crate) slots: &'m mut [Slot<S>],
    tree: &'m mut [u32],
}

impl<'m, S: Scalar> Queue<'m, S> {
    /// A queue for as many grains as there are slots; the tree has the same length.
    pub(crate) fn new(slots: &'m mut [Slot<S>], tree: &'m mut [u32]) -> Self {
        let mut queue = Self { slots, tree };
        queue.rebuild();
        queue
    }

    /// The grain whose event is the earliest, if there are grains.
    pub(crate) fn first(&self) -> Option<usize> {
        match self.slots.len() {
            0 => None,
            1 => Some(0),
            _ => self.tree.get(1).map(|&w| w as usize),
        }
    }

    /// The slot of a grain.
    pub(crate) fn slot(&self, grain: usize) -> Slot<S> {
        self.slots.get(grain).copied().unwrap_or(Slot::EMPTY)
    }

    /// Puts a grain's event in its place.
    pub(crate) fn set(&mut self, grain: usize, slot: Slot<S>) {
        if let Some(place) = self.slots.get_mut(grain) {
            *place = slot;
            self.replay(grain);
        }
    }

    /// Visits the grains whose events are at this time, the earliest of all, until a visit says it is enough.
    pub(crate) fn tied(&self, time: S, visit: &mut impl FnMut(usize) -> bool) {
        match self.slots.len() {
            0 => {}
            1 => {
                visit(0);
            }
            _ => {
                self.tied_below(1, time, visit);
            }
        }
    }

    /// As deep as the tree is high: at most 32.
    fn tied_below(&self, node: usize, time: S, visit: &mut impl FnMut(usize) -> bool) -> bool {
        let winner = self.winner(node);
        if !(self.slot(winner).time <= time) {
            return true;
        }
        if node >= self.slots.len() {
            return visit(winner);
        }
        self.tied_below(2 * node, time, visit) && self.tied_below(2 * node + 1, time, visit)
    }

    /// Plays every match again.
    pub(crate) fn rebuild(&mut self) {
        for node in (1..self.slots.len()).rev() {
            self.play(node);
        }
    }

    /// Plays the matches on one leaf's way up again.
    fn replay(&mut self, grain: usize) {
        let mut node = (self.slots.len() + grain) / 2;
        while node >= 1 {
            self.play(node);
            node /= 2;
        }
    }

    #[expect(clippy::cast_possible_truncation, reason = "setup refuses more than MOST_GRAINS")]
    fn play(&mut self, node: usize) {
        let (left, right) = (self.winner(2 * node), self.winner(2 * node + 1));
        let winner = if self.before(right, left) { right } else { left };
        if let Some(n) = self.tree.get_mut(node) {
            *n = winner as u32;
        }
    }

    fn winner(&self, node: usize) -> usize {
        let leaves = self.slots.len();
        if node >= leaves { node - leaves } else { self.tree.get(node).map_or(0, |&w| w as usize) }
    }

    /// Earlier, or as early with a lower number.
    fn before(&self, a: usize, b: usize) -> bool {
        let (ta, tb) = (self.slot(a).time, self.slot(b).time);
        ta < tb || (ta == tb && a < b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn firsts(times: &[f64]) -> std::vec::Vec<usize> {
        let mut slots = [Slot::EMPTY; 9];
        let mut tree = [0_u32; 9];
        let n = times.len();
        let mut queue = Queue::new(&mut slots[..n], &mut tree[..n]);
        for (i, &t) in times.iter().enumerate() {
            queue.set(i, Slot::alone(t, Kind::Wander));
        }
        let mut order = std::vec::Vec::new();
        for _ in 0..n {
            let i = queue.first().unwrap();
            order.push(i);
            queue.set(i, Slot::EMPTY);
        }
        order
    }

    #[test]
    fn events_come_in_order_of_time_then_number_for_every_size() {
        assert_eq!(firsts(&[2.0]), [0]);
        assert_eq!(firsts(&[2.0, 1.0]), [1, 0]);
        assert_eq!(firsts(&[3.0, 1.0, 2.0]), [1, 2, 0]);
        assert_eq!(
            firsts(&[5.0, 1.0, 5.0, 0.5, 5.0, 1.0, 7.0, 0.0, 2.0]),
            [7, 3, 1, 5, 8, 0, 2, 4, 6]
        );
    }
}

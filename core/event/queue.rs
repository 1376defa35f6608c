//! Who is next? One pending event per grain in a tournament tree; reads and writes slots and tree.
//!
//! Every grain has one slot: its own earliest event. The tree's root names the earliest of all, so
//! the capacity is exactly the number of grains and nothing can overflow. Equal times are decided
//! by the grain's number, so ties break the same way on every target.

use crate::matter::Partner;
#[cfg(doc)]
use crate::matter::grid::Stride;
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

/// A grain's earliest event, and its earliest meeting.
///
/// A grain that comes into another cell keeps its meeting: only what is ahead must be looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Slot<S: Scalar> {
    pub(crate) time: S,
    /// When it meets its partner.
    pub(crate) meeting: S,
    pub(crate) partner: Partner,
    /// The partner's stamp when this was predicted.
    pub(crate) stamp: u32,
    pub(crate) kind: Kind,
    /// Through which face of its cell it leaves, see [`Stride::code`]; [`Slot::NO_FACE`] for none.
    pub(crate) face: u8,
}

impl<S: Scalar> Slot<S> {
    /// A look around that crosses no face.
    pub(crate) const NO_FACE: u8 = u8::MAX;

    /// Nothing, ever.
    pub(crate) const EMPTY: Self = Self {
        time: S::NEVER,
        meeting: S::NEVER,
        partner: Partner::NOTHING,
        stamp: 0,
        kind: Kind::Nothing,
        face: Self::NO_FACE,
    };

    /// An event without a partner.
    pub(crate) fn alone(time: S, kind: Kind) -> Self {
        Self { time, kind, ..Self::EMPTY }
    }

    /// What the event is about: nothing but itself, unless it is a meeting.
    pub(crate) fn with(&self) -> Partner {
        if self.kind == Kind::Meet { self.partner } else { Partner::NOTHING }
    }

    /// Only the meeting; without a partner that is a search which paused there and must go on.
    pub(crate) fn only_meeting(self) -> Self {
        let kind = match self.partner {
            Partner::NOTHING if self.meeting < S::NEVER => Kind::Wander,
            Partner::NOTHING => Kind::Nothing,
            _ => Kind::Meet,
        };
        Self { time: self.meeting, kind, face: Self::NO_FACE, ..self }
    }
}

impl<S: Scalar> Default for Slot<S> {
    fn default() -> Self {
        Self::EMPTY
    }
}

/// The tree over the slots of all grains. Node n has the children 2n and 2n + 1; leaf i is node N + i.
///
/// A node's word is the winner's number and, in the two highest bits, how many leaves below it are as
/// early as the winner: 0 for one, 1 for two, 2 for more.
pub(crate) struct Queue<'m, S: Scalar> {
    pub(crate) slots: &'m mut [Slot<S>],
    tree: &'m mut [u32],
}

/// The bits of a winner's number.
const WINNER: u32 = (1 << 30) - 1;

impl<'m, S: Scalar> Queue<'m, S> {
    /// The most grains that a word of the tree can number.
    pub(crate) const MOST: usize = WINNER as usize;

    /// A queue for as many grains as there are slots; the tree has the same length.
    pub(crate) fn new(slots: &'m mut [Slot<S>], tree: &'m mut [u32]) -> Self {
        let mut queue = Self { slots, tree };
        queue.rebuild();
        queue
    }

    /// The grain whose event is the earliest, if there are grains.
    pub(crate) fn first(&self) -> Option<usize> {
        (!self.slots.is_empty()).then(|| self.winner(self.word(1)))
    }

    /// How many events are as early as the first, the first included; 3 stands for any more.
    pub(crate) fn at_once(&self) -> u32 {
        (self.word(1) >> 30) + 1
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
        if !self.slots.is_empty() {
            self.tied_below(1, time, visit);
        }
    }

    /// As deep as the tree is high: at most 30.
    fn tied_below(&self, node: usize, time: S, visit: &mut impl FnMut(usize) -> bool) -> bool {
        let winner = self.winner(self.word(node));
        if !(self.time(winner) <= time) {
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
            let [left, right] = [2 * node, 2 * node + 1].map(|child| {
                let word = self.word(child);
                (word, self.time(self.winner(word)))
            });
            self.keep(node, play(left, right).0);
        }
    }

    /// Plays the matches on one leaf's way up again, as far as they can end otherwise than before.
    fn replay(&mut self, grain: usize) {
        let mut node = self.slots.len() + grain;
        let mut mine = (self.word(node), self.time(grain));
        while node > 1 {
            let word = self.word(node ^ 1);
            let other = (word, self.time(self.winner(word)));
            node /= 2;
            mine = play(mine, other);
            let Some(place) = self.tree.get_mut(node) else { return };
            if mine.0 == *place && (mine.0 & WINNER) as usize != grain {
                return;
            }
            *place = mine.0;
        }
    }

    fn keep(&mut self, node: usize, word: u32) {
        if let Some(place) = self.tree.get_mut(node) {
            *place = word;
        }
    }

    /// The word of a node; a leaf's is its number.
    #[expect(clippy::cast_possible_truncation, reason = "setup refuses more than MOST")]
    fn word(&self, node: usize) -> u32 {
        let leaves = self.slots.len();
        if node >= leaves {
            (node - leaves) as u32
        } else {
            self.tree.get(node).copied().unwrap_or(0)
        }
    }

    fn winner(&self, word: u32) -> usize {
        (word & WINNER) as usize
    }

    fn time(&self, grain: usize) -> S {
        self.slots.get(grain).map_or(S::NEVER, |slot| slot.time)
    }
}

/// Of two words and their winners' times the earlier, or, of equals, that with the lower winner and the
/// sum of their counts.
#[inline]
fn play<S: Scalar>(left: (u32, S), right: (u32, S)) -> (u32, S) {
    if left.1 == right.1 {
        let more = ((left.0 >> 30) + (right.0 >> 30) + 1).min(2);
        return ((left.0 & WINNER).min(right.0 & WINNER) | more << 30, left.1);
    }
    if right.1 < left.1 { right } else { left }
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

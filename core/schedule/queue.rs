//! Who is next? One scheduled event per grain in a tournament tree; reads and writes events and tree.
//!
//! Every grain has one event: its own earliest. The tree's root names the earliest of all, so
//! the capacity is exactly the number of grains and nothing can overflow. Equal times are decided
//! by the grain's number, so ties break the same way on every target.

use crate::detect::ScheduledEvent;
use crate::scalar::Scalar;

/// The tree over the events of all grains. Node n has the children 2n and 2n + 1; leaf i is node N + i.
///
/// A node's word is the winner's number and, in the two highest bits, how many leaves below it are as
/// early as the winner: 0 for one, 1 for two, 2 for more.
pub(crate) struct EventQueue<'m, S: Scalar> {
    pub(crate) events: &'m mut [ScheduledEvent<S>],
    tree: &'m mut [u32],
}

/// The bits of a winner's number.
const WINNER: u32 = (1 << 30) - 1;

impl<'m, S: Scalar> EventQueue<'m, S> {
    /// The most grains that a word of the tree can number.
    pub(crate) const MAX_GRAINS: usize = WINNER as usize;

    /// A queue for as many grains as there are events; the tree has the same length.
    pub(crate) fn new(events: &'m mut [ScheduledEvent<S>], tree: &'m mut [u32]) -> Self {
        let mut queue = Self { events, tree };
        queue.rebuild();
        queue
    }

    /// The grain whose event is the earliest, if there are grains.
    pub(crate) fn first(&self) -> Option<usize> {
        (!self.events.is_empty()).then(|| self.winner(self.word(1)))
    }

    /// How many events are as early as the first, the first included; 3 stands for any more.
    pub(crate) fn simultaneous(&self) -> u32 {
        (self.word(1) >> 30) + 1
    }

    /// The event of a grain.
    pub(crate) fn event(&self, grain: usize) -> ScheduledEvent<S> {
        self.events.get(grain).copied().unwrap_or(ScheduledEvent::NONE)
    }

    /// Puts a grain's event in its place.
    #[inline]
    pub(crate) fn set(&mut self, grain: usize, event: ScheduledEvent<S>) {
        if let Some(place) = self.events.get_mut(grain) {
            *place = event;
            self.replay(grain);
        }
    }

    /// Visits the grains whose events are at this time, the earliest of all, until a visit says it is enough.
    pub(crate) fn tied(&self, time: S, visit: &mut impl FnMut(usize) -> bool) {
        if !self.events.is_empty() {
            self.tied_below(1, time, visit);
        }
    }

    /// As deep as the tree is high: at most 30.
    fn tied_below(&self, node: usize, time: S, visit: &mut impl FnMut(usize) -> bool) -> bool {
        let winner = self.winner(self.word(node));
        if !(self.time(winner) <= time) {
            return true;
        }
        if node >= self.events.len() {
            return visit(winner);
        }
        self.tied_below(2 * node, time, visit) && self.tied_below(2 * node + 1, time, visit)
    }

    /// Plays every match again.
    pub(crate) fn rebuild(&mut self) {
        for node in (1..self.events.len()).rev() {
            let [left, right] = [2 * node, 2 * node + 1].map(|child| {
                let word = self.word(child);
                (word, self.time(self.winner(word)))
            });
            self.keep(node, play(left, right).0);
        }
    }

    /// Plays the matches on one leaf's way up again, as far as they can end otherwise than before.
    #[inline]
    fn replay(&mut self, grain: usize) {
        let mut node = self.events.len() + grain;
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
    #[expect(clippy::cast_possible_truncation, reason = "the builder refuses more than MAX_GRAINS")]
    fn word(&self, node: usize) -> u32 {
        let leaves = self.events.len();
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
        self.events.get(grain).map_or(S::NEVER, |event| event.time)
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
    use crate::detect::EventKind;

    fn firsts(times: &[f64]) -> std::vec::Vec<usize> {
        let mut events = [ScheduledEvent::NONE; 9];
        let mut tree = [0_u32; 9];
        let n = times.len();
        let mut queue = EventQueue::new(&mut events[..n], &mut tree[..n]);
        for (i, &t) in times.iter().enumerate() {
            queue.set(i, ScheduledEvent::alone(t, EventKind::Recheck));
        }
        let mut order = std::vec::Vec::new();
        for _ in 0..n {
            let i = queue.first().unwrap();
            order.push(i);
            queue.set(i, ScheduledEvent::NONE);
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

//! Who is next where there are few grains, or many events at one instant? A tournament over the events of all; reads events, writes the tree.

use crate::detect::ScheduledEvent;
use crate::particle::Index;
use crate::scalar::Scalar;

/// The tree over the events of all grains. Node n has the children 2n and 2n + 1; leaf i is node N + i.
///
/// A node's word is the winner's number and, in the two highest bits, how many leaves below it are as
/// early as the winner: 0 for one, 1 for two, 2 for more.
pub(super) struct Tournament<'m> {
    tree: &'m mut [Index],
}

/// The bits of a winner's number.
pub(super) const WINNER: u32 = (1 << COUNT) - 1;

/// The first bit of the count above it.
const COUNT: u32 = Index::BITS - 2;

impl<'m> Tournament<'m> {
    /// A tree with as many words as there are events; the matches are yet to be played.
    pub fn new(tree: &'m mut [Index]) -> Self {
        Self { tree }
    }

    /// The grain whose event is the earliest, if there are grains.
    pub fn first(&self) -> Option<usize> {
        (!self.tree.is_empty()).then(|| winner(self.word(1)))
    }

    /// How many events are as early as the first, the first included; 3 stands for any more.
    pub fn simultaneous(&self) -> u32 {
        (self.word(1) >> COUNT) + 1
    }

    /// Visits the grains whose events are at this time, the earliest of all, until a visit says it is enough.
    pub fn tied<S: Scalar>(
        &self,
        events: &[ScheduledEvent<S>],
        time: S,
        visit: &mut impl FnMut(usize) -> bool,
    ) {
        if !self.tree.is_empty() {
            self.tied_below(events, 1, time, visit);
        }
    }

    /// As deep as the tree is high: at most 30.
    fn tied_below<S: Scalar>(
        &self,
        events: &[ScheduledEvent<S>],
        node: usize,
        time: S,
        visit: &mut impl FnMut(usize) -> bool,
    ) -> bool {
        let winner = winner(self.word(node));
        if !(time_of(events, winner) <= time) {
            return true;
        }
        if node >= self.tree.len() {
            return visit(winner);
        }
        self.tied_below(events, 2 * node, time, visit)
            && self.tied_below(events, 2 * node + 1, time, visit)
    }

    /// Where a grain's leaf is, counted from one side of the tree to the other.
    pub fn place(&self, grain: usize) -> usize {
        let node = self.tree.len() + grain;
        node << (node.leading_zeros() - self.tree.len().saturating_mul(2).leading_zeros())
    }

    /// Plays every match again.
    pub fn rebuild<S: Scalar>(&mut self, events: &[ScheduledEvent<S>]) {
        for node in (1..self.tree.len()).rev() {
            let [left, right] = [2 * node, 2 * node + 1].map(|child| {
                let word = self.word(child);
                (word, time_of(events, winner(word)))
            });
            if let Some(place) = self.tree.get_mut(node) {
                *place = Index::new(play(left, right).0);
            }
        }
    }

    /// Plays the matches on one leaf's way up again, as far as they can end otherwise than before.
    #[inline]
    pub fn replay<S: Scalar>(&mut self, events: &[ScheduledEvent<S>], grain: usize) {
        let mut node = self.tree.len() + grain;
        let mut mine = (self.word(node), time_of(events, grain));
        while node > 1 {
            let word = self.word(node ^ 1);
            let other = (word, time_of(events, winner(word)));
            node /= 2;
            mine = play(mine, other);
            let Some(place) = self.tree.get_mut(node) else { return };
            if mine.0 == place.get() && winner(mine.0) != grain {
                return;
            }
            *place = Index::new(mine.0);
        }
    }

    /// The word of a node; a leaf's is its number.
    #[expect(clippy::cast_possible_truncation, reason = "the builder refuses more than MAX_GRAINS")]
    fn word(&self, node: usize) -> u32 {
        let leaves = self.tree.len();
        if node >= leaves {
            (node - leaves) as u32
        } else {
            self.tree.get(node).map_or(0, |word| word.get())
        }
    }
}

fn winner(word: u32) -> usize {
    (word & WINNER) as usize
}

fn time_of<S: Scalar>(events: &[ScheduledEvent<S>], grain: usize) -> S {
    events.get(grain).map_or(S::NEVER, |event| event.time)
}

/// Of two words and their winners' times the earlier, or, of equals, that with the lower winner and the
/// sum of their counts.
#[inline]
fn play<S: Scalar>(left: (u32, S), right: (u32, S)) -> (u32, S) {
    if left.1 == right.1 {
        let more = ((left.0 >> COUNT) + (right.0 >> COUNT) + 1).min(2);
        return ((left.0 & WINNER).min(right.0 & WINNER) | more << COUNT, left.1);
    }
    if right.1 < left.1 { right } else { left }
}

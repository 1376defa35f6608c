//! Who is next? One scheduled event per grain, in a calendar or a tournament tree; reads and writes events and both.
//!
//! Every grain has one event: its own earliest. So the capacity is exactly the number of grains and nothing can
//! overflow. Equal times are decided by the grain's number, so ties break the same way on every target and in both.

#[cfg(feature = "alloc")]
use super::calendar::Calendar;
#[cfg(not(feature = "alloc"))]
use super::no_calendar::Calendar;
use super::tournament::{Tournament, WINNER};
use crate::detect::ScheduledEvent;
use crate::particle::Index;
use crate::scalar::Scalar;

/// Of so many events at one instant the calendar can tell the order.
const MOST_TIED: u32 = 16;

/// The events of all grains, and what finds the earliest of them.
pub(crate) struct EventQueue<'m, S: Scalar> {
    pub(crate) events: &'m mut [ScheduledEvent<S>],
    tournament: Tournament<'m>,
    calendar: Calendar<'m>,
}

impl<'m, S: Scalar> EventQueue<'m, S> {
    /// The most grains that a word of the tree can number.
    pub(crate) const MAX_GRAINS: usize = WINNER as usize;

    /// A queue for as many grains as there are events; the tree has the same length.
    pub(crate) fn new(
        events: &'m mut [ScheduledEvent<S>],
        tree: &'m mut [Index],
        rings: &'m mut [[u32; 2]],
    ) -> Self {
        let calendar = Calendar::new(rings, events.len());
        let mut queue = Self { events, tournament: Tournament::new(tree), calendar };
        queue.rebuild();
        queue
    }

    /// Whether the calendar says who is next.
    pub(crate) fn has_calendar(&self) -> bool {
        self.calendar.is_open()
    }

    /// The grain whose event is the earliest, if there are grains.
    #[inline]
    pub(crate) fn first(&mut self) -> Option<usize> {
        if !self.calendar.is_open() && self.calendar.has_rested() {
            self.rebuild();
        }
        while self.calendar.is_open() {
            let Some(earliest) = self.calendar.earliest(self.events) else { break };
            let crowded = earliest.ties > MOST_TIED;
            if self.calendar.go_to(&earliest) && !crowded {
                return Some(earliest.grain as usize);
            }
            self.reopen(crowded);
        }
        self.first_without_search()
    }

    /// The same after none was found in the calendar, or if there is none.
    fn first_without_search(&self) -> Option<usize> {
        match self.calendar.is_open() {
            true => (!self.events.is_empty()).then_some(0),
            false => self.tournament.first(),
        }
    }

    /// The calendar's days have become too long or too short, or too many events come at one instant.
    #[cold]
    fn reopen(&mut self, crowded: bool) {
        if !crowded && self.calendar.has_served() {
            self.calendar.open(self.events);
        } else {
            self.calendar.close();
        }
        if !self.calendar.is_open() {
            self.tournament.rebuild(self.events);
        }
    }

    /// The earliest event, if there are grains.
    pub(crate) fn earliest(&self) -> Option<ScheduledEvent<S>> {
        let found = match self.calendar.is_open() {
            true => self.calendar.earliest(self.events).map(|earliest| earliest.grain as usize),
            false => None,
        };
        found.or_else(|| self.first_without_search()).map(|grain| self.event(grain))
    }

    /// How many events are as early as that which was found last, itself included; 3 stands for any more.
    pub(crate) fn simultaneous(&self) -> u32 {
        match self.calendar.is_open() {
            true => self.calendar.ties().clamp(1, 3),
            false => self.tournament.simultaneous(),
        }
    }

    /// The event of a grain.
    #[inline]
    pub(crate) fn event(&self, grain: usize) -> ScheduledEvent<S> {
        self.events.get(grain).copied().unwrap_or(ScheduledEvent::NONE)
    }

    /// Puts a grain's event in its place.
    #[inline]
    pub(crate) fn set(&mut self, grain: usize, event: ScheduledEvent<S>) {
        let Some(place) = self.events.get_mut(grain) else { return };
        *place = event;
        if self.calendar.is_open() {
            self.calendar.set(grain, event.time);
        } else {
            self.tournament.replay(self.events, grain);
        }
    }

    /// Visits the grains whose events are at this time, that which was found last, until a visit says it is enough.
    pub(crate) fn tied(&self, time: S, visit: &mut impl FnMut(usize) -> bool) {
        if !self.calendar.is_open() {
            return self.tournament.tied(self.events, time, visit);
        }
        let mut tied = heapless::Vec::<usize, { MOST_TIED as usize }>::new();
        self.calendar.due_at(self.events, time, |grain| {
            let _ = tied.push(grain as usize);
        });
        // In the order in which the tree has its leaves.
        tied.sort_unstable_by_key(|grain| self.tournament.place(*grain));
        let _ = tied.iter().all(|&grain| visit(grain));
    }

    /// All events were written anew.
    pub(crate) fn rebuild(&mut self) {
        self.calendar.open(self.events);
        if !self.calendar.is_open() {
            self.tournament.rebuild(self.events);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::detect::EventKind;
    use std::vec::Vec;

    const GRAINS: usize = 40;
    const RINGS: usize = GRAINS + 64 + 1;

    fn event(time: f64) -> ScheduledEvent<f64> {
        ScheduledEvent::alone(time, EventKind::Recheck)
    }

    fn firsts(times: &[f64]) -> Vec<usize> {
        let mut events = [ScheduledEvent::NONE; 9];
        let mut tree = [Index::ZERO; 9];
        let n = times.len();
        let mut queue = EventQueue::new(&mut events[..n], &mut tree[..n], &mut []);
        for (i, &t) in times.iter().enumerate() {
            queue.set(i, event(t));
        }
        let mut order = Vec::new();
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

    /// The next event, how many come with it, and who in which order.
    fn next(queue: &mut EventQueue<'_, f64>) -> (usize, u64, u32, Vec<usize>) {
        let grain = queue.first().unwrap();
        let (time, mut tied) = (queue.event(grain).time, Vec::new());
        assert_eq!(queue.earliest().unwrap().time, time);
        queue.tied(time, &mut |k| {
            tied.push(k);
            tied.len() < 8
        });
        let never = time == f64::MAX;
        (
            grain,
            time.to_bits(),
            if never { 0 } else { queue.simultaneous() },
            if never { Vec::new() } else { tied },
        )
    }

    proptest::proptest! {
        /// With and without a calendar: waits that are short, long, equal, none and without end, and rates that
        /// change by orders of magnitude, so that the calendar is opened anew and closed, too.
        #[test]
        fn the_calendar_says_what_the_tree_says(
            count in 33..=GRAINS,
            starts in proptest::collection::vec(0.0..2.0_f64, GRAINS),
            waits in proptest::collection::vec((0_u8..16, 0.0..2.0_f64, 0_usize..GRAINS), 1..2000),
            slower in proptest::bool::ANY,
        ) {
            let mut events = [[ScheduledEvent::NONE; GRAINS]; 2];
            let (mut trees, mut rings) = ([[Index::ZERO; GRAINS]; 2], [[0; 2]; RINGS]);
            let [a, b] = &mut events;
            let [s, t] = &mut trees;
            let mut tree = EventQueue::new(&mut a[..count], &mut s[..count], &mut []);
            let mut calendar = EventQueue::new(&mut b[..count], &mut t[..count], &mut rings);
            for queue in [&mut tree, &mut calendar] {
                queue.events.iter_mut().zip(&starts).for_each(|(place, time)| *place = event(*time));
                queue.rebuild();
            }
            proptest::prop_assert!(!cfg!(feature = "alloc") || calendar.calendar.is_open());
            let mut unit = 1.0_f64;
            for (kind, wait, other) in waits {
                let found = next(&mut tree);
                proptest::prop_assert_eq!(&found, &next(&mut calendar));
                let now = f64::from_bits(found.1);
                if now == f64::MAX {
                    break;
                }
                unit *= if slower { 1.004 } else { 0.996 };
                let grid = unit.log2().ceil().exp2();
                let then = match kind {
                    0 => now,
                    1 => now + 1e3 * unit * wait,
                    2 => f64::MAX,
                    // Two in a row seldom have the same unit, but the same power of two: such times are equal.
                    3 | 6..=8 => (now / grid).ceil() * grid,
                    4 => now - 1e-3 * wait,
                    _ => now + unit * wait,
                };
                let grain = if kind == 4 || kind == 5 { other % count } else { found.0 };
                tree.set(grain, event(then));
                calendar.set(grain, event(then));
            }
        }
    }
}

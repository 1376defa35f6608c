//! Who is next where many grains are? Events in days of a calendar; reads their times, writes the lists of the days.
//!
//! The days are as long as it takes until about one event is due, and are used again year after year: which year an
//! event belongs to, its time says. Finding the next event and moving one to another day then take the same few
//! steps however many grains there are (Brown, Commun. ACM 31, 1220, 1988). Where that is not so, because the
//! rate of events changed or many come at one instant, [`super::EventQueue`] opens the calendar anew or goes back
//! to its tree.

use crate::detect::ScheduledEvent;
use crate::scalar::Scalar;

/// With fewer grains the tree has at most four levels below its root, and a calendar little to save.
const FEWEST: usize = 32;

/// So many steps an event may take before the calendar is called a bad one; two or three are usual.
const STEPS: u32 = 12;

/// The lists of all days, in borrowed memory.
pub(super) struct Calendar<'m> {
    /// The next and the previous in a ring: first those of each grain, then those of each day, in whose ring its
    /// grains are, and of a last one that never comes. So nothing that is moved is ever the first or the last.
    rings: &'m mut [[u32; 2]],
    grains: u32,
    /// The days of a year less one: a power of two of them.
    mask: u32,
    days_per_time: f64,
    /// Counted from when times are zero, not from the year's beginning.
    today: i64,
    /// How many events are due at the time that was found last.
    ties: u32,
    is_open: bool,
    /// How many steps more can be wasted until it is opened anew.
    patience: u32,
    /// How many searches it has stood, or has been closed for.
    searches: u32,
}

/// The earliest event of all.
#[derive(Clone, Copy)]
pub(super) struct Earliest<S> {
    pub grain: u32,
    pub time: S,
    /// How many events are as early.
    pub ties: u32,
    today: i64,
    steps: u32,
}

impl<'m> Calendar<'m> {
    /// A closed calendar for so many grains; it stays closed if they are few or this memory is too little.
    #[expect(clippy::cast_possible_truncation, reason = "the builder refuses more than MAX_GRAINS")]
    pub fn new(rings: &'m mut [[u32; 2]], grains: usize) -> Self {
        let days = rings.len().saturating_sub(grains + 1).min(1 << 30);
        let days = if days > 0 { 1 << days.ilog2() } else { 0 };
        let enough = grains >= FEWEST && days >= grains;
        let rings = rings.get_mut(..grains + days + 1).filter(|_| enough).unwrap_or_default();
        let mask = (days as u32).saturating_sub(1);
        let [ties, patience, searches] = [0; 3];
        Self {
            rings,
            grains: grains as u32,
            mask,
            days_per_time: 0.0,
            today: 0,
            ties,
            is_open: false,
            patience,
            searches,
        }
    }

    /// Whether events are in it.
    #[inline(always)]
    pub fn is_open(&self) -> bool {
        self.is_open
    }

    /// How many events are as early as the one that was found last.
    pub fn ties(&self) -> u32 {
        self.ties
    }

    /// Nothing is in it any more.
    pub fn close(&mut self) {
        (self.is_open, self.searches) = (false, 0);
    }

    /// Whether it has been closed for as many searches as there are grains, and may be opened.
    #[inline]
    pub fn has_rested(&mut self) -> bool {
        self.searches = self.searches.saturating_add(1);
        self.has_served() && !self.rings.is_empty()
    }

    /// Whether it has stood as many searches as there are grains.
    pub fn has_served(&self) -> bool {
        self.searches >= self.grains
    }

    /// All these events are in it from now on, if it has memory and their times tell how long a day should be.
    #[expect(clippy::cast_possible_truncation, reason = "rings are numbered in 32 bits")]
    pub fn open<S: Scalar>(&mut self, events: &[ScheduledEvent<S>]) {
        self.close();
        let found = if self.rings.is_empty() { None } else { rate(events) };
        let Some((first, days_per_time)) = found else { return };
        (self.days_per_time, self.today) = (days_per_time, 0);
        self.today = self.day(first);
        self.rings.iter_mut().enumerate().for_each(|(n, ring)| *ring = [n as u32; 2]);
        self.is_open = true;
        for (grain, event) in events.iter().enumerate() {
            self.set(grain, event.time);
        }
        self.patience = self.most_patience();
    }

    /// The day of a time; what is overdue is due today.
    #[inline(always)]
    #[expect(
        clippy::cast_possible_truncation,
        reason = "what is too late for any day is in the last one"
    )]
    fn day<S: Scalar>(&self, time: S) -> i64 {
        ((time.to_f64() * self.days_per_time) as i64).max(self.today)
    }

    /// The ring of a day.
    #[inline(always)]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "its place in the year is meant"
    )]
    fn ring(&self, day: i64) -> u32 {
        self.grains + (day as u32 & self.mask)
    }

    /// Moves a grain to the day of this time.
    #[inline]
    #[expect(clippy::cast_possible_truncation, reason = "the builder refuses more than MAX_GRAINS")]
    pub fn set<S: Scalar>(&mut self, grain: usize, time: S) {
        let never = self.grains + self.mask + 1;
        let ring = if time < S::NEVER { self.ring(self.day(time)) } else { never };
        let [next, previous] = self.place(grain as u32);
        self.join(previous, next);
        let [next, _] = self.place(ring);
        self.join(ring, grain as u32);
        self.join(grain as u32, next);
    }

    /// What is next to this in its ring, and before it.
    #[inline(always)]
    fn place(&self, of: u32) -> [u32; 2] {
        self.rings.get(of as usize).copied().unwrap_or([of; 2])
    }

    /// The second of these is the next to the first.
    #[inline(always)]
    fn join(&mut self, first: u32, second: u32) {
        if let Some([next, _]) = self.rings.get_mut(first as usize) {
            *next = second;
        }
        if let Some([_, previous]) = self.rings.get_mut(second as usize) {
            *previous = first;
        }
    }

    /// The earliest event, of equal ones that of the lowest number.
    pub fn earliest<S: Scalar>(&self, events: &[ScheduledEvent<S>]) -> Option<Earliest<S>> {
        let mut first =
            Earliest { grain: u32::MAX, time: S::NEVER, ties: 0, today: self.today, steps: 0 };
        for today in self.today..self.today.saturating_add(i64::from(self.mask) + 1) {
            first.today = today;
            self.visit(events, today, |grain, time| first.meet(grain, time));
            first.steps += 1;
            if first.ties > 0 {
                return Some(first);
            }
        }
        self.in_later_years(events, first)
    }

    /// The same if nothing is due this year.
    #[cold]
    #[expect(clippy::cast_possible_truncation, reason = "the builder refuses more than MAX_GRAINS")]
    fn in_later_years<S: Scalar>(
        &self,
        events: &[ScheduledEvent<S>],
        mut first: Earliest<S>,
    ) -> Option<Earliest<S>> {
        let times = events.iter().enumerate().map(|(grain, event)| (grain as u32, event.time));
        times
            .filter(|(_, time)| *time < S::NEVER)
            .for_each(|(grain, time)| first.meet(grain, time));
        first.today = self.day(first.time);
        (first.ties > 0).then_some(first)
    }

    /// Goes on to the day of the earliest event; false if it took too many steps to find it, time after time.
    #[inline]
    pub fn go_to<S: Scalar>(&mut self, earliest: &Earliest<S>) -> bool {
        (self.today, self.ties) = (earliest.today, earliest.ties);
        self.searches = self.searches.saturating_add(1);
        let patience = (self.patience + STEPS).min(self.most_patience());
        self.patience = patience.saturating_sub(earliest.steps);
        self.patience > 0
    }

    /// As many steps as it takes to open it, or a few more.
    fn most_patience(&self) -> u32 {
        self.grains.saturating_mul(8).saturating_add(1024).min(u32::MAX / 2)
    }

    /// Visits the grains that are due on this day.
    #[inline(always)]
    fn visit<S: Scalar>(
        &self,
        events: &[ScheduledEvent<S>],
        today: i64,
        mut visit: impl FnMut(u32, S),
    ) {
        let [mut grain, _] = self.place(self.ring(today));
        // The last of them leads to the day's own ring, which has no event.
        while let Some(event) = events.get(grain as usize) {
            if self.day(event.time) <= today {
                visit(grain, event.time);
            }
            [grain, _] = self.place(grain);
        }
    }

    /// Visits the grains that are due today at this time at the latest.
    pub fn due_at<S: Scalar>(
        &self,
        events: &[ScheduledEvent<S>],
        time: S,
        mut visit: impl FnMut(u32),
    ) {
        self.visit(events, self.today, |grain, due| {
            if due <= time {
                visit(grain);
            }
        });
    }
}

impl<S: Scalar> Earliest<S> {
    #[inline(always)]
    fn meet(&mut self, grain: u32, time: S) {
        self.steps += 1;
        if time < self.time {
            (self.grain, self.time, self.ties) = (grain, time, 1);
        } else if time == self.time {
            (self.grain, self.ties) = (self.grain.min(grain), self.ties + 1);
        }
    }
}

/// The earliest time, and how many events are due in a unit of time then; none if the times do not tell.
fn rate<S: Scalar>(events: &[ScheduledEvent<S>]) -> Option<(S, f64)> {
    let spans = |from: S| {
        let due = events.iter().filter(|event| event.time < S::NEVER);
        due.map(move |event| event.time.to_f64() - from.to_f64())
    };
    let first = events.iter().fold(S::NEVER, |first, event| first.min(event.time));
    let count = spans(first).count() as f64;
    let mut span = spans(first).sum::<f64>() / count;
    let mut most = 0.0_f64;
    // The longest spans say nothing of what is due next: half of them, and half of those again, are left out.
    for _ in 0..64 {
        let within = spans(first).filter(|x| *x <= span).count() as f64;
        most = most.max(within / span);
        if within <= 0.5 * count {
            break;
        }
        span *= 0.5;
    }
    // Also not if a day is so short that the days of late times cannot be counted.
    let is_rate = most > 0.0 && most.is_finite() && (first.to_f64() + span) * most < 1e15;
    is_rate.then_some((first, most))
}

//! How did all boxes fare, family by family? Reads reports; writes nothing, returns counts and times.

use super::draw::{Drawn, Gravity};
use super::run::{Ended, Report};
use std::collections::BTreeMap;

/// What boxes have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Family {
    /// 1, 2 or 3.
    pub dimension: usize,
    /// The law's name.
    pub law: &'static str,
    /// What gravity does.
    pub gravity: Gravity,
    /// Whether they are boxes of more than 20 grains that must sleep.
    pub is_large: bool,
}

/// How the boxes of a family fared.
#[derive(Clone, Debug, Default)]
pub struct Summary {
    /// How many there are.
    pub boxes: u64,
    /// When they fell asleep, of those that must, sorted.
    pub asleep: Vec<f64>,
    /// How many still slid on a smooth floor.
    pub sliding: u64,
    /// In how many something was crushed.
    pub crushed: u64,
    /// How many broke.
    pub broken: u64,
    /// The largest of what was measured.
    pub rise: f64,
    /// The deepest overlap, in units of the smaller radius.
    pub deepest: f64,
    /// Collisions of a grain in a unit of time.
    pub collisions: f64,
    /// Seconds of the slowest box.
    pub slowest: f64,
}

impl Summary {
    /// One more box.
    pub fn add(&mut self, drawn: &Drawn, report: &Report) {
        self.boxes += 1;
        match report.ended {
            Ended::Asleep(time) if drawn.must_sleep_by().is_some() => {
                let place = self.asleep.partition_point(|&other| other < time);
                self.asleep.insert(place, time);
            }
            Ended::Asleep(_) | Ended::Moving { slides: false } => {}
            Ended::Moving { slides: true } => self.sliding += 1,
            Ended::Crushed => self.crushed += 1,
            Ended::Broken(_) => self.broken += 1,
        }
        self.rise = self.rise.max(report.rise);
        self.deepest = self.deepest.max(report.deepest);
        self.collisions = self.collisions.max(report.collisions);
        self.slowest = self.slowest.max(report.seconds);
    }

    /// The median time of falling asleep.
    pub fn median(&self) -> Option<f64> {
        self.asleep.get(self.asleep.len() / 2).copied()
    }
}

/// The family of a box.
pub fn family(drawn: &Drawn) -> Family {
    let is_large = drawn.must_sleep_by().is_some() && drawn.count() > 20;
    let Drawn { dimension, gravity, law, .. } = *drawn;
    Family { dimension, law: law.label(), gravity, is_large }
}

/// All families.
pub type Families = BTreeMap<Family, Summary>;

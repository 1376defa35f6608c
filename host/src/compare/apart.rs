//! How far apart are two methods? Reads their samples; writes nothing, returns position differences.

use super::{Point, Track};
use crate::method::touching;
use crate::run::Sample;
use crate::scenario::Start;
use serde::Serialize;

/// Position differences of the grains that touch nothing in either method.
///
/// During a contact eMD* holds grains where they will be only at its end, and eMD has no duration
/// at all, so grains in contact are left out.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Apart {
    /// Root mean square [m].
    pub rms: f64,
    /// Largest [m].
    pub largest: f64,
}

/// The differences of one sample; nothing if all grains are in contact.
pub fn apart(start: &Start, judge: &Sample, other: &Sample) -> Option<Apart> {
    let held = touching(start, &judge.grains).into_iter().zip(touching(start, &other.grains));
    let pairs = judge.grains.iter().zip(&other.grains).zip(held);
    let (mut count, mut sum, mut largest) = (0u32, 0.0, 0.0f64);
    for ((a, b), _) in pairs.filter(|(_, (here, there))| !here && !there) {
        let square: f64 = start.nearest(&a.position, &b.position).iter().map(|x| x * x).sum();
        count += 1;
        sum += square;
        largest = largest.max(square);
    }
    (count > 0).then(|| Apart { rms: (sum / f64::from(count)).sqrt(), largest: largest.sqrt() })
}

/// The time series of a track, compared with the judge's.
pub(super) fn series(start: &Start, judge: &Track, track: &Track) -> Vec<Point> {
    let pairs = judge.samples.iter().zip(&track.samples);
    pairs
        .map(|(reference, sample)| Point {
            time: sample.time,
            kinetic_energy: sample.kinetic_energy,
            collisions: sample.collisions,
            collisions_per_grain: per_grain(start, reference),
            apart: apart(start, reference, sample),
        })
        .collect()
}

/// The sample at which the table compares: the first after one collision a grain, or the last one
/// if the run hardly gets there.
pub(super) fn where_to_look(start: &Start, judge: &Track) -> usize {
    let last = judge.samples.len() - 1;
    if per_grain(start, &judge.samples[last]) <= 2.0 {
        return last;
    }
    judge.samples.iter().position(|sample| per_grain(start, sample) >= 1.0).unwrap_or(last)
}

fn per_grain(start: &Start, sample: &Sample) -> f64 {
    2.0 * sample.collisions as f64 / start.grains.len() as f64
}

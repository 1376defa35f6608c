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
    /// Half of the grains differ by less (m).
    pub median: f64,
    /// Root mean square (m).
    pub rms: f64,
    /// Largest (m).
    pub largest: f64,
}

/// The differences of one sample; nothing if all grains are in contact.
pub fn apart(start: &Start, judge: &Sample, other: &Sample) -> Option<Apart> {
    let held = touching(start, &judge.grains).into_iter().zip(touching(start, &other.grains));
    let pairs = judge.grains.iter().zip(&other.grains).zip(held);
    let free = pairs.filter(|(_, (here, there))| !here && !there);
    let mut squares: Vec<f64> = free
        .map(|((a, b), _)| start.nearest(&a.position, &b.position).iter().map(|x| x * x).sum())
        .collect();
    squares.sort_by(f64::total_cmp);
    let mean = squares.iter().sum::<f64>() / squares.len() as f64;
    Some(Apart {
        median: squares.get(squares.len() / 2)?.sqrt(),
        rms: mean.sqrt(),
        largest: squares.last()?.sqrt(),
    })
}

/// The time series of a track, compared with the judge's as long as that ran.
pub(super) fn series(start: &Start, judge: &Track, track: &Track) -> Vec<Point> {
    let point = |(number, sample): (usize, &Sample)| Point {
        time: sample.time,
        kinetic_energy: sample.kinetic_energy,
        collisions: sample.collisions,
        collisions_per_grain: per_grain(start, sample),
        apart: judge.samples.get(number).and_then(|judge| apart(start, judge, sample)),
    };
    track.samples.iter().enumerate().map(point).collect()
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

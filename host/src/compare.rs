//! Do the methods agree, and what does each cost? Runs all from one start; returns the comparison, writes it as a table.

use crate::method;
use crate::report::write_aligned;
use crate::run::{self, Plan, Sample};
use crate::scenario::{MethodName, Scenario, Start, touching};
use anyhow::{Result, bail};
use serde::Serialize;
use std::io::Write;

/// A method counts as following MD while half of the grains are closer to where MD has them than
/// this part of a radius.
pub const FOLLOWING: f64 = 0.1;

/// A shorter run of MD than this (s) is not timed.
const TIMEABLE: f64 = 5e-3;

/// Everything that a comparison found.
#[derive(Clone, Debug, Serialize)]
pub struct Comparison {
    /// The scenario's title.
    pub title: String,
    /// Grains.
    pub grains: usize,
    /// Mean radius (m).
    pub mean_radius: f64,
    /// What positions are compared with.
    pub reference: MethodName,
    /// Where in the run `Summary::difference` is taken (s).
    pub compared_at: f64,
    /// How long the reference ran (s).
    pub reference_until: f64,
    /// One entry for each method, the reference first.
    pub methods: Vec<Summary>,
}

/// What one method got and what it cost.
#[derive(Clone, Debug, Serialize)]
pub struct Summary {
    /// The method.
    pub method: MethodName,
    /// Contacts with grains and walls.
    pub collisions: u64,
    /// Kinetic energy at the end (J).
    pub kinetic_energy: f64,
    /// Seconds of computing.
    pub wall_seconds: f64,
    /// Seconds simulated.
    pub simulated: f64,
    /// How many times faster than force-based MD by velocity Verlet; nothing if that took less
    /// than a few milliseconds, which cannot be timed in one run.
    pub speed_up: Option<f64>,
    /// Position differences from the reference at `Comparison::compared_at`.
    pub difference: Option<Difference>,
    /// The last sample at which it still followed the reference; nothing if it did to the reference's end.
    pub followed_until: Option<f64>,
    /// Collisions a grain until then, or until the reference's end.
    pub followed_collisions: f64,
    /// All statistics at the end.
    pub statistics: Vec<(&'static str, u64)>,
    /// The time series.
    pub series: Vec<Point>,
}

/// One sample of one method, compared with the reference.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Point {
    /// Time (s).
    pub time: f64,
    /// Kinetic energy (J).
    pub kinetic_energy: f64,
    /// Contacts so far.
    pub collisions: u64,
    /// Collisions a grain so far.
    pub collisions_per_grain: f64,
    /// Position differences from the reference.
    pub difference: Option<Difference>,
}

/// One method's samples and cost.
#[derive(Clone, Debug)]
pub struct Track {
    /// The method.
    pub method: MethodName,
    /// All samples.
    pub samples: Vec<Sample>,
    /// Seconds of computing.
    pub wall_seconds: f64,
}

/// Runs MD by velocity Verlet, eMD, eMD* and, as the reference, MD contact by contact, all from one
/// start and one after the other, so that the times can be compared. The reference comes first.
///
/// # Errors
/// An error of a method; a law without a force.
pub fn tracks(scenario: &Scenario) -> Result<(Start, Vec<Track>)> {
    if scenario.laws().any(|law| !law.has_force()) {
        bail!(
            "law.kind is constant: there is no force to compare with; lsd or viscoelastic is needed"
        );
    }
    if scenario.only_law().is_none() {
        bail!("there are several laws, but MD has one for all contacts");
    }
    if let Some(axis) = scenario.event_driven_walls() {
        bail!(
            "box.{axis}: MD has no hard walls, no walls of a material and no two that vibrate; soft ones at rest are needed for a comparison"
        );
    }
    let start = Start::new(scenario)?;
    let plan = Plan::new(scenario);
    let verlet = track(scenario, &start, MethodName::Md, &plan)?;
    // A number of collisions is this one's; the others run to the same instant.
    let plan = plan.until(verlet.samples.last().map_or(0.0, |sample| sample.time));
    let emd = track(scenario, &start, MethodName::Emd, &plan)?;
    let emd_star = track(scenario, &start, MethodName::EmdStar, &plan)?;
    let exact_plan = plan.at_most(scenario.options.exact_until);
    let exact = track(scenario, &start, MethodName::Exact, &exact_plan)?;
    Ok((start, vec![exact, verlet, emd, emd_star]))
}

fn track(scenario: &Scenario, start: &Start, name: MethodName, plan: &Plan) -> Result<Track> {
    let mut samples = Vec::new();
    let keep = |sample: &Sample| {
        samples.push(sample.clone());
        Ok(())
    };
    let run = |method: &mut dyn method::Method| run::drive(method, plan, keep);
    let wall_seconds = method::with(name, scenario, start, run)?;
    Ok(Track { method: name, samples, wall_seconds })
}

/// Compares the tracks with the first one.
///
/// # Errors
/// When there is no track.
pub fn summarise(scenario: &Scenario, start: &Start, tracks: &[Track]) -> Result<Comparison> {
    let Some(reference) = tracks.first() else { bail!("no method was run") };
    let verlet = tracks.iter().find(|track| track.method == MethodName::Md);
    let at = sample_to_compare(start, reference);
    let one = |track: &Track| summary(start, reference, verlet, at, track);
    Ok(Comparison {
        title: scenario.title.clone(),
        grains: start.grains.len(),
        mean_radius: start.mean_radius(),
        reference: reference.method,
        reference_until: reference.samples.last().map_or(0.0, |sample| sample.time),
        compared_at: reference.samples.get(at).map_or(0.0, |sample| sample.time),
        methods: tracks.iter().map(one).collect(),
    })
}

fn summary(
    start: &Start,
    reference: &Track,
    verlet: Option<&Track>,
    at: usize,
    track: &Track,
) -> Summary {
    let series = series(start, reference, track);
    let limit = FOLLOWING * start.mean_radius();
    let is_lost =
        |point: &Point| point.difference.is_some_and(|difference| difference.median > limit);
    let lost = series.iter().position(is_lost);
    let compared = series.iter().rposition(|point| point.difference.is_some()).unwrap_or(0);
    let last = series[lost.map_or(compared, |lost| lost.saturating_sub(1))];
    let end = series[series.len() - 1];
    Summary {
        method: track.method,
        collisions: end.collisions,
        kinetic_energy: end.kinetic_energy,
        wall_seconds: track.wall_seconds,
        simulated: end.time,
        speed_up: verlet
            .filter(|verlet| verlet.wall_seconds > TIMEABLE)
            .map(|verlet| speed(track) / speed(verlet)),
        difference: series.get(at).and_then(|point| point.difference),
        followed_until: lost.map(|_| last.time),
        followed_collisions: last.collisions_per_grain,
        statistics: track.samples.last().map(|s| s.statistics.clone()).unwrap_or_default(),
        series,
    }
}

/// Simulated seconds a second.
fn speed(track: &Track) -> f64 {
    track.samples.last().map_or(0.0, |sample| sample.time) / track.wall_seconds
}

/// Position differences of the grains that touch nothing in either method.
///
/// During a contact eMD* holds grains where they will be only at its end, and eMD has no duration
/// at all, so grains in contact are left out.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Difference {
    /// Half of the grains differ by less (m).
    pub median: f64,
    /// Root mean square (m).
    pub rms: f64,
    /// Largest (m).
    pub max: f64,
}

/// The differences of one sample; nothing if all grains are in contact.
fn difference(start: &Start, reference: &Sample, other: &Sample) -> Option<Difference> {
    let in_contact =
        touching(start, &reference.grains).into_iter().zip(touching(start, &other.grains));
    let pairs = reference.grains.iter().zip(&other.grains).zip(in_contact);
    let free = pairs.filter(|(_, (here, there))| !here && !there);
    let mut squares: Vec<f64> = free
        .map(|((a, b), _)| start.nearest(&a.position, &b.position).iter().map(|x| x * x).sum())
        .collect();
    squares.sort_by(f64::total_cmp);
    let mean = squares.iter().sum::<f64>() / squares.len() as f64;
    Some(Difference {
        median: squares.get(squares.len() / 2)?.sqrt(),
        rms: mean.sqrt(),
        max: squares.last()?.sqrt(),
    })
}

/// The time series of a track, compared with the reference's as long as that ran.
fn series(start: &Start, reference: &Track, track: &Track) -> Vec<Point> {
    let point = |(number, sample): (usize, &Sample)| Point {
        time: sample.time,
        kinetic_energy: sample.kinetic_energy,
        collisions: sample.collisions,
        collisions_per_grain: per_grain(start, sample),
        difference: reference
            .samples
            .get(number)
            .and_then(|reference| difference(start, reference, sample)),
    };
    track.samples.iter().enumerate().map(point).collect()
}

/// The sample at which the table compares: the first after one collision a grain, or the last one
/// if the run hardly gets there.
fn sample_to_compare(start: &Start, reference: &Track) -> usize {
    let last = reference.samples.len() - 1;
    if per_grain(start, &reference.samples[last]) <= 2.0 {
        return last;
    }
    reference.samples.iter().position(|sample| per_grain(start, sample) >= 1.0).unwrap_or(last)
}

fn per_grain(start: &Start, sample: &Sample) -> f64 {
    2.0 * sample.collisions as f64 / start.grains.len() as f64
}

const HEAD: [&str; 9] = [
    "method",
    "collisions",
    "energy [J]",
    "median [R]",
    "rms [R]",
    "max [R]",
    "follows to [s]",
    "cost [s]",
    "speed-up",
];

/// Prints the comparison: what each method got, what it cost, and what was out of the ordinary.
///
/// # Errors
/// An error of `sink`.
pub fn print(sink: &mut dyn Write, comparison: &Comparison) -> Result<()> {
    writeln!(sink, "{} ({} grains)", comparison.title, comparison.grains)?;
    let mut rows = vec![HEAD.map(str::to_owned).to_vec()];
    rows.extend(comparison.methods.iter().map(|summary| row(comparison, summary).to_vec()));
    write_aligned(sink, &rows, 1)?;
    notes(sink, comparison)
}

fn row(comparison: &Comparison, summary: &Summary) -> [String; 9] {
    let radius = comparison.mean_radius;
    let is_reference = summary.method == comparison.reference;
    let dash = || "-".to_owned();
    let [median, rms, max] = match summary.difference {
        Some(difference) if !is_reference => [difference.median, difference.rms, difference.max]
            .map(|length| format!("{:.1e}", length / radius)),
        _ => [dash(), dash(), dash()],
    };
    [
        summary.method.label().to_owned(),
        summary.collisions.to_string(),
        format!("{:.6}", summary.kinetic_energy),
        median,
        rms,
        max,
        match summary.followed_until {
            _ if is_reference => dash(),
            Some(time) => format!("{time:.3}"),
            None => format!("{:.3}+", comparison.reference_until),
        },
        seconds(summary.wall_seconds),
        summary.speed_up.filter(|_| !is_reference).map_or_else(dash, speed_up),
    ]
}

fn seconds(seconds: f64) -> String {
    if seconds < 0.01 { format!("{seconds:.1e}") } else { format!("{seconds:.3}") }
}

fn speed_up(factor: f64) -> String {
    if factor < 10.0 { format!("{factor:.2}") } else { format!("{factor:.0}") }
}

fn notes(sink: &mut dyn Write, comparison: &Comparison) -> Result<()> {
    let (reference, at) = (comparison.reference.label(), comparison.compared_at);
    writeln!(
        sink,
        "  median, rms, max: distance to where {reference} has the grain at t = {at:.4} s; grains in contact left out"
    )?;
    writeln!(
        sink,
        "  follows: until half of the grains are {FOLLOWING} R difference; speed-up: over MD (velocity Verlet)"
    )?;
    let end = comparison.methods.iter().map(|summary| summary.simulated).fold(0.0, f64::max);
    if comparison.reference_until < end {
        let until = comparison.reference_until;
        writeln!(
            sink,
            "  {reference} runs to t = {until} s only: collisions and energy are of then"
        )?;
    }
    for summary in &comparison.methods {
        let shown = ["rotation_refused", "interrupted", "clamped", "hard_sphere"];
        let list: Vec<String> = summary
            .statistics
            .iter()
            .filter(|(name, _)| shown.contains(name))
            .map(|(name, count)| format!("{} {count}", name.replace('_', " ")))
            .collect();
        if !list.is_empty() {
            writeln!(sink, "  {}: {}", summary.method.label(), list.join(", "))?;
        }
    }
    Ok(())
}

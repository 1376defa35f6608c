//! Do the methods agree, and what does each cost? Runs all from one start; writes nothing, returns the comparison.

mod apart;
mod terminal;

pub use apart::Apart;
pub use terminal::print;

use crate::method;
use crate::run::{self, Plan, Sample};
use crate::scenario::{MethodName, Scenario, Start};
use anyhow::{Result, bail};
use serde::Serialize;

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
    pub judge: MethodName,
    /// Where in the run `Summary::apart` is taken (s).
    pub compared_at: f64,
    /// How long the judge ran (s).
    pub judged_until: f64,
    /// One entry for each method, the judge first.
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
    /// Position differences from the judge at `Comparison::compared_at`.
    pub apart: Option<Apart>,
    /// The last sample at which it still followed the judge; nothing if it did to the judge's end.
    pub followed_until: Option<f64>,
    /// Collisions a grain until then, or until the judge's end.
    pub followed_collisions: f64,
    /// All counters at the end.
    pub counters: Vec<(&'static str, u64)>,
    /// The time series.
    pub series: Vec<Point>,
}

/// One sample of one method, compared with the judge.
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
    /// Position differences from the judge.
    pub apart: Option<Apart>,
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

/// Runs MD by velocity Verlet, eMD, eMD* and, as the judge, MD contact by contact, all from one
/// start and one after the other, so that the times can be compared. The judge comes first.
///
/// # Errors
/// What a method says; a law without a force.
pub fn tracks(scenario: &Scenario) -> Result<(Start, Vec<Track>)> {
    if matches!(scenario.law, crate::scenario::LawSpec::Constant { .. }) {
        bail!(
            "law.kind is constant: there is no force to compare with; lsd or viscoelastic is needed"
        );
    }
    if let Some(axis) = scenario.hard_walls() {
        bail!("box.{axis}: MD has no hard walls; soft ones are needed for a comparison");
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
    let Some(judge) = tracks.first() else { bail!("no method was run") };
    let verlet = tracks.iter().find(|track| track.method == MethodName::Md);
    let at = apart::where_to_look(start, judge);
    let one = |track: &Track| summary(start, judge, verlet, at, track);
    Ok(Comparison {
        title: scenario.title.clone(),
        grains: start.grains.len(),
        mean_radius: start.mean_radius(),
        judge: judge.method,
        judged_until: judge.samples.last().map_or(0.0, |sample| sample.time),
        compared_at: judge.samples.get(at).map_or(0.0, |sample| sample.time),
        methods: tracks.iter().map(one).collect(),
    })
}

fn summary(
    start: &Start,
    judge: &Track,
    verlet: Option<&Track>,
    at: usize,
    track: &Track,
) -> Summary {
    let series = apart::series(start, judge, track);
    let limit = FOLLOWING * start.mean_radius();
    let is_lost = |point: &Point| point.apart.is_some_and(|apart| apart.median > limit);
    let lost = series.iter().position(is_lost);
    let judged = series.iter().rposition(|point| point.apart.is_some()).unwrap_or(0);
    let last = series[lost.map_or(judged, |lost| lost.saturating_sub(1))];
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
        apart: series.get(at).and_then(|point| point.apart),
        followed_until: lost.map(|_| last.time),
        followed_collisions: last.collisions_per_grain,
        counters: track.samples.last().map(|s| s.counters.clone()).unwrap_or_default(),
        series,
    }
}

/// Simulated seconds a second.
fn speed(track: &Track) -> f64 {
    track.samples.last().map_or(0.0, |sample| sample.time) / track.wall_seconds
}

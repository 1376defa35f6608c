//! How high is a bouncing ball at which time? Reads the closed form and worlds with a plate at several heights; writes r(t) (BSFP14 Fig. 7, the drawing).

use super::ball::{GRAVITY, RESTITUTION, SIGMA, t_final};
use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::draw::{self, Kind, Mark, PlotStyle};
use crate::figure::number::significant;
use anyhow::{Context, Result};
use carom::law::HardSphere;
use carom::{Enduring, Grain, Memory, World};

/// Where the plate is: at an end and inside of the paper's range.
const PLATES: [f64; 3] = [0.0, 0.3, 1.0];
/// Points of a curve, until 5/4 of the time of rest.
const POINTS: u32 = 250;

/// r − r_plate in exact arithmetic.
///
/// ```
/// use carom_host::figure::bsfp14::{ball::t_final, path::exact};
/// assert_eq!(exact(0.0), 1.0);
/// assert_eq!(exact(t_final()), 0.5);
/// // The first impact is after a third of the time; the first hop is a quarter as high as the fall.
/// assert!((exact(t_final() / 3.0) - 0.5).abs() < 1e-15);
/// assert!((exact(0.5 * t_final()) - 0.625).abs() < 1e-15);
/// ```
pub fn exact(t: f64) -> f64 {
    let g = -GRAVITY;
    let first = (2.0 * (1.0 - SIGMA / 2.0) / g).sqrt();
    if t < first {
        return 1.0 - 0.5 * g * t * t;
    }
    let (mut speed, mut since) = (RESTITUTION * g * first, t - first);
    while speed > 1e-18 {
        let hop = 2.0 * speed / g;
        if since < hop {
            return SIGMA / 2.0 + since * (speed - 0.5 * g * since);
        }
        (speed, since) = (RESTITUTION * speed, since - hop);
    }
    SIGMA / 2.0
}

fn times() -> impl Iterator<Item = f64> {
    (0..=POINTS).map(|k| 1.25 * t_final() * f64::from(k) / f64::from(POINTS))
}

/// r − r_plate in a world of one grain.
fn in_world(plate: f64) -> Result<Vec<f64>> {
    let mut memory = Memory::<f64, 1, 1>::new();
    let mut world = World::builder(&mut memory)
        .enduring(Enduring::Paper)
        .hard_walls([[plate, plate + 10.0]], RESTITUTION)
        .gravity([GRAVITY])
        .rule(HardSphere { restitution: RESTITUTION })
        .grain(Grain::with_mass(SIGMA / 2.0, 1.0).at([plate + 1.0]))?
        .start()?;
    let mut at = |t: f64| {
        world.advance_to(t)?;
        Ok(world.grain(0).context("the ball")?.position[0] - plate)
    };
    times().map(&mut at).collect()
}

/// Makes the figure.
///
/// # Errors
/// An error of the engine.
pub fn make(_: &Options) -> Result<Made> {
    let mut figure = Figure::new("bsfp14-7-path", ["t (s)", "r - r_plate (σ)"]);
    let mut closed = Series::new("closed form").param("eps", RESTITUTION).param("g", -GRAVITY);
    times().for_each(|t| closed.push(t, exact(t)));
    let mut notes = vec![Note::new(
        "t_final = √(2 (1 − σ/2)/g) (1 + ε)/(1 − ε), with g = 9.81",
        "not given in numbers",
        significant(t_final(), 6),
    )];
    for plate in PLATES {
        let found = in_world(plate)?;
        let off = found.iter().zip(&closed.y).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let ours = format!("at most {off:.1e} from the closed form");
        notes.push(Note::new(format!("r(t), plate at {plate}"), "a drawing", ours));
        let mut series = Series::new(format!("engine, plate at {plate}")).param("plate", plate);
        times().zip(found).for_each(|(t, r)| series.push(t, r));
        figure = figure.with(series);
    }
    let figure = Figure { series: [vec![closed], figure.series].concat(), ..figure };
    let style = PlotStyle::new("A bouncing ball, σ = 1, ε = 0.5 (BSFP14 Fig. 7)")
        .labels("*t* [s]", "*r* − *r*_{plate} [σ]")
        .kinds(&[Kind::Line])
        .mark(Mark::Level(SIGMA / 2.0, "at rest".to_owned()))
        .mark(Mark::Place(t_final(), "t_{final}".to_owned()));
    let picture = draw::draw(&figure, &style);
    Ok(Made { figure, picture, notes })
}

//! How steep is the surface in a drum that turns? Turns rough disks of several μ; writes the mean slope of their surface.
//!
//! A drum is a polygon that turns about its centre, half full. Its disks flow down a surface that stays at a slope: then
//! the wall's torque holds the weight, which is off to the side. That the two agree is checked.

use crate::any_rule::AnyRule;
use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::figure::draw::{self, Kind, PlotStyle, Scale};
use crate::plot::Scene;
use crate::progress::Progress;
use anyhow::Result;
use carom::law::{HardSphere, Rough, Tangential};
use carom::space::{Facet, RigidMotion, Surface};
use carom::world::{Observer, Rotating, Transfer, WithContacts, WithObstacles};
use carom::{Grain, HeapMemory, View, World};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rayon::prelude::*;
use std::f64::consts::{PI, TAU};

/// Radius of the drum, in mean diameters d, and its sides.
const RADIUS: f64 = 13.0;
const SIDES: u32 = 96;
/// How many disks fill half of it.
const DISKS: usize = 270;
/// Radii are spread evenly by so much about the mean.
const SPREAD: f64 = 0.1;
const RESTITUTION: f64 = 0.5;
/// Fr = ω² R/g: the disks flow evenly, and the surface is straight.
const FROUDE: f64 = 5e-3;
/// As in the figure `faraday`: disks at rest overlap little.
const CONTACT_TIME: f64 = 0.1;
const STEPS: u32 = 16;
/// Instants in each turn at which the slope is looked at.
const LOOKS: u32 = 60;

/// A drum of disks with this μ.
///
/// # Units
///
/// Mean diameters d, the mass of a disk of that size, and gravity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drum {
    /// μ, of disks and wall.
    pub mu: f64,
    /// Turns before it is looked at, and with those in which it is.
    pub turns: [u32; 2],
    /// Of radii and velocities at the start.
    pub seed: u64,
}

/// What a drum was found to do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// Mean angle of the surface (degrees).
    pub angle: f64,
    /// Its standard error, from the means of the single turns.
    pub error: f64,
    /// The wall's mean torque over the weight's.
    pub balance: f64,
}

/// ω.
fn rate() -> f64 {
    (FROUDE / RADIUS).sqrt()
}

impl Drum {
    fn disks(&self) -> impl Iterator<Item = Grain<f64, 2>> + use<> {
        let mut rng = Pcg64::seed_from_u64(self.seed);
        let (step, rows) = (1.02 * (1.0 + SPREAD), 30_i32);
        let lattice = (-rows..rows).flat_map(move |row| (-rows..rows).map(move |k| [k, row]));
        let places = lattice.map(move |at| at.map(|k| f64::from(k) * step));
        let inside = places.filter(|[x, y]| x.hypot(*y) < RADIUS - 1.0);
        inside.take(DISKS).map(move |at| {
            let radius = 0.5 * rng.random_range(1.0 - SPREAD..1.0 + SPREAD);
            let velocity = std::array::from_fn(|_| rng.random_range(-0.01..0.01));
            Grain::with_mass(radius, 4.0 * radius * radius).at(at).moving(velocity)
        })
    }

    fn wall() -> impl Iterator<Item = Facet<f64, 2>> {
        let corner = |k: u32| {
            let (sin, cos) = (TAU * f64::from(k % SIDES) / f64::from(SIDES)).sin_cos();
            [RADIUS * cos, RADIUS * sin]
        };
        (0..SIDES).map(move |k| Facet::new([corner(k), corner(k + 1)], Surface::Rule).moving(0))
    }

    /// Turns it.
    ///
    /// # Errors
    /// An error of the engine.
    pub fn run(&self) -> Result<Slope> {
        let facets: Vec<_> = Self::wall().collect();
        let lists = vec![Default::default(); 34 * facets.len()];
        let motion = [RigidMotion::<f64, 2>::turning([0.0; 2], rate())];
        let places = HeapMemory::<f64, 2>::with_capacity(DISKS);
        let spins = Rotating::new(places, [(); 3].map(|()| vec![0.0; DISKS]));
        let contacts = WithContacts::new(spins, vec![Default::default(); 8 * DISKS]);
        let mut memory = WithObstacles::new(contacts, facets, lists).moving(motion);
        let law = Tangential::Walton { mu: self.mu, beta_0: 0.0 };
        let rule: AnyRule<'_> =
            Box::new(Rough::disks(HardSphere { restitution: RESTITUTION }, law));
        let mut world = World::builder(&mut memory)
            .gravity([0.0, -1.0])
            .contact_time(CONTACT_TIME)
            .steps_per_contact(STEPS)
            .rule(rule)
            .grains(self.disks())?
            .start()?;
        let [before, turns] = self.turns;
        let turn = TAU / rate();
        world.advance_to(f64::from(before) * turn)?;
        let (mut torque, mut seen) = (Torque::default(), Seen::default());
        for look in before * LOOKS + 1..=turns * LOOKS {
            world.advance_observed(f64::from(look) / f64::from(LOOKS) * turn, &mut torque)?;
            seen.add(&world.view());
        }
        let span = f64::from(turns - before) * turn;
        Ok(seen.slope(torque.0 / span))
    }
}

/// What the wall has given the disks about the drum's axis.
#[derive(Default)]
struct Torque(f64);

impl Observer<f64, 2> for Torque {
    fn transferred(&mut self, transfer: &Transfer<f64, 2>) {
        if transfer.partner.as_facet().is_none() {
            return;
        }
        // The contact is where the wall is, which is round: against the way from there to the disk.
        let (from, given) = (transfer.separation, transfer.impulse);
        let arm = from * (-RADIUS * (PI / f64::from(SIDES)).cos() / from.norm());
        self.0 += arm[0] * given[1] - arm[1] * given[0];
    }
}

/// Centres of mass that were seen, and the mass.
#[derive(Default)]
struct Seen {
    angles: Vec<f64>,
    aside: f64,
    mass: f64,
}

impl Seen {
    /// In a half-filled drum the centre of mass lies across the surface from the axis.
    fn add(&mut self, view: &View<'_, f64, 2>) {
        let disks = (0..view.len()).filter_map(|i| view.grain(i));
        let (mut moment, mut mass) = ([0.0; 2], 0.0);
        for disk in disks {
            mass += disk.mass;
            (0..2).for_each(|axis| moment[axis] += disk.mass * disk.position[axis]);
        }
        self.angles.push(moment[0].atan2(-moment[1]).to_degrees());
        self.aside += moment[0] / mass;
        self.mass = mass;
    }

    fn slope(&self, torque: f64) -> Slope {
        let mean = |of: &[f64]| of.iter().sum::<f64>() / of.len() as f64;
        let turns: Vec<f64> = self.angles.chunks(LOOKS as usize).map(mean).collect();
        let angle = mean(&turns);
        let squares = turns.iter().map(|turn| (turn - angle).powi(2)).sum::<f64>();
        let count = turns.len() as f64;
        let error = (squares / (count * (count - 1.0).max(1.0))).sqrt();
        let weight = self.mass * self.aside / self.angles.len() as f64;
        Slope { angle, error, balance: torque / weight }
    }
}

/// The μ of the figure.
const MU: [f64; 5] = [0.05, 0.1, 0.2, 0.4, 0.8];

/// Makes the figure.
///
/// # Errors
/// An error of the engine.
pub fn make(_: &Options) -> Result<Made> {
    let progress = Progress::new("drum", MU.len() as u64);
    let one = |&mu: &f64| {
        let slope = Drum { mu, turns: [1, 3], seed: 1 }.run();
        progress.add(1);
        Ok((mu, slope?))
    };
    let slopes: Vec<(f64, Slope)> = MU.par_iter().map(one).collect::<Result<_>>()?;
    let mut series = Series::new("rough disks").param("froude", FROUDE);
    for (mu, slope) in &slopes {
        series.push_with_error(*mu, slope.angle, slope.error);
    }
    let figure = Figure::new("drum", ["μ", "angle of the surface (degrees)"]).with(series);
    let picture = picture(&figure);
    let notes = slopes.iter().flat_map(|(mu, slope)| notes(*mu, slope)).collect();
    Ok(Made { figure, picture, notes })
}

fn picture(figure: &Figure) -> Scene {
    let style = PlotStyle::new("A drum of rough disks, half full, *ω*²*R*/*g* = 0.005")
        .labels("*μ*", "angle of the surface (degrees)")
        .scales(Scale::LINEAR.from(0.0, 1.05), Scale::LINEAR.from(0.0, 45.0))
        .kinds(&[Kind::Both]);
    draw::draw(figure, &style)
}

fn notes(mu: f64, slope: &Slope) -> [Note; 2] {
    let angle = format!("{:.1}° ± {:.1}°", slope.angle, slope.error);
    let balance = format!("{:.3}", slope.balance);
    [
        Note::new(format!("μ = {mu}: angle"), "not given", angle),
        Note::new(format!("μ = {mu}: torque of the wall over that of the weight"), "1", balance),
    ]
}

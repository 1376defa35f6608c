//! How do density, velocity and temperature change along an axis? Reads grains; writes sums over them for each part of the axis.

use super::blocks::Blocks;
use super::table::{Table, number};
use crate::scenario::{Axis, Flow, Placed, ProfileSpec, Side, Start, present};
use anyhow::{Context, Result, bail};
use std::f64::consts::PI;

/// An axis in equal parts.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    axis: usize,
    from: f64,
    width: f64,
    bins: usize,
    dimension: usize,
    species: Vec<String>,
    /// Of a cut through the box, if that is bounded.
    area: Option<f64>,
    /// The flow of a sheared box whose gradient is this axis: within a part of it velocities are as in its middle.
    flow: Option<Flow>,
    /// Where its sums begin.
    offset: usize,
}

const AXES: [&str; 3] = ["x", "y", "z"];

/// Grains, mass, volume, momentum and m v² along each axis.
const SUMS: usize = 9;
const MASS: usize = 1;
const VOLUME: usize = 2;
const MOMENTUM: usize = 3;
const SQUARE: usize = 6;

impl Profile {
    /// The profile of a system, its sums from `offset` on.
    ///
    /// # Errors
    /// When the axis is not one of the system, or has no beginning or no end.
    pub fn new(
        spec: &ProfileSpec,
        start: &Start,
        species: &[String],
        offset: usize,
    ) -> Result<Self> {
        let axis = match spec.axis {
            Axis::X => 0,
            Axis::Y => 1,
            Axis::Z => 2,
        };
        let name = AXES[axis];
        if axis >= start.dimension {
            bail!("observe.profile.axis is {name}, but dimension is {}", start.dimension);
        }
        let range = start.sides[axis].range();
        let lowest = match start.sides[axis] {
            Side::Plate(plate, _) => Some(plate.at - plate.amplitude.abs()),
            _ => range.map(|[from, _]| from),
        };
        let missing =
            |end| format!("observe.profile.{end}: box.{name} has no such end, give it [m]");
        let from = spec.from.or(lowest).with_context(|| missing("from"))?;
        let to = spec.to.or(range.map(|[_, to]| to)).with_context(|| missing("to"))?;
        if !(from < to && (to - from).is_finite()) {
            bail!("observe.profile: from is {from} and to is {to}, from must be the smaller");
        }
        let bins = spec.bins as usize;
        let others = (0..start.dimension).filter(|&other| other != axis);
        let length = |axis: usize| start.range(axis).map(|[from, to]| to - from);
        let area = others.map(length).try_fold(1.0, |area, length| Some(area * length?));
        let (dimension, species) = (start.dimension, species.to_vec());
        Ok(Self {
            axis,
            from,
            width: (to - from) / bins as f64,
            bins,
            dimension,
            species,
            area,
            flow: start.flow.filter(|flow| flow.gradient == axis),
            offset,
        })
    }

    /// How many sums there are.
    pub fn width(&self) -> usize {
        SUMS * self.bins * self.species.len()
    }

    fn place(&self, species: usize, bin: usize) -> usize {
        self.offset + SUMS * (species * self.bins + bin)
    }

    /// Adds a state. Grains beyond the ends belong to nothing.
    pub fn add(&self, sums: &mut [f64], grains: &[Placed], species: &[u16]) {
        for (k, grain) in present(grains) {
            let bin = ((grain.position[self.axis] - self.from) / self.width).floor();
            if !(bin >= 0.0 && bin < self.bins as f64) {
                continue;
            }
            let place = self.place(species.get(k).copied().map_or(0, usize::from), bin as usize);
            let middle = self.from + (bin + 0.5) * self.width;
            let mut velocity = grain.velocity;
            if let Some(flow) = &self.flow {
                velocity[flow.along] -= flow.rate * (grain.position[self.axis] - middle);
            }
            let sums = &mut sums[place..place + SUMS];
            sums[0] += 1.0;
            sums[MASS] += grain.mass;
            sums[VOLUME] += volume(grain.radius, self.dimension);
            for a in 0..self.dimension {
                sums[MOMENTUM + a] += grain.mass * velocity[a];
                sums[SQUARE + a] += grain.mass * velocity[a] * velocity[a];
            }
        }
    }

    /// The profile, each column followed by its standard error.
    pub fn table(&self, blocks: &Blocks, states: usize) -> Table {
        let columns: Vec<Curve> =
            (0..self.species.len()).flat_map(|s| self.curves(s, states)).collect();
        let mut heads = vec![format!("{} [m]", AXES[self.axis])];
        for curve in &columns {
            heads.extend([curve.head(""), curve.head(" error")]);
        }
        let mut table = Table::new("profile", 0, heads);
        for bin in 0..self.bins {
            let middle = self.from + (bin as f64 + 0.5) * self.width;
            let means = columns.iter().map(|curve| blocks.mean(|sums| (curve.value)(sums, bin)));
            let cells = means.flat_map(|mean| [mean.value, mean.error]);
            table.rows.push(std::iter::once(middle).chain(cells).map(number).collect());
        }
        table
    }

    fn curves(&self, species: usize, states: usize) -> Vec<Curve<'_>> {
        let of = if self.species.len() > 1 {
            format!(" ({})", self.species[species])
        } else {
            String::new()
        };
        let curve = |name: &str, unit, value| Curve { name: format!("{name}{of}"), unit, value };
        let at = move |bin| self.place(species, bin);
        let size = self.width * self.area.unwrap_or(1.0);
        let per = match (self.area, self.dimension) {
            (None, _) | (_, 1) => "1/m",
            (_, 2) => "1/m2",
            _ => "1/m3",
        };
        let mut curves = vec![curve(
            "number density",
            per,
            Box::new(move |sums: &[f64], bin| sums[at(bin)] / (sums[states] * size)) as Value<'_>,
        )];
        if self.area.is_some() {
            let value = move |sums: &[f64], bin| sums[at(bin) + VOLUME] / (sums[states] * size);
            curves.push(curve("packing fraction", "", Box::new(value)));
        }
        for a in 0..self.dimension {
            let axis = AXES[a];
            let velocity =
                move |sums: &[f64], bin| sums[at(bin) + MOMENTUM + a] / sums[at(bin) + MASS];
            curves.push(curve(&format!("velocity {axis}"), "m/s", Box::new(velocity)));
            let value = move |sums: &[f64], bin| temperature(&sums[at(bin)..], a);
            curves.push(curve(&format!("temperature {axis}"), "J", Box::new(value)));
        }
        let d = self.dimension;
        let mean = move |sums: &[f64], bin: usize| {
            (0..d).map(|a| temperature(&sums[at(bin)..], a)).sum::<f64>() / d as f64
        };
        curves.push(curve("temperature", "J", Box::new(mean)));
        curves
    }
}

/// m ⟨(v − ⟨v⟩)²⟩ along an axis, ⟨v⟩ over the same time.
fn temperature(sums: &[f64], axis: usize) -> f64 {
    let [square, momentum] = [sums[SQUARE + axis], sums[MOMENTUM + axis]];
    (square - momentum * momentum / sums[MASS]) / sums[0]
}

type Value<'a> = Box<dyn Fn(&[f64], usize) -> f64 + 'a>;

struct Curve<'a> {
    name: String,
    unit: &'static str,
    value: Value<'a>,
}

impl Curve<'_> {
    fn head(&self, what: &str) -> String {
        match self.unit {
            "" => format!("{}{what}", self.name),
            unit => format!("{}{what} [{unit}]", self.name),
        }
    }
}

/// What a grain fills: of a line, a plane or space.
fn volume(radius: f64, dimension: usize) -> f64 {
    match dimension {
        1 => 2.0 * radius,
        2 => PI * radius * radius,
        _ => 4.0 / 3.0 * PI * radius.powi(3),
    }
}

//! Which waves are on the surface of a layer? Reads grains; writes sums over the squares of the surface's Fourier modes.

use super::blocks::Blocks;
use super::quantities::{ALL, Quantity};
use super::table::{Table, number};
use crate::scenario::{HeightSpec, ModesSpec, Placed, Side, Start, present};
use anyhow::{Context, Result, bail, ensure};
use serde::{Deserialize, Serialize};
use std::collections::VecDeque;
use std::f64::consts::TAU;

/// The surface of a layer over the places into which the axes across are divided, and its modes.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    up: usize,
    /// The height of a place without grains.
    floor: f64,
    /// One axis or two; in two dimensions the second has one place.
    across: [Across; 2],
    height: HeightSpec,
    modes: Vec<Mode>,
    /// Looks in a cycle of what shakes the layer, if that is a whole number.
    cycle: Option<usize>,
    /// Where its sums begin.
    offset: usize,
}

/// An axis across, in equal parts.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Across {
    axis: usize,
    from: f64,
    length: f64,
    places: usize,
    is_periodic: bool,
}

/// A mode by its waves along both axes: whole ones where the box repeats, half ones between walls.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Mode {
    numbers: [i32; 2],
    wavelength: f64,
    /// From a sum over all places to an amplitude.
    scale: f64,
}

/// Real and imaginary part of each mode's amplitude.
type Amplitudes = Vec<[f64; 2]>;

/// The amplitudes at the last looks, as many as a cycle has.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Cycle(VecDeque<Amplitudes>);

/// Of each mode: its amplitude squared, and that of what changes sign from one cycle to the next.
const SUMS: usize = 2;
/// Grains in a place, if nothing else is said.
const GRAINS: f64 = 20.0;
/// More places than these along an axis are a slip of the pen.
const MAX_PLACES: f64 = 1_000.0;
const AXES: [&str; 3] = ["x", "y", "z"];

impl Surface {
    /// That of a system which is looked at so often, its sums from `offset` on.
    ///
    /// # Errors
    /// When there is no layer: no floor, or nothing that bounds it across.
    pub fn new(spec: &ModesSpec, start: &Start, every: f64, offset: usize) -> Result<Self> {
        let d = start.dimension;
        ensure!(d > 1, "observe.surface: dimension is 1, a surface needs 2 or 3");
        let up = spec.up.map(|axis| axis.number()).or_else(|| up(start)).context(
            "observe.surface.up: there is no plate and no gravity towards a lower wall, say which axis leads up",
        )?;
        ensure!(up < d, "observe.surface.up is {}, but dimension is {d}", AXES[up]);
        let floor = match start.sides[up] {
            Side::Plate(plate, _) => plate.at,
            Side::Walls([from, _], ..) => from,
            _ => {
                bail!("observe.surface.up is {0}, but box.{0} has no plate or lower wall", AXES[up])
            }
        };
        let across = across(spec, start, up)?;
        let modes = modes(&across);
        ensure!(
            !modes.is_empty(),
            "observe.surface.place: no axis has four places across it, must be smaller"
        );
        let cycle = frequency(&start.sides[up]).and_then(|frequency| looks(every, frequency));
        Ok(Self { up, floor, across, height: spec.height, modes, cycle, offset })
    }

    /// How many sums there are: of heights, of looks that a cycle lies behind, and of modes.
    pub fn width(&self) -> usize {
        2 + SUMS * self.modes.len()
    }

    fn place(&self, mode: usize) -> usize {
        self.offset + 2 + SUMS * mode
    }

    /// Adds a state.
    pub fn add(&self, sums: &mut [f64], cycle: &mut Cycle, grains: &[Placed]) {
        let heights = self.heights(grains);
        let now = self.amplitudes(&heights);
        sums[self.offset] += heights.iter().sum::<f64>() / heights.len() as f64;
        for (mode, [re, im]) in now.iter().enumerate() {
            sums[self.place(mode)] += re * re + im * im;
        }
        let Some(looks) = self.cycle else { return };
        if cycle.0.len() == looks
            && let Some(before) = cycle.0.pop_front()
        {
            sums[self.offset + 1] += 1.0;
            for (mode, (a, b)) in now.iter().zip(&before).enumerate() {
                let half = [0, 1].map(|part| 0.5 * (a[part] - b[part]));
                sums[self.place(mode) + 1] += half[0] * half[0] + half[1] * half[1];
            }
        }
        cycle.0.push_back(now);
    }

    /// The height of each place, those of one place of the second axis after each other.
    fn heights(&self, grains: &[Placed]) -> Vec<f64> {
        let [first, second] = &self.across;
        let mut members = vec![Vec::new(); first.places * second.places];
        for (_, grain) in present(grains) {
            let place = first.place(grain) + first.places * second.place(grain);
            members[place].push(grain.position[self.up]);
        }
        members.into_iter().map(|mut of_one| self.height(&mut of_one)).collect()
    }

    /// The height of a place with grains so high.
    fn height(&self, heights: &mut [f64]) -> f64 {
        if heights.is_empty() {
            return self.floor;
        }
        if self.height == HeightSpec::Mean {
            return heights.iter().sum::<f64>() / heights.len() as f64;
        }
        heights.sort_unstable_by(f64::total_cmp);
        // Of centres that fill a range evenly these are its top; who has been thrown far up hardly counts.
        2.0 * quantile(heights, 0.75) - quantile(heights, 0.5)
    }

    /// Of each mode, A of Re A exp(i k x) or A cos k x.
    fn amplitudes(&self, heights: &[f64]) -> Amplitudes {
        let [first, second] = &self.across;
        let amplitude = |mode: &Mode| {
            let waves = [first.wave(mode.numbers[0]), second.wave(mode.numbers[1])];
            let mut sum = [0.0; 2];
            for (row, b) in heights.chunks_exact(first.places).zip(&waves[1]) {
                let mut part = [0.0; 2];
                for (height, a) in row.iter().zip(&waves[0]) {
                    part = [part[0] + height * a[0], part[1] + height * a[1]];
                }
                sum[0] += part[0] * b[0] - part[1] * b[1];
                sum[1] += part[0] * b[1] + part[1] * b[0];
            }
            sum.map(|part| mode.scale * part)
        };
        self.modes.iter().map(amplitude).collect()
    }

    /// The mean height, the strongest mode, and the strongest of those that change sign from cycle to cycle.
    pub fn quantities(&self, states: usize) -> Vec<Quantity> {
        let offset = self.offset;
        let height = move |sums: &[f64]| sums[offset] / sums[states];
        let mut list = vec![Quantity::new("surface height", ALL, "m", height)];
        let kinds = [("", 0, states), (", half frequency", 1, offset + 1)];
        for (kind, part, count) in kinds.into_iter().take(1 + usize::from(self.cycle.is_some())) {
            let modes: Vec<(usize, f64)> = self
                .modes
                .iter()
                .enumerate()
                .map(|(k, mode)| (self.place(k) + part, mode.wavelength))
                .collect();
            let strongest = move |sums: &[f64]| {
                let all = modes.iter().map(|&(place, wavelength)| (sums[place], wavelength));
                all.max_by(|(a, _), (b, _)| a.total_cmp(b)).unwrap_or((f64::NAN, f64::NAN))
            };
            let again = strongest.clone();
            let amplitude = move |sums: &[f64]| (strongest(sums).0 / sums[count]).sqrt();
            list.push(Quantity::new(format!("surface mode amplitude{kind}"), ALL, "m", amplitude));
            let wavelength = move |sums: &[f64]| {
                let (square, wavelength) = again(sums);
                if square > 0.0 { wavelength } else { f64::NAN }
            };
            list.push(Quantity::new(
                format!("surface mode wavelength{kind}"),
                ALL,
                "m",
                wavelength,
            ));
        }
        list
    }

    /// All modes from the longest on, amplitudes followed by their standard errors.
    pub fn table(&self, blocks: &Blocks, states: usize) -> Table {
        let named = |across: &Across| format!("waves along {}", AXES[across.axis]);
        let mut heads = vec!["wavelength [m]".to_owned(), "amplitude [m]".to_owned()];
        heads.push("amplitude error [m]".to_owned());
        if self.cycle.is_some() {
            heads.push("amplitude of half frequency [m]".to_owned());
            heads.push("amplitude of half frequency error [m]".to_owned());
        }
        let axes = self.across.iter().filter(|across| across.length > 0.0);
        heads.extend(axes.clone().map(named));
        let mut table = Table::new("surface", 0, heads);
        let mut order: Vec<usize> = (0..self.modes.len()).collect();
        let longest = |k: &usize| self.modes[*k].wavelength;
        order.sort_by(|a, b| longest(b).total_cmp(&longest(a)));
        let counts = [states, self.offset + 1];
        for k in order {
            let place = self.place(k);
            let mut row = vec![number(self.modes[k].wavelength)];
            for (part, &count) in
                counts.iter().enumerate().take(1 + usize::from(self.cycle.is_some()))
            {
                let mean = blocks.mean(|sums| (sums[place + part] / sums[count]).sqrt());
                row.extend([mean.value, mean.error].map(number));
            }
            let waves = axes.clone().zip(self.modes[k].numbers);
            row.extend(waves.map(|(across, n)| number(across.waves(n))));
            table.rows.push(row);
        }
        table
    }
}

impl Across {
    /// An axis that is not there.
    const NONE: Self = Self { axis: 2, from: 0.0, length: 0.0, places: 1, is_periodic: false };

    fn place(&self, grain: &Placed) -> usize {
        if self.places == 1 {
            return 0;
        }
        let part = (grain.position[self.axis] - self.from) / self.length;
        ((part * self.places as f64).max(0.0) as usize).min(self.places - 1)
    }

    /// The largest number of a mode: none is shorter than four places.
    fn most(&self) -> i32 {
        let places = i32::try_from(self.places).unwrap_or(i32::MAX);
        match self.is_periodic {
            true => places / 4,
            false if places < 4 => 0,
            false => places / 2,
        }
    }

    /// How many waves of this number there are along the axis.
    fn waves(&self, number: i32) -> f64 {
        f64::from(number) * if self.is_periodic { 1.0 } else { 0.5 }
    }

    /// 2π over the wavelength.
    fn wave_number(&self, number: i32) -> f64 {
        if number == 0 { 0.0 } else { TAU * self.waves(number) / self.length }
    }

    /// exp(−i k x) in the middle of each place, or cos k x between walls, which have crests or troughs there.
    fn wave(&self, number: i32) -> Vec<[f64; 2]> {
        let at = |k: usize| {
            let turns = self.waves(number) * (k as f64 + 0.5) / self.places as f64;
            let imaginary = if self.is_periodic { -libm::sin(TAU * turns) } else { 0.0 };
            [libm::cos(TAU * turns), imaginary]
        };
        (0..self.places).map(at).collect()
    }
}

/// The axis that leads up from a floor: the plate's, or else that of gravity.
fn up(start: &Start) -> Option<usize> {
    let axes = 0..start.dimension;
    let plate = axes.clone().find(|axis| matches!(start.sides[*axis], Side::Plate(..)));
    let heaviest =
        axes.max_by(|a, b| start.gravity[*a].abs().total_cmp(&start.gravity[*b].abs()))?;
    plate.or_else(|| (start.gravity[heaviest] < 0.0).then_some(heaviest))
}

/// The axes across, in places.
fn across(spec: &ModesSpec, start: &Start, up: usize) -> Result<[Across; 2]> {
    let axes: Vec<usize> = (0..start.dimension).filter(|&axis| axis != up).collect();
    let mut lengths = Vec::new();
    for &axis in &axes {
        let range = start.range(axis).with_context(|| {
            let is = if start.sides[axis].range().is_some() {
                "has walls that go on"
            } else {
                "is open"
            };
            format!("observe.surface: box.{} {is}, must be periodic or walled", AXES[axis])
        })?;
        lengths.push(range);
    }
    let area: f64 = lengths.iter().map(|[from, to]| to - from).product();
    let natural = (area * GRAINS / start.grains.len().max(1) as f64).powf(1.0 / axes.len() as f64);
    let size = spec.place.unwrap_or(natural);
    ensure!(size > 0.0 && size.is_finite(), "observe.surface.place is {size}, must be above 0");
    let mut all = [Across::NONE; 2];
    for ((across, &axis), [from, to]) in all.iter_mut().zip(&axes).zip(lengths) {
        let places = ((to - from) / size).round().max(1.0);
        if places > MAX_PLACES {
            let least = (to - from) / MAX_PLACES;
            bail!(
                "observe.surface.place is {size:?}, must be at least {least:?}: {MAX_PLACES} places along box.{}",
                AXES[axis]
            );
        }
        let is_periodic = matches!(start.sides[axis], Side::Periodic(_));
        *across = Across { axis, from, length: to - from, places: places as usize, is_periodic };
    }
    Ok(all)
}

/// All modes that differ; the mean height is none.
fn modes(across: &[Across; 2]) -> Vec<Mode> {
    let [first, second] = across;
    // exp(i k x) and exp(−i k x) are one wave of a surface.
    let least = if first.is_periodic && second.is_periodic { -second.most() } else { 0 };
    let numbers = (0..=first.most())
        .flat_map(|a| (least..=second.most()).map(move |b| [a, b]))
        .filter(|&[a, b]| a > 0 || b > 0);
    let places = (first.places * second.places) as f64;
    let mode = |numbers: [i32; 2]| {
        let along = |k: usize| across[k].wave_number(numbers[k]);
        let both =
            |is_periodic: bool, k: usize| across[k].is_periodic == is_periodic && numbers[k] != 0;
        let walls = [0, 1].into_iter().filter(|&k| both(false, k)).count() as i32;
        let waves = i32::from(both(true, 0) || both(true, 1));
        let scale = f64::from(1 << (walls + waves)) / places;
        Mode { numbers, wavelength: TAU / libm::hypot(along(0), along(1)), scale }
    };
    numbers.map(mode).collect()
}

/// How often what bounds an axis vibrates in a second, if it does.
fn frequency(side: &Side) -> Option<f64> {
    let [amplitude, frequency] = match side {
        Side::Plate(plate, _) => [plate.amplitude, plate.frequency],
        Side::Walls(_, _, Some(shaking)) => [shaking.amplitude, shaking.frequency],
        _ => return None,
    };
    (amplitude != 0.0 && frequency > 0.0).then_some(frequency)
}

/// How many looks a cycle has, if that is a whole number.
fn looks(every: f64, frequency: f64) -> Option<usize> {
    let looks = 1.0 / (frequency * every);
    let whole = looks.round();
    ((1.0..=1e5).contains(&whole) && (looks / whole - 1.0).abs() < 1e-6).then_some(whole as usize)
}

/// Below which a part of them lies; they are in order.
fn quantile(sorted: &[f64], part: f64) -> f64 {
    let place = (part * sorted.len() as f64 - 0.5).clamp(0.0, (sorted.len() - 1) as f64);
    let low = place.floor() as usize;
    let high = (low + 1).min(sorted.len() - 1);
    sorted[low] + (place - low as f64) * (sorted[high] - sorted[low])
}

//! What was measured so far? Reads what collisions and states add; writes tables.

use super::blocks::{Blocks, Mean};
use super::correlations::{Correlations, Ways};
use super::layout::Layout;
use super::pair_distribution::PairDistribution;
use super::profile::Profile;
use super::quantities::{self, ALL, Quantity};
use super::state;
use super::surface::{Cycle, Surface};
use super::table::{Table, number};
use crate::columns::Cell;
use crate::scenario::{ObserveSpec, Placed, Scenario, Start};
use anyhow::Result;
use serde::{Deserialize, Serialize};

/// When the state is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Looks {
    /// The first (s).
    pub from: f64,
    /// Time between two (s).
    pub every: f64,
}

impl Looks {
    /// When a scenario asks for it.
    pub fn new(spec: &ObserveSpec, sample: f64) -> Self {
        Self { from: spec.from, every: spec.every.unwrap_or(sample) }
    }

    /// The instant of a look.
    pub fn instant(&self, number: u64) -> f64 {
        self.from + number as f64 * self.every
    }
}

/// Measures one method.
#[derive(Debug)]
pub struct Recorder {
    layout: Layout,
    /// When it looks.
    pub looks: Looks,
    profile: Option<Profile>,
    pairs: Option<PairDistribution>,
    correlations: Option<Correlations>,
    surface: Option<Surface>,
    width: usize,
    sums: Sums,
}

/// What was measured so far: all that a checkpoint needs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Sums {
    blocks: Blocks,
    /// The time of the first look and the last, if there was one.
    span: Option<[f64; 2]>,
    /// Looks after the first.
    looks: u64,
    ways: Ways,
    cycle: Cycle,
}

impl Sums {
    fn new(width: usize) -> Self {
        let (ways, cycle) = (Ways::default(), Cycle::default());
        Self { blocks: Blocks::new(width), span: None, looks: 0, ways, cycle }
    }
}

impl Recorder {
    /// Begins to measure, or goes on from what [`Recorder::save`] gave; none if nothing is asked for.
    ///
    /// # Errors
    /// What cannot be measured in this system; a state that is not of such a run.
    pub fn new(scenario: &Scenario, start: &Start, saved: Option<&[u8]>) -> Result<Option<Self>> {
        let Some(spec) = &scenario.observe else { return Ok(None) };
        let (layout, looks) = (Layout::new(start), Looks::new(spec, scenario.sample));
        let mut width = layout.width();
        let profile = spec.profile.as_ref();
        let profile = profile.map(|spec| Profile::new(spec, start, &layout.names, width));
        let profile = profile.transpose()?;
        width += profile.as_ref().map_or(0, Profile::width);
        let pairs = spec.pair_distribution.as_ref();
        let pairs = pairs.map(|spec| PairDistribution::new(spec, start, &layout, width));
        let pairs = pairs.transpose()?;
        width += pairs.as_ref().map_or(0, PairDistribution::width);
        let correlations = spec.correlations.as_ref();
        let correlations =
            correlations.map(|spec| Correlations::new(spec, start, looks.every, width));
        width += correlations.as_ref().map_or(0, Correlations::width);
        let surface = spec.surface.as_ref();
        let surface = surface.map(|spec| Surface::new(spec, start, looks.every, width));
        let surface = surface.transpose()?;
        width += surface.as_ref().map_or(0, Surface::width);
        let sums = match saved {
            Some(bytes) => postcard::from_bytes(bytes)?,
            None => Sums::new(width),
        };
        Ok(Some(Self { layout, looks, profile, pairs, correlations, surface, width, sums }))
    }

    /// All that was measured, as bytes.
    ///
    /// # Errors
    /// When there is no memory for them.
    pub fn save(&self) -> Result<Vec<u8>> {
        Ok(postcard::to_stdvec(&self.sums)?)
    }

    /// Looks at a method: what contacts gave since the last look, and the state now. The first look only
    /// begins.
    pub fn look(&mut self, time: f64, tally: &[f64], grains: &[Placed]) {
        let Some([from, to]) = self.sums.span else {
            self.sums.span = Some([time, time]);
            return;
        };
        self.sums.span = Some([from, time]);
        let mut sums = vec![0.0; self.width];
        sums.iter_mut().zip(tally).for_each(|(sum, more)| *sum = *more);
        sums[Layout::TIME] = if tally.is_empty() { 0.0 } else { time - to };
        state::add(&mut sums, &self.layout, grains);
        self.add_functions(&mut sums, grains, time);
        self.sums.looks += 1;
        self.sums.blocks.add(&sums);
    }

    fn add_functions(&mut self, sums: &mut [f64], grains: &[Placed], time: f64) {
        if let Some(profile) = &self.profile {
            profile.add(sums, grains, &self.layout.species);
        }
        let looks = self.sums.looks;
        if let Some(pairs) = self.pairs.as_ref().filter(|pairs| looks.is_multiple_of(pairs.one_in))
        {
            pairs.add(sums, grains, &self.layout, time);
        }
        if let Some(correlations) = &self.correlations {
            correlations.add(sums, &mut self.sums.ways, grains);
        }
        if let Some(surface) = &self.surface {
            surface.add(sums, &mut self.sums.cycle, grains);
        }
    }

    /// Every quantity with its mean, those left out that nothing was seen of.
    pub fn means(&self) -> Vec<(Quantity, Mean)> {
        let states = self.layout.states();
        let surface = self.surface.as_ref().map(|surface| surface.quantities(states));
        let all = quantities::all(&self.layout).into_iter().chain(self.diffusion());
        let all = all.chain(surface.into_iter().flatten());
        let with_mean = |quantity: Quantity| {
            let mean = self.sums.blocks.mean(|sums| quantity.of(sums));
            (quantity, mean)
        };
        all.map(with_mean).filter(|(_, mean)| mean.value.is_finite()).collect()
    }

    fn diffusion(&self) -> Option<Quantity> {
        let known = self.correlations.as_ref().filter(|_| self.sums.ways.unclear == 0)?;
        Some(Quantity::new("diffusion coefficient", ALL, "m2/s", known.diffusion()))
    }

    /// All tables; none if there was no span of time to measure.
    pub fn tables(&self) -> Vec<Table> {
        let Sums { blocks, ways, looks, .. } = &self.sums;
        if *looks == 0 {
            return Vec::new();
        }
        let profile = self.profile.as_ref().map(|p| p.table(blocks, self.layout.states()));
        let pairs = self.pairs.as_ref().map(|pairs| pairs.table(blocks));
        let correlations = self.correlations.as_ref().map(|c| c.table(blocks, ways));
        let surface = self.surface.as_ref().map(|s| s.table(blocks, self.layout.states()));
        let functions = [profile, pairs, correlations, surface];
        [self.averages(), self.series()]
            .into_iter()
            .chain(functions.into_iter().flatten())
            .collect()
    }

    /// Means over all of the time.
    fn averages(&self) -> Table {
        let heads = vec!["quantity", "of", "unit", "value", "standard error"];
        let mut table = Table::new("averages", 3, heads);
        let row = |(quantity, mean): (Quantity, Mean)| {
            let words = [quantity.name, quantity.of, quantity.unit.to_owned()].map(Cell::Text);
            let numbers = [mean.value, mean.error].map(number);
            words.into_iter().chain(numbers).collect()
        };
        table.rows = self.means().into_iter().map(row).collect();
        table
    }

    /// Means over the blocks, one after the other.
    fn series(&self) -> Table {
        let quantities: Vec<Quantity> = self.means().into_iter().map(|(q, _)| q).collect();
        let heads = ["from [s]".to_owned(), "to [s]".to_owned()];
        let heads =
            heads.into_iter().chain(quantities.iter().map(|quantity| quantity.head(""))).collect();
        let mut table = Table::new("blocks", 0, heads);
        let mut time = self.sums.span.map_or(0.0, |[from, _]| from);
        for block in self.sums.blocks.whole() {
            let to = time + block[self.layout.states()] * self.looks.every;
            let values = quantities.iter().map(|quantity| quantity.of(block));
            table.rows.push([time, to].into_iter().chain(values).map(number).collect());
            time = to;
        }
        table
    }
}

//! What becomes of a layer's surface, and which pattern is it? Runs a layer; writes the waves that change sign in every cycle.

use super::layer::{Layer, PHASES};
use super::surface::{Surface, Wave};
use anyhow::Result;
use std::ops::Range;

/// Cycles over which means are taken.
const LAST: usize = 8;

/// The surfaces of a layer, cycle by cycle.
#[derive(Clone, Debug)]
pub struct Course {
    /// Of which layer.
    pub layer: Layer,
    pub(super) cycles: Vec<[Surface; PHASES]>,
}

/// What is on a surface in the end: its highest wave, the same wave turned by a right angle, and the highest other one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pattern {
    /// The phase of the cycle at which it is highest.
    pub phase: usize,
    /// The first two waves.
    pub waves: [Wave; 2],
    /// The third one.
    pub other: Wave,
}

impl Course {
    /// Shakes a layer for so many cycles.
    ///
    /// # Errors
    /// An error of the engine.
    pub fn run(layer: Layer, cycles: usize, mut passed: impl FnMut()) -> Result<Self> {
        let mut seen = Vec::with_capacity(cycles);
        layer.run(cycles, |surfaces| {
            seen.push(surfaces);
            passed();
        })?;
        Ok(Self { layer, cycles: seen })
    }

    /// The mean surface at this phase, each cycle with its sign: only what changes sign in every cycle is left.
    fn changing(&self, phase: usize, cycles: Range<usize>) -> Surface {
        let mut mean = Surface::default();
        let share = 1.0 / cycles.len() as f64;
        for cycle in cycles {
            mean.add(&self.cycles[cycle][phase], if cycle % 2 == 0 { share } else { -share });
        }
        mean
    }

    /// What is on the surface in the last eight cycles; a course of fewer has nothing.
    pub fn pattern(&self) -> Pattern {
        let end = self.cycles.len();
        let one = |phase| {
            let surface = self.changing(phase, end.saturating_sub(LAST)..end);
            let all = surface.waves();
            let highest = all.first().copied().unwrap_or_default();
            let across = surface.wave(highest.across());
            let is_other = |wave: &&Wave| ![highest, across].iter().any(|one| one.is(wave));
            let other = all.iter().find(is_other).copied().unwrap_or_default();
            Pattern { phase, waves: [highest, across], other }
        };
        let patterns = (0..PHASES).map(one);
        let height = |pattern: &Pattern| pattern.waves[0].amplitude;
        let highest = patterns.max_by(|a, b| height(a).total_cmp(&height(b)));
        highest.unwrap_or_default()
    }

    /// How a wave grows: its amplitude over eight cycles after the other.
    pub(super) fn growth(&self, phase: usize, wave: Wave) -> Vec<[f64; 2]> {
        let ends = (LAST..=self.cycles.len()).step_by(LAST / 2);
        let one = |end| {
            let surface = self.changing(phase, end - LAST..end);
            [end as f64, surface.wave(wave.numbers).amplitude]
        };
        ends.map(one).collect()
    }

    /// Its surface in the last cycle.
    pub(super) fn last(&self, phase: usize) -> Surface {
        self.cycles.last().map_or_else(Surface::default, |surfaces| surfaces[phase].clone())
    }
}

impl Pattern {
    /// The wave across the highest one, and the highest other one, over the highest: 1 and 0 in squares, 0 and 0 in
    /// stripes, 0 and 1 in hexagons.
    pub fn ratios(&self) -> [f64; 2] {
        let [highest, across] = self.waves;
        [across, self.other].map(|wave| wave.amplitude / highest.amplitude)
    }

    pub(super) fn name(&self) -> &'static str {
        match self.ratios() {
            [across, other] if across > 0.6 && other < 0.4 => "squares",
            [across, other] if across.max(other) < 0.4 => "stripes",
            _ => "neither",
        }
    }
}

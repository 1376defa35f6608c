//! Which patterns are on a shaken layer, squares or stripes? Shakes two layers of rough spheres; writes their surfaces and how waves grow.

mod course;
mod layer;
mod picture;
mod surface;

pub use course::{Course, Pattern};
pub use layer::{FILLING, Layer, PHASES};
pub use surface::{Surface, Wave};

use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::progress::Progress;
use anyhow::Result;
use rayon::prelude::*;

/// The layers of the figure, and how many cycles of each. Sides are about one and two wavelengths: those of the
/// experiment's fit are 39 d and 23 d, and as in the figure `faraday` squares like to be an eighth shorter.
const LAYERS: [(Layer, usize); 2] = [
    (Layer { side: 33.0, frequency: 0.27, agitation: 3.0, seed: 1 }, 56),
    (Layer { side: 46.0, frequency: 0.44, agitation: 3.0, seed: 1 }, 40),
];

/// Makes the figure.
///
/// # Errors
/// An error of the engine.
pub fn make(_: &Options) -> Result<Made> {
    let all = LAYERS.iter().map(|(_, cycles)| *cycles as u64).sum();
    let progress = Progress::new("patterns", all);
    let one = |(layer, cycles): &(Layer, usize)| Course::run(*layer, *cycles, || progress.add(1));
    let courses: Vec<Course> = LAYERS.par_iter().map(one).collect::<Result<_>>()?;
    let found: Vec<(Course, Pattern)> =
        courses.into_iter().map(|c| (c.clone(), c.pattern())).collect();
    let figure = figure(&found);
    let picture = picture::draw(&found);
    let notes = found.iter().zip(["squares", "stripes"]).flat_map(notes).collect();
    Ok(Made { figure, picture, notes })
}

fn figure(found: &[(Course, Pattern)]) -> Figure {
    let mut figure = Figure::new("patterns", ["cycles", "half height of a wave (d)"]);
    for (course, pattern) in found {
        for (wave, which) in pattern.waves.iter().zip(["the highest", "across it"]) {
            let frequency = course.layer.frequency;
            let name = format!("f* = {frequency}: {which}");
            let mut series = Series::new(name).param("f*", frequency).param("wave", which);
            for [cycle, amplitude] in course.growth(pattern.phase, *wave) {
                series.push(cycle, amplitude);
            }
            figure = figure.with(series);
        }
    }
    figure
}

fn notes(((course, pattern), paper): (&(Course, Pattern), &str)) -> [Note; 2] {
    let at = format!("f* = {}", course.layer.frequency);
    let [first, second] = pattern.waves;
    let [highest, across, other] = [first, second, pattern.other].map(|wave| wave.amplitude);
    let heights = format!("{highest:.2} d, {across:.2} d, {other:.2} d");
    [
        Note::new(format!("{at}: pattern"), paper, pattern.name()),
        Note::new(format!("{at}: half heights of three waves"), "not given", heights),
    ]
}

//! How do the grains of a shaken layer flow? Shakes disks by MD and event by event; draws both velocity fields side by side, in two cycles.
//!
//! L94 (Sec. VI) leaves shaken layers in two dimensions and what they do inside to later work.

use super::shaken_disks::{Disks, Field, Flow, PHASES, PLACE, PLACES};
use crate::figure::data::{Figure, Made, Note, Options, Series};
use crate::plot::text::{Align, Style};
use crate::plot::{Axis, Colour, Panel, Rect, Scene, Stroke};
use crate::progress::Progress;
use anyhow::Result;
use tiny_skia::PathBuilder;

/// The layer of the figure.
pub const LAYER: Disks = Disks {
    grains: [46, 8],
    agitation: 3.0,
    frequency: 0.157,
    contact_time: 0.01,
    c_dis: 0.24,
    seed: 1,
};
/// Cycles before the field is looked at, and with it.
const CYCLES: [usize; 2] = [30, 70];
/// Seeds of the runs: how clean a run's wave is is chance.
const SEEDS: [u64; 4] = [1, 2, 3, 4];
/// Which of them is drawn: of both methods a wave that kept its place.
const DRAWN: usize = 1;
/// Steps a contact of MD.
const STEPS: f64 = 40.0;

/// A run's two fields at one phase, the first that of the cycles in which disks near the left wall move away from it.
#[derive(Clone, Debug)]
pub struct Pair {
    /// They.
    pub fields: [Field; 2],
}

/// Both runs at the phase at which disks move fastest across in MD.
///
/// # Errors
/// An error of a run.
pub fn run(layer: &Disks, cycles: [usize; 2]) -> Result<[Pair; 2]> {
    let progress = Progress::new("flow", 2);
    let done = |flow: Result<Flow>| {
        progress.add(1);
        flow
    };
    let (md, events) =
        rayon::join(|| done(layer.by_md(cycles, STEPS)), || done(layer.by_events(cycles)));
    let (md, events) = (md?, events?);
    let speed = |fields: &[Field; 2]| fields[0].across().iter().map(|v| v * v).sum::<f64>();
    let phase = (0..PHASES).max_by(|a, b| speed(&md[*a]).total_cmp(&speed(&md[*b]))).unwrap_or(0);
    Ok([&md, &events].map(|flow| ordered(&flow[phase])))
}

/// Whether a wave's first cycle is even or odd is chance.
fn ordered([even, odd]: &[Field; 2]) -> Pair {
    let leaves = |field: &Field| field.across().iter().take(PLACES[0] / 4).sum::<f64>();
    let fields = match leaves(even) > leaves(odd) {
        true => [even.clone(), odd.clone()],
        false => [odd.clone(), even.clone()],
    };
    Pair { fields }
}

/// How alike two velocity fields are: their correlation over the places that both have.
pub fn likeness(a: &Field, b: &Field) -> f64 {
    let both = (0..PLACES[0] * PLACES[1]).filter_map(|k| Some((a.velocity(k)?, b.velocity(k)?)));
    let all: Vec<(f64, f64)> = both.map(|(u, v)| (u[0], v[0])).collect();
    let sum = |of: fn(&(f64, f64)) -> f64| all.iter().map(of).sum::<f64>();
    sum(|(u, v)| u * v) / (sum(|(u, _)| u * u) * sum(|(_, v)| v * v)).sqrt()
}

/// Makes the figure.
///
/// # Errors
/// An error of a run.
pub fn make(_: &Options) -> Result<Made> {
    let runs = SEEDS.iter().map(|&seed| run(&Disks { seed, ..LAYER }, CYCLES));
    let runs = runs.collect::<Result<Vec<_>>>()?;
    let pairs = &runs[DRAWN];
    let names = ["MD", "event by event"];
    let mut figure = Figure::new("flow", ["x (d)", "mean horizontal velocity (√(g d))"]);
    for (name, pair) in names.iter().zip(pairs) {
        for (cycle, field) in ["a cycle", "the next"].iter().zip(&pair.fields) {
            let mut series = Series::new(format!("{name}, {cycle}")).param("method", *name);
            for (x, velocity) in field.across().iter().enumerate() {
                series.push((x as f64 + 0.5) * PLACE[0], *velocity);
            }
            figure = figure.with(series.param("cycle", *cycle));
        }
    }
    Ok(Made { figure, picture: picture(pairs), notes: notes(&runs) })
}

/// The largest mean velocity across, of both fields.
fn fastest(pair: &Pair) -> f64 {
    let most = |field: &Field| field.across().iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    0.5 * (most(&pair.fields[0]) + most(&pair.fields[1]))
}

/// Mean, its standard error, and each.
fn spread(values: &[f64]) -> String {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let square = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>();
    let error = (square / (count - 1.0) / count).sqrt();
    let each: Vec<_> = values.iter().map(|value| format!("{value:.2}")).collect();
    format!("{mean:.2} ± {error:.2} ({})", each.join(", "))
}

fn notes(runs: &[[Pair; 2]]) -> Vec<Note> {
    let note = |what: &str, of: fn(&Pair) -> f64, unit: &str| {
        let [md, events] = [0, 1].map(|method| {
            let values: Vec<_> = runs.iter().map(|pairs| of(&pairs[method])).collect();
            spread(&values)
        });
        Note::new(what, "not given", format!("MD {md}{unit}, events {events}{unit}"))
    };
    let next = |pair: &Pair| likeness(&pair.fields[0], &pair.fields[1]);
    vec![
        note("correlation of one cycle with the next", next, ""),
        note("largest mean velocity across", fastest, " √(g d)"),
    ]
}

const WIDTH: f64 = 300.0;
const HEIGHT: f64 = 100.0;
/// Points for a velocity of √(g d).
const ARROW: f64 = 22.0;

fn picture(pairs: &[Pair; 2]) -> Scene {
    let mut scene = Scene::new(2.0 * WIDTH + 118.0, 2.0 * HEIGHT + 142.0);
    let title = "A shaken layer of 368 disks, Γ = 3: velocities relative to the mean of all";
    scene.text([54.0, 18.0], title, Style::new(11.0, Colour::INK, Align::Left));
    arrow(&mut scene, [480.0, 15.0], [ARROW, 0.0], Colour::INK, None);
    let style = Style::new(9.5, Colour::INK, Align::Left);
    scene.text([512.0, 18.0], "(*g d*)^{1/2}", style);
    let names = ["MD", "event by event"];
    for (column, (pair, name)) in pairs.iter().zip(names).enumerate() {
        for (row, (field, cycle)) in pair.fields.iter().zip(["a cycle", "the next"]).enumerate() {
            let letter = [["a", "c"], ["b", "d"]][column][row];
            let place = Rect {
                x: 54.0 + (WIDTH + 50.0) * column as f64,
                y: 48.0 + (HEIGHT + 52.0) * row as f64,
                width: WIDTH,
                height: HEIGHT,
            };
            one(&mut scene, place, field, &format!("({letter}) {name}, {cycle}"));
        }
    }
    scene
}

fn one(scene: &mut Scene, place: Rect, field: &Field, title: &str) {
    let size = [0, 1].map(|axis| PLACES[axis] as f64 * PLACE[axis]);
    let panel = Panel { place, x: Axis::linear(0.0, size[0], 5), y: Axis::linear(0.0, size[1], 4) };
    for k in 0..PLACES[0] * PLACES[1] {
        let Some([across, up]) = field.velocity(k) else { continue };
        let [x, z] = [k % PLACES[0], k / PLACES[0]];
        let middle = panel.at((x as f64 + 0.5) * PLACE[0], (z as f64 + 0.5) * PLACE[1]);
        let colour = if across > 0.0 { Colour::BLUE } else { Colour::EMD };
        arrow(scene, middle, [ARROW * across, -ARROW * up], colour, Some(place));
    }
    panel.frame(scene);
    panel.labels(scene, "*x* / *d*", "height over the plate / *d*", 34.0);
    panel.title(scene, title);
}

/// An arrow from a point; the head shrinks with it.
fn arrow(scene: &mut Scene, [x, y]: [f64; 2], by: [f64; 2], colour: Colour, clip: Option<Rect>) {
    let length = libm::hypot(by[0], by[1]);
    if length < 0.3 {
        return;
    }
    let head = (0.4 * length).min(4.0);
    let [ex, ey] = by.map(|part| part / length);
    let neck = [x + by[0] - ex * head, y + by[1] - ey * head];
    scene.line(&[[x, y], neck], Stroke::solid(colour, 0.9), clip);
    let mut path = PathBuilder::new();
    let tip = [x + by[0], y + by[1]];
    path.move_to(tip[0] as f32, tip[1] as f32);
    for side in [0.4 * head, -0.4 * head] {
        path.line_to((neck[0] - ey * side) as f32, (neck[1] + ex * side) as f32);
    }
    path.close();
    scene.shape(path.finish(), Some(colour), None, clip);
}

//! How do the data of a figure become a picture? Reads a figure and how it is to look; writes a scene.
//!
//! Lines, dots, error bars, a legend to the right, and the paper's numbers as grey dashed lines or open squares.

mod beside;
mod look;

pub use beside::beside;
pub use look::{Kind, Look, Mark, Scale};

use super::{Figure, Series};
use crate::plot::colour::INK;
use crate::plot::text::{self, Align, Style};
use crate::plot::{Axis, Colour, Panel, Rect, Scene, Stroke};

const GREY: Colour = Colour::rgb(0x88, 0x88, 0x88);
const MARKED: Stroke = Stroke::dashed(GREY, 1.2, 5.0, 3.0);
const DOT: f64 = 2.6;
const PLACE: Rect = Rect { x: 66.0, y: 36.0, width: 350.0, height: 270.0 };

/// Draws a figure.
pub fn draw(figure: &Figure, look: &Look) -> Scene {
    let legend = legend_width(figure, look);
    let title = PLACE.x + text::width(&look.title, 11.0) + 16.0;
    let mut scene = Scene::new((PLACE.x + PLACE.width + 20.0 + legend).max(title), 354.0);
    scene.text([PLACE.x, 20.0], &look.title, Style::new(11.0, INK, Align::Left));
    let panel = Panel { place: PLACE, x: axis(figure, look, 0), y: axis(figure, look, 1) };
    for mark in &look.marks {
        show_mark(&mut scene, &panel, mark);
    }
    for (number, series) in figure.series.iter().enumerate() {
        curve(&mut scene, &panel, series, look.kind(number), look.colour(number));
    }
    panel.frame(&mut scene);
    let [x, y] = look.labels.clone().unwrap_or([figure.axes.x.clone(), figure.axes.y.clone()]);
    panel.labels(&mut scene, &x, &y, 46.0);
    entries(&mut scene, figure, look);
    scene
}

/// The axis in direction 0 or 1, fitted to the data and marks if it is not given.
fn axis(figure: &Figure, look: &Look, direction: usize) -> Axis {
    let scale = [look.x, look.y][direction];
    let [low, high] = scale.range.unwrap_or_else(|| {
        let all = figure.series.iter().flat_map(|s| reach(s, direction));
        let marks = look.marks.iter().flat_map(|mark| mark.reach(direction));
        let seen = |x: &f64| x.is_finite() && (!scale.logarithmic || *x > 0.0);
        let ends = [f64::INFINITY, f64::NEG_INFINITY];
        let ends =
            all.chain(marks).filter(seen).fold(ends, |[low, high], x| [low.min(x), high.max(x)]);
        if scale.logarithmic { decades(ends) } else { margins(ends) }
    });
    if scale.logarithmic { Axis::logarithmic(low, high) } else { Axis::linear(low, high, 6) }
}

/// What a curve reaches, with its error bars.
fn reach(series: &Series, direction: usize) -> Vec<f64> {
    let Series { x, y, yerr, .. } = series;
    if direction == 0 {
        return x.clone();
    }
    let error = |i: usize| yerr.get(i).copied().unwrap_or(0.0);
    y.iter().enumerate().flat_map(|(i, y)| [*y, y - error(i), y + error(i)]).collect()
}

fn margins([low, high]: [f64; 2]) -> [f64; 2] {
    if !(low <= high) {
        return [0.0, 1.0];
    }
    let margin = if high > low { 0.05 * (high - low) } else { 0.5 * low.abs().max(1.0) };
    [low - margin, high + margin]
}

/// A range with at least two powers of ten in it.
fn decades([low, high]: [f64; 2]) -> [f64; 2] {
    if !(low <= high) {
        return [0.1, 10.0];
    }
    let [low, high] = [low / 1.4, high * 1.4];
    if high.log10().floor() - low.log10().ceil() >= 1.0 {
        return [low, high];
    }
    [10f64.powf(low.log10().floor()), 10f64.powf(high.log10().ceil())]
}

fn curve(scene: &mut Scene, panel: &Panel, series: &Series, kind: Kind, colour: Colour) {
    let points: Vec<_> = series.x.iter().zip(&series.y).map(|(x, y)| [*x, *y]).collect();
    if kind != Kind::Dots {
        panel.line(scene, &points, Stroke::solid(colour, 1.5));
    }
    for ([x, y], error) in points.iter().zip(&series.yerr) {
        bar(scene, panel, *x, [y - error, y + error], Stroke::solid(colour, 1.0));
    }
    if kind != Kind::Line {
        points.iter().for_each(|[x, y]| panel.dot(scene, *x, *y, DOT, colour));
    }
}

/// An error bar with its caps. Where its lower end is not on a logarithmic axis, it ends at the frame.
fn bar(scene: &mut Scene, panel: &Panel, x: f64, [low, high]: [f64; 2], pen: Stroke) {
    let Rect { y: top, height, .. } = panel.place;
    let place = Some(panel.place);
    let [across, above] = panel.at(x, high);
    let below = Some(panel.at(x, low)[1]).filter(|y| y.is_finite()).unwrap_or(top + height);
    scene.line(&[[across, below], [across, above]], pen, place);
    for y in [below, above] {
        scene.line(&[[across - 2.5, y], [across + 2.5, y]], pen, place);
    }
}

fn show_mark(scene: &mut Scene, panel: &Panel, mark: &Mark) {
    let Rect { x, y, width, height } = panel.place;
    match mark {
        Mark::Level(level, _) => {
            let at = y + height * (1.0 - panel.y.fraction(*level));
            scene.line(&[[x, at], [x + width, at]], MARKED, Some(panel.place));
        }
        Mark::Place(place, _) => {
            let at = x + width * panel.x.fraction(*place);
            scene.line(&[[at, y], [at, y + height]], MARKED, Some(panel.place));
        }
        Mark::Curve(points, _) => panel.line(scene, points, MARKED),
        Mark::Points(points, _) => {
            points.iter().for_each(|[x, y]| square(scene, panel.at(*x, *y)));
        }
    }
}

fn square(scene: &mut Scene, [x, y]: [f64; 2]) {
    let side = 7.5;
    let place = Rect { x: x - side / 2.0, y: y - side / 2.0, width: side, height: side };
    scene.rectangle(place, None, Some(Stroke::solid(GREY, 1.3)));
}

const NAME: f64 = 9.5;

/// A name as a legend shows it: its asterisks are letters, not marks; an underscore lowers one letter.
fn plain(name: &str) -> String {
    let mut text = String::new();
    let mut letters = name.chars();
    while let Some(letter) = letters.next() {
        match letter {
            '*' => text.push('∗'),
            '_' => text.extend(["_{", &String::from_iter(letters.next()), "}"]),
            other => text.push(other),
        }
    }
    text
}

fn legend_width(figure: &Figure, look: &Look) -> f64 {
    let names = figure.series.iter().map(|series| plain(&series.name));
    let names = names.chain(look.marks.iter().map(|mark| mark.name().to_owned()));
    names.map(|name| text::width(&name, NAME)).fold(0.0, f64::max) + 40.0
}

/// The legend: a sample of each curve and mark, and its name.
fn entries(scene: &mut Scene, figure: &Figure, look: &Look) {
    let left = PLACE.x + PLACE.width + 14.0;
    let mut y = PLACE.y + 8.0;
    let mut entry = |scene: &mut Scene, name: &str, pen: Option<Stroke>, dot: Option<Colour>| {
        if let Some(pen) = pen {
            scene.line(&[[left, y], [left + 20.0, y]], pen, None);
        }
        if let Some(colour) = dot {
            scene.disc([left + 10.0, y], DOT, Some(colour), None, None);
        }
        if pen.is_none() && dot.is_none() {
            square(scene, [left + 10.0, y]);
        }
        scene.text([left + 26.0, y + 3.4], name, Style::new(NAME, INK, Align::Left));
        y += 14.5;
    };
    for (number, series) in figure.series.iter().enumerate() {
        let (kind, colour) = (look.kind(number), look.colour(number));
        let pen = (kind != Kind::Dots).then(|| Stroke::solid(colour, 1.5));
        entry(scene, &plain(&series.name), pen, (kind != Kind::Line).then_some(colour));
    }
    for mark in look.marks.iter().filter(|mark| !mark.name().is_empty()) {
        let pen = (!matches!(mark, Mark::Points(..))).then_some(MARKED);
        entry(scene, mark.name(), pen, None);
    }
}

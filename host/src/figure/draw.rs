//! How do the data of a figure become a picture? Reads a figure and its style; writes a scene.
//!
//! Lines, dots, error bars, a legend to the right, and the paper's numbers as grey dashed lines or open squares.

use super::data::{Figure, Series};
pub use super::style::{Kind, Mark, PlotStyle, Scale};
use crate::plot::text::{self, Align, Style};
use crate::plot::{Axis, Colour, Item, Panel, Rect, Scene, Stroke};
use tiny_skia::Transform;

const GREY: Colour = Colour::rgb(0x88, 0x88, 0x88);
const MARKED: Stroke = Stroke::dashed(GREY, 1.2, 5.0, 3.0);
const PLACE: Rect = Rect { x: 66.0, y: 36.0, width: 350.0, height: 270.0 };

/// Draws a figure.
pub fn draw(figure: &Figure, style: &PlotStyle) -> Scene {
    let legend = legend_width(figure, style);
    let title = PLACE.x + text::width(&style.title, 11.0) + 16.0;
    let mut scene = Scene::new((PLACE.x + PLACE.width + 20.0 + legend).max(title), 354.0);
    scene.text([PLACE.x, 20.0], &style.title, Style::new(11.0, Colour::INK, Align::Left));
    let panel = Panel { place: PLACE, x: axis(figure, style, 0), y: axis(figure, style, 1) };
    for mark in &style.marks {
        show_mark(&mut scene, &panel, mark);
    }
    for (number, series) in figure.series.iter().enumerate() {
        curve(&mut scene, &panel, series, style, number);
    }
    panel.frame(&mut scene);
    let [x, y] = style.labels.clone().unwrap_or([figure.axes.x.clone(), figure.axes.y.clone()]);
    panel.labels(&mut scene, &x, &y, 46.0);
    entries(&mut scene, figure, style);
    scene
}

/// The axis in direction 0 or 1, fitted to the data and marks if it is not given.
fn axis(figure: &Figure, style: &PlotStyle, direction: usize) -> Axis {
    let scale = [style.x, style.y][direction];
    let [low, high] = scale.range.unwrap_or_else(|| {
        let all = figure.series.iter().flat_map(|s| values(s, direction, scale.logarithmic));
        let marks = style.marks.iter().flat_map(|mark| mark.values(direction));
        let seen = |x: &f64| x.is_finite() && (!scale.logarithmic || *x > 0.0);
        let ends = [f64::INFINITY, f64::NEG_INFINITY];
        let ends =
            all.chain(marks).filter(seen).fold(ends, |[low, high], x| [low.min(x), high.max(x)]);
        if scale.logarithmic { decades(ends) } else { margins(ends) }
    });
    if scale.logarithmic { Axis::logarithmic(low, high) } else { Axis::linear(low, high, 6) }
}

/// What a curve reaches, with its error bars.
fn values(series: &Series, direction: usize, logarithmic: bool) -> Vec<f64> {
    let Series { x, y, yerr, .. } = series;
    if direction == 0 {
        return x.clone();
    }
    let error = |i: usize| yerr.get(i).copied().unwrap_or(0.0);
    let reach = |(i, y): (usize, &f64)| {
        let [low, high] = [y - error(i), y + error(i)];
        [*y, if logarithmic { low.max(y / OPEN) } else { low }, high]
    };
    y.iter().enumerate().flat_map(reach).collect()
}

/// An error bar on a logarithmic axis goes down to this part of the value at most.
const OPEN: f64 = 3.0;

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

fn curve(scene: &mut Scene, panel: &Panel, series: &Series, style: &PlotStyle, number: usize) {
    let (kind, pen) = (style.kind(number), style.pen(number));
    let points: Vec<_> = series.x.iter().zip(&series.y).map(|(x, y)| [*x, *y]).collect();
    if kind != Kind::Dots {
        panel.line(scene, &points, pen);
    }
    for ([x, y], error) in points.iter().zip(&series.yerr) {
        bar(scene, panel, [*x, *y], *error, Stroke::solid(pen.colour, 1.0));
    }
    if kind != Kind::Line {
        let place = Some(panel.place);
        points.iter().for_each(|[x, y]| marker(scene, panel.at(*x, *y), number, pen.colour, place));
    }
}

/// An error bar with its caps. On a logarithmic axis it is open below where it would reach a third of the value.
fn bar(scene: &mut Scene, panel: &Panel, [x, y]: [f64; 2], error: f64, pen: Stroke) {
    let open = panel.y.is_logarithmic() && y - error < y / OPEN;
    let low = if open { y / OPEN } else { y - error };
    let place = Some(panel.place);
    let ([across, above], [_, below]) = (panel.at(x, y + error), panel.at(x, low));
    scene.line(&[[across, below], [across, above]], pen, place);
    for y in [above, below].into_iter().take(if open { 1 } else { 2 }) {
        scene.line(&[[across - 2.5, y], [across + 2.5, y]], pen, place);
    }
}

/// The mark of a point: the first curve's is full, the others' are open and of another form each, so that none hides another.
fn marker(scene: &mut Scene, at: [f64; 2], number: usize, tone: Colour, clip: Option<Rect>) {
    let pen = Stroke::solid(tone, 1.1);
    let corners: &[[f64; 2]] = match number % 5 {
        0 => return scene.disc(at, 2.3, Some(tone), None, clip),
        1 => &[[-2.9, -2.9], [2.9, -2.9], [2.9, 2.9], [-2.9, 2.9], [-2.9, -2.9], [2.9, -2.9]],
        2 => &[[-3.6, 2.6], [3.6, 2.6], [0.0, -3.8], [-3.6, 2.6], [3.6, 2.6]],
        3 => &[[0.0, -4.2], [4.2, 0.0], [0.0, 4.2], [-4.2, 0.0], [0.0, -4.2], [4.2, 0.0]],
        _ => &[[-3.2, -3.2], [3.2, 3.2], [f64::NAN; 2], [-3.2, 3.2], [3.2, -3.2]],
    };
    let outline: Vec<_> = corners.iter().map(|[x, y]| [at[0] + x, at[1] + y]).collect();
    scene.line(&outline, pen, clip);
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

fn legend_width(figure: &Figure, style: &PlotStyle) -> f64 {
    let names = figure.series.iter().map(|series| plain(&series.name));
    let names = names.chain(style.marks.iter().map(|mark| mark.name().to_owned()));
    names.map(|name| text::width(&name, NAME)).fold(0.0, f64::max) + 40.0
}

/// The legend: a sample of each curve and mark, and its name.
fn entries(scene: &mut Scene, figure: &Figure, style: &PlotStyle) {
    let left = PLACE.x + PLACE.width + 14.0;
    let mut y = PLACE.y + 8.0;
    let mut named = |scene: &mut Scene, name: &str, pen: Option<Stroke>| {
        if let Some(pen) = pen {
            scene.line(&[[left, y], [left + 22.0, y]], pen, None);
        }
        let letters = Style::new(NAME, Colour::INK, Align::Left);
        scene.text([left + 28.0, y + 3.4], name, letters);
        y += 14.5;
        [left + 11.0, y - 14.5]
    };
    for (number, series) in figure.series.iter().enumerate() {
        let (kind, pen) = (style.kind(number), style.pen(number));
        let at = named(scene, &plain(&series.name), (kind != Kind::Dots).then_some(pen));
        if kind != Kind::Line {
            marker(scene, at, number, pen.colour, None);
        }
    }
    for mark in style.marks.iter().filter(|mark| !mark.name().is_empty()) {
        let points = matches!(mark, Mark::Points(..));
        let at = named(scene, mark.name(), (!points).then_some(MARKED));
        if points {
            square(scene, at);
        }
    }
}

/// Puts the second picture to the right of the first.
pub fn beside(first: Scene, second: Scene) -> Scene {
    let by = [first.width, 0.0];
    put(first, second, by)
}

/// Puts the second picture under the first.
pub fn below(first: Scene, second: Scene) -> Scene {
    let by = [0.0, first.height];
    put(first, second, by)
}

/// Puts the second picture on the page of the first, so far to the right and down.
fn put(first: Scene, second: Scene, [x, y]: [f64; 2]) -> Scene {
    let moved = |rect: Rect| Rect { x: rect.x + x, y: rect.y + y, ..rect };
    let shift = Transform::from_translate(x as f32, y as f32);
    let mut page =
        Scene::new(first.width.max(x + second.width), first.height.max(y + second.height));
    page.items = first.items;
    page.items.extend(second.items.into_iter().filter_map(|item| match item {
        Item::Shape { path, fill, stroke, clip } => {
            let path = path.transform(shift)?;
            Some(Item::Shape { path, fill, stroke, clip: clip.map(moved) })
        }
        Item::Letters { path, colour, at, upright, runs } => {
            let path = path.transform(shift)?;
            Some(Item::Letters { path, colour, at: [at[0] + x, at[1] + y], upright, runs })
        }
        Item::Pixels { place, size, rgba } => {
            Some(Item::Pixels { place: moved(place), size, rgba })
        }
    }));
    page
}

//! How do the data of a figure become a picture? Reads a figure and its style; writes a scene.
//!
//! Lines, dots, error bars, a legend to the right, and the paper's numbers as grey dashed lines or open squares.

use super::data::{Figure, Series};
use crate::plot::text::{self, Align, Style};
use crate::plot::{Axis, Colour, Item, Panel, Rect, Scene, Stroke};
use tiny_skia::Transform;

const GREY: Colour = Colour::rgb(0x88, 0x88, 0x88);
const MARKED: Stroke = Stroke::dashed(GREY, 1.2, 5.0, 3.0);
const DOT: f64 = 2.6;
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
        curve(&mut scene, &panel, series, style.kind(number), style.colour(number));
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
        let all = figure.series.iter().flat_map(|s| values(s, direction));
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
fn values(series: &Series, direction: usize) -> Vec<f64> {
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

fn legend_width(figure: &Figure, style: &PlotStyle) -> f64 {
    let names = figure.series.iter().map(|series| plain(&series.name));
    let names = names.chain(style.marks.iter().map(|mark| mark.name().to_owned()));
    names.map(|name| text::width(&name, NAME)).fold(0.0, f64::max) + 40.0
}

/// The legend: a sample of each curve and mark, and its name.
fn entries(scene: &mut Scene, figure: &Figure, style: &PlotStyle) {
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
        scene.text([left + 26.0, y + 3.4], name, Style::new(NAME, Colour::INK, Align::Left));
        y += 14.5;
    };
    for (number, series) in figure.series.iter().enumerate() {
        let (kind, colour) = (style.kind(number), style.colour(number));
        let pen = (kind != Kind::Dots).then(|| Stroke::solid(colour, 1.5));
        entry(scene, &plain(&series.name), pen, (kind != Kind::Line).then_some(colour));
    }
    for mark in style.marks.iter().filter(|mark| !mark.name().is_empty()) {
        let pen = (!matches!(mark, Mark::Points(..))).then_some(MARKED);
        entry(scene, mark.name(), pen, None);
    }
}

/// How an axis is divided.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// Equal steps are equal factors.
    pub logarithmic: bool,
    /// From where to where; none to fit the data.
    pub range: Option<[f64; 2]>,
}

impl Scale {
    /// Equal steps, fitted to the data.
    pub const LINEAR: Self = Self { logarithmic: false, range: None };
    /// Equal factors, fitted to the data.
    pub const LOG: Self = Self { logarithmic: true, range: None };

    /// The same over a given range.
    #[must_use]
    pub const fn from(self, low: f64, high: f64) -> Self {
        Self { range: Some([low, high]), ..self }
    }
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A line without dots.
    Line,
    /// Dots without a line.
    Dots,
    /// Both.
    Both,
}

/// Something of the paper's, to compare with; drawn in grey.
#[derive(Clone, Debug)]
pub enum Mark {
    /// A level: a dashed line across.
    Level(f64, String),
    /// A place: a dashed line upwards.
    Place(f64, String),
    /// A curve: dashed.
    Curve(Vec<[f64; 2]>, String),
    /// Points: open squares.
    Points(Vec<[f64; 2]>, String),
}

/// How a figure is drawn. Texts take the marks of [`crate::plot::text`].
#[derive(Clone, Debug)]
pub struct PlotStyle {
    /// Over the picture.
    pub title: String,
    /// What stands along the axes, if it differs from the figure's own labels.
    pub labels: Option<[String; 2]>,
    /// From left to right.
    pub x: Scale,
    /// From bottom to top.
    pub y: Scale,
    /// How the curves are drawn, by their number; the last holds for those that follow.
    pub kinds: Vec<Kind>,
    /// The curves' colours, by their number; a palette serves those that follow.
    pub colours: Vec<Colour>,
    /// The paper's numbers.
    pub marks: Vec<Mark>,
}

impl PlotStyle {
    /// Lines with dots on linear axes.
    pub fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            labels: None,
            x: Scale::LINEAR,
            y: Scale::LINEAR,
            kinds: vec![Kind::Both],
            colours: Vec::new(),
            marks: Vec::new(),
        }
    }

    /// The same with other words along the axes.
    #[must_use]
    pub fn labels(self, x: &str, y: &str) -> Self {
        Self { labels: Some([x.to_owned(), y.to_owned()]), ..self }
    }

    /// The same on other axes.
    #[must_use]
    pub fn scales(self, x: Scale, y: Scale) -> Self {
        Self { x, y, ..self }
    }

    /// The same with curves drawn so.
    #[must_use]
    pub fn kinds(self, kinds: &[Kind]) -> Self {
        Self { kinds: kinds.to_vec(), ..self }
    }

    /// The same with one more of the paper's numbers.
    #[must_use]
    pub fn mark(mut self, mark: Mark) -> Self {
        self.marks.push(mark);
        self
    }

    fn kind(&self, number: usize) -> Kind {
        self.kinds.get(number).or(self.kinds.last()).copied().unwrap_or(Kind::Both)
    }

    fn colour(&self, number: usize) -> Colour {
        let others = number.saturating_sub(self.colours.len());
        self.colours.get(number).copied().unwrap_or(PALETTE[others % PALETTE.len()])
    }
}

impl Mark {
    fn name(&self) -> &str {
        match self {
            Self::Level(_, name)
            | Self::Place(_, name)
            | Self::Curve(_, name)
            | Self::Points(_, name) => name,
        }
    }

    fn values(&self, direction: usize) -> Vec<f64> {
        match self {
            Self::Level(y, _) if direction == 1 => vec![*y],
            Self::Place(x, _) if direction == 0 => vec![*x],
            Self::Level(..) | Self::Place(..) => Vec::new(),
            Self::Curve(points, _) | Self::Points(points, _) => {
                points.iter().map(|point| point[direction]).collect()
            }
        }
    }
}

/// Distinct for the colour-blind too.
const PALETTE: [Colour; 8] = [
    Colour::INK,
    Colour::EMD,
    Colour::EMD_STAR,
    Colour::BLUE,
    Colour::rgb(0xe0, 0x9f, 0x00),
    Colour::rgb(0x9a, 0x4d, 0xa8),
    Colour::rgb(0x58, 0xb5, 0xe3),
    Colour::rgb(0x80, 0x5b, 0x36),
];

/// Puts the second picture to the right of the first.
pub fn beside(first: Scene, second: Scene) -> Scene {
    let shift = first.width;
    let moved = |rect: Rect| Rect { x: rect.x + shift, ..rect };
    let mut page = Scene::new(first.width + second.width, first.height.max(second.height));
    page.items = first.items;
    page.items.extend(second.items.into_iter().filter_map(|item| match item {
        Item::Shape { path, fill, stroke, clip } => {
            let path = path.transform(Transform::from_translate(shift as f32, 0.0))?;
            Some(Item::Shape { path, fill, stroke, clip: clip.map(moved) })
        }
        Item::Pixels { place, size, rgba } => {
            Some(Item::Pixels { place: moved(place), size, rgba })
        }
    }));
    page
}

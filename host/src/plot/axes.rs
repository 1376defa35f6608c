//! Where does a number stand on the page? Reads ranges, series and fields; writes frames, ticks, lines and pixels to a scene.

use super::scene::{Colour, Item, Rect, Scene, Stroke};
use super::text::{Align, Style};

/// One axis of a panel.
#[derive(Clone, Debug)]
pub struct Axis {
    low: f64,
    high: f64,
    logarithmic: bool,
    ticks: Vec<f64>,
    minor: Vec<f64>,
    labelled: bool,
}

impl Axis {
    /// A linear axis with about `ticks` round numbers.
    pub fn linear(low: f64, high: f64, ticks: usize) -> Self {
        let step = round_step((high - low) / ticks.max(1) as f64);
        let first = (low / step - 1e-9).ceil() as i64;
        let last = (high / step + 1e-9).floor() as i64;
        let ticks = (first..=last).map(|k| k as f64 * step).collect();
        Self { low, high, logarithmic: false, ticks, minor: Vec::new(), labelled: true }
    }

    /// A linear axis with given ticks.
    pub const fn with_ticks(low: f64, high: f64, ticks: Vec<f64>) -> Self {
        Self { low, high, logarithmic: false, ticks, minor: Vec::new(), labelled: true }
    }

    /// A logarithmic axis with a tick at powers of ten, every so many decades, and short ticks between: at the
    /// multiples of a power of ten, or at the powers without a number.
    pub fn logarithmic(low: f64, high: f64) -> Self {
        let (first, last) = (low.log10().ceil() as i32, high.log10().floor() as i32);
        let every = 1 + (last - first).max(0) / 8;
        let ticks =
            (first..=last).filter(|k| k.rem_euclid(every) == 0).map(|k| 10f64.powi(k)).collect();
        let inside = |x: &f64| (low..=high).contains(x);
        let minor = match every {
            1 => (first - 1..=last).flat_map(multiples).filter(inside).collect(),
            _ => (first..=last).map(|k| 10f64.powi(k)).collect(),
        };
        Self { low, high, logarithmic: true, ticks, minor, labelled: true }
    }

    /// The same axis without numbers at its ticks.
    pub fn unlabelled(mut self) -> Self {
        self.labelled = false;
        self
    }

    /// Equal steps are equal factors.
    pub const fn is_logarithmic(&self) -> bool {
        self.logarithmic
    }

    /// 0 at the low end, 1 at the high end.
    pub fn fraction(&self, value: f64) -> f64 {
        if self.logarithmic {
            (value.ln() - self.low.ln()) / (self.high.ln() - self.low.ln())
        } else {
            (value - self.low) / (self.high - self.low)
        }
    }

    fn label(&self, tick: f64) -> String {
        if self.logarithmic {
            return match tick.log10().round() as i32 {
                0 => "1".to_owned(),
                1 => "10".to_owned(),
                power => format!("10^{{{power}}}").replace('-', "−"),
            };
        }
        let step = match self.ticks.as_slice() {
            [a, b, ..] => (b - a).abs(),
            _ => tick.abs(),
        };
        let largest = self.ticks.iter().fold(tick.abs(), |largest, tick| largest.max(tick.abs()));
        let tick = if tick.abs() < 1e-9 * step { 0.0 } else { tick };
        // Very small and very large numbers have a power of ten of their own, the same for all of an axis.
        let power = largest.log10().floor() as i32;
        let text = match (-4..7).contains(&power) || largest == 0.0 {
            true => rounded(tick, step),
            false if tick == 0.0 => "0".to_owned(),
            false => {
                let unit = 10f64.powi(power);
                format!("{} · 10^{{{power}}}", rounded(tick / unit, step / unit))
            }
        };
        text.replace('-', "−")
    }
}

/// A tick with as many digits as the step from one to the next needs.
fn rounded(tick: f64, step: f64) -> String {
    let digits = (-(step * 1.000_001).log10().floor()).clamp(0.0, 6.0) as usize;
    let last = step * 10f64.powi(digits as i32);
    let digits = digits + usize::from((last - last.round()).abs() > 0.01);
    format!("{tick:.digits$}")
}

/// 2, 3, … 9 times a power of ten.
fn multiples(power: i32) -> impl Iterator<Item = f64> {
    (2..10).map(move |digit| f64::from(digit) * 10f64.powi(power))
}

/// 1, 2 or 5 times a power of ten, at least as large as `rough`.
fn round_step(rough: f64) -> f64 {
    let power = 10f64.powf(rough.log10().floor());
    [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .map(|step| step * power)
        .find(|step| *step >= rough * 0.999)
        .unwrap_or(10.0 * power)
}

/// Type size of numbers at ticks.
pub const SMALL: f64 = 8.5;
/// Type size of labels.
pub const NORMAL: f64 = 10.0;
const THIN: f32 = 0.7;
const TICK: f64 = 4.0;

/// A frame with two axes.
#[derive(Clone, Debug)]
pub struct Panel {
    /// Where it stands.
    pub place: Rect,
    /// From left to right.
    pub x: Axis,
    /// From bottom to top.
    pub y: Axis,
}

impl Panel {
    /// The point of a pair of numbers.
    pub fn at(&self, x: f64, y: f64) -> [f64; 2] {
        let place = &self.place;
        [
            place.x + place.width * self.x.fraction(x),
            place.y + place.height * (1.0 - self.y.fraction(y)),
        ]
    }

    /// Draws frame, ticks and numbers; over the lines, so last.
    pub fn frame(&self, scene: &mut Scene) {
        scene.rectangle(self.place, None, Some(Stroke::solid(Colour::INK, THIN)));
        self.marks(scene);
        let Rect { x, y, width, height } = self.place;
        let bottom = y + height;
        for tick in self.x.ticks.iter().filter(|_| self.x.labelled) {
            let at = [x + width * self.x.fraction(*tick), bottom + 3.0 + SMALL];
            let style = Style::new(SMALL, Colour::INK, Align::Middle);
            scene.text(at, &self.x.label(*tick), style);
        }
        for tick in self.y.ticks.iter().filter(|_| self.y.labelled) {
            let at = [x - 4.0, bottom - height * self.y.fraction(*tick) + 0.36 * SMALL];
            let style = Style::new(SMALL, Colour::INK, Align::Right);
            scene.text(at, &self.y.label(*tick), style);
        }
    }

    /// Ticks along all four sides.
    fn marks(&self, scene: &mut Scene) {
        let pen = Stroke::solid(Colour::INK, THIN);
        let Rect { x, y, width, height } = self.place;
        let (right, bottom) = (x + width, y + height);
        for (ticks, size) in [(&self.x.ticks, TICK), (&self.x.minor, 0.5 * TICK)] {
            for at in ticks.iter().map(|tick| x + width * self.x.fraction(*tick)) {
                scene.line(&[[at, bottom], [at, bottom - size]], pen, None);
                scene.line(&[[at, y], [at, y + size]], pen, None);
            }
        }
        for (ticks, size) in [(&self.y.ticks, TICK), (&self.y.minor, 0.5 * TICK)] {
            for at in ticks.iter().map(|tick| bottom - height * self.y.fraction(*tick)) {
                scene.line(&[[x, at], [x + size, at]], pen, None);
                scene.line(&[[right, at], [right - size, at]], pen, None);
            }
        }
    }

    /// Names the axes.
    pub fn labels(&self, scene: &mut Scene, x: &str, y: &str, margin: f64) {
        let Rect { x: left, y: top, width, height } = self.place;
        let style = Style::new(NORMAL, Colour::INK, Align::Middle);
        scene.text([left + width / 2.0, top + height + 17.0 + NORMAL], x, style);
        scene.text([left - margin, top + height / 2.0], y, style.upwards());
    }

    /// A title over the frame, at its left end.
    pub fn title(&self, scene: &mut Scene, title: &str) {
        let style = Style::new(NORMAL, Colour::INK, Align::Left);
        scene.text([self.place.x, self.place.y - 6.0], title, style);
    }

    /// A line through points.
    pub fn line(&self, scene: &mut Scene, points: &[[f64; 2]], stroke: Stroke) {
        let points: Vec<_> = points.iter().map(|[x, y]| self.at(*x, *y)).collect();
        scene.line(&points, stroke, Some(self.place));
    }

    /// A legend: a sample of each line and its name, downwards from the upper left point `at`.
    pub fn legend(&self, scene: &mut Scene, at: [f64; 2], entries: &[(&str, Stroke)]) {
        for (row, (name, stroke)) in entries.iter().enumerate() {
            let y = at[1] + 14.0 * row as f64;
            scene.line(&[[at[0], y], [at[0] + 22.0, y]], *stroke, None);
            let style = Style::new(9.5, Colour::INK, Align::Left);
            scene.text([at[0] + 28.0, y + 3.4], name, style);
        }
    }

    /// A filled dot.
    pub fn dot(&self, scene: &mut Scene, x: f64, y: f64, radius: f64, colour: Colour) {
        scene.disc(self.at(x, y), radius, Some(colour), None, Some(self.place));
    }
}

/// Values on a grid, row by row from the bottom; NaN is left white.
#[derive(Clone, Debug)]
pub struct Field {
    /// Columns.
    pub columns: usize,
    /// The values.
    pub values: Vec<f64>,
}

impl Field {
    /// Draws the field over `place`, `low` as the darkest colour and `high` as the lightest.
    pub fn draw(&self, scene: &mut Scene, place: Rect, low: f64, high: f64) {
        let columns = self.columns.max(1);
        let rows = self.values.len() / columns;
        let mut rgba = Vec::with_capacity(4 * self.values.len());
        for row in self.values.chunks_exact(columns).rev() {
            for value in row {
                if value.is_nan() {
                    rgba.extend([255, 255, 255, 0]);
                } else {
                    let [r, g, b] = Colour::scale((value - low) / (high - low)).rgb;
                    rgba.extend([r, g, b, 255]);
                }
            }
        }
        scene.items.push(Item::Pixels { place, size: [columns as u32, rows as u32], rgba });
    }
}

/// A horizontal colour bar from `low` to `high` with about three numbers below it.
pub fn colour_bar(scene: &mut Scene, place: Rect, low: f64, high: f64) {
    let columns = 256;
    let values = (0..columns).map(|k| k as f64 / (columns - 1) as f64).collect();
    Field { columns, values }.draw(scene, place, 0.0, 1.0);
    // Numbers with two decimals need more space.
    let x = Axis::linear(low, high, if high - low < 0.3 { 3 } else { 4 });
    Panel { place, x, y: Axis::with_ticks(0.0, 1.0, Vec::new()) }.frame(scene);
}

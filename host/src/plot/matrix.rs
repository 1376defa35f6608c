//! What does the matrix of restitution look like? Reads the contact equation and the tables' ranges; writes MP13's Figs. 3, 4 and 5 as scenes.

use super::axes::{Axis, Field, NORMAL, Panel, SMALL, colour_bar};
use super::scene::{Colour, Rect, Scene};
use super::text::{Align, Style};
use crate::parameter_space::Space;
use carom_tables::contact;
use carom_tables::read::{End, Groups, Law, ScaledRestitution};
use rayon::prelude::*;
use std::f64::consts::PI;
use tiny_skia::PathBuilder;

/// MP13 Fig. 3: ε_φ of elastic linear-dashpot collisions over (ln c_φ, ln l~); white where Table I
/// does not reach.
pub fn fig3() -> Scene {
    let space = Space::linear();
    let (columns, rows) = (370usize, 240usize);
    let y_range = [space.m[0], space.m[1] + 2.2];
    let x_range = [y_range[0] + space.g[0], y_range[1] + space.g[1]];
    let value = |k: usize| {
        let x = spread(k % columns, columns, x_range);
        let y = spread(k / columns, rows, y_range);
        let Some([u, w]) = space.near(x, y, 0.3) else { return f64::NAN };
        let groups = Groups { c_dis: 0.0, ..space.groups(u, w, 0.0) };
        contact::integrate(space.law, End::Force, &groups).angle
    };
    let values = (0..columns * rows).into_par_iter().map(value).collect();
    let mut scene = Scene::new(440.0, 350.0);
    let place = Rect { x: 52.0, y: 56.0, width: 370.0, height: 240.0 };
    Field { columns, values }.draw(&mut scene, place, 0.0, PI);
    let (x, y) = (Axis::linear(x_range[0], x_range[1], 8), Axis::linear(y_range[0], y_range[1], 7));
    let panel = Panel { place, x, y };
    blank_outside(&mut scene, &panel, &space);
    panel.frame(&mut scene);
    panel.labels(&mut scene, "ln *c*_{φ}", "ln *l\u{303}*", 34.0);
    let bar = Rect { x: 222.0, y: 16.0, width: 200.0, height: 9.0 };
    colour_bar(&mut scene, bar, 0.0, PI);
    scene.text([bar.x - 8.0, 24.0], "*ε*_{φ} [rad]", Style::new(NORMAL, Colour::INK, Align::Right));
    scene
}

/// Covers what lies outside of Table I: the panel with the region left out.
fn blank_outside(scene: &mut Scene, panel: &Panel, space: &Space) {
    let Rect { x, y, width, height } = panel.place;
    let mut path = PathBuilder::new();
    // The panel runs against the clock and the region with it, so the region stays open.
    let corners = [[x, y], [x, y + height], [x + width, y + height], [x + width, y]];
    let rim: Vec<[f64; 2]> = space.rim(60).into_iter().map(|[a, b]| panel.at(a, b)).collect();
    for outline in [corners.as_slice(), rim.as_slice()] {
        for (number, [x, y]) in outline.iter().enumerate() {
            match number {
                0 => path.move_to(*x as f32, *y as f32),
                _ => path.line_to(*x as f32, *y as f32),
            }
        }
        path.close();
    }
    scene.shape(path.finish(), Some(Colour::WHITE), None, Some(panel.place));
}

/// What MP13 Fig. 4 (linear dashpot) or Fig. 5 (viscoelastic) shows: the matrix of restitution over
/// ln(c_φ/c_φ^min) and ln(l~/l~^min), for five dampings.
#[derive(Clone, Debug)]
pub struct Maps {
    /// The axes.
    pub space: Space,
    /// ln c_dis of the linear law, ln(c_dis/c_dis^min) of the viscoelastic one.
    pub dampings: [f64; 5],
    /// For each damping, row by row from the smallest l~.
    pub answers: Vec<Vec<ScaledRestitution<f64>>>,
}

impl Maps {
    /// Integrates the contact equation at all points.
    pub fn new(law: Law) -> Self {
        let (space, dampings) = match law {
            Law::LinearDashpot => (Space::linear(), [-4.0, -1.0, 0.0, 1.0, 3.0]),
            Law::Viscoelastic => (Space::viscoelastic(), [4.0, 8.0, 12.0, 16.0, 20.0]),
        };
        let answers = dampings.iter().map(|damping| sample(&space, *damping)).collect();
        Self { space, dampings, answers }
    }

    /// Draws a row for each damping, a column for each coefficient.
    pub fn draw(&self) -> Scene {
        let mut scene =
            Scene::new(LEFT + 4.0 * (WIDE + GAP) + 8.0, TOP + 5.0 * (TALL + GAP) + 30.0);
        for (column, coefficient) in COEFFICIENTS.iter().enumerate() {
            let [low, high] = coefficient.range(self.answers.iter().flatten());
            head(&mut scene, column, coefficient.name, [low, high]);
            for (row, answers) in self.answers.iter().enumerate() {
                let values = answers.iter().map(coefficient.value).collect();
                Field { columns: COLUMNS, values }.draw(&mut scene, cell(row, column), low, high);
                panel(&self.space, row, column).frame(&mut scene);
            }
        }
        self.name_rows(&mut scene);
        let middle = [LEFT + 2.0 * (WIDE + GAP) - GAP / 2.0, scene.height - 10.0];
        let style = Style::new(NORMAL, Colour::INK, Align::Middle);
        scene.text(middle, "ln *c*_{φ}/*c*_{φ}^{min}", style);
        let middle = [14.0, TOP + 2.5 * (TALL + GAP)];
        scene.text(middle, "ln *l\u{303}*/*l\u{303}*^{min}", style.upwards());
        scene
    }

    fn name_rows(&self, scene: &mut Scene) {
        let name = match self.space.law {
            Law::LinearDashpot => "ln *c*_{dis}",
            Law::Viscoelastic => "ln *c*_{dis}/*c*_{dis}^{min}",
        };
        for (row, damping) in self.dampings.iter().enumerate() {
            let at = [cell(row, 0).x + 6.0, cell(row, 0).y + 13.0];
            let text = format!("{name} = {damping}").replace('-', "−");
            scene.text(at, &text, Style::new(SMALL, Colour::WHITE, Align::Left));
        }
    }
}

const LEFT: f64 = 44.0;
const TOP: f64 = 52.0;
const WIDE: f64 = 128.0;
const TALL: f64 = 100.0;
const GAP: f64 = 9.0;
/// Points of a map from left to right.
pub const COLUMNS: usize = 128;
const ROWS: usize = 100;

/// One column of Figs. 4 and 5.
#[derive(Clone, Copy, Debug)]
pub struct Coefficient {
    /// In the picture.
    name: &'static str,
    /// In plain letters.
    pub plain: &'static str,
    /// The limits, where the values themselves shall not set them.
    low: Option<f64>,
    high: Option<f64>,
    /// Which it is.
    pub value: fn(&ScaledRestitution<f64>) -> f64,
}

impl Coefficient {
    /// From the smallest to the largest value, rounded outwards to tenths.
    fn range<'a>(&self, answers: impl Iterator<Item = &'a ScaledRestitution<f64>>) -> [f64; 2] {
        let all = answers.map(self.value);
        let (low, high) = all
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        [
            self.low.unwrap_or((10.0 * low).floor() / 10.0),
            self.high.unwrap_or((10.0 * high).ceil() / 10.0),
        ]
    }
}

/// The columns of Figs. 4 and 5.
pub const COEFFICIENTS: [Coefficient; 4] = [
    Coefficient {
        name: "*ε*_{φ} [rad]",
        plain: "ε_φ (rad)",
        low: Some(0.0),
        high: None,
        value: |s| s.angle,
    },
    Coefficient {
        name: "*ε*_{*r\u{307}*}",
        plain: "ε_ṙ",
        low: Some(-1.0),
        high: Some(0.0),
        value: |s| -s.speed,
    },
    Coefficient {
        name: "*ε*_{*r*}",
        plain: "ε_r",
        low: None,
        high: Some(1.0),
        value: |s| s.separation,
    },
    Coefficient { name: "*ε*_{*t*}", plain: "ε_t", low: Some(0.0), high: None, value: |s| s.tau },
];

fn spread(k: usize, count: usize, [low, high]: [f64; 2]) -> f64 {
    low + (high - low) * (k as f64 + 0.5) / count as f64
}

fn sample(space: &Space, damping: f64) -> Vec<ScaledRestitution<f64>> {
    (0..COLUMNS * ROWS)
        .into_par_iter()
        .map(|k| {
            let u = spread(k % COLUMNS, COLUMNS, [0.0, space.width()]);
            let w = spread(k / COLUMNS, ROWS, [0.0, space.height()]);
            contact::integrate(space.law, End::Force, &space.groups(u, w, damping))
        })
        .collect()
}

fn cell(row: usize, column: usize) -> Rect {
    let (x, y) = (LEFT + column as f64 * (WIDE + GAP), TOP + row as f64 * (TALL + GAP));
    Rect { x, y, width: WIDE, height: TALL }
}

fn panel(space: &Space, row: usize, column: usize) -> Panel {
    let x = Axis::linear(0.0, space.width(), 6);
    let y = Axis::linear(0.0, space.height(), 6);
    Panel {
        place: cell(row, column),
        x: if row == 4 { x } else { x.unlabelled() },
        y: if column == 0 { y } else { y.unlabelled() },
    }
}

fn head(scene: &mut Scene, column: usize, name: &str, [low, high]: [f64; 2]) {
    let Rect { x, width, .. } = cell(0, column);
    scene.text([x + width / 2.0, 14.0], name, Style::new(NORMAL, Colour::INK, Align::Middle));
    let bar = Rect { x: x + 10.0, y: 21.0, width: width - 20.0, height: 8.0 };
    colour_bar(scene, bar, low, high);
}

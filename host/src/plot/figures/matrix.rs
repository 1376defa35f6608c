//! What does the matrix of restitution look like? Reads the contact equation; writes MP13's Figs. 3, 4 and 5 as scenes.

use super::space::Space;
use crate::plot::axes::{NORMAL, SMALL};
use crate::plot::colour::{INK, WHITE};
use crate::plot::heat::{Field, colour_bar};
use crate::plot::scene::{Rect, Scene};
use crate::plot::text::{Align, Style};
use crate::plot::{Axis, Panel};
use carom_tables::{End, Groups, Law, Scaled, contact};
use rayon::prelude::*;
use std::f64::consts::PI;

/// MP13 Fig. 3: ε_φ of elastic linear-dashpot collisions over (ln c_φ, ln l~).
pub fn fig3() -> Scene {
    let space = Space::linear();
    let (columns, rows) = (420usize, 320usize);
    let y_range = [space.m[0], space.m[1] + 2.2];
    let x_range = [y_range[0] + space.g[0], y_range[1] + space.g[1]];
    let values = (0..columns * rows)
        .into_par_iter()
        .map(|k| {
            let x = spread(k % columns, columns, x_range);
            let y = spread(k / columns, rows, y_range);
            space.inside(x, y).map_or(f64::NAN, |[u, w]| {
                contact::integrate(space.law, End::Force, &elastic(space.groups(u, w, 0.0))).angle
            })
        })
        .collect();
    let mut scene = Scene::new(440.0, 350.0);
    let place = Rect { x: 52.0, y: 56.0, width: 370.0, height: 240.0 };
    Field { columns, values }.draw(&mut scene, place, 0.0, PI);
    let (x, y) = (Axis::linear(x_range[0], x_range[1], 8), Axis::linear(y_range[0], y_range[1], 7));
    let panel = Panel { place, x, y };
    panel.frame(&mut scene);
    panel.labels(&mut scene, "ln *c*_{φ}", "ln *l\u{303}*", 34.0);
    let bar = Rect { x: 222.0, y: 16.0, width: 200.0, height: 9.0 };
    colour_bar(&mut scene, bar, 0.0, PI);
    scene.text([bar.x - 8.0, 24.0], "*ε*_{φ} [rad]", Style::new(NORMAL, INK, Align::Right));
    scene
}

fn elastic(groups: Groups<f64>) -> Groups<f64> {
    Groups { c_dis: 0.0, ..groups }
}

/// MP13 Fig. 4 (linear dashpot) or Fig. 5 (viscoelastic): a row for each damping, a column for
/// each coefficient, over ln(c_φ/c_φ^min) and ln(l~/l~^min).
pub fn coefficients(law: Law) -> Scene {
    let (space, rows, name): (_, [f64; 5], _) = match law {
        Law::LinearDashpot => (Space::linear(), [-4.0, -1.0, 0.0, 1.0, 3.0], "ln *c*_{dis}"),
        Law::Viscoelastic => {
            let name = "ln *c*_{dis}/*c*_{dis}^{min}";
            (Space::viscoelastic(), [4.0, 8.0, 12.0, 16.0, 20.0], name)
        }
    };
    let mut scene = Scene::new(LEFT + 4.0 * (WIDE + GAP) + 8.0, TOP + 5.0 * (TALL + GAP) + 30.0);
    for (column, coefficient) in COEFFICIENTS.iter().enumerate() {
        head(&mut scene, column, coefficient);
    }
    for (row, damping) in rows.into_iter().enumerate() {
        let answers = sample(&space, damping);
        for (column, coefficient) in COEFFICIENTS.iter().enumerate() {
            let values = answers.iter().map(coefficient.value).collect();
            let place = cell(row, column);
            Field { columns: COLUMNS, values }.draw(
                &mut scene,
                place,
                coefficient.low,
                coefficient.high,
            );
            panel(&space, row, column).frame(&mut scene);
        }
        let at = [cell(row, 0).x + 6.0, cell(row, 0).y + 13.0];
        let text = format!("{name} = {damping}").replace('-', "−");
        scene.text(at, &text, Style::new(SMALL, WHITE, Align::Left));
    }
    let middle = [LEFT + 2.0 * (WIDE + GAP) - GAP / 2.0, scene.height - 10.0];
    let style = Style::new(NORMAL, INK, Align::Middle);
    scene.text(middle, "ln *c*_{φ}/*c*_{φ}^{min}", style);
    let middle = [14.0, TOP + 2.5 * (TALL + GAP)];
    scene.text(middle, "ln *l\u{303}*/*l\u{303}*^{min}", style.upwards());
    scene
}

const LEFT: f64 = 44.0;
const TOP: f64 = 52.0;
const WIDE: f64 = 128.0;
const TALL: f64 = 100.0;
const GAP: f64 = 9.0;
const COLUMNS: usize = 128;
const ROWS: usize = 100;

struct Coefficient {
    name: &'static str,
    low: f64,
    high: f64,
    value: fn(&Scaled<f64>) -> f64,
}

const COEFFICIENTS: [Coefficient; 4] = [
    Coefficient { name: "*ε*_{φ} [rad]", low: 0.0, high: PI, value: |s| s.angle },
    Coefficient { name: "*ε*_{*r\u{307}*}", low: -1.0, high: 0.0, value: |s| -s.speed },
    Coefficient { name: "*ε*_{*r*}", low: 0.0, high: 1.0, value: |s| s.separation },
    Coefficient { name: "*ε*_{*t*}", low: 0.0, high: 3.25, value: |s| s.tau },
];

fn spread(k: usize, count: usize, [low, high]: [f64; 2]) -> f64 {
    low + (high - low) * (k as f64 + 0.5) / count as f64
}

fn sample(space: &Space, damping: f64) -> Vec<Scaled<f64>> {
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

fn head(scene: &mut Scene, column: usize, coefficient: &Coefficient) {
    let Rect { x, width, .. } = cell(0, column);
    let style = Style::new(NORMAL, INK, Align::Middle);
    scene.text([x + width / 2.0, 14.0], coefficient.name, style);
    let bar = Rect { x: x + 4.0, y: 21.0, width: width - 8.0, height: 8.0 };
    colour_bar(scene, bar, coefficient.low, coefficient.high);
}

//! How do many small diagrams share a page? Reads curves; writes one scene of panels in rows.

use crate::plot::colour::{self, INK};
use crate::plot::text::{Align, Style};
use crate::plot::{Axis, Panel, Rect, Scene, Stroke};

/// One diagram: lines in colours from dark to light, in the order given.
#[derive(Clone, Debug)]
pub struct Diagram {
    /// Over it.
    pub title: String,
    /// Its lines.
    pub curves: Vec<Vec<[f64; 2]>>,
    /// From left to right.
    pub x: [f64; 2],
    /// From bottom to top; none to fit the curves.
    pub y: Option<[f64; 2]>,
}

const WIDTH: f64 = 190.0;
const HEIGHT: f64 = 130.0;
const LEFT: f64 = 54.0;
const TOP: f64 = 44.0;
const ACROSS: f64 = 52.0;
const DOWN: f64 = 58.0;

/// Draws diagrams in rows of so many.
pub fn draw(title: &str, diagrams: &[Diagram], columns: usize, [x, y]: [&str; 2]) -> Scene {
    let rows = diagrams.len().div_ceil(columns);
    let size = |n: usize, each: f64, between: f64| n as f64 * (each + between);
    let width = LEFT + size(columns, WIDTH, ACROSS) - ACROSS + 14.0;
    let mut scene = Scene::new(width, TOP + size(rows, HEIGHT, DOWN) - 12.0);
    scene.text([LEFT, 18.0], title, Style::new(11.0, INK, Align::Left));
    for (k, diagram) in diagrams.iter().enumerate() {
        let left = LEFT + size(k % columns, WIDTH, ACROSS);
        let top = TOP + size(k / columns, HEIGHT, DOWN);
        let panel = Panel {
            place: Rect { x: left, y: top, width: WIDTH, height: HEIGHT },
            x: Axis::linear(diagram.x[0], diagram.x[1], 5),
            y: vertical(diagram),
        };
        for (i, curve) in diagram.curves.iter().enumerate() {
            let tone = colour::scale(0.9 * i as f64 / diagram.curves.len().max(2) as f64);
            panel.line(&mut scene, curve, Stroke::solid(tone, 1.1));
        }
        panel.frame(&mut scene);
        panel.labels(&mut scene, x, y, 36.0);
        panel.title(&mut scene, &diagram.title);
    }
    scene
}

fn vertical(diagram: &Diagram) -> Axis {
    let [low, high] = diagram.y.unwrap_or_else(|| {
        let all = diagram.curves.iter().flatten().map(|point| point[1]);
        let (low, high) =
            all.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), y| (a.min(y), b.max(y)));
        let margin = 0.05 * (high - low).max(1e-12);
        [low - margin, high + margin]
    });
    Axis::linear(low, high, 5)
}

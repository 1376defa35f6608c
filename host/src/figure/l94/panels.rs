//! How do trajectories of many beads become diagrams side by side? Reads lines in the order of the beads; writes a scene with lettered panels.

use crate::plot::text::{Align, Style};
use crate::plot::{Axis, Colour, Panel, Rect, SMALL, Scene, Stroke};

/// One diagram: a line for each bead, from the lowest to the highest.
#[derive(Clone, Debug)]
pub struct Diagram {
    /// Over it.
    pub title: String,
    /// Its lines.
    pub curves: Vec<Vec<[f64; 2]>>,
    /// From left to right.
    pub x: [f64; 2],
}

const WIDTH: f64 = 190.0;
const HEIGHT: f64 = 130.0;
const LEFT: f64 = 54.0;
const TOP: f64 = 58.0;
const ACROSS: f64 = 52.0;
const DOWN: f64 = 58.0;
/// The highest bead's place on the colour scale: yellow cannot be seen on white.
const LIGHTEST: f64 = 0.9;

/// Draws diagrams in rows of so many, with a letter each.
pub fn draw_panels(title: &str, diagrams: &[Diagram], columns: usize, labels: [&str; 2]) -> Scene {
    let rows = diagrams.len().div_ceil(columns);
    let size = |n: usize, each: f64, between: f64| n as f64 * (each + between);
    let width = LEFT + size(columns, WIDTH, ACROSS) - ACROSS + 14.0;
    let mut scene = Scene::new(width, TOP + size(rows, HEIGHT, DOWN) - 12.0);
    scene.text([LEFT, 18.0], title, Style::new(11.0, Colour::INK, Align::Left));
    explain_colours(&mut scene, diagrams.first().map_or(0, |diagram| diagram.curves.len()));
    for (k, (diagram, letter)) in diagrams.iter().zip('a'..='z').enumerate() {
        let left = LEFT + size(k % columns, WIDTH, ACROSS);
        let top = TOP + size(k / columns, HEIGHT, DOWN);
        let place = Rect { x: left, y: top, width: WIDTH, height: HEIGHT };
        one(&mut scene, place, diagram, letter, labels);
    }
    scene
}

fn one(scene: &mut Scene, place: Rect, diagram: &Diagram, letter: char, [x, y]: [&str; 2]) {
    let panel =
        Panel { place, x: Axis::linear(diagram.x[0], diagram.x[1], 5), y: vertical(diagram) };
    for (i, curve) in diagram.curves.iter().enumerate() {
        let tone = Colour::scale(LIGHTEST * i as f64 / diagram.curves.len().max(2) as f64);
        panel.line(scene, curve, Stroke::solid(tone, 1.1));
    }
    panel.frame(scene);
    panel.labels(scene, x, y, 36.0);
    panel.title(scene, &format!("({letter}) {}", diagram.title));
}

/// Which colour is which bead.
fn explain_colours(scene: &mut Scene, beads: usize) {
    if beads < 2 {
        return;
    }
    let style = Style::new(SMALL, Colour::INK, Align::Left);
    scene.text([LEFT, 34.0], "bead 1, the lowest", style);
    let place = Rect { x: LEFT + 84.0, y: 27.0, width: 10.0 * beads as f64, height: 8.0 };
    for i in 0..beads {
        let tone = Colour::scale(LIGHTEST * i as f64 / beads as f64);
        let one = Rect { x: place.x + 10.0 * i as f64, width: 10.0, ..place };
        scene.rectangle(one, Some(tone), None);
    }
    let end = [place.x + place.width + 6.0, 34.0];
    scene.text(end, &format!("bead {beads}, the highest"), style);
}

fn vertical(diagram: &Diagram) -> Axis {
    let all = diagram.curves.iter().flatten().map(|point| point[1]);
    let (low, high) =
        all.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), y| (a.min(y), b.max(y)));
    let margin = 0.05 * (high - low).max(1e-12);
    Axis::linear(low - margin, high + margin, 5)
}

//! How fast do the methods leave force-based MD? Reads the study of ten-grain gases; writes errors against the collision number as a scene.

use crate::divergence::{Errors, Way};
use crate::plot::axes::{Axis, Panel};
use crate::plot::colour;
use crate::plot::scene::{Colour, Rect, Scene, Stroke};
use crate::plot::text::{Align, Style};

/// Draws median (solid) and largest error (dotted) of each way after each collision.
pub fn draw(study: &[Errors], runs: usize) -> Scene {
    let mut scene = Scene::new(470.0, 380.0);
    let style = Style::new(11.0, colour::INK, Align::Left);
    let title = format!("{runs} gases of ten viscoelastic grains, until three touch");
    scene.text([64.0, 20.0], &title, style);
    let collisions = study.first().map_or(1, |errors| errors.by_collision.len());
    let ticks = (1..=collisions).map(|k| k as f64).collect();
    let panel = Panel {
        place: Rect { x: 64.0, y: 48.0, width: 380.0, height: 280.0 },
        x: Axis::with_ticks(0.5, collisions as f64 + 0.5, ticks),
        y: Axis::logarithmic(1e-20, 1e2),
    };
    let mut legend = Vec::new();
    for errors in study {
        let tone = tone(errors.way);
        let pen = Stroke::solid(tone, 1.8);
        let thin = Stroke::dashed(tone.with_opacity(0.75), 1.0, 2.0, 2.0);
        panel.line(&mut scene, &curve(errors, Errors::median), pen);
        panel.line(&mut scene, &curve(errors, Errors::largest), thin);
        for [x, y] in curve(errors, Errors::median) {
            panel.dot(&mut scene, x, y, 2.4, tone);
        }
        legend.push((errors.way.name().replace('*', "∗"), pen));
    }
    panel.frame(&mut scene);
    panel.labels(&mut scene, "collision number", "distance from exact MD [*l*]", 44.0);
    panel.title(&mut scene, "positions of free grains: median (solid), largest (dotted)");
    let legend: Vec<_> = legend.iter().map(|(text, pen)| (text.as_str(), *pen)).collect();
    panel.legend(&mut scene, [300.0, 284.0], &legend);
    scene
}

fn curve(errors: &Errors, of: fn(&Errors, usize) -> Option<f64>) -> Vec<[f64; 2]> {
    let value = |k: usize| of(errors, k).filter(|e| *e > 0.0).map(|e| [k as f64 + 1.0, e]);
    (0..errors.by_collision.len()).filter_map(value).collect()
}

fn tone(way: Way) -> Colour {
    match way {
        Way::Integrated => colour::INK,
        Way::Table => colour::EMD_STAR,
        Way::HardSphere => colour::EMD,
    }
}

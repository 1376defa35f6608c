//! How do the methods compare? Reads a gas, or the study of ten-grain gases; writes each as a scene.

use super::axes::{Axis, Panel};
use super::scene::{Colour, Rect, Scene, Stroke};
use super::text::{Align, Style};
use crate::compare::{Comparison, Difference, Point, Summary};
use crate::divergence::{Errors, Variant};
use crate::scenario::MethodName;

pub use super::pair::fig6;

/// Draws the comparison: kinetic energy on the left, distance from exact MD on the right.
pub fn gas(comparison: &Comparison) -> Scene {
    let mut scene = Scene::new(740.0, 340.0);
    let style = Style::new(11.0, Colour::INK, Align::Left);
    scene.text([56.0, 20.0], &comparison.title, style);
    energy(&mut scene, comparison);
    error(&mut scene, comparison);
    scene
}

const TOP: f64 = 48.0;
const TALL: f64 = 240.0;

/// Names, costs and lines; the asterisk would be read as a mark for italics.
fn name(summary: &Summary) -> &'static str {
    match summary.method {
        MethodName::Md => "MD (Verlet)",
        MethodName::Exact => "MD, exact",
        MethodName::Emd => "eMD",
        MethodName::EmdStar => "eMD∗",
    }
}

fn tone(method: MethodName) -> Colour {
    match method {
        MethodName::Md => Colour::MD,
        MethodName::Exact => Colour::FAINT,
        MethodName::Emd => Colour::EMD,
        MethodName::EmdStar => Colour::EMD_STAR,
    }
}

fn energy(scene: &mut Scene, comparison: &Comparison) {
    let shown: Vec<&Summary> =
        comparison.methods.iter().filter(|s| s.method != MethodName::Exact).collect();
    let values = shown.iter().flat_map(|s| s.series.iter().map(|p| p.kinetic_energy));
    let highest = values.fold(0.0, f64::max);
    let end = shown.iter().flat_map(|s| s.series.last()).map(|p| p.time).fold(0.0, f64::max);
    let place = Rect { x: 56.0, y: TOP, width: 290.0, height: TALL };
    let first = shown.first().and_then(|s| s.series.first()).map_or(1.0, |p| p.kinetic_energy);
    let panel = Panel {
        place,
        x: Axis::linear(0.0, end, 6),
        y: Axis::linear(0.0, 1.08 * highest / first, 5),
    };
    let mut legend = Vec::new();
    for summary in &shown {
        // MD widest and first, so that lines that cover it leave a rim.
        let wide = if summary.method == MethodName::Md { 3.4 } else { 1.5 };
        let pen = match summary.method {
            MethodName::EmdStar => Stroke::dashed(tone(summary.method), wide, 6.0, 3.0),
            _ => Stroke::solid(tone(summary.method), wide),
        };
        let points: Vec<_> =
            summary.series.iter().map(|p| [p.time, p.kinetic_energy / first]).collect();
        panel.line(scene, &points, pen);
        legend.push((format!("{}: {}", name(summary), cost(summary)), pen));
    }
    panel.frame(scene);
    panel.labels(scene, "*t* [s]", "*E*_{kin} / *E*_{kin}(0)", 36.0);
    panel.title(scene, "energy, and time of computing");
    let legend: Vec<_> = legend.iter().map(|(text, pen)| (text.as_str(), *pen)).collect();
    panel.legend(scene, [place.x + 128.0, place.y + 20.0], &legend);
}

fn cost(summary: &Summary) -> String {
    let seconds = summary.wall_seconds;
    if seconds < 0.1 { format!("{:.1} ms", 1e3 * seconds) } else { format!("{seconds:.2} s") }
}

fn error(scene: &mut Scene, comparison: &Comparison) {
    let end = comparison.reference_until;
    let place = Rect { x: 424.0, y: TOP, width: 290.0, height: TALL };
    let panel = Panel { place, x: Axis::linear(0.0, end, 6), y: Axis::logarithmic(1e-12, 1e2) };
    let radius = Stroke::dashed(Colour::FAINT, 0.9, 4.0, 3.0);
    panel.line(scene, &[[0.0, 1.0], [end, 1.0]], radius);
    let [x, y] = panel.at(0.0, 1.0);
    let small = Style::new(8.5, Colour::INK, Align::Left);
    scene.text([x + 0.52 * place.width, y + 10.0], "one radius", small);
    let mut legend = Vec::new();
    for summary in comparison.methods.iter().filter(|s| s.method != comparison.reference) {
        let pen = Stroke::solid(tone(summary.method), 1.6);
        let thin = Stroke::dashed(tone(summary.method).with_opacity(0.75), 1.0, 2.0, 2.0);
        panel.line(scene, &curve(comparison, summary, |of| of.median), pen);
        panel.line(scene, &curve(comparison, summary, |of| of.max), thin);
        legend.push((name(summary), pen));
    }
    panel.frame(scene);
    panel.labels(scene, "*t* [s]", "distance from exact MD [*R*]", 38.0);
    panel.title(scene, "positions: median (solid), largest (dotted)");
    panel.legend(scene, [place.x + 190.0, place.y + TALL - 48.0], &legend);
}

/// A line in the logarithmic panel; zeros are left out.
fn curve(comparison: &Comparison, summary: &Summary, of: fn(&Difference) -> f64) -> Vec<[f64; 2]> {
    let value = |point: &Point| {
        let difference = of(point.difference.as_ref()?) / comparison.mean_radius;
        Some([point.time, if difference > 0.0 { difference } else { f64::NAN }])
    };
    summary.series.iter().filter_map(value).collect()
}

/// Draws median (solid) and largest error (dotted) of each variant after each collision.
pub fn divergence(study: &[Errors], runs: usize) -> Scene {
    let mut scene = Scene::new(470.0, 380.0);
    let style = Style::new(11.0, Colour::INK, Align::Left);
    let title = format!("{runs} gases of ten viscoelastic grains; pairs only, until three touch");
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
        let tone = variant_tone(errors.variant);
        let pen = Stroke::solid(tone, 1.8);
        let thin = Stroke::dashed(tone.with_opacity(0.75), 1.0, 2.0, 2.0);
        panel.line(&mut scene, &error_curve(errors, Errors::median), pen);
        panel.line(&mut scene, &error_curve(errors, Errors::max), thin);
        for [x, y] in error_curve(errors, Errors::median) {
            panel.dot(&mut scene, x, y, 2.4, tone);
        }
        legend.push((errors.variant.name().replace('*', "∗"), pen));
    }
    panel.frame(&mut scene);
    panel.labels(&mut scene, "collision number", "distance from exact MD [*l*]", 44.0);
    panel.title(&mut scene, "positions of free grains: median (solid), largest (dotted)");
    let legend: Vec<_> = legend.iter().map(|(text, pen)| (text.as_str(), *pen)).collect();
    panel.legend(&mut scene, [300.0, 264.0], &legend);
    scene
}

fn error_curve(errors: &Errors, of: fn(&Errors, usize) -> Option<f64>) -> Vec<[f64; 2]> {
    let value = |k: usize| of(errors, k).filter(|e| *e > 0.0).map(|e| [k as f64 + 1.0, e]);
    (0..errors.by_collision.len()).filter_map(value).collect()
}

fn variant_tone(variant: Variant) -> Colour {
    match variant {
        Variant::Clusters => Colour::BLUE,
        Variant::Integrated => Colour::INK,
        Variant::Table => Colour::EMD_STAR,
        Variant::HardSphere => Colour::EMD,
    }
}

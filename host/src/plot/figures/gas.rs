//! How do the methods compare on many grains? Reads a comparison; writes energy and error against time as a scene.

use crate::compare::{Apart, Comparison, Point, Summary};
use crate::plot::axes::{Axis, Panel};
use crate::plot::colour;
use crate::plot::scene::{Colour, Rect, Scene, Stroke};
use crate::plot::text::{Align, Style};
use crate::scenario::MethodName;

/// Draws the comparison: kinetic energy on the left, distance from exact MD on the right.
pub fn draw(comparison: &Comparison) -> Scene {
    let mut scene = Scene::new(740.0, 340.0);
    let style = Style::new(11.0, colour::INK, Align::Left);
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
        MethodName::Md => colour::MD,
        MethodName::Exact => colour::FAINT,
        MethodName::Emd => colour::EMD,
        MethodName::EmdStar => colour::EMD_STAR,
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
    let end = comparison.judged_until;
    let place = Rect { x: 424.0, y: TOP, width: 290.0, height: TALL };
    let panel = Panel { place, x: Axis::linear(0.0, end, 6), y: Axis::logarithmic(1e-12, 1e2) };
    let radius = Stroke::dashed(colour::FAINT, 0.9, 4.0, 3.0);
    panel.line(scene, &[[0.0, 1.0], [end, 1.0]], radius);
    let [x, y] = panel.at(0.0, 1.0);
    let small = Style::new(8.5, colour::INK, Align::Left);
    scene.text([x + 0.52 * place.width, y + 10.0], "one radius", small);
    let mut legend = Vec::new();
    for summary in comparison.methods.iter().filter(|s| s.method != comparison.judge) {
        let pen = Stroke::solid(tone(summary.method), 1.6);
        let thin = Stroke::dashed(tone(summary.method).with_opacity(0.75), 1.0, 2.0, 2.0);
        panel.line(scene, &curve(comparison, summary, |apart| apart.median), pen);
        panel.line(scene, &curve(comparison, summary, |apart| apart.largest), thin);
        legend.push((name(summary), pen));
    }
    panel.frame(scene);
    panel.labels(scene, "*t* [s]", "distance from exact MD [*R*]", 38.0);
    panel.title(scene, "positions: median (solid), largest (dotted)");
    panel.legend(scene, [place.x + 190.0, place.y + TALL - 48.0], &legend);
}

/// A line in the logarithmic panel; zeros are left out.
fn curve(comparison: &Comparison, summary: &Summary, of: fn(&Apart) -> f64) -> Vec<[f64; 2]> {
    let value = |point: &Point| {
        let apart = of(point.apart.as_ref()?) / comparison.mean_radius;
        Some([point.time, if apart > 0.0 { apart } else { f64::NAN }])
    };
    summary.series.iter().filter_map(value).collect()
}

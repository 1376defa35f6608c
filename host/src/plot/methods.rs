//! How do the methods compare? Reads MP13's Fig. 6, a gas, or the study of ten-grain gases; writes each as a scene.

use super::axes::{Axis, Panel};
use super::scene::{Colour, Rect, Scene, Stroke};
use super::text::{Align, Style};
use crate::compare::{Comparison, Difference, Point, Summary};
use crate::divergence::{Errors, Variant};
use crate::method::{self, Method};
use crate::scenario::{MethodName, Scenario, Start};
use anyhow::Result;

/// Pieces of a path between two numbered dots.
const FINE: u32 = 24;
/// Which sample is dot 0, and how many dots there are.
const FIRST_DOT: u32 = 4;
const DOTS: u32 = 8;

/// Positions of the two grains: along the path, and at the numbered dots.
struct Paths {
    lines: [Vec<[f64; 2]>; 2],
    dots: [Vec<[f64; 2]>; 2],
    /// Where the grains stand just before dot 0, if they jump there.
    before: Option<[[f64; 2]; 2]>,
}

/// Draws the figure: MD and eMD on the left, MD and eMD* on the right.
///
/// # Errors
/// An error of a method.
pub fn fig6(scenario: &Scenario) -> Result<Scene> {
    let start = Start::new(scenario)?;
    let paths = |name| method::with(name, scenario, &start, |method| follow(method, scenario));
    let md = paths(MethodName::Exact)?;
    let mut scene = Scene::new(700.0, 378.0);
    let sides = [(MethodName::Emd, Colour::EMD), (MethodName::EmdStar, Colour::EMD_STAR)];
    for (number, (name, colour)) in sides.into_iter().enumerate() {
        let place = Rect { x: 52.0 + 330.0 * number as f64, y: 34.0, width: 300.0, height: 296.0 };
        let y = Axis::with_ticks(-0.37, 0.37, vec![-0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3]);
        let y = if number == 0 { y } else { y.unlabelled() };
        let panel = Panel { place, x: Axis::linear(-0.25, 0.5, 8), y };
        discs(&mut scene, &panel, &md, &start);
        show(&mut scene, &panel, &md, Stroke::solid(Colour::MD, 3.0), [1.0, -1.0]);
        let sides = if number == 0 { [1.0, 1.0] } else { [-1.0, 1.0] };
        show(&mut scene, &panel, &paths(name)?, Stroke::solid(colour, 1.4), sides);
        panel.frame(&mut scene);
        panel.labels(&mut scene, "*x* [m]", if number == 0 { "*y* [m]" } else { "" }, 38.0);
        let title = format!("{} and {}", MethodName::Md.label(), name.label().replace('*', "∗"));
        panel.title(&mut scene, &title);
        let lines = [
            ("MD", Stroke::solid(Colour::MD, 3.0)),
            (if number == 0 { "eMD" } else { "eMD∗" }, Stroke::solid(colour, 1.4)),
        ];
        panel.legend(&mut scene, [place.x + 14.0, place.y + 18.0], &lines);
    }
    Ok(scene)
}

fn follow(method: &mut dyn Method, scenario: &Scenario) -> Result<Paths> {
    let mut paths = Paths { lines: Default::default(), dots: Default::default(), before: None };
    let last = (scenario.duration.unwrap_or(0.0) / scenario.sample).round() as u32;
    for number in 0..=last * FINE {
        let (dot, rest) = (number / FINE, number % FINE);
        let time = f64::from(number) * scenario.sample / f64::from(FINE);
        let step = 1e-7 * scenario.sample;
        let touch = dot == FIRST_DOT && rest == 0;
        if touch {
            method.advance_to(time - step)?;
            let before = method.grains();
            paths.before = Some([0, 1].map(|i| flat(&before[i].position)));
        }
        // Just after the contact has begun or ended, whatever round-off says about its instant.
        method.advance_to(if rest == 0 { time + step } else { time })?;
        let grains = method.grains();
        for (i, grain) in grains.iter().enumerate().take(2) {
            let here = flat(&grain.position);
            let jump = paths.before.filter(|_| touch).map(|before| distance(before[i], here));
            if let (Some(before), Some(true)) = (paths.before, jump.map(|jump| jump > 1e-4)) {
                paths.lines[i].extend([before[i], [f64::NAN; 2]]);
            }
            paths.lines[i].push(here);
            if rest == 0 && (FIRST_DOT..FIRST_DOT + DOTS).contains(&dot) {
                paths.dots[i].push(here);
            }
        }
    }
    let jumped = |before: &[[f64; 2]; 2]| distance(before[0], paths.dots[0][0]) > 1e-4;
    paths.before = paths.before.filter(jumped);
    Ok(paths)
}

fn flat(position: &[f64; 3]) -> [f64; 2] {
    [position[0], position[1]]
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The dashed circles: both grains when they touch.
fn discs(scene: &mut Scene, panel: &Panel, md: &Paths, start: &Start) {
    let points_a_metre = panel.place.width / 0.75;
    for (dots, grain) in md.dots.iter().zip(&start.grains) {
        let centre = panel.at(dots[0][0], dots[0][1]);
        let pen = Stroke::dashed(Colour::FAINT, 1.0, 4.0, 3.0);
        let radius = grain.radius * points_a_metre;
        scene.disc(centre, radius, None, Some(pen), Some(panel.place));
    }
}

/// Paths with their dots; `sides` says on which side of each path the numbers stand.
fn show(scene: &mut Scene, panel: &Panel, paths: &Paths, pen: Stroke, sides: [f64; 2]) {
    let tone = pen.colour;
    for (i, side) in sides.into_iter().enumerate() {
        panel.line(scene, &paths.lines[i], pen);
        let dots = &paths.dots[i];
        // The first dot of a method that does not jump is MD's own.
        let shared = usize::from(tone != Colour::MD && paths.before.is_none());
        for (number, dot) in dots.iter().enumerate().skip(shared) {
            let (next, last) = (dots.get(number + 1).unwrap_or(dot), number.saturating_sub(1));
            let along = [next[0] - dots[last][0], next[1] - dots[last][1]];
            label(scene, panel, *dot, along, number, tone, side);
        }
        if let Some(before) = paths.before {
            label(scene, panel, before[i], [1.0, 0.0], 0, tone, side);
            let jump = Stroke::dashed(tone.with_opacity(0.6), 0.9, 1.5, 2.5);
            panel.line(scene, &[before[i], dots[0]], jump);
        }
    }
}

fn label(
    scene: &mut Scene,
    panel: &Panel,
    dot: [f64; 2],
    along: [f64; 2],
    number: usize,
    colour: Colour,
    side: f64,
) {
    panel.dot(scene, dot[0], dot[1], 2.5, colour);
    let [x, y] = panel.at(dot[0], dot[1]);
    let inside = x > panel.place.x && x < panel.place.x + panel.place.width;
    if !inside || y < panel.place.y || y > panel.place.y + panel.place.height {
        return;
    }
    let length = along[0].hypot(along[1]).max(1e-12);
    // To the right of the way for side 1, to the left for -1; y grows downwards on the page.
    let (dx, dy) = (side * along[1] / length, side * along[0] / length);
    let at = [x + 8.0 * dx, y + 8.0 * dy + 2.8];
    scene.text(at, &number.to_string(), Style::new(8.0, colour, Align::Middle));
}

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
    panel.legend(&mut scene, [300.0, 284.0], &legend);
    scene
}

fn error_curve(errors: &Errors, of: fn(&Errors, usize) -> Option<f64>) -> Vec<[f64; 2]> {
    let value = |k: usize| of(errors, k).filter(|e| *e > 0.0).map(|e| [k as f64 + 1.0, e]);
    (0..errors.by_collision.len()).filter_map(value).collect()
}

fn variant_tone(variant: Variant) -> Colour {
    match variant {
        Variant::Integrated => Colour::INK,
        Variant::Table => Colour::EMD_STAR,
        Variant::HardSphere => Colour::EMD,
    }
}

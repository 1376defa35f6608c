//! Where do two soft grains go? Reads MP13's Fig. 6 as a scenario; follows it by MD, eMD and eMD*, writes their paths as a scene.

use super::axes::{Axis, Panel};
use super::scene::{Colour, Rect, Scene, Stroke};
use super::text::{Align, Style};
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
        let close = dots.len() > 1 && near(panel, dots[0], dots[1]);
        // The first dot of a method that does not jump is MD's own.
        let shared = usize::from(tone != Colour::MD && paths.before.is_none());
        for (number, dot) in dots.iter().enumerate().skip(shared) {
            let (next, last) = (dots.get(number + 1).unwrap_or(dot), number.saturating_sub(1));
            let along = [next[0] - dots[last][0], next[1] - dots[last][1]];
            // Where dots stand close together, every second number stands further out.
            let far = if close && number % 2 == 1 { 17.0 } else { 8.0 };
            label(scene, panel, *dot, along, number, tone, side * far);
        }
        if let Some(before) = paths.before {
            label(scene, panel, before[i], [1.0, 0.0], 0, tone, 8.0 * side);
            let jump = Stroke::dashed(tone.with_opacity(0.6), 0.9, 1.5, 2.5);
            panel.line(scene, &[before[i], dots[0]], jump);
        }
    }
}

/// Whether the numbers of two dots would run together.
fn near(panel: &Panel, a: [f64; 2], b: [f64; 2]) -> bool {
    distance(panel.at(a[0], a[1]), panel.at(b[0], b[1])) < 7.0
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
    // To the right of the way where positive, to the left where negative; y grows downwards on the page.
    let (dx, dy) = (side * along[1] / length, side * along[0] / length);
    let at = [x + dx, y + dy + 2.8];
    scene.text(at, &number.to_string(), Style::new(8.0, colour, Align::Middle));
}

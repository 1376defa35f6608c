//! How do patterns look? Reads surfaces and how their waves have grown; writes a picture, each box repeated beside itself.

use super::course::{Course, Pattern};
use super::surface::Surface;
use crate::plot::text::{Align, Style};
use crate::plot::{Axis, Colour, Field, Panel, Rect, Scene, Stroke, colour_bar};

const SIDE: f64 = 250.0;
const TALL: f64 = 110.0;
const LEFT: f64 = 58.0;
const GAP: f64 = 70.0;
const TOP: f64 = 54.0;

/// The surfaces in the last cycle, and below each how its two waves have grown.
pub fn draw(found: &[(Course, Pattern)]) -> Scene {
    let wide = LEFT + (SIDE + GAP) * found.len() as f64;
    let mut scene = Scene::new(wide, TOP + SIDE + TALL + 175.0);
    let title = "A shaken layer of rough spheres, *Γ* = 3: mean height over the plate";
    scene.text([LEFT, 20.0], title, Style::new(11.0, Colour::INK, Align::Left));
    for (k, (course, pattern)) in found.iter().enumerate() {
        let x = LEFT + (SIDE + GAP) * k as f64;
        let letter = [["a", "c"], ["b", "d"]][k.min(1)];
        map(&mut scene, [x, TOP], course, pattern, letter[0]);
        growth(&mut scene, [x, TOP + SIDE + 120.0], course, pattern, letter[1]);
    }
    scene
}

fn map(scene: &mut Scene, [x, y]: [f64; 2], course: &Course, pattern: &Pattern, letter: &str) {
    let place = Rect { x, y, width: SIDE, height: SIDE };
    let surface = twice(&course.last(pattern.phase));
    let [low, high] = limits(&surface.heights);
    Field { columns: surface.places, values: surface.heights }.draw(scene, place, low, high);
    let axis = || Axis::linear(0.0, 2.0 * course.layer.side, 5);
    let panel = Panel { place, x: axis(), y: axis() };
    panel.frame(scene);
    panel.labels(scene, "*x* / *d*", "*y* / *d*", 40.0);
    panel
        .title(scene, &format!("({letter}) *f*∗ = {}: {}", course.layer.frequency, pattern.name()));
    let bar = Rect { x: x + 0.2 * SIDE, y: y + SIDE + 48.0, width: 0.6 * SIDE, height: 9.0 };
    colour_bar(scene, bar, low, high);
    let style = Style::new(9.0, Colour::INK, Align::Left);
    scene.text([bar.x + bar.width + 6.0, bar.y + 8.0], "*d*", style);
}

fn growth(scene: &mut Scene, [x, y]: [f64; 2], course: &Course, pattern: &Pattern, letter: &str) {
    let place = Rect { x, y, width: SIDE, height: TALL };
    let curves = pattern.waves.map(|wave| course.growth(pattern.phase, wave));
    let most = curves.iter().flatten().fold(0.0_f64, |most, point| most.max(point[1]));
    let cycles = course.cycles.len() as f64;
    let panel =
        Panel { place, x: Axis::linear(0.0, cycles, 6), y: Axis::linear(0.0, 1.15 * most, 4) };
    let strokes = [Stroke::solid(Colour::INK, 1.4), Stroke::dashed(Colour::EMD, 1.4, 5.0, 2.5)];
    for (curve, stroke) in curves.iter().zip(strokes) {
        panel.line(scene, curve, stroke);
    }
    panel.frame(scene);
    panel.labels(scene, "cycles", "half height / *d*", 40.0);
    panel.title(scene, &format!("({letter}) the highest wave, and the one across it (dashed)"));
}

/// Two by two of it.
fn twice(surface: &Surface) -> Surface {
    let places = 2 * surface.places;
    let one = |k: usize| {
        let [x, y] = [k % places, k / places].map(|at| at % surface.places.max(1));
        surface.heights[y * surface.places + x]
    };
    Surface { places, heights: (0..places * places).map(one).collect() }
}

fn limits(heights: &[f64]) -> [f64; 2] {
    let low = heights.iter().copied().fold(f64::INFINITY, f64::min);
    let high = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    [low.floor(), high.ceil()]
}

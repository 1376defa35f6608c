//! How do the grains look? Reads grains, box and obstacles; returns a scene: in space seen along y, in the plane along nothing.

use super::axes::{Axis, Panel};
use super::scene::{Colour, Rect, Scene, Stroke};
use crate::scenario::{Placed, Side, Start, Wall, present};
use tiny_skia::PathBuilder;

/// The longer side of the picture (points).
const LONG: f64 = 420.0;
const MARGIN: f64 = 58.0;
const TOP: f64 = 30.0;

/// Colours of species, then again from the first.
const COLOURS: [Colour; 6] = [
    Colour::BLUE,
    Colour::EMD,
    Colour::EMD_STAR,
    Colour::rgb(0xe0, 0xa0, 0x20),
    Colour::rgb(0x7a, 0x4f, 0xa3),
    Colour::rgb(0x60, 0x60, 0x60),
];

/// The facets of obstacles.
const WALL: Colour = Colour::rgb(0x55, 0x4a, 0x40);

/// Grains of a start as they are at some time, with its box and obstacles: in space across x and z, the nearest last.
pub fn grains(start: &Start, grains: &[Placed], title: &str) -> Scene {
    let view = View::new(start, grains);
    let Rect { width, height, .. } = view.panel.place;
    let mut scene = Scene::new(width + MARGIN + 20.0, height + TOP + 46.0);
    if start.dimension == 3 {
        view.in_depth(&mut scene, start, grains);
    } else {
        let there = present(grains);
        there.for_each(|(number, grain)| view.grain(&mut scene, start, number, grain));
        start.walls.iter().for_each(|wall| view.wall(&mut scene, wall));
    }
    view.panel.frame(&mut scene);
    let name = |axis: usize| format!("{} (m)", ["x", "y", "z"][axis]);
    let upwards = if start.dimension == 1 { String::new() } else { name(view.upward) };
    view.panel.labels(&mut scene, &name(0), &upwards, 44.0);
    view.panel.title(&mut scene, title);
    scene
}

/// What is seen, and how large.
struct View {
    /// The axis that leads up; 0, and not used, in one dimension.
    upward: usize,
    scale: f64,
    panel: Panel,
}

impl View {
    fn new(start: &Start, grains: &[Placed]) -> Self {
        let upward = start.dimension - 1;
        let x = extent(start, grains, 0);
        let y = if upward == 0 { band(grains) } else { extent(start, grains, upward) };
        let scale = LONG / (x[1] - x[0]).max(y[1] - y[0]);
        let [width, height] = [x, y].map(|[low, high]| (high - low) * scale);
        let panel = Panel {
            place: Rect { x: MARGIN, y: TOP, width, height },
            x: Axis::linear(x[0], x[1], ticks(width)),
            y: Axis::linear(y[0], y[1], ticks(height)),
        };
        Self { upward, scale, panel }
    }

    fn at(&self, position: &[f64; 3]) -> [f64; 2] {
        self.panel.at(position[0], if self.upward == 0 { 0.0 } else { position[self.upward] })
    }

    /// What is far behind first, grains and triangles alike.
    fn in_depth(&self, scene: &mut Scene, start: &Start, grains: &[Placed]) {
        let middle = |wall: &Wall| wall.corners.iter().map(|c| c[1]).sum::<f64>() / 3.0;
        let mut order: Vec<(f64, Result<usize, &Wall>)> =
            present(grains).map(|(k, grain)| (grain.position[1], Ok(k))).collect();
        order.extend(start.walls.iter().map(|wall| (middle(wall), Err(wall))));
        order.sort_by(|a, b| b.0.total_cmp(&a.0));
        for (_, what) in order {
            match what {
                Ok(k) => self.grain(scene, start, k, &grains[k]),
                Err(wall) => self.wall(scene, wall),
            }
        }
    }

    fn grain(&self, scene: &mut Scene, start: &Start, number: usize, grain: &Placed) {
        let species = start.species.get(number).copied().map_or(0, usize::from);
        let colour = COLOURS[species % COLOURS.len()];
        let edge = Stroke::solid(Colour::WHITE, 0.3);
        let (at, radius) = (self.at(&grain.position), grain.radius * self.scale);
        scene.disc(at, radius, Some(colour), Some(edge), Some(self.panel.place));
    }

    /// A segment as a line; a triangle so that one sees what is behind it.
    fn wall(&self, scene: &mut Scene, wall: &Wall) {
        let corners: Vec<[f64; 2]> = wall.corners.iter().map(|corner| self.at(corner)).collect();
        if let [from, to] = corners[..] {
            return scene.line(&[from, to], Stroke::solid(WALL, 1.6), Some(self.panel.place));
        }
        let mut path = PathBuilder::new();
        for (k, [x, y]) in corners.into_iter().enumerate() {
            let (x, y) = (x as f32, y as f32);
            if k == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
        }
        path.close();
        let (inside, edge) = (WALL.with_opacity(0.06), WALL.with_opacity(0.45));
        let edge = Stroke::solid(edge, 0.5);
        scene.shape(path.finish(), Some(inside), Some(edge), Some(self.panel.place));
    }
}

fn ticks(length: f64) -> usize {
    ((length / 70.0) as usize).max(4)
}

/// What is seen of an axis: the box, or else where grains and obstacles are.
fn extent(start: &Start, grains: &[Placed], axis: usize) -> [f64; 2] {
    if let Some(range) = start.sides[axis].range() {
        return range;
    }
    let corners = start.walls.iter().flat_map(|wall| &wall.corners).map(|corner| corner[axis]);
    let seen =
        present(grains).map(|(_, g)| [g.position[axis] - g.radius, g.position[axis] + g.radius]);
    let seen = seen.chain(corners.map(|x| [x, x]));
    let [low, high] = seen.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], [from, to]| {
        [low.min(from), high.max(to)]
    });
    let low = match start.sides[axis] {
        Side::Plate(plate, _) => plate.at - plate.amplitude.abs(),
        _ if low.is_finite() => low,
        _ => 0.0,
    };
    let high = if high > low { high } else { low + 1.0 };
    let edge = 0.03 * (high - low);
    [low - edge, high + edge]
}

/// A line is as high as its largest grain.
fn band(grains: &[Placed]) -> [f64; 2] {
    let largest = present(grains).map(|(_, grain)| grain.radius).fold(0.0, f64::max);
    [-1.5 * largest, 1.5 * largest]
}

//! Is a box still right? Reads a world; writes nothing, returns what is broken and what was measured.

use super::draw::{Drawn, DrawnPlane, Gravity};
use carom::{Scalar, View};

/// A grain in plain numbers.
#[derive(Clone, Copy, Debug)]
struct Seen {
    radius: f64,
    mass: f64,
    position: [f64; 3],
    velocity: [f64; 3],
}

/// The deepest overlap that is one and not a passage, in units of the smaller radius.
const DEEPEST: f64 = 0.9;

/// By how much of its scale energy may rise; in `f32` by three times, in a number of 16 binary places by ten times as
/// much: the errors of steps are random there, and heat.
const ENERGY: f64 = 1e-2;

/// What is followed of a box while it runs.
#[derive(Clone, Debug)]
pub(super) struct Watch {
    grains: Vec<Seen>,
    gravity: [f64; 3],
    /// The most that energy can be: what it was, and what changes of gravity added.
    energy: f64,
    scale: f64,
    is_driven: bool,
    is_line: bool,
    resolution: f64,
    planes: Vec<DrawnPlane>,
    /// The largest rise of energy, in units of its scale.
    pub rise: f64,
    /// The deepest overlap, in units of the smaller radius.
    pub deepest: f64,
    /// Whether a grain was seen deeper in something than is an overlap, or behind it.
    pub is_too_deep: bool,
}

fn plain<S: Scalar>(from: impl IntoIterator<Item = S>) -> [f64; 3] {
    let mut to = [0.0; 3];
    to.iter_mut().zip(from).for_each(|(x, value)| *x = value.to_f64());
    to
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn minus(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

fn look<S: Scalar, const D: usize>(view: View<'_, S, D>) -> Vec<Seen> {
    let seen = |i| {
        let grain = view.released(i)?;
        Some(Seen {
            radius: grain.radius.to_f64(),
            mass: grain.mass.to_f64(),
            position: plain(grain.position.iter().copied()),
            velocity: plain(grain.velocity.iter().copied()),
        })
    };
    (0..view.len()).filter_map(seen).collect()
}

impl Watch {
    /// A box as it starts.
    pub fn new<S: Scalar, const D: usize>(drawn: &Drawn, view: View<'_, S, D>) -> Self {
        let grains = look(view);
        let mass: f64 = grains.iter().map(|grain| grain.mass).sum();
        let gravity = plain(view.gravity().iter().copied());
        let mut watch = Self {
            grains,
            gravity,
            energy: 0.0,
            scale: 0.0,
            is_driven: drawn.gravity == Gravity::Plate,
            is_line: D == 1,
            resolution: S::RESOLUTION.to_f64(),
            planes: drawn.planes.clone(),
            rise: 0.0,
            deepest: 0.0,
            is_too_deep: false,
        };
        watch.energy = watch.total();
        // A radius high, or as fast as they start.
        let moving = watch.energy + watch.weight_on(&watch.grains);
        watch.scale = mass * dot(&gravity, &gravity).sqrt() + moving.max(1e-3 * mass);
        watch
    }

    /// Σ m g · r.
    fn weight_on(&self, grains: &[Seen]) -> f64 {
        grains.iter().map(|grain| grain.mass * dot(&self.gravity, &grain.position)).sum()
    }

    /// Kinetic and potential energy.
    fn total(&self) -> f64 {
        let kinetic = |grain: &Seen| grain.mass * dot(&grain.velocity, &grain.velocity) / 2.0;
        self.grains.iter().map(kinetic).sum::<f64>() - self.weight_on(&self.grains)
    }

    /// Gravity was changed: what that did to the potential energy is no rise.
    pub fn turn<S: Scalar, const D: usize>(&mut self, view: View<'_, S, D>) {
        self.grains = look(view);
        let before = self.total();
        self.gravity = plain(view.gravity().iter().copied());
        self.energy += self.total() - before;
    }

    /// Looks at the box again.
    ///
    /// # Errors
    /// What is broken.
    pub fn look<S: Scalar, const D: usize>(&mut self, view: View<'_, S, D>) -> Result<(), String> {
        let before = std::mem::replace(&mut self.grains, look(view));
        for (i, grain) in self.grains.iter().enumerate() {
            let mut all = grain.position.iter().chain(&grain.velocity);
            if !all.all(|x| x.is_finite()) {
                return Err(format!("grain {i} is nowhere"));
            }
        }
        let time = view.now().as_f64();
        self.behind_planes(time)?;
        self.through_grains(&before)?;
        if !self.is_driven {
            self.rise = self.rise.max((self.total() - self.energy) / self.scale);
        }
        let coarse = match self.resolution {
            1e-6.. => 10.0,
            1e-8.. => 3.0,
            _ => 1.0,
        };
        if self.rise > ENERGY * coarse {
            return Err(format!("energy rose by {:.1} % at {time}", 100.0 * self.rise));
        }
        Ok(())
    }

    fn behind_planes(&mut self, time: f64) -> Result<(), String> {
        for (p, plane) in self.planes.iter().enumerate() {
            let place = plane.vibration.map_or(0.0, |[amplitude, frequency]| {
                amplitude * (std::f64::consts::TAU * frequency * time).sin()
            });
            for (i, grain) in self.grains.iter().enumerate() {
                let gap = dot(&plane.normal, &grain.position) - plane.offset - place;
                let depth = 1.0 - gap / grain.radius;
                self.deepest = self.deepest.max(depth);
                if depth > DEEPEST {
                    self.is_too_deep = true;
                    return Err(format!("grain {i} is {depth:.2} radii in plane {p} at {time}"));
                }
            }
        }
        Ok(())
    }

    /// Grains do not pass through each other; in one dimension they stay in order.
    fn through_grains(&mut self, before: &[Seen]) -> Result<(), String> {
        for (i, a) in self.grains.iter().enumerate() {
            for (k, b) in self.grains.iter().enumerate().take(i) {
                let apart = minus(&a.position, &b.position);
                let distance = dot(&apart, &apart).sqrt();
                let depth = (a.radius + b.radius - distance) / a.radius.min(b.radius);
                self.deepest = self.deepest.max(depth);
                let was = minus(&before[i].position, &before[k].position);
                let passed = self.is_line && dot(&apart, &was) < 0.0;
                if depth > DEEPEST || passed {
                    self.is_too_deep = true;
                    return Err(format!("grains {i} and {k} overlap by {depth:.2} radii"));
                }
            }
        }
        Ok(())
    }

    /// Whether all that moves does so level: on a smooth floor nothing slows what slides, so it need not sleep.
    ///
    /// Numbers of few digits tremble: theirs may be faster.
    pub fn only_slides(&self) -> bool {
        let slow = 1e-3_f64.max(self.resolution * 5000.0);
        self.grains.iter().all(|grain| dot(&grain.velocity, &self.gravity).abs() < slow)
    }

    /// The largest speed.
    pub fn fastest(&self) -> f64 {
        let speed = |grain: &Seen| dot(&grain.velocity, &grain.velocity).sqrt();
        self.grains.iter().map(speed).fold(0.0, f64::max)
    }
}

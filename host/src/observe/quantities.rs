//! Which means are there, and how do they follow from the sums? Reads sums; writes nothing, names quantities and units.

use super::layout::{Contact, Layout, State, Wall};
use super::obstacles::{Observed, Struck};

/// A number that follows from sums.
pub struct Quantity {
    /// What it is.
    pub name: String,
    /// Of what: everything, a species, two species, a wall.
    pub of: String,
    /// Its unit.
    pub unit: &'static str,
    value: Value,
}

/// How it follows from sums.
type Value = Box<dyn Fn(&[f64]) -> f64>;

impl Quantity {
    pub(super) fn new(
        name: impl Into<String>,
        of: impl Into<String>,
        unit: &'static str,
        value: impl Fn(&[f64]) -> f64 + 'static,
    ) -> Self {
        Self { name: name.into(), of: of.into(), unit, value: Box::new(value) }
    }

    /// Its value; NaN or infinite where there is nothing to take it from.
    pub fn of(&self, sums: &[f64]) -> f64 {
        (self.value)(sums)
    }

    /// Name, of what, and unit: the head of a column, or of that of its errors.
    pub fn head(&self, what: &str) -> String {
        let Self { name, of, unit, .. } = self;
        let of = if of == ALL { String::new() } else { format!(" ({of})") };
        if unit.is_empty() {
            format!("{name}{of}{what}")
        } else {
            format!("{name}{of}{what} [{unit}]")
        }
    }
}

impl std::fmt::Debug for Quantity {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.head(""))
    }
}

pub(super) const ALL: &str = "all";
const AXES: [&str; 3] = ["x", "y", "z"];

/// All quantities of a system.
pub fn all(layout: &Layout) -> Vec<Quantity> {
    let mut list = temperatures(layout);
    list.extend(stresses(layout));
    list.extend(contacts(layout));
    list.extend(walls(layout));
    list.extend(obstacles(layout));
    list
}

/// For how many grains the squares of velocities along an axis count, those of all states.
fn freedom(layout: &Layout, species: usize, axis: usize) -> impl Fn(&[f64]) -> f64 + use<> {
    let total: f64 = layout.masses.iter().map(|(mass, count)| mass * *count as f64).sum();
    let alone = layout.masses.iter().map(|(_, count)| count).sum::<usize>() < 2;
    let part =
        if layout.is_drifting(axis) && !alone { layout.masses[species].0 / total } else { 0.0 };
    let place = layout.state(species, State::Count);
    move |sums| sums[place] * (1.0 - part)
}

/// Granular temperatures m ⟨v²⟩/D, in all and along each axis; kinetic energy; a₂.
fn temperatures(layout: &Layout) -> Vec<Quantity> {
    let (d, count) = (layout.dimension, layout.names.len());
    let mut list = vec![energy(layout), temperature(layout, &(0..count).collect::<Vec<_>>(), ALL)];
    for axis in (0..d).filter(|_| d > 1) {
        let squares: Vec<usize> =
            (0..count).map(|s| layout.state(s, State::Square(axis))).collect();
        let free: Vec<_> = (0..count).map(|s| freedom(layout, s, axis)).collect();
        let name = format!("temperature {}", AXES[axis]);
        list.push(Quantity::new(name, ALL, "J", move |sums| {
            let square: f64 = squares.iter().map(|&place| sums[place]).sum();
            square / free.iter().map(|free| free(sums)).sum::<f64>()
        }));
    }
    for (s, name) in layout.names.iter().enumerate() {
        if count > 1 {
            list.push(temperature(layout, &[s], name));
        }
        list.push(second_sonine(layout, s, if count > 1 { name } else { ALL }));
    }
    list
}

fn energy(layout: &Layout) -> Quantity {
    let places: Vec<usize> = (0..layout.dimension).map(|a| layout.stress(a, a)).collect();
    let states = layout.states();
    Quantity::new("kinetic energy of fluctuations", ALL, "J", move |sums| {
        0.5 * places.iter().map(|&place| sums[place]).sum::<f64>() / sums[states]
    })
}

fn temperature(layout: &Layout, species: &[usize], of: &str) -> Quantity {
    let d = layout.dimension;
    let terms: Vec<_> = species
        .iter()
        .flat_map(|&s| (0..d).map(move |a| (s, a)))
        .map(|(s, a)| (layout.state(s, State::Square(a)), freedom(layout, s, a)))
        .collect();
    Quantity::new("temperature", of, "J", move |sums| {
        let square: f64 = terms.iter().map(|(place, _)| sums[*place]).sum();
        square / terms.iter().map(|(_, free)| free(sums)).sum::<f64>()
    })
}

/// a₂ of Sonine's expansion: ⟨c⁴⟩ D/(⟨c²⟩² (D + 2)) − 1; 0 for a Maxwellian.
fn second_sonine(layout: &Layout, species: usize, of: &str) -> Quantity {
    let d = layout.dimension as f64;
    let at = |what| layout.state(species, what);
    let (count, second, fourth) = (at(State::Count), at(State::Second), at(State::Fourth));
    Quantity::new("a2", of, "", move |sums| {
        let (second, fourth) = (sums[second] / sums[count], sums[fourth] / sums[count]);
        d / (d + 2.0) * fourth / (second * second) - 1.0
    })
}

/// How many grains there are, in the mean of all states.
fn grains(layout: &Layout) -> impl Fn(&[f64]) -> f64 + Clone + use<> {
    let places: Vec<usize> =
        (0..layout.names.len()).map(|s| layout.state(s, State::Count)).collect();
    let states = layout.states();
    move |sums| places.iter().map(|&place| sums[place]).sum::<f64>() / sums[states]
}

/// The unit of a pressure in so many dimensions.
const PRESSURES: [&str; 3] = ["N", "N/m", "Pa"];

/// The pressure p = (N T + Σ r·Δp/(D t))/V, p V/(N T), and the stress of motion and of contacts.
fn stresses(layout: &Layout) -> Vec<Quantity> {
    let Some(volume) = layout.volume else { return Vec::new() };
    let (d, unit) = (layout.dimension, PRESSURES[layout.dimension - 1]);
    let states = layout.states();
    let part = |a: usize, b: usize| {
        let (moving, virial) = (layout.stress(a, b), layout.virial(a, b));
        move |sums: &[f64]| {
            (sums[moving] / sums[states] + sums[virial] / sums[Layout::TIME]) / volume
        }
    };
    let virial: Vec<usize> = (0..d).map(|a| layout.virial(a, a)).collect();
    let contacts = move |sums: &[f64]| {
        virial.iter().map(|&place| sums[place]).sum::<f64>() / (d as f64 * sums[Layout::TIME])
    };
    let grains = grains(layout);
    let temperature = temperature(layout, &(0..layout.names.len()).collect::<Vec<_>>(), ALL).value;
    let moving = move |sums: &[f64]| grains(sums) * temperature(sums);
    let both = (contacts.clone(), std::rc::Rc::new(moving));
    let again = both.1.clone();
    let mut list = vec![
        Quantity::new("pressure", ALL, unit, move |sums| (both.0(sums) + both.1(sums)) / volume),
        Quantity::new("compressibility factor", ALL, "", move |sums| {
            1.0 + contacts(sums) / again(sums)
        }),
    ];
    for a in (0..d).filter(|_| d > 1) {
        for (b, other) in AXES.iter().enumerate().take(d).skip(a) {
            let name = format!("stress {}{other}", AXES[a]);
            list.push(Quantity::new(name, ALL, unit, part(a, b)));
        }
    }
    list
}

/// Rates, mean free time, and what contacts of two grains are like.
fn contacts(layout: &Layout) -> Vec<Quantity> {
    let grains = grains(layout);
    let every: Vec<usize> =
        (0..layout.pairs()).map(|pair| layout.contact(pair, Contact::Count)).collect();
    let rate = move |sums: &[f64]| {
        let count: f64 = every.iter().map(|&place| sums[place]).sum();
        2.0 * count / (grains(sums) * sums[Layout::TIME])
    };
    let again = rate.clone();
    let mut list = vec![
        Quantity::new("collision rate of a grain", ALL, "1/s", rate),
        Quantity::new("mean free time", ALL, "s", move |sums| 1.0 / again(sums)),
    ];
    for b in 0..layout.names.len() {
        for a in 0..=b {
            let of = match layout.names.len() {
                1 => ALL.to_owned(),
                _ => format!("{} - {}", layout.names[a], layout.names[b]),
            };
            list.extend(contacts_of(layout, layout.pair(a, b), &of));
        }
    }
    list
}

fn contacts_of(layout: &Layout, pair: usize, of: &str) -> Vec<Quantity> {
    let at = |what| layout.contact(pair, what);
    let count = at(Contact::Count);
    let mean = |name: &str, unit, what| {
        let place = at(what);
        Quantity::new(name, of, unit, move |sums| sums[place] / sums[count])
    };
    let rate = |name: &str, unit, what| {
        let place = at(what);
        Quantity::new(name, of, unit, move |sums| sums[place] / sums[Layout::TIME])
    };
    vec![
        rate("contacts", "1/s", Contact::Count),
        rate("energy lost in contacts", "W", Contact::Loss),
        mean("speed of approach", "m/s", Contact::Approach),
        mean("coefficient of restitution", "", Contact::Restitution),
        mean("lasting contacts", "", Contact::Lasting),
        mean("contact duration", "s", Contact::Duration),
    ]
}

/// Rates, forces and losses at walls.
fn walls(layout: &Layout) -> Vec<Quantity> {
    let mut list = Vec::new();
    for (wall, (name, area)) in layout.walls.iter().enumerate() {
        let of = format!("wall {name}");
        let rate = |name: &str, unit, what, by: f64| {
            let place = layout.wall(wall, what);
            Quantity::new(name, &of, unit, move |sums| sums[place] / (sums[Layout::TIME] * by))
        };
        list.push(rate("contacts", "1/s", Wall::Count, 1.0));
        list.push(rate("force", "N", Wall::Push, 1.0));
        if let Some(area) = area.filter(|_| layout.dimension > 1) {
            list.push(rate("pressure", PRESSURES[layout.dimension - 1], Wall::Push, area));
        }
        list.push(rate("energy lost in contacts", "W", Wall::Loss, 1.0));
    }
    list
}

/// Rates of contacts, forces and losses at obstacles, and the torques on those that turn.
fn obstacles(layout: &Layout) -> Vec<Quantity> {
    let numbered = layout.obstacles.iter().enumerate();
    numbered.flat_map(|(number, obstacle)| of_obstacle(layout, number, obstacle)).collect()
}

fn of_obstacle(layout: &Layout, number: usize, obstacle: &Observed) -> Vec<Quantity> {
    let rate = |name: &str, unit, what| {
        let place = layout.obstacle(number, what);
        Quantity::new(name, &obstacle.name, unit, move |sums| sums[place] / sums[Layout::TIME])
    };
    let axes = AXES.into_iter().enumerate().take(layout.dimension);
    let mut list = vec![rate("contacts", "1/s", Struck::Count)];
    list.extend(axes.clone().map(|(k, x)| rate(&format!("force {x}"), "N", Struck::Momentum(k))));
    if obstacle.centre.is_some() {
        match layout.dimension {
            2 => list.push(rate("torque", "N m", Struck::Turn(2))),
            _ => {
                list.extend(axes.map(|(k, x)| rate(&format!("torque {x}"), "N m", Struck::Turn(k))))
            }
        }
    }
    list.push(rate("energy lost in contacts", "W", Struck::Loss));
    list
}

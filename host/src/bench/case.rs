//! Which gases are timed? Reads nothing; writes their descriptions.

/// What happens when two grains of a case touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contact {
    /// Hard spheres of diameter 1, mass 1 and k T = 1 at this number density, with this ε.
    Hard {
        /// Grains per unit of volume, area or length.
        density: f64,
        /// ε.
        restitution: f64,
    },
    /// MP13's elastic viscoelastic grains (Y = 1 GPa, ν = 0.4, R = 0.1 m, ρ = 1140 kg/m³, thermal
    /// speed 2 m/s, Sec. VI B 6) at this packing fraction.
    Viscoelastic {
        /// Fraction of the box that the grains fill.
        packing: f64,
        /// With the matrix of restitution (eMD*), or as hard spheres with the law's ε(v) (eMD).
        star: bool,
    },
}

/// Large grains among the others, of the same density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Large {
    /// How many times as large as the others.
    pub ratio: usize,
    /// How many there are.
    pub count: usize,
}

/// One gas in a periodic box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    /// As the command line and the JSON call it.
    pub name: &'static str,
    /// 1, 2 or 3.
    pub dimension: usize,
    /// How many grains.
    pub count: usize,
    /// What they do.
    pub contact: Contact,
    /// Those of another size that fill as much of the box, if there are some.
    pub large: Option<Large>,
    /// How many collisions are timed.
    pub collisions: u64,
    /// What others reach on a quiet core of this kind (collisions/s), and who.
    pub others: &'static [(&'static str, f64)],
}

/// Number density of the hard-sphere cases: packing fraction 0.2618 in three dimensions, 0.3927 in two.
const DENSITY: f64 = 0.5;
/// A packing fraction of spheres of diameter 1 as a number density.
const fn packed(fraction: f64) -> f64 {
    fraction * 6.0 / std::f64::consts::PI
}

const C_CODE: &str = "C code (arXiv:2201.01100)";
const DYNAMO: &str = "DynamO";

const fn hard(
    name: &'static str,
    dimension: usize,
    count: usize,
    collisions: u64,
    others: &'static [(&'static str, f64)],
) -> Case {
    let contact = Contact::Hard { density: DENSITY, restitution: 1.0 };
    Case { name, dimension, count, contact, large: None, collisions, others }
}

const fn soft(name: &'static str, packing: f64, star: bool) -> Case {
    let contact = Contact::Viscoelastic { packing, star };
    let (count, collisions, large) = (10_000, 100_000, None);
    Case { name, dimension: 3, count, contact, large, collisions, others: &[] }
}

/// So many large spheres, and small ones that together fill as much.
const fn sizes(name: &'static str, ratio: usize, large: usize) -> Case {
    let count = large * ratio.pow(3);
    let Case { contact, .. } = hard(name, 3, count, 1_000_000, &[]);
    let large = Some(Large { ratio, count: large });
    Case { name, dimension: 3, count, contact, large, collisions: 1_000_000, others: &[] }
}

/// All cases, in the order in which they run.
pub const ALL: [Case; 16] = [
    hard("hs3d-1372", 3, 1_372, 1_000_000, &[(C_CODE, 589e3), (DYNAMO, 140e3)]),
    hard("hs3d-13500", 3, 13_500, 1_000_000, &[(C_CODE, 516e3), (DYNAMO, 119e3)]),
    hard("hs3d-108000", 3, 108_000, 1_000_000, &[(C_CODE, 313e3), (DYNAMO, 70e3)]),
    hard("hs3d-1000000", 3, 1_000_000, 2_000_000, &[]),
    Case {
        contact: Contact::Hard { density: packed(0.01), restitution: 1.0 },
        ..hard("hs3d-dilute", 3, 13_500, 500_000, &[(C_CODE, 206e3)])
    },
    Case {
        contact: Contact::Hard { density: packed(0.001), restitution: 1.0 },
        ..hard("hs3d-dilute-0.001", 3, 13_500, 100_000, &[])
    },
    Case {
        contact: Contact::Hard { density: DENSITY, restitution: 0.9 },
        ..hard("ihs3d-13500", 3, 13_500, 500_000, &[])
    },
    hard("hd2d-1024", 2, 1_024, 1_000_000, &[(DYNAMO, 201e3)]),
    hard("rod1d-1000", 1, 1_000, 1_000_000, &[(DYNAMO, 361e3)]),
    hard("small-32", 3, 32, 1_000_000, &[(DYNAMO, 181e3)]),
    soft("emdstar-10000-0.001", 0.001, true),
    soft("emdstar-10000-0.01", 0.01, true),
    soft("emd-10000-0.001", 0.001, false),
    soft("emd-10000-0.01", 0.01, false),
    sizes("ratio-10", 10, 100),
    sizes("ratio-20", 20, 14),
];

/// The case of this name, or all whose names continue it after a dash.
pub fn named(name: &str) -> Vec<Case> {
    let exact: Vec<Case> = ALL.into_iter().filter(|case| case.name == name).collect();
    if !exact.is_empty() {
        return exact;
    }
    let begins = |case: &Case| case.name.strip_prefix(name).is_some_and(|r| r.starts_with('-'));
    ALL.into_iter().filter(begins).collect()
}

impl Case {
    /// The radius of a grain.
    pub const fn radius(&self) -> f64 {
        match self.contact {
            Contact::Hard { .. } => 0.5,
            Contact::Viscoelastic { .. } => 0.1,
        }
    }

    /// The mass of a grain.
    pub fn mass(&self) -> f64 {
        match self.contact {
            Contact::Hard { .. } => 1.0,
            Contact::Viscoelastic { .. } => 1140.0 * sphere(0.1),
        }
    }

    /// The standard deviation of a component of the velocity.
    pub fn speed(&self) -> f64 {
        match self.contact {
            Contact::Hard { .. } => 1.0,
            Contact::Viscoelastic { .. } => 2f64.sqrt(),
        }
    }

    /// How many grains there are, large ones included.
    pub fn total(&self) -> usize {
        self.count + self.large.map_or(0, |large| large.count)
    }

    /// The edge of the box. The large ones fill as much as the others.
    pub fn edge(&self) -> f64 {
        let density = match self.contact {
            Contact::Hard { density, .. } => density,
            Contact::Viscoelastic { packing, .. } => packing / sphere(0.1),
        };
        let equal = self.count + self.large.map_or(0, |_| self.count);
        (equal as f64 / density).powf(1.0 / self.dimension as f64)
    }
}

/// The volume of a sphere.
fn sphere(radius: f64) -> f64 {
    4.0 / 3.0 * std::f64::consts::PI * radius.powi(3)
}

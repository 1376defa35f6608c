//! Which scenes are replayed? Reads nothing; builds a world in borrowed memory.

use carom::law::embedded::read::{Law, StoredNumber, Table};
use carom::law::embedded::{Compact, Standard, TableSet, wide};
use carom::law::{
    HardSphere, IntegratedMode, LinearDashpot, Outside, PaperMode, Rough, Rule, Soft, Tangential,
    Viscoelastic,
};
use carom::scalar::I32F32;
use carom::space::ContactState;
#[cfg(feature = "plates")]
use carom::space::{Plane, Surface, Vibration};
use carom::world::{Rotating, WithContacts};
use carom::{Enduring, Error, Grain, Memory, Scalar, Storage, World};

/// The scenes that every target replays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scene {
    /// The soft pair of MP13's Fig. 6, in a periodic box so that it collides again and again.
    Fig6,
    /// Sixteen viscoelastic grains in a 2D box under gravity, which turns by a quarter now and then.
    Box16,
    /// A 3D periodic gas of 32 elastic Hertzian spheres.
    Gas32,
    /// A column of ten beads on a vibrating plate, in one dimension.
    Column10,
    /// [`Scene::Box16`] by the default mode: a heap whose contacts are integrated.
    Heap16,
    /// The same of hard grains, which fall asleep between two turns.
    Hard16,
    /// [`Scene::Hard16`] of rough grains, which roll, slide and stick.
    Rough16,
    /// Sixteen hard grains in an hourglass of segments, which turns by a quarter now and then.
    Hourglass16,
}

impl Scene {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::Fig6,
        Self::Box16,
        Self::Gas32,
        Self::Column10,
        Self::Heap16,
        Self::Hard16,
        Self::Rough16,
        Self::Hourglass16,
    ];

    /// Its name in the golden file.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Fig6 => "fig6",
            Self::Box16 => "box16",
            Self::Gas32 => "gas32",
            Self::Column10 => "column10",
            Self::Heap16 => "heap16",
            Self::Hard16 => "hard16",
            Self::Rough16 => "rough16",
            Self::Hourglass16 => "hourglass16",
        }
    }
}

/// A number of these units.
pub(crate) fn n<S: Scalar>(value: f64) -> S {
    S::from_f64(value)
}

/// A vector of numbers of these units.
pub(crate) fn v<S: Scalar, const D: usize>(values: [f64; D]) -> [S; D] {
    values.map(n)
}

/// A grain of the unit's density.
pub(crate) fn grain<S: Scalar, const D: usize>(
    radius: f64,
    at: [f64; D],
    moving: [f64; D],
) -> Grain<S, D> {
    Grain::with_mass(n(radius), n(radius * radius * radius)).at(v(at)).moving(v(moving))
}

/// Gravity: 9.81 m/s² in mm/ms².
pub const GRAVITY: f64 = 9.81e-3;

/// A number type in which everything here runs.
pub trait Number: Scalar {
    /// Its name.
    const NAME: &str;
    /// The number in which its tables are stored.
    type Stored: StoredNumber;
    /// The compact table of the viscoelastic law.
    fn compact() -> &'static Table<Self::Stored>;
    /// The standard table of the viscoelastic law.
    fn standard() -> &'static Table<Self::Stored>;
    /// The standard table of linear spring-dashpots.
    fn standard_dashpot() -> &'static Table<Self::Stored>;
}

macro_rules! number {
    ($type:ident) => {
        impl Number for $type {
            const NAME: &str = stringify!($type);
            type Stored = <Standard as TableSet<$type>>::Stored;
            fn compact() -> &'static Table<Self::Stored> {
                <Compact as TableSet<$type>>::table(Law::Viscoelastic)
            }
            fn standard() -> &'static Table<Self::Stored> {
                <Standard as TableSet<$type>>::table(Law::Viscoelastic)
            }
            fn standard_dashpot() -> &'static Table<Self::Stored> {
                <Standard as TableSet<$type>>::table(Law::LinearDashpot)
            }
        }
    };
}

number!(f32);
number!(f64);
number!(I32F32);

/// Linear spring-dashpots.
pub type Dashpot<S, C> = Soft<LinearDashpot<S>, C>;
/// Viscoelastic spheres.
pub type Rubber<S> = Soft<Viscoelastic<S>, <S as Number>::Stored>;

/// Rubber of 5 MPa with A = 0.01 ms, read from this table.
pub(crate) fn rubber<S: Number>(table: &'static Table<S::Stored>) -> Rubber<S> {
    let law = Viscoelastic { young: n(477.5), poisson: n(0.4), dissipation: n(0.01) };
    Soft::with_table(law, table, Outside::HardSphere)
}

/// A world whose rule is asked by a pointer. The engine is compiled once for all of these, not for each rule anew.
pub type AnyWorld<'m, S, const D: usize> = World<'m, S, D, &'m dyn Rule<S>>;

/// The rule of [`Scene::Fig6`]: k = 2 kN/m, elastic (MP13 §VI.A).
#[must_use]
pub fn spring<S: Number>() -> Dashpot<S, f32> {
    let law = LinearDashpot { stiffness: n(2000.0), damping: n(0.0) };
    Soft::with_table(law, &wide::LINEAR_DASHPOT, Outside::Clamp)
}

/// MP13 §VI.A: R = 0.1 m, ρ = 1140 kg/m³; here in a periodic box of one metre.
///
/// # Errors
/// None unless the memory is too small.
pub fn fig6<'m, S: Number>(
    memory: &'m mut impl Storage<S, 2>,
    rule: &'m dyn Rule<S>,
) -> Result<AnyWorld<'m, S, 2>, Error> {
    let pair = |at, moving| Grain::with_mass(n(0.1), n(4.775_220_8)).at(v(at)).moving(v(moving));
    World::builder(memory)
        .enduring(Enduring::Paper)
        .periodic([v([-0.5, 0.5]); 2])
        .rule(rule)
        .grain(pair([0.0175, -0.120_393_92], [1.25, 2.5]))?
        .grain(pair([-0.0425, 0.120_393_92], [1.25, -2.5]))?
        .start()
}

/// The rule of [`Scene::Box16`]: contacts end each other as in MP13.
#[must_use]
pub fn paper_rubber<S: Number>() -> PaperMode<Rubber<S>> {
    PaperMode(rubber(S::standard()))
}

/// The rule of [`Scene::Heap16`]: the same by the default mode.
#[must_use]
pub fn heaped_rubber<S: Number>() -> IntegratedMode<Rubber<S>> {
    IntegratedMode(rubber(S::standard()))
}

/// The rule of [`Scene::Hard16`] and [`Scene::Hourglass16`].
#[must_use]
pub fn hard<S: Scalar>() -> IntegratedMode<HardSphere<S>> {
    IntegratedMode(HardSphere { restitution: n(0.5) })
}

/// Hard spheres with rough surfaces.
pub type Rough16<S> = IntegratedMode<Rough<HardSphere<S>, S>>;

/// Memory for sixteen of them.
pub type RoughBox<S> = Rotating<WithContacts<Memory<S, 2, 16>, [ContactState<S>; 80]>, [S; 16]>;

/// That memory, empty.
#[must_use]
pub fn rough_box<S: Scalar>() -> RoughBox<S> {
    let memory = WithContacts::new(Memory::new(), [ContactState::VACANT; 80]);
    Rotating::new(memory, [[S::zero(); 16]; 3])
}

/// The rule of [`Scene::Rough16`].
#[must_use]
pub fn rough<S: Scalar>() -> Rough16<S> {
    let tangential = Tangential::Walton { mu: n(0.5), beta_0: n(0.3) };
    IntegratedMode(Rough::spheres(HardSphere { restitution: n(0.5) }, tangential))
}

/// One of sixteen grains of 0.7 to 1.3 mm, on a lattice in a box of 12 mm.
pub(crate) fn sixteen<S: Scalar>(k: u32) -> Grain<S, 2> {
    let (column, row, odd) = (f64::from(k % 4), f64::from(k / 4), f64::from(k * 7 % 16));
    let at = [1.5 + 3.0 * column, 1.5 + 3.0 * row];
    grain(0.7 + 0.04 * odd, at, [0.02 * (odd - 7.5), 0.03 * (column - row)])
}

/// Sixteen grains of 0.7 to 1.3 mm in a box of 12 mm.
///
/// # Errors
/// None unless the memory is too small.
pub fn box16<'m, S: Number>(
    memory: &'m mut impl Storage<S, 2>,
    rule: &'m dyn Rule<S>,
) -> Result<AnyWorld<'m, S, 2>, Error> {
    World::builder(memory)
        .walls([v([0.0, 12.0]); 2])
        .gravity(v([0.0, -GRAVITY]))
        .rule(rule)
        .grains((0..16).map(sixteen))?
        .start()
}

/// How long gravity of [`box16`] stays as it is.
pub const QUARTER: u32 = 64;

/// Gravity of [`box16`] after so many quarter turns.
#[must_use]
pub fn turned<S: Scalar>(quarters: u32) -> [S; 2] {
    v(match quarters % 4 {
        0 => [0.0, -GRAVITY],
        1 => [GRAVITY, 0.0],
        2 => [0.0, GRAVITY],
        _ => [-GRAVITY, 0.0],
    })
}

/// Elastic rubber: what the gases are of.
#[must_use]
pub fn elastic<S: Number>() -> Rubber<S> {
    let law = Viscoelastic { young: n(477.5), poisson: n(0.4), dissipation: n(0.0) };
    Soft::with_table(law, S::standard(), Outside::HardSphere)
}

/// 32 equal spheres of 1 mm at the sites of a cubic lattice in a periodic box of so many millimetres, of which they fill
/// 134/side³: at 24 mm a hundredth.
///
/// # Errors
/// None unless the memory is too small.
#[inline(never)]
pub fn gas32<S: Number, R: Rule<S>>(
    memory: &mut impl Storage<S, 3>,
    rule: R,
    side: u32,
) -> Result<World<'_, S, 3, R>, Error> {
    let part = f64::from(side) / 8.0;
    let site = |k: u32| {
        let at = [k % 4, k / 4 % 4, k / 16].map(|i| part * (1.0 + 2.0 * f64::from(i)));
        grain(1.0, at, [5, 11, 3].map(|prime| 0.02 * (f64::from(k * prime % 32) - 15.5)))
    };
    World::builder(memory)
        .enduring(Enduring::Paper)
        .periodic([[n(0.0), S::from_count(side)]; 3])
        .rule(rule)
        .grains((0..32).map(site))?
        .start()
}

/// The rule of [`Scene::Column10`].
#[must_use]
pub fn bead<S: Number>() -> Dashpot<S, S::Stored> {
    let law = LinearDashpot { stiffness: n(1000.0), damping: n(1.5) };
    Soft::with_table(law, S::standard_dashpot(), Outside::HardSphere)
}

/// Ten beads of 1 mm on a plate of amplitude 1 mm at 25 Hz: 2.5 times gravity.
///
/// # Errors
/// None unless the memory is too small.
#[cfg(feature = "plates")]
pub fn column10<'m, S: Number>(
    memory: &'m mut impl Storage<S, 1>,
    rule: &'m dyn Rule<S>,
) -> Result<AnyWorld<'m, S, 1>, Error> {
    let plate = Plane::new(v([1.0]), n(0.0), Surface::Rule);
    let bead = |k: u32| grain(1.0, [1.5 + 2.25 * f64::from(k)], [0.0]);
    World::builder(memory)
        .enduring(Enduring::Paper)
        .plane(plate.vibrating(Vibration::new(n(1.0), n(0.025))))
        .gravity(v([-GRAVITY]))
        .rule(rule)
        .grains((0..10).map(bead))?
        .start()
}

//! Where do grains go at random? Reads radii and a region; writes nothing, returns places without overlap.

use super::clear::Obstacles;
use super::compress::{self, Growth};
use super::near::Cells;
use super::problem::{Problem, named};
use super::region::Region;
use super::side::{Placed, Side, filled};
use rand::RngExt;
use rand_pcg::Pcg64;

/// Grains to be placed, and what is there already.
#[derive(Clone, Copy)]
pub struct Crowd<'a> {
    /// Which field of the scenario asks for them.
    pub path: &'a str,
    /// Where they may be.
    pub region: Region,
    /// What bounds the box.
    pub sides: &'a [Side; 3],
    /// What stands in it.
    pub obstacles: &'a Obstacles,
    /// Their radii, largest first.
    pub radii: &'a [f64],
    /// Grains that are there.
    pub others: &'a [Placed],
}

/// Tries to place one grain before a region is called full.
const TRIES: usize = 20_000;

/// Up to which packing fraction grains find places one after the other without many tries, by dimension.
const DILUTE: [f64; 3] = [0.6, 0.45, 0.3];

/// As what part of their size grains are not tried to be placed smaller.
const SMALLEST: f64 = 0.1;

/// The densest packing of equal spheres, by dimension.
const DENSEST: [f64; 3] = [1.0, 0.906_899_682_117_109, 0.740_480_489_693_061];

impl Crowd<'_> {
    /// The packing fraction that they have in the region.
    fn packing(&self) -> f64 {
        let dimension = self.region.dimension;
        self.radii.iter().map(|radius| filled(*radius, dimension)).sum::<f64>()
            / self.region.volume()
    }

    fn problem(&self, message: &str) -> Problem {
        let message = format!("{}: {message}", named(self.path));
        Problem { path: self.path.to_owned(), offset: None, message }
    }

    /// Where a centre may be.
    fn range(&self, radius: f64) -> Result<[[f64; 2]; 3], Problem> {
        let mut range = self.region.axes;
        for (axis, [low, high]) in range.iter_mut().enumerate().take(self.region.dimension) {
            if !self.region.periodic[axis] {
                (*low, *high) = (*low + radius, *high - radius);
            }
            if *low > *high || self.region.length(axis) < 2.0 * radius {
                let name = ["x", "y", "z"][axis];
                let message = format!("a grain of radius {radius} does not fit along {name}");
                return Err(self.problem(&message));
            }
        }
        Ok(range)
    }
}

/// Places without overlap: one after the other while the region is dilute, else by compression.
///
/// # Errors
/// When so many grains cannot be placed.
pub fn fill(crowd: &Crowd<'_>, rng: &mut Pcg64) -> Result<Vec<[f64; 3]>, Problem> {
    if crowd.packing() <= DILUTE[crowd.region.dimension - 1]
        && let Ok(places) = anew_until_free(crowd, 1.0, rng)
    {
        return Ok(places);
    }
    compressed(crowd, rng)
}

/// Uniformly, one after the other, each anew until it overlaps nothing. Grains are as large as `scale` says, but where they
/// would overlap obstacles in their full size they are not placed.
///
/// # Errors
/// When one finds no place.
pub fn anew_until_free(
    crowd: &Crowd<'_>,
    scale: f64,
    rng: &mut Pcg64,
) -> Result<Vec<[f64; 3]>, Problem> {
    let mut grains = crowd.others.to_vec();
    let largest = crowd.radii.iter().map(|radius| scale * radius).fold(0.0, f64::max);
    let mut cells = Cells::of(crowd.others, largest, crowd.sides);
    for (number, &full) in crowd.radii.iter().enumerate() {
        let radius = scale * full;
        let range = crowd.range(radius)?;
        let mut place = || range.map(|[from, to]| from + (to - from) * rng.random::<f64>());
        let is_good = |place: &[f64; 3]| {
            cells.is_free(place, radius, &grains) && crowd.obstacles.are_clear_of(place, full)
        };
        let Some(position) = std::iter::repeat_with(&mut place).take(TRIES).find(is_good) else {
            let clear = if crowd.obstacles.are_none() { "" } else { " clear of obstacles" };
            let message = format!("no place{clear} found for grain {number} in {TRIES} tries");
            return Err(crowd.problem(&message));
        };
        cells.add(grains.len(), &position);
        grains.push(Placed { radius, mass: 0.0, position, velocity: [0.0; 3] });
    }
    Ok(grains[crowd.others.len()..].iter().map(|grain| grain.position).collect())
}

/// Grains that are placed small and grow while they fly and collide.
///
/// # Errors
/// When they jam before they are as large as they should be.
pub fn compressed(crowd: &Crowd<'_>, rng: &mut Pcg64) -> Result<Vec<[f64; 3]>, Problem> {
    let dimension = crowd.region.dimension;
    let packing = crowd.packing();
    let (densest, dilute) = (DENSEST[dimension - 1], DILUTE[dimension - 1]);
    let are_equal = crowd.radii.first() == crowd.radii.last();
    if packing >= 1.0 || are_equal && packing > densest {
        let most =
            if are_equal { format!("{densest:.4}, the densest there is") } else { "1".to_owned() };
        return Err(crowd.problem(&format!(
            "a packing fraction of {packing:.4} cannot be reached, at most {most}"
        )));
    }
    crowd.radii.first().map_or(Ok([[0.0; 2]; 3]), |&radius| crowd.range(radius))?;
    let scale = (0.6 * dilute / packing).powf(1.0 / dimension as f64).min(0.8);
    let (scale, start) = small(crowd, scale, rng)?;
    let Crowd { region, radii, others, obstacles, .. } = *crowd;
    let growth = Growth { region, radii, others, obstacles, scale };
    compress::grow(&growth, start, rng).map_err(|jammed| {
        let jammed = packing * jammed.0.powi(dimension as i32);
        crowd.problem(&format!(
            "a packing fraction of {packing:.4} cannot be reached: compressed at random, these grains jam at {jammed:.4}"
        ))
    })
}

/// Places for grains that are this small, or smaller where obstacles leave too little room for that.
fn small(crowd: &Crowd<'_>, scale: f64, rng: &mut Pcg64) -> Result<(f64, Vec<[f64; 3]>), Problem> {
    match anew_until_free(crowd, scale, rng) {
        Err(_) if scale > SMALLEST && !crowd.obstacles.are_none() => small(crowd, 0.7 * scale, rng),
        placed => placed.map(|places| (scale, places)),
    }
}

//! Where do grains go that are put in order, on a lattice, in a layer or a heap? Reads a crowd; writes nothing, returns places.

use super::fill::Crowd;
use super::grains::PlaceSpec;
use super::lattice;
use super::near::Cells;
use super::problem::{Problem, named};
use super::side::{Placed, Side};
use super::stack::Ground;
use rand::seq::SliceRandom;
use rand_pcg::Pcg64;

/// A hair more than touching, so that rounding is no overlap.
const MARGIN: f64 = 1.0 + 1e-9;

/// How far apart rows of a layer are if nothing else is said, in diameters.
const GAP: f64 = 0.05;

/// Places for all, in the order of their radii; who gets which of them is drawn.
///
/// # Errors
/// When there is no floor, or somebody overlaps something.
pub fn arrange(
    crowd: &Crowd<'_>,
    place: &PlaceSpec,
    gravity: &[f64; 3],
    rng: &mut Pcg64,
) -> Result<Vec<[f64; 3]>, Problem> {
    let count = crowd.radii.len();
    let widest = 2.0 * crowd.radii.first().copied().unwrap_or_default();
    let ground =
        |spacing: f64| up(crowd, gravity).map(|up| Ground { up, region: crowd.region, spacing });
    let mut places = match place {
        PlaceSpec::Lattice { lattice, .. } => {
            let sites = |wanted| lattice::sites(*lattice, &crowd.region, wanted);
            thinned(&clear(crowd, sites)?, count)
        }
        PlaceSpec::Layer { gap, .. } => {
            let ground = ground(widest * (1.0 + gap.unwrap_or(GAP)).max(MARGIN))?;
            free(crowd, ground.layer().take(MOST_SITES + SITES_PER_GRAIN * count))
                .take(count)
                .collect()
        }
        PlaceSpec::Pile { at } => {
            let middle: [f64; 3] = crowd.region.axes.map(|[low, high]| 0.5 * (low + high));
            let at = std::array::from_fn(|axis| {
                at.as_ref().and_then(|at| at.get(axis).copied()).unwrap_or(middle[axis])
            });
            let ground = ground(widest * MARGIN)?;
            clear(crowd, |wanted| ground.pile(wanted, at))?
        }
        PlaceSpec::Fill { .. } | PlaceSpec::File { .. } => Vec::new(),
    };
    places.truncate(count);
    if places.len() < count {
        return Err(too_few(crowd, places.len()));
    }
    places.shuffle(rng);
    check(crowd, &places)?;
    Ok(places)
}

fn problem(crowd: &Crowd<'_>, message: &str) -> Problem {
    let message = format!("{}: {message}", named(crowd.path));
    Problem { path: format!("{}.place", crowd.path), offset: None, message }
}

/// The axis that leads up from the floor: the plate's, or else that of gravity.
fn up(crowd: &Crowd<'_>, gravity: &[f64; 3]) -> Result<usize, Problem> {
    let axes = 0..crowd.region.dimension;
    let plate = axes.clone().find(|axis| matches!(crowd.sides[*axis], Side::Plate(..)));
    let heaviest = axes.max_by(|a, b| gravity[*a].abs().total_cmp(&gravity[*b].abs())).unwrap_or(0);
    let falls = gravity[heaviest] < 0.0 && !crowd.region.periodic[heaviest];
    plate.or(falls.then_some(heaviest)).ok_or_else(|| {
        problem(crowd, "there is no floor: a plate is needed, or gravity towards a lower wall")
    })
}

/// Those of the sites at which the largest grain would overlap nothing that is there.
fn free<'c>(
    crowd: &'c Crowd<'_>,
    sites: impl Iterator<Item = [f64; 3]> + 'c,
) -> impl Iterator<Item = [f64; 3]> + 'c {
    let radius = crowd.radii.first().copied().unwrap_or_default();
    let cells = Cells::of(crowd.others, radius, crowd.sides);
    let is_clear = move |site: &[f64; 3]| crowd.obstacles.are_clear_of(site, radius);
    sites.filter(move |site| cells.is_free(site, radius, crowd.others) && is_clear(site))
}

/// Rows of a layer are given up after so many sites.
const MOST_SITES: usize = 10_000_000;

/// A lattice or a heap is given up after so many sites a grain, and as many as for ten grains besides.
const SITES_PER_GRAIN: usize = 100;

fn too_few(crowd: &Crowd<'_>, found: usize) -> Problem {
    let count = crowd.radii.len();
    problem(crowd, &format!("{count} grains do not fit, found {found} places clear of obstacles"))
}

/// Of sites, of which there are as many as one wants, those at which the largest grain overlaps no obstacle: as few are
/// wanted as give enough.
fn clear(
    crowd: &Crowd<'_>,
    sites: impl Fn(usize) -> Vec<[f64; 3]>,
) -> Result<Vec<[f64; 3]>, Problem> {
    let count = crowd.radii.len();
    let largest = crowd.radii.first().copied().unwrap_or_default();
    let left = |wanted: usize| {
        let mut sites = sites(wanted);
        sites.retain(|site| crowd.obstacles.are_clear_of(site, largest));
        sites
    };
    let (mut few, mut enough, mut places) = (count.saturating_sub(1), count, left(count));
    while places.len() < count {
        few = enough;
        enough += (count - places.len()).max(enough / 16);
        if enough > (count + 10).saturating_mul(SITES_PER_GRAIN) {
            return Err(too_few(crowd, places.len()));
        }
        places = left(enough);
    }
    Ok(fewest(count, left, few, (enough, places)))
}

/// The places that are left of the least number of sites that leaves enough, between one that does not and one that does.
fn fewest(
    count: usize,
    left: impl Fn(usize) -> Vec<[f64; 3]>,
    mut few: usize,
    (mut enough, mut places): (usize, Vec<[f64; 3]>),
) -> Vec<[f64; 3]> {
    while enough - few > 1 {
        let middle = few + (enough - few) / 2;
        match left(middle) {
            fewer if fewer.len() < count => few = middle,
            found => (enough, places) = (middle, found),
        }
    }
    places
}

/// So many of the places, the others left out evenly.
fn thinned(places: &[[f64; 3]], count: usize) -> Vec<[f64; 3]> {
    let is_used = |k: usize| (k + 1) * count / places.len() > k * count / places.len();
    let used = places.iter().enumerate().filter(|(k, _)| is_used(*k));
    used.map(|(_, place)| *place).collect()
}

/// Nobody may overlap anybody, or stand out of the region.
fn check(crowd: &Crowd<'_>, places: &[[f64; 3]]) -> Result<(), Problem> {
    let mut grains = crowd.others.to_vec();
    let largest = crowd.radii.first().copied().unwrap_or_default();
    let mut cells = Cells::of(crowd.others, largest, crowd.sides);
    for (position, &radius) in places.iter().zip(crowd.radii) {
        for axis in 0..crowd.region.dimension {
            let [low, high] = crowd.sides[axis].room();
            let is_inside = low.is_none_or(|low| position[axis] - radius >= low)
                && high.is_none_or(|high| position[axis] + radius <= high);
            if !(is_inside || matches!(crowd.sides[axis], Side::Periodic(_))) {
                let name = ["x", "y", "z"][axis];
                return Err(problem(crowd, &format!("so many grains do not fit along {name}")));
            }
        }
        if !cells.is_free(position, radius, &grains) {
            let message = "so many grains do not fit, two of them would overlap";
            return Err(problem(crowd, message));
        }
        cells.add(grains.len(), position);
        grains.push(Placed { radius, mass: 0.0, position: *position, velocity: [0.0; 3] });
    }
    Ok(())
}

//! Do we get what Bannerman et al. (Comput. Part. Mech. 1, 191, 2014) got? Bouncing balls and gases against the closed form and the paper.

use carom_host::figure::bsfp14::ball::{self, Variant, t_final};
use carom_host::figure::bsfp14::{gas, three_body};
use carom_host::figure::hard::Fluid;

const PLATES: u32 = 4_000;

/// Plate positions from 0 to 1.
fn plates() -> impl Iterator<Item = f64> {
    (0..PLATES).map(|i| f64::from(i) / f64::from(PLATES - 1))
}

/// Fig. 7: by the stable rule every ball is at rest at t_final, up to the time that it takes to fall
/// by the last place of its position, √(2·2⁻⁵²/g) (1 + ε)/(1 − ε) ≈ 2e-8, twice for impact and rebound.
#[test]
fn the_stable_rule_brings_the_ball_to_rest_on_every_plate() {
    for way in Variant::all().into_iter().filter(|way| way.stable) {
        for plate in plates() {
            let end = ball::drop_on(plate, way);
            assert!(!end.halted && (end.time - t_final()).abs() < 4e-8, "{way:?} {plate} {end:?}");
        }
    }
}

/// The same by the engine, which lays a ball down whose next hop is lower than 64 units in the last
/// place: that cuts off hops of h ≤ 64·2⁻⁵²·1.5 altogether, 2 √(2h/g)/(1 − ε) ≈ 2.6e-7 at most.
#[test]
fn the_engine_brings_the_ball_to_rest_on_every_plate() {
    for plate in plates() {
        let end = ball::drop_in_world(plate).unwrap();
        assert!(!end.halted && (end.time - t_final()).abs() < 3e-7, "{plate} {end:?}");
    }
}

/// Fig. 7: naive detection halts for about half of the plates, after about 30 impacts, says the
/// paper; how often, depends on how the same formula is written.
#[test]
fn naive_detection_halts_on_a_share_of_the_plates() {
    let mut shares = Vec::new();
    for way in Variant::all().into_iter().filter(|way| !way.stable) {
        let ends = plates().map(|plate| ball::drop_on(plate, way)).filter(|end| end.halted);
        let impacts: Vec<u32> = ends.map(|end| end.impacts).collect();
        assert!(impacts.iter().all(|n| (24..40).contains(n)), "{way:?}");
        shares.push(impacts.len() as f64 / f64::from(PLATES));
    }
    println!("{shares:?}");
    let halting = shares.iter().filter(|share| (0.25..0.75).contains(*share)).count();
    assert!(halting >= 2, "{shares:?}");
}

/// Fig. 3: mean and mode of the separation at impact are σ, to a unit of the last place or two; about half
/// of the impacts overlap; errors are of the order of the rounding of positions, 2⁻⁵² L/4 each.
#[test]
fn spheres_collide_at_contact_but_for_the_last_places() {
    let fluid = Fluid { restitution: 0.9, ..Fluid::elastic(500, 0.5) };
    let start = fluid.equilibrium::<3>(10).unwrap();
    let seen = gas::run(&fluid, &start, 10_000, |_| {}).unwrap();
    let (mean, deviation) = seen.moments();
    let share = seen.overlaps.overlapping as f64 / seen.overlaps.impacts as f64;
    println!(
        "mean {mean:.2} ulp, mode {}, deviation {deviation:.2}, overlap {share:.3}",
        seen.mode()
    );
    assert!(mean.abs() < 1.0 && seen.mode().abs() <= 2);
    assert!((0.35..0.55).contains(&share));
    assert!((0.5..10.0).contains(&deviation));
    assert_eq!(seen.histogram.iter().sum::<u64>(), seen.overlaps.impacts);
}

/// Fig. 5: three spheres overlap in proportion to the rounding of positions, and several times more often
/// where collisions dissipate, as the paper says. Coarse positions make them frequent enough to count.
#[test]
#[ignore = "half a minute: run with --release"]
fn three_overlap_in_proportion_to_rounding_and_more_with_dissipation() {
    let per_impact = |middle: f64, restitution: f64| {
        let fluid = Fluid { middle, ..Fluid::elastic(500, 0.9) };
        let start = fluid.equilibrium::<3>(20).unwrap();
        let seen = gas::run(&Fluid { restitution, ..fluid }, &start, 100_000, |_| {}).unwrap();
        let (hits, count) = (seen.overlaps.three_body as f64, seen.overlaps.impacts as f64);
        println!("2^{:.1}, ε = {restitution}: {hits} of {count}", middle.log2());
        [hits / count, hits.sqrt() / count]
    };
    let [coarse, finer] =
        [8.0 * three_body::FAR, three_body::FAR].map(|middle| per_impact(middle, 1.0));
    let error = coarse[1].hypot(8.0 * finer[1]);
    assert!((coarse[0] - 8.0 * finer[0]).abs() < 3.0 * error, "{coarse:?} {finer:?}");
    assert!(per_impact(three_body::FAR, 0.5)[0] > 4.0 * finer[0]);
}

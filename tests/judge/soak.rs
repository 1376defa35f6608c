//! Can a dissipative gas break the event loop? Runs it for many collisions; checks time, overlaps and counts.

use carom_host::figure::hard::{Fluid, Overlaps, Run, RunState};

/// Runs a gas and checks that time never went back and no overlap became deeper than rounding makes it.
fn soak(grains: usize, restitution: f64, collisions: u64) -> RunState {
    let fluid = Fluid { restitution, ..Fluid::elastic(grains, 0.5) };
    let mut gas = Run::new(fluid, fluid.equilibrium::<3>(10).unwrap());
    let mut overlaps = Overlaps::new(grains);
    gas.run(collisions, &mut overlaps, |_| Ok(())).unwrap();
    let state = gas.state;
    println!("ε = {restitution}: {state:?}");
    println!("  deepest {:.1e}, deepening {:.1e}", -overlaps.deepest, overlaps.decrease);
    assert_eq!(state.collisions, collisions);
    assert_eq!(state.backward, 0, "negative time steps");
    // Positions are rounded to 2⁻⁵² of half a box, which is some five diameters long.
    assert!(-overlaps.deepest < 2e-14, "an overlap of {:e}", -overlaps.deepest);
    assert!(overlaps.decrease < 1e-14, "an overlap became deeper by {:e}", overlaps.decrease);
    state
}

#[test]
fn a_gas_cools_without_end() {
    let state = soak(108, 0.9, 30_000);
    // Haff: ln E falls by (1 − ε²)/3 a collision of a grain at first, later more slowly; after 560 of
    // them a grain the energy has long fallen by the 2^40 at which the unit of time changes.
    assert!(state.units >= 1, "{} units of time", state.units);
}

#[test]
fn a_gas_clusters() {
    soak(108, 0.5, 20_000);
}

/// With ε = 0 every touch is for ever: collapses without end, unless the engine ends them.
#[test]
fn a_gas_of_putty_does_not_stop_time() {
    for restitution in [0.0, 0.1, 0.2] {
        let state = soak(108, restitution, 10_000);
        assert!(state.time > 0.1, "{}", state.time);
    }
}

/// 10⁷ collisions at ε = 0.9, 10⁶ at 0.5 and 0; still longer ones are run by `carom soak`.
#[test]
#[ignore = "long; run in release"]
fn gases_run_for_millions_of_collisions() {
    soak(1_372, 0.9, 10_000_000);
    soak(1_372, 0.5, 1_000_000);
    soak(1_372, 0.0, 1_000_000);
}

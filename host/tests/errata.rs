//! Is docs/errata.md right? Puts numbers into the papers' formulas, as they stand and as they should be; writes nothing.

use carom_host::figure::l94::table1;
use carom_host::parameter_space::Space;

/// MP13 Eqs. (5), (29), (30): with r = r₁ − r₂, a contact that neither turns nor lasts leaves both grains in place.
#[test]
fn mp13_29_30_exchange_the_grains() {
    let ([m1, m2], [r1, r2]) = ([1.0, 3.0], [0.0, 2.0]);
    let centre = (m1 * r1 + m2 * r2) / (m1 + m2);
    let r: f64 = r1 - r2;
    let after =
        |sign: f64| [centre + sign * m2 / (m1 + m2) * r, centre - sign * m1 / (m1 + m2) * r];
    assert_eq!(after(1.0), [r1, r2]);
    assert!(after(-1.0)[0] > after(-1.0)[1], "as it stands, they have changed sides");
}

/// MP13 Eq. (38): the same for velocities, with ṙ′ = −ṙ.
#[test]
fn mp13_38_conserves_only_with_the_other_signs() {
    let ([m1, m2], [v1, v2]) = ([1.0, 3.0], [2.0, -1.0]);
    let centre = (m1 * v1 + m2 * v2) / (m1 + m2);
    let parting = -(v1 - v2);
    let after = |sign: f64| {
        [centre + sign * m2 / (m1 + m2) * parting, centre - sign * m1 / (m1 + m2) * parting]
    };
    let [u1, u2] = after(1.0);
    // Elastic: v₁′ = ((m₁ − m₂) v₁ + 2 m₂ v₂)/(m₁ + m₂).
    let right = ((m1 - m2) * v1 + 2.0 * m2 * v2) / (m1 + m2);
    assert!((u1 - right).abs() < 1e-15 && u2 > u1, "{u1} {u2}");
    assert_eq!(after(-1.0), [v1, v2], "as it stands, an elastic collision changes nothing");
}

/// MP13 Eqs. (50), (61): l~ and c_φ = l~ tan α from the definitions, and from the axes.
#[test]
fn mp13_50_61_lack_a_logarithm() {
    for space in [Space::linear(), Space::viscoelastic()] {
        let (e, m) = (0.3_f64, 5.0);
        let g = -0.5 * (1.0 / (e * e) - 1.0).ln();
        let part = if space == Space::linear() { 0.5 } else { 0.4 };
        let ln_l = m + part * (1.0 + (2.0 * g).exp()).ln();
        let ln_c = ln_l + g;
        let ln_ratio: f64 = ln_c - (ln_l + space.g[0]);
        assert!((ln_ratio + ln_l + space.g[0] - ln_c).abs() < 1e-12);
        assert!((ln_ratio.exp() + ln_l + space.g[0] - ln_c).abs() > 1.0, "as it stands");
        let [u, _] = space.near(ln_c, ln_l, 0.0).expect("inside the table");
        assert!((u - ln_ratio).abs() < 1e-12);
        let groups = space.groups(u, m - space.m[0], 0.0);
        assert!((groups.sin - e).abs() < 1e-12, "back to the eccentricity");
    }
}

/// MP13 Eq. (63): head-on at ±1, elastic.
#[test]
fn mp13_63_has_the_wrong_signs() {
    let (v, epsilon) = ([1.0, -1.0], 1.0);
    let after = |sign: f64, e_r: f64| {
        let push = sign * 0.5 * (1.0 + epsilon) * ((v[0] - v[1]) * e_r) * e_r;
        [v[0] - push, v[1] + push]
    };
    for e_r in [1.0, -1.0] {
        assert_eq!(after(1.0, e_r), [-1.0, 1.0]);
        assert_eq!(after(-1.0, e_r), [3.0, -3.0], "as it stands, nine times the energy");
    }
}

/// L94 Table I, rows three and four, by exact MD.
#[test]
fn l94_table_1_rows_three_and_four() {
    let near = |found: [f64; 3], right: [f64; 3]| {
        found.iter().zip(right).all(|(a, b)| (a - b).abs() < 1e-4)
    };
    let third = [0.8, -0.2, -0.2];
    assert!(near(table1::measured([0.5, 0.0]).unwrap(), third));
    assert!(!near(table1::measured([1.0, 0.0]).unwrap(), third), "with β = 1, as it stands");
    assert!(near(table1::measured([0.5, 0.5]).unwrap(), [0.8, -0.2, 0.2]));
}

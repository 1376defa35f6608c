//! What obstacles are refused, and with which words?

use super::shapes::{cube, ring, room};
use carom::error::Subject;
use carom::law::{HardSphere, PaperMode};
use carom::particle::{Index, Partner};
use carom::space::{Facet, Surface};
use carom::world::WithObstacles;
use carom::{Error, Grain, HeapMemory, World};

const RULE: HardSphere<f64> = HardSphere { restitution: 0.9 };

fn started(facets: Vec<Facet<f64, 2>>, grain: Grain<f64, 2>) -> Result<(), Error> {
    let mut memory = room(1, facets);
    World::builder(&mut memory).rule(RULE).grain(grain)?.start().map(drop)
}

fn square() -> Vec<Facet<f64, 2>> {
    ring(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], Surface::Hard(0.9))
}

#[test]
fn facets_must_be_some() {
    let far = Grain::with_mass(0.1, 1.0).at([9.0, 9.0]);
    let refused = |facet: Facet<f64, 2>| {
        let mut facets = square();
        facets.push(facet);
        started(facets, far).unwrap_err()
    };
    let no_length = refused(Facet::new([[2.0, 2.0]; 2], Surface::Rule));
    assert!(matches!(no_length, Error::Input { subject: Subject::Facet(4), field: "length", .. }));
    let no_number = refused(Facet::new([[2.0, f64::NAN], [1.0, 2.0]], Surface::Rule));
    assert!(matches!(no_number, Error::Input { subject: Subject::Facet(4), field: "corner", .. }));
    let no_restitution = refused(Facet::new([[2.0, 3.0], [1.0, 2.0]], Surface::Hard(1.5)));
    assert!(matches!(no_restitution, Error::Input { field: "restitution", .. }));
    let across = refused(Facet::new([[2.0, 3.0], [2.0, 4.0]], Surface::Rule).running([1.0, 1.0]));
    assert!(matches!(across, Error::Input { field: "belt's velocity", .. }));
    let mut needle = cube(Surface::Rule);
    needle.push(Facet::new([[0.0; 3], [1.0, 1.0, 1.0], [0.5, 0.5, 0.5]], Surface::Rule));
    let mut memory = room(0, needle);
    let refused = World::builder(&mut memory).rule(RULE).start().err().unwrap();
    assert!(matches!(refused, Error::Input { subject: Subject::Facet(12), field: "area", .. }));
    assert!(refused.to_string().starts_with("facet 12: area is 0, must be above 0"), "{refused}");
}

#[test]
fn a_grain_in_a_wall_is_refused() {
    let at = |x, y| started(square(), Grain::with_mass(0.1, 1.0).at([x, y]));
    assert!(at(0.5, 0.5).is_ok() && at(0.1, 0.1).is_ok() && at(-0.1, 0.5).is_ok());
    for (x, y, facet) in [(0.05, 0.5, 3), (0.5, -0.05, 0), (1.07, 1.07, 1)] {
        let Err(Error::Overlap { grain: 0, with, gap, also: None }) = at(x, y) else {
            panic!("{x}, {y}")
        };
        assert_eq!(with, Partner::facet(facet));
        assert!(gap < 0.0);
    }
    let text = at(0.05, 0.5).unwrap_err().to_string();
    assert!(text.starts_with("grain 0 and facet 3 overlap"), "{text}");
}

#[test]
fn a_grain_between_faces_that_leave_it_no_room_is_refused_with_both() {
    let side = |x: f64| Facet::new([[x, -1.0], [x, 1.0]], Surface::Rule);
    let facets = || vec![side(5.0), side(0.55), side(0.44), side(0.43)];
    let at = |x: f64| started(facets(), Grain::with_mass(0.1, 1.0).at([x, 0.0]));
    let refused = at(0.5).unwrap_err();
    let Error::Overlap { grain: 0, with, also: Some(also), .. } = refused else {
        panic!("{refused}")
    };
    assert_eq!((with, also), (Partner::facet(1), Partner::facet(2)));
    let text = refused.to_string();
    assert!(text.starts_with("grain 0 overlaps facet 1 and, on its other side, facet 2"), "{text}");
    // Two on one side are no narrow place.
    let Err(Error::Overlap { also: None, .. }) = at(0.36) else { panic!("both are on one side") };
}

#[test]
fn lists_that_are_too_short_are_named() {
    let with_places = |places: usize| {
        let lists = vec![Index::default(); places];
        let mut memory = WithObstacles::new(HeapMemory::with_capacity(1), square(), lists);
        World::builder(&mut memory).rule(RULE).start().map(drop)
    };
    assert!(with_places(6).is_ok());
    let refused = with_places(5).unwrap_err();
    assert!(matches!(refused, Error::Full { capacity: 5, .. }));
    assert!(refused.to_string().contains("WithObstacles"), "{refused}");
}

#[test]
fn what_obstacles_do_not_stand_in_is_refused() {
    let mut memory = room(1, square());
    let refused = World::builder(&mut memory).periodic([[0.0, 9.0]; 2]).rule(RULE).start();
    assert!(matches!(refused.err().unwrap(), Error::Input { subject: Subject::Axis(0), .. }));
    let refused = World::builder(&mut memory).rule(PaperMode(RULE)).start();
    assert!(matches!(refused.err().unwrap(), Error::Input { field: "papers' mode", .. }));
}

/// Places near a wall whose corners are far away are rounded as those corners are.
#[test]
fn an_overlap_of_no_more_than_the_rounding_of_far_corners_is_let_through() {
    let at = |y: f64| {
        let floor = Facet::new([[-1.0e6, 0.0], [1.0e6, 0.0]], Surface::Hard(0.9));
        started(vec![floor], Grain::with_mass(1.0, 1.0).at([0.0, y]))
    };
    assert_eq!(at(1.0 - 1.0e-10), Ok(()));
    assert!(matches!(at(1.0 - 1.0e-7), Err(Error::Overlap { grain: 0, .. })));
}

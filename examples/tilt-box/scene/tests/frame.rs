//! Does physics keep to its share of a frame? Runs the box with little time and with enough; reads disks and counters.

use carom::Instant;
use carom_tilt_box::frame::FRAME;
use carom_tilt_box::replay::{self, Onlooker};
use carom_tilt_box::scene::{G, Memory, SIDES, disk};
use carom_tilt_box::screen::Canvas;
use carom_tilt_box::script::READINGS;
use carom_tilt_box::{Pace, TiltBox};

const DISKS: usize = 12;
const DOWN: [f32; 2] = [0.0, -G];

fn milliseconds(instant: Instant) -> f64 {
    instant.as_f64()
}

#[test]
fn with_enough_time_the_box_is_where_the_engine_alone_would_be() {
    let (mut memory, mut other) = (Memory::<DISKS>::new(), Memory::<DISKS>::new());
    let mut tilt_box = TiltBox::new(&mut memory).unwrap();
    let mut engine = carom_tilt_box::scene::disks(&mut other).unwrap();
    for frame in 1..=100_u16 {
        let gravity = if frame < 50 { DOWN } else { [G, 0.0] };
        tilt_box.frame(gravity, || true).unwrap();
        engine.set_gravity(gravity).unwrap();
        engine.advance_to(f32::from(frame) * FRAME as f32).unwrap();
    }
    assert_eq!(tilt_box.disks().digest(), engine.digest());
    assert_eq!(tilt_box.pace(), Pace { frames: 100, slowed: 0, behind: 0 });
}

#[test]
fn physics_stops_when_its_time_is_over_and_does_not_catch_up() {
    const EVENTS: u32 = 20;
    let mut memory = Memory::<DISKS>::new();
    let mut tilt_box = TiltBox::new(&mut memory).unwrap();
    let mut frames = 0_u32;
    let mut slowed = 0;
    while frames < 100 {
        let before = tilt_box.disks().now();
        let mut asked = 0;
        tilt_box
            .frame(DOWN, || {
                asked += 1;
                asked <= EVENTS
            })
            .unwrap();
        frames += 1;
        let took = milliseconds(tilt_box.disks().now()) - milliseconds(before);
        assert!(asked <= EVENTS + 1 && took <= f64::from(FRAME));
        slowed += u32::from(took < f64::from(FRAME));
    }
    let (pace, now) = (tilt_box.pace(), milliseconds(tilt_box.disks().now()));
    assert!(slowed > 10 && slowed < 100, "{slowed}");
    assert_eq!((pace.frames, pace.slowed), (frames, slowed));
    // Each frame's part is rounded down to a µs, and an f32 of some ms is a µs off at most.
    let behind = (f64::from(frames * FRAME) - now) * 1000.0;
    assert!(
        (behind - pace.behind as f64).abs() <= 2.0 * f64::from(slowed),
        "{behind} {}",
        pace.behind
    );
}

#[test]
fn without_any_time_nothing_moves_and_all_of_it_is_counted() {
    let mut memory = Memory::<DISKS>::new();
    let mut tilt_box = TiltBox::new(&mut memory).unwrap();
    for _ in 0..3 {
        tilt_box.frame(DOWN, || false).unwrap();
    }
    assert_eq!(tilt_box.pace(), Pace { frames: 3, slowed: 3, behind: 3 * 25_000 });
    assert_eq!(tilt_box.disks().now(), Instant::START);
}

#[test]
fn gravity_that_would_press_disks_flat_is_refused_and_the_box_goes_on() {
    let mut memory = Memory::<DISKS>::new();
    let mut tilt_box = TiltBox::new(&mut memory).unwrap();
    assert!(tilt_box.frame([0.0, -1000.0 * G], || true).is_err());
    assert!(tilt_box.frame([f32::NAN, 0.0], || true).is_err());
    tilt_box.frame(DOWN, || true).unwrap();
    assert_eq!(tilt_box.pace().frames, 1);
}

/// ±2 g along both axes is the most that the sensor tells.
#[test]
fn the_strongest_reading_is_accepted() {
    let mut memory = Memory::<DISKS>::new();
    let mut tilt_box = TiltBox::new(&mut memory).unwrap();
    for _ in 0..40 {
        tilt_box.frame([2.048 * G, -2.048 * G], || true).unwrap();
    }
}

#[test]
fn disks_that_are_left_alone_lie_down_and_sleep() {
    let mut memory = Memory::<DISKS>::new();
    let mut tilt_box = TiltBox::new(&mut memory).unwrap();
    let mut frames = 0;
    while tilt_box.disks().next_event_time().is_some() {
        tilt_box.frame(DOWN, || true).unwrap();
        frames += 1;
        assert!(frames < 40 * 60, "still awake after a minute");
    }
    // Nine disks lie beside each other on the floor at most: twelve fill less than two layers.
    let view = tilt_box.disks().view();
    for number in 0..DISKS {
        let grain = view.grain(number).unwrap();
        assert!(view.is_at_rest(number) && grain.position.y < 45.0, "disk {number}: {grain:?}");
    }
}

/// Looks whether all disks are in the box, and where their centre is.
#[derive(Default)]
struct Inside {
    rightmost: f32,
    leftmost: f32,
}

impl Onlooker for Inside {
    fn begin(&mut self) {}

    fn has_time(&mut self) -> bool {
        true
    }

    fn end(&mut self, _: u32, tilt_box: &TiltBox<'_>) {
        let [width, height] = SIDES;
        let mut centre = 0.0;
        for number in 0..DISKS {
            let grain = tilt_box.disks().grain(number).unwrap();
            let (x, y, r) = (grain.position.x, grain.position.y, grain.radius);
            // Pressed against a wall by a whole heap, a disk is a tenth of its radius beyond it at most.
            let within = |at: f32, side: f32| at > 0.9 * r && at < side - 0.9 * r;
            assert!(within(x, width) && within(y, height), "disk {number} at {x}, {y}");
            centre += x / DISKS as f32 - width / 2.0 / DISKS as f32;
        }
        self.rightmost = self.rightmost.max(centre);
        self.leftmost = self.leftmost.min(centre);
    }
}

#[test]
fn the_scripted_box_rocks_its_disks_to_and_fro_and_keeps_them() {
    let mut inside = Inside::default();
    let pace = replay::run(&mut Memory::<DISKS>::new(), &mut Canvas::new(), &mut inside).unwrap();
    assert_eq!((pace.frames, pace.slowed), (READINGS, 0));
    assert!(
        inside.rightmost > 40.0 && inside.leftmost < -40.0,
        "{} {}",
        inside.leftmost,
        inside.rightmost
    );
}

#[test]
fn as_many_disks_as_there_are_sites_can_be_let_go() {
    assert!(TiltBox::new(&mut Memory::<24>::new()).is_ok());
    assert!(TiltBox::new(&mut Memory::<1>::new()).is_ok());
    assert_eq!(disk(0).radius, 10.0);
}

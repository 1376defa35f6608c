//! Are two worlds the same to the last bit? Reads the whole state; writes one number.

use super::state::World;
use crate::particle::Body;
use crate::scalar::{Scalar, Vector};
use crate::space::ContactState;

/// FNV-1a with 64 bits.
struct Fnv(u64);

impl Fnv {
    fn word(&mut self, word: u64) {
        for byte in word.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    fn number<S: Scalar>(&mut self, x: S) {
        self.word(x.bits());
    }

    fn vector<S: Scalar, const D: usize>(&mut self, v: &Vector<S, D>) {
        v.iter().for_each(|&x| self.number(x));
    }

    fn body<S: Scalar, const D: usize>(&mut self, body: &Body<S, D>, position: &Vector<S, D>) {
        for v in [position, &body.velocity, &body.velocity_change] {
            self.vector(v);
        }
        for x in [body.clock, body.contact_end, body.reference_time, body.radius, body.mass] {
            self.number(x);
        }
        self.word(u64::from(body.partner.word()));
        self.word(u64::from(body.material));
        self.word(u64::from(body.planes));
        self.word(u64::from(body.consecutive_collisions));
    }
}

impl<S: Scalar, const D: usize, R> World<'_, S, D, R> {
    /// A digest of the whole state: equal states have equal digests on every target.
    ///
    /// It covers time, gravity, plates and every grain: its own clock, its state then, the contact it is
    /// in. Pending events and cells follow from them, and the statistics are not covered: worlds that find
    /// neighbours in different ways have the same digest.
    #[must_use]
    pub fn digest(&self) -> u64 {
        let mut fnv = Fnv(0xcbf2_9ce4_8422_2325);
        let ticks = self.clock.epoch.words();
        fnv.word(ticks.0);
        fnv.word(ticks.1);
        fnv.number(self.clock.now);
        fnv.vector(self.domain.gravity());
        let moving = self.domain.boundary.planes().iter().filter(|plane| plane.moves());
        moving.for_each(|plane| fnv.number(plane.motion(self.clock.now).place));
        let boundary = &self.domain.boundary;
        boundary.images().iter().for_each(|images| fnv.number(images.offset(self.clock.now)));
        let inside = |body: &Body<S, D>| boundary.wrap_from_far(body.position);
        self.particles.bodies.iter().for_each(|body| fnv.body(body, &inside(body)));
        let rotation = &self.particles.rotation;
        let spins = rotation.velocities.iter().chain(rotation.accelerations.iter());
        spins.for_each(|&w| fnv.number(w));
        fnv.0 ^ contacts(self.particles.contacts.0)
    }
}

/// One number for all contacts that last, in whatever order they are kept; 0 without any.
fn contacts<S: Scalar>(states: &[ContactState<S>]) -> u64 {
    let one = |words: [u64; 6]| {
        let mut fnv = Fnv(0xcbf2_9ce4_8422_2325);
        words.into_iter().for_each(|word| fnv.word(word));
        fnv.0
    };
    states.iter().filter_map(ContactState::words).map(one).fold(0, u64::wrapping_add)
}

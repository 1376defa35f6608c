//! Are two worlds the same to the last bit? Reads the whole state; writes one number.

use super::World;
use crate::event::{Kind, Slot};
use crate::matter::Body;
use crate::number::{Scalar, Vector};

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

    fn body<S: Scalar, const D: usize>(&mut self, body: &Body<S, D>) {
        for v in [&body.position, &body.velocity, &body.release] {
            self.vector(v);
        }
        for x in [body.clock, body.release_at, body.moment, body.radius, body.mass] {
            self.number(x);
        }
        self.word(u64::from(body.partner.word()));
        self.word(u64::from(body.material));
        self.word(u64::from(body.planes));
        self.word(u64::from(body.burst));
    }

    fn slot<S: Scalar>(&mut self, slot: &Slot<S>) {
        self.number(slot.time);
        self.word(u64::from(slot.partner.word()));
        self.word(match slot.kind {
            Kind::Meet => 0,
            Kind::Release => 1,
            Kind::Wander => 2,
            Kind::Nothing => 3,
            Kind::TakeOff => 4,
            Kind::Check => 5,
        });
    }
}

impl<S: Scalar, const D: usize, R> World<'_, S, D, R> {
    /// A digest of the whole state: equal states have equal digests on every target.
    ///
    /// It covers time, gravity, every grain and every pending event, not the counters.
    #[must_use]
    pub fn digest(&self) -> u64 {
        let mut fnv = Fnv(0xcbf2_9ce4_8422_2325);
        let ticks = self.scene.epoch.words();
        fnv.word(ticks.0);
        fnv.word(ticks.1);
        fnv.number(self.scene.now);
        fnv.vector(&self.scene.gravity);
        let plates = self.scene.boundary.planes().iter().filter_map(|plane| plane.vibration);
        plates.for_each(|plate| fnv.number(plate.at(self.scene.now).place));
        self.scene.bodies.iter().for_each(|body| fnv.body(body));
        self.queue.slots.iter().for_each(|slot| fnv.slot(slot));
        fnv.0
    }
}

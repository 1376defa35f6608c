//! What does a contact that lasts remember? How far its surfaces have been dragged, and what its law keeps: a table by pair, in memory that is lent; reads and writes it.

use crate::error::Error;
use crate::particle::Partner;
use crate::scalar::{Axial, Scalar};

/// A contact that lasts: who touches, how far their surfaces have been dragged along each other since, and what their
/// force law remembers.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ContactState<S> {
    /// The grain, of two that with the smaller number, and what it touches.
    pair: (u32, Partner),
    /// n × s, the normal and the displacement of the surface of the first against that of the second.
    displacement: [S; 3],
    /// What the law remembers.
    memory: [S; 2],
    /// Whether the two have touched in the last step.
    touched: bool,
}

impl<S: Scalar> ContactState<S> {
    /// A place that no contact has. All bits of the displacement are zero.
    pub const VACANT: Self = Self {
        pair: (u32::MAX, Partner::NOTHING),
        displacement: [S::ZERO; 3],
        memory: [S::ZERO; 2],
        touched: false,
    };

    fn is_vacant(&self) -> bool {
        self.pair.1 == Partner::NOTHING
    }

    /// The number of its grain.
    fn grain(&self) -> usize {
        usize::try_from(self.pair.0).unwrap_or(usize::MAX)
    }

    /// n × s.
    pub(crate) fn displacement(&self) -> Axial<S> {
        self.displacement.into()
    }

    /// The surfaces are that far by now, in a contact that lasts.
    pub(crate) fn drag(&mut self, displacement: &Axial<S>) {
        (self.displacement, self.touched) = ((*displacement).into(), true);
    }

    /// What the law remembers, of a contact that lasts.
    pub(crate) fn remember(&mut self) -> &mut [S; 2] {
        self.touched = true;
        &mut self.memory
    }

    /// What this contact adds to a digest, wherever in the table it is.
    pub(crate) fn words(&self) -> Option<[u64; 6]> {
        let [x, y, z] = self.displacement.map(|x| x.bits());
        let [m, n] = self.memory.map(|x| x.bits());
        let pair = u64::from(self.pair.0) << 32 | u64::from(self.pair.1.word());
        (!self.is_vacant()).then_some([pair, x, y, z, m, n])
    }

    /// The first field that a saved contact cannot have among so many grains.
    pub(crate) fn refused(&self, grains: usize) -> Option<(&'static str, f64)> {
        if self.is_vacant() {
            return None;
        }
        let inside = |grain: usize| grain < grains;
        let (first, second) = (self.grain(), self.pair.1);
        if !inside(first) || !second.as_grain().is_none_or(inside) {
            return Some(("grain of a contact", first as f64));
        }
        let outside = |x: &&S| !x.in_range();
        let bad = self.displacement.iter().chain(&self.memory).find(outside)?;
        Some(("memory of a contact", bad.to_f64()))
    }
}

impl<S: Scalar> Default for ContactState<S> {
    fn default() -> Self {
        Self::VACANT
    }
}

/// The key of a grain and what it touches: the same whoever of the two asks.
fn key(grain: usize, with: Partner) -> (u32, Partner) {
    let (first, second) = match with.as_grain() {
        Some(k) if k < grain => (k, Partner::grain(grain)),
        _ => (grain, with),
    };
    (u32::try_from(first).unwrap_or(u32::MAX), second)
}

/// A hash table with linear probing over lent places.
#[derive(Debug)]
pub(crate) struct Contacts<'m, S>(pub &'m mut [ContactState<S>]);

impl<'m, S: Scalar> Contacts<'m, S> {
    /// The state of a contact; that of a new one is all zero.
    ///
    /// # Errors
    /// [`Error::Full`] if there is no place for it.
    pub fn of(self, grain: usize, with: Partner) -> Result<&'m mut ContactState<S>, Error> {
        let pair = key(grain, with);
        let (count, home) = (self.0.len(), self.home(pair));
        let mine = |place: &usize| {
            let state = self.0.get(*place);
            state.is_some_and(|state| state.pair == pair || state.is_vacant())
        };
        let place = (0..count).map(|k| (home + k) % count).find(mine);
        let full = Error::Full { knob: "places for contacts (WithContacts)", capacity: count };
        let state = place.and_then(|place| self.0.get_mut(place)).ok_or(full)?;
        if state.is_vacant() {
            *state = ContactState { pair, ..ContactState::VACANT };
        }
        Ok(state)
    }

    /// Whether this contact is known.
    pub fn has(&self, grain: usize, with: Partner) -> bool {
        self.known(grain, with).is_some()
    }

    /// The state of a contact that is known.
    pub fn known(&self, grain: usize, with: Partner) -> Option<&ContactState<S>> {
        let (pair, count) = (key(grain, with), self.0.len());
        let home = self.home(pair);
        let places = (0..count).filter_map(|k| self.0.get((home + k) % count));
        places.take_while(|state| !state.is_vacant()).find(|state| state.pair == pair)
    }

    /// What a grain and the first of two touched remember is from now on of it and the second, which is not known yet.
    pub fn hand_over(&mut self, grain: usize, [from, to]: [Partner; 2]) {
        let (pair, key) = (key(grain, from), key(grain, to));
        let Some(place) = self.0.iter().position(|state| state.pair == pair) else { return };
        let Some(state) = self.0.get(place).copied() else { return };
        self.vacate(place);
        // A place has just become free.
        if let Ok(new) = Contacts(&mut *self.0).of(grain, to) {
            *new = ContactState { pair: key, ..state };
        }
    }

    /// Where a contact is looked for first.
    fn home(&self, (first, second): (u32, Partner)) -> usize {
        let mixed = (first ^ second.word().rotate_left(16)).wrapping_mul(0x9e37_79b1) >> 7;
        usize::try_from(mixed).unwrap_or(0).checked_rem(self.0.len()).unwrap_or(0)
    }

    /// Contacts that were not touched in this step are forgotten, if they have ended.
    pub fn forget(&mut self, ended: impl Fn(usize, Partner) -> bool) {
        let mut place = 0;
        while let Some(state) = self.0.get(place) {
            let idle = !state.is_vacant() && !state.touched;
            if idle && ended(state.grain(), state.pair.1) {
                self.vacate(place);
            } else {
                place += 1;
            }
        }
        self.0.iter_mut().for_each(|state| state.touched = false);
    }

    /// Empties a place; those that were put behind it because it was taken move up.
    fn vacate(&mut self, place: usize) {
        let count = self.0.len();
        let mut hole = place;
        for step in 1..count {
            let next = (place + step) % count;
            let Some(state) = self.0.get(next).copied().filter(|s| !s.is_vacant()) else { break };
            let home = self.home(state.pair);
            // How far it is from its home: it may move back to the hole if that is not before its home.
            let [to_hole, to_next] = [hole, next].map(|at| (at + count - home) % count);
            if to_hole <= to_next {
                self.put(hole, state);
                hole = next;
            }
        }
        self.put(hole, ContactState::VACANT);
    }

    fn put(&mut self, place: usize, state: ContactState<S>) {
        if let Some(at) = self.0.get_mut(place) {
            *at = state;
        }
    }

    /// Takes over saved contacts.
    ///
    /// # Errors
    /// [`Error::Full`] if there are not places for all.
    pub fn restore(&mut self, saved: &[ContactState<S>]) -> Result<(), Error> {
        self.0.fill(ContactState::VACANT);
        for state in saved.iter().filter(|state| !state.is_vacant()) {
            *Contacts(&mut *self.0).of(state.grain(), state.pair.1)? = *state;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;
    use std::vec::Vec;

    #[test]
    fn the_table_is_a_map() {
        let mut places = [ContactState::<f64>::VACANT; 13];
        let mut table = Contacts(&mut places);
        let mut map = BTreeMap::new();
        let mut seed = 1_u32;
        let mut draw = |below: u32| {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (seed >> 16) % below
        };
        for _ in 0..20_000 {
            let pair = [draw(5) as usize, 5 + draw(5) as usize];
            let known = map.contains_key(&pair);
            match Contacts(&mut *table.0).of(pair[1], Partner::grain(pair[0])) {
                Ok(state) => {
                    assert_eq!(state.displacement().z, map.get(&pair).copied().unwrap_or(0.0));
                    let value = f64::from(draw(1000));
                    state.drag(&Axial::new(0.0, 0.0, value));
                    map.insert(pair, value);
                }
                Err(_) => assert!(!known && map.len() == 13),
            }
            if draw(4) == 0 {
                let gone = draw(5);
                table.0.iter_mut().for_each(|state| state.touched = state.pair.0 != gone);
                table.forget(|_, _| true);
                map.retain(|pair, _| pair[0] as u32 != gone);
            }
            let kept: Vec<_> = table.0.iter().filter(|s| !s.is_vacant()).collect();
            assert_eq!(kept.len(), map.len());
        }
    }
}

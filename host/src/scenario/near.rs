//! Who is near a place? Reads positions; writes its own lists of grains by cells.

use super::side::{Placed, Side};
use std::collections::HashMap;

/// Grains by cells as wide as the largest diameter.
pub struct Cells<'a> {
    width: f64,
    sides: &'a [Side; 3],
    members: HashMap<[i64; 3], Vec<usize>>,
}

impl<'a> Cells<'a> {
    /// No grains yet; no two that are added may be wider together.
    pub fn new(width: f64, sides: &'a [Side; 3]) -> Self {
        Self { width, sides, members: HashMap::new() }
    }

    /// Cells along an axis; a periodic axis has a whole number, so the last one may be wider.
    fn cell(&self, axis: usize, at: f64) -> i64 {
        match self.sides[axis] {
            Side::Periodic([from, to]) => {
                let count = self.count(axis);
                (((at - from) / (to - from)).rem_euclid(1.0) * count as f64) as i64 % count
            }
            _ => (at / self.width).floor() as i64,
        }
    }

    fn count(&self, axis: usize) -> i64 {
        match self.sides[axis] {
            Side::Periodic([from, to]) => (((to - from) / self.width).floor() as i64).max(1),
            _ => i64::MAX,
        }
    }

    /// These grains; none that is added may have more than this radius, or theirs.
    pub fn of(grains: &[Placed], radius: f64, sides: &'a [Side; 3]) -> Self {
        let largest = grains.iter().map(|grain| grain.radius).fold(radius, f64::max);
        let mut cells = Self::new(2.0 * largest, sides);
        for (number, grain) in grains.iter().enumerate() {
            cells.add(number, &grain.position);
        }
        cells
    }

    /// Adds grain `number`.
    pub fn add(&mut self, number: usize, position: &[f64; 3]) {
        let key = std::array::from_fn(|axis| self.cell(axis, position[axis]));
        self.members.entry(key).or_default().push(number);
    }

    /// Whether a grain of this radius would overlap none there.
    pub fn is_free(&self, position: &[f64; 3], radius: f64, grains: &[Placed]) -> bool {
        let home: [i64; 3] = std::array::from_fn(|axis| self.cell(axis, position[axis]));
        let separate = |number: &usize| {
            let other = &grains[*number];
            let square: f64 = (0..3)
                .map(|k| self.sides[k].nearest(position[k] - other.position[k]).powi(2))
                .sum();
            square > (radius + other.radius).powi(2)
        };
        (0..27).all(|step| {
            let shift = [step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1];
            let key = std::array::from_fn(|axis| match self.sides[axis] {
                Side::Periodic(_) => (home[axis] + shift[axis]).rem_euclid(self.count(axis)),
                _ => home[axis] + shift[axis],
            });
            self.members.get(&key).is_none_or(|members| members.iter().all(separate))
        })
    }
}

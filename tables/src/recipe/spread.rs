//! Where shall a table be tested? Reads a seed; writes points spread at random, the same on every machine.

/// A small generator of uniform numbers (xorshift64*, Vigna 2016).
#[derive(Clone, Debug)]
pub struct Spread(u64);

impl Spread {
    /// A sequence of its own for every seed.
    pub fn new(seed: u64) -> Self {
        let mut spread = Spread(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
        for _ in 0..8 {
            spread.uniform();
        }
        spread
    }

    /// A number in 0..1.
    pub fn uniform(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number in `low..high`, its logarithm uniform.
    pub fn logarithmic(&mut self, low: f64, high: f64) -> f64 {
        low * libm::pow(high / low, self.uniform())
    }
}

//! Which law do hoppers follow? Reads rates over the width of the opening; writes Beverloo's law that fits them best.

use super::run::Rate;

/// Beverloo's law, W = C √g (D − k d)^n: n = 3/2 in two dimensions (W. A. Beverloo, H. A. Leniger and J. van de Velde,
/// Chem. Eng. Sci. 15, 260, 1961, for three, where n = 5/2).
///
/// # Units
/// d, m and g are one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beverloo {
    /// C.
    pub c: f64,
    /// k: so much of the opening, in diameters, lets nothing through.
    pub k: f64,
    /// n.
    pub exponent: f64,
    /// The standard error of n, where it was fitted: where χ² is by one above its least.
    pub error: f64,
    /// How far the rates are from it, in squares of their errors.
    pub chi_squared: f64,
}

impl Beverloo {
    /// W at this D.
    pub fn rate(&self, opening: f64) -> f64 {
        self.c * libm::pow((opening - self.k).max(0.0), self.exponent)
    }
}

/// The law that fits best, its exponent given or fitted, too; none where rates are fewer than three.
pub fn fit(rates: &[Rate], exponent: Option<f64>) -> Option<Beverloo> {
    if rates.len() < 3 {
        return None;
    }
    let Some(exponent) = exponent else { return Some(fit_exponent(rates)) };
    Some(at(rates, exponent))
}

/// W^(1/n) is linear in D: least squares, each rate with its error.
fn at(rates: &[Rate], exponent: f64) -> Beverloo {
    let mut sums = [0.0; 5];
    for rate in rates {
        let y = libm::pow(rate.mean, 1.0 / exponent);
        let weight = (exponent * rate.mean / (y * rate.error)).powi(2);
        let terms = [1.0, rate.opening, y, rate.opening.powi(2), rate.opening * y];
        sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += weight * term);
    }
    let [w, x, y, xx, xy] = sums;
    let slope = (w * xy - x * y) / (w * xx - x * x);
    let k = (x - y / slope) / w;
    let law = Beverloo { c: libm::pow(slope, exponent), k, exponent, error: 0.0, chi_squared: 0.0 };
    let far = |rate: &Rate| ((rate.mean - law.rate(rate.opening)) / rate.error).powi(2);
    Beverloo { chi_squared: rates.iter().map(far).sum(), ..law }
}

fn fit_exponent(rates: &[Rate]) -> Beverloo {
    let tried = |i: i32| at(rates, 1.0 + 0.001 * f64::from(i));
    let laws: Vec<Beverloo> = (0..=1500).map(tried).collect();
    let least = |a: &&Beverloo, b: &&Beverloo| a.chi_squared.total_cmp(&b.chi_squared);
    let best = laws.iter().min_by(least).copied().unwrap_or_else(|| at(rates, 1.5));
    let within: Vec<&Beverloo> =
        laws.iter().filter(|law| law.chi_squared <= best.chi_squared + 1.0).collect();
    let ends = within.first().zip(within.last());
    let error = ends.map_or(0.0, |(a, b)| 0.5 * (b.exponent - a.exponent));
    Beverloo { error, ..best }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_by_the_law_give_the_law() {
        for n in [1.5, 1.7] {
            let law = Beverloo { c: 1.2, k: 1.8, exponent: n, error: 0.0, chi_squared: 0.0 };
            let one = |opening| Rate { opening, mean: law.rate(opening), error: 0.1 };
            let rates = [6.0, 9.0, 14.0, 21.0].map(one);
            let found = fit(&rates, None).expect("a fit");
            assert!((found.exponent - n).abs() < 1e-9, "{found:?}");
            assert!((found.k - 1.8).abs() < 1e-9 && (found.c - 1.2).abs() < 1e-9, "{found:?}");
            assert!(found.error > 0.0 && found.error < 0.1, "{found:?}");
        }
        assert_eq!(fit(&[], None), None);
    }
}

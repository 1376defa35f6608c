//! Which power law, which mean? Reads numbers; writes a slope, or a mean with its standard error.

/// The slope of ln y over ln x, by least squares.
pub fn slope(x: &[f64], y: &[f64]) -> f64 {
    let points: Vec<[f64; 2]> =
        x.iter().zip(y).map(|(x, y)| [libm::log(*x), libm::log(*y)]).collect();
    let n = points.len() as f64;
    let mean = |k: usize| points.iter().map(|p| p[k]).sum::<f64>() / n;
    let (mx, my) = (mean(0), mean(1));
    let above: f64 = points.iter().map(|p| (p[0] - mx) * (p[1] - my)).sum();
    above / points.iter().map(|p| (p[0] - mx).powi(2)).sum::<f64>()
}

/// Mean and standard error of independent values.
pub fn mean(values: &[f64]) -> [f64; 2] {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let square = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>();
    [mean, (square / (n * (n - 1.0).max(1.0))).sqrt()]
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_power_law_and_a_mean() {
        let x: Vec<f64> = (1..9).map(f64::from).collect();
        let y: Vec<f64> = x.iter().map(|x| 3.0 * x.powf(-0.7)).collect();
        assert!((super::slope(&x, &y) + 0.7).abs() < 1e-14);
        assert_eq!(super::mean(&[1.0, 3.0]), [2.0, 1.0]);
    }
}

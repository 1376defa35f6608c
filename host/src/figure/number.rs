//! How is a number written? Reads a number; writes nothing, returns text that is the same on every machine.

/// So many digits after the point; what rounds to zero has no sign.
///
/// ```
/// use carom_host::figure::number::fixed;
/// assert_eq!(fixed(-0.204, 2), "-0.20");
/// assert_eq!(fixed(-1e-9, 2), "0.00");
/// ```
pub fn fixed(x: f64, digits: usize) -> String {
    let text = format!("{x:.digits$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.bytes().all(|c| c == b'0' || c == b'.') => rest.to_owned(),
        _ => text,
    }
}

/// So many significant digits, as short as they can be.
///
/// ```
/// use carom_host::figure::number::significant;
/// assert_eq!(significant(0.0333123, 4), "0.03331");
/// assert_eq!(significant(1000.0, 6), "1000");
/// assert_eq!(significant(2.5e-15, 4), "2.5e-15");
/// ```
pub fn significant(x: f64, digits: usize) -> String {
    let scientific = format!("{x:.0$e}", digits.max(1) - 1);
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let power: i32 = exponent.parse().unwrap_or(0);
    if x == 0.0 {
        return "0".to_owned();
    }
    if !(-3..7).contains(&power) {
        return format!("{}e{exponent}", shortened(mantissa));
    }
    let after = (digits as i32 - 1 - power).max(0) as usize;
    shortened(&format!("{x:.after$}")).to_owned()
}

/// A value with its standard error, which has two digits; an error of less than 10⁻⁴ of the value is left out.
///
/// ```
/// use carom_host::figure::number::measured;
/// assert_eq!(measured(0.0226512, 0.000318), "0.02265 ± 0.00032");
/// assert_eq!(measured(0.96830922, 8.2e-7), "0.9683");
/// assert_eq!(measured(6.6e-15, 2.0e-15), "6.6e-15 ± 2.0e-15");
/// ```
pub fn measured(value: f64, error: f64) -> String {
    if value == 0.0 || error < 1e-4 * value.abs() {
        return significant(value, 4);
    }
    let scientific = format!("{error:.1e}");
    let power: i32 = scientific.split_once('e').map_or(0, |(_, e)| e.parse().unwrap_or(0));
    if !(1e-3..1e7).contains(&value.abs()) {
        return format!("{value:.1e} ± {scientific}");
    }
    let digits = (1 - power).clamp(0, 12) as usize;
    format!("{value:.digits$} ± {error:.digits$}")
}

fn shortened(text: &str) -> &str {
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => text,
    }
}

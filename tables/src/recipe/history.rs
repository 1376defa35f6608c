//! How is the course of a contact over time made for a build.rs? Reads a law; writes expansions as Rust text.

use super::emit::is_name;
use super::error::Error;
use super::number_type::EncodeNumber;
use crate::fit::history::{FittedHistory, fit, largest_error};
use crate::read::history::History;
use crate::read::law::Law;

/// The largest scaled dissipation, that of the standard tables.
const C_DIS_MAX: f64 = 1.0;

/// The course of a contact as Rust text: `pub static NAME: History<f32> = ...;`, and nothing else.
///
/// `reader_path` is the path of carom-tables' module `read` there.
///
/// # Errors
/// Names what is no name.
///
/// ```
/// use carom_tables::{read::Law, recipe::emit_history};
/// let text = emit_history(Law::Viscoelastic, "HERTZ", "::carom_tables::read")?;
/// assert!(text.contains("pub static HERTZ: ::carom_tables::read::History<f32>"));
/// # Ok::<(), carom_tables::recipe::Error>(())
/// ```
pub fn emit_history(law: Law, name: &str, reader_path: &str) -> Result<String, Error> {
    if !is_name(name) {
        return Err(Error::field("name", name, "a Rust name such as MY_TABLE"));
    }
    let FittedHistory { duration, overlap, rate } = fit(law, C_DIS_MAX);
    let [duration, overlap, rate] = [duration, overlap, rate].map(stored);
    let error = 1.5 * error_of(law, [&duration, &overlap, &rate]);
    let bytes = 4 * (duration.len() + overlap.len() + rate.len());
    Ok(format!(
        "/// Overlap and rate in a contact of the law {law:?} over time: {bytes} bytes, largest error {error:e}.\n\
         pub static {name}: {reader_path}::History<f32> = {reader_path}::History {{\n\
         law: {reader_path}::Law::{law:?}, c_dis_max: {C_DIS_MAX:?}, error: {error:?},\n\
         duration: &{duration:?},\noverlap: &{overlap:?},\nrate: &{rate:?} }};\n"
    ))
}

fn stored(values: Vec<f64>) -> Vec<f32> {
    values.into_iter().map(f32::nearest).collect()
}

/// The largest error found with the numbers as they are stored.
fn error_of(law: Law, series: [&[f32]; 3]) -> f64 {
    // A history lives as long as a program: so does this one, which is small.
    let [duration, overlap, rate] = series.map(|part| &*part.to_vec().leak());
    largest_error(&History { law, c_dis_max: C_DIS_MAX, error: 0.0, duration, overlap, rate })
}

//! How do the data of a figure read as CSV? Reads a figure; writes a line for each point.

use super::data::{Figure, Series};
use anyhow::Result;
use std::io::Write;

/// Writes series, x, y and standard error, which is empty where there is none; all digits of the numbers.
///
/// # Errors
/// An error of the sink.
///
/// ```
/// use carom_host::figure::{Figure, Series, write_csv};
/// let mut curve = Series::new("MD, N = 2");
/// curve.push_with_error(0.1, 2.0, 0.5);
/// let figure = Figure::new("l94-7", ["α", "h"]).with(curve).with(Series::new("ED").point(1.0, 3.0));
/// let mut text = Vec::new();
/// write_csv(&mut text, &figure)?;
/// assert_eq!(text, b"series,x,y,error\n\"MD, N = 2\",0.1,2.0,0.5\nED,1.0,3.0,\n");
/// # Ok::<(), anyhow::Error>(())
/// ```
pub fn write_csv(sink: &mut impl Write, figure: &Figure) -> Result<()> {
    let mut csv = csv::Writer::from_writer(sink);
    csv.write_record(["series", "x", "y", "error"])?;
    for Series { name, x, y, yerr, .. } in &figure.series {
        for (k, (x, y)) in x.iter().zip(y).enumerate() {
            let error = yerr.get(k).map_or_else(String::new, |error| format!("{error:?}"));
            csv.write_record([name.clone(), format!("{x:?}"), format!("{y:?}"), error])?;
        }
    }
    Ok(csv.flush()?)
}

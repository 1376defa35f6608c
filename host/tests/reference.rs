//! Is the reference right? Reads data and closed forms made outside it; writes nothing, fails where it is not.

#[path = "reference/closed.rs"]
mod closed;
#[path = "reference/collisions.rs"]
mod collisions;
#[path = "reference/column.rs"]
mod column;
#[path = "reference/gas.rs"]
mod gas;
#[path = "reference/input.rs"]
mod input;
#[path = "reference/invariance.rs"]
mod invariance;
#[path = "reference/nothing_missed.rs"]
mod nothing_missed;
#[path = "reference/plate.rs"]
mod plate;
#[path = "reference/verlet.rs"]
mod verlet;

/// A file of the repository's test data.
fn data(name: &str) -> String {
    let path = format!("{}/../tests/data/{name}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"))
}

/// The rows of a table with a header, fields by name.
fn table(name: &str) -> Vec<std::collections::HashMap<String, String>> {
    let mut reader = csv::Reader::from_reader(std::io::Cursor::new(data(name)));
    reader.deserialize().map(|row| row.expect("a row")).collect()
}

/// The largest of |a − b|, component by component.
fn apart<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

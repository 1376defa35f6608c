//! Is the reference right? Reads data and closed forms made outside it; writes nothing, fails where it is not.

mod closed;
mod collisions;
mod column;
mod gas;
mod input;
mod invariance;
mod nothing_missed;
mod pauses;
mod plate;
mod verlet;

/// A file of the repository's test data.
fn data(name: &str) -> String {
    let path = format!("{}/../../tests/data/{name}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"))
}

/// The rows of a table with a header, fields by name.
fn table(name: &str) -> Vec<std::collections::HashMap<String, String>> {
    let mut reader = csv::Reader::from_reader(std::io::Cursor::new(data(name)));
    reader.deserialize().map(|row| row.expect("a row")).collect()
}

/// The largest of |a − b|, component by component.
fn max_difference<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

//! What is wrong, and where? Collects problems by the path of their field; reads and writes nothing else.

use std::fmt;

/// One thing that is wrong with a scenario.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// The field, as in `grain.3.radius`; empty if it is the file as a whole.
    pub path: String,
    /// Where in the text (bytes), if that is known better than by the path.
    pub offset: Option<usize>,
    /// What is wrong and what would be right.
    pub message: String,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Problem {}

/// A path as it is read: `grain.3.radius` is "grain 3: radius".
pub fn named(path: &str) -> String {
    let mut name = String::new();
    let mut separator = "";
    for key in path.split('.') {
        if key.parse::<usize>().is_ok() {
            name.push(' ');
            name.push_str(key);
            separator = ": ";
        } else {
            name.push_str(separator);
            name.push_str(key);
            separator = ".";
        }
    }
    name
}

/// Everything that is wrong, in the order in which it was found.
#[derive(Debug, Default)]
pub struct Problems(pub Vec<Problem>);

impl Problems {
    /// One more; the message begins with the field's name.
    pub fn add(&mut self, path: impl Into<String>, rest: impl fmt::Display) {
        let path = path.into();
        let message = format!("{} {rest}", named(&path));
        self.0.push(Problem { path, offset: None, message });
    }

    /// One more, whose message says all by itself.
    pub fn say(&mut self, path: impl Into<String>, message: impl Into<String>) {
        self.0.push(Problem { path: path.into(), offset: None, message: message.into() });
    }

    /// The value must be finite and above 0.
    pub fn positive(&mut self, path: &str, value: f64) -> bool {
        self.must(path, value, value > 0.0 && value.is_finite(), "finite and above 0")
    }

    /// The value must be finite and at least 0.
    pub fn not_negative(&mut self, path: &str, value: f64) -> bool {
        self.must(path, value, value >= 0.0 && value.is_finite(), "finite and at least 0")
    }

    /// The value must be from 0 to 1.
    pub fn fraction(&mut self, path: &str, value: f64) -> bool {
        self.must(path, value, (0.0..=1.0).contains(&value), "from 0 to 1")
    }

    /// The value must be above 0 and below 1.
    pub fn packing(&mut self, path: &str, value: f64) -> bool {
        self.must(path, value, value > 0.0 && value < 1.0, "above 0 and below 1")
    }

    /// Notes the value if it is not right; returns whether it is.
    pub fn must(&mut self, path: &str, value: f64, is_right: bool, wanted: &str) -> bool {
        if !is_right {
            self.add(path, format!("is {value}, must be {wanted}"));
        }
        is_right
    }

    /// All of the numbers must be finite.
    pub fn finite(&mut self, path: &str, values: &[f64]) {
        if let Some(value) = values.iter().find(|value| !value.is_finite()) {
            self.add(path, format!("has {value}, must be finite"));
        }
    }

    /// As many finite numbers as there are axes.
    pub fn vector(&mut self, path: &str, values: &[f64], dimension: usize) {
        if values.len() != dimension {
            let length = values.len();
            let rest = format!("has {length} numbers, must have {dimension}, one for each axis");
            self.add(path, rest);
        }
        self.finite(path, values);
    }
}

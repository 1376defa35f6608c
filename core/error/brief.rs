//! What does an error say where there is no room for words? Reads an error; writes its number, what it is about, and a value.

use super::refusal::{Error, Subject};
use core::fmt;

/// An error in a few letters, such as `E10 grain 3 radius -1.000e0`: its [code](Error::code), whose it is, which field,
/// and the value.
///
/// It is written without `core::fmt`: on a Cortex-M4F it takes 1.6 KB of flash, the sentences of `Display` 25 KB.
///
/// ```
/// use carom::{Grain, Memory, World, law::HardSphere};
/// let mut memory = Memory::<f32, 2, 4>::new();
/// let refused = World::builder(&mut memory)
///     .rule(HardSphere { restitution: 0.9 })
///     .grain(Grain::with_mass(-1.0, 1.0));
/// let error = refused.err().unwrap();
/// assert_eq!(error.brief().as_str(), "E10 grain 0 radius -1.000e0");
/// ```
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Brief {
    text: [u8; Brief::LONGEST],
    length: u8,
}

impl Error {
    /// The error's number, the same for all time: for programs that have no room for words.
    ///
    /// | code | error | value that [`brief`](Self::brief) shows |
    /// |---|---|---|
    /// | 10 | [`Input`](Self::Input): a field has a value that it cannot have | that value |
    /// | 11 | [`Full`](Self::Full): no place for another grain or plane, or too few cells | how many places there are |
    /// | 12 | [`Overlap`](Self::Overlap): two overlap at the start | the gap |
    /// | 13 | [`OutsideTable`](Self::OutsideTable): a collision outside the table | η |
    /// | 14 | [`LongContact`](Self::LongContact): gravity is too strong for the contact time | the longest that is allowed |
    /// | 15 | [`InvalidOutcome`](Self::InvalidOutcome): the rule's answer is none | what it answered |
    /// | 16 | [`Stuck`](Self::Stuck): too many events at one instant | how many |
    /// | 17 | [`NotFinite`](Self::NotFinite): a grain's state is no longer a number | |
    /// | 18 | [`Past`](Self::Past): the instant asked for is over | |
    /// | 19 | [`Overflow`](Self::Overflow): a number does not fit the fixed-point type | the largest that fits |
    #[must_use]
    pub const fn code(&self) -> u8 {
        match self {
            Self::Input { .. } => 10,
            Self::Full { .. } => 11,
            Self::Overlap { .. } => 12,
            Self::OutsideTable { .. } => 13,
            Self::LongContact { .. } => 14,
            Self::InvalidOutcome { .. } => 15,
            Self::Stuck { .. } => 16,
            Self::NotFinite { .. } => 17,
            Self::Past { .. } => 18,
            Self::Overflow { .. } => 19,
        }
    }

    /// The error in a few letters.
    #[must_use]
    #[inline(never)]
    pub fn brief(&self) -> Brief {
        let mut brief = Brief { text: [0; Brief::LONGEST], length: 0 };
        brief.put(b"E");
        brief.integer(self.code().into(), 1);
        let (subject, field, value) = self.parts();
        brief.subject(subject);
        if !field.is_empty() {
            brief.put(b" ");
            brief.put(field.as_bytes());
        }
        if let Some(value) = value {
            brief.put(b" ");
            brief.value(value);
        }
        brief
    }

    /// Whose it is, which field, and a value.
    fn parts(&self) -> (Subject, &'static str, Option<f32>) {
        match *self {
            Self::Input { subject, field, value, .. } => (subject, field, Some(short(value))),
            Self::Full { capacity, .. } => (Subject::World, "", Some(capacity as f32)),
            Self::Overlap { grain, gap, .. } => (Subject::Grain(grain), "gap", Some(short(gap))),
            Self::OutsideTable { grain, eta, .. } => (Subject::Grain(grain), "", Some(short(eta))),
            Self::LongContact { longest, .. } => (Subject::World, "", Some(short(longest))),
            Self::InvalidOutcome { field, value, .. } => (Subject::Rule, field, Some(short(value))),
            Self::Stuck { grain, events, .. } => (Subject::Grain(grain), "", Some(events as f32)),
            Self::NotFinite { grain, field, .. } => (Subject::Grain(grain), field, None),
            Self::Past { .. } => (Subject::World, "", None),
            Self::Overflow { subject, quantity, range, .. } => {
                (subject, quantity, Some(short(range)))
            }
        }
    }
}

impl Brief {
    /// No text is longer: what is, is cut off.
    pub const LONGEST: usize = 64;

    /// The letters, all ASCII.
    #[must_use]
    pub fn as_bytes(&self) -> &[u8] {
        self.text.get(..self.length.into()).unwrap_or_default()
    }

    /// The same as a string.
    #[must_use]
    pub fn as_str(&self) -> &str {
        core::str::from_utf8(self.as_bytes()).unwrap_or_default()
    }

    // Not inlined, these four: the text shall be small.
    #[inline(never)]
    fn put(&mut self, letters: &[u8]) {
        for &letter in letters {
            if let Some(place) = self.text.get_mut(usize::from(self.length)) {
                *place = letter;
                self.length += 1;
            }
        }
    }

    #[inline(never)]
    fn subject(&mut self, subject: Subject) {
        let (name, number): (&[u8], _) = match subject {
            Subject::Grain(number) => (b" grain ", Some(number)),
            Subject::Plane(number) => (b" plane ", Some(number)),
            Subject::Facet(number) => (b" facet ", Some(number)),
            Subject::Axis(number) => (b" axis ", Some(number)),
            Subject::Rule => (b" rule", None),
            Subject::World => (b" world", None),
        };
        self.put(name);
        if let Some(number) = number {
            self.integer(u32::try_from(number).unwrap_or(u32::MAX), 1);
        }
    }

    /// All digits of a number, and zeros before it down to a power of ten.
    #[inline(never)]
    fn integer(&mut self, number: u32, least: u32) {
        let mut power = 1_000_000_000;
        while power > 0 {
            if power <= least || power <= number {
                self.put(&[b'0' + (number / power % 10) as u8]);
            }
            power /= 10;
        }
    }

    /// Four digits and a power of ten; large and small numbers are off by some of the last digit.
    #[inline(never)]
    fn value(&mut self, value: f32) {
        if value < 0.0 {
            self.put(b"-");
        }
        let mut left = value.abs();
        if !left.is_finite() {
            return self.put(if left.is_nan() { b"nan" } else { b"inf" });
        }
        let mut exponent = 0_i32;
        while left >= 9.9995 {
            (left, exponent) = (left * 0.1, exponent + 1);
        }
        while left < 0.99995 && left > 0.0 {
            (left, exponent) = (left * 10.0, exponent - 1);
        }
        let thousandths = (left * 1000.0 + 0.5) as u32;
        self.integer(thousandths / 1000, 1);
        self.put(b".");
        self.integer(thousandths % 1000, 100);
        self.put(if exponent < 0 { b"e-" } else { b"e" });
        self.integer(exponent.unsigned_abs(), 1);
    }
}

/// A number in `f32`, towards zero; beyond its range infinity or zero. By its bits: what converts between numbers is not
/// in every program.
fn short(number: f64) -> f32 {
    let bits = number.to_bits();
    let sign = (bits >> 32) as u32 & 1 << 31;
    // The difference of the two formats' zero exponents is 1023 - 127.
    let exponent = (bits >> 52) as u32 & 0x7FF;
    let size = match exponent.checked_sub(1023 - 127) {
        _ if bits << 1 > 0x7FF << 53 => f32::NAN.to_bits(),
        None | Some(0) => 0,
        Some(exponent @ 1..255) => exponent << 23 | (bits >> 29) as u32 & 0x7F_FFFF,
        Some(_) => f32::INFINITY.to_bits(),
    };
    f32::from_bits(sign | size)
}

impl fmt::Display for Brief {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

impl fmt::Debug for Brief {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::particle::Partner;
    use crate::scalar::Instant;
    use std::collections::HashSet;
    use std::string::ToString;

    fn all() -> [(Error, &'static str); 10] {
        let (at, with, wanted) = (Instant::from(1.0_f64), Partner::plane(2), "right");
        let subject = Subject::Plane(3);
        [
            (Error::input(subject, "offset", f64::NAN, wanted), "E10 plane 3 offset nan"),
            (Error::Full { knob: "N", capacity: 32 }, "E11 world 3.200e1"),
            (
                Error::Overlap { grain: 4_000_000_000, with, gap: -0.012_344_9, also: None },
                "E12 grain 4000000000 gap -1.234e-2",
            ),
            (
                Error::OutsideTable { grain: 0, with, eccentricity: 0.1, eta: 0.2, c_dis: 9.0 },
                "E13 grain 0 2.000e-1",
            ),
            (
                Error::LongContact { contact_time: 4.0, overlap: 0.1, longest: 3.0 },
                "E14 world 3.000e0",
            ),
            (
                Error::InvalidOutcome { field: "normal", value: f64::MAX, wanted },
                "E15 rule normal inf",
            ),
            (Error::Stuck { grain: 10, with, at, events: 4096 }, "E16 grain 10 4.096e3"),
            (Error::NotFinite { grain: 1, field: "velocity", at }, "E17 grain 1 velocity"),
            (Error::Past { asked: at, now: at }, "E18 world"),
            (Error::overflow(Subject::Axis(1), "length", 32_768.0), "E19 axis 1 length 3.277e4"),
        ]
    }

    #[test]
    fn every_error_has_a_number_and_a_brief_text() {
        let codes: HashSet<u8> = all().iter().map(|(error, _)| error.code()).collect();
        assert_eq!(codes.len(), 10);
        for (error, text) in all() {
            assert_eq!(error.brief().to_string(), text);
        }
    }

    #[test]
    fn what_is_too_long_is_cut_off() {
        let brief = Error::input(Subject::World, &"long ".repeat(20).leak()[..], 1.0, "").brief();
        assert_eq!(brief.as_bytes().len(), Brief::LONGEST);
        assert!(brief.as_str().starts_with("E10 world long long"));
    }

    proptest::proptest! {
        #[test]
        fn a_value_is_right_to_four_digits(mantissa in -9.999_f64..9.999, exponent in -30..30_i32) {
            let value = mantissa * libm::pow(10.0, f64::from(exponent));
            let text = Error::input(Subject::World, "", value, "").brief();
            let read: f64 = text.as_str().rsplit(' ').next().unwrap().parse().unwrap();
            proptest::prop_assert!((read - value).abs() <= 6e-4 * value.abs(), "{text} for {value}");
        }
    }
}

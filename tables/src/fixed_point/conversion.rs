//! How do fixed-point numbers become other types and text? Reads a number; writes a number of the package `fixed`, or decimals.

use core::fmt;

use super::number::{I16F16, I32F32};

macro_rules! conversion {
    ($name:ident, $plain:path) => {
        impl num_traits::Zero for $name {
            fn zero() -> Self {
                Self(0)
            }
            fn is_zero(&self) -> bool {
                self.0 == 0
            }
        }

        impl num_traits::One for $name {
            fn one() -> Self {
                Self::ONE
            }
        }

        impl From<$plain> for $name {
            /// The same number; the least one of the package's has no place here.
            fn from(plain: $plain) -> Self {
                Self(plain.to_bits())
            }
        }

        impl From<$name> for Option<$plain> {
            /// The same number, unless it is none.
            fn from(number: $name) -> Self {
                number.is_number().then(|| <$plain>::from_bits(number.0))
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match Option::<$plain>::from(*self) {
                    Some(plain) => plain.fmt(f),
                    None => f.pad("NaN"),
                }
            }
        }

        #[cfg(feature = "defmt")]
        impl defmt::Format for $name {
            fn format(&self, f: defmt::Formatter<'_>) {
                defmt::write!(f, "{=f64}", crate::read::Real::to_f64(*self));
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                fmt::Display::fmt(self, f)
            }
        }
    };
}

conversion!(I32F32, ::fixed::types::I32F32);
conversion!(I16F16, ::fixed::types::I16F16);

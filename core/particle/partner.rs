//! With what is a grain in contact, or about to collide? A grain, a plane, a facet or nothing, in one word; reads and writes nothing else.

/// What a grain is in contact with, or what its next event is about: one word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Partner(u32);

impl Partner {
    const FIRST_PLANE: u32 = u32::MAX - 255;
    /// From here on words are those of facets, up to the clustered grains.
    const FIRST_FACET: u32 = Self::FIRST_CLUSTERED - (1 << 24);
    /// From here on words are those of clustered grains, and name the next of them.
    const FIRST_CLUSTERED: u32 = 1 << 31;
    /// The last clustered grain.
    pub(crate) const LAST_CLUSTERED: Self = Self(Self::FIRST_PLANE - 1);
    /// What memory holds that nobody has written yet.
    pub(crate) const ZERO: Self = Self(0);
    /// Nothing at all.
    pub const NOTHING: Self = Self(u32::MAX);
    /// The most grains a world can hold: the words above name planes.
    pub const MAX_GRAINS: usize = Self::FIRST_FACET as usize - 1;
    /// The most facets that obstacles can have.
    pub const MAX_FACETS: usize = (Self::FIRST_CLUSTERED - Self::FIRST_FACET) as usize;

    /// The grain with this number.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "setup refuses more than MAX_GRAINS")]
    pub fn grain(index: usize) -> Self {
        Self(index as u32)
    }

    /// The plane with this number.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "there are at most a handful of planes")]
    pub fn plane(index: usize) -> Self {
        Self(Self::FIRST_PLANE + index as u32)
    }

    /// The facet with this number: a piece of an obstacle.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "setup refuses more than MAX_FACETS")]
    pub fn facet(index: usize) -> Self {
        Self(Self::FIRST_FACET + index as u32)
    }

    /// The grain's number, if it is a grain.
    #[must_use]
    pub fn as_grain(self) -> Option<usize> {
        (self.0 < Self::FIRST_FACET).then_some(self.0 as usize)
    }

    /// The facet's number, if it is one of an obstacle.
    #[must_use]
    pub fn as_facet(self) -> Option<usize> {
        let number = self.0.checked_sub(Self::FIRST_FACET)?;
        (self.0 < Self::FIRST_CLUSTERED).then_some(number as usize)
    }

    /// What a clustered grain has for a partner: the number of the next clustered grain, if there is one.
    pub(crate) fn clustered(next: Option<usize>) -> Self {
        next.map_or(Self::LAST_CLUSTERED, |next| Self(Self::grain(next).0 | Self::FIRST_CLUSTERED))
    }

    /// Whether this is what a clustered grain has.
    pub(crate) fn is_clustered(self) -> bool {
        self.0 >= Self::FIRST_CLUSTERED && self.0 < Self::FIRST_PLANE
    }

    /// The next clustered grain, if there is one.
    pub(crate) fn next_clustered(self) -> Option<usize> {
        let is_one = self.is_clustered() && self != Self::LAST_CLUSTERED;
        is_one.then_some((self.0 & !Self::FIRST_CLUSTERED) as usize)
    }

    /// The plane's number, if it is a plane.
    #[must_use]
    pub fn as_plane(self) -> Option<usize> {
        let number = self.0.checked_sub(Self::FIRST_PLANE)?;
        (self != Self::NOTHING).then_some(number as usize)
    }

    /// The word itself, for a digest.
    #[must_use]
    pub fn word(self) -> u32 {
        self.0
    }
}

impl core::fmt::Display for Partner {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match (self.as_grain(), self.as_plane()) {
            (Some(i), _) => write!(f, "grain {i}"),
            (_, Some(i)) => write!(f, "plane {i}"),
            _ if self.as_facet().is_some() => {
                write!(f, "facet {}", self.as_facet().unwrap_or_default())
            }
            _ if self.is_clustered() => f.write_str("a cluster"),
            _ => f.write_str("nothing"),
        }
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for Partner {
    fn format(&self, f: defmt::Formatter<'_>) {
        match (self.as_grain(), self.as_plane()) {
            (Some(i), _) => defmt::write!(f, "grain {=usize}", i),
            (_, Some(p)) => defmt::write!(f, "plane {=usize}", p),
            (None, None) if self.as_facet().is_some() => {
                defmt::write!(f, "facet {=usize}", self.as_facet().unwrap_or_default());
            }
            (None, None) => defmt::write!(f, "nothing"),
        }
    }
}

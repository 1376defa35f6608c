//! What becomes of contacts that last or crowd? Reads nothing; writes nothing, names the two modes.

/// What becomes of contacts that last or crowd.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Enduring {
    /// As in the papers: a contact is an event (L94, BSFP14) or a pair's own affair (MP13), whatever else
    /// touches the two; grains come to rest by rules of their own, rough ones hop on. Figures of the papers need it.
    Paper,
    /// Contacts of more than two, and those in which gravity decides, are integrated under the same force
    /// law; what has come to rest sleeps.
    ///
    /// The work is bounded. With t the contact time of the two smallest grains and n the
    /// [steps a contact](crate::world::WorldBuilder::steps_per_contact):
    ///
    /// * Clustered grains make a step all together, each t/n. Under a force law of the rule's own, t is the
    ///   shortest contact at the speeds there are, over √3; with the stand-in it is the
    ///   [contact time](crate::world::WorldBuilder::contact_time), and a load that presses it deeper than
    ///   R/32 makes steps shorter, by up to 14 times.
    /// * Of collisions without duration a clustered grain begins at most 8 in a step, and a free one at most 64
    ///   that follow each other within t/16: then it is clustered. That is at most 1,040 + 16 n in a time
    ///   t, with 64 more once. (Boxes that were drawn at random have less than a tenth of that.)
    /// * Of contacts with duration a pair has one in its duration.
    /// * Crossings into other cells are as many as speeds over the width of a cell say.
    #[default]
    Integrated,
}

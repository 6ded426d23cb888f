//! Numbers of laws of stretch that are plain keys of a cable: read, written, named and identified by the entry of their law.

/// A number of a law of stretch, above zero: a key of `[[cable]]`, and a parameter of every cable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LawNumber {
    /// Name of the parameter, e.g. in lists of free ones.
    pub name: &'static str,
    /// Key in the robot file.
    pub key: &'static str,
    /// Its unit, empty for a ratio.
    pub unit: &'static str,
    /// Meaning, in the words of the schema.
    pub about: &'static str,
}

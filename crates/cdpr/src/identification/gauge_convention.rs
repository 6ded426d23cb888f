//! Conventions that fix what data leave free of a robot as a whole.

use serde::Serialize;

/// Convention that fixes motions which no measurement sees.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum GaugeConvention {
    /// As many coordinates of anchors as there are motions stay at the file's values, those that the motions move most.
    #[default]
    Anchors,
    /// Of all robots that the data cannot tell apart the one whose anchors are nearest to the file's (free-network adjustment).
    LeastChange,
    /// Measured, known or held numbers fix everything; data that leave a motion free are refused.
    Known,
}

impl GaugeConvention {
    /// All of them, the default first.
    pub const ALL: [Self; 3] = [Self::Anchors, Self::LeastChange, Self::Known];

    /// Name in options and answers.
    pub fn name(self) -> &'static str {
        match self {
            Self::Anchors => "anchors",
            Self::LeastChange => "least-change",
            Self::Known => "known",
        }
    }
}

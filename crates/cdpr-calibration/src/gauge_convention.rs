//! Conventions that fix what data leave free of a robot as a whole.

use cdpr_model::reading::keywords;

/// Convention that fixes motions which no measurement sees.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
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

keywords!(GaugeConvention: Anchors = "anchors", LeastChange = "least-change", Known = "known");

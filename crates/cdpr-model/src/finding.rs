//! Findings, which speak against an answer: a kind of a closed list, where it lies, and how much it weighs.

use std::fmt;

/// Kinds of findings; the word is the one of JSON and of `cdpr explain finding::KIND`.
macro_rules! kinds {
    ($($(#[$words:meta])* $name:ident = $word:literal, $code:literal,)*) => {
        /// Kind of a finding.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum FindingKind {
            $($(#[$words])* $name,)*
        }

        impl FindingKind {
            /// All kinds.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            /// The kind's word.
            pub const fn word(self) -> &'static str {
                match self {
                    $(Self::$name => $word,)*
                }
            }

            /// The name that `cdpr explain` knows.
            pub const fn code(self) -> &'static str {
                match self {
                    $(Self::$name => $code,)*
                }
            }
        }
    };
}

kinds! {
    /// Numbers in another unit than their column's or key's.
    Unit = "unit", "finding::unit",
    /// A scale of recorded lengths that no winch has, or that all cables share.
    Scale = "scale", "finding::scale",
    /// Constants of recorded lengths that differ between parts of the data.
    Offset = "offset", "finding::offset",
    /// Anchors far from those of the file.
    Anchor = "anchor", "finding::anchor",
    /// A load that is not the file's, or not the same in all data.
    Load = "load", "finding::load",
    /// A stiffness that is not the file's, or that the data leave open.
    Stiffness = "stiffness", "finding::stiffness",
    /// Poses at which no tensions balance the load.
    Gravity = "gravity", "finding::gravity",
    /// Mirrored axes.
    Mirror = "mirror", "finding::mirror",
    /// Permuted cables or axes.
    Permutation = "permutation", "finding::permutation",
    /// Orientations written by another convention.
    RotationConvention = "rotation-convention", "finding::rotation-convention",
    /// Poses of a marker instead of the platform.
    Marker = "marker", "finding::marker",
    /// Poses in another frame than the robot's.
    Frame = "frame", "finding::frame",
    /// Clocks that differ.
    Clock = "clock", "finding::clock",
    /// Residuals that jump at a row.
    Step = "step", "finding::step",
    /// Residuals that drift with time.
    Drift = "drift", "finding::drift",
    /// A sensor that repeats one value.
    Stuck = "stuck", "finding::stuck",
    /// Recorded changes that stay behind the motion after every reversal.
    DeadBand = "dead-band", "finding::dead-band",
    /// Residuals by the direction of travel.
    Backlash = "backlash", "finding::backlash",
    /// A cable that hangs slack.
    Slack = "slack", "finding::slack",
    /// Rows that repeat others.
    Repeat = "repeat", "finding::repeat",
    /// Rows that depend on their neighbours.
    Order = "order", "finding::order",
    /// Samples that cover little of where the robot works.
    Coverage = "coverage", "finding::coverage",
    /// Residuals larger than stated accuracies explain.
    LackOfFit = "lack-of-fit", "finding::lack-of-fit",
    /// Combinations of parameters that the data hardly hold.
    WeakDirection = "weak-direction", "finding::weak-direction",
    /// Parameters at a bound.
    Bound = "bound", "finding::bound",
    /// A search that ended before its optimum, or with several; candidates that could not be judged.
    Unsettled = "unsettled", "finding::unsettled",
    /// Numbers that the data cannot see.
    Unseen = "unseen", "finding::unseen",
    /// Samples far from what any model explains.
    Outlier = "outlier", "finding::outlier",
    /// A sensor whose column does not fit the others.
    Sensor = "sensor", "finding::sensor",
}

impl fmt::Display for FindingKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

/// Weight of a finding, from least to most.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Worth knowing; the answer stands.
    Remark,
    /// The answer is to be used after reading this.
    Caution,
    /// The answer is not to be trusted.
    Distrust,
}

impl Severity {
    /// The word of JSON.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Remark => "remark",
            Self::Caution => "caution",
            Self::Distrust => "distrust",
        }
    }
}

/// Reason to doubt an answer, in words and numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// Its kind.
    pub kind: FindingKind,
    /// Its weight.
    pub severity: Severity,
    /// The cable it is about, counted from 0; `None` if it is about several or none.
    pub cable: Option<usize>,
    /// The line of the file where it begins, the header being line 1; `None` if it has no place.
    pub line: Option<usize>,
    /// Its size in `unit`.
    pub value: Option<f64>,
    /// Unit of the size; empty for a ratio.
    pub unit: &'static str,
    /// Fraction of the residuals' squares that it explains.
    pub explains: Option<f64>,
    /// The finding in a sentence.
    pub text: String,
}

impl Finding {
    /// A finding of a kind in words, without a place or a size.
    pub fn new(kind: FindingKind, severity: Severity, text: impl Into<String>) -> Self {
        let (cable, line, value, explains) = (None, None, None, None);
        Self { kind, severity, cable, line, value, unit: "", explains, text: text.into() }
    }

    /// The same about a cable (from 0).
    #[must_use]
    pub fn of_cable(self, cable: usize) -> Self {
        Self { cable: Some(cable), ..self }
    }

    /// The same from a line of the file on.
    #[must_use]
    pub fn at_line(self, line: usize) -> Self {
        Self { line: Some(line), ..self }
    }

    /// The same with its size and the unit of it.
    #[must_use]
    pub fn of_size(self, value: f64, unit: &'static str) -> Self {
        Self { value: Some(value), unit, ..self }
    }

    /// The same with the fraction of the residuals' squares that it explains.
    #[must_use]
    pub fn explaining(self, fraction: f64) -> Self {
        Self { explains: Some(fraction), ..self }
    }
}

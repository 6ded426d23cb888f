//! Causes that may stand behind residuals.

use cdpr_model::finding::FindingKind;

/// Cause that may stand behind residuals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Cause {
    /// One cable's lengths change by a constant from a row on.
    Step,
    /// The lengths of every cable change by a constant of its own from a row on.
    Offsets,
    /// The lengths of every cable change by a constant of its own in the data that are held out.
    HeldOut,
    /// The tracker moves at a row.
    Tracker,
    /// One cable's lengths drift.
    Drift,
    /// Lengths of all cables drift.
    Drifts,
    /// One cable's lengths depend on the direction of travel.
    Backlash,
    /// Those of all cables do.
    Backlashes,
    /// One cable's lengths stay where they are after a reversal, until the play is used up.
    DeadBand,
    /// Poses and lengths are of different times.
    Clock,
    /// One cable's residuals are larger than those of the others, without an order.
    Loud,
}

/// An explanation with how much it explains.
#[derive(Clone, Debug)]
pub(super) struct Explanation {
    pub(super) cause: Cause,
    pub(super) cable: Option<usize>,
    /// Index of the row where it begins, among those searched.
    pub(super) first: Option<usize>,
    /// Logarithm of the likelihood ratio less the price of parameters and places.
    pub(super) score: f64,
    /// Fraction of the squares explained: of the cable, or of all.
    pub(super) explained: f64,
    /// Size (m; m per second or row of a drift; s of a clock).
    pub(super) size: f64,
    /// Root mean square of the explained part, and of the residuals that are left (m).
    pub(super) part: f64,
    pub(super) left: f64,
}

impl Cause {
    pub(super) fn kind(self, is_redundant: bool) -> FindingKind {
        match self {
            Self::Step => FindingKind::Step,
            Self::Offsets | Self::HeldOut => FindingKind::Offset,
            Self::Tracker => FindingKind::Frame,
            Self::Drift | Self::Drifts => FindingKind::Drift,
            Self::Backlash | Self::Backlashes => FindingKind::Backlash,
            Self::DeadBand => FindingKind::DeadBand,
            Self::Clock => FindingKind::Clock,
            Self::Loud if is_redundant => FindingKind::Slack,
            Self::Loud => FindingKind::Sensor,
        }
    }

    pub(super) fn unit(self) -> &'static str {
        match self {
            Self::Drift | Self::Drifts => "m/s",
            Self::Clock => "s",
            _ => "m",
        }
    }

    /// True where two explanations are one thing in two forms: a dead band that every motion crosses is a backlash.
    pub(super) fn is_form_of(self, other: Self) -> bool {
        let is_play = |cause: Self| matches!(cause, Self::Backlash | Self::DeadBand);
        self == other || is_play(self) && is_play(other)
    }

    /// Question behind an explanation that stands alone.
    pub(super) fn question(self) -> &'static str {
        match self {
            Self::Step => ": was the cable clamped anew, or did it slip?",
            Self::Offsets | Self::HeldOut => ": were the winches set anew?",
            Self::Tracker => ": was the tracker moved?",
            Self::Drift | Self::Drifts => ": does the cable creep, or the drum warm up?",
            Self::DeadBand => ": play of gear or coupling, friction along the cable, or an encoder that reports steps?",
            Self::Backlash | Self::Backlashes => ": backlash of gear or pulleys, or friction along the cable?",
            Self::Clock => ": free `clock-offset`",
            Self::Loud => ": does it hang slack, or is its sensor disturbed?",
        }
    }
}

/// Gain of an explanation (m²), of which squares, by how many parameters and places.
pub(super) struct Explained {
    pub(super) gain: f64,
    pub(super) of: f64,
    pub(super) parameters: f64,
    pub(super) tried: f64,
}

/// Root mean squares of the explained part and of the rest (m).
pub(super) struct Spread {
    pub(super) part: f64,
    pub(super) left: f64,
}

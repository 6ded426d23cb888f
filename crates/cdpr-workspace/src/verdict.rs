//! The answer of a criterion.

/// Verdict of a criterion on one pose.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// Signed margin in the criterion's unit: at least 0 where it holds, below 0 where it fails, −∞ where no amount would
    /// mend it; never NaN.
    pub margin: f64,
    /// First reason in words when it fails (names cable and number); `None` when it holds.
    pub reason: Option<String>,
    /// The cable that limits (from 0), when one does.
    pub cable: Option<usize>,
}

impl Verdict {
    /// The criterion holds with this margin; below zero only by rounding.
    pub fn held(margin: f64, cable: Option<usize>) -> Self {
        Self { margin: margin.max(0.0), reason: None, cable }
    }

    /// The criterion fails by this margin, for a reason in words; zero or above only by rounding.
    pub fn failed(margin: f64, reason: impl Into<String>, cable: Option<usize>) -> Self {
        Self { margin: margin.min(-f64::MIN_POSITIVE), reason: Some(reason.into()), cable }
    }

    /// The criterion has no meaning at the pose, so that it fails whatever would be changed: no path of a cable, say.
    pub fn impossible(reason: impl Into<String>, cable: Option<usize>) -> Self {
        Self::failed(f64::NEG_INFINITY, reason, cable)
    }

    /// True when the criterion holds.
    pub fn holds(&self) -> bool {
        self.margin >= 0.0
    }
}

//! The answer of a criterion.

/// Verdict of a criterion on one pose.
#[derive(Clone, Debug, PartialEq)]
pub struct Verdict {
    /// Signed margin in the criterion's unit: at least 0 if it holds, below 0 if it fails, −∞ if no change of the
    /// quantity would make it hold; never NaN.
    pub margin: f64,
    /// First reason in words if it fails (names cable and number); `None` if it holds.
    pub reason: Option<String>,
    /// The limiting cable (from 0), if there is one.
    pub cable: Option<usize>,
}

impl Verdict {
    /// Verdict that the criterion holds with this margin, which may be below zero only by rounding.
    pub fn held(margin: f64, cable: Option<usize>) -> Self {
        Self { margin: margin.max(0.0), reason: None, cable }
    }

    /// Verdict that the criterion fails by this margin, for a reason in words; zero or above only by rounding.
    pub fn failed(margin: f64, reason: impl Into<String>, cable: Option<usize>) -> Self {
        Self { margin: margin.min(-f64::MIN_POSITIVE), reason: Some(reason.into()), cable }
    }

    /// Verdict that the criterion is not defined at the pose, for example because a cable has no path: the margin is
    /// −∞.
    pub fn impossible(reason: impl Into<String>, cable: Option<usize>) -> Self {
        Self::failed(f64::NEG_INFINITY, reason, cable)
    }

    /// True if the criterion holds.
    pub fn holds(&self) -> bool {
        self.margin >= 0.0
    }
}

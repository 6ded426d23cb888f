//! Verdict on force control after an identification: whether the machine follows the commanded tensions better or worse.
//!
//! An identification makes poses and lengths fit. Where the control model lacks an effect of the machine, its numbers
//! stand for that effect, and the tensions that emerge may be farther from the commanded ones than before (sec. 4.5).

use crate::Experiment;
use crate::accuracy::Assessment;
use cdpr_model::control::CommandedPose;
use cdpr_model::reading::keywords;

/// Part of the error before within which two controllers follow tensions alike.
const ALIKE: f64 = 0.01;

/// Errors of the tensions under two force controllers of one machine, at the same poses.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(non_snake_case, reason = "the fields are the keys of the answer, units included")]
pub struct ForceTracking {
    /// Comparison of both.
    pub verdict: TrackingVerdict,
    /// Mean over poses of the 2-norm of emerging less commanded tensions, with the controller before (N).
    pub before_mean_norm_N: f64,
    /// The same with the controller after (N).
    pub after_mean_norm_N: f64,
}

/// Comparison of two force controllers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TrackingVerdict {
    /// The machine follows the commanded tensions better than before.
    Better,
    /// Both errors are within a percent of each other.
    Alike,
    /// The machine follows them worse than before.
    Worse,
}

keywords!(TrackingVerdict: Better = "better", Alike = "alike", Worse = "worse");

impl ForceTracking {
    /// The comparison of two mean errors of tensions (N); `None` unless both are known.
    pub fn of(before: f64, after: f64) -> Option<Self> {
        let is_known = before.is_finite() && after.is_finite();
        let verdict = match after - before {
            change if change.abs() <= ALIKE * before => TrackingVerdict::Alike,
            change if change > 0.0 => TrackingVerdict::Worse,
            _ => TrackingVerdict::Better,
        };
        is_known.then_some(Self { verdict, before_mean_norm_N: before, after_mean_norm_N: after })
    }

    /// True if the machine follows the commanded tensions worse than before.
    pub fn is_worse(&self) -> bool {
        self.verdict == TrackingVerdict::Worse
    }
}

impl Experiment {
    /// Comparison with the controller by which the winches were set (`offset_robot` of the study), driven to the same
    /// poses; `own` is the assessment of this one. `None` if it is the same controller, or if one of both commands no
    /// tensions or has no answer.
    pub fn force_tracking(&self, poses: &[CommandedPose], own: &Assessment) -> Option<ForceTracking> {
        own.accuracy.tension_error_N?;
        let former = self.former.clone()?;
        // a former robot without what commands tensions is no error of this controller
        let before = self.with_control(former).assess(poses).ok()?;
        let errors = own.difference(poses, &before).tension_error_N?;
        ForceTracking::of(errors.other.mean, errors.own.mean)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_percent_of_the_error_before_is_alike_and_unknown_errors_have_no_verdict() {
        let verdict = |before: f64, after: f64| ForceTracking::of(before, after).map(|found| found.verdict);
        assert_eq!(verdict(100.0, 100.9), Some(TrackingVerdict::Alike));
        assert_eq!(verdict(100.0, 99.1), Some(TrackingVerdict::Alike));
        assert_eq!(verdict(100.0, 101.1), Some(TrackingVerdict::Worse));
        assert_eq!(verdict(100.0, 98.9), Some(TrackingVerdict::Better));
        assert_eq!(verdict(0.0, 1e-9), Some(TrackingVerdict::Worse));
        assert_eq!(verdict(0.0, 0.0), Some(TrackingVerdict::Alike));
        assert_eq!([verdict(f64::NAN, 1.0), verdict(1.0, f64::INFINITY)], [None, None]);
    }
}

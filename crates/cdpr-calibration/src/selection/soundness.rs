//! Candidates whose parameters nobody should rely on, however small their errors are.

use super::{JudgedCandidate, Judgement};
use crate::pose_band::PoseBand;
use cdpr_model::finding::{Finding, FindingKind, Severity};
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Samples, three_digits};

/// Poses at which weak directions are asked for their effect.
const ASKED: usize = 12;

/// Writes for every candidate whether it is sound: not at a bound, and without weak directions that move a predicted pose by more than its error on
/// validation data.
pub(super) fn judge(candidates: &mut [JudgedCandidate], samples: &Samples) {
    for judgement in candidates.iter_mut().filter_map(|candidate| candidate.outcome.as_mut().ok()) {
        if judgement.disqualified.is_none() && judgement.has_converged() {
            judgement.unsound = at_bound(judgement).or_else(|| weak(judgement, samples));
        }
    }
}

fn at_bound(judgement: &Judgement) -> Option<Finding> {
    let first = judgement.fit.at_bound().next()?;
    let text = format!(
        "not to be trusted: {} parameters ended at a bound, the first {} = {}: the optimum is where no robot can be",
        judgement.fit.at_bound().count(),
        first.name,
        three_digits(first.value)
    );
    Some(Finding::new(FindingKind::Bound, Severity::Distrust, text).of_size(first.value, first.unit))
}

fn weak(judgement: &Judgement, samples: &Samples) -> Option<Finding> {
    if judgement.fit.analysis.weak_direction_count == 0 {
        return None;
    }
    let all = &judgement.validation_samples;
    let poses: Vec<Pose> =
        (0..ASKED.min(all.len())).map(|place| samples.poses[all[place * all.len() / ASKED.min(all.len())]]).collect();
    let bands: Vec<PoseBand> = judgement.fit.pose_bands(&poses).ok()?.into_iter().flatten().collect();
    let error = judgement.validation.position_error_m.mean;
    let largest = bands.iter().map(|band| band.position).fold(0.0, f64::max);
    (largest > error).then(|| {
        let text = format!(
            "not to be trusted: the data hold {} combinations of parameters so weakly that a predicted pose moves by {} mm (one standard deviation), more than \
             its error on validation data, {} mm",
            judgement.fit.analysis.weak_direction_count,
            three_digits(1e3 * largest),
            three_digits(1e3 * error)
        );
        Finding::new(FindingKind::WeakDirection, Severity::Distrust, text).of_size(largest, "m")
    })
}

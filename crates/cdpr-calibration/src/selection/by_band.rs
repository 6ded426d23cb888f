//! Candidates compared by the band of the poses that they predict, where no pose is measured.

use super::Selection;
use crate::self_calibration::PredictedBand;
use crate::verdict::Doubt;
use cdpr_model::finding::{Finding, FindingKind, Severity};
use cdpr_model::measurement::{Fact, InternalSamples, three_digits};

/// Factor of the narrowest band within which bands are as good.
const AS_GOOD: f64 = 1.1;

/// Doubts about a candidate by its band: what the data cannot see, a band that is too wide, or data without any distance.
pub(super) fn doubts_of_band(band: Option<&PredictedBand>, internal: &InternalSamples) -> Vec<Doubt> {
    let mut findings: Vec<Finding> = band.map(|band| band.findings.clone()).unwrap_or_default();
    if findings.is_empty() && !has_distance(internal) {
        findings.push(Finding::new(
            FindingKind::Unseen,
            Severity::Caution,
            "no pose and no distance is in these data: the size of the robot is the file's; measure the distance of two frame anchors (--known distance[1,2]=…), or of two \
             poses far apart",
        ));
    }
    findings.into_iter().map(Doubt::from).collect()
}

/// True where a distance, a length from the anchors or a position is known.
fn has_distance(internal: &InternalSamples) -> bool {
    let is_distance = |fact: &Fact| matches!(fact, Fact::Distance { .. } | Fact::Length { .. });
    internal.known_count() > 0 || internal.facts.iter().any(|known| is_distance(&known.fact))
}

/// Among the candidates that lengths do not tell from the best, recommends the simplest whose band is as narrow as any.
pub(super) fn choose_by_band(selection: &mut Selection) {
    let (Some(best), Some(simplest)) = (selection.best, selection.recommended) else { return };
    let judged = |index: usize| selection.candidates[index].outcome.as_ref().ok();
    let limit =
        judged(best).map(|best| best.criterion + Some(best.standard_error).filter(|e| e.is_finite()).unwrap_or(0.0));
    let Some(limit) = limit else { return };
    let band = |index: usize| {
        let own = judged(index)?;
        let is_near = own.criterion <= limit && own.has_converged() && own.meets_requirements();
        Some(own.pose_band.as_ref().filter(|_| is_near)?.band_m)
    };
    let bands: Vec<Option<f64>> = (0..selection.candidates.len()).map(band).collect();
    let Some(narrowest) = bands.iter().flatten().copied().min_by(f64::total_cmp) else { return };
    // what lengths themselves err by tells no bands apart
    let of_lengths = judged(best).map_or(0.0, |best| best.validation.length_error_m.mean_abs).max(0.0);
    let widest = (AS_GOOD * narrowest).max(narrowest + of_lengths);
    let is_as_good = |own: &Option<f64>| own.is_some_and(|own| own <= widest);
    let Some(chosen) = bands.iter().position(is_as_good) else { return };
    let told = bands[simplest].zip(bands[chosen]);
    if let Some((of_simplest, of_chosen)) = told.filter(|_| chosen != simplest) {
        let [simplest, own] = [simplest, chosen].map(|index| selection.candidates[index].name.clone());
        selection.reason = format!(
            "`{own}` has the narrowest band of predicted poses, {} mm (rms), of the candidates whose lengths are as good; `{simplest}`, the simplest of them, has {} mm",
            three_digits(1e3 * of_chosen),
            three_digits(1e3 * of_simplest)
        );
        selection.recommended = Some(chosen);
    }
}

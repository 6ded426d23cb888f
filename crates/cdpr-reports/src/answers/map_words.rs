//! Maps that correct a control model's lengths, in words.

use cdpr_model::compensation::Beyond;
use cdpr_model::control::error_statistics::PoseErrorStatistics;
use cdpr_study::Experiment;
use cdpr_study::field::Field;

use super::title;

/// The control model of an experiment with its map, as answers and figures name it.
pub fn control_title(experiment: &Experiment) -> String {
    let map = experiment.study.control.compensation.as_ref().filter(|_| experiment.compensation.is_some());
    let corrected = map.map_or_else(String::new, |file| format!(" corrected by {file}"));
    format!("{}{corrected}", title(&experiment.control))
}

/// Remarks on the errors of a study: poses outside the machine's reach, and beyond the samples of its map.
pub fn study_remarks(experiment: &Experiment, found: &Field) -> Vec<String> {
    let beyond = found.summary.compensation.as_ref().map(|map| map.beyond).unwrap_or_default();
    let beyond = beyond_map(beyond, &format!("{} poses", found.samples.len()));
    found.remark(&experiment.machine).into_iter().chain(beyond).collect()
}

/// Cautions about places beyond the samples of a study's map and in the margin around them; empty where there are none.
pub(crate) fn beyond_map(beyond: Beyond, places: &str) -> Vec<String> {
    beyond_words(beyond, places, "the samples of [control] compensation", "the control model alone drives there")
}

/// Cautions about places beyond samples, where `alone` says who acts without a map, and in the margin around them.
pub(crate) fn beyond_words(beyond: Beyond, places: &str, samples: &str, alone: &str) -> Vec<String> {
    let Beyond { outside, fading } = beyond;
    let outside = (outside > 0).then(|| format!("{outside} of {places} lie beyond {samples}: {alone}"));
    let fading = (fading > 0)
        .then(|| format!("{fading} of {places} lie in the margin around {samples}: the correction fades there"));
    outside.into_iter().chain(fading).collect()
}

/// Sentence on what a map makes of position errors; empty where the machine came to no pose with it or without.
pub(crate) fn gain_words(with: &PoseErrorStatistics, without: &PoseErrorStatistics) -> String {
    if !with.mean.is_finite() || !without.mean.is_finite() {
        return String::new();
    }
    let both = |with: f64, without: f64| format!("{:.3} instead of {:.3} mm", 1e3 * with, 1e3 * without);
    let (mean, most) = (both(with.mean, without.mean), both(with.max, without.max));
    format!("\nwith its map positions are missed by {mean} in the mean, {most} at most\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_machine_that_came_to_no_pose_has_no_sentence_on_its_map() {
        let all = |value: f64| PoseErrorStatistics { mean: value, rms: value, median: value, p95: value, max: value };
        let [some, none] = [1e-3, f64::NAN].map(all);
        assert!(gain_words(&some, &none).is_empty() && gain_words(&none, &some).is_empty());
        assert!(gain_words(&some, &some).contains("1.000 instead of 1.000 mm in the mean"));
    }
}

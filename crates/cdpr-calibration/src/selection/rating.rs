//! Candidates rated by several criteria side by side (sec. 4.4), and whether these agree.

use super::JudgedCandidate;
use super::preferences::{Outcome, Preference, preferences};
use super::settings::Settings;
use crate::fit::Fit;
use crate::likelihood;
use cdpr_model::control::error_statistics::diagonal;
use cdpr_model::measurement::Samples;
use cdpr_model::robot::Robot;

/// Reason why criteria are missing beside other objectives.
const WITHOUT_LIKELIHOOD: &str = "; no AIC and BIC: they follow from a likelihood, which least squares of lengths make large and this objective does not";

/// Choices of several criteria.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rating {
    /// Every criterion with its choice.
    pub criteria: Vec<Preference>,
    /// Whether all of them choose the same candidate.
    pub agrees: bool,
    /// Agreement or disagreement in words; empty where nothing is to choose.
    pub words: String,
}

/// Writes likelihood, information criteria and relative error of every candidate.
pub(super) fn inform(robot: &Robot, samples: &Samples, candidates: &mut [JudgedCandidate], settings: &Settings) {
    let fits: Vec<&Fit> =
        candidates.iter().filter_map(|candidate| Some(&candidate.outcome.as_ref().ok()?.fit)).collect();
    let found = likelihood::information(robot, &fits, settings.fit.loss);
    let judgements = candidates.iter_mut().filter_map(|candidate| candidate.outcome.as_mut().ok());
    for (judgement, information) in judgements.zip(found) {
        judgement.information = information;
        let diagonal = diagonal(|| judgement.validation_samples.iter().map(|&sample| samples.poses[sample].position));
        judgement.relative_position_error =
            (diagonal > 0.0).then(|| judgement.validation.position_error_m.mean / diagonal);
    }
}

/// The rating of a comparison that has its choice.
pub(super) fn rate(outcome: Outcome<'_>, settings: &Settings) -> Rating {
    let criteria = preferences(outcome, settings);
    let agrees = criteria.windows(2).all(|pair| pair[0].candidate == pair[1].candidate);
    let mut words = match criteria.len() {
        0 | 1 => String::new(),
        _ if agrees => format!("all {} criteria choose `{}`", criteria.len(), criteria[0].candidate_name),
        _ => disagreement(&criteria),
    };
    if settings.fit.is_other_objective() && !words.is_empty() {
        words.push_str(WITHOUT_LIKELIHOOD);
    }
    Rating { criteria, agrees, words }
}

fn disagreement(criteria: &[Preference]) -> String {
    let mut chosen: Vec<usize> = Vec::new();
    for preference in criteria {
        if !chosen.contains(&preference.candidate) {
            chosen.push(preference.candidate);
        }
    }
    let by = |&candidate: &usize| {
        let own: Vec<&Preference> = criteria.iter().filter(|one| one.candidate == candidate).collect();
        let words: Vec<&str> = own.iter().map(|one| one.words.as_str()).collect();
        format!("`{}` by {}", own[0].candidate_name, words.join(", "))
    };
    format!("the criteria disagree: {}", chosen.iter().map(by).collect::<Vec<_>>().join("; "))
}

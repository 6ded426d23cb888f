//! Candidates whose fit did not converge: none is recommended.

use super::support::{builtin, measured, simulator};
use cdpr_calibration::candidate::parse_list;
use cdpr_calibration::fit;
use cdpr_calibration::selection::{self, Selection, select};
use cdpr_calibration::unobserved;
use cdpr_model::measurement::Split;
use cdpr_model::model::Composition;

/// Candidates on the kinematic twin, by so many steps of each fit at most.
fn selected(candidates: &str, max_iterations: u32) -> Selection {
    let truth = builtin("cablerobot-simulator-helicopter-kinematic-calibrated");
    let samples = measured(&truth, Composition::STANDARD, 91, 0.15, 3);
    let folds = Split::Blocks(4).folds(&samples, 0).unwrap();
    let fit = fit::Settings { max_iterations, ..fit::Settings::default() };
    let settings = selection::Settings { fit, ..selection::Settings::default() };
    select(&simulator(), &parse_list(candidates).unwrap(), &samples, &folds, &settings, &unobserved).unwrap()
}

/// One step leads nearly to the optimum, and to errors far below those of the model as given: the candidate is told with its errors and not recommended, by the rule nor by any
/// other criterion.
#[test]
fn a_candidate_that_did_not_converge_is_never_recommended() {
    let ladder = "standard;standard:frame-anchor,length-offset";
    let found = selected(ladder, 1);
    let judged = |index: usize| found.candidates[index].outcome.as_ref().unwrap();
    assert_eq!(judged(1).fit.status, fit::Status::NotConverged);
    assert!(judged(1).criterion < 0.5 * judged(0).criterion, "{} {}", judged(1).criterion, judged(0).criterion);
    assert_eq!((found.best, found.recommended), (Some(0), Some(0)), "{}", found.reason);
    assert!(found.reason.contains("its fit did not converge"), "{}", found.reason);
    assert!(found.rating.criteria.iter().all(|criterion| criterion.candidate == 0), "{:?}", found.rating);
    let alone = selected("standard:frame-anchor,length-offset", 1);
    assert_eq!((alone.best, alone.recommended), (None, None));
    assert!(alone.reason.contains("its fit did not converge"), "{}", alone.reason);
    assert_eq!(selected(ladder, 200).recommended, Some(1));
}

//! Long work that its caller stops, and cross-validation with the loss of the reported fit.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicUsize, Ordering};

use super::support::{builtin, measured, simulator};
use cdpr_calibration::candidate::parse_list;
use cdpr_calibration::fit::{self, fit, fit_observed};
use cdpr_calibration::selection::{self, select};
use cdpr_calibration::{Loss, cross_validate, cross_validation_fits, evaluate_fitted, unobserved};
use cdpr_model::measurement::{Samples, Split};
use cdpr_model::model::{Composition, Model};

fn samples() -> Samples {
    measured(&builtin("cablerobot-simulator-helicopter-kinematic-calibrated"), Composition::STANDARD, 60, 0.15, 3)
}

/// A progress that asks to stop at its call of this number, and counts its calls.
fn stop_at(calls: &AtomicUsize, last: usize) -> ControlFlow<()> {
    match calls.fetch_add(1, Ordering::Relaxed) + 1 < last {
        true => ControlFlow::Continue(()),
        false => ControlFlow::Break(()),
    }
}

#[test]
fn a_fit_of_many_starts_stops_at_the_start_at_which_it_is_asked_to() {
    let model = Model::new(simulator(), Composition::STANDARD).unwrap();
    let settings = fit::Settings { starts: 20, ..fit::Settings::default() };
    for last in [1, 7] {
        let calls = AtomicUsize::new(0);
        let free = "frame-anchor,length-offset".parse().unwrap();
        let found = fit_observed(&model, &samples(), &free, &settings, &|| stop_at(&calls, last));
        assert_eq!(found.unwrap_err(), fit::InputError::Stopped);
        assert_eq!(calls.into_inner(), last);
    }
}

#[test]
fn a_selection_stops_on_all_threads() {
    let samples = samples();
    let folds = Split::Blocks(4).folds(&samples, 0).unwrap();
    let candidates = parse_list("standard;standard:frame-anchor;standard:frame-anchor,length-offset").unwrap();
    let calls = AtomicUsize::new(0);
    let progress = || stop_at(&calls, 3);
    let found = select(&simulator(), &candidates, &samples, &folds, &selection::Settings::default(), &progress);
    assert_eq!(found.unwrap_err(), selection::InputError::Stopped);
    // a fit that another thread has begun may end, and no further one begins
    let most = 3 + std::thread::available_parallelism().map_or(1, usize::from);
    assert!(calls.into_inner() <= most);
}

#[test]
fn held_out_errors_are_those_of_fits_without_the_fold() {
    let (samples, model) = (samples(), Model::new(simulator(), Composition::STANDARD).unwrap());
    let free = "frame-anchor,length-offset".parse().unwrap();
    let settings = fit::Settings { loss: Loss::Squared, ..fit::Settings::default() };
    for count in [1, 4] {
        let mut folds = Split::Blocks(4).folds(&samples, 0).unwrap();
        folds.truncate(count);
        let found = cross_validate(&model, &samples, &free, &settings, &folds, &unobserved).unwrap();
        assert_eq!(cross_validation_fits(&folds), if count == 1 { 1 } else { 5 });
        let mut position = Vec::new();
        for fold in &folds {
            let own = fit(&model, &samples.subset(&fold.train), &free, &settings).unwrap();
            let errors = evaluate_fitted(&own.model, &own.as_fitted(&samples.subset(&fold.validation))).unwrap();
            position.push(errors.blocks().length_error_m.rms);
        }
        let mean = position.iter().map(|rms| rms * rms).sum::<f64>() / position.len() as f64;
        let rms = found.after.blocks().length_error_m.rms;
        assert!((rms - mean.sqrt()).abs() < 1e-12 * rms, "{rms} {}", mean.sqrt());
        assert!(found.before.blocks().length_error_m.rms > rms);
        assert_eq!(found.part.len(), if count == 1 { folds[0].train.len() } else { samples.len() });
    }
}

//! Course of a fit: the steps of the dissertation's optimisations, from the file's values to the optimum (Figs. 4.13–4.15, 6.7, 6.20).

use super::studies::record;
use super::support::builtin;
use cdpr_calibration::fit::{Fit, Minimizer, Prior, Settings, fit};
use cdpr_calibration::{CourseStep, Loss, Minimize, Objective, conditioning, course, evaluate};
use cdpr_model::measurement::{Samples, SensorSigmas};
use cdpr_model::model::{Composition, FreeParameters, Model};
use cdpr_model::robot::ParameterKind;

const ELASTIC: &str = "frame-anchor,platform-anchor,compliance,wrench";

fn twin() -> Samples {
    record("twin-measurements", 1)
}

/// A fit of the nominal robot to the twin's record with its course, which begins at the file's values and ends at the fit's.
fn followed(composition: Composition, free: &str, settings: &Settings) -> (Fit, Vec<CourseStep>) {
    followed_on(&twin(), composition, free, settings)
}

fn followed_on(samples: &Samples, composition: Composition, free: &str, settings: &Settings) -> (Fit, Vec<CourseStep>) {
    let settings = Settings { keeps_course: true, ..settings.clone() };
    let model = Model::new(builtin("cablerobot-simulator-helicopter"), composition).unwrap();
    let fit = fit(&model, samples, &free.parse().unwrap(), &settings).unwrap();
    let steps = course(samples, &fit, &settings).unwrap();
    let values = |of: &dyn Fn(usize) -> f64| (0..fit.parameters.len()).map(of).collect::<Vec<f64>>();
    assert_eq!(steps.first().unwrap().values, values(&|k| fit.parameters[k].start));
    assert_eq!(steps.last().unwrap().values, values(&|k| fit.parameters[k].value));
    assert!(steps[0].step_m.is_none() && steps[1..].iter().all(|step| step.step_m.unwrap() > 0.0));
    (fit, steps)
}

fn with_prior() -> Settings {
    Settings { priors: vec![Prior { kind: ParameterKind::PlatformAnchor, sigma: 0.02 }], ..Settings::default() }
}

/// The dissertation prints three steps for the kinematic model (sec. 6.2): three beyond a tenth of a millimetre, and a fourth beyond a hundredth. Accuracies that rows are weighed by follow the
/// parameters and add steps of some micrometres: here all rows weigh the same.
#[test]
fn twenty_four_parameters_take_four_gauss_newton_steps() {
    let settings = Settings { minimizer: Minimizer::GaussNewton, ..Settings::default() };
    let samples = Samples { sigmas: SensorSigmas::default(), ..twin() };
    let (fit, steps) = followed_on(&samples, Composition::STANDARD, "frame-anchor", &settings);
    println!("{:?}", steps.iter().map(|step| (step.step_m, step.length_rms_m, step.condition)).collect::<Vec<_>>());
    let last = steps.last().unwrap();
    let beyond = |metres: f64| steps.iter().filter(|step| step.step_m.is_some_and(|own| own > metres)).count();
    assert_eq!([beyond(1e-4), beyond(1e-5)], [3, 4]);
    assert!(steps[1].length_rms_m < 0.2 * steps[0].length_rms_m);
    assert!(last.force_rms.is_none() && last.moment_rms.is_none() && last.position_rms_m.is_none());
    let errors = evaluate(&fit.model, &twin()).unwrap().blocks();
    assert!((last.length_rms_m / errors.length_error_m.rms - 1.0).abs() < 1e-12);
    // without weights, block by block the same singular values
    assert!((last.condition / fit.analysis.condition - 1.0).abs() < 1e-9);
    assert_eq!(last.rank, 24);
}

/// The dissertation prints eight steps for the elastostatic model (sec. 6.5), this library has taken five to eight.
#[test]
fn sixty_two_parameters_take_five_to_eight_steps() {
    let settings = with_prior();
    let (fit, steps) = followed(Composition::ELASTIC, ELASTIC, &settings);
    println!(
        "{:?}",
        steps.iter().map(|step| (step.step_m, step.length_rms_m, step.force_rms, step.moment_rms)).collect::<Vec<_>>()
    );
    let moved = steps.iter().filter(|step| step.step_m.is_some_and(|metres| metres > 1e-5)).count();
    assert!((4..=8).contains(&moved), "{moved}");
    let (first, last) = (&steps[0], steps.last().unwrap());
    assert!(last.length_rms_m < 0.2 * first.length_rms_m);
    assert!(last.force_rms.unwrap() < first.force_rms.unwrap());
    assert!(last.moment_rms.unwrap() < first.moment_rms.unwrap());
    let free: FreeParameters = ELASTIC.parse().unwrap();
    let condition = conditioning(&fit.model, &twin(), &free, &settings, &[]).unwrap();
    // the same columns of one length, before their rows are reflected or after: rounding times the condition
    assert!((last.condition / condition.condition - 1.0).abs() < 1e-9);
    assert!((last.condition_scaled / condition.condition_unit_columns - 1.0).abs() < 1e-12);
}

/// What is kept moves nothing: the same steps lead to the same values.
#[test]
fn a_fit_that_keeps_its_course_is_the_same_and_one_that_does_not_has_none() {
    let model = Model::new(builtin("cablerobot-simulator-helicopter"), Composition::ELASTIC).unwrap();
    let (kept, _) = followed(Composition::ELASTIC, ELASTIC, &with_prior());
    let plain = fit(&model, &twin(), &ELASTIC.parse().unwrap(), &with_prior()).unwrap();
    assert_eq!((&plain.parameters, &plain.history), (&kept.parameters, &kept.history));
    assert!(course(&twin(), &plain, &with_prior()).unwrap().is_empty());
}

/// Robust losses, other starts, other costs and other objectives have their way too; predicted poses tell their own error.
#[test]
fn every_search_tells_its_way() {
    let plain = Settings::default();
    for settings in [
        Settings { loss: Loss::Huber, ..plain.clone() },
        Settings { starts: 3, ..plain.clone() },
        Settings { minimize: Minimize::Mean, ..plain.clone() },
        Settings { minimize: Minimize::Max, ..plain.clone() },
    ] {
        let (_, steps) = followed(Composition::STANDARD, "frame-anchor", &Settings { starts: 1, ..settings.clone() });
        assert!(steps.len() > 3 && steps.last().unwrap().length_rms_m < 0.2 * steps[0].length_rms_m, "{settings:?}");
    }
    let (_, steps) = followed(Composition::ELASTIC, ELASTIC, &Settings { loss: Loss::Huber, ..with_prior() });
    assert!(steps.last().unwrap().length_rms_m < 0.2 * steps[0].length_rms_m);
    let (_, steps) = followed(Composition::STANDARD, "frame-anchor", &Settings { objective: Objective::Pose, ..plain });
    let predicted: Vec<f64> = steps.iter().map(|step| step.position_rms_m.unwrap()).collect();
    assert!(predicted.last().unwrap() < &(0.2 * predicted[0]), "{predicted:?}");
}

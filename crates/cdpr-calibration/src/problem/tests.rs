//! Samples without a prediction.

use crate::fit::{InputError, Settings, fit};
use crate::loss::Loss;
use crate::objective::Objective;
use crate::residual::tests::{crane, samples};
use cdpr_model::measurement::Samples;
use cdpr_model::model::{Composition, FreeParameters};

/// One sample of eleven whose lengths belong to no pose is left out, and the fit is that of the other ten with a warning; three are an error.
#[test]
fn a_sample_without_a_prediction_is_left_out_and_told() {
    let model = crane(Composition::PULLEY);
    let mut samples = samples(&model);
    let free: FreeParameters = "frame-anchor[1,2]".parse().unwrap();
    let settings = Settings { objective: Objective::Pose, loss: Loss::Squared, ..Settings::default() };
    let others: Vec<usize> = (0..samples.len()).filter(|sample| *sample != 3).collect();
    let expected = fit(&model, &samples.subset(&others), &free, &settings).unwrap();
    let cables = samples.cable_count;
    let spoil = |samples: &mut Samples, sample: usize| {
        samples.lengths[sample * cables..][..cables].iter_mut().step_by(2).for_each(|length| *length += 60.0);
    };
    spoil(&mut samples, 3);
    let found = fit(&model, &samples, &free, &settings).unwrap();
    assert!(found.warnings[0].starts_with("1 of 11 samples"), "{:?}", found.warnings);
    for (one, other) in found.parameters.iter().zip(&expected.parameters) {
        // searches begin at the file's values, one by the shorter way to the squares
        assert!((one.value - other.value).abs() < 1e-7, "{}: {} {}", one.name, one.value, other.value);
        let (sigma, expected) = (one.sigma.unwrap(), other.sigma.unwrap());
        assert!((sigma / expected - 1.0).abs() < 1e-4, "{}: {sigma} {expected}", one.name);
    }
    for sample in [5, 7] {
        spoil(&mut samples, sample);
    }
    let refused = fit(&model, &samples, &free, &settings).unwrap_err();
    assert!(matches!(refused, InputError::NoPrediction { sample: 4, .. }), "{refused}");
}

//! The block solver against a general least-squares library on the same problem.

use cdpr_calibration::Loss;
use cdpr_calibration::fit::{Settings, optimal_parameters};
use levenberg_marquardt::LevenbergMarquardt;

/// Both stop when no digit is left to gain; 1e-9 m is far below what any sensor sees and far above what rounding leaves.
#[test]
fn cable_blocks_find_the_optimum_of_the_dense_problem() {
    let (model, samples) = super::dense::problem();
    let free = "frame-anchor,platform-anchor".parse().unwrap();
    let settings = Settings { loss: Loss::Squared, ..Settings::default() };
    let blocks = optimal_parameters(&model, &samples, &free, &settings).unwrap();
    assert!(blocks.converged);
    let found: Vec<f64> = blocks.parameters.iter().map(|parameter| parameter.value(blocks.model.robot())).collect();
    // the defaults stop at 1e-14 of the cost, which leaves the parameters 1e-9 m off
    let to_the_last_digits = LevenbergMarquardt::new().with_ftol(0.0).with_gtol(0.0).with_xtol(1e-12);
    let expected = super::dense::solve(&model, &samples, to_the_last_digits);
    assert_eq!(found.len(), expected.len());
    for ((found, expected), parameter) in found.iter().zip(&expected).zip(&blocks.parameters) {
        assert!((found - expected).abs() < 1e-9, "{}: {found} {expected}", parameter.name(model.robot()));
    }
}

//! Fits of an elastic model whose rows of wrenches and lengths have stated weights.

use super::studies::experiment;
use cdpr_calibration::fit::{RowWeights, Settings, fit};
use cdpr_model::model::FreeParameters;
use cdpr_model::robot::ParameterKind;

const ROWS: RowWeights = RowWeights { wrench: 1.0, length: 1e4 };

fn free() -> FreeParameters {
    "frame-anchor,compliance,wrench".parse().unwrap()
}

fn settings() -> Settings {
    Settings { row_weights: Some(ROWS), ..Settings::default() }
}

/// Inverse form of sec. 4.5 with w_we = 1 and w_q = 10⁴, by another program (C25.5): Δa in mm, 1/k_F in 1/GN, w in N.
#[test]
fn the_example_with_row_weights_is_reproduced() {
    let experiment = experiment("planar-force-tracking");
    let record = experiment.record(&experiment.commands(Vec::new(), 0).unwrap(), 0).unwrap().samples;
    let found = fit(&experiment.control, &record, &free(), &settings()).unwrap();
    let changes = [0.368, 13.318, -5.337, 15.135, -3.029, 6.816, 4.136, 10.303];
    let of = |kind: ParameterKind| found.parameters.iter().filter(move |estimate| estimate.parameter.kind == kind);
    for (estimate, expected) in of(ParameterKind::FrameAnchor).zip(changes) {
        assert!((1e3 * estimate.change - expected).abs() < 2e-3, "{} {}", estimate.name, 1e3 * estimate.change);
    }
    for (estimate, expected) in of(ParameterKind::Compliance).zip([5099.8, 5024.5, 4959.4, 4945.6]) {
        assert!((1e9 * estimate.value - expected).abs() < 0.1, "{} {}", estimate.name, 1e9 * estimate.value);
    }
    for (estimate, expected) in of(ParameterKind::Wrench).zip([-3.88, -1947.97]) {
        assert!((estimate.value - expected).abs() < 0.01, "{} {}", estimate.name, estimate.value);
    }
    let cost = found.history.last().unwrap();
    assert!((cost - 179_195.718).abs() < 0.01, "{cost}");
    let ten_times = RowWeights { wrench: 10.0, length: 1e5 };
    let settings = Settings { row_weights: Some(ten_times), ..Settings::default() };
    let again = fit(&experiment.control, &record, &free(), &settings).unwrap();
    for (one, other) in found.parameters.iter().zip(&again.parameters) {
        assert!(
            (one.value - other.value).abs() <= 1e-6 * one.value.abs(),
            "{}: {} {}",
            one.name,
            one.value,
            other.value
        );
    }
}

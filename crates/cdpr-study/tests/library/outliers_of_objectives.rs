//! Rows that are wrong, where predicted poses are fitted, or lengths and poses together.

use super::outliers::{ANCHORS, displace, record};
use super::support::simulator;
use cdpr_calibration::fit::{Fit, Settings, Status, fit};
use cdpr_calibration::{Loss, Objective};
use cdpr_model::measurement::Samples;
use cdpr_model::model::{Composition, Model};

fn identified(samples: &Samples, objective: Objective, loss: Loss) -> Fit {
    let model = Model::new(simulator(), Composition::STANDARD).unwrap();
    let settings = Settings { objective, loss, ..Settings::default() };
    let found = fit(&model, samples, &ANCHORS.parse().unwrap(), &settings).unwrap();
    assert_eq!(found.status, Status::Converged, "{objective:?} {loss:?}: {}", found.reason);
    found
}

fn named(found: &Fit) -> Vec<usize> {
    found.outliers.iter().map(|outlier| outlier.sample - 1).collect()
}

/// Root mean square of the changes from another fit in its standard deviations.
fn away(found: &Fit, from: &Fit) -> f64 {
    let pairs = found.parameters.iter().zip(&from.parameters);
    let squares = pairs.map(|(a, b)| ((a.value - b.value) / b.sigma.unwrap()).powi(2));
    (squares.sum::<f64>() / found.parameters.len() as f64).sqrt()
}

/// All six displaced rows of 200 are named and no other, by every loss that looks for them; parameters stay where clean data have them, which
/// least squares leave.
#[test]
fn displaced_rows_are_named_whatever_is_fitted() {
    for objective in [Objective::Pose, Objective::Both] {
        for seed in 0..6 {
            let clean = record(seed);
            let mut dirty = clean.clone();
            let rows = displace(&mut dirty, seed);
            let of_clean = identified(&clean, objective, Loss::Auto);
            let squared = identified(&clean, objective, Loss::Squared);
            assert_eq!((of_clean.loss, &of_clean.parameters), (Loss::Squared, &squared.parameters));
            assert_eq!((&of_clean.history, named(&of_clean)), (&squared.history, Vec::new()), "{objective:?} {seed}");
            for loss in [Loss::Auto, Loss::Huber, Loss::Cauchy] {
                let of_dirty = identified(&dirty, objective, loss);
                assert_eq!(named(&of_dirty), rows, "{objective:?}, seed {seed}, {loss:?}");
                assert!(of_dirty.loss != Loss::Squared && of_dirty.outlier_warning.is_some());
                let change = away(&of_dirty, &of_clean);
                assert!(change < 0.8, "{objective:?}, seed {seed}, {loss:?}: {change:.2} deviations");
            }
            let spoiled = identified(&dirty, objective, Loss::Squared);
            assert!(away(&spoiled, &of_clean) > 2.0, "{objective:?}, seed {seed}: {:.2}", away(&spoiled, &of_clean));
        }
    }
}

/// Lengths agree among each other far better than with poses: whitened together, a cable that is wrong by 10 mm is named, which its own deviation hides.
#[test]
fn a_cable_that_lies_is_named_where_its_sample_is_whitened_together() {
    let mut dirty = record(5);
    let lengths = dirty.cable_count;
    dirty.lengths[lengths * 30 + 2] += 0.01;
    let found = identified(&dirty, Objective::Both, Loss::Auto);
    assert_eq!(named(&found), [30]);
    assert!(found.outliers[0].reason.contains("cable 3"), "{}", found.outliers[0].reason);
}

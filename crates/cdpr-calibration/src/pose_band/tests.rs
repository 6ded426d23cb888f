use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, Normal};

use crate::fit::{Settings, fit};
use cdpr_model::control::CommandedPose;
use cdpr_model::control::{Operation, Status};
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Samples, SensorSigmas};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::Robot;

/// Calibrated on 200 noisy recordings, controllers drive the true machine to poses that scatter as their bands say: 200 tell a deviation to 5 %,
/// and each fit has a band of its own, which is the same within some percent.
#[test]
fn poses_of_controllers_calibrated_anew_scatter_as_the_band_says() {
    const SIGMA: f64 = 1e-3;
    let truth = Model::new(Robot::builtin("planar-example").unwrap(), Composition::STANDARD).unwrap();
    let home = truth.robot().home_or_middle();
    let at = |x: f64, z: f64| Pose { position: home.position + truth.axes()[0] * x + truth.axes()[1] * z, ..home };
    let measured: Vec<Pose> = (0..40).map(|k| at((0.7 * f64::from(k)).sin(), (1.1 * f64::from(k)).cos())).collect();
    let commanded = [at(0.0, 0.0), at(2.5, -1.0)];
    let mut squares = [0.0; 2];
    let mut bands = [0.0; 2];
    const RECORDS: u64 = 200;
    for seed in 0..RECORDS {
        let (mut rng, noise) = (ChaCha8Rng::seed_from_u64(seed), Normal::new(0.0, SIGMA).unwrap());
        let lengths = measured.iter().flat_map(|pose| truth.cable_lengths(pose).unwrap());
        let lengths = lengths.map(|length| length + noise.sample(&mut rng)).collect();
        let sigmas = SensorSigmas { length: Some(SIGMA), ..SensorSigmas::default() };
        let samples = Samples { poses: measured.clone(), lengths, cable_count: 4, sigmas, ..Samples::default() };
        let fit = fit(&truth, &samples, &"frame-anchor".parse().unwrap(), &Settings::default()).unwrap();
        let mut operation = Operation::new(&fit.model, &truth, &[0.0; 4]).unwrap();
        for (place, band) in fit.pose_bands(&commanded).unwrap().into_iter().enumerate() {
            let outcome = operation.answer(&CommandedPose::at(commanded[place]));
            assert_eq!(outcome.status, Status::Converged);
            squares[place] += (outcome.pose.position - commanded[place].position).norm_squared() / RECORDS as f64;
            bands[place] += band.unwrap().position / RECORDS as f64;
        }
    }
    for place in 0..2 {
        let ratio = squares[place].sqrt() / bands[place];
        assert!((ratio - 1.0).abs() < 0.2, "{place}: {ratio} {bands:?}");
    }
    assert!(bands[1] > 1.5 * bands[0], "beyond the data the pose is less certain: {bands:?}");
}

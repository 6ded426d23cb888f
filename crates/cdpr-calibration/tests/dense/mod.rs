//! Anchor calibration as one dense least-squares problem, written without the library's models: the oracle of the
//! identification test and the baseline of its bench.
#![allow(dead_code, reason = "each test file uses its own part")]

use cdpr_model::geometry::Pose;
use cdpr_model::measurement::Samples;
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::Robot;
use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::Vector3;
use nalgebra_of_levenberg_marquardt::{DMatrix, DVector, Dyn, Owned};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The nominal CableRobot Simulator and 91 samples of a machine whose anchors are up to 10 mm elsewhere, lengths wrong by up
/// to 1 mm, poses in its box turned by up to 10° about each axis. No sensor accuracy is known: all lengths weigh the same.
pub(crate) fn problem() -> (Model, Samples) {
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    let mut vector = |size: f64| Vector3::from_fn(|_, _| rng.random_range(-size..size));
    let nominal = Robot::builtin("cablerobot-simulator-helicopter").expect("built in");
    let mut machine = nominal.clone();
    for cable in &mut machine.cables {
        cable.frame_anchor += vector(0.01);
        cable.platform_anchor += vector(0.01);
    }
    let machine = Model::new(machine, Composition::STANDARD).expect("a model");
    let poses: Vec<Pose> = (0..91)
        .map(|_| {
            let position = Vector3::new(0.0, 0.0, 1.6) + vector(1.5).component_mul(&Vector3::new(1.0, 1.0, 0.25));
            Pose::from_xyz_angles(position, vector(10.0_f64.to_radians()).into())
        })
        .collect();
    let mut lengths = Vec::new();
    for pose in &poses {
        let noise = (0..8).map(|_| vector(1e-3).x);
        lengths.extend(machine.cable_lengths(pose).expect("lengths").iter().zip(noise).map(|(length, x)| length + x));
    }
    let samples = Samples { poses, lengths, cable_count: 8, ..Samples::default() };
    (Model::new(nominal, Composition::STANDARD).expect("a model"), samples)
}

/// 48 unknowns, 728 rows: per cable the frame anchor, then the platform anchor.
pub(crate) struct Dense<'a> {
    pub(crate) samples: &'a Samples,
    pub(crate) parameters: DVector<f64>,
}

impl Dense<'_> {
    /// For every row: sample, cable, rotated platform anchor to outlet.
    fn rows(&self) -> impl Iterator<Item = (usize, usize, Vector3<f64>)> {
        let samples = self.samples;
        let anchor = |first: usize| Vector3::from_row_slice(&self.parameters.as_slice()[first..first + 3]);
        (0..samples.len() * 8).map(move |row| {
            let (sample, cable) = (row / 8, row % 8);
            let pose = &samples.poses[sample];
            (sample, cable, anchor(6 * cable) - pose.position - pose.rotation * anchor(6 * cable + 3))
        })
    }
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Dense<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, parameters: &DVector<f64>) {
        self.parameters.copy_from(parameters);
    }

    fn params(&self) -> DVector<f64> {
        self.parameters.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        let recorded = self.samples.lengths.iter();
        let residuals = self.rows().zip(recorded).map(|((_, _, cable), length)| cable.norm() - length);
        Some(DVector::from_iterator(self.samples.lengths.len(), residuals))
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        let mut jacobian = DMatrix::zeros(self.samples.lengths.len(), 48);
        for (row, (sample, cable, vector)) in self.rows().enumerate() {
            let direction = vector.normalize();
            let in_platform = self.samples.poses[sample].rotation.inverse() * direction;
            for k in 0..3 {
                jacobian[(row, 6 * cable + k)] = direction[k];
                jacobian[(row, 6 * cable + 3 + k)] = -in_platform[k];
            }
        }
        Some(jacobian)
    }
}

/// The 48 optimal components by a general library; panics when it does not converge.
pub(crate) fn solve(model: &Model, samples: &Samples, solver: LevenbergMarquardt<f64>) -> Vec<f64> {
    let cables = &model.robot().cables;
    let start = cables.iter().flat_map(|cable| cable.frame_anchor.iter().chain(cable.platform_anchor.iter()).copied());
    let parameters = DVector::from_iterator(48, start);
    let (optimum, report) = solver.minimize(Dense { samples, parameters });
    assert!(report.termination.was_successful(), "{:?}", report.termination);
    optimum.parameters.as_slice().to_vec()
}

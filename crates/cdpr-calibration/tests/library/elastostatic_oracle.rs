//! Elastostatic identification against the problem it stands for, solved whole: parameters, true poses and true tensions of
//! every sample as unknowns of one dense least-squares problem of a general library, written without the library's models.

use cdpr_calibration::Loss;
use cdpr_calibration::fit::{Prior, Settings, Status, fit};
use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::measurement::{Samples, SensorSigmas};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::{CableStiffness, ParameterKind, Robot};
use cdpr_model::statics::Load;
use cdpr_model::tension::{Limits, closed_form};
use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::{Vector3, Vector6};
use nalgebra_of_levenberg_marquardt::{DMatrix, DVector, Dyn, Owned};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

const SAMPLES: usize = 24;
const CABLES: usize = 8;
/// Anchors of frame and platform, compliances, wrench.
const PARAMETERS: usize = 3 * CABLES + 3 * CABLES + CABLES + 6;
const SIGMAS: SensorSigmas = SensorSigmas {
    position: Some(0.001),
    rotation: Some(0.001),
    length: Some(0.0005),
    tension: Some(50.0),
    swivel: None,
    length_scale: None,
    balance_force: None,
    balance_moment: None,
};
const PRIOR: f64 = 0.02;
/// What the balance of forces may miss (N, N·m): 1e-3 of what 50 N in each cable miss, so 1e-6 of their variance.
const BALANCE: f64 = 0.05;

/// Unknowns are counted in these units, so that all steps are of one size: mm, 1e-9/N, 10 N, mm or mrad, 10 N.
fn unit(unknown: usize) -> f64 {
    const ANCHORS: usize = 6 * CABLES;
    match unknown {
        0..ANCHORS => 1e-3,
        _ if unknown < ANCHORS + CABLES => 1e-9,
        _ if unknown < PARAMETERS => 10.0,
        _ if (unknown - PARAMETERS) % (6 + CABLES) < 6 => 1e-3,
        _ => 10.0,
    }
}

/// Balanced tensions between 1 and 9 kN at poses of the simulator's box, lengths by f = (q − q_θ)/(c q), everything with noise.
fn measured(machine: &Model) -> Samples {
    let mut rng = ChaCha8Rng::seed_from_u64(11);
    let load = Load::of(machine.robot()).unwrap();
    let mut samples = Samples { cable_count: CABLES, sigmas: SIGMAS, tensions: Some(Vec::new()), ..Samples::default() };
    while samples.len() < SAMPLES {
        let turn = [(); 3].map(|()| rng.random_range(-0.1..0.1));
        let position = Vector3::from_fn(|k, _| rng.random_range(-1.0..1.0) * [1.5, 1.5, 0.4][k] + [0.0, 0.0, 1.6][k]);
        let pose = Pose::from_xyz_angles(position, turn);
        let wanted: Vec<f64> = (0..CABLES).map(|_| rng.random_range(2000.0..6000.0)).collect();
        let near = Limits::new(wanted.clone(), wanted).unwrap();
        let structure_matrix = machine.structure_matrix(&pose).unwrap();
        let found = closed_form::solve(&structure_matrix, load.in_pattern(machine, &pose).as_slice(), &near).unwrap();
        if !found.tensions.iter().all(|f| (1000.0..9000.0).contains(f)) {
            continue;
        }
        let mut normal = |sigma: Option<f64>| -> f64 {
            let number: f64 = StandardNormal.sample(&mut rng);
            sigma.unwrap() * number
        };
        let lengths = machine.cable_lengths(&pose).unwrap();
        for (cable, &tension) in found.tensions.iter().enumerate() {
            let controlled = machine.elasticity(cable).controlled_length(lengths[cable], tension);
            samples.lengths.push(controlled + normal(SIGMAS.length));
            samples.tensions.as_mut().unwrap().push(tension + normal(SIGMAS.tension));
        }
        let twist = Twist::from_fn(|k, _| if k < 3 { normal(SIGMAS.position) } else { normal(SIGMAS.rotation) });
        samples.poses.push(pose.displaced(&twist));
    }
    samples
}

/// Everything unknown at once: parameters, then per sample the displacement of the pose and the tensions.
struct Whole<'a> {
    samples: &'a Samples,
    /// Platform anchors of the file (m).
    prior: Vec<f64>,
    unknowns: DVector<f64>,
}

impl Whole<'_> {
    fn value(&self, unknown: usize) -> f64 {
        self.unknowns[unknown] * unit(unknown)
    }

    fn vector(&self, first: usize) -> Vector3<f64> {
        Vector3::from_fn(|k, _| self.value(first + k))
    }

    /// In standard deviations: prior; per sample the corrections of pose and tensions, what is left of the balance, lengths.
    fn rows(&self) -> Vec<f64> {
        let mut rows: Vec<f64> =
            (0..3 * CABLES).map(|k| (self.value(3 * CABLES + k) - self.prior[k]) / PRIOR).collect();
        for sample in 0..SAMPLES {
            let first = PARAMETERS + sample * (6 + CABLES);
            let (shift, turn) = (self.vector(first), self.vector(first + 3));
            let twist = Twist::new(shift.x, shift.y, shift.z, turn.x, turn.y, turn.z);
            let pose = self.samples.poses[sample].displaced(&twist);
            rows.extend((0..3).map(|k| shift[k] / SIGMAS.position.unwrap()));
            rows.extend((0..3).map(|k| turn[k] / SIGMAS.rotation.unwrap()));
            let mut balance = Vector6::from_fn(|k, _| self.value(7 * CABLES + k));
            for cable in 0..CABLES {
                let tension = self.value(first + 6 + cable);
                let moment_arm = pose.rotation * self.vector(3 * CABLES + 3 * cable);
                let cable_vector = self.vector(3 * cable) - pose.position - moment_arm;
                let length = cable_vector.norm();
                let force = cable_vector * (tension / length);
                let moment = moment_arm.cross(&force);
                balance += Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z);
                let row = sample * CABLES + cable;
                rows.push((tension - self.samples.tensions.as_ref().unwrap()[row]) / SIGMAS.tension.unwrap());
                let controlled = length * (1.0 - tension * self.value(6 * CABLES + cable));
                rows.push((controlled - self.samples.lengths[row]) / SIGMAS.length.unwrap());
            }
            rows.extend(balance.iter().map(|rest| rest / BALANCE));
        }
        rows
    }
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Whole<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, unknowns: &DVector<f64>) {
        self.unknowns.copy_from(unknowns);
    }

    fn params(&self) -> DVector<f64> {
        self.unknowns.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        Some(DVector::from_vec(self.rows()))
    }

    /// Central differences: units are chosen so that a hundredth of one is small everywhere and far above rounding.
    fn jacobian(&self) -> Option<DMatrix<f64>> {
        const STEP: f64 = 0.01;
        let mut moved = Whole { samples: self.samples, prior: self.prior.clone(), unknowns: self.unknowns.clone() };
        let columns = (0..self.unknowns.len()).map(|unknown| {
            let mut at = |step: f64| {
                moved.unknowns[unknown] = self.unknowns[unknown] + step;
                DVector::from_vec(moved.rows())
            };
            let column = (at(STEP) - at(-STEP)) / (2.0 * STEP);
            moved.unknowns[unknown] = self.unknowns[unknown];
            column
        });
        Some(DMatrix::from_columns(&columns.collect::<Vec<_>>()))
    }
}

/// The file's robot as start: anchors, compliances, the wrench of its load.
fn start(robot: &Robot, samples: &Samples) -> DVector<f64> {
    let mut values: Vec<f64> = robot.cables.iter().flat_map(|cable| cable.frame_anchor.iter().copied()).collect();
    values.extend(robot.cables.iter().flat_map(|cable| cable.platform_anchor.iter().copied()));
    values.extend(robot.cables.iter().map(|cable| 1.0 / cable.axial_stiffness().unwrap()));
    values.extend(Load::of(robot).unwrap().constant_part().iter());
    for sample in 0..SAMPLES {
        values.extend([0.0; 6]);
        values.extend(&samples.tensions.as_ref().unwrap()[sample * CABLES..][..CABLES]);
    }
    DVector::from_iterator(values.len(), values.iter().enumerate().map(|(unknown, value)| value / unit(unknown)))
}

/// The inverse form eliminates poses and tensions by first-order covariances, corrected to where model and measurements agree
/// best. Both optima are then those of the same cost, but for the 1e-6 of the variance that the balance may miss here; measured
/// are 2e-6 standard deviations.
#[test]
fn the_inverse_form_finds_the_optimum_of_the_whole_problem() {
    let file = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    let mut machine = file.clone();
    for (k, cable) in machine.cables.iter_mut().enumerate() {
        let k = k as f64;
        cable.frame_anchor += Vector3::new(0.02 * k.sin(), 0.03 * k.cos(), -0.01 * (2.0 * k).sin());
        cable.platform_anchor += Vector3::new(0.01 * (3.0 * k).cos(), -0.01, 0.012 * k.cos());
        cable.stiffness =
            cable.axial_stiffness().map(|stiffness| CableStiffness::Axial(stiffness * (1.0 + 0.05 * k.sin())));
    }
    let samples = measured(&Model::new(machine, Composition::ELASTIC).unwrap());

    let free = "frame-anchor,platform-anchor,compliance,wrench".parse().unwrap();
    let settings = Settings {
        priors: vec![Prior { kind: ParameterKind::PlatformAnchor, sigma: PRIOR }],
        starts: 1,
        loss: Loss::Squared,
        ..Settings::default()
    };
    let found = fit(&Model::new(file.clone(), Composition::ELASTIC).unwrap(), &samples, &free, &settings).unwrap();
    assert_eq!(found.status, Status::Converged, "{}", found.reason);
    assert_eq!(found.parameters.len(), PARAMETERS);

    let prior = file.cables.iter().flat_map(|cable| cable.platform_anchor.iter().copied()).collect();
    let whole = Whole { samples: &samples, prior, unknowns: start(&file, &samples) };
    let (whole, report) = LevenbergMarquardt::new().with_patience(50).minimize(whole);
    assert!(report.termination.was_successful(), "{:?}", report.termination);
    // one cable after the other: anchors, compliance; then the wrench
    let expected = |estimate: &cdpr_calibration::fit::Estimate| {
        let parameter = &estimate.parameter;
        whole.value(match parameter.kind {
            ParameterKind::FrameAnchor => 3 * parameter.cable + parameter.axis,
            ParameterKind::PlatformAnchor => 3 * CABLES + 3 * parameter.cable + parameter.axis,
            ParameterKind::Compliance => 6 * CABLES + parameter.cable,
            _ => 7 * CABLES + parameter.axis,
        })
    };
    for estimate in &found.parameters {
        let difference = estimate.value - expected(estimate);
        let name = estimate.parameter.name(found.model.robot());
        let sigma = estimate.sigma.unwrap() / found.noise_factor;
        assert!(difference.abs() < 1e-4 * sigma, "{name}: {difference:e} of {sigma:e}");
    }
}

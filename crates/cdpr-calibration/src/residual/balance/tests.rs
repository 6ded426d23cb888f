//! Rows against dual numbers, and optima of exact data.

use nalgebra::{Const, DVector, SVector, Vector3};
use num_dual::DualVec;

use super::noise::{Noise, Sigmas};
use super::rows::{RowModel, SampleRows};
use crate::fit::{Estimate, Minimizer, Prior, Settings, Status, fit};
use crate::recorded::Recorded;
use crate::stopping::StoppingRule;
use cdpr_model::cable::elasticity::Elasticity;
use cdpr_model::cable::outlet;
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Samples, SensorSigmas};
use cdpr_model::model::{Composition, FreeParameters, Model, missing_effect};
use cdpr_model::robot::{CableStiffness, Parameter, ParameterKind, Robot, StiffnessBasis};
use cdpr_model::scalar::{add, cross, rotate};
use cdpr_model::statics::Load;

/// Derivatives by frame anchor, platform anchor, offset, scale, radius, compliance, hidden length, tension scale and offset, turns of the
/// swivel axis.
const PARAMETERS: usize = 15;
type Dual = DualVec<f64, Const<PARAMETERS>>;

fn variable(value: f64, index: usize) -> Dual {
    Dual::new(value, num_dual::Derivative::some(SVector::<f64, PARAMETERS>::ith(index, 1.0)))
}

/// The first cable of a robot with pulleys, every kind of parameter away from its neutral value.
fn odd_robot(basis: StiffnessBasis) -> Robot {
    let mut robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").expect("built in");
    for cable in &mut robot.cables {
        cable.set_pulley_swivel_axis(Vector3::new(0.1, -0.2, 0.9).normalize());
        cable.stiffness_by = Some(basis);
        cable.hidden_length = Some(3.0);
        cable.series_compliance = Some(1e-7);
        (cable.length_scale, cable.length_offset) = (Some(1.03), Some(-0.2));
        (cable.tension_scale, cable.tension_offset) = (Some(0.97), Some(40.0));
    }
    robot
}

fn pose() -> Pose {
    Pose::from_xyz_angles(Vector3::new(0.3, -0.2, 1.4), [0.05, -0.1, 0.08])
}

/// Rows of the first cable in dual numbers: \[u; b × u\] f and the recorded length.
fn dual_rows(robot: &Robot, pose: &Pose, recorded_tension: f64) -> [Dual; 7] {
    let cable = &robot.cables[0];
    let numbers = |v: Vector3<f64>, first: usize| [0, 1, 2].map(|k| variable(v[k], first + k));
    let moment_arm = rotate(&pose.rotation_rows().map(|row| row.map(Dual::from)), numbers(cable.platform_anchor, 3));
    let anchor = add([0, 1, 2].map(|k| Dual::from(pose.position[k])), moment_arm);
    // the axis' own derivatives have a test of their own
    let mut axis = cable.pulley_swivel_axis().unwrap().map(Dual::from);
    for turn in 0..2 {
        let parameter = Parameter { cable: 0, kind: ParameterKind::SwivelAxis, axis: turn };
        let (of, about) = parameter.turned_axis(robot).unwrap();
        axis += of.by_turn_about(&about).map(|slope| variable(0.0, 13 + turn) * slope);
    }
    let radius = variable(cable.pulley_radius().unwrap(), 8);
    let path = outlet::pulley::path(numbers(cable.frame_anchor, 0), axis.into(), radius, anchor);
    let tension = (Dual::from(recorded_tension) - variable(cable.tension_offset.unwrap(), 12))
        / variable(cable.tension_scale.unwrap(), 11);
    let specific = variable(1.0 / cable.axial_stiffness().unwrap(), 9);
    let constant = specific * variable(cable.hidden_length.unwrap(), 10) + cable.series_compliance.unwrap();
    let zero = Dual::from(0.0);
    let law = match cable.stiffness_by {
        Some(StiffnessBasis::Unstrained) => Elasticity { by_length: zero, by_controlled_length: specific, constant },
        _ => Elasticity { by_length: specific, by_controlled_length: zero, constant },
    };
    let controlled = law.controlled_length(path.length, tension);
    let length = variable(cable.length_scale.unwrap(), 7) * controlled + variable(cable.length_offset.unwrap(), 6);
    let moment = cross(moment_arm, path.direction);
    let u = path.direction;
    [
        u[0] * tension,
        u[1] * tension,
        u[2] * tension,
        moment[0] * tension,
        moment[1] * tension,
        moment[2] * tension,
        length,
    ]
}

#[test]
fn the_rows_derivatives_agree_with_dual_numbers() {
    for basis in [StiffnessBasis::Actual, StiffnessBasis::Unstrained] {
        let mut robot = odd_robot(basis);
        for (axis, turn) in [(0, 0.2), (1, -0.3)] {
            Parameter { cable: 0, kind: ParameterKind::SwivelAxis, axis }.set(&mut robot, turn);
        }
        let model = Model::new(robot.clone(), Composition::PULLEY_ELASTIC).unwrap();
        let is_there = |kind: &ParameterKind| missing_effect(*kind, Composition::PULLEY_ELASTIC).is_none();
        let of_lengths = |kind: &ParameterKind| !kind.needs_motor_angles() && !kind.needs_swivels();
        let is_weight = |kind: &ParameterKind| matches!(kind, ParameterKind::Mass | ParameterKind::CenterOfMass);
        let is_asked = |kind: &ParameterKind| is_there(kind) && of_lengths(kind) && !is_weight(kind);
        let kinds = ParameterKind::IDENTIFIED.into_iter().filter(is_asked);
        let kinds: Vec<_> = kinds.collect();
        let free = FreeParameters::of(&kinds);
        let parameters = free.parameters(&model, &FreeParameters::default()).unwrap();
        let mut rows = SampleRows::new(&model, parameters.len());
        let tensions = [3000.0; 8];
        let load = Load::of(&robot).unwrap();
        RowModel::new(&model, load, &parameters).write(&pose(), &tensions, Recorded::lengths(&[8.0; 8]), &mut rows);
        let expected = dual_rows(&robot, &pose(), tensions[0]);
        for (column, Parameter { kind, axis, .. }) in parameters.iter().take(PARAMETERS).enumerate() {
            let place = match kind {
                ParameterKind::FrameAnchor => *axis,
                ParameterKind::PlatformAnchor => 3 + axis,
                ParameterKind::LengthOffset => 6,
                ParameterKind::LengthScale => 7,
                ParameterKind::PulleyRadius => 8,
                ParameterKind::SwivelAxis => 13 + axis,
                ParameterKind::Compliance => 9,
                ParameterKind::HiddenLength => 10,
                ParameterKind::TensionScale => 11,
                _ => 12,
            };
            for (row, dual) in expected.iter().enumerate() {
                let exact = dual.eps.unwrap_generic(Const, Const::<1>)[place];
                let found = rows.entries[row * rows.stride + column];
                // rounding, relative to the size of the entry; exact zeros may be rounding of terms that cancel
                assert!(
                    (found - exact).abs() <= 1e-11 * exact.abs().max(1.0),
                    "{kind} {axis} row {row}: {found} {exact}"
                );
            }
        }
    }
}

/// Poses, tensions and lengths that contradict nothing: tensions balance the load, lengths follow from them.
fn exact_samples(machine: &Model, count: usize) -> Samples {
    let load = Load::of(machine.robot()).unwrap();
    let mut samples = Samples { cable_count: machine.cable_count(), ..Samples::default() };
    let mut tensions = Vec::new();
    for index in 0..count {
        let t = index as f64;
        let position = Vector3::new(1.3 * (1.7 * t).sin(), 1.2 * (2.3 * t).cos(), 1.6 + 0.4 * (0.9 * t).sin());
        let turns = [0.06 * (1.1 * t).cos(), 0.07 * (0.7 * t).sin(), 0.05 * (3.1 * t).sin()];
        let pose = Pose::from_xyz_angles(position, turns);
        let structure = machine.structure_matrix(&pose).unwrap();
        // another level of tension at every pose tells the stiffness
        let middle = DVector::from_fn(8, |cable, _| 3500.0 + 1500.0 * (t + 1.3 * cable as f64).sin());
        let missing = &structure * &middle + load.in_pattern(machine, &pose);
        let tension = &middle - structure.pseudo_inverse(1e-12).unwrap() * missing;
        for cable in 0..8 {
            let length = machine.path(cable, &pose).unwrap().0.length;
            let controlled = machine.elasticity(cable).controlled_length(length, tension[cable]);
            samples.lengths.push(machine.recorded_length(cable, controlled));
            tensions.push(machine.recorded_tension(cable, tension[cable]));
        }
        samples.poses.push(pose);
    }
    samples.tensions = Some(tensions);
    samples.sigmas = SensorSigmas {
        position: Some(1e-3),
        rotation: Some(1e-3),
        length: Some(2e-4),
        tension: Some(50.0),
        swivel: None,
        length_scale: None,
        balance_force: None,
        balance_moment: None,
    };
    samples
}

/// 62 parameters of exact data come back whatever the start.
#[test]
fn exact_data_give_the_true_parameters_back_from_every_start() {
    let truth = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    let machine = Model::new(truth.clone(), Composition::ELASTIC).unwrap();
    let samples = exact_samples(&machine, 60);
    let mut start = Robot::builtin("cablerobot-simulator-helicopter").unwrap();
    start.cables.iter_mut().zip(&truth.cables).for_each(|(cable, true_cable)| {
        cable.stiffness = Some(CableStiffness::Axial(2e6));
        // the anchors' common shift is weak: only a prior at the true place makes the truth the optimum
        cable.platform_anchor = true_cable.platform_anchor;
    });
    let model = Model::new(start, Composition::ELASTIC).unwrap();
    let free: FreeParameters = "frame-anchor,platform-anchor,compliance,wrench".parse().unwrap();
    let settings = Settings {
        priors: vec![Prior { kind: ParameterKind::PlatformAnchor, sigma: 0.02 }],
        starts: 10,
        ..Settings::default()
    };
    let found = fit(&model, &samples, &free, &settings).unwrap();
    assert_eq!((found.status, found.parameters.len()), (Status::Converged, 62), "{}", found.reason);
    assert_eq!((found.starts.optima.len(), found.starts.optima[0].starts), (1, 10), "{:?}", found.starts);
    for (cable, true_cable) in found.model.robot().cables.iter().zip(&truth.cables) {
        // the data are exact: only the tolerance of the fit is left
        assert!((cable.frame_anchor - true_cable.frame_anchor).norm() < 1e-6, "{}", cable.name);
        let ratio = cable.axial_compliance().unwrap() * true_cable.axial_stiffness().unwrap();
        assert!((ratio - 1.0).abs() < 1e-4, "cable {}: {ratio}", cable.name);
    }
    let wrench = found.model.robot().external_wrench.as_ref().unwrap().wrench;
    assert!((wrench - truth.external_wrench.unwrap().wrench).amax() < 1e-2, "{wrench}");
}

#[test]
fn tensions_that_push_are_refused_with_their_rows() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    let mut samples = exact_samples(&model, 12);
    samples.tensions.as_mut().unwrap()[3 * 8 + 4] = -900.0;
    let error = fit(&model, &samples, &"compliance".parse().unwrap(), &Settings::default()).unwrap_err().to_string();
    assert!(error.contains("cable 5") && error.contains("sample 4") && error.contains("-900"), "{error}");
    samples.tensions = None;
    let error = fit(&model, &samples, &"compliance".parse().unwrap(), &Settings::default()).unwrap_err().to_string();
    assert!(error.contains("tension_N_1"), "{error}");
}

/// Rows of cables without a closed form: every column against the rows of the robot with that parameter changed.
#[test]
fn the_rows_of_any_composition_are_the_differences_of_changed_robots() {
    let mut robot = odd_robot(StiffnessBasis::Unstrained);
    for cable in &mut robot.cables {
        cable.linear_density = Some(0.8);
        cable.stiffness = cable.specific_compliance().map(CableStiffness::Compliance);
        cable.tension_of_strain = Some(vec![2e6, 2e8]);
    }
    let mut weighed = Robot { external_wrench: None, ..robot.clone() };
    (weighed.platform.mass, weighed.platform.center_of_mass) = (Some(500.0), Some(Vector3::new(0.05, -0.1, 0.2)));
    let kinds = "frame-anchor,platform-anchor,length-offset,length-scale,pulley-radius,tension-scale,tension-offset";
    for (words, more, robot) in [
        ("pulley+elastic+catenary", ",compliance,hidden-length,linear-density,wrench", &robot),
        ("pulley+elastic+finite-element", ",compliance,hidden-length,linear-density,mass,center-of-mass", &weighed),
        ("pulley+catenary", ",linear-density,mass,center-of-mass", &weighed),
        ("pulley+elastic", ",compliance,mass,center-of-mass", &weighed),
        ("pulley+polynomial", ",hidden-length,wrench", &robot),
        ("pulley+polynomial+catenary", ",hidden-length,linear-density,wrench", &robot),
    ] {
        let composition: Composition = words.parse().expect("a composition");
        let free: FreeParameters = format!("{kinds}{more}").parse().expect("parameters");
        let model = Model::new(robot.clone(), composition).expect("everything an effect needs");
        let parameters = free.parameters(&model, &FreeParameters::default()).expect("of this model");
        let tensions = [2000.0, 1500.0, 2500.0, 3000.0, 900.0, 1200.0, 1800.0, 2200.0];
        let write = |model: &Model, pose: &Pose, tensions: &[f64]| {
            let mut rows = SampleRows::new(model, parameters.len());
            let load = Load::of(model.robot()).expect("the file states it");
            RowModel::new(model, load, &parameters).write(pose, tensions, Recorded::lengths(&[8.0; 8]), &mut rows);
            rows
        };
        let rows = write(&model, &pose(), &tensions);
        for (column, parameter) in parameters.iter().enumerate() {
            let h = if parameter.kind == ParameterKind::Compliance { 1e-11 } else { 1e-6 };
            let changed = |step: f64| {
                let mut robot = robot.clone();
                parameter.set(&mut robot, parameter.value(model.robot()) + step);
                write(&Model::new(robot, composition).expect("a small change"), &pose(), &tensions)
            };
            let (ahead, behind) = (changed(h), changed(-h));
            for row in 0..rows.count {
                let slope = (ahead.residual(row) - behind.residual(row)) / (2.0 * h);
                let found = rows.entries[row * rows.stride + column];
                // rounding of forces of 3000 N and lengths of 10 m over the step, truncation beside
                let tolerance = if row < 6 { 1e-12 * 3e3 * 10.0 } else { 1e-14 * 10.0 } / h + 1e-6 * found.abs();
                assert!((slope - found).abs() < tolerance, "{words} {parameter:?} row {row}: {slope} {found}");
            }
        }
    }
}

/// Ten poses, errors in tensions and lengths, and a prior that matters: where no accuracy is stated, the answer is that of the
/// assumed ones times the noise factor.
#[test]
fn unknown_accuracies_give_the_answer_of_the_assumed_ones_times_the_noise_factor() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    let mut samples = exact_samples(&model, 10);
    samples.lengths.iter_mut().enumerate().for_each(|(index, length)| *length += 4e-3 * (1.3 * index as f64).sin());
    let tensions = samples.tensions.as_mut().unwrap();
    tensions.iter_mut().enumerate().for_each(|(index, tension)| *tension += 120.0 * (1.7 * index as f64).cos());
    let mean = tensions.iter().sum::<f64>() / tensions.len() as f64;
    let free: FreeParameters = "frame-anchor,platform-anchor,compliance,wrench".parse().unwrap();
    let fitted = |sigmas: SensorSigmas, prior: f64| {
        let priors =
            [ParameterKind::PlatformAnchor, ParameterKind::FrameAnchor].map(|kind| Prior { kind, sigma: prior });
        let settings = Settings { priors: priors.to_vec(), ..Settings::default() };
        fit(&model, &Samples { sigmas, ..samples.clone() }, &free, &settings).unwrap()
    };
    let unknown = fitted(SensorSigmas::default(), 0.003);
    assert!((1.5..10.0).contains(&unknown.noise_factor), "{}", unknown.noise_factor);
    let noise = unknown.noise_factor;
    let sigmas =
        SensorSigmas { length: Some(1e-3 * noise), tension: Some(0.01 * mean * noise), ..SensorSigmas::default() };
    let stated = fitted(sigmas, 0.003);
    assert!((stated.noise_factor - 1.0).abs() < 1e-4, "{}", stated.noise_factor);
    for (unknown, stated) in unknown.parameters.iter().zip(&stated.parameters) {
        // descents stop where the next step promises no more than 1e-7 of the cost: some thousandths of a deviation
        let (difference, sigma) = ((unknown.value - stated.value).abs(), stated.sigma.unwrap());
        assert!(difference < 1e-2 * sigma, "{}: {} {} ± {sigma}", stated.name, unknown.value, stated.value);
        assert!((unknown.sigma.unwrap() / sigma - 1.0).abs() < 1e-3, "{}: {:?} {sigma}", stated.name, unknown.sigma);
    }
    // a prior of a nanometre holds
    let anchors = fitted(SensorSigmas::default(), 1e-9);
    for estimate in anchors.parameters.iter().filter(|estimate| estimate.parameter.kind.is_anchor()) {
        assert!(estimate.change.abs() < 1e-8, "{}: {}", estimate.name, estimate.change);
    }
    assert!((1.0..20.0).contains(&anchors.noise_factor), "{}", anchors.noise_factor);
}

/// Only one accuracy is stated: what stands for the other is said.
#[test]
fn accuracies_that_are_assumed_beside_stated_ones_are_told() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    let samples = exact_samples(&model, 12);
    let warnings = |sigmas: SensorSigmas| {
        let free = "compliance".parse().unwrap();
        fit(&model, &Samples { sigmas, ..samples.clone() }, &free, &Settings::default()).unwrap().warnings.join("\n")
    };
    let of_tension = warnings(SensorSigmas { tension: Some(50.0), ..SensorSigmas::default() });
    assert!(of_tension.contains("lengths are assumed to be known to 1 mm"), "{of_tension}");
    let of_length = warnings(SensorSigmas { length: Some(2e-4), ..SensorSigmas::default() });
    assert!(of_length.contains("tensions are assumed to be known to 1 % of their mean"), "{of_length}");
    assert!(!warnings(samples.sigmas).contains("assumed"), "all are stated");
}

/// A length row of a slack cable says nothing, and does not count as a row.
#[test]
fn slack_cables_give_no_rows() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    let load = Load::of(model.robot()).unwrap();
    let sigmas = Sigmas { position: 1e-3, rotation: 1e-3, length: 2e-4, tension: 50.0, slack: 200.0 };
    let mut noise = Noise::new(&model);
    let mut rows_at = |tensions: [f64; 8]| {
        RowModel::new(&model, load, &[]).noise(&pose(), &tensions, &sigmas, &mut noise);
        noise.informative_rows()
    };
    assert_eq!(rows_at([3000.0; 8]), 6 + 8);
    // below four standard deviations of the force sensor
    assert_eq!(rows_at([3000.0, 10.0, 3000.0, 150.0, 3000.0, 3000.0, 3000.0, 3000.0]), 6 + 6);
}

/// The noise factor is the root of the cost over rows and priors less parameters.
#[test]
fn priors_count_as_rows() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    let mut samples = exact_samples(&model, 5);
    samples.lengths.iter_mut().enumerate().for_each(|(index, length)| *length += 1e-3 * (1.3 * index as f64).sin());
    let prior = Prior { kind: ParameterKind::LengthOffset, sigma: 1e-3 };
    let settings = Settings { priors: vec![prior], ..Settings::default() };
    let found = fit(&model, &samples, &"length-offset".parse().unwrap(), &settings).unwrap();
    let freedom = found.history.last().unwrap() / found.noise_factor.powi(2);
    // 5 × (6 + 8) rows, 8 priors, 8 parameters
    assert!((freedom - 70.0).abs() < 1e-9 * 70.0, "{freedom}");
}

/// Each way ends at the same optimum of data with errors, at which one cable seems stiffer than rigid.
#[test]
fn every_minimizer_ends_at_the_same_cost() {
    let truth = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    let machine = Model::new(truth, Composition::ELASTIC).unwrap();
    let mut samples = exact_samples(&machine, 40);
    samples.lengths.iter_mut().enumerate().for_each(|(index, length)| *length += 2e-4 * (1.3 * index as f64).sin());
    let mut start = Robot::builtin("cablerobot-simulator-helicopter").unwrap();
    start.cables.iter_mut().for_each(|cable| cable.stiffness = Some(CableStiffness::Axial(2e6)));
    let model = Model::new(start, Composition::ELASTIC).unwrap();
    let free: FreeParameters = "frame-anchor,compliance".parse().unwrap();
    let found = |minimizer| {
        let settings = Settings { minimizer, ..Settings::default() };
        let found = fit(&model, &samples, &free, &settings).unwrap();
        assert_eq!(found.status, Status::Converged, "{minimizer:?}: {}", found.reason);
        let stopped = found.stopped_by;
        assert!(stopped.rule < StoppingRule::IterationLimit && stopped.value <= stopped.limit, "{stopped:?}");
        let is_inside = |e: &Estimate| e.value >= e.parameter.bounds().0 && e.value <= e.parameter.bounds().1;
        assert!(found.parameters.iter().all(is_inside), "{minimizer:?}");
        found
    };
    let reference = found(Minimizer::LevenbergMarquardt);
    assert_eq!(reference.at_bound().count(), 1);
    for minimizer in [Minimizer::GaussNewton, Minimizer::Dogleg, Minimizer::TrustRegion] {
        let other = found(minimizer);
        let ratio = other.noise_factor / reference.noise_factor;
        assert!((ratio - 1.0).abs() < 1e-10, "{minimizer:?}: {ratio}");
    }
}

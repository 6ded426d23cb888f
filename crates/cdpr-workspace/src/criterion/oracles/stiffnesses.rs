//! Stiffness, stability, vibrations and conditioning against differences and decompositions of other kinds.

use nalgebra::{DMatrix, Matrix3};

use super::*;
use cdpr_model::equilibrium::distribution;
use cdpr_model::robot::CableStiffness;
use cdpr_model::statics::{controlled_lengths, wrench_residual};

/// −∂(Aᵀ f + w)/∂x at fixed controlled lengths by central differences, \[δr; δφ\].
fn stiffness_by_differences(model: &Model, pose: &Pose, load: &Load, limits: &Limits) -> Option<DMatrix<f64>> {
    let found = distribution::solve(model, pose, load, limits).unwrap();
    if found.reason.is_some() {
        return None;
    }
    let controlled = controlled_lengths(model, pose, &found.tensions).unwrap();
    let residual = |pose: &Pose| {
        let tensions: Vec<f64> = (0..model.cable_count())
            .map(|cable| {
                let length = model.path(cable, pose).unwrap().0.length;
                model.elasticity(cable).tension(length, controlled[cable]).value
            })
            .collect();
        wrench_residual(model, pose, &tensions, load).unwrap()
    };
    let h = 1e-6; // truncation ~ h² · 1e5 N/m³, rounding ~ 1e4 N · ε/h
    let mut stiffness = DMatrix::zeros(model.dof(), model.dof());
    for (column, twist) in model.twist_basis().iter().enumerate() {
        let slope = (residual(&pose.displaced(&(twist * h))) - residual(&pose.displaced(&(twist * -h)))) / (2.0 * h);
        stiffness.set_column(column, &-slope);
    }
    Some(stiffness)
}

#[test]
fn the_softest_direction_is_that_of_small_differences() {
    for model in models() {
        let (load, limits) = (Load::of(model.robot()).unwrap(), Limits::of(model.robot(), None, None).unwrap());
        let scale = 0.7;
        let criterion = MinimumStiffness::new(&model, &load, &limits, 1000.0, Some(scale)).unwrap();
        let stable = StaticStability::new(&model, &load, &limits, Some(scale)).unwrap();
        let mut compared = 0;
        for pose in poses(&model, 30, 0.5, 97) {
            let verdict = criterion.judge(&pose);
            let Some(stiffness) = stiffness_by_differences(&model, &pose, &load, &limits) else {
                assert_eq!(verdict.margin, f64::NEG_INFINITY);
                assert!(verdict.reason.unwrap().contains("no tensions hold the load"));
                continue;
            };
            let translations = model.robot().motion_pattern.translations();
            let part = |row: usize| if row < translations { 1.0 } else { 1.0 / scale };
            let symmetric = (&stiffness + stiffness.transpose()) * 0.5;
            let scaled = DMatrix::from_fn(model.dof(), model.dof(), |i, j| symmetric[(i, j)] * part(i) * part(j));
            let least = scaled.clone().symmetric_eigenvalues().min();
            // differences of 1e5 N/m are accurate to about 1e-3 N/m
            let tolerance = 1e-6 * scaled.amax();
            assert!((verdict.margin + 1000.0 - least).abs() < tolerance, "{}: {verdict:?} {least}", model.robot().name);
            assert!((stable.judge(&pose).margin - least).abs() < tolerance);
            compared += 1;
        }
        assert!(compared > 0, "{}: no tensions at any pose", model.robot().name);
    }
}

/// A weight far above the platform tips it over; one far below does not. Stability does not depend on the length scale.
#[test]
fn a_weight_above_the_platform_makes_it_unstable() {
    let verdict = |height: f64, scale: f64| {
        let mut robot = complete("cogiro");
        robot.platform.center_of_mass = Some(Vector3::new(0.0, 0.0, height));
        robot.cables.iter_mut().for_each(|cable| cable.tension_max = Some(1e6));
        let model = Model::new(robot, Composition::ELASTIC).unwrap();
        let (load, limits) = (Load::of(model.robot()).unwrap(), Limits::of(model.robot(), Some(0.0), None).unwrap());
        let vibrations = NaturalFrequency::new(&model, &load, &limits, 0.0).unwrap();
        let home = model.robot().home_or_middle();
        let verdict = StaticStability::new(&model, &load, &limits, Some(scale)).unwrap().judge(&home);
        assert_eq!(vibrations.holds(&home), verdict.holds());
        verdict
    };
    // 100 kg · 9.81 m/s² · 1 km exceeds the stiffness of springs of 2e5 N/8 m at half a metre
    for scale in [0.1, 1.0, 10.0] {
        assert!(verdict(-1.0, scale).holds());
        let tipped = verdict(1000.0, scale);
        assert!(!tipped.holds() && tipped.reason.unwrap().contains("about"), "{scale}");
    }
}

/// A point on two pairs of springs: ω² = 4 k cos²/m along the axes of a square, computed by hand.
#[test]
fn the_frequency_of_a_point_on_springs_is_that_done_by_hand() {
    let mut robot = complete("planar-example");
    let plane = robot.plane;
    for (cable, corner) in robot.cables.iter_mut().zip([[-3.0, 4.0], [3.0, 4.0], [-3.0, -4.0], [3.0, -4.0]]) {
        cable.frame_anchor = plane.embed(corner);
        cable.platform_anchor = Vector3::zeros();
        cable.stiffness = Some(CableStiffness::Spring(1e4));
    }
    robot.gravity = Some(Vector3::zeros());
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    // without tension only the springs act: 4 · 1e4 N/m · 0.6² across
    let limits = Limits::uniform(4, 1e-9, 1e-9).unwrap();
    let load = Load::constant(Twist::zeros());
    let criterion = NaturalFrequency::new(&model, &load, &limits, 2.0).unwrap();
    let verdict = criterion.judge(&Pose::identity());
    let expected = (4.0 * 1e4 * 0.36_f64 / 100.0).sqrt() / std::f64::consts::TAU - 2.0;
    assert!((verdict.margin - expected).abs() < 1e-9, "{verdict:?} {expected}");
    assert!(verdict.reason.unwrap().contains("along x, at least 2 Hz") || expected < 0.0);
}

/// det(K − ω² M) = 0 with M written about the centre of mass, where it has diagonal blocks, and shifted by Steiner's
/// theorem through the velocity of that centre.
#[test]
fn the_lowest_frequency_solves_the_characteristic_equation() {
    let mut robot = complete("cogiro");
    robot.platform.center_of_mass = Some(Vector3::new(0.1, -0.2, 0.3));
    robot.platform.inertia = Some(Matrix3::new(20.0, 1.0, 2.0, 1.0, 25.0, -3.0, 2.0, -3.0, 30.0));
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    let (load, limits) = (Load::of(model.robot()).unwrap(), Limits::of(model.robot(), None, None).unwrap());
    let criterion = NaturalFrequency::new(&model, &load, &limits, 0.0).unwrap();
    let mut compared = 0;
    for pose in poses(&model, 20, 1.0, 98) {
        let Some(stiffness) = stiffness_by_differences(&model, &pose, &load, &limits) else { continue };
        let symmetric = (&stiffness + stiffness.transpose()) * 0.5;
        let (rotation, moment_arm) =
            (pose.rotation_matrix(), pose.rotation * model.robot().platform.center_of_mass.unwrap());
        let inertia = rotation * model.robot().platform.inertia.unwrap() * rotation.transpose();
        // kinetic energy ½ m (v + ω × c)² + ½ ωᵀ I ω
        let energy = |x: &[f64], y: &[f64]| {
            let point = |x: &[f64]| {
                Vector3::from_column_slice(&x[..3]) + Vector3::from_column_slice(&x[3..]).cross(&moment_arm)
            };
            let (o, p) = (Vector3::from_column_slice(&x[3..]), Vector3::from_column_slice(&y[3..]));
            100.0 * point(x).dot(&point(y)) + o.dot(&(inertia * p))
        };
        let unit = |k: usize| (0..6).map(|row| f64::from(row == k)).collect::<Vec<f64>>();
        let mass = DMatrix::from_fn(6, 6, |i, j| energy(&unit(i), &unit(j)));
        let square = (criterion.judge(&pose).margin * std::f64::consts::TAU).powi(2);
        let values = (mass.clone().try_inverse().unwrap() * &symmetric).complex_eigenvalues();
        let least = values.iter().map(|value| value.re).fold(f64::INFINITY, f64::min);
        assert!((square - least).abs() < 1e-5 * least.abs(), "{square} {least}");
        compared += 1;
    }
    assert!(compared > 3);
}

#[test]
fn condition_and_dexterity_are_ratios_of_singular_values() {
    for model in models() {
        let radius = model.platform_radius();
        let condition = JacobianConditioning::new(&model, 3.0, None).unwrap();
        let dexterity = Dexterity::new(&model, 1.0 / 3.0, Some(radius)).unwrap();
        for pose in poses(&model, 30, 1.0, 99) {
            let mut matrix = model.structure_matrix(&pose).unwrap();
            for row in model.robot().motion_pattern.translations()..model.dof() {
                matrix.row_mut(row).scale_mut(1.0 / radius);
            }
            let squares = (&matrix * matrix.transpose()).symmetric_eigenvalues();
            let ratio = (squares.max() / squares.min()).sqrt();
            // squares halve the accurate digits
            assert!((condition.judge(&pose).margin - (3.0 - ratio)).abs() < 1e-6 * ratio.powi(2));
            assert!((dexterity.judge(&pose).margin - (1.0 / ratio - 1.0 / 3.0)).abs() < 1e-6);
            assert_eq!(condition.holds(&pose), dexterity.holds(&pose));
        }
    }
    let mut few = complete("cogiro");
    few.cables.truncate(5);
    let few = Model::new(few, Composition::STANDARD).unwrap();
    let verdict = Dexterity::new(&few, 0.1, None).unwrap().judge(&few.robot().home_or_middle());
    assert!((verdict.margin + 0.1).abs() < 1e-12, "five cables leave a direction: {verdict:?}");
}

/// The same robot twice as large, with the length scale twice as large, has the same condition.
#[test]
fn condition_and_dexterity_do_not_depend_on_the_size_of_the_robot() {
    let small = model("cablerobot-simulator-helicopter", Composition::STANDARD);
    let mut robot = small.robot().clone();
    for cable in &mut robot.cables {
        cable.frame_anchor *= 2.0;
        cable.platform_anchor *= 2.0;
    }
    let large = Model::new(robot, Composition::STANDARD).unwrap();
    for pose in poses(&small, 20, 1.0, 100) {
        let twice = Pose { position: pose.position * 2.0, ..pose };
        let (a, b) = (Dexterity::new(&small, 0.2, None).unwrap(), Dexterity::new(&large, 0.2, None).unwrap());
        assert!((a.judge(&pose).margin - b.judge(&twice).margin).abs() < 1e-12);
    }
}

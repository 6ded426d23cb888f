//! Derivatives against dual numbers, finite differences and solves of the balance.

use nalgebra::{Const, DMatrix, DVector, SVector, Vector3};
use num_dual::DualVec;

use super::*;
use crate::cable::elasticity::Elasticity;
use crate::cable::{CablePath, outlet};
use crate::geometry::Wrench;
use crate::scalar::{add, cross, rotate};

/// Derivatives by [δr; δφ] and one controlled length.
type Dual = DualVec<f64, Const<7>>;

fn variable(value: f64, index: usize) -> Dual {
    Dual::new(value, num_dual::Derivative::some(SVector::<f64, 7>::ith(index, 1.0)))
}

/// Column of Aᵀ times tension in dual numbers of the pose and of the cable's controlled length.
fn dual_force(model: &Model, index: usize, pose: &Pose, controlled: f64) -> [Dual; 6] {
    let cable = &model.robot().cables[index];
    let constants = |v: Vector3<f64>| [0, 1, 2].map(|k| Dual::from(v[k]));
    let turn = [0, 1, 2].map(|k| variable(0.0, 3 + k));
    let stored: [Dual; 3] =
        rotate(&pose.rotation_rows().map(|row| row.map(Dual::from)), constants(cable.platform_anchor));
    let moment_arm = add(stored, cross(turn, stored));
    let anchor = add([0, 1, 2].map(|k| variable(pose.position[k], k)), moment_arm);
    let path: CablePath<Dual> = match model.composition().pulley {
        true => outlet::pulley::path(
            constants(cable.frame_anchor),
            constants(cable.pulley_swivel_axis().expect("has a pulley")),
            Dual::from(cable.pulley_radius().expect("has a pulley")),
            anchor,
        ),
        false => outlet::point::path(constants(cable.frame_anchor), anchor),
    };
    let law = model.elasticity(index);
    let dual_law = Elasticity {
        by_length: law.by_length.into(),
        by_controlled_length: law.by_controlled_length.into(),
        constant: law.constant.into(),
    };
    let tension = dual_law.tension(path.length, variable(controlled, 6)).value;
    let u = path.direction;
    let moment = cross(moment_arm, u);
    [u[0], u[1], u[2], moment[0], moment[1], moment[2]].map(|x| x * tension)
}

/// All of K_wx and K_wq from one differentiation of the balance itself, without any of the formulas under test.
#[test]
fn stiffness_is_minus_the_derivative_of_the_balance_in_dual_numbers() {
    for composition in [Composition::ELASTIC, Composition::PULLEY_ELASTIC] {
        let (model, pose, tensions, load) = of(composition);
        let stiffness = Stiffness::at(&model, &pose, &tensions, &load).unwrap();
        let mut by_pose = DMatrix::from_iterator(6, 6, load.gradient(&pose).iter().copied());
        for cable in 0..8 {
            let force = dual_force(&model, cable, &pose, stiffness.controlled_lengths[cable]);
            for (row, component) in force.iter().enumerate() {
                let gradient = component.eps.unwrap_generic(Const, Const::<1>);
                (0..6).for_each(|axis| by_pose[(row, axis)] += gradient[axis]);
                // rounding of entries of up to 1e5
                assert!((stiffness.by_controlled_length[(row, cable)] + gradient[6]).abs() < 1e-8);
            }
        }
        assert!((&stiffness.system + by_pose).amax() < 1e-8, "{composition}");
    }
}

/// −∂(Aᵀ f + w)/∂x by central differences on the manifold.
fn numeric_stiffness(model: &Model, pose: &Pose, controlled: &[f64], load: &Load) -> DMatrix<f64> {
    let h = 1e-5; // truncation ~ h² · 1e5 N/m³, rounding ~ 1e4 N · ε/h
    let columns: Vec<DVector<f64>> = model
        .twist_basis()
        .iter()
        .map(|twist| {
            let at = |step: f64| residual(model, &pose.displaced(&(twist * step)), controlled, load);
            (at(-h) - at(h)) / (2.0 * h)
        })
        .collect();
    DMatrix::from_columns(&columns)
}

#[test]
fn stiffness_is_that_of_finite_differences() {
    for composition in [Composition::ELASTIC, Composition::PULLEY_ELASTIC] {
        let (model, pose, tensions, load) = of(composition);
        let stiffness = Stiffness::at(&model, &pose, &tensions, &load).unwrap();
        let numeric = numeric_stiffness(&model, &pose, &stiffness.controlled_lengths, &load);
        assert!((&stiffness.system - &numeric).amax() < 1e-4, "{composition}: {}", &stiffness.system - numeric);
    }
}

/// Each sign that the dissertation prints otherwise changes the matrix by thousands of times the remaining difference.
#[test]
fn misprinted_signs_fail_finite_differences() {
    let (model, pose, tensions, load) = of(Composition::ELASTIC);
    let k = Stiffness::at(&model, &pose, &tensions, &load).unwrap();
    let numeric = numeric_stiffness(&model, &pose, &k.controlled_lengths, &load);
    let misprints = [
        ("2.71, surplus minus of ∂f/∂q", -&k.cable - &k.geometric - &k.load),
        ("2.76 and 2.78, both signs of K_wx", &k.geometric - &k.cable - &k.load),
        ("2.82, the sum of K_G and K_C", &k.cable + &k.geometric - &k.load),
        ("the load's gradient with the other sign", &k.cable - &k.geometric + &k.load),
    ];
    for (name, matrix) in misprints {
        assert!((matrix - &numeric).amax() > 10.0, "{name}");
    }
    // eq. 2.69: ∂b/∂x with the printed sign, which subtracts twice the part of the moment arm
    let mut lever_part = DMatrix::<f64>::zeros(6, 6);
    for cable in 0..8 {
        let (path, moment_arm) = model.path(cable, &pose).unwrap();
        let u = Vector3::from(path.direction);
        let part = u.cross_matrix() * moment_arm.cross_matrix() * tensions[cable];
        let mut corner = lever_part.view_mut((3, 3), (3, 3));
        corner += part;
    }
    assert!((&k.system - &lever_part * 2.0 - &numeric).amax() > 10.0);
    assert!((&k.system + &lever_part * 2.0 - &numeric).amax() > 10.0);
}

/// δx = K_wx⁻¹ (δw − K_wq δq_θ): a Newton solve of the balance ends at the predicted pose.
#[test]
fn the_platform_moves_as_compliance_and_length_jacobian_say() {
    let mut robot = elastic_robot();
    robot.cables.iter_mut().for_each(|cable| cable.platform_anchor.x *= 1.2);
    let pose = robot.home.unwrap();
    let load = Load::of(&robot).unwrap();
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    let tensions = balanced(&model, &pose, &load);
    let k = Stiffness::at(&model, &pose, &tensions, &load).unwrap();
    let equilibrium = |controlled: &[f64], extra: &Wrench| {
        let mut at = pose;
        for _ in 0..20 {
            let missing = residual(&model, &at, controlled, &load) + DVector::from_column_slice(extra.as_slice());
            let step = k.compliance().unwrap() * missing;
            at = at.displaced(&Twist::from_column_slice(step.as_slice()));
        }
        pose.displacement_to(&at)
    };
    let small = 1e-3;
    for axis in 0..6 {
        let force = Wrench::ith(axis, small);
        let moved = equilibrium(&k.controlled_lengths, &force) - equilibrium(&k.controlled_lengths, &-force);
        let predicted = k.compliance().unwrap().column(axis) * (2.0 * small);
        // central difference: third order of 1e-6 m; after the Newton steps only rounding
        assert!((moved - predicted).amax() < 1e-12, "axis {axis}: {moved}");
    }
    for cable in 0..8 {
        let reeled = |step: f64| {
            let mut lengths = k.controlled_lengths.clone();
            lengths[cable] += step;
            equilibrium(&lengths, &Wrench::zeros())
        };
        let moved = (reeled(1e-5) - reeled(-1e-5)) / 2e-5;
        let predicted = k.pose_by_controlled_lengths().unwrap();
        // rounding 1e-15 m over 2e-5 m, truncation of third order
        assert!((moved - predicted.column(cable)).amax() < 1e-6, "cable {}: {moved}", cable + 1);
    }
}

#[test]
fn gravity_terms_agree_with_dual_numbers() {
    let (model, pose, _, load) = of(Composition::ELASTIC);
    let robot = model.robot();
    let weight = robot.gravity.unwrap() * robot.platform.mass.unwrap();
    let moment_arm = rotate(
        &pose.rotation_rows().map(|row| row.map(Dual::from)),
        [0, 1, 2].map(|k| Dual::from(robot.platform.center_of_mass.unwrap()[k])),
    );
    let turned = add(moment_arm, cross([0, 1, 2].map(|k| variable(0.0, 3 + k)), moment_arm));
    let moment = cross(turned, [0, 1, 2].map(|k| Dual::from(weight[k])));
    for row in 0..3 {
        assert!((moment[row].re - load.wrench(&pose)[3 + row]).abs() < 1e-12);
        let gradient = moment[row].eps.unwrap_generic(Const, Const::<1>);
        for axis in 0..6 {
            assert!((gradient[axis] - load.gradient(&pose)[(3 + row, axis)]).abs() < 1e-12);
        }
    }
}

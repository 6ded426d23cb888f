//! Criteria against brute force, and laws that all of them obey.

mod clearances;
mod sets;
mod stiffnesses;

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::*;
use crate::WorkspaceError;
use crate::criterion::registry::{self, CriterionRequest, Setting};
use cdpr_model::geometry::Twist;
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::{CableStiffness, Obstacle, ObstacleShape, Robot};
use cdpr_model::statics::Load;
use cdpr_model::tension::Limits;

/// A built-in robot with every key that a criterion may ask for.
fn complete(name: &str) -> Robot {
    let mut robot = Robot::builtin(name).unwrap();
    let planar = robot.motion_pattern.is_planar();
    robot.gravity = Some(if planar { robot.plane.second_axis() } else { Vector3::z() } * -9.81);
    robot.external_wrench = None;
    robot.platform.mass = Some(100.0);
    robot.platform.center_of_mass = Some(Vector3::zeros());
    robot.platform.inertia = Some(nalgebra::Matrix3::from_diagonal(&Vector3::new(20.0, 25.0, 30.0)));
    for cable in &mut robot.cables {
        cable.stiffness = Some(CableStiffness::Axial(2e5));
        (cable.tension_min, cable.tension_max) = (Some(10.0), Some(9e3));
        cable.diameter = Some(0.006);
        (cable.length_min, cable.length_max) = (Some(0.5), Some(12.0));
        (cable.pulley_wrap_min, cable.pulley_wrap_max) = (Some(0.2), Some(3.0));
    }
    let home = robot.home_or_middle().position;
    let shape = match planar {
        true => {
            let corner = (robot.plane.first_axis() + robot.plane.second_axis()) * 0.4;
            ObstacleShape::Box { min: home + corner, max: home + corner * 2.0 }
        }
        false => {
            ObstacleShape::Box { min: home + Vector3::new(0.8, 0.3, -1.0), max: home + Vector3::new(1.4, 1.2, 1.5) }
        }
    };
    robot.obstacles.push(Obstacle { name: "crate".to_owned(), shape });
    let side = robot.plane.first_axis() * 2.0;
    let strut =
        ObstacleShape::Strut { from: home - side, to: home - side * 1.2 + robot.plane.second_axis(), radius: 0.05 };
    robot.obstacles.push(Obstacle { name: "strut".to_owned(), shape: strut });
    robot
}

fn model(name: &str, composition: Composition) -> Model {
    Model::new(complete(name), composition).unwrap()
}

/// Poses about home that the pattern allows, up to `reach` metres away on a robot whose cables are 5 m long.
fn poses(model: &Model, count: usize, reach: f64, seed: u64) -> Vec<Pose> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let home = model.robot().home_or_middle();
    let size: f64 = model.robot().cables.iter().map(|cable| (cable.frame_anchor - home.position).norm()).sum();
    let size = size / model.cable_count() as f64 / 5.0;
    let mut pose = || {
        let step: Twist = model.twist_basis().iter().enumerate().fold(Twist::zeros(), |sum, (row, twist)| {
            let turn = row >= model.robot().motion_pattern.translations();
            sum + twist * rng.random_range(-1.0..1.0) * if turn { 0.3 * reach.min(1.0) } else { reach * size }
        });
        home.displaced(&step)
    };
    (0..count).map(|_| pose()).collect()
}

/// All criteria of this folder for one model, with pulleys or without.
fn all(model: &Model) -> Vec<Box<dyn Criterion + '_>> {
    let (load, limits) = (Load::of(model.robot()).unwrap(), Limits::of(model.robot(), None, None).unwrap());
    let mut all: Vec<Box<dyn Criterion + '_>> = vec![
        Box::new(MinimumStiffness::new(model, &load, &limits, 1e4, None).unwrap()),
        Box::new(StaticStability::new(model, &load, &limits, None).unwrap()),
        Box::new(NaturalFrequency::new(model, &load, &limits, 5.0).unwrap()),
        Box::new(JacobianConditioning::new(model, 5.0, None).unwrap()),
        Box::new(Dexterity::new(model, 0.2, None).unwrap()),
        Box::new(LengthLimits::new(model, None, None).unwrap()),
        Box::new(CableInterference::new(model, 0.02, None).unwrap()),
        Box::new(CableObstacles::new(model, 0.1, None).unwrap()),
        Box::new(PlatformObstacles::new(model, 0.05).unwrap()),
        Box::new(ModelValidity::new(model)),
        Box::new(WrenchSetFeasible::with_ball(model, &limits, &load, [50.0, 10.0], None).unwrap()),
    ];
    if model.composition().pulley {
        all.push(Box::new(WrapLimits::new(model, None, None).unwrap()));
    }
    if model.robot().motion_pattern.has_rotation() {
        all.push(Box::new(PlatformInterference::new(model, 0.1).unwrap()));
    }
    all
}

fn models() -> Vec<Model> {
    vec![
        model("planar-example", Composition::ELASTIC),
        model("kntu-planar", Composition::ELASTIC),
        model("cogiro", Composition::ELASTIC),
        model("cablerobot-simulator-helicopter", Composition::ELASTIC),
        model("cucablerobot", Composition::PULLEY_ELASTIC),
    ]
}

/// There is a reason exactly if the margin is negative, `holds` agrees with `judge`, and margins are never NaN.
#[test]
fn verdicts_are_consistent_at_all_poses() {
    for model in models() {
        for criterion in all(&model) {
            let (mut held, mut failed) = (0, 0);
            for pose in poses(&model, 60, 4.0, 91) {
                let verdict = criterion.judge(&pose);
                let what = format!("{} of {}: {verdict:?}", criterion.name(), model.robot().name);
                assert!(!verdict.margin.is_nan(), "{what}");
                assert_eq!(verdict.reason.is_some(), verdict.margin < 0.0, "{what}");
                assert_eq!(criterion.holds(&pose), verdict.holds(), "{what}");
                assert!(verdict.cable.is_none_or(|cable| cable < model.cable_count()), "{what}");
                *(if verdict.holds() { &mut held } else { &mut failed }) += 1;
            }
            let nowhere = Pose { position: Vector3::repeat(f64::NAN), ..Pose::identity() };
            assert!(!criterion.holds(&nowhere) && criterion.judge(&nowhere).reason.is_some());
            assert!(held + failed == 60);
        }
    }
}

/// Steps of 1e-7 m and rad change a margin by little, relative to its range over the poses.
#[test]
fn margins_are_continuous() {
    for model in models() {
        for criterion in all(&model) {
            let poses = poses(&model, 60, 1.0, 92);
            let margins: Vec<f64> = poses.iter().map(|pose| criterion.judge(pose).margin).collect();
            let size = margins.iter().filter(|margin| margin.is_finite()).fold(1e-3, |most: f64, m| most.max(m.abs()));
            for (pose, margin) in poses.iter().zip(&margins).filter(|(_, margin)| margin.is_finite()) {
                let step = model.twist_basis().iter().fold(Twist::zeros(), |sum, twist| sum + twist * 1e-7);
                let next = criterion.judge(&pose.displaced(&step)).margin;
                // −∞ beside a finite margin: tensions cease to exist here
                let change = (next - margin).abs();
                let what = format!("{} of {}", criterion.name(), model.robot().name);
                assert!(change < 1e-4 * size || next == f64::NEG_INFINITY, "{what}: {margin} {next}");
            }
        }
    }
}

#[test]
fn what_a_criterion_needs_and_the_file_lacks_is_named() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter").unwrap();
    let (rigid, load) = (Model::new(robot.clone(), Composition::STANDARD).unwrap(), Load::constant(Twist::zeros()));
    let limits = Limits::uniform(8, 1.0, 1e4).unwrap();
    let says = |error: Result<(), WorkspaceError>, part: &str| {
        let words = error.unwrap_err().to_string();
        assert!(words.contains(part), "{part} is not in: {words}");
    };
    says(MinimumStiffness::new(&rigid, &load, &limits, 0.0, None).map(drop), "`elastic`");
    says(StaticStability::new(&rigid, &load, &limits, None).map(drop), "`elastic`");
    says(LengthLimits::new(&rigid, None, None).map(drop), "length_max_m");
    says(LengthLimits::new(&rigid, Some(3.0), Some(2.0)).map(drop), "not above");
    says(WrapLimits::new(&rigid, None, Some(3.0)).map(drop), "`pulley`");
    says(CableInterference::new(&rigid, 0.0, None).map(drop), "diameter_m");
    says(CableInterference::new(&rigid, -1.0, Some(0.01)).map(drop), "clearance");
    says(CableObstacles::new(&rigid, 0.0, Some(0.01)).map(drop), "[[obstacle]]");
    says(JacobianConditioning::new(&rigid, 0.5, None).map(drop), "1 or more");
    says(Dexterity::new(&rigid, 1.5, None).map(drop), "0 to 1");
    says(Dexterity::new(&rigid, 0.5, Some(0.0)).map(drop), "length scale");
    let mut point = Robot::builtin("planar-example").unwrap();
    let planar = Model::new(point.clone(), Composition::STANDARD).unwrap();
    says(PlatformInterference::new(&planar, 0.0).map(drop), "hull_m");
    point.platform.mass = None;
    point.cables.iter_mut().for_each(|cable| cable.stiffness = Some(CableStiffness::Axial(1e5)));
    let elastic = Model::new(point, Composition::ELASTIC).unwrap();
    says(NaturalFrequency::new(&elastic, &load, &Limits::uniform(4, 1.0, 1e4).unwrap(), 1.0).map(drop), "mass_kg");
    let mut half = complete("cogiro");
    half.cables[3].length_max = None;
    half.cables[2].stiffness = Some(CableStiffness::Compliance(0.0));
    let half = Model::new(half, Composition::ELASTIC).unwrap();
    says(LengthLimits::new(&half, None, None).map(drop), "cable 4");
    says(MinimumStiffness::new(&half, &load, &limits, 0.0, None).map(drop), "axial_stiffness_EA_N");
    let mut inside = complete("cogiro");
    let corner = |k: i32| Vector3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2)) * 20.0;
    inside.platform.hull = Some((0..8).map(|k| corner(k) - Vector3::repeat(10.0)).collect());
    let inside = Model::new(inside, Composition::STANDARD).unwrap();
    says(PlatformInterference::new(&inside, 0.0).map(drop), "hull_m");
}

/// Every entry of the registry makes the criterion of its name from a complete robot and its required numbers.
#[test]
fn every_criterion_is_made_by_its_name() {
    let model = model("cucablerobot", Composition::PULLEY_ELASTIC);
    let setting =
        Setting { model: &model, load: Load::of(model.robot()), limits: Limits::of(model.robot(), None, None) };
    for entry in registry::ENTRIES {
        let numbers: Vec<String> = entry
            .numbers
            .iter()
            .filter(|number| number.is_required)
            .map(|number| format!("{}=1", number.name))
            .collect();
        let wanted: CriterionRequest = format!("{}:{}", entry.name, numbers.join(",")).parse().unwrap();
        let criterion = wanted.make(&setting).unwrap();
        assert_eq!(criterion.name(), entry.name);
        assert!(!criterion.judge(&model.robot().home_or_middle()).margin.is_nan());
    }
    let made = |text: &str| text.parse::<CriterionRequest>().unwrap().make(&setting);
    assert!(made("wrench-set-feasible:mass-min=5,mass-max=20,acceleration=14,angular-acceleration=3").is_ok());
    let both = made("wrench-set-feasible:mass-max=20,force=5").map(drop).unwrap_err().to_string();
    assert!(both.contains("two criteria"), "{both}");
}

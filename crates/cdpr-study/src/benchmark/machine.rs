//! A robot as built: with deviating numbers, cables that stretch, and the poses at which it is judged.

use nalgebra::Vector3;
use rand::SeedableRng;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

use super::rules::{BenchmarkError, BenchmarkRules};
use crate::study::{ControlModel, PoseFilter, PoseGrid, Poses, RandomPoses, RobotModel};
use crate::{Experiment, Robots, Study};
use cdpr_model::control::{CommandedPose, Initial};
use cdpr_model::measurement::SensorSigmas;
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::{CableStiffness, Robot};
use cdpr_model::tension::Method;

/// Fewest poses from which a workspace is judged.
const LEAST: usize = 12;

/// A machine with its poses.
pub(super) struct Machine {
    robot: Robot,
    composition: Composition,
    study: Study,
    /// Poses to command.
    pub(super) poses: Vec<CommandedPose>,
    /// Poses that are measured.
    pub(super) measured: Vec<CommandedPose>,
    /// Standard deviation of the machine's frame anchors per axis (m).
    pub(super) anchor_sigma: f64,
}

impl Machine {
    /// The machine of a robot: the effects that its file supports, elastic cables in any case, with deviating numbers.
    pub(super) fn of(robot: &Robot, rules: &BenchmarkRules) -> Result<Self, BenchmarkError> {
        let stretching = with_stiffness(robot, rules)?;
        let composition = Composition::supported(&stretching)?.richest.without("drum");
        let model = Model::new(robot.clone(), Composition::STANDARD)?;
        let anchor_sigma = rules.anchor_deviation * frame_size(robot);
        let robot = deviating(&model, stretching, rules, anchor_sigma);
        let study = study(&robot, rules);
        let mut machine = Self { robot, composition, study, poses: Vec::new(), measured: Vec::new(), anchor_sigma };
        let own = machine.under(&machine.robot, Composition::STANDARD)?;
        let all = own.study.commanded_poses(&machine.robot, Vec::new(), rules.seed)?.len();
        machine.poses = own.poses(Vec::new(), rules.seed)?;
        if machine.poses.len() < LEAST {
            return Err(BenchmarkError::TooFewPoses { there: machine.poses.len(), all, least: LEAST });
        }
        machine.measured = machine.poses.clone();
        machine.measured.shuffle(&mut ChaCha8Rng::seed_from_u64(rules.seed));
        machine.measured.truncate(rules.measured_poses);
        Ok(machine)
    }

    /// The machine under a control model of the robot's file.
    pub(super) fn under(&self, robot: &Robot, control: Composition) -> Result<Experiment, BenchmarkError> {
        let mut study = self.study.clone();
        (study.control.model, study.machine.model) = (control.to_string(), self.composition.to_string());
        let robots = Robots { control: robot.clone(), machine: self.robot.clone(), prediction: None, former: None };
        Ok(Experiment::new(study, robots)?)
    }

    /// Control models that a robot's file supports.
    pub(super) fn controls(&self, robot: &Robot) -> Vec<Composition> {
        supported(robot, self.composition)
    }
}

/// Mean distance of the frame anchors from their middle (m).
fn frame_size(robot: &Robot) -> f64 {
    let count = robot.cable_count().max(1) as f64;
    let middle = robot.cables.iter().map(|cable| cable.frame_anchor).sum::<Vector3<f64>>() / count;
    robot.cables.iter().map(|cable| (cable.frame_anchor - middle).norm()).sum::<f64>() / count
}

/// The robot with default stiffnesses for the cables whose file states none.
fn with_stiffness(robot: &Robot, rules: &BenchmarkRules) -> Result<Robot, BenchmarkError> {
    let mut robot = robot.clone();
    for cable in &mut robot.cables {
        let largest = cable.tension_max.ok_or(BenchmarkError::NoLimits)?;
        let usual = CableStiffness::Axial(largest / rules.strain_at_largest_tension);
        cable.stiffness = Some(cable.stiffness.unwrap_or(usual));
    }
    Ok(robot)
}

/// The robot as built: normal deviations of the anchors along the directions of its motion pattern, and of the
/// stiffnesses.
fn deviating(model: &Model, mut robot: Robot, rules: &BenchmarkRules, anchor_sigma: f64) -> Robot {
    let mut rng = ChaCha8Rng::seed_from_u64(rules.seed);
    rng.set_stream(1);
    let mut normal = move || -> f64 { StandardNormal.sample(&mut rng) };
    let has_extent = robot.cables.iter().any(|cable| cable.platform_anchor.norm() > 0.0);
    let platform_sigma = if has_extent { rules.anchor_deviation * model.platform_radius() } else { 0.0 };
    for cable in &mut robot.cables {
        for axis in model.axes() {
            cable.frame_anchor += axis * (anchor_sigma * normal());
            cable.platform_anchor += axis * (platform_sigma * normal());
        }
        let factor = 1.0 + rules.stiffness_deviation * normal();
        cable.stiffness = cable.stiffness.map(|stiffness| match stiffness {
            CableStiffness::Axial(value) => CableStiffness::Axial(value * factor),
            CableStiffness::Compliance(value) => CableStiffness::Compliance(value / factor),
            CableStiffness::Spring(value) => CableStiffness::Spring(value * factor),
        });
    }
    robot
}

/// The study of a machine; its models are set when they are chosen.
fn study(robot: &Robot, rules: &BenchmarkRules) -> Study {
    let (home, pattern) = (robot.home_or_middle(), robot.motion_pattern);
    let middle = pattern.pose_to_components(robot.plane, &home);
    let moves = pattern.translations();
    let halves = half_sides(robot, rules, moves);
    let ends = |side: f64| -> Vec<f64> {
        let end = |(k, value): (usize, &f64)| if k < moves { value + side * halves[k] } else { *value };
        middle.iter().enumerate().map(end).collect()
    };
    let points = |k: usize| [5, 5, 3].get(k).copied().filter(|_| k < moves).unwrap_or(1);
    let turns = middle.len() - moves;
    let random = RandomPoses {
        count: rules.turned_poses,
        min: None,
        max: None,
        rotation_rad: Some(vec![rules.turn_rad; turns]),
        set: None,
    };
    let grid = PoseGrid { min: ends(-1.0), max: ends(1.0), count: (0..middle.len()).map(points).collect(), set: None };
    let largest = robot.cables.iter().filter_map(|cable| cable.tension_max).fold(0.0, f64::max);
    let named = |robot: &str| (robot.to_owned(), Composition::STANDARD.to_string());
    let ((control, of_control), (machine, of_machine)) = (named("control"), named("machine"));
    Study {
        control: ControlModel { robot: control, model: of_control, tension_method: None, compensation: None },
        machine: RobotModel { robot: machine, model: of_machine },
        prediction: None,
        initial: Initial { pose: middle, tension_method: Some(Method::Qp), ..Initial::default() },
        limits: None,
        poses: Some(Poses {
            grid: Some(grid),
            file: None,
            random: (turns > 0).then_some(random),
            tension_tests: None,
            only: Some(PoseFilter::WrenchFeasible),
        }),
        noise: Some(SensorSigmas {
            position: Some(rules.position_m),
            rotation: Some(rules.rotation_rad),
            length: Some(rules.length_m),
            tension: Some(rules.tension_share * largest),
            swivel: None,
            length_scale: None,
            balance_force: None,
            balance_moment: None,
        }),
        history: None,
        tolerances: None,
        campaign: None,
        task: None,
        published: Vec::new(),
    }
}

/// Half sides of the box of poses (m): a fraction of the travel box, or of the box of frame anchors and home pose if
/// the file states none.
fn half_sides(robot: &Robot, rules: &BenchmarkRules, moves: usize) -> Vec<f64> {
    let (pattern, home) = (robot.motion_pattern, robot.home_or_middle());
    let components = |point: Vector3<f64>| {
        let pose = cdpr_model::geometry::Pose { position: point, ..home };
        pattern.pose_to_components(robot.plane, &pose)
    };
    let points: Vec<Vec<f64>> = match &robot.travel {
        Some(travel) => vec![components(travel.min), components(travel.max)],
        None => {
            robot.cables.iter().map(|cable| components(cable.frame_anchor)).chain([components(home.position)]).collect()
        }
    };
    let side = |k: usize| {
        let along = || points.iter().map(|point| point[k]);
        along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
    };
    (0..moves).map(|k| 0.5 * rules.box_share * side(k)).collect()
}

/// Control models that a file supports and that have no effect beyond the machine's, from the simplest to the richest.
fn supported(robot: &Robot, machine: Composition) -> Vec<Composition> {
    let own: Vec<&str> = machine.effects().collect();
    let is_poorer = |model: &Composition| model.effects().all(|effect| own.contains(&effect));
    Composition::all().filter(is_poorer).filter(|model| Model::new(robot.clone(), *model).is_ok()).collect()
}

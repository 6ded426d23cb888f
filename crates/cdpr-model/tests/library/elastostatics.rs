//! The elastostatic forward problem: every equilibrium is found again, and nothing that is none is called one.

use super::support::{builtin, displaced, random_pose, with_pulleys, within_pattern};
use cdpr_model::equilibrium::elastostatics::{InputError, Settings, Solution, Solver, Status, solve};
use cdpr_model::geometry::{Pose, Twist, Wrench};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::{CableStiffness, Robot};
use cdpr_model::statics::{Load, Stiffness, wrench_residual};
use nalgebra::{DMatrix, DVector, Vector3};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const POSES: usize = 10_000;

/// Tensions that balance the load, near the middle of the limits (eq. 3.41); nothing where they leave the limits.
fn tensions(model: &Model, load: &Load, pose: &Pose, limits: [f64; 2]) -> Option<Vec<f64>> {
    let structure_matrix = model.structure_matrix(pose).ok()?;
    let wrench = load.in_pattern(model, pose);
    let middle = DVector::repeat(model.cable_count(), 0.5 * (limits[0] + limits[1]));
    let short = structure_matrix.clone().svd(true, true).solve(&(wrench + &structure_matrix * &middle), 1e-9).ok()?;
    let tensions = middle - short;
    tensions.iter().all(|f| (limits[0]..limits[1]).contains(f)).then(|| tensions.as_slice().to_vec())
}

fn size(robot: &Robot) -> f64 {
    let anchors = || robot.cables.iter().map(|cable| cable.frame_anchor);
    let first = robot.cables[0].frame_anchor;
    (anchors().fold(first, |a, b| a.sup(&b)) - anchors().fold(first, |a, b| a.inf(&b))).norm()
}

pub(super) fn distance(a: &Pose, b: &Pose, radius: f64) -> f64 {
    (a.position - b.position).norm().hypot(radius * a.angle_to(b))
}

/// How the searches ended.
#[derive(Debug, Default)]
struct Tally {
    found: usize,
    other_stable: usize,
    start_unstable: usize,
    not_converged: usize,
    worst_pose: f64,
    worst_tension: f64,
    worst_balance: f64,
    most_iterations: u32,
    iterations: u32,
    restarts: u32,
    first_reason: Option<String>,
}

fn tally(robot: &Robot, composition: Composition, limits: [f64; 2]) -> Tally {
    let model = Model::new(robot.clone(), composition).unwrap();
    let load = Load::of(robot).unwrap();
    let scale = size(robot) / size(&super::support::simulator());
    let mut rng = ChaCha8Rng::seed_from_u64(2021);
    let mut solver = Solver::new(&model, &load, &Settings::default()).unwrap();
    let mut tally = Tally::default();
    for _ in 0..POSES {
        let (pose, expected) = loop {
            let pose = random_pose(robot, 10_f64.to_radians(), &mut rng);
            let pose = within_pattern(&model, &robot.home_or_middle(), &pose);
            if let Some(tensions) = tensions(&model, &load, &pose, limits) {
                break (pose, tensions);
            }
        };
        let lengths: Vec<f64> = (0..model.cable_count())
            .map(|cable| {
                let (path, _) = model.path(cable, &pose).unwrap();
                model.elasticity(cable).controlled_length(path.length, expected[cable])
            })
            .collect();
        let guess = displaced(&pose, 0.1 * scale, 3_f64.to_radians(), &mut rng);
        let guess = within_pattern(&model, &pose, &guess);
        let solution = solver.solve(&lengths, &guess).unwrap();
        tally.add(solution, &pose, &expected, model.platform_radius());
    }
    tally
}

impl Tally {
    fn add(&mut self, solution: &Solution, pose: &Pose, expected: &[f64], radius: f64) {
        let error = distance(&solution.pose, pose, radius);
        let tension_error = solution
            .tensions
            .iter()
            .zip(expected)
            .map(|(found, expected)| (found - expected).abs())
            .fold(0.0, f64::max);
        self.iterations += solution.iterations;
        self.restarts += solution.restarts;
        self.most_iterations = self.most_iterations.max(solution.iterations);
        match solution.status {
            Status::Converged if error < 1e-9 && tension_error < 1e-4 => {
                self.found += 1;
                self.worst_pose = self.worst_pose.max(error);
                self.worst_tension = self.worst_tension.max(tension_error);
                self.worst_balance = self.worst_balance.max(solution.wrench_residual);
            }
            Status::Converged if solution.stability > 0.0 && error > 1e-3 => self.other_stable += 1,
            Status::Unstable if error < 1e-9 => self.start_unstable += 1,
            _ => {
                self.not_converged += 1;
                self.first_reason.get_or_insert(format!("{error:e} {tension_error:e} {solution:?}"));
            }
        }
    }
}

fn stretchable(robot: &Robot, stiffness: f64) -> Robot {
    let mut robot = robot.clone();
    for cable in &mut robot.cables {
        cable.stiffness.get_or_insert(CableStiffness::Axial(stiffness));
    }
    robot
}

#[test]
fn elastic_robots_find_every_pose_again() {
    for (name, limits, stiffness) in [
        ("cablerobot-simulator-helicopter-elastostatic-calibrated", [500.0, 10_000.0], 4e5),
        ("cogiro", [10.0, 5000.0], 5e5),
        ("planar-example", [500.0, 9000.0], 2e5),
    ] {
        let robot = stretchable(&builtin(name), stiffness);
        let placed = with_pulleys(&robot, 0.01 * size(&robot));
        for (robot, composition) in [(&robot, Composition::ELASTIC), (&placed, Composition::PULLEY_ELASTIC)] {
            let start = std::time::Instant::now();
            let tally = tally(robot, composition, limits);
            println!("{name} {composition}: {tally:?} {:?}", start.elapsed());
            assert_eq!(tally.found, POSES, "{name} {composition}: {tally:?}");
        }
    }
}

/// The calibrated CableRobot Simulator with its elasticity, a load with a weight off the origin and a constant moment.
fn loaded_simulator() -> (Model, Load) {
    let mut robot = stretchable(&builtin("cablerobot-simulator-helicopter-elastostatic-calibrated"), 4e5);
    robot.gravity = Some(Vector3::new(0.0, 0.0, -9.81));
    robot.platform.mass = Some(180.0);
    robot.platform.center_of_mass = Some(Vector3::new(0.1, -0.2, 0.3));
    let external = robot.external_wrench.get_or_insert(cdpr_model::robot::ExternalWrench {
        wrench: Wrench::zeros(),
        includes_gravity: false,
        note: None,
    });
    (external.includes_gravity, external.wrench) = (false, Wrench::new(100.0, -200.0, 50.0, 120.0, -300.0, 80.0));
    let load = Load::of(&robot).unwrap();
    (Model::new(robot, Composition::ELASTIC).unwrap(), load)
}

/// Controlled lengths with these cables pulled in by `tighten` (m) from their geometric lengths at a pose.
fn tightened(model: &Model, pose: &Pose, tighten: f64) -> Vec<f64> {
    model.cable_lengths(pose).unwrap().iter().map(|length| length - tighten).collect()
}

fn twist(vector: &DVector<f64>) -> Twist {
    Twist::from_column_slice(vector.as_slice())
}

/// Forces of the solution by the public formulas of statics and elasticity, not by the kernel.
#[test]
fn tensions_follow_from_the_law_and_balance_the_load() {
    let (model, load) = loaded_simulator();
    let mut rng = ChaCha8Rng::seed_from_u64(4);
    for _ in 0..200 {
        let pose = random_pose(model.robot(), 0.2, &mut rng);
        let lengths: Vec<f64> = tightened(&model, &pose, 0.0)
            .iter()
            .map(|length| length + rng.random_range(-0.03..0.02)) // some cables are slack
            .collect();
        let solution = solve(&model, &lengths, &load, &pose, &Settings::default()).unwrap();
        assert_eq!(solution.status, Status::Converged, "{:?}", solution.reason);
        for cable in 0..8 {
            let (path, _) = model.path(cable, &solution.pose).unwrap();
            let tension = model.elasticity(cable).tension(path.length, lengths[cable]).value.max(0.0);
            assert!((solution.tensions[cable] - tension).abs() < 1e-7); // 1e-15 m over 1e-6 m/N
        }
        assert_eq!(solution.slack, solution.tensions.iter().filter(|f| **f == 0.0).count());
        let residual = wrench_residual(&model, &solution.pose, &solution.tensions, &load).unwrap();
        assert!(residual.amax() < 1e-6, "{residual}");
        let stiffness = Stiffness::at(&model, &solution.pose, &solution.tensions, &load).unwrap();
        let smallest = stiffness.eigenvalues()[0];
        // the solver's is that of the last step but one
        assert!((solution.stability / smallest - 1.0).abs() < 1e-5, "{} {smallest}", solution.stability);
    }
}

/// δx = K_wx⁻¹ δw and δx = −K_wx⁻¹ K_wq δq_θ: the stiffness matrices of statics predict what the forward solve does, the
/// skew part of the constant moment included.
#[test]
fn stiffness_equals_finite_differences_of_the_forward_solve() {
    let (model, load) = loaded_simulator();
    let robot_load = |extra: Wrench| {
        let mut robot = model.robot().clone();
        robot.external_wrench.as_mut().unwrap().wrench += extra;
        Load::of(&robot).unwrap()
    };
    let start = model.robot().home_or_middle().displaced(&Twist::new(0.3, -0.4, 0.2, 0.05, -0.08, 0.1));
    let lengths = tightened(&model, &start, 0.02);
    let at = |load: &Load, lengths: &[f64]| solve(&model, lengths, load, &start, &Settings::default()).unwrap();
    let middle = at(&load, &lengths);
    assert_eq!(middle.slack, 0);
    let stiffness = Stiffness::at(&model, &middle.pose, &middle.tensions, &load).unwrap();
    let compliance = stiffness.compliance().unwrap();
    let by_lengths = stiffness.pose_by_controlled_lengths().unwrap();
    // central differences: the pose is right to 1e-13 m, steps move it by about 1e-4 m
    for axis in 0..6 {
        let wrench = Wrench::ith(axis, 50.0);
        let (ahead, behind) = (at(&robot_load(wrench), &lengths), at(&robot_load(-wrench), &lengths));
        let slope = behind.pose.displacement_to(&ahead.pose) / 100.0;
        let error = (slope - twist(&compliance.column(axis).into_owned())).norm();
        assert!(error < 1e-5 * slope.norm(), "axis {axis}: {error:e} of {:e}", slope.norm());
    }
    for cable in 0..8 {
        let moved = |by: f64| {
            let mut lengths = lengths.clone();
            lengths[cable] += by;
            at(&load, &lengths).pose
        };
        let slope = moved(-1e-4).displacement_to(&moved(1e-4)) / 2e-4;
        let error = (slope - twist(&by_lengths.column(cable).into_owned())).norm();
        assert!(error < 1e-5 * slope.norm(), "cable {cable}: {error:e} of {:e}", slope.norm());
    }
}

/// The platform let go with friction: explicit steps of the forces alone, no stiffness, no energy. Each velocity is dropped
/// when it turns against its force.
fn relaxed(model: &Model, lengths: &[f64], load: &Load, start: &Pose) -> Pose {
    let (mut pose, mut velocity) = (*start, DVector::zeros(model.dof()));
    let mut masses: Option<DVector<f64>> = None;
    for _ in 0..200_000 {
        let tensions: Vec<f64> = (0..model.cable_count())
            .map(|cable| {
                let length = model.path(cable, &pose).unwrap().0.length;
                model.elasticity(cable).tension(length, lengths[cable]).value.max(0.0)
            })
            .collect();
        let force = wrench_residual(model, &pose, &tensions, load).unwrap();
        let masses = masses.get_or_insert_with(|| {
            // twice the row sums of |A|ᵀ k |A|, all cables taut: steps of 1 are then stable
            let a: DMatrix<f64> = model.structure_matrix(&pose).unwrap();
            let stiffness = |cable: usize| 1.0 / model.elasticity(cable).compliance(lengths[cable], lengths[cable]);
            DVector::from_fn(model.dof(), |row, _| {
                2.0 * (0..model.cable_count())
                    .map(|cable| stiffness(cable) * a[(row, cable)].abs() * a.column(cable).abs().sum())
                    .sum::<f64>()
            })
        });
        velocity += force.component_div(masses);
        if velocity.dot(&force) < 0.0 {
            velocity.fill(0.0);
            velocity += force.component_div(masses) * 0.5;
        }
        let mut step = Twist::zeros();
        for (direction, amount) in model.twist_basis().iter().zip(velocity.iter()) {
            step += direction * *amount;
        }
        pose = pose.displaced(&step);
        if force.amax() < 1e-7 {
            break;
        }
    }
    pose
}

#[test]
fn a_platform_let_go_with_friction_comes_to_rest_at_the_same_pose() {
    let mut rng = ChaCha8Rng::seed_from_u64(11);
    let (simulator, simulator_load) = loaded_simulator();
    let cogiro = stretchable(&builtin("cogiro"), 5e5);
    let cogiro_load = Load::of(&cogiro).unwrap();
    let cogiro = Model::new(cogiro, Composition::ELASTIC).unwrap();
    let planar = stretchable(&builtin("planar-example"), 2e5);
    let planar_load = Load::of(&planar).unwrap();
    let planar = Model::new(planar, Composition::ELASTIC).unwrap();
    for (model, load) in [(&simulator, &simulator_load), (&cogiro, &cogiro_load), (&planar, &planar_load)] {
        for _ in 0..10 {
            let pose = model.robot().home_or_middle();
            let lengths: Vec<f64> =
                tightened(model, &pose, 0.01).iter().map(|length| length + rng.random_range(-0.02..0.02)).collect();
            let solution = solve(model, &lengths, load, &pose, &Settings::default()).unwrap();
            assert_eq!(solution.status, Status::Converged);
            let expected = relaxed(model, &lengths, load, &pose);
            let error = distance(&solution.pose, &expected, model.platform_radius());
            // forces to 1e-7 N over the softest direction, some 10 N/m
            assert!(error < 1e-6, "{}: {error:e}, {} slack", model.robot().name, solution.slack);
        }
    }
}

/// Two opposite cables that pull at the rim away from each other are stable; crossed over they turn the platform round.
#[test]
fn an_unstable_equilibrium_is_left() {
    let mut robot = stretchable(&builtin("planar-example"), 2e5);
    robot.motion_pattern = cdpr_model::geometry::MotionPattern::Planar;
    let anchors = [[-5.0, 0.0, -0.5, 0.0], [5.0, 0.0, 0.5, 0.0], [0.0, 5.0, 0.0, 0.5], [0.0, -5.0, 0.0, -0.5]];
    for (cable, [ax, ay, bx, by]) in robot.cables.iter_mut().zip(anchors) {
        cable.frame_anchor = Vector3::new(ax, ay, 0.0);
        cable.platform_anchor = Vector3::new(-bx, -by, 0.0); // turned by 180°
    }
    robot.home = None;
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    let load = Load::constant(Wrench::zeros());
    let settings = Settings { max_restarts: 0, ..Settings::default() };
    let turned_round = Pose::identity();
    let lengths = [4.4; 4];
    let solution = solve(&model, &lengths, &load, &turned_round, &settings).unwrap();
    assert_eq!(solution.status, Status::Unstable, "{solution:?}");
    assert!(solution.stability < 0.0 && solution.reason.unwrap().contains("smallest disturbance"));
    let solution = solve(&model, &lengths, &load, &turned_round, &Settings::default()).unwrap();
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.reason);
    assert!(solution.pose.angle_to(&turned_round) > 3.1, "turned by half a circle");
}

#[test]
fn slack_cables_without_load_are_singular_in_words() {
    let robot = stretchable(&builtin("planar-example"), 2e5);
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    let load = Load::constant(Wrench::zeros());
    let pose = model.robot().home_or_middle();
    let solution = solve(&model, &tightened(&model, &pose, -1.0), &load, &pose, &Settings::default()).unwrap();
    assert_eq!((solution.status, solution.slack), (Status::Singular, 4));
    assert!(solution.reason.unwrap().contains("all cables are slack"));
}

#[test]
fn cables_stretched_beyond_reason_are_remarked_upon() {
    let (model, load) = loaded_simulator();
    let pose = model.robot().home_or_middle();
    let half: Vec<f64> = model.cable_lengths(&pose).unwrap().iter().map(|length| 0.5 * length).collect();
    let solution = solve(&model, &half, &load, &pose, &Settings::default()).unwrap();
    assert_eq!(solution.status, Status::Converged);
    assert!(solution.reason.unwrap().contains("is stretched by"));
}

#[test]
fn input_that_makes_no_sense_is_refused() {
    let (model, load) = loaded_simulator();
    let settings = Settings::default();
    let pose = model.robot().home_or_middle();
    let error = solve(&model, &[1.0; 7], &load, &pose, &settings).unwrap_err();
    assert!(error.to_string().contains("expected 8 cable lengths"), "{error}");
    let error = solve(&model, &[f64::NAN; 8], &load, &pose, &settings).unwrap_err();
    assert!(error.to_string().contains("cable 1"), "{error}");
    assert!(solve(&model, &[8.0; 8], &load, &pose, &Settings { pose_tolerance: 0.0, ..settings.clone() }).is_err());
    let rigid = Model::new(model.robot().clone(), Composition::STANDARD).unwrap();
    let error = solve(&rigid, &[8.0; 8], &load, &pose, &settings).unwrap_err();
    assert_eq!(error, InputError::RigidRedundant { rigid: 8, dof: 6 });
}

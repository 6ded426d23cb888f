//! Drawn robots against their first order, exact against linear, and the tolerances that an accuracy allows.

use super::support::{builtin, random_poses, simulator, with_pulleys};
use cdpr_model::control::winch_offsets;
use cdpr_model::control::{CommandedPose, Initial, Shortening};
use cdpr_model::geometry::Pose;
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::ParameterKind;
use cdpr_model::tension::Method;
use cdpr_study::sensitivity::{Kind, Offsets, ParameterDeviation, PoseSensitivity, Sensitivity, Setting, Side};
use cdpr_study::study::Distribution;
use cdpr_study::tolerance::{Engine, MonteCarlo, Settings, Spread, allowed, monte_carlo};

/// A control model on a machine with what emerges without deviations.
struct Subject {
    control: Model,
    machine: Model,
    initial: Initial,
    home: Pose,
    offsets: Vec<f64>,
    commanded: Vec<CommandedPose>,
    nominal: Vec<PoseSensitivity>,
    causes: Vec<ParameterDeviation>,
}

fn initial(tensions: Option<Vec<f64>>, tension_method: Option<Method>) -> Initial {
    Initial { tensions_N: tensions, tension_method, ..Initial::default() }
}

impl Subject {
    fn new(control: Model, machine: Model, initial: Initial, home: Pose, commanded: Vec<CommandedPose>) -> Self {
        let offsets = winch_offsets(&initial, &control, &machine, &home).unwrap();
        let setting = Setting { initial: &initial, pose: home, former: None, offsets: Offsets::Kept };
        let mut sensitivity = Sensitivity::new(&control, &machine, &offsets, &setting).unwrap();
        let causes = sensitivity.causes().to_vec();
        let nominal = commanded.iter().map(|command| sensitivity.at(command).unwrap()).collect();
        Self { initial, offsets, nominal, causes, control, machine, home, commanded }
    }

    fn planar() -> Self {
        let mut robot = builtin("planar-example");
        for cable in &mut robot.cables {
            (cable.tension_min, cable.tension_max) = (Some(1000.0), Some(8000.0));
        }
        let at = |x: f64, z: f64| CommandedPose::at(robot.motion_pattern.pose(robot.plane, &[x, z]).unwrap());
        let commanded = vec![at(0.0, 5.2), at(-3.0, 2.0), at(1.5, 3.4), at(2.0, 1.0)];
        let model = |composition| Model::new(robot.clone(), composition).unwrap();
        let home = at(0.0, 5.2).pose;
        let initial = initial(None, Some(Method::ClosedForm));
        Self::new(model(Composition::STANDARD), model(Composition::ELASTIC), initial, home, commanded)
    }

    fn spatial(machine: Composition) -> Self {
        let robot = with_pulleys(&builtin("cablerobot-simulator-helicopter-kinematic-calibrated"), 0.161);
        let home = robot.home.unwrap();
        let commanded = random_poses(&robot, 5, 0.1, 3);
        let tensions = vec![3678.0, 2169.0, 4250.0, 1708.0, 3985.0, 2394.0, 4715.0, 1684.0];
        let control = Model::new(simulator(), Composition::STANDARD).unwrap();
        Self::new(control, Model::new(robot, machine).unwrap(), initial(Some(tensions), None), home, commanded)
    }

    fn translations(&self) -> usize {
        self.machine.axes().len()
    }

    fn errors(&self) -> Vec<f64> {
        let pairs = self.nominal.iter().zip(&self.commanded);
        pairs.map(|(at, command)| (at.outcome.pose.position - command.pose.position).norm()).collect()
    }

    /// A standard deviation for each unit.
    fn sigmas(&self, length: f64) -> Vec<f64> {
        let sigma = |cause: &ParameterDeviation| match cause.kind.unit() {
            "m" => length,
            "1" | "rad" => length,
            "kg" => 1e3 * length,
            _ => 1e4 * length,
        };
        self.causes.iter().map(sigma).collect()
    }

    fn draw(&self, sigmas: &[f64], robots: usize, engine: Engine, offsets: Offsets) -> MonteCarlo {
        let distribution = Distribution::Normal;
        let settings = Settings { causes: &self.causes, sigmas, distribution, robots, seed: 5, engine, history: None };
        self.draw_with(&settings, offsets)
    }

    fn draw_with(&self, settings: &Settings<'_>, offsets: Offsets) -> MonteCarlo {
        let setting = Setting { initial: &self.initial, pose: self.home, former: None, offsets };
        let (control, machine) = (&self.control, &self.machine);
        monte_carlo(control, machine, &setting, &self.offsets, &self.commanded, &self.nominal, settings).unwrap()
    }
}

#[test]
fn linear_robots_spread_as_their_derivatives_say() {
    for (subject, distribution) in [
        (Subject::planar(), Distribution::Normal),
        (Subject::spatial(Composition::PULLEY_ELASTIC), Distribution::Uniform),
    ] {
        let sigmas = subject.sigmas(1e-5);
        let spread = Spread::of(&subject.nominal, &subject.errors(), &sigmas, 2.0, subject.translations());
        let settings = Settings {
            causes: &subject.causes,
            sigmas: &sigmas,
            distribution,
            robots: 20_000,
            seed: 1,
            engine: Engine::Linear,
            history: None,
        };
        let drawn = subject.draw_with(&settings, Offsets::Kept);
        for (found, expected) in drawn.deviations.iter().zip(&spread.deviation) {
            // the relative error of a root mean square of 20 000 squares, √(2/20 000)/2 or less, four times
            assert!((found.rms / expected - 1.0).abs() < 0.02, "{} {expected}", found.rms);
        }
        for (found, expected) in drawn.errors.iter().zip(&spread.error) {
            assert!((found.rms / expected - 1.0).abs() < 0.02, "{} {expected}", found.rms);
        }
    }
}

/// The same draws: what differs is of second order in the deviations.
#[test]
fn small_deviations_do_exactly_what_the_derivatives_say() {
    let subjects =
        [Subject::planar(), Subject::spatial(Composition::PULLEY_ELASTIC), Subject::spatial(Composition::PULLEY)];
    for subject in subjects {
        let sigmas = subject.sigmas(1e-6);
        let exact = subject.draw(&sigmas, 50, Engine::Exact, Offsets::Kept);
        let linear = subject.draw(&sigmas, 50, Engine::Linear, Offsets::Kept);
        assert_eq!((exact.unanswered, exact.reason), (0, None));
        for (exact, linear) in exact.deviations.iter().zip(&linear.deviations) {
            assert!((exact.p95 / linear.p95 - 1.0).abs() < 1e-3, "{exact:?} {linear:?}");
            assert!((exact.mean / linear.mean - 1.0).abs() < 1e-3, "{exact:?} {linear:?}");
        }
    }
}

/// A shortening by nothing changes nothing but the way in which robots are asked.
#[test]
fn robots_asked_pose_by_pose_answer_as_in_batches() {
    for composition in [Composition::PULLEY_ELASTIC, Composition::PULLEY] {
        let mut subject = Subject::spatial(composition);
        let sigmas = subject.sigmas(1e-3);
        let batched = subject.draw(&sigmas, 30, Engine::Exact, Offsets::SetAnew);
        subject.commanded[0].shortened = Some(Shortening { cable: 0, by: 0.0 });
        let single = subject.draw(&sigmas, 30, Engine::Exact, Offsets::SetAnew);
        for (batched, single) in batched.errors.iter().zip(&single.errors) {
            // both end within the tolerance of the forward problems
            assert!((batched.max - single.max).abs() < 1e-8, "{batched:?} {single:?}");
            assert!((batched.mean - single.mean).abs() < 1e-8, "{batched:?} {single:?}");
        }
    }
}

#[test]
fn a_robot_is_the_same_however_many_are_drawn() {
    let subject = Subject::planar();
    let sigmas = subject.sigmas(1e-3);
    let one = subject.draw(&sigmas, 1, Engine::Exact, Offsets::Kept);
    let two = subject.draw(&sigmas, 2, Engine::Exact, Offsets::Kept);
    for (one, two) in one.errors.iter().zip(&two.errors) {
        // of two numbers, their mean and the larger give the smaller
        let other = 2.0 * two.mean - two.max;
        assert!((one.mean - two.max).abs() < 1e-12 || (one.mean - other).abs() < 1e-12, "{one:?} {two:?}");
    }
}

#[test]
fn allowed_tolerances_use_up_the_accuracy_at_the_worst_pose_and_nowhere_more() {
    let subject = Subject::planar();
    let (errors, translations) = (subject.errors(), subject.translations());
    let (accuracy, coverage) = (0.3, 2.0);
    let is_named = |side: Side, kind: Kind| side == Side::Machine && kind != Kind::Parameter(ParameterKind::Force);
    let found = allowed(&subject.causes, &subject.nominal, &errors, accuracy, coverage, &is_named, translations);
    let left = |sigma: &dyn Fn(&ParameterDeviation) -> f64, is_worst: bool| {
        let sigmas: Vec<f64> = subject.causes.iter().map(sigma).collect();
        let spread = Spread::of(&subject.nominal, &errors, &sigmas, 1.0, translations);
        let ways = if is_worst { spread.worst_case } else { spread.deviation.iter().map(|s| coverage * s).collect() };
        let left = errors.iter().zip(&ways).map(|(error, way)| accuracy - error - way);
        left.fold(f64::INFINITY, f64::min)
    };
    for kind in &found.kinds {
        let of = |cause: &ParameterDeviation| (cause.side, cause.kind) == (kind.side, kind.kind);
        for (tolerance, is_worst) in [(kind.alone, false), (kind.alone_worst_case, true)] {
            let rest = left(&|cause| if of(cause) { tolerance } else { 0.0 }, is_worst);
            // rounding of sums
            assert!(rest.abs() < 1e-12, "{kind:?}: {rest:e}");
        }
        assert_eq!(kind.joint.is_some(), is_named(kind.side, kind.kind), "{kind:?}");
    }
    for is_worst in [false, true] {
        let joint = |cause: &ParameterDeviation| {
            let own = found.kinds.iter().find(|kind| (kind.side, kind.kind) == (cause.side, cause.kind)).unwrap();
            (if is_worst { own.joint_worst_case } else { own.joint }).unwrap_or(0.0)
        };
        assert!(left(&joint, is_worst).abs() < 1e-12);
    }
}

#[test]
fn no_tolerance_helps_where_the_error_is_larger_than_the_accuracy() {
    let subject = Subject::planar();
    let errors = subject.errors();
    let found = allowed(&subject.causes, &subject.nominal, &errors, 0.01, 2.0, &|_, _| true, 2);
    let worst = errors.iter().copied().fold(0.0, f64::max);
    assert!(found.kinds.is_empty() && (found.budget - (0.01 - worst)).abs() < 1e-15);
    assert_eq!(errors[found.worst_pose], worst);
}

/// Whatever the signs of the deviations, small ones stay within the sum of their magnitudes.
#[test]
fn drawn_robots_stay_within_the_worst_case() {
    let subject = Subject::planar();
    let sigmas = subject.sigmas(1e-5);
    let settings = Settings {
        causes: &subject.causes,
        sigmas: &sigmas,
        distribution: Distribution::Uniform,
        robots: 2000,
        seed: 2,
        engine: Engine::Exact,
        history: None,
    };
    let drawn = subject.draw_with(&settings, Offsets::Kept);
    let spread = Spread::of(&subject.nominal, &subject.errors(), &sigmas, 3.0_f64.sqrt(), 2);
    for (deviation, bound) in drawn.deviations.iter().zip(&spread.worst_case) {
        assert!(deviation.max < *bound && deviation.max > 0.2 * bound, "{} {bound}", deviation.max);
    }
}

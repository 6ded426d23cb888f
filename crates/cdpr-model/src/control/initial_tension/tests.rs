use super::*;
use crate::model::Composition;
use crate::robot::Robot;
use crate::tension::Method;

/// The planar example of sec. 3.6.
struct Planar {
    control: Model,
    machine: Model,
    limits: Limits,
}

impl Planar {
    fn new() -> Self {
        let robot = Robot::builtin("planar-example").unwrap();
        let control = Model::new(robot.clone(), Composition::STANDARD).unwrap();
        let machine = Model::new(robot.clone(), Composition::ELASTIC).unwrap();
        let limits = Limits::of(&robot, Some(1000.0), Some(8000.0)).unwrap();
        Self { control, machine, limits }
    }

    fn task(&self) -> Task<'_> {
        let pose = self.at(0.0, 5.2);
        let (control, machine) = (&self.control, &self.machine);
        Task {
            control: control.into(),
            machine,
            set_with: control,
            pose,
            limits: &self.limits,
            history: None,
            now: None,
        }
    }

    fn at(&self, x: f64, y: f64) -> Pose {
        let robot = self.machine.robot();
        robot.motion_pattern.pose(robot.plane, &[x, y]).unwrap()
    }

    /// A circle of 2 m around (0, 3).
    fn circle(&self) -> Vec<Pose> {
        let angle = |k: u32| std::f64::consts::TAU * f64::from(k) / 40.0;
        (0..40).map(|k| self.at(2.0 * angle(k).cos(), 3.0 + 2.0 * angle(k).sin())).collect()
    }
}

fn by_method(method: Method) -> Target {
    Initial { tension_method: Some(method), tension_limits_N: Some([1000.0, 8000.0]), ..Initial::default() }
}

/// For a single pose, the one at which the winches are set, the best initial tensions are the target itself.
#[test]
fn for_the_initial_pose_alone_the_optimum_is_the_target() {
    let planar = Planar::new();
    let task = planar.task();
    let target = by_method(Method::ClosedForm);
    let found = optimum(&task, &target, &[task.pose]).unwrap();
    let expected = initial_tensions(&target, &planar.machine, &task.pose).unwrap();
    assert!(found.is_settled && found.fit.rms < 1e-3, "{found:?}");
    assert!(found.tensions.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-3), "{found:?} {expected:?}");
}

/// No other initial tensions nearby, balanced and within the limits, follow the target better: the cost is evaluated
/// around the optimum along the null space, in steps of 1 and 100 N. Setting the winches for the initial pose alone is
/// much worse.
#[test]
fn no_neighbour_of_the_optimum_follows_a_circle_better() {
    let planar = Planar::new();
    let task = planar.task();
    let poses = planar.circle();
    for method in [Method::ClosedForm, Method::Minimum] {
        let target = by_method(method);
        let found = optimum(&task, &target, &poses).unwrap();
        assert!(found.is_settled, "{found:?}");
        assert!(planar.limits.contain(&found.tensions, 1e-2), "{found:?}");
        let cost = |tensions: &[f64]| {
            let offsets = offsets_of(&task, tensions).unwrap();
            fit(&task, &offsets, &target, &poses).unwrap().rms
        };
        let matrix = planar.machine.structure_matrix(&task.pose).unwrap();
        for k in 0..16 {
            let angle = std::f64::consts::TAU * f64::from(k) / 16.0;
            for step in [1.0, 100.0] {
                // a direction of the null space: two changed tensions, balanced
                let mut wish = found.tensions.clone();
                wish[0] += step * angle.cos();
                wish[2] += step * angle.sin();
                let tensions = initial_tensions(&given(&wish), &planar.machine, &task.pose).unwrap();
                // the cables carry 1962 N
                let left = &matrix * nalgebra::DVector::from_column_slice(&tensions);
                assert!((left.norm() - 1962.0).abs() < 1e-8, "{left}");
                if planar.limits.contain(&tensions, 0.0) {
                    assert!(cost(&tensions) > found.fit.rms - 1e-4, "{method:?} {k} {step}: {found:?}");
                }
            }
        }
        let plain = initial_tensions(&target, &planar.machine, &task.pose).unwrap();
        // the least tensions are at the limits already
        let better = if method == Method::Minimum { 1.0 + 1e-9 } else { 0.95 };
        assert!(found.fit.rms <= better * cost(&plain), "{} {}", found.fit.rms, cost(&plain));
    }
}

/// A circle beyond the reach of the least tensions: cables go slack, and the descent from the middle of the limits ends
/// in a local minimum at 610.2 N.
#[test]
fn several_starts_leave_the_hollow_that_one_ends_in() {
    let planar = Planar::new();
    let task = Task { pose: planar.at(0.697596, 3.46791), ..planar.task() };
    let angle = |k: u32| std::f64::consts::TAU * f64::from(k) / 12.0;
    let at = |k: u32| planar.at(1.69808 + 2.83244 * angle(k).cos(), 3.47587 + 2.83244 * angle(k).sin());
    let poses: Vec<Pose> = (0..12).map(at).collect();
    let found = optimum(&task, &by_method(Method::Minimum), &poses).unwrap();
    assert!(found.is_settled && found.agreeing < found.starts, "{found:?}");
    assert!(found.fit.rms < 607.0, "{found:?}");
    // one pose of the circle has no tensions that balance the load within the limits
    assert_eq!((found.fit.poses, found.fit.without_target.len()), (11, 1), "{found:?}");
    // a start at the result leads to itself
    let again = Task { now: Some(found.tensions.clone()), ..task };
    let again = optimum(&again, &by_method(Method::Minimum), &poses).unwrap();
    assert!((again.fit.rms - found.fit.rms).abs() < 1e-3, "{again:?}");
}

/// A target of 3000 N for all tensions would give the lower cables less than 2300 N: the optimum is at a limit, not
/// beyond.
#[test]
fn the_optimum_keeps_the_limits_at_the_initial_pose() {
    let planar = Planar::new();
    let limits = Limits::uniform(4, 2300.0, 8000.0).unwrap();
    let task = Task { limits: &limits, ..planar.task() };
    let target = given(&[3000.0; 4]);
    let found = optimum(&task, &target, &planar.circle()).unwrap();
    assert!(found.tensions.iter().all(|&f| f > 2300.0 - 0.01), "{found:?}");
    assert!(!found.at_limits.is_empty());
    let narrow = Limits::uniform(4, 100.0, 120.0).unwrap();
    let refused = optimum(&Task { limits: &narrow, ..planar.task() }, &target, &planar.circle());
    assert!(matches!(refused, Err(InputError::NotBalanced { .. })), "{refused:?}");
}

/// Every stage ends at x_ini with the tensions it states, and the last with those requested.
#[test]
fn the_way_to_the_initial_tensions_rests_at_the_initial_pose_after_every_stage() {
    let planar = Planar::new();
    let task = planar.task();
    let from = initial_tensions(&by_method(Method::Minimum), &planar.machine, &task.pose).unwrap();
    let to = initial_tensions(&by_method(Method::ClosedForm), &planar.machine, &task.pose).unwrap();
    let way = approach(&task, &from, &to, 4).unwrap();
    assert_eq!((way.stages.len(), way.unanswered), (5, 0));
    for stage in &way.stages {
        let outcome = driving(&task, &stage.offsets).unwrap().outcome(&task.pose);
        assert!((outcome.pose.position - task.pose.position).norm() < 1e-9);
        let read = outcome.tensions.unwrap();
        assert!(read.iter().zip(&stage.tensions).all(|(a, b)| (a - b).abs() < 1e-5), "{read:?} {stage:?}");
    }
    let change = |cable: usize| way.stages[4].offsets[cable] - way.stages[0].offsets[cable];
    assert!(way.order.windows(2).all(|pair| change(pair[0]) >= change(pair[1])), "{way:?}");
    assert!(way.largest_displacement > 1e-6 && way.largest_displacement < 0.1, "{}", way.largest_displacement);
}

#[test]
fn rigid_machines_have_no_initial_tensions() {
    let planar = Planar::new();
    let task = Task { machine: &planar.control, ..planar.task() };
    let refused = fit(&task, &[0.0; 4], &by_method(Method::ClosedForm), &planar.circle());
    assert_eq!(refused, Err(InputError::RigidMachine));
}

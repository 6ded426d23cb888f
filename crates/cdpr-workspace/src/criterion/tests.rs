//! Laws of the criteria on built-in robots.

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::{All, Any, Criterion, MinimumStiffness, StaticStability, WrenchClosure, WrenchFeasible, WrenchSetFeasible};
use cdpr_model::geometry::Pose;
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::Robot;
use cdpr_model::statics::Load;
use cdpr_model::tension::Limits;

fn standard(name: &str) -> Model {
    Model::new(Robot::builtin(name).unwrap(), Composition::STANDARD).unwrap()
}

fn moved(limits: &Limits, t: f64) -> Limits {
    let minimum = limits.minimum().iter().map(|f| f + t).collect();
    Limits::new(minimum, limits.maximum().iter().map(|f| f - t).collect()).unwrap()
}

/// Poses around the middle of the frame, one in three of them outside.
fn poses(model: &Model, count: usize, seed: u64) -> Vec<Pose> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let cables = &model.robot().cables;
    let middle = cables.iter().map(|cable| cable.frame_anchor).sum::<Vector3<f64>>() / cables.len() as f64;
    let anchors = || cables.iter().map(|cable| (cable.frame_anchor - middle).abs());
    let half = anchors().fold(Vector3::zeros(), |most, size| most.sup(&size));
    let has_rotation = model.robot().motion_pattern.has_rotation();
    let angle = if has_rotation { 0.3 } else { 0.0 };
    (0..count)
        .map(|_| {
            let position = middle + half.map(|half| half * rng.random_range(-1.1..1.1));
            Pose::from_xyz_angles(position, [0, 1, 2].map(|_| angle * rng.random_range(-1.0..=1.0)))
        })
        .collect()
}

/// The margin is the narrowing at which tensions cease to exist, on both sides of the boundary.
#[test]
fn limits_narrowed_by_less_than_the_margin_leave_tensions_and_by_more_leave_none() {
    for (name, seed) in
        [("planar-example", 1), ("cablerobot-simulator-icosahedron", 2), ("cogiro", 3), ("ipanema-1", 4)]
    {
        let model = standard(name);
        let limits = Limits::of(model.robot(), None, None).unwrap();
        let load = Load::of(model.robot()).unwrap();
        let narrowed = |t: f64| WrenchFeasible::new(&model, &load, &moved(&limits, t)).unwrap();
        let criterion = WrenchFeasible::new(&model, &load, &limits).unwrap();
        let (mut held, mut failed) = (0, 0);
        for pose in poses(&model, 60, seed) {
            let verdict = criterion.judge(&pose);
            assert_eq!(verdict.holds(), criterion.holds(&pose), "{name}");
            assert_eq!(verdict.holds(), verdict.reason.is_none(), "{name}");
            (held, failed) = (held + i32::from(verdict.holds()), failed + i32::from(!verdict.holds()));
            // the programme keeps limits to 1e-10 of their size; the step to the boundary is a thousand times that
            let step = 1e-7 * limits.maximum()[0].max(verdict.margin.abs());
            assert!(narrowed(verdict.margin - step).holds(&pose), "{name} {verdict:?}");
            let range = limits.maximum()[0] - limits.minimum()[0];
            if verdict.margin + step < 0.5 * range {
                assert!(!narrowed(verdict.margin + step).holds(&pose), "{name} {verdict:?}");
            }
        }
        // the frame of cogiro is flat: nothing hangs as high as its anchors; ipanema-1 has narrow limits
        assert!(
            (held > 5 || name == "cogiro" || name == "ipanema-1") && failed > 5,
            "{name}: {held} held, {failed} failed"
        );
    }
}

/// A point platform in the plane is held by four cables exactly inside the convex hull of the frame anchors.
#[test]
fn a_point_has_wrench_closure_inside_the_hull_of_the_anchors() {
    let model = standard("planar-example");
    let closure = WrenchClosure::new(&model).unwrap();
    let corners: Vec<_> = [0, 2, 3, 1].iter().map(|&cable| model.robot().cables[cable].frame_anchor).collect();
    for pose in poses(&model, 300, 5) {
        let r = Pose { position: Vector3::new(pose.position.x, pose.position.y, 0.0), ..pose };
        let left = |k: usize| {
            let (from, to) = (corners[k], corners[(k + 1) % 4]);
            (to - from).cross(&(r.position - from)).z
        };
        let inside = (0..4).map(left).fold(f64::INFINITY, f64::min) > 0.0;
        let verdict = closure.judge(&r);
        assert_eq!(verdict.holds(), inside, "{r:?} {verdict:?}");
        assert_eq!(closure.holds(&r), inside);
    }
}

/// Cables that all come from above cannot pull against each other.
#[test]
fn a_suspended_robot_has_no_wrench_closure_and_a_constrained_one_has_it_at_home() {
    let (suspended, constrained) = (standard("cogiro"), standard("cablerobot-simulator-icosahedron"));
    let verdict = |model: &Model| WrenchClosure::new(model).unwrap().judge(&model.robot().home.unwrap());
    assert!(!verdict(&suspended).holds());
    assert!(verdict(&suspended).reason.is_some());
    let held = verdict(&constrained);
    assert!(held.holds() && held.margin <= 1.0, "{held:?}");
}

/// A cable without a path gives a verdict with its number, not a panic.
#[test]
fn a_platform_on_an_anchor_fails_with_the_cable_that_has_no_path() {
    let model = standard("planar-example");
    let criterion =
        WrenchFeasible::new(&model, &Load::of(model.robot()).unwrap(), &Limits::uniform(4, 1e3, 8e3).unwrap());
    let pose = Pose { position: model.robot().cables[2].frame_anchor, ..Pose::identity() };
    for verdict in [criterion.unwrap().judge(&pose), WrenchClosure::new(&model).unwrap().judge(&pose)] {
        assert_eq!((verdict.holds(), verdict.cable), (false, Some(2)));
        assert!(verdict.reason.unwrap().contains("cable 3"));
    }
}

#[test]
fn joined_criteria_hold_where_all_and_where_one_of_them_hold() {
    let model = standard("planar-example");
    let (load, limits) = (Load::of(model.robot()).unwrap(), Limits::of(model.robot(), None, None).unwrap());
    let feasible = || WrenchFeasible::new(&model, &load, &limits).unwrap();
    let closure = || WrenchClosure::new(&model).unwrap();
    let pair = || -> Vec<Box<dyn Criterion + '_>> { vec![Box::new(feasible()), Box::new(closure())] };
    let (all, any) = (All::new(pair()).unwrap(), Any::new(pair()).unwrap());
    let poses = poses(&model, 200, 6);
    let (mut by_all, mut by_any) = (vec![false; 200], vec![true; 200]);
    all.holds_all(&poses, &mut by_all);
    any.holds_all(&poses, &mut by_any);
    for (index, pose) in poses.iter().enumerate() {
        let (first, second) = (feasible().holds(pose), closure().holds(pose));
        assert_eq!((by_all[index], by_any[index]), (first && second, first || second));
        let (all, any) = (all.judge(pose), any.judge(pose));
        assert_eq!((all.holds(), any.holds()), (first && second, first || second));
        assert_eq!((all.reason.is_some(), any.reason.is_some()), (!all.holds(), !any.holds()));
    }
    assert!(All::new(Vec::new()).is_err());
}

/// A search without a given step relies on it; with a fixed effort it took fifteen times the time allowed.
#[test]
fn criteria_that_choose_tensions_take_longer_with_cables_that_sag() {
    let mut robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    robot.cables.iter_mut().for_each(|cable| cable.linear_density = Some(0.1));
    let [straight, sagging] =
        ["elastic", "elastic+catenary"].map(|effects| Model::new(robot.clone(), effects.parse().unwrap()).unwrap());
    let load = Load::of(&robot).unwrap();
    let limits = Limits::uniform(8, 1000.0, 9000.0).unwrap();
    let efforts = |model| {
        let stiff = MinimumStiffness::new(model, &load, &limits, 1.0, None).unwrap();
        let stable = StaticStability::new(model, &load, &limits, None).unwrap();
        [WrenchFeasible::new(model, &load, &limits).unwrap().effort(), stiff.effort(), stable.effort()]
    };
    assert_eq!(efforts(&straight), [1.0, 100.0, 100.0]);
    assert_eq!(efforts(&sagging), [1e4; 3]);
}

/// The sets of many cables have thousands of facets: a search without a given step takes that into account.
#[test]
fn wrench_sets_of_many_cables_take_longer() {
    let robot = Robot::builtin("cogiro").unwrap();
    let effort = |cables: usize| {
        let mut robot = robot.clone();
        robot.cables = robot.cables.iter().cycle().take(cables).cloned().collect();
        let model = Model::new(robot, Composition::STANDARD).unwrap();
        let (limits, load) =
            (Limits::uniform(cables, 1000.0, 9000.0).unwrap(), Load::constant(cdpr_model::geometry::Wrench::zeros()));
        WrenchSetFeasible::with_ball(&model, &limits, &load, [10.0, 1.0], None).map(|criterion| criterion.effort())
    };
    // C(8, 5) = 56 and C(24, 5) = 42504
    assert_eq!([effort(8).unwrap(), effort(24).unwrap()], [300.0, 300.0 * 42504.0 / 56.0]);
    assert!(effort(25).is_err());
}

//! Lengths, wraps and distances, checked with points sampled along the cables.

use super::*;
use cdpr_model::robot::{Pulley, WrapSide};

/// Points of every cable's free part, 0 at the outlet and `count` at the platform.
fn sampled(model: &Model, pose: &Pose, count: usize) -> Vec<Vec<Vector3<f64>>> {
    (0..model.cable_count())
        .map(|cable| {
            let (path, moment_arm) = model.path(cable, pose).unwrap();
            let anchor = pose.position + moment_arm;
            let outlet = anchor + Vector3::from(path.direction) * path.free_length;
            (0..=count).map(|step| outlet + (anchor - outlet) * (step as f64 / count as f64)).collect()
        })
        .collect()
}

#[test]
fn cables_are_as_near_to_each_other_as_their_sampled_points() {
    for model in
        [model("cablerobot-simulator-helicopter", Composition::STANDARD), model("cucablerobot", Composition::PULLEY)]
    {
        let criterion = CableInterference::new(&model, 0.0, Some(0.0)).unwrap();
        for pose in poses(&model, 6, 0.5, 93) {
            let cables = sampled(&model, &pose, 300);
            let mut nearest = f64::INFINITY;
            for (first, a) in model.robot().cables.iter().enumerate() {
                for (second, b) in model.robot().cables.iter().enumerate().skip(first + 1) {
                    if a.frame_anchor == b.frame_anchor || a.platform_anchor == b.platform_anchor {
                        continue;
                    }
                    for p in &cables[first] {
                        nearest = cables[second].iter().map(|q| (p - q).norm()).fold(nearest, f64::min);
                    }
                }
            }
            let margin = criterion.judge(&pose).margin;
            // a step along a cable of 15 m is 50 mm; two cables that cross are off by less than one of them
            assert!(margin <= nearest + 1e-12 && nearest < margin + 0.05, "{margin} {nearest}");
        }
    }
}

#[test]
fn cables_are_as_far_from_obstacles_as_their_sampled_points() {
    let model = model("cablerobot-simulator-helicopter", Composition::STANDARD);
    let criterion = CableObstacles::new(&model, 0.0, Some(0.0)).unwrap();
    let (mut through, mut past) = (0, 0);
    for pose in poses(&model, 40, 2.0, 94) {
        let points = sampled(&model, &pose, 4000);
        let mut nearest = f64::INFINITY;
        for point in points.iter().flatten() {
            for obstacle in &model.robot().obstacles {
                nearest = nearest.min(match obstacle.shape {
                    ObstacleShape::Box { min, max } => {
                        let place = (point - (min + max) * 0.5).abs() - (max - min) * 0.5;
                        let outside = place.map(|x| x.max(0.0)).norm();
                        if outside > 0.0 { outside } else { place.max() }
                    }
                    ObstacleShape::Strut { from, to, radius } => {
                        let part = ((point - from).dot(&(to - from)) / (to - from).norm_squared()).clamp(0.0, 1.0);
                        (from + (to - from) * part - point).norm() - radius
                    }
                });
            }
        }
        let verdict = criterion.judge(&pose);
        // 15 m in 4000 steps
        assert!(verdict.margin <= nearest + 1e-12 && nearest < verdict.margin + 0.004, "{verdict:?} {nearest}");
        *(if verdict.holds() { &mut past } else { &mut through }) += 1;
    }
    assert!(through > 5 && past > 5, "{through} {past}");
}

/// An obstacle that carries a cable's outlet is not judged against that cable, but against others.
#[test]
fn an_obstacle_under_a_frame_anchor_carries_it() {
    let mut robot = complete("cablerobot-simulator-helicopter");
    let anchor = robot.cables[0].frame_anchor;
    let shape = ObstacleShape::Strut { from: anchor, to: anchor + Vector3::z(), radius: 0.1 };
    robot.obstacles = vec![Obstacle { name: "post".to_owned(), shape }];
    let home = robot.home_or_middle();
    let model = Model::new(robot, Composition::STANDARD).unwrap();
    assert!(CableObstacles::new(&model, 0.01, None).unwrap().holds(&home));
    let mut other = model.robot().clone();
    let b = home.transform(&other.cables[1].platform_anchor);
    other.cables[1].frame_anchor = b + (anchor - b) * 1.5;
    let model = Model::new(other, Composition::STANDARD).unwrap();
    let verdict = CableObstacles::new(&model, 0.01, None).unwrap().judge(&home);
    assert_eq!((verdict.holds(), verdict.cable), (false, Some(1)), "{verdict:?}");
    assert!(verdict.reason.unwrap().contains("\"post\""));
}

/// A cable towards the platform's middle runs into the platform; the hull of the anchors shows it.
#[test]
fn a_cable_that_runs_through_the_platform_is_found() {
    let mut robot = complete("cablerobot-simulator-helicopter");
    let middle = robot.cables.iter().map(|cable| cable.platform_anchor).sum::<Vector3<f64>>() / 8.0;
    let (home, b) = (robot.home_or_middle(), robot.cables[4].platform_anchor);
    // the frame anchor on the other side of the middle
    robot.cables[4].frame_anchor = home.transform(&(b + (middle - b) * 20.0));
    let model = Model::new(robot, Composition::STANDARD).unwrap();
    let verdict = PlatformInterference::new(&model, 0.0).unwrap().judge(&home);
    assert_eq!((verdict.holds(), verdict.cable), (false, Some(4)), "{verdict:?}");
    assert!(verdict.reason.unwrap().contains("runs into the platform"));
    // sampled: 1 mm along the cable it is below all planes through faces at the anchor; it meets a larger body too
    let mut large = model.robot().clone();
    let away = |k: i32| Vector3::new(f64::from(k & 1) - 0.5, f64::from(k >> 1 & 1) - 0.5, f64::from(k >> 2) - 0.5);
    large.platform.hull = Some((0..8).map(|k| middle + away(k) * 0.05).collect());
    let large = Model::new(large, Composition::STANDARD).unwrap();
    let small_body = PlatformInterference::new(&large, 0.0).unwrap().judge(&home);
    assert_eq!((small_body.holds(), small_body.cable), (false, Some(4)), "{small_body:?}");
}

/// Points sampled on the platform's surface and in a crate are no nearer to each other than the margin, and a
/// translation by minus the margin removes an overlap.
#[test]
fn a_platform_is_as_far_from_obstacles_as_its_sampled_points() {
    let mut robot = complete("cablerobot-simulator-helicopter");
    robot.platform.hull = Some((0..8).map(|k| Vector3::new(0.6, 0.4, 0.3).component_mul(&corner(k))).collect());
    let ObstacleShape::Box { min, max } = robot.obstacles[0].shape else { panic!("a crate") };
    robot.obstacles.truncate(1);
    let model = Model::new(robot, Composition::STANDARD).unwrap();
    let criterion = PlatformObstacles::new(&model, 0.02).unwrap();
    let mut rng = ChaCha8Rng::seed_from_u64(97);
    let (mut held, mut failed) = (0, 0);
    for pose in poses(&model, 60, 1.0, 98) {
        let margin = criterion.judge(&pose).margin;
        let distance = margin + 0.02;
        let mut nearest = f64::INFINITY;
        for _ in 0..4000 {
            let place =
                Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0)).component_mul(&Vector3::new(0.6, 0.4, 0.3));
            let point = pose.transform(&place);
            let outside = Vector3::from_fn(|axis, _| (min[axis] - point[axis]).max(point[axis] - max[axis]).max(0.0));
            nearest = nearest.min(outside.norm());
        }
        // of 4000 points in 0.6 m³ one lies within 0.15 m of any point
        assert!(nearest >= distance.max(0.0) - 1e-12 && nearest < distance.max(0.0) + 0.15, "{nearest} {distance}");
        *(if margin >= 0.0 { &mut held } else { &mut failed }) += 1;
    }
    assert!(held > 5 && failed > 5, "{held} {failed}");
}

fn corner(k: i32) -> Vector3<f64> {
    Vector3::new(f64::from(k & 1), f64::from(k >> 1 & 1), f64::from(k >> 2)) * 2.0 - Vector3::repeat(1.0)
}

#[test]
fn lengths_and_wraps_are_those_of_the_model() {
    let model = model("cucablerobot", Composition::PULLEY);
    let (lengths, wraps) =
        (LengthLimits::new(&model, None, None).unwrap(), WrapLimits::new(&model, None, None).unwrap());
    for pose in poses(&model, 50, 1.5, 95) {
        let (mut least, mut turn) = (f64::INFINITY, f64::INFINITY);
        for cable in 0..model.cable_count() {
            let path = model.path(cable, &pose).unwrap().0;
            least = least.min(path.length - 0.5).min(12.0 - path.length);
            turn = turn.min(path.wrap_angle - 0.2).min(3.0 - path.wrap_angle);
        }
        assert!(
            (lengths.judge(&pose).margin - least).abs() < 1e-12 && (wraps.judge(&pose).margin - turn).abs() < 1e-12
        );
    }
    let short = LengthLimits::new(&model, None, Some(0.7)).unwrap().judge(&model.robot().home_or_middle());
    assert!(short.reason.unwrap().contains("at most 0.7 m"));
    let wide = WrapLimits::new(&model, Some(3.1), Some(3.2)).unwrap().judge(&model.robot().home_or_middle());
    assert!(wide.reason.unwrap().contains("at least 177.62°"));
}

/// Along a line into each degenerate pose, the margin falls to zero where the paths end.
#[test]
fn validity_ends_where_courses_end() {
    let mut planar = complete("planar-example");
    let axis = planar.plane.second_axis();
    for cable in &mut planar.cables {
        cable.pulley = Some(Pulley::Whole { radius: 0.2, swivel_axis: axis.into() });
        cable.pulley_wrap_side = Some(WrapSide::Right);
    }
    let models = [
        Model::new(planar.clone(), Composition::STANDARD).unwrap(),
        Model::new(planar, Composition::PULLEY).unwrap(),
        model("cucablerobot", Composition::PULLEY),
    ];
    let mut rng = ChaCha8Rng::seed_from_u64(96);
    for model in models {
        let criterion = ModelValidity::new(&model);
        let mut failed = 0;
        for case in 0..400 {
            // a platform anchor near an outlet
            let cable = case % model.cable_count();
            let data = &model.robot().cables[cable];
            let near = 2.5 * data.pulley_radius().unwrap_or(0.2);
            let around: Vector3<f64> = model.axes().iter().map(|axis| axis * rng.random_range(-near..near)).sum();
            let pose = Pose { position: data.frame_anchor + around - data.platform_anchor, ..Pose::identity() };
            let verdict = criterion.judge(&pose);
            let has_paths = (0..model.cable_count()).all(|cable| model.path(cable, &pose).is_ok());
            assert_eq!(verdict.holds(), has_paths, "{verdict:?}");
            assert!(verdict.margin.is_finite() && verdict.margin.abs() < 10.0, "{verdict:?}");
            failed += usize::from(!has_paths);
            // a margin above half a millimetre is not exhausted by a step of a tenth
            if verdict.margin > 5e-4 {
                let step = model.twist_basis()[0] * 1e-4;
                assert!(criterion.holds(&pose.displaced(&step)) && criterion.holds(&pose.displaced(&-step)));
            }
        }
        let on_outlet = Pose {
            position: model.robot().cables[1].frame_anchor - model.robot().cables[1].platform_anchor,
            ..Pose::identity()
        };
        let verdict = criterion.judge(&on_outlet);
        assert_eq!((verdict.holds(), verdict.cable), (false, Some(1)), "{verdict:?}");
        assert!(model.composition() == Composition::STANDARD || failed > 5, "{failed}");
    }
}

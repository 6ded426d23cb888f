//! Pulleys of planar robots that do not swivel: the side on which the cable wraps decides.

use super::*;

/// A planar robot in the xz plane with one cable over a pulley on the given side of the rising cable.
pub(super) fn planar_robot(side: WrapSide) -> Robot {
    let cable = Cable {
        frame_anchor: Vector3::new(-2.0, 0.0, 3.0),
        platform_anchor: Vector3::new(0.3, 0.0, 0.1),
        pulley: Some(Pulley::Whole { radius: 0.12, swivel_axis: Vector3::z().into() }),
        pulley_wrap_side: Some(side),
        ..tilted_pulley_cable()
    };
    let plane = Plane::from_axes("xz").unwrap();
    Robot { motion_pattern: MotionPattern::Planar, plane, ..robot_of(vec![cable]) }
}

/// Platform poses on both sides of the rising cable, above and below the entry, except on the open side.
pub(super) fn planar_poses() -> Vec<Pose> {
    let turned = |x: f64, z: f64| Pose::from_xyz_angles(Vector3::new(x, 0.0, z), [0.0, 0.3, 0.0]);
    vec![turned(0.0, 0.0), turned(1.0, 4.0), turned(-2.2, 1.0), turned(-4.0, 1.5), turned(-2.25, 5.0)]
}

#[test]
fn derivatives_over_a_pulley_that_does_not_swivel_agree_with_dual_numbers() {
    for pose in planar_poses() {
        check_derivatives(&planar_robot(WrapSide::Right), &pose, true);
        let mirrored =
            Pose { position: pose.position + Vector3::x() * (2.0 * (-2.3 - pose.position.x)), rotation: pose.rotation };
        check_derivatives(&planar_robot(WrapSide::Left), &mirrored, true);
    }
}

/// On the side to which a swivelling pulley would turn, both are the same; on the other side the cable wraps further.
#[test]
fn a_pulley_that_does_not_swivel_differs_beyond_its_entry_only() {
    let robot = planar_robot(WrapSide::Right);
    let mut swivelling = robot.clone();
    swivelling.cables[0].pulley_wrap_side = None;
    let [fixed, swivelling] = [robot, swivelling].map(|robot| Model::new(robot, Composition::PULLEY).unwrap());
    for pose in planar_poses() {
        let (on_side, turned) = (fixed.path(0, &pose).unwrap().0, swivelling.path(0, &pose).unwrap().0);
        let beyond = (pose.transform(&fixed.robot().cables[0].platform_anchor)).x < -2.0;
        assert_eq!(on_side.wrap_angle > turned.wrap_angle + 1e-9, beyond, "{pose:?}");
        assert!(beyond || (on_side.length - turned.length).abs() < 1e-14);
        // the free part is tangent to the circle, whose centre is to the right of the entry
        let center = Vector3::new(-2.0 + 0.12, 0.0, 3.0);
        let anchor = pose.transform(&fixed.robot().cables[0].platform_anchor);
        let contact = anchor + Vector3::from(on_side.direction) * on_side.free_length;
        assert!(((contact - center).norm() - 0.12).abs() < 1e-14);
        assert!((contact - center).dot(&Vector3::from(on_side.direction)).abs() < 1e-14);
    }
    assert_eq!(fixed.swivel_angle(0, &planar_poses()[0], &Vector3::x()), None);
}

#[test]
fn the_open_side_of_a_pulley_and_spatial_wrap_sides_are_refused() {
    use crate::cable::GeometryError as Reason;
    let model = Model::new(planar_robot(WrapSide::Right), Composition::PULLEY).unwrap();
    let left_above = Pose { position: Vector3::new(-4.0, 0.0, 5.0), ..Pose::identity() };
    assert_eq!(model.path(0, &left_above).unwrap_err(), Reason::OpenSide { cable: 1 });
    assert!(model.path_or_nan(0, &left_above).0.length.is_nan());
    let inside = Pose { position: Vector3::new(-2.3 + 0.1, 0.0, 2.9), ..Pose::identity() };
    assert_eq!(model.path(0, &inside).unwrap_err(), Reason::InsidePulley { cable: 1, radius: 0.12 });

    let spatial = robot_of(planar_robot(WrapSide::Right).cables);
    let refused = Model::new(spatial, Composition::PULLEY).unwrap_err();
    assert!(matches!(refused, ModelError::SpatialWrapSide { cable: 1, .. }), "{refused}");
    let mut mixed = planar_robot(WrapSide::Right);
    mixed.cables.push(Cable { pulley_wrap_side: None, ..mixed.cables[0].clone() });
    let refused = Model::new(mixed, Composition::PULLEY).unwrap_err().to_string();
    assert!(refused.contains("pulley_wrap_side") && refused.contains("cable 2"), "{refused}");
}

/// With r_p → 0 the pulley is a point, for any position of the anchor.
#[test]
fn radius_zero_is_a_point_also_without_a_swivel() {
    let mut robot = planar_robot(WrapSide::Right);
    robot.cables[0].set_pulley_radius(0.0);
    let [pulley, point] = [Composition::PULLEY, Composition::STANDARD].map(|effects| {
        let model = Model::new(robot.clone(), effects).unwrap();
        planar_poses().iter().map(|pose| model.path(0, pose).unwrap().0).collect::<Vec<_>>()
    });
    for (pulley, point) in pulley.iter().zip(&point) {
        assert!((pulley.length - point.length).abs() < 1e-14);
        for k in [0, 2] {
            assert!((pulley.direction[k] - point.direction[k]).abs() < 1e-14);
            for column in [0, 2] {
                let (found, expected) = (pulley.direction_gradient[k][column], point.direction_gradient[k][column]);
                assert!((found - expected).abs() < 1e-13);
            }
        }
    }
}

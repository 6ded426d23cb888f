//! Robots as points: data of one orientation R tell the anchors only by a − R b (sec. 6.3).

use nalgebra::{UnitQuaternion, Vector3};

use cdpr_model::geometry::{MotionPattern, Pose};
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Robot;

/// Pattern without the rotations; `None` for one that has none.
pub fn point_pattern(pattern: MotionPattern) -> Option<MotionPattern> {
    match pattern {
        MotionPattern::Spatial => Some(MotionPattern::SpatialPoint),
        MotionPattern::Planar => Some(MotionPattern::PlanarPoint),
        _ => None,
    }
}

/// The robot with the anchors a − R b and b = 0; `None` for one whose platform does not turn.
pub(super) fn point_robot(robot: &Robot, rotation: &UnitQuaternion<f64>) -> Option<Robot> {
    let mut point = robot.clone();
    point.motion_pattern = point_pattern(robot.motion_pattern)?;
    for cable in &mut point.cables {
        cable.frame_anchor -= rotation * cable.platform_anchor;
        cable.platform_anchor = Vector3::zeros();
    }
    point.home = point.home.map(|home| Pose { rotation: UnitQuaternion::identity(), ..home });
    Some(point)
}

/// The same of a model whose platform anchors vanish: no length tells its rotation.
pub(super) fn as_point(model: &Model) -> Option<Model> {
    let is_point = model.robot().cables.iter().all(|cable| cable.platform_anchor == Vector3::zeros());
    let robot = is_point.then(|| point_robot(model.robot(), &UnitQuaternion::identity()))??;
    Model::new(robot, model.composition()).ok()
}

/// Samples of a point.
pub fn without_rotation(samples: &Samples) -> Samples {
    let mut samples = samples.clone();
    samples.poses.iter_mut().for_each(|pose| pose.rotation = UnitQuaternion::identity());
    samples
}

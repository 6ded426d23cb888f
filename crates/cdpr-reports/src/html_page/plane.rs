//! The plane of a planar robot, as pages draw it.

use cdpr_model::robot::Robot;
use serde::Serialize;

/// Letters and world directions of a planar robot's axes.
#[derive(Serialize)]
pub(crate) struct PlaneData {
    names: Vec<String>,
    first: [f64; 3],
    second: [f64; 3],
}

impl PlaneData {
    /// Plane of a robot; `None` for a spatial one.
    pub(crate) fn of(robot: &Robot) -> Option<Self> {
        robot.motion_pattern.is_planar().then(|| Self {
            names: robot.plane.axes().chars().map(String::from).collect(),
            first: robot.plane.first_axis().into(),
            second: robot.plane.second_axis().into(),
        })
    }
}

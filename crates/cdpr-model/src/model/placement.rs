//! Pulleys placed so that their contact points are the anchors of the point model.

use nalgebra::Vector3;
use thiserror::Error;

use crate::cable::outlet::pulley::{self, PlacementError};
use crate::geometry::Pose;
use crate::robot::{Pulley, Robot};

/// Reason that pulleys cannot be placed.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum PlacePulleysError {
    /// The pulley of a cable has no unique position.
    #[error("cable {cable}: {reason}; choose another pose or swivel axis")]
    Cable {
        /// Number of the cable, from 1.
        cable: usize,
        /// Reason that the position is not unique.
        reason: PlacementError,
    },
    /// A negative or infinite radius, or an axis that is no unit vector.
    #[error(
        "cable {cable}: a pulley needs a radius of 0 or more and an axis of length 1, found radius {radius} m and axis length {axis_length}"
    )]
    Input {
        /// Number of the cable, from 1.
        cable: usize,
        /// The radius (m).
        radius: f64,
        /// The length of the axis.
        axis_length: f64,
    },
}

/// The robot with a pulley at every cable, each placed so that the contact point at `pose` is the published frame
/// anchor.
///
/// `pulleys` gives radius (m) and unit swivel axis (world) per cable. Lengths, directions and structure matrix at
/// `pose` then agree with the point model, except for the wrapped length (sec. 3.8). A pulley with `pulley_wrap_side`
/// stays on its side.
pub fn place_pulleys(robot: &Robot, pulleys: &[(f64, Vector3<f64>)], pose: &Pose) -> Result<Robot, PlacePulleysError> {
    let mut placed = robot.clone();
    for (index, (cable, &(radius, axis))) in placed.cables.iter_mut().zip(pulleys).enumerate() {
        let number = index + 1;
        // written so that NaN is refused too
        if !(radius >= 0.0 && radius.is_finite() && (axis.norm() - 1.0).abs() < 1e-6) {
            return Err(PlacePulleysError::Input { cable: number, radius, axis_length: axis.norm() });
        }
        let anchor = pose.transform(&cable.platform_anchor);
        let outlet = cable.frame_anchor.into();
        let entry = match cable.pulley_wrap_side.map(|side| robot.side_of(&axis, side)) {
            Some(side) => pulley::place_on_side(outlet, axis.into(), side.into(), radius, anchor.into()),
            None => pulley::place(outlet, axis.into(), radius, anchor.into()),
        };
        let entry = entry.map_err(|reason| PlacePulleysError::Cable { cable: number, reason })?;
        cable.frame_anchor = entry.into();
        cable.pulley = Some(Pulley::Whole { radius, swivel_axis: axis.into() });
    }
    Ok(placed)
}

//! Whether a model is good enough to be announced at all.

use super::evaluation::ErrorBlocks;
use crate::measurement::{SensorSigmas, three_digits};
use crate::robot::Robot;

/// Largest mean error, as a share of the diagonal of the anchors' box.
const LARGEST_SHARE: f64 = 0.01;
/// Largest mean error, as a multiple of the stated accuracy of the poses.
const LARGEST_MULTIPLE: f64 = 5.0;

/// Reasons not to trust a model with its errors.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Distrust {
    /// A sentence each; empty where there is none.
    pub reasons: Vec<String>,
    /// Whether the errors are no longer those of a robot of this size: then the answer is no.
    pub is_gross: bool,
}

/// Reasons not to trust a model with these errors.
///
/// A mean error above a hundredth of the robot's size, or above five times the accuracy that is stated for the measured poses, is no
/// error of a model but of its data, of the robot file, or of what the model leaves out.
pub fn distrust(robot: &Robot, sigmas: &SensorSigmas, errors: &ErrorBlocks) -> Distrust {
    let position = errors.position_error_m.mean;
    let (error, name) = match position.is_nan() {
        true => (errors.length_error_m.mean_abs, "cable-length"),
        false => (position, "position"),
    };
    let limit = LARGEST_SHARE * robot.anchor_diagonal();
    let (mut reasons, is_gross) = (Vec::new(), error > limit);
    if is_gross {
        reasons.push(format!(
            "not to be trusted: the mean {name} error, {} mm, is above 1 % of the diagonal of the anchors' box, {} mm: \
             are the data, their frame, their clock and the robot file right?",
            three_digits(1e3 * error),
            three_digits(1e3 * limit)
        ));
    }
    let rotation = errors.rotation_error_rad.mean;
    for (error, sigma, name, factor, unit) in [
        (position, sigmas.position, "position", 1e3, " mm"),
        (rotation, sigmas.rotation, "rotation", 1f64.to_degrees(), "°"),
    ] {
        let Some(sigma) = sigma.filter(|sigma| *sigma > 0.0 && error > LARGEST_MULTIPLE * sigma) else { continue };
        reasons.push(format!(
            "not to be trusted: the mean {name} error, {}{unit}, is {} times the accuracy that is stated for the poses, {}{unit}: \
             the model lacks something, or data or accuracy are wrong",
            three_digits(factor * error),
            three_digits(error / sigma),
            three_digits(factor * sigma)
        ));
    }
    Distrust { reasons, is_gross }
}

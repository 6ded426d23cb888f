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
/// error of a model but of its data, of the robot file, or of what the model leaves out. Nor is one to be trusted that predicts less than half of the
/// poses, though the robot has as many cables as degrees of freedom.
pub fn distrust(robot: &Robot, sigmas: &SensorSigmas, errors: &ErrorBlocks) -> Distrust {
    let position = errors.position_error_m.mean;
    let (error, name) = match position.is_nan() {
        true => (errors.length_error_m.mean_abs, "cable-length"),
        false => (position, "position"),
    };
    let limit = LARGEST_SHARE * robot.anchor_diagonal();
    let (mut reasons, is_gross) = (Vec::new(), error > limit);
    let (answered, all) = (errors.answered, errors.answered + errors.not_converged);
    // fewer cables than degrees of freedom determine no pose, and are judged by their lengths
    let is_determined = robot.cable_count() >= robot.motion_pattern.dof();
    let predicts_nothing = is_determined && answered == 0 && all > 0;
    if is_determined && 2 * answered < all {
        reasons.push(format!(
            "not to be trusted: the model predicts a pose from the recorded lengths of {answered} of {all} samples, so that its errors are those of few or \
             none: the data do not hold its parameters, or data or robot file are wrong"
        ));
    }
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
    Distrust { reasons, is_gross: is_gross || predicts_nothing }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::identification::evaluation::Evaluation;

    /// Of nine samples one, none and five with a predicted pose.
    #[test]
    fn a_model_that_predicts_few_poses_is_not_trusted() {
        let robot = Robot::builtin("planar-example").unwrap();
        let of = |robot: &Robot, answered: usize| {
            let errors = ErrorBlocks { answered, not_converged: 9 - answered, ..Evaluation::default().blocks() };
            distrust(robot, &SensorSigmas::default(), &errors)
        };
        assert!(of(&robot, 1).reasons[0].contains("of 1 of 9 samples") && !of(&robot, 1).is_gross);
        assert!(of(&robot, 0).is_gross);
        assert_eq!(of(&robot, 5), Distrust::default());
        // one cable leaves a plane open, whatever it says
        let mut hanging = robot.clone();
        hanging.cables.truncate(1);
        assert_eq!(of(&hanging, 0), Distrust::default());
    }
}

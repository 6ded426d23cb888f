//! Whether a model is good enough to be announced at all.

use super::evaluation::ErrorBlocks;
use super::verdict::{Doubt, DoubtKind};
use cdpr_model::measurement::{SensorSigmas, three_digits};
use cdpr_model::robot::Robot;

/// Largest mean error, as a share of the diagonal of the anchors' box.
const LARGEST_SHARE: f64 = 0.01;
/// Largest mean error, as a multiple of the stated accuracy.
const LARGEST_MULTIPLE: f64 = 5.0;

/// Reasons not to trust a model with its errors; empty if they are empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Distrust {
    /// A sentence each.
    pub reasons: Vec<Doubt>,
}

impl Distrust {
    fn add(&mut self, kind: DoubtKind, words: impl FnOnce() -> String) {
        self.reasons.push(Doubt::new(kind, format!("not to be trusted: {}", words())));
    }
}

/// Reasons not to trust a model with these errors.
///
/// A mean error above a hundredth of the robot's size, or above five times the accuracy that is stated for the measured poses (of lengths, where no pose is
/// measured), is no error of a model but of its data, of the robot file, or of what the model leaves out. Nor is one to be trusted that predicts less than half
/// of the poses, though the robot has as many cables as degrees of freedom.
pub fn distrust(robot: &Robot, sigmas: &SensorSigmas, errors: &ErrorBlocks) -> Distrust {
    let position = errors.position_error_m.mean;
    let (error, name) = match position.is_nan() {
        true => (errors.length_error_m.mean_abs, "cable-length"),
        false => (position, "position"),
    };
    let limit = LARGEST_SHARE * robot.anchor_diagonal();
    let mut distrust = Distrust::default();
    let (answered, all) = (errors.answered, errors.answered + errors.not_converged);
    // fewer cables than degrees of freedom determine no pose, and are judged by their lengths
    let is_determined = robot.cable_count() >= robot.motion_pattern.dof();
    if is_determined && 2 * answered < all {
        distrust.add(DoubtKind::FewPoses, || {
            format!(
                "the model predicts a pose from the recorded lengths of {answered} of {all} samples, so that its errors are those of few or \
                 none: the data do not hold its parameters, or data or robot file are wrong"
            )
        });
    }
    if error > limit {
        distrust.add(DoubtKind::Gross, || {
            format!(
                "the mean {name} error, {} mm, is above 1 % of the diagonal of the anchors' box, {} mm: \
                 are the data, their frame, their clock and the robot file right?",
                three_digits(1e3 * error),
                three_digits(1e3 * limit)
            )
        });
    }
    let rotation = errors.rotation_error_rad.mean;
    for (error, sigma, name, factor, unit) in [
        (position, sigmas.position, "position", 1e3, " mm"),
        (rotation, sigmas.rotation, "rotation", 1f64.to_degrees(), "°"),
    ] {
        let Some(sigma) = sigma.filter(|sigma| *sigma > 0.0 && error > LARGEST_MULTIPLE * sigma) else { continue };
        distrust.add(DoubtKind::BeyondAccuracy, || {
            format!(
                "the mean {name} error, {}{unit}, is {} times the accuracy that is stated for the poses, {}{unit}: \
                 the model lacks something, or data or accuracy are wrong",
                three_digits(factor * error),
                three_digits(error / sigma),
                three_digits(factor * sigma)
            )
        });
    }
    // poses that were predicted and have no error were not measured
    if position.is_nan() && answered > 0 {
        distrust.reasons.extend(beyond_length_accuracy(errors.length_error_m.rms, sigmas));
    }
    distrust
}

/// Doubt about length residuals of this size (m), beside poses that nobody measured; `None` where no accuracy is stated or they keep five times it.
pub(super) fn beyond_length_accuracy(residual: f64, sigmas: &SensorSigmas) -> Option<Doubt> {
    let sigma = sigmas.length.filter(|sigma| *sigma > 0.0 && residual > LARGEST_MULTIPLE * sigma)?;
    let words = format!(
        "not to be trusted: lengths are {} mm (rms) from those at the poses found, {} times the accuracy that is stated for them, {} mm: poses or parameters are \
         those of another optimum, the model lacks something, or data or accuracy are wrong",
        three_digits(1e3 * residual),
        three_digits(residual / sigma),
        three_digits(1e3 * sigma)
    );
    Some(Doubt::new(DoubtKind::BeyondAccuracy, words))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluation::Evaluation;

    /// Of nine samples one, none and five with a predicted pose.
    #[test]
    fn a_model_that_predicts_few_poses_is_not_trusted() {
        let robot = Robot::builtin("planar-example").unwrap();
        let of = |robot: &Robot, answered: usize| {
            let errors = ErrorBlocks { answered, not_converged: 9 - answered, ..Evaluation::default().blocks() };
            distrust(robot, &SensorSigmas::default(), &errors)
        };
        assert!(of(&robot, 1).reasons[0].words().contains("of 1 of 9 samples"));
        assert_eq!(of(&robot, 0).reasons[0].kind, DoubtKind::FewPoses);
        assert_eq!(of(&robot, 5), Distrust::default());
        // one cable leaves a plane open, whatever it says
        let mut hanging = robot.clone();
        hanging.cables.truncate(1);
        assert_eq!(of(&hanging, 0), Distrust::default());
    }

    /// 2.6 mm beside a stated 0.5 mm, at poses that nobody measured; beside 0.6 mm, or where nothing is stated, it is told otherwise.
    #[test]
    fn lengths_beyond_five_times_their_accuracy_are_not_trusted_without_poses() {
        let robot = Robot::builtin("planar-example").unwrap();
        let mut errors = ErrorBlocks { answered: 9, not_converged: 0, ..Evaluation::default().blocks() };
        errors.length_error_m.rms = 2.6e-3;
        let of = |length: Option<f64>| distrust(&robot, &SensorSigmas { length, ..SensorSigmas::default() }, &errors);
        assert_eq!(of(Some(5e-4)).reasons[0].kind, DoubtKind::BeyondAccuracy);
        assert!(of(Some(5e-4)).reasons[0].words().contains("5.20 times"), "{:?}", of(Some(5e-4)));
        assert_eq!([of(Some(6e-4)), of(Some(0.0)), of(None)], [(); 3].map(|()| Distrust::default()));
    }
}

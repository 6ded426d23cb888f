//! Whether a model is good enough to be announced at all.

use super::evaluation::{ErrorBlocks, predicted_poses};
use super::verdict::{Doubt, DoubtKind};
use cdpr_model::control::error_statistics::diagonal;
use cdpr_model::measurement::{Samples, SensorSigmas, three_digits};
use cdpr_model::model::Model;
use cdpr_model::robot::Robot;

/// Largest mean error, as a fraction of the diagonal of the sampled positions; of the anchors' box where no pose is measured.
const LARGEST_FRACTION: f64 = 0.01;
/// Scatter of the errors of neighbouring samples that is allowed besides, and how near neighbours are as a fraction of that diagonal.
const SCATTERS: f64 = 2.0;
const NEAR: f64 = 0.05;
/// Fewest neighbours that tell a scatter, and most samples asked for theirs.
const FEWEST_NEIGHBOURS: usize = 10;
const MOST_ASKED: usize = 300;
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
/// A mean error above a hundredth of the size of the sampled region and twice the scatter of neighbouring samples (of the robot's size where no pose is
/// measured), or above five times the accuracy that is stated for the measured poses (of lengths, where no pose is
/// measured), is no error of a model but of its data, of the robot file, or of what the model leaves out. Nor is one to be trusted that predicts less than half
/// of the poses, though the robot has as many cables as degrees of freedom.
///
/// Errors of a predicted pose that follow from the stated accuracy of the lengths belong to the accuracy of the prediction: robots with few cables, or near a singularity, turn
/// it into much more than what the tracker errs.
pub fn distrust(robot: &Robot, model: &Model, samples: &Samples, errors: &ErrorBlocks) -> Distrust {
    judged(&Judged {
        robot,
        sigmas: &samples.sigmas,
        errors,
        of_lengths: &|| of_lengths(model, samples),
        sampled: &|| sampled(model, samples, errors.position_error_m.mean),
    })
}

/// Errors of a predicted position (m) and orientation (rad) that the accuracy of the lengths makes.
type OfLengths<'a> = &'a dyn Fn() -> Option<[f64; 2]>;

/// Diagonal of the sampled positions, and mean difference of the errors of neighbours, over √2 (m).
#[derive(Clone, Copy, Default)]
struct Sampled {
    diagonal: f64,
    scatter: f64,
}

/// Size and noise of the samples by themselves, where a mean error (m) is large beside the size; `None` for a single position.
fn sampled(model: &Model, samples: &Samples, error: f64) -> Option<Sampled> {
    let diagonal = diagonal(|| samples.poses.iter().map(|pose| pose.position));
    if !(diagonal > 0.0) {
        return None;
    }
    let none = Some(Sampled { diagonal, scatter: 0.0 });
    if error <= LARGEST_FRACTION * diagonal {
        return none;
    }
    let asked = MOST_ASKED.min(samples.len());
    let few = samples.subset(&(0..asked).map(|place| place * samples.len() / asked).collect::<Vec<usize>>());
    let Some(predicted) = predicted_poses(model, &few) else { return none };
    let error = |sample: usize| Some(predicted[sample]?.position - few.poses[sample].position);
    let distance = |a: usize, b: usize| (few.poses[a].position - few.poses[b].position).norm();
    let mut differences = Vec::new();
    for sample in 0..asked {
        let nearest = (0..asked)
            .filter(|&other| other != sample)
            .min_by(|&a, &b| distance(sample, a).total_cmp(&distance(sample, b)));
        let Some(other) = nearest.filter(|&other| distance(sample, other) < NEAR * diagonal) else { continue };
        differences.extend(error(sample).zip(error(other)).map(|(own, other)| (own - other).norm()));
    }
    if differences.len() < FEWEST_NEIGHBOURS {
        return none;
    }
    let scatter = differences.iter().sum::<f64>() / differences.len() as f64 / std::f64::consts::SQRT_2;
    Some(Sampled { diagonal, scatter })
}

/// Samples at which it is asked for.
const ASKED: usize = 12;

/// Root mean square errors of predicted poses if every length errs by its stated accuracy, to first order; `None` where none is stated.
fn of_lengths(model: &Model, samples: &Samples) -> Option<[f64; 2]> {
    let sigma = samples.sigmas.length.filter(|sigma| *sigma > 0.0)?;
    let asked = ASKED.min(samples.len());
    let few = samples.subset(&(0..asked).map(|place| place * samples.len() / asked).collect::<Vec<usize>>());
    let middle = predicted_poses(model, &few)?;
    let (mut squares, mut answered) = ([0.0; 2], 0.0);
    for cable in 0..few.cable_count {
        let mut moved = few.clone();
        (0..asked).for_each(|sample| moved.lengths[sample * few.cable_count + cable] += sigma);
        for (before, after) in middle.iter().zip(predicted_poses(model, &moved)?) {
            let (Some(before), Some(after)) = (before, after) else { continue };
            squares[0] += (after.position - before.position).norm_squared();
            squares[1] += after.angle_to(before).powi(2);
            answered += 1.0 / few.cable_count as f64;
        }
    }
    (answered > 0.0).then(|| squares.map(|square| (square / answered).sqrt()))
}

/// Errors of a model, and what they are held against.
struct Judged<'a> {
    robot: &'a Robot,
    sigmas: &'a SensorSigmas,
    errors: &'a ErrorBlocks,
    of_lengths: OfLengths<'a>,
    sampled: &'a dyn Fn() -> Option<Sampled>,
}

fn judged(asked: &Judged<'_>) -> Distrust {
    let Judged { robot, sigmas, errors, of_lengths, sampled } = *asked;
    let position = errors.position_error_m.mean;
    let (error, name) = match position.is_nan() {
        true => (errors.length_error_m.mean_abs, "cable-length"),
        false => (position, "position"),
    };
    let of_anchors = (LARGEST_FRACTION * robot.anchor_diagonal(), "1 % of the diagonal of the anchors' box");
    // a stated accuracy says more than a size
    let by_samples = sigmas.position.is_none() && !position.is_nan();
    let (limit, of_what) = match by_samples.then(sampled).flatten() {
        Some(Sampled { diagonal, scatter }) if LARGEST_FRACTION * diagonal + SCATTERS * scatter < of_anchors.0 => (
            LARGEST_FRACTION * diagonal + SCATTERS * scatter,
            "1 % of the diagonal of the sampled positions and twice the scatter of neighbours",
        ),
        _ => of_anchors,
    };
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
                "the mean {name} error, {} mm, is above {of_what}, {} mm: \
                 are the data, their frame, their clock and the robot file right?",
                three_digits(1e3 * error),
                three_digits(1e3 * limit)
            )
        });
    }
    let rotation = errors.rotation_error_rad.mean;
    for (place, (error, sigma, name, factor, unit)) in [
        (position, sigmas.position, "position", 1e3, " mm"),
        (rotation, sigmas.rotation, "rotation", 1f64.to_degrees(), "°"),
    ]
    .into_iter()
    .enumerate()
    {
        let Some(sigma) = sigma.filter(|sigma| *sigma > 0.0 && error > LARGEST_MULTIPLE * sigma) else { continue };
        // 1.6 = √(8/π): the mean of a length in space over its deviation per axis
        let propagated = of_lengths().map_or(0.0, |both| both[place]);
        if error <= LARGEST_MULTIPLE * (1.6 * sigma).hypot(propagated) / 1.6 {
            continue;
        }
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
            judged(&Judged {
                robot,
                sigmas: &SensorSigmas::default(),
                errors: &errors,
                of_lengths: &|| None,
                sampled: &|| None,
            })
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
        let of = |length: Option<f64>| {
            let sigmas = SensorSigmas { length, ..SensorSigmas::default() };
            judged(&Judged { robot: &robot, sigmas: &sigmas, errors: &errors, of_lengths: &|| None, sampled: &|| None })
        };
        assert_eq!(of(Some(5e-4)).reasons[0].kind, DoubtKind::BeyondAccuracy);
        assert!(of(Some(5e-4)).reasons[0].words().contains("5.20 times"), "{:?}", of(Some(5e-4)));
        assert_eq!([of(Some(6e-4)), of(Some(0.0)), of(None)], [(); 3].map(|()| Distrust::default()));
    }
}

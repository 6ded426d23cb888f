//! Two candidates compared on the same samples: what is common to both, such as the noise of a tracker, cancels.

use nalgebra::Vector3;

use super::bootstrap::standard_error_of_groups;
use cdpr_model::measurement::Samples;
use cdpr_model::robot::Robot;

/// Fraction of the best's mean below which a difference is of no use to anybody.
const OF_NO_USE: f64 = 0.01;
/// Positions and rotations are those of one pose within these fractions of the diagonal of the anchors' box and of a radian.
const SAME_PLACE: f64 = 1e-3;
const SAME_TURN: f64 = 2e-3;

/// Mean of the differences of a candidate's errors to those of the best on the same samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// Mean over the samples, in the unit of the errors; positive where the candidate is worse.
    pub mean: f64,
    /// Its standard error by block bootstrap, in which repeated poses are drawn whole; not a number for fewer than two poses.
    pub standard_error: f64,
}

impl Difference {
    /// The difference of a candidate's errors to those of the best; `groups` has a number for every sample, the same for repeated poses.
    pub(crate) fn to_best(best: &[f64], other: &[f64], groups: &[usize], seed: u64) -> Self {
        let differences: Vec<f64> = other.iter().zip(best).map(|(other, best)| other - best).collect();
        let mean = differences.iter().sum::<f64>() / differences.len() as f64;
        Self { mean, standard_error: standard_error_of_groups(&differences, groups, seed) }
    }

    /// True where the candidate is as good as the best, whose mean error is given: the difference is within one standard error, or below a hundredth of
    /// that mean.
    pub(crate) fn is_none(self, best_mean: f64) -> bool {
        self.mean <= self.largest_none(best_mean)
    }

    /// The largest difference that is none.
    pub(crate) fn largest_none(self, best_mean: f64) -> f64 {
        let error = if self.standard_error.is_finite() { self.standard_error } else { 0.0 };
        error.max(OF_NO_USE * best_mean)
    }
}

/// The place of the least mean, and for every series whether it is as good; false for empty ones. All other series are of the same samples.
pub(crate) fn as_good_as_best(series: &[Vec<f64>], groups: &[usize], seed: u64) -> Option<(usize, Vec<bool>)> {
    let mean = |values: &Vec<f64>| values.iter().sum::<f64>() / values.len() as f64;
    let means: Vec<f64> = series.iter().map(mean).collect();
    let finite = (0..series.len()).filter(|&place| means[place].is_finite());
    let best = finite.min_by(|&a, &b| means[a].total_cmp(&means[b]))?;
    let is_as_good =
        |own: &Vec<f64>| !own.is_empty() && Difference::to_best(&series[best], own, groups, seed).is_none(means[best]);
    Some((best, series.iter().map(is_as_good).collect()))
}

/// A number for every sample, the same for samples at one pose, wherever they stand.
pub(crate) fn repeated_poses(robot: &Robot, samples: &Samples) -> Vec<usize> {
    let step = SAME_PLACE * robot.anchor_diagonal();
    if step.is_nan() || step <= 0.0 {
        return (0..samples.len()).collect();
    }
    let cell = |vector: Vector3<f64>, step: f64| vector.map(|entry| (entry / step).round() as i64);
    let key = |sample: usize| {
        let pose = &samples.poses[sample];
        let (place, turn) = (cell(pose.position, step), cell(pose.rotation.scaled_axis(), SAME_TURN));
        [place.x, place.y, place.z, turn.x, turn.y, turn.z]
    };
    let mut numbers = std::collections::HashMap::new();
    (0..samples.len()).map(|sample| *numbers.entry(key(sample)).or_insert(sample)).collect()
}

/// Root of the mean squared distance of the platform anchors from their origin (m): the distance that a turn of one radian moves them by.
pub(crate) fn platform_radius(robot: &Robot) -> f64 {
    let squares: f64 = robot.cables.iter().map(|cable| cable.platform_anchor.norm_squared()).sum();
    (squares / robot.cables.len().max(1) as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Noise common to both of ten times the difference: the difference is seen, and one below a hundredth is none.
    #[test]
    fn common_noise_cancels() {
        let noise = |at: usize| 1.0 + ((at * 7919) % 101) as f64 / 101.0;
        let best: Vec<f64> = (0..200).map(noise).collect();
        let worse: Vec<f64> = best.iter().enumerate().map(|(at, own)| own + 0.05 + 0.01 * (at % 3) as f64).collect();
        let alike: Vec<f64> = best.iter().map(|own| own + 0.01).collect();
        let whole: Vec<usize> = (0..200).collect();
        let of = |other: &[f64]| Difference::to_best(&best, other, &whole, 3);
        assert!((of(&worse).mean - 0.06).abs() < 1e-3 && !of(&worse).is_none(1.5));
        assert!(of(&alike).is_none(1.5) && !of(&alike).is_none(0.5));
        assert_eq!(
            [of(&alike), of(&worse)].map(|one| one.largest_none(1.5)),
            [0.015, of(&worse).standard_error.max(0.015)]
        );
        let (place, as_good) = as_good_as_best(&[worse, best.clone(), Vec::new(), alike], &whole, 3).unwrap();
        assert_eq!((place, as_good), (1, vec![false, true, false, true]));
    }
}

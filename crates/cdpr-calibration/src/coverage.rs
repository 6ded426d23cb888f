//! Which poses a model was fitted to, and how far beyond them it was judged: outside it extrapolates.

use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Fold, Samples};
use cdpr_model::robot::Robot;

/// Ranges of the poses, component by component, and the validation samples that lie beyond those of their fit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Coverage {
    /// One range for each component of the pose, in the order of the motion pattern.
    pub ranges: Vec<PoseRange>,
    /// Validation samples, all folds together.
    pub validation: usize,
    /// Those of them with a component outside the range of the data that the predicting fit saw.
    pub outside: usize,
    /// For each validation sample, fold by fold, whether it is one of those.
    pub is_outside: Vec<bool>,
}

/// Smallest and largest value of one component of the pose.
#[derive(Clone, Debug, PartialEq)]
pub struct PoseRange {
    /// The component: a world axis, or `rx`, `ry`, `rz`, `angle`.
    pub name: String,
    /// Its unit: m or rad.
    pub unit: &'static str,
    /// Smallest value in the data of the reported fit.
    pub fit_min: f64,
    /// Largest value in the data of the reported fit.
    pub fit_max: f64,
    /// Smallest value in validation data.
    pub validation_min: f64,
    /// Largest value in validation data.
    pub validation_max: f64,
}

/// Compares the poses of fit and validation.
///
/// With one fold the reported fit is that of its training part, with several it is of all samples, as in
/// [`select`](super::selection::select); whether a sample lies outside is asked of the training part of its own fold.
pub fn coverage(robot: &Robot, samples: &Samples, folds: &[Fold]) -> Coverage {
    let components = |pose: &Pose| robot.motion_pattern.pose_to_components(robot.plane, pose);
    let all: Vec<Vec<f64>> = samples.poses.iter().map(components).collect();
    let everything: Vec<usize> = (0..samples.len()).collect();
    let fitted = if let [fold] = folds { &fold.train } else { &everything };
    let judged: Vec<usize> = folds.iter().flat_map(|fold| fold.validation.iter().copied()).collect();
    let mut is_outside = Vec::with_capacity(judged.len());
    for fold in folds {
        let limits: Vec<(f64, f64)> = (0..robot.dof()).map(|k| range(&all, &fold.train, k)).collect();
        let beyond = |&sample: &usize| {
            all[sample].iter().zip(&limits).any(|(value, (least, most))| value < least || value > most)
        };
        is_outside.extend(fold.validation.iter().map(beyond));
    }
    let ranges = names(robot).into_iter().enumerate().map(|(k, (name, unit))| {
        let ((fit_min, fit_max), (validation_min, validation_max)) = (range(&all, fitted, k), range(&all, &judged, k));
        PoseRange { name, unit, fit_min, fit_max, validation_min, validation_max }
    });
    let outside = is_outside.iter().filter(|&&outside| outside).count();
    Coverage { ranges: ranges.collect(), validation: judged.len(), outside, is_outside }
}

/// Names of the pose's components with their units; translations of a planar robot have the letters of its plane.
fn names(robot: &Robot) -> Vec<(String, &'static str)> {
    let translations = robot.motion_pattern.translations();
    let unit = |k: usize| if k < translations { "m" } else { "rad" };
    robot.motion_pattern.component_names(robot.plane).into_iter().enumerate().map(|(k, name)| (name, unit(k))).collect()
}

fn range(all: &[Vec<f64>], samples: &[usize], component: usize) -> (f64, f64) {
    let values = samples.iter().map(|&sample| all[sample][component]);
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), value| (least.min(value), most.max(value)))
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;

    fn at(x: f64, y: f64, angle: f64) -> Pose {
        Pose::from_xyz_angles(Vector3::new(x, y, 0.0), [0.0, 0.0, angle])
    }

    /// One sample beyond in x, one only in its angle, one at the very edge, which is not beyond.
    #[test]
    fn a_sample_beyond_in_any_component_is_outside() {
        let robot = Robot::builtin("kntu-planar").unwrap();
        let poses =
            vec![at(0.0, 0.0, -0.1), at(1.0, 2.0, 0.1), at(1.1, 1.0, 0.0), at(0.5, 1.0, 0.2), at(1.0, 0.0, 0.1)];
        let samples = Samples { poses, cable_count: robot.cable_count(), ..Samples::default() };
        let fold = Fold { name: "one".to_owned(), train: vec![0, 1], validation: vec![2, 3, 4] };
        let found = coverage(&robot, &samples, &[fold]);
        assert_eq!(found.is_outside, [true, true, false]);
        assert_eq!((found.outside, found.validation), (2, 3));
        let range = &found.ranges[0];
        assert_eq!((range.name.as_str(), range.fit_max, range.validation_max), ("x", 1.0, 1.1));
        assert_eq!(found.ranges.iter().map(|range| range.unit).collect::<Vec<_>>(), ["m", "m", "rad"]);
    }

    /// The reported fit saw all samples then, but each was predicted by a fit that had not seen it.
    #[test]
    fn folds_that_take_turns_are_judged_by_their_own_training_part() {
        let robot = Robot::builtin("kntu-planar").unwrap();
        let poses = vec![at(0.0, 0.0, 0.0), at(1.0, 1.0, 0.0), at(2.0, 0.5, 0.0)];
        let samples = Samples { poses, cable_count: robot.cable_count(), ..Samples::default() };
        let fold = |validation: usize| Fold {
            name: validation.to_string(),
            train: (0..3).filter(|&k| k != validation).collect(),
            validation: vec![validation],
        };
        let found = coverage(&robot, &samples, &[fold(0), fold(1), fold(2)]);
        assert_eq!(found.is_outside, [true, true, true]);
        assert_eq!((found.ranges[0].fit_min, found.ranges[0].fit_max), (0.0, 2.0));
    }
}

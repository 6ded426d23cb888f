//! Recorded tensions in another unit than newtons, told by the weight that they carry.

use super::{Samples, three_digits};
use crate::finding::{Finding, FindingKind, Severity};
use crate::robot::Robot;

/// Units of force that are written for newtons: name, and newtons.
const UNITS: [(&str, f64); 3] =
    [("kilograms-force (kgf)", 9.80665), ("pounds-force (lbf)", 4.448_222), ("kilonewtons", 1e3)];
/// Largest deviation of the carried weight from that of the file, so read; of a sample from the mean.
const AGREES: f64 = 0.02;
const SCATTER: f64 = 0.1;
/// Least number of samples for a verdict.
const FEWEST: usize = 6;

/// The unit in which recorded tensions carry the weight of the file; `None` if they carry it in newtons, if no unit does,
/// and for robots whose weight is unknown or that an external wrench pulls.
pub(super) fn judged(robot: &Robot, samples: &Samples) -> Option<Finding> {
    let (tensions, mass, gravity) = (samples.tensions.as_ref()?, robot.platform.mass?, robot.gravity?);
    let weight = mass * gravity.norm();
    if robot.external_wrench.is_some() || !(weight > 0.0) || samples.len() < FEWEST {
        return None;
    }
    let up = -gravity.normalize();
    let carried = |(pose, tensions): (&crate::geometry::Pose, &[f64])| -> f64 {
        let pulls = robot.cables.iter().zip(tensions).map(|(cable, tension)| {
            let along = cable.frame_anchor - pose.transform(&cable.platform_anchor);
            tension * along.normalize().dot(&up)
        });
        pulls.sum()
    };
    let shares: Vec<f64> = samples
        .poses
        .iter()
        .zip(tensions.chunks(samples.cable_count.max(1)))
        .map(|sample| carried(sample) / weight)
        .collect();
    let mean = shares.iter().sum::<f64>() / shares.len() as f64;
    let scatter = (shares.iter().map(|share| (share - mean).powi(2)).sum::<f64>() / shares.len() as f64).sqrt();
    if !(scatter < SCATTER * mean.abs()) {
        return None;
    }
    let (name, newtons) = UNITS.into_iter().find(|(_, newtons)| (mean * newtons - 1.0).abs() < AGREES)?;
    let text = format!(
        "the tensions look like {name}: as newtons they carry {} N, {} of the weight of {} kg; multiply them by {newtons}, or correct mass_kg",
        three_digits(mean * weight),
        three_digits(mean),
        three_digits(mass)
    );
    Some(Finding::new(FindingKind::Unit, Severity::Caution, text).of_size(mean, ""))
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;

    use super::*;
    use crate::geometry::Pose;

    /// A suspended robot whose cables carry the weight of its platform at two places.
    fn recorded(factor: f64) -> (Robot, Samples) {
        let mut robot = Robot::builtin("cogiro").unwrap();
        robot.external_wrench = None;
        let gravity = robot.gravity.get_or_insert(Vector3::new(0.0, 0.0, -9.81));
        let weight = gravity.norm() * *robot.platform.mass.get_or_insert(100.0);
        let mut samples = Samples { cable_count: robot.cable_count(), ..Samples::default() };
        let mut tensions = Vec::new();
        for k in 0..10 {
            let home = robot.home_or_middle();
            let pose = Pose { position: home.position + Vector3::new(0.1 * f64::from(k), 0.0, 0.0), ..home };
            let up = |cable: &crate::robot::Cable| {
                (cable.frame_anchor - pose.transform(&cable.platform_anchor)).normalize().z
            };
            let sum: f64 = robot.cables.iter().map(up).sum();
            tensions.extend(robot.cables.iter().map(|_| weight / sum / factor));
            samples.lengths.extend(vec![1.0; robot.cable_count()]);
            samples.poses.push(pose);
        }
        samples.tensions = Some(tensions);
        (robot, samples)
    }

    #[test]
    fn units_of_tensions_are_told_by_the_weight() {
        for (factor, words) in [(9.80665, "(kgf)"), (4.448_222, "(lbf)"), (1e3, "kilonewtons")] {
            let (robot, samples) = recorded(factor);
            let found = judged(&robot, &samples).unwrap();
            assert!(found.kind == FindingKind::Unit && found.text.contains(words), "{}", found.text);
        }
        // newtons, and a load that no unit explains
        for factor in [1.0, 0.97, 3.0, 1.1] {
            let (robot, samples) = recorded(factor);
            assert_eq!(judged(&robot, &samples), None, "{factor}");
        }
    }
}

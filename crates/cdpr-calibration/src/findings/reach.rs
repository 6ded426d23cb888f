//! Region of the samples, and the error to be expected elsewhere.

use nalgebra::Vector3;

use super::examined::Examined;
use cdpr_model::control::{CommandedPose, Operation, Status};
use cdpr_model::finding::{Finding, FindingKind, Severity};
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::three_digits;

/// Fractions of the workspace of the file, or of the anchors' box where it has none, below which samples are a corner of it.
const OF_WORKSPACE: f64 = 0.1;
const OF_ANCHORS: f64 = 0.01;
/// Predicted error elsewhere, in multiples of that of the validation, from which on it is worth a word.
const FARTHER_OFF: f64 = 2.0;
/// Middle part of the box whose corners are asked.
const INNER: f64 = 0.8;

/// The samples as a corner of where the robot works, with the error predicted for the rest; `None` where they cover it, or the rest is as good.
pub(super) fn finding(examined: &Examined<'_>) -> Option<Finding> {
    let robot = examined.given;
    let (low, high, name, limit) = match &robot.travel {
        Some(travel) => (travel.min, travel.max, "workspace of the robot file", OF_WORKSPACE),
        None => {
            let anchors = || robot.cables.iter().map(|cable| cable.frame_anchor);
            let first = anchors().next()?;
            let (low, high) =
                anchors().fold((first, first), |(low, high), anchor| (low.inf(&anchor), high.sup(&anchor)));
            (low, high, "box of the frame anchors", OF_ANCHORS)
        }
    };
    let samples = examined.fit.as_fitted(examined.samples);
    let positions = || samples.poses.iter().map(|pose| pose.position);
    let first = positions().next()?;
    let (from, to) = positions().fold((first, first), |(from, to), position| (from.inf(&position), to.sup(&position)));
    let axes: Vec<usize> = (0..3).filter(|&axis| high[axis] - low[axis] > 1e-9).collect();
    let overlap =
        |axis: usize| ((to[axis].min(high[axis]) - from[axis].max(low[axis])) / (high[axis] - low[axis])).max(0.0);
    let fraction: f64 = axes.iter().map(|&axis| overlap(axis)).product();
    if axes.is_empty() || fraction >= limit {
        return None;
    }
    let elsewhere = error_elsewhere(examined, &low, &high, &samples.poses);
    let told = elsewhere.filter(|error| *error > FARTHER_OFF * examined.position_error.max(1e-4));
    let is_unknown = elsewhere.is_none() && robot.travel.is_some();
    (told.is_some() || is_unknown).then(|| {
        let error = match told {
            Some(error) => format!(
                "elsewhere an error of {} mm is to be expected, {} mm where they are",
                three_digits(1e3 * error),
                three_digits(1e3 * examined.position_error)
            ),
            None => "the error elsewhere is not known".to_owned(),
        };
        let text = format!("the samples span {:.1} % of the {name}: {error}; record poses there", 100.0 * fraction);
        Finding::new(FindingKind::Coverage, Severity::Caution, text).of_size(told.unwrap_or(f64::NAN), "m")
    })
}

/// Largest error at corners of a box (m): of the parameters of the richest fit, and of the model beside it; `None` where neither is known.
fn error_elsewhere(examined: &Examined<'_>, low: &Vector3<f64>, high: &Vector3<f64>, near: &[Pose]) -> Option<f64> {
    let middle = (low + high) / 2.0;
    let half = (high - low) * (INNER / 2.0);
    let turned = near.first()?.rotation;
    let corners: Vec<Pose> = (0..8)
        .map(|corner| {
            let sign = |axis: usize| if corner >> axis & 1 == 1 { 1.0 } else { -1.0 };
            let away = Vector3::from_fn(|axis, _| sign(axis) * half[axis]);
            Pose { position: middle + away, rotation: turned }
        })
        .collect();
    let bands = examined.richest.pose_bands(&corners).ok()?;
    let offsets = vec![0.0; examined.fit.model.cable_count()];
    let mut operation = Operation::new(&examined.fit.model, &examined.richest.model, &offsets).ok()?;
    let mut of_model = |pose: &Pose| {
        let outcome = operation.answer(&CommandedPose::at(*pose));
        (outcome.status == Status::Converged).then(|| (outcome.pose.position - pose.position).norm())
    };
    let errors = corners.iter().zip(&bands).map(|(pose, band)| Some(band.as_ref()?.position.hypot(of_model(pose)?)));
    errors.flatten().max_by(f64::total_cmp)
}

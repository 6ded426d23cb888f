//! Samples to compare with: the corners of the data's box, in the orientations that the data go to.

use nalgebra::{UnitQuaternion, Vector3};

use crate::identifiability::mean_rotation;
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::statics::Load;

/// Angle below which data do not turn (rad).
const LEVEL: f64 = 1e-9;

/// Corners and middle of the box of positions, each in the mean orientation and turned by the largest angle of the data about every axis that the
/// platform turns about; with the tensions of the model there. `None` where it cannot hold any of them.
pub(super) fn corners(model: &Model, samples: &Samples) -> Option<Samples> {
    let axes = model.axes();
    let range = |axis: &Vector3<f64>| {
        let along = || samples.poses.iter().map(|pose| pose.position.dot(axis));
        (along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max))
    };
    let ranges: Vec<(f64, f64)> = axes.iter().map(range).collect();
    let corner = |bits: usize| -> Vector3<f64> {
        let end = |k: usize| if bits >> k & 1 == 0 { ranges[k].0 } else { ranges[k].1 };
        (0..axes.len()).map(|k| axes[k] * end(k)).sum()
    };
    let middle: Vector3<f64> = (0..axes.len()).map(|k| axes[k] * (0.5 * (ranges[k].0 + ranges[k].1))).sum();
    let off = samples.poses.first().map(|pose| pose.position - across(&pose.position, axes))?;
    let places = (0..1_usize << axes.len()).map(corner).chain([middle]);
    let mut found = Samples { cable_count: samples.cable_count, sigmas: samples.sigmas, ..Samples::default() };
    let load = model.needs_tensions().then(|| Load::of(model.robot())).transpose().ok()?;
    let (turns, mut tensions) = (orientations(model, samples), Vec::new());
    for position in places {
        for rotation in &turns {
            let pose = Pose { position: position + off, rotation: *rotation };
            if let Some(load) = &load {
                let Ok(held) = model.distribute(&pose, load) else { continue };
                tensions.extend(held.tensions);
            }
            found.poses.push(pose);
            found.lengths.extend(std::iter::repeat_n(0.0, samples.cable_count));
        }
    }
    found.tensions = load.map(|_| tensions);
    (!found.poses.is_empty()).then_some(found)
}

/// Part of a position along some axes.
fn across(position: &Vector3<f64>, axes: &[Vector3<f64>]) -> Vector3<f64> {
    axes.iter().map(|axis| axis * axis.dot(position)).sum()
}

fn orientations(model: &Model, samples: &Samples) -> Vec<UnitQuaternion<f64>> {
    let mean = UnitQuaternion::from_matrix(&mean_rotation(samples));
    let angle = samples.poses.iter().map(|pose| pose.rotation.angle_to(&mean)).fold(0.0, f64::max);
    let about = model.twist_basis().iter().map(|twist| twist.fixed_rows::<3>(3).into_owned());
    let turned = about
        .filter(|axis| axis.norm() > 0.5 && angle > LEVEL)
        .flat_map(|axis| [-angle, angle].map(|angle| UnitQuaternion::from_scaled_axis(axis * angle) * mean));
    std::iter::once(mean).chain(turned).collect()
}

//! Two controllers on one machine: the difference of their errors as a table and as a map.

use cdpr_model::control::CommandedPose;
use cdpr_model::geometry::MotionPattern;
use cdpr_study::Experiment;
use cdpr_study::difference::{Difference, ErrorChange};
use cdpr_study::force_tracking::ForceTracking;
use schemars::JsonSchema;
use serde::Serialize;

use super::tracking_answer::TrackingAnswer;
use super::{axis_names, control_title};
use crate::figures::{DifferenceMap, DifferencePoint};
use crate::keys::DifferenceKeys;
use crate::number_format::{NONE, short, significant};
use crate::study_page::{SAME_HEIGHT, levels};
use crate::table::Table;

/// Errors of a controller beside those of another on the same machine.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "ControllerDifference")]
pub struct DifferenceAnswer {
    /// Name of the other study.
    against: String,
    /// The other control model.
    other_control: String,
    #[serde(flatten, with = "DifferenceKeys")]
    difference: Difference,
    #[serde(skip)]
    pattern: MotionPattern,
}

impl DifferenceAnswer {
    /// The answer for an experiment and another one by its name.
    pub fn new(experiment: &Experiment, name: &str, other: &Experiment, difference: Difference) -> Self {
        Self {
            against: name.to_owned(),
            other_control: control_title(other),
            difference,
            pattern: experiment.machine.robot().motion_pattern,
        }
    }

    /// Force tracking compared with that of the other controller; `None` unless both command tensions.
    pub(super) fn force_tracking(&self) -> Option<TrackingAnswer> {
        let errors = self.difference.tension_error_N?;
        let found = ForceTracking::of(errors.other.mean, errors.own.mean)?;
        Some(TrackingAnswer::new(self.other_control.clone(), found))
    }

    /// The paragraph of the difference.
    pub(super) fn words(&self, width: Option<usize>) -> String {
        let Difference {
            samples, compared, better, worse, position_error_m, rotation_error_rad, tension_error_N, ..
        } = &self.difference;
        let mut table = Table::new([
            "error",
            "unit",
            "this mean",
            "other mean",
            "Δ mean",
            "Δ %",
            "Δ max",
            "largest gain",
            "largest loss",
        ]);
        let mut row = |name: &str, unit: &str, scale: f64, change: &ErrorChange| {
            let figure = |value: f64| significant(scale * value, 3);
            let relative = change.relative_change.map_or_else(|| NONE.to_owned(), |share| significant(1e2 * share, 3));
            let mut cells = vec![name.to_owned(), unit.to_owned()];
            cells.extend([change.own.mean, change.other.mean, change.mean_change].map(figure));
            cells.push(relative);
            cells.extend([change.own.max - change.other.max, change.largest_gain, change.largest_loss].map(figure));
            table.row(cells);
        };
        row("position", "mm", 1e3, position_error_m);
        if self.pattern.has_rotation() {
            row("rotation", "°", 1.0_f64.to_degrees(), rotation_error_rad);
        }
        if let Some(change) = tension_error_N {
            row("tensions, norm", "N", 1.0, change);
        }
        format!(
            "\nagainst {} ({}): better at {better}, worse at {worse} of the {compared} of {samples} poses that both reach\n\n{}",
            self.other_control,
            self.against,
            table.text(width)
        )
    }

    /// Map of the poses at which the position error is smaller or larger than the other's, as SVG: in the plane of a planar robot, else from above,
    /// height by height where the poses have few heights; `None` where no pose is compared.
    pub fn map(&self, experiment: &Experiment, poses: &[CommandedPose]) -> Option<String> {
        let axes: Vec<usize> = experiment.machine.axes().iter().map(|axis| axis.iamax()).collect();
        let names = axis_names(experiment.machine.robot());
        let of_poses: Vec<f64> = poses.iter().map(|command| command.pose.position.z).collect();
        let heights = if axes.len() > 2 { levels(&of_poses) } else { Vec::new() };
        let points = |height: Option<f64>| -> Vec<DifferencePoint> {
            let point = |(command, change): (&CommandedPose, &Option<f64>)| {
                let position = command.pose.position;
                let is_there = height.is_none_or(|height| (position.z - height).abs() < SAME_HEIGHT);
                let change = change.filter(|_| is_there)?;
                Some(DifferencePoint { at: [position[axes[0]], position[axes[1]]], change: 1e3 * change })
            };
            poses.iter().zip(&self.difference.position_change).filter_map(point).collect()
        };
        let panels = match heights.is_empty() {
            true => vec![(String::new(), points(None))],
            false => heights.iter().map(|&height| (format!("z = {} m", short(height)), points(Some(height)))).collect(),
        };
        let ErrorChange { own, other, .. } = self.difference.position_error_m;
        let mean = |value: f64| format!("{} mm", significant(1e3 * value, 3));
        let own_title = control_title(experiment);
        let map = DifferenceMap {
            title: vec![
                format!("{own_title} against {}", self.other_control),
                format!("mean position error {} against {}", mean(own.mean), mean(other.mean)),
            ],
            panels,
            axes: [names[0].clone(), names[1].clone()],
            label: "change of the position error in mm".to_owned(),
            unit: "mm".to_owned(),
        };
        Some(map.svg()?.file())
    }
}

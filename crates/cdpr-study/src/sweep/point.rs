//! One point of a sweep.

use serde::{Deserialize, Serialize};

use super::calibration_table::CalibrationOutcome;
use super::point_error::PointError;
use super::set_up::{PreparedSweep, SetUp, whatever_the_error};
use crate::reachable::Census;
use cdpr_workspace::grid;

/// Answer of one point of a sweep; sizes in m² or m³, thresholds in the order of the sweep.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Index of the point, from 0.
    pub point: usize,
    /// Value of each parameter.
    pub values: Vec<f64>,
    /// Size of the workspace in which the machine is wrench-feasible; `None` without tension limits.
    pub physical: Option<f64>,
    /// Size of the workspace reached with tensions within their limits, at any error.
    pub reachable: Option<f64>,
    /// Sizes of the workspaces reached within each largest position error.
    pub by_accuracy: Vec<f64>,
    /// Cells of the grid.
    pub cells: u64,
    /// Outcome of a calibration; `None` if the sweep compares none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub calibration: Option<CalibrationOutcome>,
    /// Reason in words for which there is no reachable workspace: the machine cannot be set up, or the box lies outside
    /// its reach.
    pub reason: Option<String>,
}

impl Row {
    /// Row of a point without an answer, with its reason.
    pub(crate) fn without_answer(point: usize, values: &[f64], reason: String) -> Self {
        Self {
            point,
            values: values.to_vec(),
            physical: None,
            reachable: None,
            by_accuracy: Vec::new(),
            cells: 0,
            calibration: None,
            reason: Some(reason),
        }
    }
}

impl PreparedSweep {
    /// Answers one point; a point that cannot be set up has a reason instead of sizes.
    pub fn row(&self, point: usize, values: &[f64]) -> Row {
        self.measured(point, values).unwrap_or_else(|error| Row::without_answer(point, values, error.to_string()))
    }

    fn measured(&self, point: usize, values: &[f64]) -> Result<Row, PointError> {
        let SetUp { experiment, bounds, grid } = SetUp::new(self, values)?;
        let reachable = experiment.reachable_with(whatever_the_error(&experiment))?;
        let region = experiment.region(&reachable, experiment.start.rotation)?;
        let census = Census::take(&reachable, &region, &grid);
        let size = |most: Option<f64>| grid::outcome(&grid, &census.reached(most)).size;
        let physical = experiment.feasible_cells(&experiment.machine, &region, &grid).map(|held| held.size);
        let reachable = size(None);
        let is_out_of_reach = physical == Some(0.0) && reachable == 0.0;
        Ok(Row {
            point,
            values: values.to_vec(),
            physical,
            reachable: Some(reachable),
            by_accuracy: self.sweep.position_error_max_m.iter().map(|&most| size(Some(most))).collect(),
            cells: grid.points(),
            calibration: None,
            reason: is_out_of_reach.then(|| {
                let ends: Vec<String> = bounds.ends().iter().map(f64::to_string).collect();
                format!(
                    "the box {} lies outside the robot's reach: its cables can balance the load at no cell of it",
                    ends.join(", ")
                )
            }),
        })
    }
}

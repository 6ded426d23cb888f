//! Band of the pose that a calibrated controller drives to, from the covariance of its parameters.

#[cfg(test)]
mod tests;

use nalgebra::Matrix6;

use super::fit::Fit;
use cdpr_model::control::CommandedPose;
use cdpr_model::control::{InputError, Operation, Status};
use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::model::Model;

/// Share of a standard deviation by which a parameter is moved to find its effect.
const STEP: f64 = 0.01;

/// Standard deviations of a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseBand {
    /// Root of the mean squared distance (m).
    pub position: f64,
    /// Root of the mean squared angle (rad).
    pub rotation: f64,
}

impl Fit {
    /// Bands of the poses at which a machine with the true parameters ends when the calibrated model commands these poses, to first order:
    /// J Σ Jᵀ, J by central differences of one hundredth of a deviation; `None` where a pose has no answer, and everywhere where no free
    /// parameter has a deviation.
    ///
    /// A parameter that the data do not determine has none and is left out: the band is then a lower bound ([`Fit::without_deviation`]).
    pub fn pose_bands(&self, poses: &[Pose]) -> Result<Vec<Option<PoseBand>>, InputError> {
        // a model that answers no command is refused only where one is asked for
        if poses.is_empty() {
            return Ok(Vec::new());
        }
        let offsets = vec![0.0; self.model.cable_count()];
        let places: Vec<usize> = (0..self.parameters.len()).filter(|&k| self.parameters[k].sigma.is_some()).collect();
        if places.is_empty() && !self.parameters.is_empty() {
            return Ok(vec![None; poses.len()]);
        }
        let mut effects = Vec::with_capacity(places.len());
        for &place in &places {
            let driven = |side: f64| -> Result<Vec<Option<Pose>>, InputError> {
                let Some(machine) = self.moved(place, side * STEP) else { return Ok(vec![None; poses.len()]) };
                let mut operation = Operation::new(&self.model, &machine, &offsets)?;
                let mut answer = |pose: &Pose| {
                    let outcome = operation.answer(&CommandedPose::at(*pose));
                    (outcome.status == Status::Converged).then_some(outcome.pose)
                };
                Ok(poses.iter().map(&mut answer).collect())
            };
            let effect = |(behind, ahead): (&Option<Pose>, &Option<Pose>)| -> Option<Twist> {
                Some(behind.as_ref()?.displacement_to(ahead.as_ref()?) / (2.0 * STEP))
            };
            effects.push(driven(-1.0)?.iter().zip(&driven(1.0)?).map(effect).collect::<Vec<_>>());
        }
        Ok((0..poses.len()).map(|pose| self.band(&places, &effects, pose)).collect())
    }

    /// Free parameters without a standard deviation: the data do not determine them, or their cost knows none.
    pub fn without_deviation(&self) -> usize {
        self.parameters.iter().filter(|estimate| estimate.sigma.is_none()).count()
    }

    /// The calibrated model with a parameter so many standard deviations away, as far as its bounds allow.
    fn moved(&self, place: usize, deviations: f64) -> Option<Model> {
        let estimate = &self.parameters[place];
        let mut robot = self.model.robot().clone();
        estimate.parameter.set(&mut robot, estimate.value + deviations * estimate.sigma?);
        Model::new(robot, self.model.composition()).ok()
    }

    fn band(&self, places: &[usize], effects: &[Vec<Option<Twist>>], pose: usize) -> Option<PoseBand> {
        let columns: Vec<Twist> = effects.iter().map(|effect| effect[pose]).collect::<Option<_>>()?;
        let mut covariance = Matrix6::zeros();
        for (i, first) in columns.iter().enumerate() {
            for (j, second) in columns.iter().enumerate() {
                let (row, column) = (places[i].max(places[j]), places[i].min(places[j]));
                let own = self.analysis.correlation_rows.get(row).and_then(|row| row.get(column));
                let coefficient = if i == j { 1.0 } else { own.copied().filter(|c| c.is_finite()).unwrap_or(0.0) };
                covariance += first * second.transpose() * coefficient;
            }
        }
        let deviation = |from: usize| (from..from + 3).map(|k| covariance[(k, k)]).sum::<f64>().max(0.0).sqrt();
        Some(PoseBand { position: deviation(0), rotation: deviation(3) })
    }
}

//! A start for descents that held parameters lead astray.
//!
//! Data that hold a shape weakly let the way to its optimum bend it by far, and a frame that is fixed by few anchors turns with each of them, so that descents end in a long, curved valley. Anchors
//! that all move keep the frame where it is, and the way nearly straight.

use crate::progress::unobserved;
use nalgebra::DVector;

use super::gauge::Gauge;
use super::internal::Sensing;
use super::question::Question;
use crate::fit::{InputError, Settings};
use crate::gauge_convention::GaugeConvention;
use crate::minimize::minimize;
use crate::residual::Poseless;
use cdpr_model::geometry::Pose;

/// Steps of the motion that brings held parameters back to the file's values.
const STEPS: usize = 16;

impl Question<'_> {
    /// Values of the parameters that are not held near an optimum that descents with the others held did not reach; `None` if the way around ends nowhere either.
    pub(super) fn way_around(&self, gauge: &Gauge, near: &[Pose]) -> Result<Option<Vec<f64>>, InputError> {
        let is_held = self.settings.gauge == GaugeConvention::Anchors && !gauge.held.is_empty();
        if matches!(self.sensing, Sensing::Lengths(_)) || !is_held || !self.settings.priors.is_empty() {
            return Ok(None);
        }
        let one = Settings { starts: 1, keeps_course: false, ..self.settings.clone() };
        let mut free = self.clone();
        free.hold_still(gauge);
        let mut residual = free.start(&self.model, &self.parameters, Some(near))?;
        let unknowns = free.unknowns(&self.model, &self.parameters, &one, &residual.poses())?;
        let found = minimize(&mut residual, &unknowns, None, &unobserved)?;
        if !found.end.converged() {
            return Ok(None);
        }
        Ok(self.moved_back(gauge, found.end.values, &residual.poses()))
    }

    /// Kept parameters after the motion of everything together that brings the held ones back to the file's values, where rows stay what they are.
    fn moved_back(&self, gauge: &Gauge, mut values: Vec<f64>, poses: &[Pose]) -> Option<Vec<f64>> {
        let mut poses = poses.to_vec();
        let moved = |values: &[f64], change: &DVector<f64>, fraction: f64| -> Vec<f64> {
            values.iter().zip(change.iter()).map(|(value, change)| value + fraction * change).collect()
        };
        for step in 0..STEPS {
            // the classical method of Runge and Kutta
            let left = (STEPS - step) as f64;
            let first = self.motion(gauge, &values, (&mut poses, left))?;
            let second = self.motion(gauge, &moved(&values, &first, 0.5), (&mut poses, left - 0.5))?;
            let third = self.motion(gauge, &moved(&values, &second, 0.5), (&mut poses, left - 0.5))?;
            let change = match step + 1 < STEPS {
                true => {
                    let fourth = self.motion(gauge, &moved(&values, &third, 1.0), (&mut poses, left - 1.0))?;
                    (first + (second + third) * 2.0 + fourth) / 6.0
                }
                false => third,
            };
            values = moved(&values, &change, 1.0);
        }
        let is_kept = |(place, _): &(usize, f64)| !gauge.held.contains(place);
        Some(values.into_iter().enumerate().filter(is_kept).map(|(_, value)| value).collect())
    }

    /// Change of all parameters by the motion that moves the held ones by the share of what is `left` of their way; poses follow.
    fn motion(&self, gauge: &Gauge, values: &[f64], (poses, left): (&mut Vec<Pose>, f64)) -> Option<DVector<f64>> {
        let model = self.model.with_parameters(&self.parameters, values)?;
        let here = self.rows(&model, &self.parameters, Some(poses)).ok()?;
        let lengths = here.lengths(&self.sensing);
        let moves = Gauge::of(&model, &self.parameters, &here.rows, &lengths).moves;
        *poses = here.poses;
        if moves.ncols() != gauge.held.len() {
            return None;
        }
        let of_held = moves.select_rows(&gauge.held);
        let away = |place: &usize| (self.parameters[*place].value(self.model.robot()) - values[*place]) / left;
        let way = DVector::from_iterator(gauge.held.len(), gauge.held.iter().map(away));
        Some(moves * of_held.lu().solve(&way)?)
    }
}

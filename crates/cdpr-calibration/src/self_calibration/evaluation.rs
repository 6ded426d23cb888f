//! Errors of a model at the poses where a sample's measurements agree best.

use std::borrow::Cow;

use nalgebra::DVector;

use super::found::{as_found, modelled_length};
use super::internal::Sensing;
use super::question::{Forces, check_swivels, no_equation_left, sensing};
use super::written::rows_at;
use crate::evaluation::Evaluation;
use crate::fit::InputError;
use crate::residual::Poseless;
use crate::residual::sensors::Sensor;
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{InternalSamples, Samples};
use cdpr_model::model::Model;

/// Share of a sensor's rows in a sample that its pose has to leave, for something to be judged by.
const LEAST_LEFT: f64 = 1e-6;

/// Errors of a model's lengths and swivel angles at the poses where its measurements agree best; known components of poses stay. There are no errors of poses.
///
/// Tensions count where the model is elastic, and where lengths, swivels and what is known of poses leave poses open.
pub fn evaluate_lengths(model: &Model, internal: &InternalSamples) -> Result<Evaluation, InputError> {
    let agreed = Agreed::of(model, internal)?;
    Ok(Evaluation { tension: Vec::new(), ..agreed.evaluation(false)? })
}

/// Errors of what a model predicts of samples that it was not calibrated with: residuals of lengths, tensions and swivel angles at the poses that their own
/// rows tell, by the model as it is, and divided by the root of what the poses leave of them, √(Σ(1 − h)/rows) over each sensor's rows of a sample with leverages h.
///
/// Noise of σ gives errors of σ then, whatever unknowns a sample has, so that models which use other rows are compared by the same figure. Samples without a
/// pose where measurements agree, and sensors that poses use up, have no error.
pub(crate) fn predict_sensors(model: &Model, internal: &InternalSamples) -> Result<Evaluation, InputError> {
    match Agreed::of(model, internal).and_then(|agreed| agreed.evaluation(true)) {
        Err(InputError::NoPoses) => {}
        other => return other,
    }
    let mut all = Evaluation::default();
    for sample in 0..internal.samples.len() {
        let own = internal.subset(&[sample]);
        match Agreed::of(model, &own).and_then(|agreed| agreed.evaluation(true)) {
            Err(InputError::NoPoses) => all.extend(&without_answer(model, &own)),
            other => all.extend(&other?),
        }
    }
    Ok(all)
}

/// Samples with the poses where their measurements agree best by a model as it is.
pub(crate) fn at_agreed_poses(model: &Model, internal: &InternalSamples) -> Result<Samples, InputError> {
    as_found(model, internal, &Agreed::of(model, internal)?.poses)
}

/// Errors of samples that have no pose.
fn without_answer(model: &Model, internal: &InternalSamples) -> Evaluation {
    let count = internal.samples.len();
    let unknown = |is_there: bool| vec![f64::NAN; if is_there { count * model.cable_count() } else { 0 }];
    Evaluation {
        position: vec![f64::NAN; count],
        position_vector: vec![[f64::NAN; 3]; count],
        rotation: vec![f64::NAN; count],
        length: unknown(true),
        tension: unknown(model.needs_tensions() && internal.samples.tensions.is_some()),
        swivel: unknown(internal.swivels.is_some()),
        cable_count: model.cable_count(),
        not_converged: (0..count).map(|sample| (sample, "its measurements agree at no pose".to_owned())).collect(),
    }
}

/// Samples at the poses where they agree best.
struct Agreed<'a> {
    model: &'a Model,
    internal: Cow<'a, InternalSamples>,
    sensing: Sensing,
    poses: Vec<Pose>,
    residuals: DVector<f64>,
    /// Share of each row that its pose takes up; empty where only lengths are rows.
    leverages: Vec<f64>,
}

impl<'a> Agreed<'a> {
    fn of(model: &'a Model, internal: &'a InternalSamples) -> Result<Self, InputError> {
        let (robot, data) = (model.cable_count(), internal.samples.cable_count);
        if robot != data {
            return Err(InputError::CableCount { robot, data });
        }
        check_swivels(model, internal)?;
        let (internal, sensing) = used(model, internal);
        let mut residual = sensing.residual(model, &internal, &[], &[]);
        if residual.equation_count().is_none() {
            return Err(no_equation_left(model, &sensing));
        }
        let residuals = rows_at(&mut residual, model, &[])?.residuals;
        let (poses, leverages) = (residual.poses(), residual.leverages());
        drop(residual);
        Ok(Self { model, internal, sensing, poses, residuals, leverages })
    }

    fn evaluation(&self, is_scaled: bool) -> Result<Evaluation, InputError> {
        let count = self.poses.len();
        let length = match self.sensing {
            Sensing::Lengths(_) => self.lengths_alone(is_scaled)?,
            Sensing::All(..) => self.errors(Sensor::Length, is_scaled),
        };
        Ok(Evaluation {
            position: vec![f64::NAN; count],
            position_vector: vec![[f64::NAN; 3]; count],
            rotation: vec![f64::NAN; count],
            length,
            // rigid cables predict no tension: theirs are adjusted to equilibrium alone
            tension: if self.model.needs_tensions() { self.errors(Sensor::Tension, is_scaled) } else { Vec::new() },
            swivel: self.errors(Sensor::Swivel, is_scaled),
            cable_count: self.model.cable_count(),
            not_converged: Vec::new(),
        })
    }

    /// Errors where lengths are the only rows.
    fn lengths_alone(&self, is_scaled: bool) -> Result<Vec<f64>, InputError> {
        let (model, m) = (self.model, self.model.cable_count());
        let found = as_found(model, &self.internal, &self.poses)?;
        let factor = |sample: usize| {
            let unknown = self.internal.known[sample].iter().filter(|known| !**known).count();
            if is_scaled { factor(unknown as f64, m) } else { 1.0 }
        };
        let error = |(k, recorded): (usize, &f64)| {
            factor(k / m) * (modelled_length(model, k % m, &found.poses[k / m]) - recorded)
        };
        Ok(found.lengths.iter().enumerate().map(error).collect())
    }

    /// Errors of a sensor, sample by sample; none of one that is not there.
    fn errors(&self, sensor: Sensor, is_scaled: bool) -> Vec<f64> {
        let Sensing::All(layout, weights) = &self.sensing else { return Vec::new() };
        let places: Vec<usize> = layout.places(sensor, self.poses.len()).collect();
        let count = places.len() / self.poses.len().max(1);
        let sigma = weights.sigma(sensor).unwrap_or(f64::NAN);
        let of_sample = |rows: &[usize]| -> Vec<f64> {
            let taken = rows.iter().map(|row| self.leverages[*row]).sum();
            let factor = if is_scaled { sigma * factor(taken, count) } else { sigma };
            rows.iter().map(|row| self.residuals[*row] * factor).collect()
        };
        places.chunks(count.max(1)).flat_map(of_sample).collect()
    }
}

/// Factor of residuals of which poses take up so much; not a number where nothing is left.
fn factor(taken: f64, rows: usize) -> f64 {
    let left = 1.0 - taken / rows as f64;
    if left > LEAST_LEFT { left.sqrt().recip() } else { f64::NAN }
}

/// Measurements that tell poses, with their rows.
fn used<'a>(model: &Model, internal: &'a InternalSamples) -> (Cow<'a, InternalSamples>, Sensing) {
    let geometry =
        InternalSamples { samples: Samples { tensions: None, ..internal.samples.clone() }, ..internal.clone() };
    let by_geometry = sensing(model, &geometry, Forces::Sensors);
    let is_determined =
        !model.needs_tensions() && by_geometry.residual(model, &geometry, &[], &[]).equation_count().is_some();
    match is_determined || internal.samples.tensions.is_none() {
        true => (Cow::Owned(geometry), by_geometry),
        false => (Cow::Borrowed(internal), sensing(model, internal, Forces::Sensors)),
    }
}

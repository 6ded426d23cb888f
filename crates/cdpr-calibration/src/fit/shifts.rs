//! Changes of recorded lengths inside a record: steps from a line on and drifts, found around fits.
//!
//! Lengths are fitted as the winches would record them at the end of the record. A step of Gauss and Newton over shifts and parameters together then
//! corrects the shifts, and the next fit the parameters, until no shift moves by more than 1e-4 of its deviation.

mod estimate;
#[cfg(test)]
mod tests;

use nalgebra::{DMatrix, DVector};

pub use estimate::ShiftEstimate;
use estimate::clock;
pub(super) use estimate::undone;

use super::input_error::InputError;
use super::{Fit, Settings, Status};
use crate::problem::Problem;
use crate::stopping::{StoppedBy, StoppingRule};
use cdpr_model::measurement::Samples;
use cdpr_model::model::{FreeParameters, LengthShift};
use cdpr_model::robot::{Parameter, ParameterKind};
use cdpr_model::scalar::decomposition::pseudo_inverse;

/// Fits at most, and the part of a deviation that a shift still moves where it has settled.
const ROUNDS: u32 = 30;
const SETTLED: f64 = 1e-4;
/// Steps below this are rounding (m).
const ROUNDING: f64 = 1e-12;
/// Share of the largest eigenvalue below which a combination of parameters is not determined.
const DEPENDENT: f64 = 1e-10;
/// Share of a shift's information below which a change of the parameters has the same effect.
const OPEN: f64 = 1e-12;

/// Fit of parameters to samples without shifts.
type Plain<'a> = &'a dyn Fn(&Samples, &FreeParameters) -> Result<Fit, InputError>;

/// Fits the free parameters together with shifts of recorded lengths; `plain` fits without them.
pub(super) fn fit(
    samples: &Samples,
    free: &FreeParameters,
    shifts: &[LengthShift],
    settings: &Settings,
    plain: Plain<'_>,
) -> Result<Fit, InputError> {
    let mut estimates = starts(samples, shifts)?;
    let free = free.without_length_shifts();
    let mut rounds = 0;
    loop {
        rounds += 1;
        let after = undone(samples, &estimates);
        let mut fit = plain(&after, &free)?;
        let step = Step::of(&fit, &after, &estimates, settings)?;
        let sigmas = step.sigmas(fit.analysis.inflation);
        let is_settled = |(change, sigma): (&f64, &f64)| change.abs() <= (SETTLED * sigma).max(ROUNDING);
        let has_settled = step.change.iter().zip(&sigmas).all(is_settled);
        if !has_settled && rounds < ROUNDS {
            estimates.iter_mut().zip(step.change.iter()).for_each(|(estimate, change)| estimate.change += change);
            continue;
        }
        for (estimate, sigma) in estimates.iter_mut().zip(sigmas) {
            let cable = &fit.model.robot().cables[estimate.shift.cable];
            (estimate.sigma, estimate.offset_after) = (sigma, cable.length_offset.unwrap_or(0.0));
        }
        step.widen(&mut fit);
        if !has_settled {
            tell_unsettled(&mut fit);
        }
        fit.shifts = estimates;
        return Ok(fit);
    }
}

/// Takes the optimum back, where shifts still move.
fn tell_unsettled(fit: &mut Fit) {
    if fit.status == Status::Converged {
        let rounds = f64::from(ROUNDS);
        fit.status = Status::NotConverged;
        fit.stopped_by = StoppedBy { rule: StoppingRule::IterationLimit, value: rounds, limit: rounds };
        fit.reason = format!("changes of recorded lengths did not settle in {ROUNDS} fits; {}", fit.reason);
    }
}

/// Shifts of size zero to begin with; an error where all samples of the record lie on one side of a shift.
fn starts(samples: &Samples, shifts: &[LengthShift]) -> Result<Vec<ShiftEstimate>, InputError> {
    let is_timed = samples.time.is_some();
    let own: Vec<f64> = clock(samples, is_timed)
        .into_iter()
        .enumerate()
        .filter_map(|(sample, at)| (!samples.is_appended(sample)).then_some(at))
        .collect();
    let record =
        [own.iter().copied().fold(f64::INFINITY, f64::min), own.iter().copied().fold(-f64::INFINITY, f64::max)];
    let start = |&shift: &LengthShift| {
        let estimate = ShiftEstimate { shift, change: 0.0, sigma: f64::NAN, offset_after: f64::NAN, record, is_timed };
        let remaining = estimate.remaining(samples);
        let is_told = remaining.iter().any(|share| *share > 0.0) && remaining.iter().any(|share| *share < 1.0);
        is_told.then_some(estimate).ok_or_else(|| InputError::ShiftUntold { name: shift.to_string() })
    };
    shifts.iter().map(start).collect()
}

/// Step of shifts and parameters from the optimum of the parameters alone.
struct Step {
    change: DVector<f64>,
    /// In units of the rows' noise.
    covariance: DMatrix<f64>,
    /// Change of the parameters with the shifts.
    following: DMatrix<f64>,
}

impl Step {
    fn of(fit: &Fit, samples: &Samples, shifts: &[ShiftEstimate], settings: &Settings) -> Result<Self, InputError> {
        let seen = fit.as_fitted(samples);
        let base: Vec<Parameter> = fit.parameters.iter().map(|estimate| estimate.parameter).collect();
        let parameters = with_offsets(&base, shifts);
        let place = |parameter: &Parameter| parameters.iter().position(|other| other == parameter);
        let mut rows = Problem::new(&fit.model, &seen, &parameters, settings)?.rows()?;
        // outliers count as they did in the fit
        if let Some(norms) = fit.rows.as_ref().map(|rows| &rows.norms).filter(|_| fit.samples == seen.len()) {
            (0..seen.len()).for_each(|sample| rows.scale(sample, norms.weight(sample).sqrt()));
        }
        let count = rows.jacobian.nrows();
        let mut own = DMatrix::zeros(count, shifts.len());
        for (column, estimate) in shifts.iter().enumerate() {
            let offset = offset_of(estimate.shift.cable);
            let Some(of_offset) = place(&offset) else { continue };
            let remaining = estimate.remaining(&seen);
            for row in 0..count {
                // the recorded length grows by it, and the modelled one would by an offset
                own[(row, column)] = -remaining[row / rows.size()] * rows.jacobian[(row, of_offset)];
            }
        }
        let columns: Vec<usize> = base.iter().filter_map(place).collect();
        let of_base = rows.jacobian.select_columns(&columns);
        let priors = crate::identifiability::prior_weights(&base, settings);
        let pulls = fit.parameters.iter().zip(&priors).map(|(own, weight)| weight * own.change);
        // a fit ends a little before its optimum
        let of_rest = of_base.tr_mul(&rows.residuals) + DVector::from_iterator(base.len(), pulls);
        let inverse = scaled_inverse(&(of_base.tr_mul(&of_base) + DMatrix::from_diagonal(&DVector::from_vec(priors))));
        let mixed = of_base.tr_mul(&own);
        let following = -&inverse * &mixed;
        let own_part = own.tr_mul(&own) + mixed.tr_mul(&following);
        let told = own.tr_mul(&own).diagonal();
        let gradient = own.tr_mul(&rows.residuals) + following.tr_mul(&of_rest);
        let is_open = |place: &usize| !(own_part[(*place, *place)] > OPEN * told[*place]);
        let name = |place: usize| InputError::ShiftUntold { name: shifts[place].shift.to_string() };
        if let Some(open) = (0..shifts.len()).find(is_open) {
            return Err(name(open));
        }
        let covariance = own_part.cholesky().ok_or_else(|| name(0))?.inverse();
        Ok(Self { change: -&covariance * gradient, covariance, following })
    }

    /// Standard deviations of the shifts at a factor of the rows' noise (m).
    fn sigmas(&self, noise: f64) -> Vec<f64> {
        self.covariance.diagonal().iter().map(|variance| noise * variance.max(0.0).sqrt()).collect()
    }

    /// Widens the deviations of a fit's parameters by what they follow the shifts.
    fn widen(&self, fit: &mut Fit) {
        let noise = fit.analysis.inflation;
        let added = &self.following * &self.covariance * self.following.transpose();
        for (place, estimate) in fit.parameters.iter_mut().enumerate() {
            let own = noise * added[(place, place)].max(0.0).sqrt();
            estimate.sigma = estimate.sigma.map(|sigma| sigma.hypot(own));
        }
    }
}

fn offset_of(cable: usize) -> Parameter {
    Parameter { cable, kind: ParameterKind::LengthOffset, axis: 0 }
}

/// Parameters, ordered by cable, with the length offsets of shifted cables.
fn with_offsets(base: &[Parameter], shifts: &[ShiftEstimate]) -> Vec<Parameter> {
    let mut all = base.to_vec();
    for estimate in shifts {
        let offset = offset_of(estimate.shift.cable);
        if !all.contains(&offset) {
            let is_behind = |own: &Parameter| own.cable > offset.cable || !own.kind.is_of_cable();
            let place = all.iter().position(is_behind).unwrap_or(all.len());
            all.insert(place, offset);
        }
    }
    all
}

/// Inverse in the directions that the rows determine, with rows and columns scaled to a diagonal of ones.
fn scaled_inverse(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    let scale = matrix.diagonal().map(|entry| if entry > 0.0 { entry.sqrt().recip() } else { 0.0 });
    let scaled = |matrix: &DMatrix<f64>| {
        DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| scale[i] * matrix[(i, j)] * scale[j])
    };
    scaled(&pseudo_inverse(&scaled(matrix), DEPENDENT))
}

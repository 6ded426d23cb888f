//! An estimation problem: residuals of samples, free parameters with their priors and bounds, and the cost to make small.

#[cfg(test)]
mod tests;

use crate::fit::{InputError, Settings};
use crate::loss::Loss;
use crate::minimize::cost::write_squares;
use crate::minimize::dense::DenseEquations;
use crate::minimize::unknowns::Unknowns;
use crate::minimize::{Optimum, minimize};
use crate::objective::Minimize;
use crate::progress::Progress;
use crate::residual::Given;
use crate::residual::Residual;
use crate::residual::entries::residual;
use crate::residual::rows::{Missing, Rows};
use crate::unit_scale::joint_scales;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;

/// One of so many samples may be left out of a fit since it has no prediction, and one in any case.
const MOST_LEFT_OUT: usize = 10;

/// Residuals at measured poses with the parameters that make them small.
pub(crate) struct Problem<'a> {
    pub(crate) unknowns: Unknowns<'a>,
    pub(crate) residual: Box<dyn Residual + 'a>,
    /// Samples that were left out of the optimum.
    missing: Vec<Missing>,
}

impl<'a> Problem<'a> {
    /// The problem of these parameters under settings.
    pub(crate) fn new(
        model: &Model,
        samples: &'a Samples,
        parameters: &'a [Parameter],
        settings: &'a Settings,
    ) -> Result<Self, InputError> {
        check(settings)?;
        Self::of(residual(&Given { model, samples, parameters, settings })?, samples, parameters, settings)
    }

    /// The problem of residuals at hand.
    pub(crate) fn of(
        residual: Box<dyn Residual + 'a>,
        samples: &'a Samples,
        parameters: &'a [Parameter],
        settings: &'a Settings,
    ) -> Result<Self, InputError> {
        let tensions = samples.tensions.as_deref().or(residual.tensions()).unwrap_or_default();
        let model = residual.model();
        let scales = || joint_scales(model, parameters, &samples.lengths, tensions);
        let unknowns = Unknowns {
            parameters,
            start: parameters.iter().map(|parameter| parameter.value(model.robot())).collect(),
            scale: residual.scales().unwrap_or_else(scales).into(),
            settings,
            mean_tension: tensions.iter().sum::<f64>() / tensions.len().max(1) as f64,
        };
        Ok(Self { unknowns, residual, missing: Vec::new() })
    }

    /// Finds the optimum, without samples that have no prediction at the start values as long as these are few; `progress` is called after each start.
    pub(crate) fn minimize(&mut self, progress: &Progress<'_>) -> Result<Optimum, InputError> {
        let found = minimize(&mut *self.residual, &self.unknowns, None, progress);
        let is_unpredicted = matches!(found, Err(InputError::NotFinite)) && self.residual.unpredicted().is_some();
        if !is_unpredicted {
            return found;
        }
        let samples = self.residual.layout().samples;
        self.missing = self.residual.leave_out_missing(&self.unknowns.start);
        let may_be_left_out = !self.missing.is_empty() && self.missing.len() <= (samples / MOST_LEFT_OUT).max(1);
        let again = may_be_left_out.then(|| minimize(&mut *self.residual, &self.unknowns, None, progress));
        let first = self.missing.first().map(|missing| (missing.sample, missing.reason.clone()));
        match again.unwrap_or(Err(InputError::NotFinite)) {
            Err(InputError::NotFinite) => match self.residual.unpredicted().or(first) {
                Some((sample, reason)) => Err(InputError::NoPrediction { sample: sample + 1, reason }),
                None => Err(InputError::NotFinite),
            },
            other => other,
        }
    }

    /// Samples that were left out, in words; `None` without any.
    pub(crate) fn missing_words(&self) -> Option<String> {
        let first = self.missing.first()?;
        Some(format!(
            "{} of {} samples have no predicted pose at the values of the file and are left out of the fit; the first is sample {}: {}",
            self.missing.len(),
            self.residual.layout().samples,
            first.sample + 1,
            first.reason
        ))
    }

    /// The model at parameter values.
    pub(crate) fn model_at(&self, values: &[f64]) -> Result<Model, InputError> {
        model_at(&*self.residual, &self.unknowns, values)
    }

    /// Writes the squares of a block and of its priors with half their derivatives; false where a row is not finite.
    pub(crate) fn write(&mut self, block: usize, values: &[f64], to: &mut DenseEquations) -> bool {
        let ranges = self.residual.blocks(self.unknowns.len());
        if !self.residual.normal(block, values, to) {
            let mut rows = Rows::new(self.residual.layout(), values.len());
            if !self.residual.write(values, &mut rows) {
                return false;
            }
            write_squares(&rows, to);
        }
        self.unknowns.within(ranges[block].clone()).add_priors(values, to);
        to.cost.is_finite()
    }

    /// Rows at the start values.
    pub(crate) fn rows(&mut self) -> Result<Rows, InputError> {
        let mut rows = Rows::new(self.residual.layout(), self.unknowns.len());
        self.residual.write(&self.unknowns.start, &mut rows).then_some(rows).ok_or(InputError::NotFinite)
    }
}

/// The model at parameter values.
pub(crate) fn model_at(residual: &dyn Residual, unknowns: &Unknowns<'_>, values: &[f64]) -> Result<Model, InputError> {
    residual.model().with_parameters(unknowns.parameters, values).ok_or(InputError::NotFinite)
}

/// Refuses what cannot be combined.
fn check(settings: &Settings) -> Result<(), InputError> {
    let is_robust = !matches!(settings.loss, Loss::Auto | Loss::Squared);
    if settings.minimize != Minimize::Squares && is_robust {
        return Err(InputError::RobustCost { loss: settings.loss, minimize: settings.minimize });
    }
    if settings.minimize != Minimize::Squares && !settings.priors.is_empty() {
        return Err(InputError::PriorCost { minimize: settings.minimize });
    }
    if settings.row_weights.is_some() && is_robust {
        use cdpr_model::reading::Keyword;
        return Err(InputError::RowWeightCost { words: format!("the loss `{}`", settings.loss.name()) });
    }
    Ok(())
}

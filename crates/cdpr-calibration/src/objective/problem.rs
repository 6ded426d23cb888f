//! Residual vectors of an objective for any model.

use super::Objective;
use super::balance::BalanceVectors;
use super::dense::DenseEquations;
use super::lengths::LengthVectors;
use super::metric::{Metric, position_sigma};
use super::poses::PoseVectors;
use super::unknown_poses::UnknownPoses;
use super::vectors::{Outliers, Stacked, Vectors};
use crate::elastostatic::Balance;
use crate::fit::{ASSUMED_NOISE, InputError, Settings};
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;

/// Residual vectors of an objective, in standard deviations.
pub(super) enum ObjectiveVectors<'a> {
    Lengths(LengthVectors),
    Balance(BalanceVectors<'a>),
    Poses(PoseVectors<'a>),
    Both(UnknownPoses<'a>),
}

impl Objective {
    /// True where it has residuals for a model and samples; `both` is for rigid models with stated accuracies of lengths and positions.
    pub fn has_residuals(self, model: &Model, samples: &Samples, settings: &Settings) -> bool {
        ObjectiveVectors::of(model, samples, &[], &Settings { objective: self, ..settings.clone() }).is_ok()
    }
}

impl<'a> ObjectiveVectors<'a> {
    /// Vectors at a model with the load that its parameters need, and the standard deviation in metres that is one of their units; `None` where
    /// they have none.
    pub(super) fn of(
        model: &'a Model,
        samples: &'a Samples,
        parameters: &'a [Parameter],
        settings: &Settings,
    ) -> Result<(Self, Option<f64>), InputError> {
        match (settings.objective, model.needs_tensions()) {
            (Objective::Pose, is_elastic) => {
                let metric = Metric::of(model, samples, settings.rotation_length)?;
                let unit = (!is_elastic).then(|| position_sigma(samples));
                Ok((Self::Poses(PoseVectors::new(model, samples, parameters, metric)), unit))
            }
            (Objective::Both, true) => Err(InputError::UnknownPosesOfElastic),
            (Objective::Both, false) => {
                let sigmas = &samples.sigmas;
                let (Some(sigma), Some(_)) = (known(sigmas.length), known(sigmas.position)) else {
                    return Err(InputError::NoAccuracies);
                };
                let metric = Metric::of(model, samples, settings.rotation_length)?;
                Ok((Self::Both(UnknownPoses::new(model, samples, parameters, metric, sigma)), None))
            }
            (Objective::Length, true) => {
                let balance = Balance::new(model, samples, parameters)?;
                Ok((Self::Balance(BalanceVectors::new(model, samples, parameters, balance)), None))
            }
            (Objective::Length, false) => {
                let sigma = known(samples.sigmas.length).unwrap_or(ASSUMED_NOISE);
                Ok((Self::Lengths(LengthVectors::new(model, samples, parameters, sigma)), Some(sigma)))
            }
        }
    }

    /// Sample without a prediction (from 0) where the vectors were written last, with the reason.
    pub(super) fn unpredicted(&self) -> Option<(usize, String)> {
        match self {
            Self::Poses(poses) => poses.unpredicted(),
            _ => None,
        }
    }
}

/// A stated accuracy that is one.
fn known(sigma: Option<f64>) -> Option<f64> {
    sigma.filter(|sigma| *sigma > 0.0)
}

impl Vectors for ObjectiveVectors<'_> {
    fn size(&self) -> usize {
        match self {
            Self::Lengths(vectors) => vectors.size(),
            Self::Balance(vectors) => vectors.size(),
            Self::Poses(vectors) => vectors.size(),
            Self::Both(vectors) => vectors.size(),
        }
    }

    fn unknowns(&self) -> usize {
        match self {
            Self::Both(vectors) => vectors.unknowns(),
            _ => 0,
        }
    }

    fn samples(&self) -> usize {
        match self {
            Self::Lengths(vectors) => vectors.samples(),
            Self::Balance(vectors) => vectors.samples(),
            Self::Poses(vectors) => vectors.samples(),
            Self::Both(vectors) => vectors.samples(),
        }
    }

    fn restart(&mut self) {
        if let Self::Poses(vectors) = self {
            vectors.restart();
        }
    }

    fn outliers(&self) -> Option<Outliers> {
        Some(if let Self::Poses(_) = self { Outliers::Witnessed } else { Outliers::Own })
    }

    fn squares(&self) -> Option<(&[f64], Vec<f64>)> {
        match self {
            Self::Poses(vectors) => vectors.squares(),
            _ => None,
        }
    }

    fn write_squares(&mut self, values: &[f64], equations: &mut DenseEquations) -> bool {
        match self {
            Self::Poses(vectors) => vectors.write_squares(values, equations),
            _ => false,
        }
    }

    fn write(&mut self, values: &[f64], stacked: &mut Stacked) -> bool {
        match self {
            Self::Lengths(vectors) => vectors.write(values, stacked),
            Self::Balance(vectors) => vectors.write(values, stacked),
            Self::Poses(vectors) => vectors.write(values, stacked),
            Self::Both(vectors) => vectors.write(values, stacked),
        }
    }
}

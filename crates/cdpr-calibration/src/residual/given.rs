//! Model, samples and settings that residuals are made of.

use crate::fit::Settings;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;

/// Question to residuals.
#[derive(Clone, Copy)]
pub(crate) struct Given<'a, 'm> {
    /// The model before the fit, with the load that its parameters need.
    pub(crate) model: &'m Model,
    pub(crate) samples: &'a Samples,
    /// The free parameters, ordered by cable.
    pub(crate) parameters: &'a [Parameter],
    pub(crate) settings: &'a Settings,
}

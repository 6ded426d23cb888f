//! Entry of a criterion in the registry: its name, its numbers and its constructor.

use super::Criterion;
use crate::WorkspaceError;
use cdpr_model::model::Model;
use cdpr_model::statics::{Load, LoadError};
use cdpr_model::tension::{Limits, LimitsError};

/// Inputs of criteria. Load and limits may be unknown: only criteria that need them fail then.
#[derive(Clone, Debug)]
pub struct Setting<'a> {
    /// Robot and effects.
    pub model: &'a Model,
    /// Load on the platform, without the cables.
    pub load: Result<Load, LoadError>,
    /// Least and largest tensions.
    pub limits: Result<Limits, LimitsError>,
}

/// A criterion that can be requested by name.
pub struct Entry {
    /// Name of the criterion.
    pub name: &'static str,
    /// Property of a pose that it tests, in one line.
    pub summary: &'static str,
    /// The numbers that the criterion takes, with their units.
    pub numbers: &'static [Number],
    pub(super) make: Make,
}

pub(super) type Make = for<'a> fn(&Setting<'a>, &CriterionRequest) -> Result<Box<dyn Criterion + 'a>, WorkspaceError>;

/// A number that a criterion takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Number {
    /// Name of the number.
    pub name: &'static str,
    /// Unit of the number.
    pub unit: &'static str,
    /// False if the criterion has a default for it.
    pub is_required: bool,
}

/// A criterion as it is requested: `NAME` or `NAME:NUMBER=VALUE,…`.
#[derive(Clone, Debug, PartialEq)]
pub struct CriterionRequest {
    pub(super) name: &'static str,
    pub(super) numbers: Vec<(&'static str, f64)>,
}

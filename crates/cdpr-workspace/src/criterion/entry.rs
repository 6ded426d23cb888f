//! Entry of a criterion in the registry: name, numbers, and how it is made.

use super::Criterion;
use crate::WorkspaceError;
use cdpr_model::model::Model;
use cdpr_model::statics::{Load, LoadError};
use cdpr_model::tension::{Limits, LimitsError};

/// Ingredients of criteria. Load and limits may be unknown: only criteria that need them refuse then.
#[derive(Clone, Debug)]
pub struct Setting<'a> {
    /// Robot and effects.
    pub model: &'a Model,
    /// Load on the platform besides the cables.
    pub load: Result<Load, LoadError>,
    /// Least and largest tensions.
    pub limits: Result<Limits, LimitsError>,
}

/// A criterion that can be asked for by name.
pub struct Entry {
    /// The name.
    pub name: &'static str,
    /// Question that it asks of a pose, in one line.
    pub summary: &'static str,
    /// The numbers that it takes, with their unit.
    pub numbers: &'static [Number],
    pub(super) make: Make,
}

pub(super) type Make = for<'a> fn(&Setting<'a>, &CriterionRequest) -> Result<Box<dyn Criterion + 'a>, WorkspaceError>;

/// A number that a criterion takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Number {
    /// Its name.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// False where the criterion does without it.
    pub is_required: bool,
}

/// A criterion as it is asked for: `NAME` or `NAME:NUMBER=VALUE,…`.
#[derive(Clone, Debug, PartialEq)]
pub struct CriterionRequest {
    pub(super) name: &'static str,
    pub(super) numbers: Vec<(&'static str, f64)>,
}

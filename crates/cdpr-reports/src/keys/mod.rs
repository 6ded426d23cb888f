//! Keys of library values in answers.
//!
//! Library values have plain names and no format. A table of keys is a struct with those fields of a value that answers tell, under their keys:
//! with `#[serde(remote)]` or [`adapters::keys`] it writes the value itself, so that an answer holds what the library gave and nothing is copied. `with = "PoseErrorKeys"` on a
//! field of an answer says so for a value, [`Each`] for a list, [`Maybe`] for an optional value, [`Word`] for a choice that has a name.

pub(crate) mod adapters;
mod design;
mod errors;
mod fit;
mod identification;
mod parameters;
mod robot;
mod run;
mod selection;
mod statics;
mod study;
pub(crate) mod table_schema;
mod tables;
mod warnings;
mod workspace;

pub(crate) use adapters::{Each, FromOne, Keys, Maybe, Shown, Word};
pub(crate) use design::{PlanKeys, PredictedKeys};
pub(crate) use errors::{ErrorBlockKeys, LengthErrorKeys, PoseErrorKeys, TensionErrorKeys};
pub(crate) use fit::{OutlierKeys, RecordingFrameKeys, ShiftKeys};
pub(crate) use identification::{ComparisonKeys, IdentificationKeys, OptimumKeys, SelfCalibrationKeys};
pub(crate) use parameters::{
    ConditioningKeys, CourseStepKeys, PathParameterKeys, PathPointKeys, ProfileKeys, ReductionKeys, ResampledKeys,
};
pub(crate) use robot::FindingKeys;
pub(crate) use run::{EnergyKeys, SlackKeys, ViolationKeys};
pub(crate) use selection::{CoverageKeys, JudgementKeys, PredictedBandKeys, PreferenceKeys};
pub(crate) use statics::{DisplacementKeys, ExtentKeys, InfeasibilityKeys, JudgedMapKeys};
pub(crate) use study::{
    AccuracyKeys, BeyondKeys, BranchesKeys, DifferenceKeys, ForceTrackingKeys, HistoryKeys, SummaryKeys,
};
pub(crate) use tables::{
    AllowanceKeys, BenchmarkKeys, ChainStepKeys, InfluenceKeys, KindInfluenceKeys, MonteCarloKeys, RoundKeys,
    SweepRowKeys,
};
pub(crate) use warnings::{FoundKeys, WarningKeys};
pub(crate) use workspace::AuditKeys;

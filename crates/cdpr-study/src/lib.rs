//! A control model on a machine: the poses and tensions that emerge if one model's lengths drive another.

pub mod accuracy;
pub mod advice;
pub mod benchmark;
pub mod branches;
#[cfg(feature = "files")]
mod calibration_cost;
pub mod campaign;
pub mod chain;
pub mod difference;
pub mod effects;
mod error_code;
mod experiment;
pub mod field;
pub mod force_tracking;
mod identification;
mod objective_comparison;
pub mod parts;
mod poorer;
mod prediction;
pub mod reachable;
pub mod sensitivity;
pub mod study;
#[cfg(feature = "files")]
pub mod sweep;
pub mod tolerance;

pub use experiment::{Experiment, ExperimentError, Robots};
pub use identification::{Identification, IdentificationData, identify};
pub use objective_comparison::{Driven, JudgedOptimum, OptimumOf, compare_objectives};
pub use poorer::missing_effects;
pub use prediction::PredictionError;
pub use study::{Study, Task};

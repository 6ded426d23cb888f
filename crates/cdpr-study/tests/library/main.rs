//! Tests of whole questions of this crate, in one program beside the library.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "tests fail by panic and show their figures"
)]

#[path = "../support/studies.rs"]
mod studies;
#[path = "../../../cdpr-model/tests/support/mod.rs"]
mod support;

mod compensation;
mod compositions;
mod course;
mod elastostatic_identification;
mod force_tracking;
mod frames;
mod identifiability;
mod inverse_and_forward;
mod metamodel;
mod objectives;
mod outliers;
mod outliers_of_objectives;
mod planar_pulleys;
mod row_weights;
mod sensitivity;
mod starts;
mod tolerance;
mod twin;
mod winch_identification;
mod winches;

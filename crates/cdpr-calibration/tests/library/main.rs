//! Tests of whole questions of this crate, in one program beside the library.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "tests fail by panic and show their figures"
)]

#[path = "../dense/mod.rs"]
mod dense;
#[path = "../../../cdpr-model/tests/support/mod.rs"]
mod support;

mod coverage;
mod default_ladder;
mod denied;
mod elastostatic_oracle;
mod friction;
mod gtcable;
mod identification_oracle;
mod irma4u;
mod load_coverage;
mod partial_poses;
mod predicted_band;
mod selection_truth;
mod self_calibration;
mod self_calibration_by_sensors;
mod self_calibration_coverage;
mod self_calibration_held_out;
mod self_calibration_turned;
mod stopping;
mod told_by_statics;
mod verdicts;

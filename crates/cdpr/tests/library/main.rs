//! The library's tests of whole questions, in the program of its unit tests (`src/lib.rs`): the library is compiled for tests once.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "tests fail by panic and show their figures"
)]

#[path = "../dense/mod.rs"]
mod dense;
#[path = "../distribution/mod.rs"]
mod distribution;
#[path = "../distribution/problems.rs"]
mod problems;
#[path = "../readers/mod.rs"]
mod readers;
#[path = "../support/mod.rs"]
pub(crate) mod support;

mod caspr_import;
mod compositions;
mod course;
mod coverage;
mod elastostatic_extremes;
mod elastostatic_identification;
mod elastostatic_oracle;
mod elastostatics;
mod feasibility_oracle;
mod force_tracking;
mod foreign_reader_properties;
mod forward_kinematics;
mod forward_statics;
mod frames;
mod gtcable;
mod identifiability;
mod identification_oracle;
mod inverse_and_forward;
mod irma4u;
mod metamodel;
mod no_allocation;
mod no_panic;
mod objectives;
mod outliers;
mod outliers_of_objectives;
mod planar_pulleys;
mod random_workspaces;
mod reader_properties;
mod robot_files;
mod selection_truth;
mod self_calibration;
mod self_calibration_by_sensors;
mod self_calibration_coverage;
mod self_calibration_held_out;
mod self_calibration_turned;
mod sensitivity;
mod starts;
mod statics_properties;
mod statics_reference;
mod tension_collection;
mod tension_methods;
mod tension_oracle;
mod tension_reference;
mod tension_shapes;
mod tolerance;
mod twin;
mod underactuated;
mod verdicts;
mod winch_identification;
mod winches;
mod workspace_figures;
mod workspace_laws;
mod workspace_properties;
mod workspace_surfaces;
mod wrench_set_oracle;

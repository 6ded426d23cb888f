//! Tests of whole questions of this crate, in one program beside the library.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "tests fail by panic and show their figures"
)]

#[path = "../distribution/mod.rs"]
mod distribution;
#[path = "../distribution/problems.rs"]
mod problems;
#[path = "../support/mod.rs"]
mod support;

mod caspr_import;
mod elastostatic_extremes;
mod elastostatics;
mod feasibility_oracle;
mod forward_kinematics;
mod forward_statics;
mod robot_doubts;
mod robot_files;
mod statics_properties;
mod statics_reference;
mod tension_collection;
mod tension_methods;
mod tension_oracle;
mod tension_reference;
mod tension_shapes;
mod underactuated;

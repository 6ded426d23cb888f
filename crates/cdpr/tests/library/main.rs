//! The library's tests through its public interface, in one program: the library is linked once, and no core waits for the last test of a
//! file. Only tests that replace the allocator stand beside it.
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
mod support;

mod caspr_import;
mod compositions;
mod coverage;
mod elastostatic_identification;
mod elastostatic_oracle;
mod elastostatics;
mod feasibility_oracle;
mod foreign_reader_properties;
mod forward_kinematics;
mod forward_statics;
mod gtcable;
mod identifiability;
mod identification_oracle;
mod irma4u;
mod metamodel;
mod no_panic;
mod planar_pulleys;
mod random_workspaces;
mod reader_properties;
mod robot_files;
mod selection_truth;
mod sensitivity;
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
mod winch_identification;
mod winches;
mod workspace_figures;
mod workspace_properties;
mod workspace_surfaces;
mod wrench_set_oracle;

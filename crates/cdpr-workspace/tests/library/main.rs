//! Tests of whole questions of this crate, in one program beside the library.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "tests fail by panic and show their figures"
)]

#[path = "../../../cdpr-model/tests/distribution/mod.rs"]
mod distribution;
#[path = "../../../cdpr-model/tests/support/mod.rs"]
mod support;

mod random_workspaces;
mod shape;
mod workspace_figures;
mod workspace_laws;
mod workspace_properties;
mod workspace_surfaces;
mod wrench_set_oracle;

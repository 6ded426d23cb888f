//! Tests of whole questions of this crate, in one program beside the library.
#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "tests fail by panic and show their figures"
)]

#[path = "../../../cdpr-calibration/tests/dense/mod.rs"]
mod dense;
#[path = "../readers/mod.rs"]
mod readers;
#[path = "../../../cdpr-model/tests/support/mod.rs"]
mod support;

mod foreign_reader_properties;
mod no_allocation;
mod no_panic;
mod reader_properties;

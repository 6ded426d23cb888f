//! The reader `compensation` on whatever libFuzzer finds.
#![no_main]

#[path = "../../crates/cdpr/tests/readers/mod.rs"]
mod readers;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| readers::check("compensation", bytes));

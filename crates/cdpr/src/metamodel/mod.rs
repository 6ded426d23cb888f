//! A control model on a machine: what emerges when one model's lengths drive another.

pub mod errors;
pub mod simulate;
pub mod study;

pub use study::Study;

//! The toolchain for cable-driven parallel robots: models, calibration and model selection.

pub use nalgebra;

pub mod geometry;
pub mod measurement;
pub mod reading;
pub mod robot;
pub mod scalar;

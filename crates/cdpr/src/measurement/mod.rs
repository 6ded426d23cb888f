//! Measured samples: poses, cable lengths, tensions; their files and how accurate the sensors are.

mod samples;

pub use samples::{Samples, SensorSigmas};

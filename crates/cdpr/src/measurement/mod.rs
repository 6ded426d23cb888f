//! Measured samples: poses, cable lengths, tensions; their files and how accurate the sensors are.

mod samples;
mod split;

pub use samples::{Samples, SensorSigmas};
pub use split::Fold;

//! Measured samples: poses, cable lengths, tensions; their files and how accurate the sensors are.

mod columns;
mod csv_reading;
mod csv_writing;
mod header_mistakes;
mod internal_samples;
mod magnitudes;
mod mix_ups;
mod pose_track;
mod samples;
mod sidecar;
mod split;
mod standing;

pub use csv_reading::{MeasurementFile, Reading, ReadingOptions, poses_from_csv};
pub use internal_samples::InternalSamples;
pub(crate) use magnitudes::{decimals, three_digits};
pub use samples::{DataError, Samples, SensorSigmas};
pub use sidecar::{Frames, Provenance, Sidecar, schema};
pub use split::{Fold, Split, SplitError};
pub use standing::StaticSamples;

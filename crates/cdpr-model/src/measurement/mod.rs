//! Measured samples: poses, cable lengths, tensions; their files and the accuracies of the sensors.

#[cfg(feature = "files")]
mod columns;
#[cfg(feature = "files")]
mod comparison;
#[cfg(feature = "files")]
mod csv_reading;
#[cfg(feature = "files")]
mod csv_writing;
mod digits;
#[cfg(feature = "files")]
mod header_mistakes;
mod holds;
mod internal_samples;
mod known;
#[cfg(feature = "files")]
mod magnitudes;
#[cfg(feature = "files")]
pub mod mix_ups;
mod pose_columns;
#[cfg(feature = "files")]
mod pose_track;
mod samples;
mod sidecar;
#[cfg(feature = "files")]
mod sidecar_file;
mod split;
mod standing;
#[cfg(feature = "files")]
mod tension_units;

#[cfg(feature = "files")]
pub use csv_reading::{MeasurementFile, Reading, ReadingOptions, poses_from_csv};
pub use digits::{decimals, three_digits};
pub use internal_samples::InternalSamples;
pub use known::{Fact, Known, KnownError};
pub use pose_columns::{pose_columns, pose_numbers, position_columns, turn_columns, turn_numbers};
pub use samples::{DataError, Samples, SensorSigmas};
pub use sidecar::{Frames, Provenance, Sidecar, schema};
pub use split::{Fold, Split, SplitError};
pub use standing::StaticSamples;

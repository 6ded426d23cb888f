//! The file beside a data set: `<data>.meta.toml` with sensor accuracies, frames and provenance.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::SensorSigmas;

/// Metadata of a data set: sensors, frames and provenance of its samples.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sidecar {
    /// Version of the layout: 1.
    pub layout_version: u32,
    /// Standard deviations of the sensors PER AXIS; missing means unknown.
    #[serde(default)]
    pub sigmas: SensorSigmas,
    /// Columns of the file by the names that measurements have, e.g. `x_m = "X_world"`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub columns: BTreeMap<String, String>,
    /// Facts known of the robot, for calibration without poses: `distance[1,2]=2.412+-0.002` and the like.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub known: Vec<String>,
    /// The frames that poses refer to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub frames: Option<Frames>,
    /// Provenance of the data.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub provenance: Option<Provenance>,
}

/// The frames that poses refer to.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Frames {
    /// In words.
    pub description: String,
}

/// Provenance of data.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Provenance {
    /// Experiment, publication or command.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub source: Option<String>,
    /// Licence of the data.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub licence: Option<String>,
    /// Robot that was measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub robot: Option<String>,
    /// Seed of simulated data.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
    /// Remarks.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
}

/// JSON Schema of sidecar files; its description lists the columns of the CSV beside it.
pub fn schema() -> schemars::Schema {
    let mut schema = schemars::schema_for!(Sidecar);
    let columns = "Sidecar `<data>.meta.toml` of a measurement CSV. Columns of the CSV: x_m, y_m, z_m position, of planar \
                   robots the two of their axes (x_m, z_m in the plane xz; files with x_m, y_m are read, too); qx, qy, qz, qw \
                   unit quaternion, or rx_rad, ry_rad, rz_rad with R = Rx Ry Rz (3R3T), or angle_rad (1R2T); \
                   cable_length_m_1…m, or cable_length_change_m_1…m from one unknown pose, or motor_angle_rad_1…m of the winches in their place; optional tension_N_1…m, set, t_s, of data without poses also swivel_rad_1…m of the pulleys (about pulley_swivel_axis, 0 towards gravity) and mass_kg of the platform with its load in a sample (optional). _mm, _deg and _kN are accepted and converted; \
                   other columns are ignored with a notice. Fields are separated by commas, semicolons or tabs, decimals by points or, with the latter two, commas; lines \
                   that begin with # are comments; UTF-8, UTF-16 and Latin-1 are read.";
    schema.insert("description".to_owned(), columns.into());
    schema
}

//! The file of a map (TOML).

use nalgebra::{DMatrix, Quaternion, UnitQuaternion, Vector3};
use serde::{Deserialize, Serialize};

use super::field::{Field, factor};
use super::map::Compensation;
use super::map_error::MapError;
use super::pose_space::PoseSpace;
use crate::geometry::Pose;
use crate::model::Model;
use crate::reading::{ReadError, Size, TomlDocument, text_from_bytes};

/// Range of scales and numbers outside which a file has an error.
const SMALLEST: f64 = 1e-9;
const LARGEST: f64 = 1e30;

/// Largest deviation of a squared quaternion from 1 by rounding.
const UNIT: f64 = 1e-9;

/// Layout of the file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    /// Version of the layout: 1.
    layout_version: u32,
    /// Robot and model for which the map was made.
    robot: String,
    model: String,
    /// Correlation length of the corrections (m).
    length_scale_m: f64,
    /// Variance of noise as a multiple of the variance of the smooth part.
    noise_ratio: f64,
    /// Length that corresponds to one radian (m).
    lever_m: f64,
    /// Mean correction of every cable (m).
    mean_m: Vec<f64>,
    /// Smallest and largest coordinate of the samples about the centre (m).
    ranges_m: Vec<[f64; 2]>,
    centre: Centre,
    sample: Vec<Sample>,
}

impl File {
    /// True if every number is possible for a map.
    fn has_numbers(&self) -> bool {
        let Centre { position_m, quaternion_xyzw, .. } = &self.centre;
        let samples = self.sample.iter().flat_map(|sample| sample.at_m.iter().chain(&sample.weights_m));
        let numbers = self.mean_m.iter().chain(self.ranges_m.iter().flatten()).chain(position_m).chain(quaternion_xyzw);
        let is_above = |value: f64| (SMALLEST..LARGEST).contains(&value);
        let sizes = || self.ranges_m.iter().map(|[low, high]| high - low);
        is_above(self.length_scale_m)
            && is_above(self.noise_ratio)
            && is_above(self.lever_m)
            && sizes().all(|size| size >= 0.0)
            && sizes().any(is_above)
            && numbers.chain(samples).all(|number| number.abs() < LARGEST)
            && (quaternion_xyzw.iter().map(|number| number * number).sum::<f64>() - 1.0).abs() < UNIT
    }
}

/// Pose about which coordinates are measured.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Centre {
    position_m: [f64; 3],
    quaternion_xyzw: [f64; 4],
    /// Lengths of the model there, for any tensions (m): another model has other lengths.
    cable_lengths_m: Vec<f64>,
}

/// Sample of the map.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Sample {
    /// Coordinates about the centre, rotations times the lever (m).
    at_m: Vec<f64>,
    /// Weight of its kernel for every cable (m).
    weights_m: Vec<f64>,
}

impl Compensation {
    /// The map as a file.
    pub fn to_toml(&self) -> String {
        let (space, field) = (&self.space, &self.field);
        let coordinates = space.centre.rotation.coords;
        let sample = |(row, point): (usize, &Vec<f64>)| Sample {
            at_m: point.clone(),
            weights_m: field.weights.row(row).iter().copied().collect(),
        };
        let file = File {
            layout_version: 1,
            robot: self.robot.clone(),
            model: self.model.clone(),
            length_scale_m: field.length_scale,
            noise_ratio: field.noise_ratio,
            lever_m: space.lever,
            mean_m: field.mean.clone(),
            ranges_m: space.ranges.clone(),
            centre: Centre {
                position_m: space.centre.position.into(),
                quaternion_xyzw: coordinates.into(),
                cable_lengths_m: self.at_centre.clone(),
            },
            sample: field.points.iter().enumerate().map(sample).collect(),
        };
        let words = "# Correction of cable lengths over the workspace: add to the recorded lengths of the model at a pose.\n\
                     # It acts as a whole within ranges_m, fades to zero over a margin around them, and in gaps between samples.\n";
        // numbers and texts can always be written as TOML
        format!("{words}{}", toml::to_string(&file).unwrap_or_default())
    }

    /// Reads a map; an error if it was made for another model.
    pub fn from_toml_bytes(bytes: &[u8], file_name: &str, model: &Model) -> Result<Self, MapError> {
        let document = TomlDocument::parse(text_from_bytes(bytes, Size::Table, file_name)?, file_name)?;
        let file: File = document.deserialize()?;
        let refused = |message: &str| ReadError::new(file_name, "compensation::file", message.to_owned());
        if file.layout_version != 1 {
            return Err(refused("this version reads layout_version = 1").into());
        }
        if !file.has_numbers() {
            return Err(refused(
                "its numbers are below 1e30, scales, lever and the largest range from 1e-9 on, ranges ascend, its quaternion has length 1",
            )
            .into());
        }
        let (dof, cables) = (model.dof(), file.mean_m.len());
        let fits = |sample: &Sample| sample.at_m.len() == file.ranges_m.len() && sample.weights_m.len() == cables;
        if file.ranges_m.len() != dof || cables != model.cable_count() || !file.sample.iter().all(fits) {
            let message = format!("a map of this robot has {dof} coordinates and {} cables", model.cable_count());
            return Err(refused(&message).into());
        }
        let weights = DMatrix::from_fn(file.sample.len(), cables, |row, cable| file.sample[row].weights_m[cable]);
        let points = file.sample.into_iter().map(|sample| sample.at_m).collect();
        let field = field(points, (file.length_scale_m, file.noise_ratio), file.mean_m, weights);
        let [x, y, z, w] = file.centre.quaternion_xyzw;
        let centre = Pose {
            position: Vector3::from(file.centre.position_m),
            rotation: UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z)),
        };
        let map = Self {
            robot: file.robot,
            model: file.model,
            at_centre: file.centre.cable_lengths_m,
            space: PoseSpace::of(model, centre, file.lever_m, file.ranges_m),
            field: field.ok_or_else(|| refused("the numbers of the samples make no smooth map"))?.into(),
        };
        map.check(model)?;
        Ok(map)
    }
}

/// The field with these numbers; `None` if they make none.
fn field(
    points: Vec<Vec<f64>>,
    (length_scale, noise_ratio): (f64, f64),
    mean: Vec<f64>,
    weights: DMatrix<f64>,
) -> Option<Field> {
    let factor = factor(&points, length_scale, noise_ratio)?;
    Some(Field { points, length_scale, noise_ratio, mean, weights, factor })
}

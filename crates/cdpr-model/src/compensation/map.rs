//! The map: corrections at poses among its samples.

use std::sync::Arc;

use nalgebra::DMatrix;

use super::correction::Correction;
use super::fade::left;
use super::field::Field;
use super::map_error::MapError;
use super::pose_space::{Extent, PoseSpace};
use crate::equilibrium::State;
use crate::geometry::Pose;
use crate::model::Model;

/// Fractions of the smooth part's variance that samples leave unknown: up to the first a map acts fully, from the
/// second on not at all.
const UNKNOWN: [f64; 2] = [0.5, 0.75];

/// Difference of lengths at the centre above which the model is another one (m).
const SAME: f64 = 1e-6;

/// Smooth correction of a model's recorded lengths over the workspace.
#[derive(Clone, Debug)]
pub struct Compensation {
    /// Name of the robot.
    pub(super) robot: String,
    /// Composition of the model.
    pub(super) model: String,
    /// Lengths of the model at the centre without tensions (m): another model has other lengths.
    pub(super) at_centre: Vec<f64>,
    pub(super) space: PoseSpace,
    pub(super) field: Arc<Field>,
}

/// Facts about a map.
#[derive(Clone, Debug, PartialEq)]
pub struct MapFacts {
    /// Number of its samples.
    pub samples: usize,
    /// Correlation length of the corrections (m).
    pub length_scale: f64,
    /// Variance of noise as a multiple of the variance of the smooth part.
    pub noise_ratio: f64,
    /// Pose about which the ranges of the samples are measured.
    pub centre: Pose,
    /// Ranges of the samples along every coordinate about the centre, and the margins over which the map fades.
    pub extents: Vec<Extent>,
}

impl Compensation {
    /// The map through corrections at poses (m; pose by cable), with the smoothness that fits them best.
    pub fn through(model: &Model, poses: &[Pose], corrections: &DMatrix<f64>) -> Result<Self, MapError> {
        let space = PoseSpace::about(model, poses);
        let points = poses.iter().map(|pose| space.point(pose)).collect();
        let field = Field::fit(points, corrections).ok_or(MapError::OnePose)?;
        Ok(Self {
            robot: model.robot().name.clone(),
            model: model.composition().to_string(),
            at_centre: lengths_at(model, &space.centre)?,
            space,
            field: field.into(),
        })
    }

    /// Facts about the map.
    pub fn facts(&self) -> MapFacts {
        MapFacts {
            samples: self.field.points.len(),
            length_scale: self.field.length_scale,
            noise_ratio: self.field.noise_ratio,
            centre: self.space.centre,
            extents: self.space.extents(),
        }
    }

    /// Correction at a pose. It acts fully in the box of the samples where these leave at most half of the smooth
    /// part's variance unknown. It fades with a continuous slope over the margins of the box, and in gaps up to three
    /// quarters unknown. Beyond that it is zero.
    pub fn at(&self, pose: &Pose) -> Correction {
        let point = self.space.point(pose);
        let in_box = self.space.fraction(&point);
        let (smooth, unknown) = match in_box > 0.0 {
            true => self.field.at(&point),
            false => (Vec::new(), 0.0),
        };
        let [whole, none] = UNKNOWN;
        let known = left((unknown - whole) / (none - whole));
        let fraction = in_box * known;
        let lengths = match fraction > 0.0 {
            true => smooth.iter().map(|length| fraction * length).collect(),
            false => vec![0.0; self.field.mean.len()],
        };
        let gap = || format!("samples are so far from it that {:.0} % of the variance stay unknown", 100.0 * unknown);
        let reason = self.space.beyond(&point).or_else(|| (known < 1.0).then(gap));
        Correction { lengths, fraction, reason }
    }

    /// Refuses a model for which the map was not made.
    pub fn check(&self, model: &Model) -> Result<(), MapError> {
        let own = lengths_at(model, &self.space.centre)?;
        let difference = match own.len() == self.at_centre.len() {
            true => own.iter().zip(&self.at_centre).map(|(own, map)| (own - map).abs()).fold(0.0, f64::max),
            false => f64::NAN,
        };
        let is_near = |(own, map): (&f64, &f64)| (own - map).abs() <= SAME;
        let is_same = own.len() == self.at_centre.len()
            && own.iter().zip(&self.at_centre).all(is_near)
            && model.composition().to_string() == self.model;
        if is_same {
            return Ok(());
        }
        let (robot, model) = (self.robot.clone(), self.model.clone());
        Err(MapError::OtherModel { robot, model, difference_m: difference })
    }
}

/// Lengths of a model's cables at a pose, for any tensions (m).
fn lengths_at(model: &Model, pose: &Pose) -> Result<Vec<f64>, MapError> {
    let mut state = State::at(model, pose);
    let solution = model.inverse(pose, &vec![f64::NAN; model.cable_count()], &mut state)?;
    Ok(solution.cables.iter().map(|cable| cable.length).collect())
}

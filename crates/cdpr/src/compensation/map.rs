//! The map: corrections at poses among its samples.

use nalgebra::DMatrix;

use super::field::Field;
use super::map_error::MapError;
use super::pose_space::PoseSpace;
use crate::equilibrium::State;
use crate::geometry::Pose;
use crate::model::Model;

/// Largest share of the smooth part's variance that samples may leave unknown at a pose.
const UNKNOWN: f64 = 0.5;

/// Difference of lengths at the centre by which another model is told (m).
const SAME: f64 = 1e-6;

/// Smooth correction of a model's recorded lengths over the workspace.
#[derive(Clone, Debug)]
pub struct Compensation {
    /// Name of the robot.
    pub(super) robot: String,
    /// Composition of the model.
    pub(super) model: String,
    /// Lengths of the model at the centre without tensions (m): another model has others.
    pub(super) at_centre: Vec<f64>,
    pub(super) space: PoseSpace,
    pub(super) field: Field,
}

impl Compensation {
    /// The map through corrections at poses (m; pose by cable), as smooth as they ask for.
    pub(crate) fn through(model: &Model, poses: &[Pose], corrections: &DMatrix<f64>) -> Result<Self, MapError> {
        let space = PoseSpace::about(model, poses);
        let points = poses.iter().map(|pose| space.point(pose)).collect();
        let field = Field::fit(points, corrections).ok_or(MapError::OnePose)?;
        Ok(Self {
            robot: model.robot().name.clone(),
            model: model.composition().to_string(),
            at_centre: lengths_at(model, &space.centre)?,
            space,
            field,
        })
    }

    /// Number of samples that the map is made of.
    pub fn sample_count(&self) -> usize {
        self.field.points.len()
    }

    /// Distance over which corrections hang together (m).
    pub fn length_scale(&self) -> f64 {
        self.field.length_scale
    }

    /// Variance of noise as a multiple of the variance of the smooth part.
    pub fn noise_ratio(&self) -> f64 {
        self.field.noise_ratio
    }

    /// Corrections to add to the recorded lengths of the model at a pose, cable by cable (m); an error beyond the samples.
    pub fn at(&self, pose: &Pose) -> Result<Vec<f64>, MapError> {
        let point = self.space.point(pose);
        if let Some(reason) = self.space.beyond(&point) {
            return Err(MapError::Outside { reason });
        }
        let (correction, unknown) = self.field.at(&point);
        match unknown <= UNKNOWN {
            true => Ok(correction),
            false => Err(MapError::Outside {
                reason: format!(
                    "samples are so far from it that {:.0} % of the variance stay unknown",
                    100.0 * unknown
                ),
            }),
        }
    }

    /// Lengths to send for a pose: those of the model, φ(x) + c(x), in the units of its encoders (m); an error beyond the samples.
    pub fn corrected(&self, pose: &Pose, modelled: &[f64]) -> Result<Vec<f64>, MapError> {
        Ok(modelled.iter().zip(self.at(pose)?).map(|(length, own)| length + own).collect())
    }

    /// Lengths that the model has where these are recorded at a pose, q − c(x) (m).
    pub(crate) fn modelled(&self, pose: &Pose, recorded: &[f64]) -> Result<Vec<f64>, MapError> {
        Ok(recorded.iter().zip(self.at(pose)?).map(|(length, own)| length - own).collect())
    }

    /// Refuses a model that the map was not made for.
    pub(crate) fn check(&self, model: &Model) -> Result<(), MapError> {
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

/// Lengths of a model's cables at a pose, whatever their tensions (m).
fn lengths_at(model: &Model, pose: &Pose) -> Result<Vec<f64>, MapError> {
    let mut state = State::at(model, pose);
    let solution = model.inverse(pose, &vec![f64::NAN; model.cable_count()], &mut state)?;
    Ok(solution.cables.iter().map(|cable| cable.length).collect())
}

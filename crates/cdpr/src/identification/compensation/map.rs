//! The map: corrections at poses among its samples.

use nalgebra::DMatrix;

use super::compensation_error::CompensationError;
use super::field::Field;
use super::pose_space::PoseSpace;
use crate::equilibrium::State;
use crate::geometry::Pose;
use crate::identification::Evaluation;
use crate::measurement::Samples;
use crate::model::Model;

/// Most samples of a map; of more, so many are taken evenly.
const MOST: usize = 400;

/// Largest share of the smooth part's variance that samples may leave unknown at a pose.
pub(super) const UNKNOWN: f64 = 0.5;

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
    /// The map of a model's errors on samples, smooth as the samples ask for; `errors` are those of the model alone.
    pub(super) fn of(model: &Model, samples: &Samples, errors: &Evaluation) -> Result<Self, CompensationError> {
        let cables = model.cable_count();
        let of_sample = |sample: &usize| &errors.length[sample * cables..][..cables];
        let known = |sample: &usize| of_sample(sample).iter().all(|error| error.is_finite());
        let all: Vec<usize> = (0..samples.len()).filter(known).collect();
        let taken = all.len().min(MOST);
        let used: Vec<usize> = (0..taken).map(|place| all[place * all.len() / taken]).collect();
        let poses: Vec<Pose> = used.iter().map(|&sample| samples.poses[sample]).collect();
        let space = PoseSpace::about(model, &poses);
        let points = poses.iter().map(|pose| space.point(pose)).collect();
        let values = DMatrix::from_fn(used.len(), cables, |row, cable| -errors.length[used[row] * cables + cable]);
        let field = Field::fit(points, &values).ok_or(CompensationError::OnePose)?;
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
    pub fn at(&self, pose: &Pose) -> Result<Vec<f64>, CompensationError> {
        let point = self.space.point(pose);
        if let Some(reason) = self.space.beyond(&point) {
            return Err(CompensationError::Outside { reason });
        }
        let (correction, unknown) = self.field.at(&point);
        match unknown <= UNKNOWN {
            true => Ok(correction),
            false => Err(CompensationError::Outside {
                reason: format!(
                    "samples are so far from it that {:.0} % of the variance stay unknown",
                    100.0 * unknown
                ),
            }),
        }
    }

    /// Refuses a model that the map was not made for.
    pub fn check(&self, model: &Model) -> Result<(), CompensationError> {
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
        Err(CompensationError::OtherModel { robot, model, difference_m: difference })
    }
}

/// Lengths of a model's cables at a pose, whatever their tensions (m).
fn lengths_at(model: &Model, pose: &Pose) -> Result<Vec<f64>, CompensationError> {
    let mut state = State::at(model, pose);
    let solution = model.inverse(pose, &vec![f64::NAN; model.cable_count()], &mut state)?;
    Ok(solution.cables.iter().map(|cable| cable.length).collect())
}

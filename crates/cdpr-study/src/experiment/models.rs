//! Robots and models of an experiment.

use thiserror::Error;

use crate::study::{RobotModel, Study};
use cdpr_model::control::InputError;
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::Robot;

/// Robots that a study names, read by the caller.
#[derive(Clone, Debug)]
pub struct Robots {
    /// Robot of the control model.
    pub control: Robot,
    /// The machine.
    pub machine: Robot,
    /// Robot of `[prediction]`; `None` if the study has none, or no prediction is needed.
    pub prediction: Option<Robot>,
    /// Robot with which the winches were set; `None` if the study names none.
    pub former: Option<Robot>,
}

impl Robots {
    /// Reads each robot of a study by its name there.
    pub fn of<E>(study: &Study, mut read: impl FnMut(&str) -> Result<Robot, E>) -> Result<Self, E> {
        Ok(Self {
            control: read(&study.control.robot)?,
            machine: read(&study.machine.robot)?,
            prediction: study.prediction.as_ref().map(|side| read(&side.robot)).transpose()?,
            former: study.former().map(|side| read(&side.robot)).transpose()?,
        })
    }
}

/// Error of a study, or of one of its robots, that prevents the experiment.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("{error}")]
pub struct ExperimentError {
    /// Name in the study of the robot with the error; `None` if the error is in the study.
    pub robot: Option<String>,
    /// Reason.
    pub error: InputError,
}

impl From<InputError> for ExperimentError {
    fn from(error: InputError) -> Self {
        Self { robot: None, error }
    }
}

impl Study {
    /// A robot with the effects of one side and the limits of the study.
    pub(crate) fn model_of(&self, side: &RobotModel, robot: Robot) -> Result<Model, InputError> {
        Ok(Model::new(self.limited(robot), side.model.parse::<Composition>()?)?)
    }

    /// The robot that was in use when the winches were set, with the effects of the control model; `None` if it is the
    /// control model's own.
    pub(crate) fn former(&self) -> Option<RobotModel> {
        let robot = self.initial.offset_robot.clone()?;
        Some(RobotModel { robot, model: self.control.model.clone() })
    }
}

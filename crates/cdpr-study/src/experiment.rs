//! A study with its models and its winches set: the one place that defines how a study is run.

mod models;
mod questions;
mod runs;
mod workspaces;

use super::study::{RobotModel, Study};
use cdpr_model::compensation::{Compensation, MapError};
use cdpr_model::control::Control;
use cdpr_model::control::History;
use cdpr_model::control::InputError;
use cdpr_model::control::winch_offsets;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::robot::Robot;
use cdpr_model::tension::Method;

pub use models::{ExperimentError, Robots};

/// A study with its models, its initial pose and its winch offsets, ready to command poses.
///
/// ```
/// use cdpr::study::{Experiment, Robots, Study};
/// use cdpr::robot::Robot;
/// let study = "[control]\nrobot = \"planar-example\"\n[machine]\nrobot = \"planar-example\"\nmodel = \"elastic\"\n\
///              [initial]\npose = [0, 5.2]\ntension_method = \"closed-form\"\n\
///              [limits]\ntension_min_N = 1000\ntension_max_N = 8000\n\
///              [poses.grid]\nmin = [-1, 4]\nmax = [1, 6]\ncount = [3, 3]";
/// let study = Study::from_toml_bytes(study.as_bytes(), "study.toml")?;
/// let robots = Robots::of(&study, |name| Robot::builtin(name).ok_or("unknown robot"))?;
/// let experiment = Experiment::new(study, robots)?;
/// let poses = experiment.poses(Vec::new(), 0)?;
/// assert!(experiment.assess(&poses)?.accuracy.position_error_m.mean > 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Experiment {
    /// The study as its file states it.
    pub study: Study,
    /// The model that computes the lengths.
    pub control: Model,
    /// The map that corrects the lengths of the control model.
    pub compensation: Option<Compensation>,
    /// The model that answers.
    pub machine: Model,
    /// The model that predicts pose and tensions from the lengths sent; `None` if the study or its robots name none.
    pub prediction: Option<Model>,
    /// The model in use when the winches were set; `None` if it was the control model.
    pub former: Option<Model>,
    /// The pose at which the winches were set.
    pub start: Pose,
    /// Winch offsets added to the commanded lengths, one per cable (m).
    pub offsets: Vec<f64>,
}

impl Experiment {
    /// Builds the models of a study from its robots, and sets the winches of the machine as the study states.
    pub fn new(study: Study, robots: Robots) -> Result<Self, ExperimentError> {
        let model = |side: &RobotModel, robot: Robot| {
            let refused = |error| ExperimentError { robot: Some(side.robot.clone()), error };
            study.model_of(side, robot).map_err(refused)
        };
        let control = model(&study.control.robot_model(), robots.control)?;
        let machine = model(&study.machine, robots.machine)?;
        let both = study.prediction.as_ref().zip(robots.prediction);
        let prediction = both.map(|(side, robot)| model(side, robot)).transpose()?;
        let former = study.former().zip(robots.former).map(|(side, robot)| model(&side, robot)).transpose()?;
        let start = study.initial_pose(machine.robot()).map_err(InputError::from)?;
        let offsets = winch_offsets(&study.initial, former.as_ref().unwrap_or(&control), &machine, &start)?;
        Ok(Self { study, control, compensation: None, machine, prediction, former, start, offsets })
    }

    /// The same machine with another controller; the winches are unchanged. The map is dropped, since it belongs to the
    /// controller before.
    #[must_use]
    pub fn with_control(&self, control: Model) -> Self {
        let former = Some(self.former.clone().unwrap_or_else(|| self.control.clone()));
        Self { control, former, ..self.without_compensation() }
    }

    /// The experiment with the map that the study names; an error if the map belongs to another robot or model.
    pub fn with_compensation(self, map: Compensation) -> Result<Self, MapError> {
        map.check(&self.control)?;
        Ok(Self { compensation: Some(map), ..self })
    }

    /// The experiment with the control model alone, even if the study names a map.
    #[must_use]
    pub fn without_compensation(&self) -> Self {
        let mut alone = Self { compensation: None, ..self.clone() };
        alone.study.control.compensation = None;
        alone
    }

    /// The experiment with another method to choose tensions; unchanged if `method` is `None`.
    #[must_use]
    pub fn with_tension_method(mut self, method: Option<Method>) -> Self {
        self.study.control.tension_method = method.or(self.study.control.tension_method);
        self
    }

    /// The control model with its tension method and its map; an error if the study names a map that is not given.
    pub(crate) fn controller(&self) -> Result<Control, InputError> {
        let stated = &self.study.control;
        match (&stated.compensation, &self.compensation) {
            (Some(file), None) => Err(InputError::NoMap { file: file.clone() }),
            (_, map) => Ok(Control {
                model: self.control.clone(),
                tension_method: stated.tension_method.unwrap_or_default(),
                compensation: map.clone(),
            }),
        }
    }

    /// Error for a question that calibrates the controller while it has a map.
    pub(crate) fn refuse_map(&self, question: &'static str) -> Result<(), InputError> {
        let reason = "it calibrates other control models, and a map belongs to one";
        self.controller()?.without_map(question, reason).map(drop)
    }

    /// The model in use when the winches are set.
    pub(crate) fn set_with(&self) -> &Model {
        self.former.as_ref().unwrap_or(&self.control)
    }

    /// Path on which the machine comes to the poses, if its cables have a memory; else `None`.
    pub fn history(&self) -> Option<History> {
        History::of(&self.machine, self.study.history)
    }
}

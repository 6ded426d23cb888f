//! Studies with their robots: what `accuracy`, `simulate` and `demo` run.

use std::ops::Deref;
use std::path::{Path, PathBuf};

use cdpr::geometry::Pose;
use cdpr::identification::{Evaluation, evaluate};
use cdpr::measurement::{Provenance, SensorSigmas, Sidecar, poses_from_csv};
use cdpr::metamodel::accuracy::{Assessment, assess_operation};
use cdpr::metamodel::branches::{Branches, branches};
use cdpr::metamodel::reachable::Reachable;
use cdpr::metamodel::sensitivity::{Offsets, Setting};
use cdpr::metamodel::simulate::{Simulation, simulate_operation};
use cdpr::metamodel::study::{CommandedPose, RobotModel, TensionMethod};
use cdpr::metamodel::{Driving, Experiment, InputError, Operation, Study};
use cdpr::model::Model;
use cdpr::reading::Size;
use cdpr::robot::Robot;
use cdpr::statics::Load;
use cdpr::tension::Limits;
use cdpr::workspace::criterion::WrenchFeasible;

use crate::answer::Output;
use crate::envelope::PROGRAM;
use crate::failure::Failure;
use crate::files;
use crate::inputs::read_robot;

/// An experiment with the files it comes from; whatever the experiment refuses is the study's fault.
pub(crate) struct Laboratory {
    /// The study with its models and winch offsets.
    pub(crate) experiment: Experiment,
    /// The model that is asked what emerges.
    pub(crate) prediction: Option<Model>,
    /// Name of the study file, for messages.
    name: String,
    /// Paths in the study start here.
    folder: PathBuf,
}

impl Deref for Laboratory {
    type Target = Experiment;

    fn deref(&self) -> &Experiment {
        &self.experiment
    }
}

/// Where the robots of a study come from.
pub(crate) type RobotSource<'a> = &'a dyn Fn(&str) -> Result<Robot, Failure>;

impl Laboratory {
    /// Reads a study and its robots; their paths are relative to its folder.
    pub(crate) fn read(path: &Path) -> Result<Self, Failure> {
        let name = path.display().to_string();
        let study = Study::from_toml_bytes(&files::read(path, Size::Text)?, &name)?;
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        let from_folder = |robot: &str| robot_of_study(robot, &folder);
        Self::new(study, &name, &folder, &from_folder)
    }

    /// Tells which robot the study is about, and the remarks on the study.
    pub(crate) fn introduce(&self, output: &Output) {
        output.about(&self.machine.robot().name);
        self.study.remarks().iter().for_each(|remark| output.remark(remark));
    }

    /// A study whose robots a caller provides.
    pub(crate) fn new(study: Study, name: &str, folder: &Path, robots: RobotSource<'_>) -> Result<Self, Failure> {
        let control = model_of(&study, &study.control.robot_model(), robots)?;
        let machine = model_of(&study, &study.machine, robots)?;
        let prediction = study.prediction.as_ref().map(|side| model_of(&study, side, robots)).transpose()?;
        let former = study.former().map(|side| model_of(&study, &side, robots)).transpose()?;
        let experiment = Experiment::new(study, control, machine, former);
        let experiment = experiment.map_err(|error| Failure::refused(name, &error))?;
        Ok(Self { experiment, prediction, name: name.to_owned(), folder: folder.to_owned() })
    }

    /// The study with another way to choose tensions, where one is given.
    pub(crate) fn with_tension_method(mut self, method: Option<TensionMethod>) -> Self {
        let control = &mut self.experiment.study.control;
        control.tension_method = method.or(control.tension_method);
        self
    }

    /// Virtual measurements of all poses and tension tests.
    pub(crate) fn record(&self, seed: u64) -> Result<Simulation, Failure> {
        let noise = self.study.noise.unwrap_or_default();
        let poses = self.poses(seed)?;
        simulate_operation(&mut self.operation()?, &poses, &noise, seed).map_err(|error| self.refused(&error))
    }

    /// How accurately the control model drives the machine; tension tests leave their pose on purpose and do not count.
    pub(crate) fn assess(&self, seed: u64) -> Result<Assessment, Failure> {
        let poses = self.untested_poses(seed)?;
        assess_operation(&mut self.operation()?, &poses).map_err(|error| self.refused(&error))
    }

    /// How well the model of `[prediction]` tells what emerges from what was sent, sensors without noise; nothing without one.
    pub(crate) fn predict(&self, seed: u64) -> Result<Option<Evaluation>, Failure> {
        let Some(model) = &self.prediction else { return Ok(None) };
        let poses = self.untested_poses(seed)?;
        let recorded = simulate_operation(&mut self.operation()?, &poses, &SensorSigmas::default(), seed);
        let recorded = recorded.map_err(|error| self.refused(&error))?;
        evaluate(model, &recorded.samples).map(Some).map_err(|error| self.refused(&error))
    }

    /// The poses that count for accuracy: tension tests leave theirs on purpose.
    pub(crate) fn untested_poses(&self, seed: u64) -> Result<Vec<CommandedPose>, Failure> {
        let mut poses = self.poses(seed)?;
        poses.retain(|command| command.shortened.is_none());
        Ok(poses)
    }

    /// How the winches were set, and what deviations do to it.
    pub(crate) fn setting(&self, offsets: Offsets) -> Setting<'_> {
        Setting { initial: &self.study.initial, pose: self.start, former: self.former.as_ref(), offsets }
    }

    /// How far apart branches lie at the poses, a hundred of them at the most; nothing without history.
    pub(crate) fn branches(&self, seed: u64, stroke: f64) -> Result<Option<Branches>, Failure> {
        let Some(history) = self.history() else { return Ok(None) };
        let commands = self.untested_poses(seed)?;
        let every = commands.len().div_ceil(100).max(1);
        let poses: Vec<Pose> = commands.iter().step_by(every).map(|command| command.pose).collect();
        let models = (self.controller(), &self.machine);
        let found = branches(models, &self.offsets, (&history, &self.start), &poses, stroke);
        found.map(Some).map_err(|error| self.refused(&error))
    }

    /// The tensions at which the winches were set (N); nothing where the study states offsets, or cables have none.
    pub(crate) fn initial_tensions(&self) -> Result<Option<Vec<f64>>, Failure> {
        self.experiment.initial_tensions().map_err(|error| self.refused(&error))
    }

    /// Tension limits of the machine, or which key is missing.
    pub(crate) fn known_limits(&self) -> Result<Limits, Failure> {
        Limits::of(self.machine.robot(), None, None).map_err(|error| self.refused(&InputError::Limits(error)))
    }

    /// The machine under its control model, to be asked from several threads.
    pub(crate) fn driving(&self) -> Result<Driving<'_>, Failure> {
        self.experiment.driving().map_err(|error| self.refused(&error))
    }

    /// Which poses count as reached.
    pub(crate) fn reachable(&self) -> Result<Reachable<'_>, Failure> {
        self.experiment.reachable(self.requirements()).map_err(|error| self.refused(&error))
    }

    /// Wrench feasibility of one of the models under the study's limits; nothing where load or limits are unknown.
    pub(crate) fn feasible<'m>(&self, model: &'m Model) -> Option<WrenchFeasible<'m>> {
        let load = Load::of(model.robot()).ok()?;
        WrenchFeasible::new(model, &load, &self.limits()?).ok()
    }

    fn operation(&self) -> Result<Operation<'_>, Failure> {
        self.experiment.operation().map_err(|error| self.refused(&error))
    }

    /// Something that is wrong with the study.
    pub(crate) fn refused(&self, error: &dyn cdpr::error_code::ErrorCode) -> Failure {
        Failure::refused(&self.name, error)
    }

    /// What is known about the samples.
    pub(crate) fn sidecar(&self, seed: u64) -> Sidecar {
        Sidecar {
            layout_version: 1,
            sigmas: self.study.noise.unwrap_or_default(),
            frames: None,
            provenance: Some(Provenance {
                source: Some(format!("simulated by {PROGRAM}")),
                robot: Some(self.machine.robot().name.clone()),
                seed: Some(seed),
                ..Provenance::default()
            }),
        }
    }

    fn poses(&self, seed: u64) -> Result<Vec<CommandedPose>, Failure> {
        let robot = self.machine.robot();
        let from_file: Vec<Pose> = match self.study.poses.as_ref().and_then(|poses| poses.file.as_ref()) {
            Some(file) => {
                let path = self.folder.join(&file.path);
                poses_from_csv(&files::read(&path, Size::Table)?, &path.display().to_string(), robot)?
            }
            None => Vec::new(),
        };
        let mut poses = self.study.commanded_poses(robot, from_file, seed).map_err(|error| self.refused(&error))?;
        self.study.keep_wanted(&self.machine, &mut poses).map_err(|error| self.refused(&error))?;
        Ok(poses)
    }
}

/// A robot that a study in a folder names.
pub(crate) fn robot_of_study(robot: &str, folder: &Path) -> Result<Robot, Failure> {
    read_robot(&robot_path(robot, folder))
}

/// A path is relative to the study, a built-in name stands for itself.
fn robot_path(robot: &str, folder: &Path) -> String {
    let is_path = robot.contains(['/', '\\', '.']);
    if is_path { folder.join(robot).display().to_string() } else { robot.to_owned() }
}

fn model_of(study: &Study, side: &RobotModel, robots: RobotSource<'_>) -> Result<Model, Failure> {
    study.model_of(side, robots(&side.robot)?).map_err(|error| Failure::refused(&side.robot, &error))
}

/// A robot with its model, as answers and figures name it.
pub(crate) fn title(model: &Model) -> String {
    format!("{} ({})", model.robot().name, model.composition())
}

/// Why a share of the physical workspace may be above 100 %.
pub(crate) const BEYOND_THE_WHOLE: &str = "more than 100 % of the physical workspace: a pose counts where it is commanded, and \
    judged is what emerges; from some poses at which the machine could not be held the platform comes to rest beside them, where it can, and a \
    rigid machine has no tensions that could break a limit";

/// True for such a share.
pub(crate) fn is_beyond_the_whole(share: Option<f64>) -> bool {
    share.is_some_and(|share| share > 1.0 + 1e-9)
}

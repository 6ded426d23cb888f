//! Studies with their robots: what `accuracy`, `simulate` and `demo` run.

use std::path::{Path, PathBuf};

use cdpr::geometry::Pose;
use cdpr::identification::{Evaluation, evaluate};
use cdpr::measurement::{Provenance, SensorSigmas, Sidecar, poses_from_csv};
use cdpr::metamodel::accuracy::{Assessment, assess_operation};
use cdpr::metamodel::branches::{Branches, branches};
use cdpr::metamodel::reachable::{Reachable, Requirements};
use cdpr::metamodel::sensitivity::{Offsets, Setting};
use cdpr::metamodel::simulate::{Simulation, simulate_operation};
use cdpr::metamodel::study::{CommandedPose, History, RobotModel, TensionMethod};
use cdpr::metamodel::{Control, Driving, InputError, Operation, Study, initial_tensions, winch_offsets};
use cdpr::model::{Composition, CompositionError, Model, StretchEffect};
use cdpr::reading::Size;
use cdpr::robot::Robot;
use cdpr::statics::Load;
use cdpr::tension::Limits;
use cdpr::workspace::criterion::WrenchFeasible;

use crate::failure::Failure;
use crate::files;
use crate::inputs::read_robot;

/// A study with its models and winch offsets.
pub(crate) struct Laboratory {
    /// The study as its file states it.
    pub(crate) study: Study,
    /// The model that computes the lengths.
    pub(crate) control: Model,
    /// What answers.
    pub(crate) machine: Model,
    /// The model that is asked what emerges.
    pub(crate) prediction: Option<Model>,
    /// The model in use when the winches were set, where it is not the control model.
    former: Option<Model>,
    /// What is added to the lengths (m).
    pub(crate) offsets: Vec<f64>,
    /// Name of the study file, for messages.
    name: String,
    /// Paths in the study start here.
    folder: PathBuf,
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

    /// A study whose robots a caller provides.
    pub(crate) fn new(study: Study, name: &str, folder: &Path, robots: RobotSource<'_>) -> Result<Self, Failure> {
        let control = model_of(&study, &study.control.robot_model(), robots)?;
        let machine = model_of(&study, &study.machine, robots)?;
        let prediction = study.prediction.as_ref().map(|side| model_of(&study, side, robots)).transpose()?;
        let pose = study.initial_pose(machine.robot()).map_err(|error| Failure::refused(name, &error))?;
        let former = study
            .initial
            .offset_robot
            .as_ref()
            .map(|robot| RobotModel { robot: robot.clone(), model: study.control.model.clone() });
        let former = former.map(|side| model_of(&study, &side, robots)).transpose()?;
        let offsets = winch_offsets(&study.initial, former.as_ref().unwrap_or(&control), &machine, &pose)
            .map_err(|error| Failure::refused(name, &error))?;
        let (name, folder) = (name.to_owned(), folder.to_owned());
        Ok(Self { study, control, machine, prediction, former, offsets, name, folder })
    }

    /// The study with another way to choose tensions, where one is given.
    pub(crate) fn with_tension_method(mut self, method: Option<TensionMethod>) -> Self {
        self.study.control.tension_method = method.or(self.study.control.tension_method);
        self
    }

    /// The control model with its way to choose tensions.
    pub(crate) fn controller(&self) -> Control<'_> {
        Control { model: &self.control, tension_method: self.study.control.tension_method.unwrap_or_default() }
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
    pub(crate) fn setting(&self, offsets: Offsets) -> Result<Setting<'_>, Failure> {
        let pose = self.study.initial_pose(self.machine.robot()).map_err(|error| self.refused(&error))?;
        Ok(Setting { initial: &self.study.initial, pose, former: self.former.as_ref(), offsets })
    }

    /// How the machine comes to the poses, where its cables remember.
    pub(crate) fn history(&self) -> Option<History> {
        let remembers = self.machine.composition().stretch == StretchEffect::Hysteresis;
        remembers.then(|| self.study.history.unwrap_or_default())
    }

    /// How far apart branches lie at the poses, a hundred of them at the most; nothing without history.
    pub(crate) fn branches(&self, seed: u64, stroke: f64) -> Result<Option<Branches>, Failure> {
        let Some(history) = self.history() else { return Ok(None) };
        let commands = self.untested_poses(seed)?;
        let every = commands.len().div_ceil(100).max(1);
        let poses: Vec<Pose> = commands.iter().step_by(every).map(|command| command.pose).collect();
        let models = (self.controller(), &self.machine);
        let found = branches(models, &self.offsets, (&history, &self.initial_pose()?), &poses, stroke);
        found.map(Some).map_err(|error| self.refused(&error))
    }

    /// The pose at which the winches were set.
    pub(crate) fn initial_pose(&self) -> Result<Pose, Failure> {
        self.study.initial_pose(self.machine.robot()).map_err(|error| self.refused(&error))
    }

    /// The tensions at which the winches were set (N); nothing where the study states offsets, or cables have none.
    pub(crate) fn initial_tensions(&self) -> Result<Option<Vec<f64>>, Failure> {
        let initial = &self.study.initial;
        let models = [&self.machine, self.former.as_ref().unwrap_or(&self.control)];
        let elastic = models.into_iter().find(|model| model.composition().depends_on_tension());
        let Some(model) = elastic.filter(|_| initial.offset.is_none() && initial.offset_m.is_none()) else {
            return Ok(None);
        };
        initial_tensions(initial, model, &self.initial_pose()?).map(Some).map_err(|error| self.refused(&error))
    }

    /// Tension limits of the machine, if they are known.
    pub(crate) fn limits(&self) -> Option<Limits> {
        Limits::of(self.machine.robot(), None, None).ok()
    }

    /// Tension limits of the machine, or which key is missing.
    pub(crate) fn known_limits(&self) -> Result<Limits, Failure> {
        Limits::of(self.machine.robot(), None, None).map_err(|error| self.refused(&InputError::Limits(error)))
    }

    /// The model in use when the winches are set.
    pub(crate) fn set_with(&self) -> &Model {
        self.former.as_ref().unwrap_or(&self.control)
    }

    /// The machine under its control model, to be asked from several threads.
    pub(crate) fn driving(&self) -> Result<Driving<'_>, Failure> {
        let driving =
            Driving::new(self.controller(), &self.machine, &self.offsets).map_err(|error| self.refused(&error))?;
        Ok(match self.history() {
            Some(history) => driving.with_history(&history, &self.initial_pose()?),
            None => driving,
        })
    }

    /// Which poses count as reached.
    pub(crate) fn reachable(&self) -> Result<Reachable<'_>, Failure> {
        let requirements = Requirements {
            tensions: self.limits().filter(|_| self.machine.composition().depends_on_tension()),
            position_error_max: self.study.limits.as_ref().and_then(|limits| limits.position_error_max_m),
            rotation_error_max: self.study.limits.as_ref().and_then(|limits| limits.rotation_error_max_rad),
        };
        Reachable::new(self.driving()?, requirements).map_err(|error| self.refused(&error))
    }

    /// Wrench feasibility of one of the models under the study's limits; nothing where load or limits are unknown.
    pub(crate) fn feasible<'m>(&self, model: &'m Model) -> Option<WrenchFeasible<'m>> {
        let load = Load::of(model.robot()).ok()?;
        WrenchFeasible::new(model, &load, &self.limits()?).ok()
    }

    fn operation(&self) -> Result<Operation<'_>, Failure> {
        let operation = Operation::new(self.controller(), &self.machine, &self.offsets);
        let operation = operation.map_err(|error| self.refused(&error))?;
        let start = self.initial_pose()?;
        Ok(match self.history() {
            Some(history) => operation.with_history(&history, &start),
            None => operation,
        })
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
                source: Some(format!("simulated by cdpr {}", env!("CARGO_PKG_VERSION"))),
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
    let robot = study.limited(robots(&side.robot)?);
    let refused = |error: &dyn cdpr::error_code::ErrorCode| Failure::refused(&side.robot, error);
    let composition: Composition = side.model.parse().map_err(|error: CompositionError| refused(&error))?;
    Model::new(robot, composition).map_err(|error| refused(&error))
}

/// A robot with its model, as answers and figures name it.
pub(crate) fn title(model: &Model) -> String {
    format!("{} ({})", model.robot().name, model.composition())
}

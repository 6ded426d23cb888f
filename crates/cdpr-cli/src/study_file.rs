//! Study files with their robots and tables of poses: what `accuracy`, `simulate` and all other commands over studies read.

use std::ops::Deref;
use std::path::{Path, PathBuf};

use cdpr_model::control::CommandedPose;
use cdpr_model::control::InputError;
use cdpr_model::geometry::Pose;
use cdpr_model::reading::ErrorCode;
use cdpr_model::reading::Size;
use cdpr_model::robot::Robot;
use cdpr_model::tension::Method;
use cdpr_study::{Experiment, Robots, Study};

use crate::answer::Output;
use crate::compensation_option::read as read_map;
use crate::failure::Failure;
use crate::file_kind::{FileKind, robot_path};
use crate::files;
use crate::inputs::{read_poses, read_robot};

/// An experiment with the file it comes from; whatever the experiment refuses is the study's fault.
pub(crate) struct StudyFile {
    /// The study with its models and winch offsets.
    pub(crate) experiment: Experiment,
    /// Name of the study file, for messages.
    name: String,
    /// Paths in the study start here.
    folder: PathBuf,
}

impl Deref for StudyFile {
    type Target = Experiment;

    fn deref(&self) -> &Experiment {
        &self.experiment
    }
}

impl StudyFile {
    /// Reads a study and its robots; their paths are relative to its folder.
    pub(crate) fn read(path: &Path) -> Result<Self, Failure> {
        let name = path.display().to_string();
        let bytes = files::read(path, Size::Text)?;
        let study = study_of(&bytes, &name)?;
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        let robots = Robots::of(&study, |robot| robot_of_study(robot, &folder))?;
        let experiment = Experiment::new(study, robots).map_err(|error| {
            let at_fault = error.robot.clone().unwrap_or_else(|| name.clone());
            Failure::refused(&at_fault, &error)
        })?;
        let map = experiment.study.control.compensation.as_ref();
        let experiment = match map.map(|map| read_map(&folder.join(map), &experiment.control)).transpose()? {
            Some((map, file)) => experiment.with_compensation(map).map_err(|error| Failure::refused(&file, &error))?,
            None => experiment,
        };
        Ok(Self { experiment, name, folder })
    }

    /// Tells which robot the study is about, and the remarks on the study.
    pub(crate) fn introduce(&self, output: &Output) {
        output.about(&self.machine.robot().name);
        self.study.remarks().iter().for_each(|remark| output.remark(remark));
    }

    /// The study with another way to choose tensions, where one is given.
    pub(crate) fn with_tension_method(self, method: Option<Method>) -> Self {
        Self { experiment: self.experiment.with_tension_method(method), ..self }
    }

    /// All poses of the study with its tension tests.
    pub(crate) fn commands(&self, seed: u64) -> Result<Vec<CommandedPose>, Failure> {
        self.accepted(self.experiment.commands(self.table()?, seed))
    }

    /// The poses that count for accuracy.
    pub(crate) fn poses(&self, seed: u64) -> Result<Vec<CommandedPose>, Failure> {
        self.accepted(self.experiment.poses(self.table()?, seed))
    }

    /// Answer of the experiment, or the failure of its study.
    pub(crate) fn accepted<T>(&self, answer: Result<T, InputError>) -> Result<T, Failure> {
        answer.map_err(|error| self.refused(&error))
    }

    /// Failure of the study.
    pub(crate) fn refused(&self, error: &dyn ErrorCode) -> Failure {
        Failure::refused(&self.name, error)
    }

    /// Poses of the file that the study names.
    fn table(&self) -> Result<Vec<Pose>, Failure> {
        let Some(file) = self.study.poses.as_ref().and_then(|poses| poses.file.as_ref()) else { return Ok(Vec::new()) };
        read_poses(&self.folder.join(&file.path), self.machine.robot())
    }
}

/// The study that the bytes of a file of this name are.
pub(crate) fn study_of(bytes: &[u8], name: &str) -> Result<Study, Failure> {
    Study::from_toml_bytes(bytes, name).map_err(|error| FileKind::Study.refusal(bytes, error))
}

/// A robot that a study in a folder names.
pub(crate) fn robot_of_study(robot: &str, folder: &Path) -> Result<Robot, Failure> {
    read_robot(&robot_path(robot, folder))
}

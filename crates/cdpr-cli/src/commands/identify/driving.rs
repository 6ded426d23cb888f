//! Calibrated control models on the machine of a study.

use std::path::PathBuf;

use cdpr_model::control::CommandedPose;
use cdpr_model::control::InputError;
use cdpr_model::model::Model;
use cdpr_study::accuracy::Accuracy;
use clap::Args;

use crate::failure::Failure;
use crate::study_file::StudyFile;

/// Machine on which a calibrated model drives.
#[derive(Debug, Args)]
pub(crate) struct DriveArguments {
    /// Study whose machine the model drives before and after, to its poses and with its winches as they were set: the error that a
    /// controller makes, beside that of predictions.
    #[arg(long, value_name = "STUDY")]
    drive: Option<PathBuf>,
}

/// A machine with the poses that it is driven to.
pub(crate) struct Drive {
    study: StudyFile,
    poses: Vec<CommandedPose>,
}

impl DriveArguments {
    pub(crate) fn is_asked(&self) -> bool {
        self.drive.is_some()
    }

    /// Reads the study.
    pub(crate) fn read(&self, seed: u64) -> Result<Option<Drive>, Failure> {
        let Some(path) = &self.drive else { return Ok(None) };
        let study = StudyFile::read(path)?;
        if study.compensation.is_some() {
            let reason = "it drives by other control models, and a map belongs to one";
            return Err(study.refused(&InputError::Map { question: "--drive", reason }));
        }
        let poses = study.poses(seed)?;
        Ok(Some(Drive { study, poses }))
    }
}

impl Drive {
    /// Errors of a control model on the machine.
    pub(crate) fn of(&self, control: &Model) -> Result<Accuracy, Failure> {
        let machine = &self.study.experiment.machine;
        if machine.cable_count() != control.cable_count() {
            return Err(Failure::input(
                "data::cable-count",
                format!(
                    "--drive: its machine has {} cables, the robot {}",
                    machine.cable_count(),
                    control.cable_count()
                ),
                "give a study of the same robot",
            ));
        }
        let experiment = self.study.experiment.with_control(control.clone());
        Ok(self.study.accepted(experiment.assess(&self.poses))?.accuracy)
    }
}

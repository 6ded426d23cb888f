//! Contents of a page, and reasons why a study has none.

use cdpr_model::control::InputError;
use cdpr_model::geometry::PatternError;
use cdpr_study::Experiment;
use cdpr_study::field::Field;
use cdpr_workspace::WorkspaceError;
use thiserror::Error;

use crate::answers::StudyAnswer;
use crate::html_page::PageError;

/// Reasons why a study has no page.
#[derive(Debug, Error)]
pub enum StudyPageError {
    /// The experiment cannot be run.
    #[error(transparent)]
    Experiment(#[from] InputError),
    /// There is no box around the robot.
    #[error(transparent)]
    Region(#[from] WorkspaceError),
    /// Poses of a region that the robot cannot have.
    #[error(transparent)]
    Pose(#[from] PatternError),
    /// The page cannot be put together.
    #[error(transparent)]
    Page(#[from] PageError),
}

/// Contents of a page.
pub struct StudyPage<'a> {
    /// Control model, machine and winches.
    pub experiment: &'a Experiment,
    /// Name of the study.
    pub name: &'a str,
    /// Answer that the page shows.
    pub answer: &'a StudyAnswer,
    /// The errors of its poses.
    pub found: &'a Field,
    /// Warnings; text between backticks is shown as code.
    pub warnings: &'a [String],
    /// The command that makes the same page again.
    pub command: &'a str,
    /// Seed of random poses.
    pub seed: u64,
    /// Version of the program.
    pub version: &'a str,
}

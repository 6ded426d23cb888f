//! Options that say what a fit makes small.

use std::fmt;
use std::path::Path;

use cdpr_calibration::fit::TaskBox;
use cdpr_calibration::{Minimize, Objective, fit};
use cdpr_model::reading::{Keyword, Size};
use clap::Args;

use crate::failure::Failure;
use crate::files;
use crate::keyword::keyword;
use crate::numbers::positive_length;
use crate::study_file::study_of;

/// Residuals and cost of a fit.
#[derive(Clone, Debug, Args)]
pub(crate) struct ObjectiveArguments {
    /// Residuals that are made small: of the lengths at the measured poses, of the poses that the model predicts from the recorded lengths (of
    /// elastic models with the tensions), of these mostly where the task of --task is, or of both in their stated accuracies, the poses unknown (rigid models).
    #[arg(long, value_name = "OBJECTIVE", default_value = Objective::default().name(), value_parser = keyword::<Objective>())]
    objective: Objective,

    /// Cost of all samples: the sum of squares, the mean of the norms, or the largest norm.
    #[arg(long, value_name = "COST", default_value = Minimize::default().name(), value_parser = keyword::<Minimize>())]
    minimize: Minimize,

    /// Length by which rotations count beside positions with `--objective pose` (m). Default: the ratio of the stated accuracies of position and
    /// rotation, else the root mean square of the platform anchors' distances.
    #[arg(long, value_name = "METRES", value_parser = positive_length)]
    rotation_length: Option<f64>,

    /// Study with a table `[task]` (`min`, `max`: a box of positions in metres): with `--objective pose-in-task` squares of poses in the box have
    /// weight 1, falling to 0.1 over a tenth of its diagonal.
    #[arg(long, value_name = "STUDY.toml", value_parser = task_of)]
    task: Option<TaskFile>,
}

/// The task of a study, with the name of its file.
#[derive(Clone, Debug)]
struct TaskFile {
    name: String,
    task: TaskBox,
}

/// A study without a task that can be read.
#[derive(Debug)]
enum TaskError {
    Study(Failure),
    NoTask,
}

impl fmt::Display for TaskError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Study(Failure::File(error)) => error.fmt(f),
            Self::Study(failure) => f.write_str(failure.message()),
            Self::NoTask => f.write_str(
                "this study has no table `[task]`; write min = [x, y, z] and max = [x, y, z] in metres below it",
            ),
        }
    }
}

impl std::error::Error for TaskError {}

fn task_of(path: &str) -> Result<TaskFile, TaskError> {
    let study = files::read(Path::new(path), Size::Text).and_then(|bytes| study_of(&bytes, path));
    let task = study.map_err(TaskError::Study)?.task.ok_or(TaskError::NoTask)?;
    Ok(TaskFile { name: path.to_owned(), task: TaskBox { min: task.min, max: task.max } })
}

impl ObjectiveArguments {
    /// Settings of a fit with these residuals and this cost.
    pub(crate) fn of(&self, settings: fit::Settings) -> fit::Settings {
        let Self { objective, minimize, rotation_length, .. } = *self;
        let task = self.task.as_ref().map(|file| file.task);
        fit::Settings { objective, minimize, rotation_length, task, ..settings }
    }

    /// The options that are not at their default, with their values as they are written.
    pub(crate) fn written(&self) -> [(&'static str, String); 4] {
        let unless_default = |name: &str, default: &str| if name == default { String::new() } else { name.to_owned() };
        [
            ("objective", unless_default(self.objective.name(), Objective::default().name())),
            ("minimize", unless_default(self.minimize.name(), Minimize::default().name())),
            ("rotation-length", self.rotation_length.map(|length| length.to_string()).unwrap_or_default()),
            ("task", self.task.as_ref().map(|file| file.name.clone()).unwrap_or_default()),
        ]
    }
}

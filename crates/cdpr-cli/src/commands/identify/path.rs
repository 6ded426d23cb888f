//! Path of a penalty on the parameters of a fit.

use std::path::{Path, PathBuf};

use cdpr_calibration::fit::Fit;
use cdpr_calibration::{PathSettings, PenaltyPath, penalty_path, propose_reduction};
use cdpr_model::measurement::{Samples, Split};
use cdpr_reports::answers::{PathAnswer, ReductionAnswer};

use super::options::PathArguments;
use super::task::Task;
use crate::failure::Failure;
use cdpr_reports::comparison::DataDivision;

/// Parts that take turns where neither a split nor other data are named.
const PARTS: usize = 5;

/// Answers that the options ask for, with the files to write.
#[derive(Default)]
pub(super) struct Found {
    pub(super) path: Option<PathAnswer>,
    pub(super) reduction: Option<ReductionAnswer>,
    pub(super) warning: Option<String>,
    files: Vec<(PathBuf, Vec<u8>)>,
}

impl Found {
    pub(super) fn files(&self) -> impl Iterator<Item = (&Path, &[u8])> {
        self.files.iter().map(|(path, content)| (path.as_path(), &content[..]))
    }
}

/// The path of a penalty, and the smaller model that it or the fit shows.
pub(super) fn find(task: &Task<'_>, fit: &Fit, other: Option<&Samples>) -> Result<Found, Failure> {
    let options = &task.arguments.path;
    let mut found = Found::default();
    let division = match division(task, other) {
        Ok(division) => division,
        // without a path nobody asked for parts
        Err(_) if options.path.is_none() && options.out_reduced.is_none() => return Ok(found),
        Err(failure) => return Err(failure),
    };
    let path = options.follow(task, fit, &division, &mut found)?;
    let (samples, free, settings) = (&division.samples, &task.arguments.free, task.settings());
    let proposal = propose_reduction(task.model, samples, fit, &settings, free, path.as_ref(), &division.folds);
    let proposal = proposal.map_err(|error| Failure::refused(&task.arguments.data.name(), &error))?;
    match (&proposal, &options.out_reduced) {
        (None, Some(path)) => found.warning = Some(nothing_smaller(path)),
        (Some(proposal), Some(path)) => {
            found.files.push((path.clone(), proposal.model.robot().to_toml().into_bytes()));
        }
        _ => {}
    }
    let out = options.out_reduced.as_ref().map(|path| path.display().to_string());
    found.reduction = proposal.map(|proposal| ReductionAnswer::new(proposal, out));
    Ok(found)
}

fn nothing_smaller(path: &Path) -> String {
    format!(
        "{} is not written: no smaller model shows that predicts data held out as well. One shows where all poses have one orientation and \
         frame-anchor and platform-anchor are free, or where parameters leave `--path lasso`",
        path.display()
    )
}

/// Parts of the data that are held out: as the options say, else contiguous blocks.
fn division(task: &Task<'_>, other: Option<&Samples>) -> Result<DataDivision, Failure> {
    if let (Some(other), Some(name)) = (other, task.validation_name()) {
        return DataDivision::of_two_files(task.samples, other, &name).map_err(|error| Failure::refused(&name, &error));
    }
    let parts = Split::Blocks(task.samples.len().clamp(2, PARTS));
    let split = Some(task.arguments.split.unwrap_or(parts));
    DataDivision::of_one_file(task.samples.clone(), split, task.arguments.seed)
        .map_err(|error| Failure::refused("--split", &error))
}

impl PathArguments {
    /// Follows the path that is asked for, if any.
    fn follow(
        &self,
        task: &Task<'_>,
        fit: &Fit,
        division: &DataDivision,
        found: &mut Found,
    ) -> Result<Option<PenaltyPath>, Failure> {
        let Some(penalty) = self.path else { return Ok(None) };
        let settings =
            PathSettings { penalty, towards: self.towards, shrink: self.shrink.clone(), ..PathSettings::default() };
        let (of_fit, free) = (task.settings(), &task.arguments.free);
        let path = penalty_path(task.model, &division.samples, fit, &of_fit, free, &settings, &division.folds)
            .map_err(|error| Failure::refused(&task.arguments.data.name(), &error))?;
        let out = self.out_path.as_ref().map(|path| path.display().to_string());
        let answer = PathAnswer::new(&path, &settings, division.words.clone(), out);
        if let Some(file) = &self.out_path {
            found.files.push((file.clone(), path.model.robot().to_toml().into_bytes()));
        }
        let figure = self.path_figure.as_ref().and_then(|file| Some((file.clone(), answer.figure()?.file())));
        found.files.extend(figure.map(|(file, figure)| (file, figure.into_bytes())));
        found.path = Some(answer);
        Ok(Some(path))
    }
}

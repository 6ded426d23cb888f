//! Uncertainty beyond linear deviations: profiles, a bootstrap, and bands of poses.

use std::path::{Path, PathBuf};

use cdpr_calibration::fit::{Fit, profiles};
use cdpr_calibration::resampled;
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_reports::NamedFile;
use cdpr_reports::answers::UncertaintyAnswer;

use super::options::UncertaintyArguments;
use super::task::Task;
use crate::failure::Failure;
use crate::files;

/// Places along each direction of a map of bands, and the share of the data's box that it goes beyond it.
const PLACES: [usize; 3] = [9, 9, 3];
const BEYOND: f64 = 0.25;

impl UncertaintyArguments {
    /// Writes the folder, where one is asked for.
    pub(super) fn write(&self, all: &[NamedFile]) -> Result<(), Failure> {
        let Some(folder) = &self.uncertainty else { return Ok(()) };
        let _own = files::OwnFolder::make(folder)?;
        let paths: Vec<PathBuf> = all.iter().map(|file| folder.join(&file.name)).collect();
        let pairs: Vec<(&Path, &[u8])> =
            paths.iter().map(PathBuf::as_path).zip(all.iter().map(|file| &file.content[..])).collect();
        files::write_all(&pairs)
    }

    /// Places of the parameters that are to be profiled.
    fn chosen(&self, fit: &Fit) -> Result<Vec<usize>, Failure> {
        let mut chosen = Vec::new();
        for name in self.profile.iter().map(|name| name.trim()) {
            let is_meant = |full: &str| {
                let rest = full.strip_prefix(name).filter(|_| !name.is_empty());
                name == "all" || rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['[', '.']))
            };
            let found: Vec<usize> =
                (0..fit.parameters.len()).filter(|&place| is_meant(&fit.parameters[place].name)).collect();
            if found.is_empty() {
                let names: Vec<&str> = fit.parameters.iter().map(|one| one.name.as_str()).take(6).collect();
                let message = format!("--profile: `{name}` is no free parameter of this fit");
                let help = match names.is_empty() {
                    true => "free parameters by --free".to_owned(),
                    false => format!("the free ones are {}, …, or `all`", names.join(", ")),
                };
                return Err(Failure::input("parameter::unknown-name", message, help));
            }
            chosen.extend(found);
        }
        chosen.sort_unstable();
        chosen.dedup();
        Ok(chosen)
    }
}

/// Profiles, deviations and bands that the options ask for.
pub(super) fn find(task: &Task<'_>, fit: &Fit) -> Result<UncertaintyAnswer, Failure> {
    let options = &task.arguments.uncertainty;
    let refused = |error: cdpr_calibration::fit::InputError| Failure::refused(&task.arguments.data.name(), &error);
    let (settings, samples) = (task.settings(), task.samples);
    let chosen = options.chosen(fit)?;
    let profiles = profiles(task.model, samples, fit, &settings, &chosen).map_err(refused)?;
    let resample = |count| resampled(task.model, samples, fit, &settings, count as usize, task.arguments.seed);
    let bootstrap = options.bootstrap.map(resample);
    let poses = options.uncertainty.as_ref().map_or_else(Vec::new, |_| grid(&fit.model, &fit.as_fitted(samples)));
    let bands = fit.pose_bands(&poses).map_err(|error| Failure::refused(&task.model.robot().name, &error))?;
    let bands = poses.into_iter().zip(bands).collect();
    Ok(UncertaintyAnswer::new(fit, profiles, bootstrap.transpose().map_err(refused)?, bands))
}

/// Poses over the box of the data and a quarter of it beyond, in the orientation of the home pose.
fn grid(model: &Model, samples: &Samples) -> Vec<Pose> {
    let home = model.robot().home_or_middle();
    let range = |direction: usize| {
        let axis = model.axes()[direction];
        let along = || samples.poses.iter().map(move |pose| pose.position.dot(&axis));
        let (low, high) = (along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max));
        (low - BEYOND * (high - low), high + BEYOND * (high - low))
    };
    let mut poses = vec![home];
    for (direction, &count) in PLACES.iter().enumerate().take(model.axes().len()) {
        let (axis, (low, high)) = (model.axes()[direction], range(direction));
        let at = |pose: &Pose, place: usize| {
            let value = low + (high - low) * place as f64 / (count - 1) as f64;
            Pose { position: pose.position + axis * (value - pose.position.dot(&axis)), ..*pose }
        };
        poses = poses.iter().flat_map(|pose| (0..count).map(|place| at(pose, place)).collect::<Vec<_>>()).collect();
    }
    poses
}

//! Sensitivities and tolerances of a study: what `cdpr sensitivity` tells people.

mod names;

use cdpr_reports::sensitivity;
use cdpr_study::Experiment;
use cdpr_study::tolerance::Deviations;

use crate::failure::Failure;
pub(crate) use names::place_of;

/// The picture for the number of this name.
pub(crate) fn map(found: &Deviations, experiment: &Experiment, name: &str) -> Result<String, Failure> {
    let cause = place_of(&found.causes, &experiment.machine, name, "--map")?;
    sensitivity::map(found, experiment, cause).ok_or_else(|| {
        let message = format!("--map: no pose tells how the platform moves with \"{name}\"");
        Failure::input("study::no-poses", message, "leave --map out".to_owned())
    })
}

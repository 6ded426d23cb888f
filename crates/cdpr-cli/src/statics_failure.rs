//! Refusals of the library's statics, as a failure or as a negative answer.

use cdpr_model::statics::StaticsError;

use crate::failure::Failure;

pub(crate) use cdpr_reports::answers::has_no_path;

/// The failure, with the option whose numbers are at fault.
pub(crate) fn refused(option: &str, error: &StaticsError) -> Failure {
    match error {
        StaticsError::CablePath(reason) => Failure::numerical(reason.to_string()),
        StaticsError::UnknownCable { .. } | StaticsError::RepeatedCable { .. } => Failure::refused("--group", error),
        StaticsError::Rigid { .. } => Failure::refused("--model", error),
        _ => Failure::refused(option, error),
    }
}

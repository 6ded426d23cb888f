//! What the library's statics refuse, as a failure or as a negative answer.

use cdpr::cable::DegenerateCourse;
use cdpr::statics::StaticsError;

use crate::failure::Failure;

/// True where the pose is at fault: a negative answer, not a failure.
pub(crate) fn has_no_course(error: &StaticsError) -> bool {
    matches!(error, StaticsError::Course(reason) if !matches!(reason, DegenerateCourse::NotFinite { .. }))
}

/// The failure, with the option whose numbers are at fault.
pub(crate) fn refused(option: &str, error: &StaticsError) -> Failure {
    match error {
        StaticsError::Course(reason) => Failure::numerical(reason.to_string()),
        StaticsError::UnknownCable { .. } | StaticsError::RepeatedCable { .. } => Failure::refused("--group", error),
        StaticsError::Rigid { .. } => Failure::refused("--model", error),
        _ => Failure::refused(option, error),
    }
}

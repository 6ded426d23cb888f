//! Poses at which a cable has no unique path.

use cdpr_model::cable::GeometryError;
use cdpr_model::statics::StaticsError;

/// True where the pose is at fault: a negative answer, not an error of whoever asked.
pub fn has_no_path(error: &StaticsError) -> bool {
    matches!(error, StaticsError::CablePath(reason) if !matches!(reason, GeometryError::NotFinite { .. }))
}

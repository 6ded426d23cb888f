//! Errors of points of a sweep that cannot be set up.

use thiserror::Error;

use super::KeyError;
use crate::ExperimentError;
use cdpr_model::control::InputError;
use cdpr_model::model::PlacePulleysError;
use cdpr_model::reading::ReadError;
use cdpr_workspace::WorkspaceError;

/// Reason for which a point of a sweep cannot be set up.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum PointError {
    /// A key that does not exist.
    #[error(transparent)]
    Key(#[from] KeyError),
    /// A value that study or robot files cannot have, or an unknown key.
    #[error(transparent)]
    Read(#[from] Box<ReadError>),
    /// Models from which no experiment can be made.
    #[error(transparent)]
    Input(#[from] InputError),
    /// An invalid box, or invalid cells.
    #[error(transparent)]
    Workspace(#[from] WorkspaceError),
    /// Pulleys that cannot be placed.
    #[error(transparent)]
    Pulleys(#[from] PlacePulleysError),
    /// A swivel axis with neither two nor three components.
    #[error("a swivel_axis is three numbers, as [0, 0, 1], or two in the plane of a planar robot")]
    SwivelAxis,
    /// A swivel axis of length 0.
    #[error("a swivel_axis of length 0 has no direction")]
    NoDirection,
    /// Neither the sweep nor the file states the swivel axis of a pulley.
    #[error(
        "placed_pulley_radius_m needs swivel_axis, as [0, 0, 1], or pulley_swivel_axis of every cable, which \"{cable}\" lacks"
    )]
    NoSwivelAxis {
        /// Name of the cable.
        cable: String,
    },
}

impl From<ExperimentError> for PointError {
    fn from(error: ExperimentError) -> Self {
        Self::Input(error.error)
    }
}

impl From<ReadError> for PointError {
    fn from(error: ReadError) -> Self {
        Self::Read(Box::new(error))
    }
}

//! Why a point of a sweep cannot be set up.

use thiserror::Error;

use super::KeyError;
use crate::ExperimentError;
use cdpr_model::control::InputError;
use cdpr_model::model::PlacePulleysError;
use cdpr_model::reading::ReadError;
use cdpr_workspace::WorkspaceError;

/// Why a point of a sweep cannot be set up.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum PointError {
    /// A key that leads nowhere.
    #[error(transparent)]
    Key(#[from] KeyError),
    /// A value that study or robot files cannot have, or a key that they do not know.
    #[error(transparent)]
    Read(#[from] Box<ReadError>),
    /// Models that make no experiment.
    #[error(transparent)]
    Input(#[from] InputError),
    /// A box, or cells, that are none.
    #[error(transparent)]
    Workspace(#[from] WorkspaceError),
    /// Pulleys that have no place.
    #[error(transparent)]
    Pulleys(#[from] PlacePulleysError),
    /// Neither two nor three components.
    #[error("a swivel_axis is three numbers, as [0, 0, 1], or two in the plane of a planar robot")]
    SwivelAxis,
    /// An axis of length 0.
    #[error("a swivel_axis of length 0 has no direction")]
    NoDirection,
    /// Nobody says how a pulley is to swivel.
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

//! Models of one cable, one file per effect, written once over [`crate::scalar::Real`].

pub mod elasticity;
pub mod law;
pub mod outlet;
mod path;
pub mod span;
mod state;
pub mod stretch;
pub mod wrench;

pub use path::{CablePath, GeometryError};
pub use state::{CableInput, CableState, CableStateError, Recording};
pub use wrench::CableEnd;

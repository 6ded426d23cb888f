//! One cable: the laws of [`cdpr_core::cable`] with the numbers of a robot file, and its winch.

pub mod elasticity;
pub mod stretch;
pub mod winch;

pub use cdpr_core::cable::wrench;
pub use cdpr_core::cable::{
    CableEnd, CableInput, CablePath, CableState, CableStateError, GeometryError, Recording, law, outlet, span,
};

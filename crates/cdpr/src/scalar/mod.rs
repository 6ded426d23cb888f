//! The number types that one formula serves (those of [`cdpr_core::scalar`]), and tables of them.

pub(crate) mod cholesky;
pub(crate) mod decomposition;
mod parts;
pub(crate) mod polynomial;
mod table;
mod triangular_factor;

pub use cdpr_core::scalar::{
    Kernel, LANES, Lanes, Portable, Real, Select, Smooth, Unit, dispatch, dispatch_narrow, dispatch_on,
};
pub(crate) use cdpr_core::scalar::{add, constants, cross, dot, eigenvalue, ldl, rotate, rotate_back, scale, sub};
pub(crate) use parts::over_parts;
pub use table::{LaneTable, Line};
pub(crate) use triangular_factor::TriangularFactor;

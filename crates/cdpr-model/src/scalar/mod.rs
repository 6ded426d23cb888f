//! The number types for which formulas are generic (those of [`cdpr_core::scalar`]), and tables of them.

pub mod cholesky;
pub mod decomposition;
mod parts;
pub mod polynomial;
mod table;
mod triangular_factor;

pub use cdpr_core::scalar::{
    Kernel, LANES, Lanes, Portable, Real, Select, Smooth, Unit, dispatch, dispatch_narrow, dispatch_on,
};
pub use cdpr_core::scalar::{add, constants, cross, dot, eigenvalue, ldl, rotate, rotate_back, scale, sub};
pub use parts::{map_all, over_parts};
pub use table::{LaneTable, Line};
pub use triangular_factor::TriangularFactor;

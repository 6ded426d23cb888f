//! The number types for which formulas are generic (those of [`cdpr_core::scalar`]), and tables of them.

pub mod cholesky;
pub mod decomposition;
mod line;
mod parts;
pub mod polynomial;
mod table;
mod transposed;
mod triangular_factor;

pub use cdpr_core::scalar::{
    Kernel, LANES, Lanes, Portable, Real, Select, Smooth, Unit, dispatch, dispatch_narrow, dispatch_on,
};
pub use cdpr_core::scalar::{
    SINE_LIMIT, add, constants, cross, dot, eigenvalue, ldl, rotate, rotate_back, scale, sin_cos, sub,
};
pub use line::Line;
pub use parts::{chunk_for_threads, map_all, over_parts};
pub use table::LaneTable;
pub(crate) use transposed::{has_room, load_items};
pub use triangular_factor::TriangularFactor;

//! The number types that one formula serves: plain numbers, lanes of poses or cables, dual numbers.
//!
//! Per-cable geometry is written once over [`Real`]. `f64` gives the answer for one pose, [`Lanes`]
//! types the answer for eight at once, and the dual numbers of the tests check every analytic derivative.

mod angle;
#[cfg(all(feature = "vectors", target_arch = "x86_64"))]
mod avx2;
#[cfg(all(feature = "vectors", target_arch = "x86_64"))]
mod avx512;
mod dispatch;
#[cfg(any(feature = "dual", test))]
mod dual;
pub mod eigenvalue;
mod lanes;
pub mod ldl;
mod plain;
mod portable;
mod real;
mod select;
mod sine;
mod smooth;
mod vector3;

#[cfg(all(feature = "vectors", target_arch = "x86_64"))]
pub use avx2::Avx2;
#[cfg(all(feature = "vectors", target_arch = "x86_64"))]
pub use avx512::Avx512;
pub use dispatch::{Unit, dispatch, dispatch_narrow, dispatch_on};
pub use lanes::{Kernel, LANES, Lanes};
pub use portable::Portable;
pub use real::Real;
pub use select::Select;
pub use sine::{SINE_LIMIT, sin_cos};
pub use smooth::Smooth;
pub use vector3::{add, constants, cross, dot, rotate, rotate_back, scale, sub};

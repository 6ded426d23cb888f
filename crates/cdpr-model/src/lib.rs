//! Models of cable-driven parallel robots: the robot as data, its cables, statics, tension distribution, equilibria,
//! and a controller that sends lengths for poses.
//!
//! Data flow from left to right through the modules [`geometry`], [`robot`], [`measurement`], [`cable`], [`model`],
//! [`statics`] and [`tension`], [`equilibrium`], [`compensation`], [`control`]; [`scalar`] has the number types,
//! [`solve`] the damped loop of every search, and [`reading`] the error of every file reader and the stable codes of
//! all errors. Symbols and signs are in [`notation`]. Units are SI and radians.
//!
//! Users use it through the crate `cdpr`.

#![warn(unnameable_types)]

pub mod cable;
pub mod compensation;
pub mod control;
pub mod equilibrium;
mod error_code;
pub mod finding;
pub mod geometry;
pub mod measurement;
pub mod model;
pub mod notation {
    //! The symbols of the documentation and of the code.
    #![doc = include_str!("notation.md")]
}
pub mod reading;
pub mod robot;
pub mod scalar;
pub mod solve;
pub mod statics;
pub mod tension;

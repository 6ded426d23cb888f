//! The toolchain for cable-driven parallel robots: models, calibration and model selection.

pub use nalgebra;

pub mod cable;
pub mod equilibrium;
pub mod geometry;
pub mod identification;
pub mod measurement;
pub mod metamodel;
pub mod model;
pub mod notation {
    //! The symbols of the documentation and of the code.
    #![doc = include_str!("notation.md")]
}
pub mod reading;
pub mod robot;
pub mod scalar;

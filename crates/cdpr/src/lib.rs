//! The toolchain for cable-driven parallel robots: models, calibration and model selection.
//!
//! A platform hangs in m cables. Cable i runs from its frame anchor aᵢ (world) to its platform anchor bᵢ (platform frame);
//! at the pose x = (r, R) its length is qᵢ = ‖aᵢ − r − R bᵢ‖, and pulleys, elasticity or sag make it longer. A *control
//! model* computes these lengths for the winches. Which one is good enough, and at which parameters p? From measured poses
//! and recorded lengths this library finds the parameters of candidate models,
//!
//! min over p of Σ ((q(x, p) − q_recorded)/σ)²,
//!
//! tells what the data determine and how surely, and recommends the simplest candidate that predicts data it was not
//! fitted to as well as the best one does.
//!
//! ```
//! use cdpr::equilibrium::{State, Status, distribution};
//! use cdpr::model::{Composition, Model};
//! use cdpr::robot::Robot;
//! use cdpr::statics::Load;
//! use cdpr::tension::Limits;
//!
//! let robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").ok_or("unknown robot")?;
//! let (load, limits) = (Load::of(&robot)?, Limits::of(&robot, None, None)?);
//! let model = Model::new(robot, Composition::ELASTIC)?;
//! let mut state = State::at_home(&model);
//! let home = state.pose();
//! let tensions = distribution::solve(&model, &home, &load, &limits)?.tensions;
//! let lengths = model.inverse(&home, &tensions, &mut state)?.controlled_lengths()?;
//! let found = model.forward(&lengths, None, None, &mut state)?;
//! assert_eq!(found.status, Status::Converged);
//! assert!((found.pose.position - home.position).norm() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Data flow from left to right through the modules [`geometry`], [`robot`], [`measurement`], [`cable`], [`model`],
//! [`statics`], [`equilibrium`], [`workspace`], [`metamodel`], [`identification`]; [`scalar`] holds the number types and [`reading`] the error of every
//! file reader, [`error_code`] the stable name of every error. Symbols and signs are in [`notation`]. SI units and radians everywhere.

#[cfg(test)]
extern crate self as cdpr;

pub use nalgebra;

pub mod cable;
pub mod equilibrium;
pub mod error_code;
pub mod geometry;
pub mod identification;
pub mod measurement;
pub mod metamodel;
pub mod model;
pub mod notation {
    //! The symbols of the documentation and of the code.
    #![doc = include_str!("notation.md")]
}
#[cfg(test)]
#[path = "../tests/library/main.rs"]
mod outside;
#[cfg(test)]
use outside::support::property;
pub mod reading;
pub mod robot;
pub mod scalar;
mod solve;
pub mod statics;
pub mod tension;
pub mod workspace;

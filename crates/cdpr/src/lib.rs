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
//! use cdpr::{Load, Model, Robot, State, Status};
//!
//! # let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/robots/");
//! let robot = Robot::from_file(format!("{folder}cablerobot-simulator-helicopter-elastostatic-calibrated.toml"))?;
//! let load = Load::of(&robot)?;
//! let model = Model::new(robot, "elastic".parse()?)?;
//! let mut state = State::at_home(&model);
//! let home = state.pose();
//!
//! let distribution = model.distribute(&home, &load)?; // tensions, or the reason for which there are none
//! let command = model.inverse(&home, &distribution.tensions, &mut state)?;
//! let lengths = command.controlled_lengths()?;
//! let answer = model.forward(&lengths, Some(&load), Some(&home), &mut state)?; // pose, tensions, status
//! assert_eq!(answer.status, Status::Converged);
//! assert!((answer.pose.position - home.position).norm() < 1e-9);
//! let volume = model.workspace(&load).wrench_feasible().volume()?; // m³, with a bound of its error
//! assert!(volume.error_bound < 0.1 * volume.size);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Data flow from left to right through the modules [`geometry`], [`robot`], [`measurement`], [`cable`], [`model`],
//! [`statics`], [`equilibrium`], [`workspace`], [`compensation`], [`metamodel`], [`identification`]; [`scalar`] holds the number types and [`reading`] the error of every
//! file reader, [`error_code`] the stable name of every error. Symbols and signs are in [`notation`]. SI units and radians everywhere.

#![warn(unnameable_types)]

#[cfg(test)]
extern crate self as cdpr;

pub use equilibrium::distribution::Distribution;
pub use equilibrium::{Solution, State, Status};
pub use geometry::{Pose, Twist, Wrench};
pub use measurement::Samples;
pub use metamodel::Experiment;
pub use model::{Composition, FreeParameters, Model};
pub use nalgebra;
pub use reading::{FileError, ReadError};
pub use robot::Robot;
pub use statics::Load;
pub use tension::Limits;

pub mod cable;
pub mod compensation;
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
pub mod plant;
pub mod reading;
pub mod robot;
pub mod scalar;
mod solve;
pub mod statics;
pub mod tension;
pub mod workspace;

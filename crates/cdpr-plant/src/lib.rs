//! The virtual machine in time: a rigid platform on cables of any composition, with ideal winches or drums.
//!
//! [`Plant`] is immutable, a [`PlantState`] belongs to the caller, and [`Plant::step`] advances a state without
//! allocating memory:
//!
//! M(x) \[v̇; ω̇\] + n(x, ω) = Σ fᵢ \[uᵢ; bᵢ × uᵢ\] + w(x, t),  fᵢ = max(0, law(qᵢ, q_θ,ᵢ) + dᵢ (q̇ᵢ − q̇_θ,ᵢ)),
//!
//! with the laws, outlets and loads of the static library: at rest the plant agrees with
//! [`Model::forward`](cdpr_model::model::Model::forward). The integrator is a symmetric, symplectic composition of
//! order four (decision 0039); a library's rule with error control is the reference (decision 0042). [`Scenario`] is
//! the file of a run, [`Simulation`] runs it.

mod cable_motion;
mod command;
mod control_loop;
mod controller;
mod controllers;
mod course;
mod cuts;
mod drums;
mod dynamics;
mod energy;
mod error;
mod error_code;
#[cfg(any(feature = "error-control", test))]
mod error_control;
pub mod events;
mod friction;
mod keys;
mod kicks;
mod linearization;
mod log;
mod modes;
mod momentum;
#[cfg(any(feature = "error-control", test))]
mod passages;
mod plant;
mod pulls;
pub mod scenario;
pub mod sensors;
mod series;
mod simulation;
mod stage_start;
mod start;
mod state;
mod step;
#[cfg(test)]
mod tests;
mod violations;
mod volume;

pub use cable_motion::CableMotion;
pub use command::Command;
pub use control_loop::Between;
pub use controller::{Controller, Measured, Setpoint};
pub use controllers::Control;
pub use course::{RunEnd, Summary};
pub use energy::Energy;
pub use error::{ControlError, PlantError, ScenarioKey, StepError};
pub use events::{Event, Happening};
pub use linearization::Linearization;
pub use log::LogFormat;
pub use modes::Mode;
pub use momentum::Inertia;
pub use plant::{Damping, Plant, Winches, assumptions_under_tensions};
pub use scenario::Scenario;
pub use sensors::Sensors;
pub use simulation::Simulation;
pub use state::PlantState;
pub use violations::Violation;
pub use volume::Volume;

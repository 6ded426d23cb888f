//! The compiled part of the Python package `cdpr`: robots and models on numpy arrays, machines in time, and the questions of the command.
//!
//! `python/src/cdpr` wraps it; what is said of shapes and units there holds here.

mod arrays;
mod choices;
mod controller;
mod error;
mod model;
mod plant;
mod question;
mod robot;
mod state;
mod sweep;

use pyo3::prelude::*;

/// The compiled part of `cdpr`.
#[pymodule]
mod _cdpr {
    #[pymodule_export]
    use crate::controller::Measured;
    #[pymodule_export]
    use crate::controller::Setpoint;
    #[pymodule_export]
    use crate::model::Model;
    #[pymodule_export]
    use crate::plant::Plant;
    #[pymodule_export]
    use crate::plant::PlantState;
    #[pymodule_export]
    use crate::question::ask;
    #[pymodule_export]
    use crate::question::command;
    #[pymodule_export]
    use crate::robot::Robot;
    #[pymodule_export]
    use crate::robot::builtin_names;
    #[pymodule_export]
    use crate::state::State;
    #[pymodule_export]
    use crate::sweep::PreparedSweep;
}

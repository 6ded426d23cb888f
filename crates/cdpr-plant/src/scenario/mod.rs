//! Scenario files: a machine, its start, commands and events.

#[cfg(feature = "files")]
mod checks;
#[cfg(feature = "files")]
mod reading;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

#[cfg(feature = "files")]
pub use reading::located;

use super::controllers::Control;
use super::events::EventTable;
use super::plant::Winches;
use super::sensors::SensorTable;
use cdpr_model::tension::Method;

/// A scenario as its file states it; the robot is named, not read.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "cdpr scenario")]
pub struct Scenario {
    /// The machine that moves.
    pub machine: Machine,
    /// Pose and tensions at which it starts.
    pub start: Start,
    /// Commands to the winches; they hold the lengths of the start when missing.
    #[serde(default)]
    pub control: Control,
    /// Wrench on the platform over time, besides load and weight.
    pub wrench: Option<WrenchSeries>,
    /// Events, in any order.
    #[serde(default)]
    pub event: Vec<EventTable>,
    /// Sensors that measure the machine.
    pub sensors: Option<SensorTable>,
    /// Duration, step and record.
    pub time: Time,
}

/// The machine that moves.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
pub struct Machine {
    /// Path (relative to the scenario) or built-in name. Mass, centre of mass and inertia come from its `[platform]`.
    pub robot: String,
    /// Composition of effects; cables must stretch. `elastic` when missing.
    #[serde(default = "elastic")]
    pub model: String,
    /// Winches: `ideal` (lengths follow the commands exactly, the default) or `drums` (with inertia and friction of
    /// the robot file).
    #[serde(default)]
    pub winches: Winches,
    /// Damping of every cable along the rate of its elongation (N·s/m), in place of that of the robot file.
    #[schemars(range(min = 0))]
    pub cable_damping_N_s_per_m: Option<f64>,
}

fn elastic() -> String {
    "elastic".to_owned()
}

/// Pose and tensions at which the machine starts.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
pub struct Start {
    /// Pose components of the motion pattern (m, rad) of the equilibrium.
    pub pose: Vec<f64>,
    /// Tensions there, one per cable (N): brought into balance with the load by the smallest change.
    pub tensions_N: Option<Vec<f64>>,
    /// Or how the tensions are found: a method of tension distribution; `qp` when both are missing.
    pub tension_method: Option<Method>,
    /// Least and largest tension that the method aims between (N), instead of the limits of the robot file.
    pub tension_limits_N: Option<[f64; 2]>,
    /// Displacement from the equilibrium in the degrees of freedom: position (m), then rotation vector (rad), world axes, from the left.
    pub displacement: Option<Vec<f64>>,
    /// Twist at the start in the degrees of freedom: v (m/s), then ω (rad/s), world axes.
    pub twist: Option<Vec<f64>>,
}

/// Wrench over time.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WrenchSeries {
    /// Times of the rows (s), ascending.
    pub time_s: Vec<f64>,
    /// Rows with the components of a wrench as `--wrench` takes them (N, N·m), straight between the rows and constant outside.
    pub wrench: Vec<Vec<f64>>,
}

/// Duration, step and record.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Time {
    /// Duration (s).
    pub duration_s: f64,
    /// Step of the integrator (s); 0.001 when missing.
    #[serde(default = "millisecond")]
    pub step_s: f64,
    /// Time between rows of the log (s), a whole multiple of the step; every tenth step when missing.
    pub record_s: Option<f64>,
    /// Integrator: `symplectic` (fixed steps, the default) or `error-controlled`.
    #[serde(default)]
    pub integrator: Integrator,
    /// `error-controlled`: error that each of its steps may have in m, rad, m/s and rad/s, and relative to them; 1e-10 when missing.
    #[schemars(range(min = 1e-13, max = 1e-3))]
    pub tolerance: Option<f64>,
}

/// Integrator of the equations of motion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Integrator {
    /// Steps of a fixed length, of order four, that keep the energy.
    #[default]
    Symplectic,
    /// Dormand and Prince's method of order eight with error control: a reference for machines with continuous
    /// forces.
    ErrorControlled,
}

fn millisecond() -> f64 {
    1e-3
}

/// JSON Schema of scenario files.
pub fn schema() -> schemars::Schema {
    schemars::schema_for!(Scenario)
}

//! Controllers: from the setpoint and the measurements to commands to the winches.

use super::command::Command;
use super::error::ControlError;
use super::sensors::Sensors;
use cdpr_model::geometry::{Pose, Twist};

/// Controller of a machine in time, with a state of its own. A [`Simulation`](super::Simulation) calls it for commands.
///
/// ```
/// use cdpr::plant::{Command, ControlError, Controller, RunEnd, Measured, Scenario, Setpoint, Simulation};
/// use cdpr::robot::Robot;
/// # use std::{convert::Infallible, ops::ControlFlow};
///
/// /// Winches that give way to what exceeds the tensions of the first look, every 5 ms: they damp.
/// #[derive(Clone, Debug, Default)]
/// struct GiveWay(Vec<f64>);
///
/// impl Controller for GiveWay {
///     fn command(&mut self, _: f64, _: &Setpoint, seen: &Measured<'_>, out: &mut [Command]) -> Result<(), ControlError> {
///         let first = self.0.is_empty().then(|| seen.tensions.to_vec());
///         self.0.extend(first.into_iter().flatten());
///         let excess = seen.tensions.iter().zip(&self.0).map(|(tension, level)| tension - level);
///         out.iter_mut().zip(excess).for_each(|(command, excess)| *command = Command::Speed(3e-5 * excess));
///         Ok(())
///     }
///     fn period(&self) -> Option<f64> { Some(0.005) }
///     fn reset(&mut self) { self.0.clear() }
///     fn boxed_clone(&self) -> Box<dyn Controller> { Box::new(self.clone()) }
/// }
///
/// let mut robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").ok_or("unknown robot")?;
/// robot.platform.center_of_mass = Some([0.0, 0.0, 0.1].into());
/// robot.platform.inertia = Some([[117.0, 0.0, 0.0], [0.0, 121.0, 0.0], [0.0, 0.0, 62.5]].into());
/// let scenario = "[machine]\nrobot = \"simulator\"\n[start]\npose = [0, 0, 1.5, 0, 0, 0]\ntension_method = \"closed-form\"\n\
///                 [[event]]\ntime_s = 0.1\nkind = \"wrench\"\nwrench = [300, 0, 0, 0, 0, 0]\n\
///                 [[event]]\ntime_s = 0.2\nkind = \"wrench\"\nwrench = [0, 0, 0, 0, 0, 0]\n[time]\nduration_s = 2\n";
/// let scenario = Scenario::from_toml_bytes(scenario.as_bytes(), "scenario.toml")?;
/// let speed_at_end = |mut simulation: Simulation| {
///     let summary = simulation.run(|_, _| Ok::<_, Infallible>(ControlFlow::Continue(())));
///     assert_eq!(summary.unwrap().end, RunEnd::Completed);
///     simulation.state.twist().norm()
/// };
/// let held = speed_at_end(Simulation::new(&scenario, robot.clone())?);
/// let damped = speed_at_end(Simulation::with_controller(&scenario, robot, Box::new(GiveWay::default()))?);
/// assert!(damped < 0.2 * held);
/// # Ok::<_, Box<dyn std::error::Error>>(())
/// ```
pub trait Controller: std::fmt::Debug + Send + Sync {
    /// Writes one command per cable. `out` holds the last commands; at first the present lengths of the winches.
    ///
    /// Without a [period](Self::period), `time` (s) is the end of the step that the commands are for, and the
    /// measurements are from its start. With a period, both are from the start of the period.
    fn command(
        &mut self,
        time: f64,
        wanted: &Setpoint,
        measured: &Measured<'_>,
        out: &mut [Command],
    ) -> Result<(), ControlError>;

    /// Time between two calls (s), counted from the start; `None` to be called for every step of the integrator.
    fn period(&self) -> Option<f64>;

    /// Resets the controller to before its first call.
    fn reset(&mut self);

    /// A copy of the controller with the same state.
    fn boxed_clone(&self) -> Box<dyn Controller>;

    /// Times (s, ascending) between which the commands of a controller without a period are linear, independent of
    /// measurements: an integrator with error control then steps freely between them. `None` if commands depend on more
    /// than time: the controller is then called at every step of the scenario.
    fn bends(&self) -> Option<&[f64]> {
        None
    }
}

impl Clone for Box<dyn Controller> {
    fn clone(&self) -> Self {
        self.boxed_clone()
    }
}

/// Wanted motion of a machine at a time.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Setpoint {
    /// Platform pose.
    pub pose: Pose,
    /// Twist \[v; ω\] of the platform origin (world axes; m/s, rad/s).
    pub twist: Twist,
    /// Acceleration \[v̇; ω̇\] of the platform origin (world axes; m/s², rad/s²).
    pub acceleration: Twist,
    /// Controlled lengths of the cables (m).
    pub lengths: Vec<f64>,
}

impl Setpoint {
    /// A platform at rest at a pose, its cables of these controlled lengths (m).
    pub fn at_rest(pose: Pose, lengths: Vec<f64>) -> Self {
        Self { pose, twist: Twist::zeros(), acceleration: Twist::zeros(), lengths }
    }
}

/// View of the machine for a controller: the true state, and the sensors of the scenario.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Measured<'a> {
    /// Time since the start (s).
    pub time: f64,
    /// Platform pose.
    pub pose: Pose,
    /// Twist \[v; ω\] of the platform origin (world axes; m/s, rad/s).
    pub twist: Twist,
    /// Controlled lengths (m).
    pub lengths: &'a [f64],
    /// Rates of the controlled lengths (m/s), positive if cable is paid out.
    pub length_rates: &'a [f64],
    /// Tensions at the outlets (N).
    pub tensions: &'a [f64],
    /// Sensors with their readings so far; `None` if the scenario has none.
    pub sensors: Option<&'a Sensors>,
}

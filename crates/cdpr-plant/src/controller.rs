//! Controllers: from what is wanted and what is measured to commands to the winches.

use super::command::Command;
use super::error::ControlError;
use super::sensors::Sensors;
use cdpr_model::geometry::{Pose, Twist};

/// Controller of a machine in time, with a state of its own. A [`Simulation`](super::Simulation) asks it for commands.
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
    /// Writes one command per cable. `out` holds the last ones; at first the lengths at which the winches stand.
    ///
    /// Without a [period](Self::period) `time` (s) is the end of the step that the commands are for, and what is measured is of its start; with one
    /// both are of the moment at which it begins.
    fn command(
        &mut self,
        time: f64,
        wanted: &Setpoint,
        measured: &Measured<'_>,
        out: &mut [Command],
    ) -> Result<(), ControlError>;

    /// Time from one question to the next (s), counted from the start; `None` if it is asked for every step of the integrator.
    fn period(&self) -> Option<f64>;

    /// Goes back to before the first question.
    fn reset(&mut self);

    /// A controller of its own that goes on from the same state.
    fn boxed_clone(&self) -> Box<dyn Controller>;

    /// Times (s, ascending) between which the commands of a controller without a period are straight lines, whatever is measured: an integrator with error
    /// control steps over all others. `None` if commands depend on more than time: it then asks at every step of the scenario.
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

/// View that a controller has of the machine: the true state, and the sensors of the scenario beside it.
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
    /// Their rates (m/s), positive where cable is paid out.
    pub length_rates: &'a [f64],
    /// Tensions at the outlets (N).
    pub tensions: &'a [f64],
    /// Sensors with what they have seen up to now; `None` if the scenario has none.
    pub sensors: Option<&'a Sensors>,
}

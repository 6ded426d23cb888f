//! Accuracies of the sensors in a machine: stated, or assumed and then told by the residuals.

use crate::fit::ASSUMED_NOISE;
use cdpr_model::geometry::Twist;
use cdpr_model::measurement::SensorSigmas;
use cdpr_model::model::Model;

/// Noise assumed for an angle of swivels or inclinometers where none is stated (rad).
const ASSUMED_ANGLE: f64 = 0.01;
/// Share of the mean tension assumed as the noise of load cells where none is stated: they have offsets and scales.
const ASSUMED_TENSION_SHARE: f64 = 0.05;
/// Share of the mean tension by which cables and load may miss their equilibrium: a law, kept by rows of great weight.
const BALANCE_SHARE: f64 = 1e-4;

/// Factor of tensions' accuracy in first searches of poses.
const RELAXATION: f64 = 100.0;

/// Kind of row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sensor {
    /// Lengths of cables.
    Length,
    /// Tensions of cables.
    Tension,
    /// Cables in equilibrium with the load, which no sensor measures.
    Balance,
    /// Swivel angles of pulleys.
    Swivel,
    /// Components of positions: a reflector's, a probe's height.
    Position,
    /// Orientations: an inclinometer's.
    Rotation,
}

impl Sensor {
    /// True where its accuracy is known.
    pub(crate) fn is_stated(self, stated: &SensorSigmas) -> bool {
        match self {
            // lengths without error would weigh without end: the assumed accuracy takes their place
            Self::Length => stated.length.is_some_and(|sigma| sigma > 0.0),
            Self::Tension => stated.tension.is_some(),
            Self::Swivel => stated.swivel.is_some(),
            Self::Position => stated.position.is_some(),
            Self::Rotation => stated.rotation.is_some(),
            Self::Balance => true,
        }
    }
}

/// Accuracies of all sensors, as standard deviations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Weights {
    /// (m)
    pub(crate) length: f64,
    /// (N)
    pub(crate) tension: f64,
    /// (rad)
    pub(crate) swivel: f64,
    /// Of orientations (rad); `None` where they count as exact.
    pub(crate) rotation: Option<f64>,
    /// Of positions (m); `None` where they count as exact.
    pub(crate) position: Option<f64>,
    /// Of forces in equilibrium (N).
    pub(crate) balance: f64,
    /// Tension to expect of a cable (N).
    pub(super) typical: f64,
    /// Arm by which moments count as forces: by their stated accuracies, else the size of the platform as its file has it, which no parameter changes (m).
    arm: f64,
}

impl Weights {
    /// Stated accuracies, and assumed ones where none are stated; `mean_tension` of what is recorded, or of what holds the load (N).
    pub(crate) fn new(model: &Model, stated: &SensorSigmas, mean_tension: f64) -> Self {
        let positive = |sigma: Option<f64>| sigma.filter(|sigma| *sigma > 0.0);
        let mean = mean_tension.abs().max(1e-3);
        let balance = positive(stated.balance_force);
        let tension = positive(stated.tension).unwrap_or(ASSUMED_TENSION_SHARE * mean);
        let balance = balance.unwrap_or((BALANCE_SHARE * mean).min(0.1 * tension));
        let arm = positive(stated.balance_moment).map_or_else(|| model.platform_radius(), |moment| moment / balance);
        Self {
            length: positive(stated.length).unwrap_or(ASSUMED_NOISE),
            tension,
            swivel: positive(stated.swivel).unwrap_or(ASSUMED_ANGLE),
            rotation: match stated.rotation {
                None => Some(ASSUMED_ANGLE),
                stated => positive(stated),
            },
            position: positive(stated.position),
            balance,
            typical: mean,
            arm,
        }
    }

    /// 1/σ of a sensor's rows.
    pub(super) fn of(&self, sensor: Sensor) -> f64 {
        self.sigma(sensor).map_or(0.0, f64::recip)
    }

    /// σ of a sensor's rows; `None` if they count as exact.
    pub(crate) fn sigma(&self, sensor: Sensor) -> Option<f64> {
        match sensor {
            Sensor::Length => Some(self.length),
            Sensor::Tension => Some(self.tension),
            Sensor::Swivel => Some(self.swivel),
            Sensor::Position => self.position,
            Sensor::Rotation => self.rotation,
            Sensor::Balance => Some(self.balance),
        }
    }

    /// Takes another accuracy for a sensor.
    pub(crate) fn set(&mut self, sensor: Sensor, sigma: f64) {
        match sensor {
            Sensor::Length => self.length = sigma,
            Sensor::Tension => self.tension = sigma,
            Sensor::Swivel => self.swivel = sigma,
            Sensor::Position => self.position = Some(sigma),
            Sensor::Rotation => self.rotation = Some(sigma),
            Sensor::Balance => self.balance = sigma,
        }
    }

    /// The same where frames of the tracker are free: positions without a stated accuracy are measured with an assumed one, since none of the robot's frame is exact.
    pub(crate) fn of_tracker(self) -> Self {
        Self { position: self.position.or(Some(ASSUMED_NOISE)), ..self }
    }

    /// Accuracies that leave poses to lengths and angles.
    pub(super) fn relaxed(&self) -> Self {
        Self { tension: RELAXATION * self.tension, balance: RELAXATION * self.balance, ..*self }
    }

    /// 1/σ of an equilibrium row of the pattern: moments count by the platform's size.
    pub(super) fn balance(&self, model: &Model, row: usize) -> f64 {
        let is_turn = is_turn(&model.twist_basis()[row]);
        self.of(Sensor::Balance) / if is_turn { self.arm } else { 1.0 }
    }

    /// 1/σ of a measured part of a pose along a direction; 0 where it counts as exact, as a pose does that is known whole without stated accuracy.
    pub(super) fn along(&self, twist: &Twist, known: &[bool]) -> f64 {
        let is_whole = known.iter().all(|known| *known);
        let sigma = match is_turn(twist) {
            true => self.rotation.filter(|_| !is_whole || self.position.is_some()),
            false => self.position,
        };
        sigma.map_or(0.0, f64::recip)
    }
}

/// True for a direction that turns the platform.
pub(super) fn is_turn(twist: &Twist) -> bool {
    twist.fixed_rows::<3>(3).norm_squared() > 0.0
}

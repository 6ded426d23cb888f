//! Quantities, and the wrenches that a unit of each adds to the load.

use nalgebra::{UnitQuaternion, Vector3};

use cdpr_model::geometry::Wrench;
use cdpr_model::model::Model;

/// Quantity that a robot can do so much of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Quantity {
    /// Mass that is added to the robot's own load (kg).
    Payload,
    /// Acceleration of the platform from rest in any direction (m/s²).
    Acceleration,
    /// Acceleration in both senses of the axis with this index (m/s²).
    AxisAcceleration(usize),
    /// Speed of the platform in any direction, without turning (m/s).
    Speed,
}

/// Quantity that the robot's file does not answer, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Absent {
    /// The quantity.
    pub quantity: Quantity,
    /// Reason in words.
    pub reason: String,
}

/// Wrenches that the unit of a quantity adds; the speed asks for none.
#[derive(Clone, Debug)]
pub(super) enum Demand {
    /// Weight of 1 kg (world axes, moment about the platform origin), at every corner of its place.
    Payload(Vec<Wrench>),
    /// The mass (kg) and its center R c (world, m), accelerated in any direction of these axes.
    Ball { mass: f64, arm: Vector3<f64>, axes: Vec<Vector3<f64>> },
    /// The same in both senses of one axis.
    Axis { mass: f64, arm: Vector3<f64>, axis: Vector3<f64>, index: usize },
    /// Speed of the platform.
    Speed,
}

impl Demand {
    pub(super) fn quantity(&self) -> Quantity {
        match self {
            Self::Payload(_) => Quantity::Payload,
            Self::Ball { .. } => Quantity::Acceleration,
            Self::Axis { index, .. } => Quantity::AxisAcceleration(*index),
            Self::Speed => Quantity::Speed,
        }
    }

    /// Largest normal · w of what one unit adds; zero or less where a half-space does not limit the quantity.
    pub(super) fn support(&self, normal: &Wrench) -> f64 {
        match self {
            Self::Payload(weights) => weights.iter().map(|w| normal.dot(w)).fold(f64::NEG_INFINITY, f64::max),
            Self::Ball { mass, arm, axes } => {
                let force = along(normal, arm);
                mass * axes.iter().map(|axis| axis.dot(&force).powi(2)).sum::<f64>().sqrt()
            }
            Self::Axis { mass, arm, axis, .. } => mass * axis.dot(&along(normal, arm)).abs(),
            Self::Speed => 0.0,
        }
    }

    /// Wrenches that one unit adds and that a half-space with this normal may limit first: every corner of the payload's
    /// place, both senses of an axis, of a ball the direction that it limits first.
    pub(super) fn wrenches(&self, normal: &Wrench) -> Vec<Wrench> {
        let accelerated = |mass: f64, arm: &Vector3<f64>, direction: Vector3<f64>| {
            let (force, moment) = (direction * -mass, arm.cross(&(direction * -mass)));
            Wrench::new(force.x, force.y, force.z, moment.x, moment.y, moment.z)
        };
        match self {
            Self::Payload(weights) => weights.clone(),
            Self::Ball { mass, arm, .. } => {
                vec![accelerated(*mass, arm, self.direction(normal).unwrap_or_else(Vector3::zeros))]
            }
            Self::Axis { mass, arm, axis, .. } => [-axis, *axis].map(|axis| accelerated(*mass, arm, axis)).to_vec(),
            Self::Speed => Vec::new(),
        }
    }

    /// Largest size of what one unit adds, with moments divided by a length (m).
    pub(super) fn size(&self, length: f64) -> f64 {
        let of = |mass: f64, arm: &Vector3<f64>| mass * (1.0 + (arm.norm() / length).powi(2)).sqrt();
        match self {
            Self::Payload(weights) => {
                let of = |w: &Wrench| w.fixed_rows::<3>(0).norm().hypot(w.fixed_rows::<3>(3).norm() / length);
                weights.iter().map(of).fold(0.0, f64::max)
            }
            Self::Ball { mass, arm, .. } | Self::Axis { mass, arm, .. } => of(*mass, arm),
            Self::Speed => 0.0,
        }
    }

    /// Direction of the acceleration (world, length 1) that a half-space limits first; `None` for other quantities.
    pub(super) fn direction(&self, normal: &Wrench) -> Option<Vector3<f64>> {
        match self {
            Self::Ball { arm, axes, .. } => {
                let force = along(normal, arm);
                let within: Vector3<f64> = axes.iter().map(|axis| axis * axis.dot(&force)).sum();
                Some(-within.try_normalize(0.0)?)
            }
            Self::Axis { arm, axis, .. } => Some(-axis * axis.dot(&along(normal, arm)).signum()),
            Self::Payload(_) | Self::Speed => None,
        }
    }
}

/// Row of a normal by a force through a point with this arm: n · \[e; arm × e\] = e · (n_F + n_M × arm).
pub(super) fn along(normal: &Wrench, arm: &Vector3<f64>) -> Vector3<f64> {
    let (force, moment) = (normal.fixed_rows::<3>(0), normal.fixed_rows::<3>(3).into_owned());
    force + moment.cross(arm)
}

/// The demands of payload and accelerations, or the reason for which the robot's file does not determine them.
pub(super) fn all(model: &Model, rotation: UnitQuaternion<f64>, payload_place: f64) -> Vec<Result<Demand, Absent>> {
    let mut all = vec![payload(model, rotation, payload_place).map(Demand::Payload)];
    let axes = model.axes();
    let quantities = std::iter::once(Quantity::Acceleration).chain((0..axes.len()).map(Quantity::AxisAcceleration));
    match moved(model) {
        Err(absent) => all.extend(quantities.map(|quantity| Err(Absent { quantity, ..absent.clone() }))),
        Ok(Moved { mass, center }) => {
            let arm = rotation * center;
            all.push(Ok(Demand::Ball { mass, arm, axes: axes.to_vec() }));
            let axis = |(index, axis): (usize, &Vector3<f64>)| Ok(Demand::Axis { mass, arm, axis: *axis, index });
            all.extend(axes.iter().enumerate().map(axis));
        }
    }
    all
}

/// Weights of 1 kg at every corner of its place.
fn payload(model: &Model, rotation: UnitQuaternion<f64>, place: f64) -> Result<Vec<Wrench>, Absent> {
    let absent = |reason: &str| Absent { quantity: Quantity::Payload, reason: reason.to_owned() };
    let robot = model.robot();
    let Some(gravity) = robot.gravity else {
        return Err(absent("the robot file lacks `gravity_m_s2`, so a mass has no weight"));
    };
    if model.axes().iter().all(|axis| axis.dot(&gravity) == 0.0) {
        return Err(absent("gravity does not act along any axis of the robot, so cables do not carry the weight"));
    }
    let turns = robot.motion_pattern.has_rotation() && place > 0.0;
    let own = if robot.motion_pattern.is_planar() { model.axes().to_vec() } else { vec![] };
    let sides = if own.is_empty() { vec![Vector3::x(), Vector3::y(), Vector3::z()] } else { own };
    let corners = if turns { 1_u32 << sides.len() } else { 1 };
    let weight = |corner: u32| {
        let sign = |side: usize| if corner & (1 << side) != 0 { 1.0 } else { -1.0 };
        let offset: Vector3<f64> = sides.iter().enumerate().map(|(side, axis)| axis * (sign(side) * place)).sum();
        let moment = (rotation * offset).cross(&gravity);
        Wrench::new(gravity.x, gravity.y, gravity.z, moment.x, moment.y, moment.z)
    };
    Ok((0..corners).map(weight).collect())
}

/// The mass (kg) and its center (platform frame, m).
struct Moved {
    mass: f64,
    center: Vector3<f64>,
}

fn moved(model: &Model) -> Result<Moved, Absent> {
    let robot = model.robot();
    let absent = |reason: String| Absent { quantity: Quantity::Acceleration, reason };
    let missing =
        |key: &str| absent(format!("the robot file lacks {key} in [platform], so what accelerates is unknown"));
    let mass = match robot.platform.mass {
        None => return Err(missing("`mass_kg`")),
        Some(0.0) => return Err(absent("`mass_kg` in [platform] is 0: nothing resists".to_owned())),
        Some(mass) => mass,
    };
    match robot.platform.center_of_mass {
        Some(center) => Ok(Moved { mass, center }),
        None if robot.motion_pattern.has_rotation() => Err(missing("`center_of_mass_m`")),
        None => Ok(Moved { mass, center: Vector3::zeros() }),
    }
}

//! Quantities that a robot can do so much of.

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

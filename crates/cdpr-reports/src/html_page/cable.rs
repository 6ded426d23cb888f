//! A cable between frame and platform, as pages draw it.

use cdpr_model::robot::Cable;
use nalgebra::Vector3;
use serde::Serialize;

use super::{digits, plain};

/// Name, anchors and limits of a cable.
#[derive(Serialize)]
pub(crate) struct CableData {
    name: String,
    frame_anchor_m: [f64; 3],
    platform_anchor_m: [f64; 3],
    /// Null where the limits are unknown.
    #[serde(rename = "tension_min_N")]
    tension_min: Option<f64>,
    #[serde(rename = "tension_max_N")]
    tension_max: Option<f64>,
}

impl CableData {
    /// Data of a cable with its least and largest tension (N).
    pub(crate) fn of(cable: &Cable, limits: Option<(f64, f64)>) -> Self {
        Self {
            name: plain(&cable.name),
            frame_anchor_m: vector(&cable.frame_anchor, 7),
            platform_anchor_m: vector(&cable.platform_anchor, 7),
            tension_min: limits.map(|(least, _)| least),
            tension_max: limits.map(|(_, largest)| largest),
        }
    }
}

/// Components of a point or direction, to so many digits.
pub(crate) fn vector(point: &Vector3<f64>, count: usize) -> [f64; 3] {
    <[f64; 3]>::from(*point).map(|component| digits(component, count))
}

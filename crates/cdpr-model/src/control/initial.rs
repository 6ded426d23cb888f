//! The pose at which winches are set, and the tensions there.

use serde::Deserialize;

use crate::tension::Method;

/// The pose at which the winches are set, and how.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
pub struct Initial {
    /// Pose components of the motion pattern (m, rad).
    pub pose: Vec<f64>,
    /// Initial tensions, one per cable (N): brought into balance with the load by the smallest change. Elastic robots only.
    pub tensions_N: Option<Vec<f64>>,
    /// Or how the initial tensions are found: a method of tension distribution. Elastic robots only.
    pub tension_method: Option<Method>,
    /// Least and largest tension that the method aims between (N), instead of the limits: the level of eq. 3.41.
    pub tension_limits_N: Option<[f64; 2]>,
    /// `"none"`: the control model's lengths go to the machine as they are.
    pub offset: Option<String>,
    /// Winch offsets, one per cable (m).
    pub offset_m: Option<Vec<f64>>,
    /// The robot whose model was in use when the winches were set.
    pub offset_robot: Option<String>,
}

//! Tensions, displacements, maps and elements of a robot at a pose.

use cdpr_calibration::compensation::Judged;
use cdpr_model::compensation::Extent;
use cdpr_model::reading::Keyword;
use cdpr_model::tension::quadratic::Certificate;
use cdpr_study::effects::Displacement;

use super::ErrorBlockKeys;
use super::adapters::keys;

keys! {
    /// Direction in which the load asks for more than the cables can give.
    InfeasibilityKeys of Certificate { direction, weights, required = "required_N", reachable = "reachable_N" }
    /// Displacement of the platform and change of the tensions.
    DisplacementKeys of Displacement {
        translation = "translation_m", rotation = "rotation_rad", tension = "tension_change_N",
        slack = "slack_cables", method.name(),
    }
    /// Errors without a map and with maps of the other samples.
    JudgedMapKeys of Judged {
        samples, beyond.outside = "outside", beyond.fading = "fading", without by ErrorBlockKeys, with by ErrorBlockKeys,
        gain_m2, gain_standard_error_m2,
    }
    /// Range of the samples of a map along one coordinate, in its `unit`.
    ExtentKeys of Extent { axis, unit, ends, margin }
}

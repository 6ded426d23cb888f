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
    InfeasibilityKeys as "InfeasibilityProof" of Certificate {
        /// Direction, one entry per row of the structure matrix.
        direction,
        /// Weights per cable, the largest by amount 1; zero for cables that do not take part. Only rounding if no cable acts in the direction at all (lost rank); then the largest entry of the direction is 1.
        weights,
        /// Value of Σ weights · tensions in equilibrium (N).
        required = "required_N",
        /// The largest Σ weights · tensions within limits (N), less than `required_N`.
        reachable = "reachable_N",
    }
    /// Displacement of the platform and change of the tensions.
    DisplacementKeys of Displacement {
        /// Distance of the platform origin (m).
        translation = "translation_m",
        /// Angle of rotation (rad).
        rotation = "rotation_rad",
        /// Largest change of a tension at the outlets (N); null for rigid straight cables, whose tensions do not follow from lengths.
        tension = "tension_change_N",
        /// Number of cables that lose their tension.
        slack = "slack_cables",
        /// Method by which it was found.
        method.name(),
    }
    /// Errors without a map and with maps of the other samples.
    JudgedMapKeys as "JudgedMap" of Judged {
        /// Samples.
        samples,
        /// Number of poses beyond its margin, where only the model acts.
        beyond.outside = "outside",
        /// Number of poses in its margin, where it fades.
        beyond.fading = "fading",
        /// Errors of the model alone.
        without by ErrorBlockKeys,
        /// Errors with the map.
        with by ErrorBlockKeys,
        /// Fall of the mean square length error (m²).
        gain_m2,
        /// Its standard error (m²).
        gain_standard_error_m2,
    }
    /// Range of the samples of a map along one coordinate, in its `unit`.
    ExtentKeys as "MapExtent" of Extent {
        /// World axis of the coordinate, `x` to `z` or `rx` to `rz`.
        axis,
        /// `m` or `rad`.
        unit,
        /// Smallest and largest coordinate of the samples, between which the map acts fully.
        ends,
        /// Distance beyond the ends over which it fades to zero.
        margin,
    }
}

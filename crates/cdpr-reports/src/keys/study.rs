//! Errors of control models on machines.

use cdpr_model::compensation::Beyond;
use cdpr_model::control::{History, MapEffect, PoseErrorStatistics, TensionErrorStatistics};
use cdpr_model::reading::Keyword;
use cdpr_study::accuracy::Accuracy;
use cdpr_study::branches::Branches;
use cdpr_study::difference::{Difference, ErrorChange};
use cdpr_study::field::Summary;
use cdpr_study::force_tracking::ForceTracking;
use schemars::JsonSchema;
use serde::Serialize;

use super::adapters::{keys, tables};
use super::table_schema::nullable_numbers;
use super::{LengthErrorKeys, Maybe, PoseErrorKeys, TensionErrorKeys};

/// Numbers of poses at which a map does not act fully.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Beyond")]
#[schemars(rename = "Beyond")]
pub(crate) struct BeyondKeys {
    /// Poses beyond its margin, where only the model acts.
    outside: usize,
    /// Poses in its margin, where it fades.
    fading: usize,
}

/// Errors over the poses of a study, exact and by one linear step.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Summary")]
#[schemars(rename = "StudySummary", transform = nullable_numbers)]
pub(crate) struct SummaryKeys {
    /// Number of commanded poses.
    samples: usize,
    /// Number of them at which the platform comes to rest.
    converged: usize,
    /// Distance between commanded and emerging position (m), exact.
    #[serde(with = "PoseErrorKeys")]
    position_error_m: PoseErrorStatistics,
    /// Angle between commanded and emerging orientation (rad), exact.
    #[serde(with = "PoseErrorKeys")]
    rotation_error_rad: PoseErrorStatistics,
    /// Null where no tensions are commanded or none emerge.
    #[serde(rename = "tension_error_N", with = "Maybe::<TensionErrorKeys>")]
    tension_error: Option<TensionErrorStatistics>,
    /// Residual force of the cables held at the commanded poses; null for a rigid machine.
    #[serde(rename = "residual_force_N", with = "Maybe::<PoseErrorKeys>")]
    residual_force: Option<PoseErrorStatistics>,
    /// Mean position error as a fraction of the diameter of the positions (eq. 3.5); null for one position.
    relative_position_error: Option<f64>,
    /// Diameter of the sampled positions: the diagonal of their box (m).
    diameter_m: f64,
    /// Distance between commanded and emerging position by the linear step (m).
    #[serde(with = "PoseErrorKeys")]
    linear_position_error_m: PoseErrorStatistics,
    /// Distance between the positions of the linear step and of the exact solution.
    #[serde(with = "PoseErrorKeys")]
    linear_residual_m: PoseErrorStatistics,
    /// Fraction of the poses at which that distance is at most a tenth of the exact error.
    linear_trusted_share: f64,
    /// Effect of the map that corrects the control model; null without one.
    #[serde(with = "Maybe::<MappedSummaryKeys>", skip_serializing_if = "Option::is_none")]
    compensation: Option<Box<MapEffect<Summary>>>,
}

/// Effect of the map that corrects the control model.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "MapEffect<Summary>")]
#[schemars(rename = "MappedSummary")]
struct MappedSummaryKeys {
    #[serde(flatten, with = "BeyondKeys")]
    beyond: Beyond,
    /// Errors of the control model without the map.
    #[serde(with = "SummaryKeys")]
    without: Summary,
}

tables!(
    MappedSummaryKeys: MapEffect<Summary>,
);

keys! {
    /// Errors of a control model on a machine.
    AccuracyKeys as "ControlErrors" of Accuracy {
        /// Number of commanded poses.
        samples,
        /// Distance between commanded and emerging position (m).
        position_error_m by PoseErrorKeys,
        /// Geodesic angle between commanded and emerging orientation (rad).
        rotation_error_rad by PoseErrorKeys,
        /// Lengths that the control model computes for the emerging pose, minus those it sent for the commanded one (eq. 6.6; m).
        length_error_m by LengthErrorKeys,
        /// Emerging minus commanded tensions (N); null if control model or machine has no tensions.
        tension_error_N by Maybe<TensionErrorKeys>,
        /// Smallest emerging tension (N); null for a rigid machine.
        tension_min_N,
        /// Largest emerging tension (N); null for a rigid machine.
        tension_max_N,
        /// Number of poses by the status of their answer; only converged ones count in the errors.
        statuses,
        /// Poses at which at least one cable is slack.
        slack_samples,
        /// Fraction of the converged poses with a tension outside the limits; null for a rigid machine or unknown limits.
        outside_limits_share,
        /// Effect of the map that corrects the control model; null without one.
        compensation unless none by Maybe<MappedAccuracyKeys>,
    }
    /// Effect of the map that corrects the control model.
    MappedAccuracyKeys as "MappedControlErrors" of MapEffect<Accuracy> {
        /// Poses beyond its margin, where only the model acts.
        beyond.outside = "outside",
        /// Poses in its margin, where it fades.
        beyond.fading = "fading",
        /// Errors of the control model without the map.
        without by AccuracyKeys,
    }
    /// Distances between the ends of several ways to each pose.
    BranchesKeys as "BranchSpread" of Branches {
        /// Length of the detour along each translation, to either side (m).
        stroke_m,
        /// Poses at which the platform comes to rest after every path; only these count.
        samples,
        /// Count of paths to each pose: straight from the initial pose, and from both sides along each translation.
        ways,
        /// Largest distance between two of the emerging positions (m).
        position_spread_m by PoseErrorKeys,
        /// Largest angle between two of the emerging orientations (rad).
        rotation_spread_rad by PoseErrorKeys,
        /// Largest difference of a cable's tension (N).
        tension_spread_N by PoseErrorKeys,
    }
    /// Path on which a machine with hysteresis comes to the poses.
    HistoryKeys as "CableHistory" of History {
        /// Pose that each pose is reached from.
        reach,
        /// Steps of the way to each pose, straight and evenly turning; 10 when missing.
        sub_steps,
    }
    /// Force control of two controllers.
    ForceTrackingKeys of ForceTracking {
        /// Comparison of both.
        verdict.name(),
        /// Mean over poses of the 2-norm of emerging less commanded tensions, with the controller before (N).
        before_mean_norm_N,
        /// The same with the controller after (N).
        after_mean_norm_N,
    }
    /// Errors of one controller minus those of another.
    DifferenceKeys of Difference {
        /// Number of commanded poses.
        samples,
        /// Number of them at which both have an answer.
        compared,
        /// Number of poses at which the position error is smaller than with the other.
        better,
        /// Number of poses at which it is larger.
        worse,
        /// Distance between commanded and emerging position (m).
        position_error_m by ErrorChangeKeys,
        /// Angle between commanded and emerging orientation (rad).
        rotation_error_rad by ErrorChangeKeys,
        /// 2-norm over cables of emerging minus commanded tensions (N); null unless both controllers command tensions and the machine has its own.
        tension_error_N by Maybe<ErrorChangeKeys>,
    }
    /// Error of two controllers at the same poses.
    ErrorChangeKeys of ErrorChange {
        /// Error of this controller.
        own by PoseErrorKeys,
        /// Error of the other one.
        other by PoseErrorKeys,
        /// Mean of own minus other.
        mean_change,
        /// Own mean divided by that of the other, minus 1; null if the other makes no error.
        relative_change,
        /// Largest reduction at one pose; 0 if there is none.
        largest_gain,
        /// Largest increase at one pose; 0 if there is none.
        largest_loss,
    }
}

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

use super::adapters::{keys, nullable_numbers, tables};
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
    samples: usize,
    converged: usize,
    #[serde(with = "PoseErrorKeys")]
    position_error_m: PoseErrorStatistics,
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
    diameter_m: f64,
    #[serde(with = "PoseErrorKeys")]
    linear_position_error_m: PoseErrorStatistics,
    /// Distance between the positions of the linear step and of the exact solution.
    #[serde(with = "PoseErrorKeys")]
    linear_residual_m: PoseErrorStatistics,
    /// Fraction of the poses at which that distance is at most a tenth of the exact error.
    linear_trusted_share: f64,
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
    AccuracyKeys of Accuracy {
        samples, position_error_m by PoseErrorKeys, rotation_error_rad by PoseErrorKeys,
        length_error_m by LengthErrorKeys, tension_error_N by Maybe<TensionErrorKeys>, tension_min_N, tension_max_N,
        statuses, slack_samples, outside_limits_share, compensation unless none by Maybe<MappedAccuracyKeys>,
    }
    /// Effect of the map that corrects the control model.
    MappedAccuracyKeys of MapEffect<Accuracy> {
        beyond.outside = "outside", beyond.fading = "fading", without by AccuracyKeys,
    }
    /// Distances between the ends of several ways to each pose.
    BranchesKeys of Branches {
        stroke_m, samples, ways, position_spread_m by PoseErrorKeys, rotation_spread_rad by PoseErrorKeys,
        tension_spread_N by PoseErrorKeys,
    }
    /// Path on which a machine with hysteresis comes to the poses.
    HistoryKeys of History { reach, sub_steps }
    /// Force control of two controllers.
    ForceTrackingKeys of ForceTracking { verdict.name(), before_mean_norm_N, after_mean_norm_N }
    /// Errors of one controller minus those of another.
    DifferenceKeys of Difference {
        samples, compared, better, worse, position_error_m by ErrorChangeKeys, rotation_error_rad by ErrorChangeKeys,
        tension_error_N by Maybe<ErrorChangeKeys>,
    }
    /// Error of two controllers at the same poses.
    ErrorChangeKeys of ErrorChange {
        own by PoseErrorKeys, other by PoseErrorKeys, mean_change, relative_change, largest_gain, largest_loss,
    }
}

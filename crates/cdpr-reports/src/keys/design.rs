//! Planned measurements.

use cdpr_calibration::{CurvePoint, GridComparison, ParameterPrediction, Plan, PosePrediction, Predicted};

use super::adapters::keys;
use super::{Each, Maybe};

keys! {
    /// Poses that tell most, with what they tell.
    PlanKeys of Plan {
        parameter_count, rank, log_det, condition, sigma_min, trace_inverse, i_value, starts, fraction = "share",
        curve by Each<CurvePointKeys>, grid by GridKeys, all_log_det,
    }
    /// Information of the best poses of a number.
    CurvePointKeys of CurvePoint { count, log_det }
    /// Plain grid of as many poses.
    GridKeys of GridComparison { log_det, efficiency }
    /// Deviations that measurements lead to.
    PredictedKeys of Predicted {
        assumed = "assumed_length_sigma_m", deviations by Each<ParameterPredictionKeys>,
        pose by Maybe<PosePredictionKeys>, weak_directions,
    }
    /// Deviation of a parameter, in its `unit`.
    ParameterPredictionKeys of ParameterPrediction { parameter, unit, sigma }
    /// Deviation of the pose that a controller with the identified parameters drives to.
    PosePredictionKeys of PosePrediction { position_m, position_max_m, rotation_rad, poses }
}

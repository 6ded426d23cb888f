//! Planned measurements.

use cdpr_calibration::{CurvePoint, GridComparison, ParameterPrediction, Plan, PosePrediction, Predicted};

use super::adapters::keys;
use super::{Each, Maybe};

keys! {
    /// Poses that tell most, with what they tell.
    PlanKeys of Plan {
        /// Number of free parameters.
        parameter_count,
        /// Rank of the Jacobian at the chosen poses and those measured already.
        rank,
        /// log det M; null where the poses do not determine all parameters.
        log_det,
        /// κ of the Jacobian in SI units; null below full rank.
        condition,
        /// Smallest singular value of the Jacobian; 0 below full rank.
        sigma_min,
        /// tr M⁻¹.
        trace_inverse,
        /// Mean variance of all lengths over the candidates, u M⁻¹ uᵀ (m² where accuracies are stated).
        i_value,
        /// Sets from which exchanges started, and the share of them that led to the plan's value.
        starts,
        /// Fraction of the starts that ended there.
        fraction = "share",
        /// log det over the number of poses.
        curve by Each<CurvePointKeys>,
        /// The plain grid of as many poses.
        grid by GridKeys,
        /// All candidates together: nothing tells more.
        all_log_det,
    }
    /// Information of the best poses of a number.
    CurvePointKeys of CurvePoint {
        /// Number of poses.
        count,
        /// log det M; null where as many poses do not determine all parameters.
        log_det,
    }
    /// Plain grid of as many poses.
    GridKeys as "GridComparison" of GridComparison {
        /// log det M of the grid; null where it does not determine all parameters.
        log_det,
        /// exp((log det grid − log det plan)/p): share of the plan's poses that would tell as much as the grid; null where the plan does not determine all parameters, 0 where only the grid does not.
        efficiency,
    }
    /// Deviations that measurements lead to.
    PredictedKeys as "PredictedDeviations" of Predicted {
        /// Length noise that was assumed since no accuracy is stated (m); deviations are proportional to it.
        assumed = "assumed_length_sigma_m",
        /// Every free parameter.
        deviations by Each<ParameterPredictionKeys>,
        /// The platform; null where a parameter is not determined, or no pose has an answer.
        pose by Maybe<PosePredictionKeys>,
        /// Directions that these poses leave weak, in words.
        weak_directions,
    }
    /// Deviation of a parameter, in its `unit`.
    ParameterPredictionKeys of ParameterPrediction {
        /// Name, e.g. `frame-anchor[1].x`.
        parameter,
        /// Its unit; empty for a ratio.
        unit,
        /// Standard deviation; null where the poses do not determine it.
        sigma,
    }
    /// Deviation of the pose that a controller with the identified parameters drives to.
    PosePredictionKeys of PosePrediction {
        /// Root mean square over poses of the root of the mean squared distance (m).
        position_m,
        /// Largest (m).
        position_max_m,
        /// Root mean square of the angle (rad).
        rotation_rad,
        /// Poses that were asked.
        poses,
    }
}

//! Parameters of a fit beyond their values: courses, profiles, resampling, penalties and scales.

use cdpr_calibration::Difference as PairedDifference;
use cdpr_calibration::fit::{Profile, ProfilePoint, RowWeights};
use cdpr_calibration::{
    Conditioning, CourseStep, Influence, KindCondition, KindScale, PathParameter, PathPoint, Reduction, Resampled,
    ResampledDeviation,
};

use cdpr_model::reading::Keyword;

use super::Each;
use super::adapters::keys;

keys! {
    /// Step of a fit.
    CourseStepKeys of CourseStep {
        values, step_m, length_rms_m, force_rms = "force_rms_N", moment_rms = "moment_rms_Nm", position_rms_m, rank,
        condition, condition_scaled,
    }
    /// Course of the weighted squares over one parameter, in its `unit`.
    ProfileKeys of Profile {
        parameter, unit, value, sigma, quantile_95, threshold, interval, length_rms_m, given_length_rms_m,
        points by Each<ProfilePointKeys>,
    }
    /// One value of a profiled parameter.
    ProfilePointKeys of ProfilePoint { shift, held, refitted, length_rms_m, position_mean_m }
    /// Parameters of data drawn anew.
    ResampledKeys of Resampled { replicates, failed, block_length, parameters by Each<ResampledDeviationKeys>, warning }
    /// Standard deviations of a parameter, in its `unit`.
    ResampledDeviationKeys of ResampledDeviation { parameter, unit, linear, bootstrap, bias, ratio }
    /// Least value at one penalty.
    PathPointKeys of PathPoint {
        lambda, parameter_count, validation, standard_error, squares, converged, values, changes_m,
    }
    /// Free parameter of a path, in its `unit`.
    PathParameterKeys of PathParameter { name, unit, centre, is_penalised, enters }
    /// Smaller model that data show, each pair of the full model and the smaller one.
    ReductionKeys of Reduction {
        evidence.name(), reason, patterns, parameter_count, left, position_mean_m, standard_error = "standard_error_m",
        difference by DifferenceToBestKeys,
    }
    /// Errors of the smaller model minus those of the full one on the same samples (m).
    DifferenceToBestKeys of PairedDifference { mean = "mean_m", standard_error = "standard_error_m" }
    /// Condition of the Jacobian of a model on data.
    ConditioningKeys of Conditioning {
        row_weights by RowWeightKeys, parameter_count, rank, condition, condition_unit_columns,
        kinds by Each<KindConditionKeys>, scales by Each<KindScaleKeys>, condition_scaled,
        influences by Each<InfluenceKeys>,
    }
    /// Weights of the rows of lengths and wrenches.
    RowWeightKeys of RowWeights { wrench = "wrench_per_N", length = "length_per_m" }
    /// Condition of one kind of parameters.
    KindConditionKeys of KindCondition { kind.name(), parameter_count, condition }
    /// Scale of a kind of parameters in its SI unit.
    KindScaleKeys of KindScale { kind.name(), factor }
    /// Factor of the condition.
    InfluenceKeys of Influence { name, factor, words }
}

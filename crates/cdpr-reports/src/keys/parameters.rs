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
        /// Values of the free parameters after the step, in their order (SI).
        values,
        /// Largest change of a parameter by the step in metres of cable, the measure of the step rule; null at the start.
        step_m,
        /// Root mean square of the length rows (m).
        length_rms_m,
        /// The same of the force rows (N); null of rigid models.
        force_rms = "force_rms_N",
        /// The same of the moment rows (N·m); null of rigid models and where nothing turns.
        moment_rms = "moment_rms_Nm",
        /// Root mean square of the predicted position error (m), where predicted poses are made small.
        position_rms_m,
        /// Rank of the rows' Jacobian.
        rank,
        /// κ of the rows' Jacobian in SI units (eq. 4.23), rows by their weights.
        condition,
        /// κ with columns of length one.
        condition_scaled,
    }
    /// Course of the weighted squares over one parameter, in its `unit`.
    ProfileKeys of Profile {
        /// Name of the parameter.
        parameter,
        /// Its unit.
        unit,
        /// Optimal value.
        value,
        /// Linear standard deviation.
        sigma,
        /// Half width of the linear 95 % interval in these deviations.
        quantile_95,
        /// Rise of the weighted squares at the ends of the interval: the square of `quantile_95` times that of the noise that `sigma` is of.
        threshold,
        /// Ends of the 95 % interval of the profile likelihood, the others refitted; null where it is open.
        interval,
        /// Root mean square of the length residuals at the optimum (m).
        length_rms_m,
        /// The same of the model as given, the level to compare with (m).
        given_length_rms_m,
        /// Points from small to large values.
        points by Each<ProfilePointKeys>,
    }
    /// One value of a profiled parameter.
    ProfilePointKeys of ProfilePoint {
        /// Value minus the optimal one.
        shift,
        /// Rise of the weighted squares, the other parameters held.
        held,
        /// The same, the others refitted.
        refitted,
        /// Root mean square of the length residuals, the others held (m).
        length_rms_m,
        /// Mean position error of the prediction from the recorded lengths, the others held (m).
        position_mean_m,
    }
    /// Parameters of data drawn anew.
    ResampledKeys of Resampled {
        /// Replicates whose fit converged.
        replicates,
        /// Replicates without a fit.
        failed,
        /// Consecutive samples in a block.
        block_length,
        /// Every free parameter.
        parameters by Each<ResampledDeviationKeys>,
        /// Doubt in words: both deviations of some parameters differ by more than a factor 1.5; and which of them to take.
        warning,
    }
    /// Standard deviations of a parameter, in its `unit`.
    ResampledDeviationKeys of ResampledDeviation {
        /// Name.
        parameter,
        /// Unit.
        unit,
        /// By the Jacobian at the optimum; null where the data do not determine it.
        linear,
        /// Of the replicates.
        bootstrap,
        /// Mean of the replicates minus the optimum.
        bias,
        /// Bootstrap through linear.
        ratio,
    }
    /// Least value at one penalty.
    PathPointKeys of PathPoint {
        /// λ: per metre of cable (lasso), per its square (ridge).
        lambda,
        /// Parameters off the centre of the penalty, and those without penalty.
        parameter_count,
        /// Mean error on data held out (SI).
        validation,
        /// Its standard error by a bootstrap of blocks.
        standard_error,
        /// χ² of data and priors, without the penalty.
        squares,
        /// False where the limit of steps was reached.
        converged,
        /// Values of all parameters.
        values,
        /// Their changes from the centre in metres of cable, which the penalty is of.
        changes_m,
    }
    /// Free parameter of a path, in its `unit`.
    PathParameterKeys of PathParameter {
        /// Name.
        name,
        /// Unit; empty for a ratio.
        unit,
        /// Value at which it has no penalty.
        centre,
        /// Whether the penalty acts on it.
        is_penalised,
        /// Largest λ of the path at which it is off the centre; null where it never is or has no penalty.
        enters,
    }
    /// Smaller model that data show, each pair of the full model and the smaller one.
    ReductionKeys of Reduction {
        /// Evidence.
        evidence.name(),
        /// The same in words.
        reason,
        /// Motion patterns of the model asked for and of the smaller one.
        patterns,
        /// Numbers of their parameters.
        parameter_count,
        /// Names of the parameters that are left out.
        left,
        /// Mean position errors of both on data held out (m).
        position_mean_m,
        /// Standard error of the first.
        standard_error = "standard_error_m",
        /// The second minus the first on the same samples, and the standard error of that (m).
        difference by DifferenceToBestKeys,
    }
    /// Errors of the smaller model minus those of the full one on the same samples (m).
    DifferenceToBestKeys of PairedDifference {
        /// Mean (m).
        mean = "mean_m",
        /// Standard error of the mean (m).
        standard_error = "standard_error_m",
    }
    /// Condition of the Jacobian of a model on data.
    ConditioningKeys of Conditioning {
        /// Weights of the rows.
        row_weights by RowWeightKeys,
        /// Number of free parameters.
        parameter_count,
        /// Rank of the Jacobian.
        rank,
        /// κ in SI units.
        condition,
        /// κ with columns of length one.
        condition_unit_columns,
        /// Kinds, each alone.
        kinds by Each<KindConditionKeys>,
        /// Scales, as given or found.
        scales by Each<KindScaleKeys>,
        /// κ under these scales.
        condition_scaled,
        /// Factors of κ in SI units.
        influences by Each<ConditionFactorKeys>,
    }
    /// Weights of the rows of lengths and wrenches.
    RowWeightKeys of RowWeights {
        /// Of wrenches: forces (1/N) and moments (1/(N·m)).
        wrench = "wrench_per_N",
        /// Of lengths (1/m).
        length = "length_per_m",
    }
    /// Condition of one kind of parameters.
    KindConditionKeys of KindCondition {
        /// The kind.
        kind.name(),
        /// Its parameters.
        parameter_count,
        /// κ of their columns alone.
        condition,
    }
    /// Scale of a kind of parameters in its SI unit.
    KindScaleKeys of KindScale {
        /// The kind; axial stiffness stands for compliance, counted by k_F = 1/compliance.
        kind.name(),
        /// Its unit.
        factor,
    }
    /// Factor of the condition.
    ConditionFactorKeys of Influence {
        /// `structure`, `parameters`, `samples` or `scaling`.
        name,
        /// The factor; null where it makes the rank deficient.
        factor,
        /// Words with numbers.
        words,
    }
}

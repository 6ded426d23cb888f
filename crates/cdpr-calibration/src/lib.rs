//! From measurements to calibrated models, their uncertainty, and the choice between them.
//!
//! Rigid models have residuals in joint space: modelled minus recorded cable lengths at the measured poses (eq. 4.8). Every
//! parameter belongs to one cable, so the problem falls into one small block per cable. Elastic models have rows of wrenches
//! besides (eq. 4.38), which tie the cables together.

mod autocorrelation;
mod bootstrap;
pub mod candidate;
mod clock;
mod clock_test;
pub mod compensation;
mod correlated_rows;
mod course;
pub mod coverage;
mod cross_validation;
mod design;
mod error_code;
pub mod evaluation;
mod findings;
pub mod fit;
pub mod frequency_response;
pub mod friction;
mod gauge_convention;
mod identifiability;
mod likelihood;
mod loss;
mod minimize;
mod misfit;
mod noise;
mod norms;
mod objective;
mod objective_values;
mod outliers;
mod paired;
mod path;
mod plain_rows;
mod plausibility;
mod point_robot;
mod pose_band;
mod problem;
mod progress;
mod recorded;
#[cfg(test)]
mod recorded_curves;
mod reduction;
mod resampling;
mod residual;
mod scaling;
mod screening;
pub mod selection;
mod self_calibration;
mod stopping;
mod student;
pub mod test_bench;
mod unit_scale;
mod verdict;
mod words;

pub use bootstrap::standard_error;
pub use candidate::Candidate;
pub use clock::ClockOffset;
pub use clock_test::clock_warning;
pub use course::{CourseStep, course};
pub use coverage::{Coverage, PoseRange, coverage};
pub use cross_validation::{
    CrossValidation, CrossValidationError, cross_validate, cross_validation_fits, evaluate_given,
};
pub use design::{
    Candidates, CurvePoint, DesignCriterion, GridComparison, ParameterPrediction, Plan, PlanError, PlanSettings,
    PosePrediction, Predicted, plan,
};
pub use evaluation::{ErrorBlocks, Evaluation, EvaluationError, WorstCable, evaluate, evaluate_fitted};
pub use findings::{Examined, UNIT_FACTORS, findings};
pub use fit::{Fit, FrameEstimate, Gauge, Prior, RecordingFrames, frame_warning};
pub use gauge_convention::GaugeConvention;
pub use identifiability::{Analysis, Correlation};
pub use likelihood::{Information, NoiseSource};
pub use loss::Loss;
pub use minimize::certificate::{ActiveSample, Certificate};
pub use minimize::starts::{StartOptimum, Starts};
pub use objective::{Minimize, Objective};
pub use objective_values::ObjectiveValues;
pub use outliers::Outlier;
pub use paired::Difference;
pub use path::{PathParameter, PathPoint, PathSettings, Penalty, PenaltyPath, Towards, penalty_path};
pub use plausibility::{Distrust, distrust};
pub use point_robot::{point_pattern, without_rotation};
pub use pose_band::PoseBand;
pub use progress::{Progress, unobserved};
pub use reduction::{Evidence, Reduction, propose_reduction};
pub use resampling::{Resampled, ResampledDeviation, resampled};
pub use scaling::{
    ConditionMap, Conditioning, Influence, KindCondition, KindScale, condition_map, conditioning, scaled_kind,
};
pub use screening::{Screened, repeated_of, screened};
pub use self_calibration::{
    Comparison, GaugeFixing, PredictedBand, SelfCalibration, SensorFit, cross_validate_without_poses, evaluate_lengths,
    self_calibrate,
};
pub use stopping::{StoppedBy, StoppingRule};
pub use verdict::{Doubt, DoubtKind, Verdict};

//! How well a model predicts measured samples.

#[cfg(test)]
mod tests;
mod worst_cable;

pub use worst_cable::WorstCable;

use thiserror::Error;

use super::outliers::unexplained;
use cdpr_model::compensation::Compensation;
use cdpr_model::control::{LengthErrorStatistics, PoseErrorStatistics, TensionErrorStatistics};
use cdpr_model::equilibrium::{
    ForwardError, ForwardProblem, ForwardSettings, InverseSolution, NoSolution, State, elastostatics,
};
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::Samples;
use cdpr_model::model::{Model, WinchError};
use cdpr_model::statics::LoadError;

/// All errors of a model on a data set, SI units.
///
/// A sample without an answer has no error: statistics are those of the samples that have a value, NaN where none has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorBlocks {
    /// Number of samples.
    pub samples: usize,
    /// Distance between predicted and measured position (m).
    pub position_error_m: PoseErrorStatistics,
    /// Geodesic angle between predicted and measured orientation (rad).
    pub rotation_error_rad: PoseErrorStatistics,
    /// Modelled minus recorded lengths at the measured poses (m).
    pub length_error_m: LengthErrorStatistics,
    /// Predicted minus recorded tensions; `None` for a model that knows none, or data without.
    pub tension_error: Option<TensionErrorStatistics>,
    /// Modelled minus recorded swivel angles at the poses where measurements agree best; `None` where there are none.
    pub swivel_error: Option<LengthErrorStatistics>,
    /// Samples whose forward problem has an answer: those of the errors of position, rotation and tension.
    pub answered: usize,
    /// Samples whose forward problem has none: not converged, singular or unstable.
    pub not_converged: usize,
    /// Samples with a modelled length of every cable: those of the length errors.
    pub length_samples: usize,
}

/// Errors sample by sample; NaN where a sample has none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Evaluation {
    /// Distance between predicted and measured position (m).
    pub position: Vec<f64>,
    /// Predicted minus measured position (world, m).
    pub position_vector: Vec<[f64; 3]>,
    /// Geodesic angle between predicted and measured orientation (rad).
    pub rotation: Vec<f64>,
    /// Modelled minus recorded lengths at the measured pose, sample by sample (m); NaN where the model has none.
    pub length: Vec<f64>,
    /// Predicted minus recorded tensions, sample by sample (N); empty for a model that knows none, or data without.
    pub tension: Vec<f64>,
    /// Modelled minus recorded swivel angles, sample by sample (rad); empty where none are compared.
    pub swivel: Vec<f64>,
    /// Number of cables.
    pub cable_count: usize,
    /// Samples whose forward problem has no answer, from 0, with the reason.
    pub not_converged: Vec<(usize, String)>,
}

/// A model whose predictions cannot be computed.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum EvaluationError {
    /// An elastic model of a robot whose load is unknown.
    #[error("an elastic model predicts poses and tensions under load: {0}")]
    Load(#[from] LoadError),
    /// An elastic model whose forward problem has no answer, such as one of rigid cables.
    #[error("the model cannot predict poses: {0}")]
    Forward(#[from] elastostatics::InputError),
    /// Motor angles that the robot's winches cannot have.
    #[error(transparent)]
    Winch(#[from] WinchError),
    /// Not one length per cable.
    #[error("the robot has {robot} cables, the data have {data}")]
    CableCount {
        /// Cables of the robot.
        robot: usize,
        /// Cables in the data.
        data: usize,
    },
}

impl From<ForwardError> for EvaluationError {
    fn from(error: ForwardError) -> Self {
        match error {
            ForwardError::Load(error) => Self::Load(error),
            ForwardError::Input(error) => Self::Forward(error),
        }
    }
}

/// Pose and tensions that a model predicts for one sample.
struct Prediction {
    pose: Pose,
    /// Real tensions (N); `None` where lengths tell none.
    tensions: Option<Vec<f64>>,
}

/// Sample without a prediction.
#[derive(Debug, Error)]
#[error(transparent)]
enum NoPrediction {
    /// No forward problem can be posed.
    Forward(#[from] ForwardError),
    /// It has no solution.
    NoSolution(#[from] NoSolution),
    /// Pose and correction depend on each other and do not settle.
    #[error(
        "the pose and its correction by the map do not settle in {TURNS} turns: the last one moved it by {moved:.1e} m or rad"
    )]
    Unsettled {
        /// Largest component of the last displacement (m, rad).
        moved: f64,
    },
}

/// Most turns in which a pose and the correction there are found.
const TURNS: usize = 50;

/// Displacement at which such turns end (m, rad).
const SETTLED: f64 = 1e-10;

/// Displacement of the last of all turns above which they have not settled (m, rad): a thousandth of what sensors see.
const UNSETTLED: f64 = 1e-7;

/// The forward problem of a model, for one sample after the other.
enum Predictor {
    Problem(ForwardProblem, Box<ForwardSettings>),
    /// No sample has an answer, for this reason.
    None(elastostatics::InputError),
}

impl Predictor {
    fn new(model: &Model, state: &mut State) -> Result<Self, EvaluationError> {
        // the measured pose is near the solution: a residual there is the model's, not a wrong minimum's
        let mut settings = ForwardSettings::default();
        settings.least_squares.suspicious_residual = settings.least_squares.plausible_residual;
        Ok(Self::Problem(model.forward_problem(None, state)?, Box::new(settings)))
    }

    fn knows_tensions(&self) -> bool {
        // a model that fits lengths always has a problem
        !matches!(self, Self::Problem(ForwardProblem::LeastSquares, _))
    }

    /// The prediction, or why there is none.
    fn predict(
        &self,
        model: &Model,
        controlled: &[f64],
        near: &Pose,
        state: &mut State,
    ) -> Result<Prediction, NoPrediction> {
        let settings = match self {
            Self::None(reason) => return Err(ForwardError::from(reason.clone()).into()),
            Self::Problem(_, settings) => settings,
        };
        let found = model.forward_with(settings, controlled, None, Some(near), state)?.converged()?;
        Ok(Prediction { pose: found.pose, tensions: self.knows_tensions().then(|| found.tensions.clone()) })
    }

    /// The prediction from recorded lengths corrected by a map at the pose that they lead to; `first` is the one without.
    fn predict_corrected(
        &self,
        model: &Model,
        (recorded, first): (&[f64], Prediction),
        map: &Compensation,
        state: &mut State,
    ) -> Result<Prediction, NoPrediction> {
        let (mut found, mut moved) = (first, f64::INFINITY);
        let mut before = recorded.to_vec();
        for _ in 0..TURNS {
            let modelled = map.at(&found.pose).taken_from(recorded);
            // the same lengths lead to the same pose, as beyond the map
            if modelled == before {
                return Ok(found);
            }
            let length = |(cable, &length): (usize, &f64)| model.controlled_length(cable, length);
            let controlled: Vec<f64> = modelled.iter().enumerate().map(length).collect();
            let next = self.predict(model, &controlled, &found.pose, state)?;
            moved = found.pose.displacement_to(&next.pose).amax();
            (found, before) = (next, modelled);
            if moved < SETTLED {
                return Ok(found);
            }
        }
        if moved < UNSETTLED { Ok(found) } else { Err(NoPrediction::Unsettled { moved }) }
    }
}

/// Compares a model with samples: its forward problem from the recorded lengths with the measured poses (and tensions), its
/// inverse at the measured poses (and tensions, predicted ones where none are recorded) with the recorded lengths.
pub fn evaluate(model: &Model, samples: &Samples) -> Result<Evaluation, EvaluationError> {
    let mut state = State::at_home(model);
    let predictor = Predictor::new(model, &mut state)?;
    evaluate_with(&predictor, model, samples, None, &mut state)
}

/// [`evaluate_fitted`] of a model whose lengths are corrected at every pose.
pub(super) fn evaluate_corrected(
    model: &Model,
    samples: &Samples,
    map: &Compensation,
) -> Result<Evaluation, EvaluationError> {
    evaluate_perhaps_corrected(model, samples, Some(map))
}

/// [`evaluate`] of a model that a fit has made: parameters without a forward problem are the outcome of the fit, so that no
/// sample has an answer, and not a mistake of the caller.
pub fn evaluate_fitted(model: &Model, samples: &Samples) -> Result<Evaluation, EvaluationError> {
    evaluate_perhaps_corrected(model, samples, None)
}

fn evaluate_perhaps_corrected(
    model: &Model,
    samples: &Samples,
    map: Option<&Compensation>,
) -> Result<Evaluation, EvaluationError> {
    let mut state = State::at_home(model);
    let predictor = match Predictor::new(model, &mut state) {
        Err(EvaluationError::Forward(reason)) => Predictor::None(reason),
        other => other?,
    };
    evaluate_with(&predictor, model, samples, map, &mut state)
}

fn evaluate_with(
    predictor: &Predictor,
    model: &Model,
    samples: &Samples,
    map: Option<&Compensation>,
    state: &mut State,
) -> Result<Evaluation, EvaluationError> {
    let cables = model.cable_count();
    if cables != samples.cable_count {
        return Err(EvaluationError::CableCount { robot: cables, data: samples.cable_count });
    }
    let samples = &*model.with_lengths(samples)?;
    let mut evaluation = Evaluation { cable_count: cables, ..Evaluation::default() };
    let (mut controlled, mut tensions) = (vec![0.0; cables], vec![0.0; cables]);
    for (sample, pose) in samples.poses.iter().enumerate() {
        let recorded = samples.lengths_of(sample);
        for (cable, length) in controlled.iter_mut().enumerate() {
            *length = model.controlled_length(cable, recorded[cable]);
        }
        let mut predicted = predictor.predict(model, &controlled, pose, state);
        if let (Some(map), Ok(first)) = (map, &mut predicted) {
            let first = Prediction { pose: first.pose, tensions: first.tensions.take() };
            predicted = predictor.predict_corrected(model, (recorded, first), map, state);
        }
        evaluation.add_pose(predicted.as_ref(), pose);
        let measured = samples.tensions.as_ref().map(|tensions| &tensions[sample * cables..][..cables]);
        let predicted = predicted.ok().and_then(|found| found.tensions);
        for (cable, tension) in tensions.iter_mut().enumerate() {
            let measured = measured.map(|tensions| model.real_tension(cable, tensions[cable]));
            let predicted = predicted.as_ref().map(|tensions| tensions[cable]);
            *tension = measured.or(predicted).unwrap_or(f64::NAN);
        }
        evaluation.add_lengths(model.inverse(pose, &tensions, state).ok(), (pose, map), recorded);
        if let Some(measured) = measured.filter(|_| predictor.knows_tensions()) {
            let error = |cable: usize| {
                let predicted = predicted.as_ref().map_or(f64::NAN, |tensions| tensions[cable]);
                model.recorded_tension(cable, predicted) - measured[cable]
            };
            evaluation.tension.extend((0..cables).map(error));
        }
    }
    Ok(evaluation)
}

/// Poses that a model predicts from recorded lengths, near the measured ones; `None` where the forward problem has no answer.
pub(crate) fn predicted_poses(model: &Model, samples: &Samples) -> Option<Vec<Option<Pose>>> {
    let mut state = State::at_home(model);
    let predictor = Predictor::new(model, &mut state).ok()?;
    let samples = &*model.with_lengths(samples).ok()?;
    let predict = |(sample, near): (usize, &Pose)| {
        let recorded = samples.lengths_of(sample).iter().enumerate();
        let controlled: Vec<f64> = recorded.map(|(cable, length)| model.controlled_length(cable, *length)).collect();
        predictor.predict(model, &controlled, near, &mut state).ok().map(|found| found.pose)
    };
    Some(samples.poses.iter().enumerate().map(predict).collect())
}

impl Evaluation {
    /// Appends the errors of a predicted pose, or the reason why there is none.
    fn add_pose(&mut self, predicted: Result<&Prediction, &NoPrediction>, measured: &Pose) {
        if let Err(reason) = predicted {
            self.not_converged.push((self.len(), reason.to_string()));
        }
        let shift = predicted.map_or([f64::NAN; 3], |predicted| (predicted.pose.position - measured.position).into());
        self.position.push(nalgebra::Vector3::from(shift).norm());
        self.position_vector.push(shift);
        self.rotation.push(predicted.map_or(f64::NAN, |predicted| predicted.pose.angle_to(measured)));
    }

    /// Appends modelled minus recorded lengths, corrected at the pose where a map knows how; NaN where the model has none.
    fn add_lengths(
        &mut self,
        modelled: Option<&InverseSolution>,
        (pose, map): (&Pose, Option<&Compensation>),
        recorded: &[f64],
    ) {
        let length = |cable: usize| modelled.map_or(f64::NAN, |solution| solution.cables[cable].recorded_length);
        let modelled: Vec<f64> = (0..recorded.len()).map(length).collect();
        let modelled = map.map_or(modelled.clone(), |map| map.at(pose).added_to(&modelled));
        self.length.extend(modelled.iter().zip(recorded).map(|(modelled, recorded)| modelled - recorded));
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.position.len()
    }

    /// True without samples.
    pub fn is_empty(&self) -> bool {
        self.position.is_empty()
    }

    /// 2-norm over the cables of one sample's tension errors (N); NaN where there are none.
    pub(crate) fn tension_norm_of(&self, sample: usize) -> f64 {
        let errors = self.tension.get(sample * self.cable_count..(sample + 1) * self.cable_count);
        errors.map_or(f64::NAN, |errors| errors.iter().map(|x| x * x).sum::<f64>().sqrt())
    }

    /// The samples at these places, in this order.
    #[must_use]
    pub fn subset(&self, places: &[usize]) -> Self {
        let rows = |data: &[f64]| -> Vec<f64> {
            let row = |&place: &usize| data[place * self.cable_count..][..self.cable_count].iter().copied();
            if data.is_empty() { Vec::new() } else { places.iter().flat_map(row).collect() }
        };
        let reason = |(index, place): (usize, &usize)| {
            let (_, why) = self.not_converged.iter().find(|(sample, _)| sample == place)?;
            Some((index, why.clone()))
        };
        Self {
            position: places.iter().map(|&place| self.position[place]).collect(),
            position_vector: places.iter().map(|&place| self.position_vector[place]).collect(),
            rotation: places.iter().map(|&place| self.rotation[place]).collect(),
            length: rows(&self.length),
            tension: rows(&self.tension),
            swivel: rows(&self.swivel),
            cable_count: self.cable_count,
            not_converged: places.iter().enumerate().filter_map(reason).collect(),
        }
    }

    /// Places of the samples whose position error lies beyond 8 robust standard deviations for both models.
    pub fn unexplained_with(&self, other: &Self) -> Vec<usize> {
        let error = |place: usize| self.position[place].min(*other.position.get(place).unwrap_or(&f64::NAN));
        unexplained((0..self.len()).map(error))
    }

    /// Appends the samples of another evaluation.
    pub fn extend(&mut self, other: &Self) {
        let offset = self.len();
        self.cable_count = other.cable_count;
        self.position.extend(&other.position);
        self.position_vector.extend(&other.position_vector);
        self.rotation.extend(&other.rotation);
        self.length.extend(&other.length);
        self.tension.extend(&other.tension);
        self.swivel.extend(&other.swivel);
        self.not_converged.extend(other.not_converged.iter().map(|(sample, why)| (sample + offset, why.clone())));
    }

    /// The statistics.
    pub fn blocks(&self) -> ErrorBlocks {
        let finite = |values: &[f64]| values.iter().copied().filter(|value| value.is_finite()).collect::<Vec<_>>();
        let whole = |values: &[f64]| whole_samples(values, self.cable_count);
        let (lengths, tensions) = (whole(&self.length), whole(&self.tension));
        ErrorBlocks {
            samples: self.len(),
            position_error_m: PoseErrorStatistics::of(&finite(&self.position)),
            rotation_error_rad: PoseErrorStatistics::of(&finite(&self.rotation)),
            length_error_m: LengthErrorStatistics::of(&lengths),
            tension_error: (!self.tension.is_empty()).then(|| TensionErrorStatistics::of(&tensions, self.cable_count)),
            swivel_error: (!self.swivel.is_empty()).then(|| LengthErrorStatistics::of(&whole(&self.swivel))),
            answered: self.len() - self.not_converged.len(),
            not_converged: self.not_converged.len(),
            length_samples: lengths.len() / self.cable_count.max(1),
        }
    }
}

/// Values of those samples that have one for every cable.
fn whole_samples(values: &[f64], cable_count: usize) -> Vec<f64> {
    let samples = values.chunks(cable_count.max(1));
    samples.filter(|sample| sample.iter().all(|value| value.is_finite())).flatten().copied().collect()
}

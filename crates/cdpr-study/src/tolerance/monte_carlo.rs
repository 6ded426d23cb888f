//! Accuracy of robots drawn at random.

use super::batch::{Batch, Room};
use super::robots::{Made, Makers, draw};
use crate::parts::{self, Parts};
use crate::sensitivity::{ParameterDeviation, PoseSensitivity, Setting, Side};
use crate::study::Distribution;
use cdpr_model::control::Control;
use cdpr_model::control::InputError;
use cdpr_model::control::Operation;
use cdpr_model::control::Status;
use cdpr_model::control::error_statistics::quantile;
use cdpr_model::control::{CommandedPose, History};
use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::model::Model;
use cdpr_model::reading::keywords;
use cdpr_model::tension::Method;
use serde::{Deserialize, Serialize};

/// Most answers kept in memory.
const ANSWER_LIMIT: usize = 50_000_000;

/// Method by which the drawn robots answer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Engine {
    /// By the exact forward problem.
    #[default]
    Exact,
    /// By the derivatives.
    Linear,
}

keywords!(Engine: Exact = "exact", Linear = "linear");

/// Settings of a draw of robots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings<'a> {
    /// Parameters that deviate: those of the derivatives of the nominal robot, in their order.
    pub causes: &'a [ParameterDeviation],
    /// Standard deviation of every cause, in its unit.
    pub sigmas: &'a [f64],
    /// Distribution of the deviations.
    pub distribution: Distribution,
    /// Number of robots to draw.
    pub robots: usize,
    /// The same seed draws the same robots on any number of threads.
    pub seed: u64,
    /// Method by which they answer.
    pub engine: Engine,
    /// Path of a machine with memory to the poses.
    pub history: Option<History>,
}

/// Mean and quantiles of a set of numbers; NaN if it is empty.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantiles {
    /// Mean.
    pub mean: f64,
    /// Root mean square.
    pub rms: f64,
    /// Median: half of the numbers are smaller.
    pub median: f64,
    /// 95th percentile.
    pub p95: f64,
    /// 99th percentile.
    pub p99: f64,
    /// Largest.
    pub max: f64,
}

/// Statistics of the drawn robots.
#[derive(Clone, Debug, PartialEq)]
pub struct MonteCarlo {
    /// Method by which they answered.
    pub engine: Engine,
    /// Robots drawn.
    pub robots: usize,
    /// Pairs of robot and pose without an answer, which do not count.
    pub unanswered: usize,
    /// Reason for which the first of them has no answer.
    pub reason: Option<String>,
    /// Distance from the commanded position over all robots and poses (m).
    pub error: Quantiles,
    /// Angle from the commanded orientation (rad).
    pub rotation_error: Quantiles,
    /// Distance from the position of the robot without deviations (m).
    pub deviation: Quantiles,
    /// Mean error of each robot over the poses; quantiles over the robots (m).
    pub mean_of_robot: Quantiles,
    /// Largest error of each robot; quantiles over the robots (m).
    pub max_of_robot: Quantiles,
    /// Error, pose by pose; quantiles over the robots (m).
    pub errors: Vec<Quantiles>,
    /// Deviation, pose by pose; quantiles over the robots (m).
    pub deviations: Vec<Quantiles>,
}

/// Error, rotation error and deviation at one pose; NaN without an answer.
type Answer = [f64; 3];

/// Robots of a part of a draw.
const ROBOTS_OF_PART: usize = 16;

/// Answers of some of the drawn robots: a part of a draw.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DrawnPart {
    robots: Vec<DrawnRobot>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct DrawnRobot {
    /// Answer at every pose; null without one.
    answers: Vec<[Option<f64>; 3]>,
    reason: Option<String>,
}

/// Draws robots with deviations and drives each through the poses.
///
/// `nominal` has the outcomes and derivatives of the robot without deviations, pose by pose. Parameters are clamped to
/// their bounds: radii not below 0, stiffness above 0.
pub fn monte_carlo(
    control: impl Into<Control>,
    machine: &Model,
    setting: &Setting<'_>,
    offsets: &[f64],
    poses: &[CommandedPose],
    nominal: &[PoseSensitivity],
    settings: &Settings<'_>,
) -> Result<MonteCarlo, InputError> {
    let control = control.into();
    Draw { control: &control, machine, setting, offsets, poses, nominal }.in_parts(settings, &parts::here)
}

/// Robots to be drawn about one control model on one machine, and the poses to drive them through.
pub(super) struct Draw<'a> {
    pub(super) control: &'a Control,
    pub(super) machine: &'a Model,
    pub(super) setting: &'a Setting<'a>,
    pub(super) offsets: &'a [f64],
    pub(super) poses: &'a [CommandedPose],
    pub(super) nominal: &'a [PoseSensitivity],
}

impl Draw<'_> {
    /// Draws robots and drives them, sixteen in each part.
    pub(super) fn in_parts(
        &self,
        settings: &Settings<'_>,
        parts: &Parts<'_, DrawnPart>,
    ) -> Result<MonteCarlo, InputError> {
        let Self { control, machine, setting, offsets, poses, nominal } = *self;
        if settings.robots.saturating_mul(poses.len()) > ANSWER_LIMIT {
            return Err(InputError::TooManyRobots { robots: settings.robots, poses: poses.len(), limit: ANSWER_LIMIT });
        }
        let causes = settings.causes;
        let active: Vec<usize> = (0..causes.len()).filter(|&cause| settings.sigmas[cause] > 0.0).collect();
        let own: Vec<ParameterDeviation> = active.iter().map(|&cause| causes[cause]).collect();
        let sigmas: Vec<f64> = active.iter().map(|&cause| settings.sigmas[cause]).collect();
        let deviates = own.iter().any(|cause| cause.side == Side::Control);
        let models = (&control.model, machine);
        let run = Run {
            models,
            tension_method: control.tension_method,
            makers: Makers::new(models.0, models.1, setting, offsets, &own)?,
            poses,
            batch: Batch::new(models.0, models.1, poses, nominal, offsets, deviates),
            nominal,
            active: &active,
            sigmas: &sigmas,
            settings,
        };
        let robots = settings.robots;
        let part = |part: usize| {
            let mut room = (Room::default(), Vec::new());
            let own = part * ROBOTS_OF_PART..robots.min((part + 1) * ROBOTS_OF_PART);
            DrawnPart { robots: own.map(|robot| DrawnRobot::of(run.one(robot, &mut room))).collect() }
        };
        let drawn = parts(robots.div_ceil(ROBOTS_OF_PART), &part);
        let rows: Vec<Row> = drawn.into_iter().flat_map(|part| part.robots).map(DrawnRobot::row).collect();
        Ok(summarize(&rows, poses.len(), settings.engine))
    }
}

impl DrawnRobot {
    fn of((answers, reason): Row) -> Self {
        let there = |number: f64| Some(number).filter(|number| number.is_finite());
        Self { answers: answers.into_iter().map(|answer| answer.map(there)).collect(), reason }
    }

    fn row(self) -> Row {
        let numbers = |answer: [Option<f64>; 3]| answer.map(|number| number.unwrap_or(f64::NAN));
        (self.answers.into_iter().map(numbers).collect(), self.reason)
    }
}

/// Data shared by all robots.
struct Run<'a> {
    models: (&'a Model, &'a Model),
    tension_method: Method,
    makers: Makers<'a>,
    poses: &'a [CommandedPose],
    batch: Option<Batch>,
    nominal: &'a [PoseSensitivity],
    active: &'a [usize],
    sigmas: &'a [f64],
    settings: &'a Settings<'a>,
}

/// The answers of one robot, and the reason for which the first missing one is missing.
type Row = (Vec<Answer>, Option<String>);

impl Run<'_> {
    fn one(&self, robot: usize, (room, deviations): &mut (Room, Vec<f64>)) -> Row {
        draw(self.settings.seed, robot, self.sigmas, self.settings.distribution, deviations);
        if self.settings.engine == Engine::Linear {
            return self.linear(deviations);
        }
        let answers = self.makers.make(deviations).and_then(|made| {
            let batched = match &self.batch {
                Some(batch) => batch.answers(self.models.1, &made, room)?,
                None => None,
            };
            match batched {
                Some(poses) => Ok(self.judged(poses)),
                None => self.one_by_one(&made),
            }
        });
        answers.unwrap_or_else(|reason| (vec![[f64::NAN; 3]; self.poses.len()], Some(reason.to_string())))
    }

    fn judged(&self, poses: Vec<Option<Pose>>) -> Row {
        let mut reason = None;
        let answers = poses.into_iter().enumerate().map(|(place, pose)| match pose {
            Some(pose) => self.answer(place, &pose),
            None => {
                reason.get_or_insert_with(|| {
                    format!("pose {}: the machine's forward problem has no solution", place + 1)
                });
                [f64::NAN; 3]
            }
        });
        (answers.collect(), reason)
    }

    fn one_by_one(&self, made: &Made) -> Result<Row, InputError> {
        let control = made.control.as_ref().unwrap_or(self.models.0);
        let machine = made.machine.as_ref().unwrap_or(self.models.1);
        let control = Control { tension_method: self.tension_method, ..Control::from(control) };
        let operation = Operation::new(control, machine, &made.offsets)?;
        let mut operation = operation.with_history(self.settings.history.as_ref(), &self.makers.setting.pose);
        let mut reason = None;
        let answers = self.poses.iter().enumerate().map(|(place, command)| {
            let outcome = operation.answer(command);
            match outcome.at_rest() {
                Ok(()) => self.answer(place, &outcome.pose),
                Err(why) => {
                    reason.get_or_insert_with(|| format!("pose {}: {why}", place + 1));
                    [f64::NAN; 3]
                }
            }
        });
        Ok((answers.collect(), reason))
    }

    fn answer(&self, place: usize, pose: &Pose) -> Answer {
        let (commanded, nominal) = (&self.poses[place].pose, &self.nominal[place].outcome);
        let deviation = match nominal.status {
            Status::Converged => (pose.position - nominal.pose.position).norm(),
            _ => f64::NAN,
        };
        [(pose.position - commanded.position).norm(), pose.angle_to(commanded), deviation]
    }

    fn linear(&self, deviations: &[f64]) -> Row {
        let basis = self.models.1.twist_basis();
        let at = |place: usize| {
            let Ok(derivatives) = &self.nominal[place].derivatives else { return [f64::NAN; 3] };
            let mut twist = Twist::zeros();
            for (row, direction) in basis.iter().enumerate() {
                let along: f64 =
                    self.active.iter().zip(deviations).map(|(&cause, by)| derivatives.pose[(row, cause)] * by).sum();
                twist += direction * along;
            }
            self.answer(place, &self.nominal[place].outcome.pose.displaced(&twist))
        };
        ((0..self.poses.len()).map(at).collect(), None)
    }
}

fn summarize(rows: &[Row], poses: usize, engine: Engine) -> MonteCarlo {
    let all = |of: usize| rows.iter().flat_map(move |(answers, _)| answers.iter().map(move |answer| answer[of]));
    let at = |of: usize| (0..poses).map(move |place| rows.iter().map(move |(answers, _)| answers[place][of]));
    let of_robot = |of: &dyn Fn(&[f64]) -> f64| {
        let values = |(answers, _): &Row| {
            let errors: Vec<f64> = answers.iter().map(|answer| answer[0]).filter(|error| error.is_finite()).collect();
            of(&errors)
        };
        Quantiles::of(rows.iter().map(values))
    };
    MonteCarlo {
        engine,
        robots: rows.len(),
        unanswered: all(0).filter(|error| error.is_nan()).count(),
        reason: rows
            .iter()
            .enumerate()
            .find_map(|(robot, (_, reason))| reason.as_ref().map(|reason| format!("robot {}: {reason}", robot + 1))),
        error: Quantiles::of(all(0)),
        rotation_error: Quantiles::of(all(1)),
        deviation: Quantiles::of(all(2)),
        mean_of_robot: of_robot(&|errors| errors.iter().sum::<f64>() / errors.len() as f64),
        max_of_robot: of_robot(&|errors| errors.iter().copied().fold(f64::NAN, f64::max)),
        errors: at(0).map(Quantiles::of).collect(),
        deviations: at(2).map(Quantiles::of).collect(),
    }
}

impl Quantiles {
    /// Statistics of all finite values.
    fn of(values: impl Iterator<Item = f64>) -> Self {
        let mut sorted: Vec<f64> = values.filter(|value| value.is_finite()).collect();
        sorted.sort_unstable_by(f64::total_cmp);
        let count = sorted.len() as f64;
        Self {
            mean: sorted.iter().sum::<f64>() / count,
            rms: (sorted.iter().map(|value| value * value).sum::<f64>() / count).sqrt(),
            median: quantile(&sorted, 0.5),
            p95: quantile(&sorted, 0.95),
            p99: quantile(&sorted, 0.99),
            max: sorted.last().copied().unwrap_or(f64::NAN),
        }
    }
}

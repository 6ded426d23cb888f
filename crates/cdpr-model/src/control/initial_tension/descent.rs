//! The search for initial tensions: Gauss–Newton steps in the null space of the structure matrix at the initial pose.

use nalgebra::{Cholesky, DMatrix, DVector};

use super::starts::starts;
use super::{Fit, Optimum, Target, Task, WantedTensions, emerging, offsets_of, wanted};
use crate::control::input_error::InputError;
use crate::geometry::Pose;
use crate::solve::{self, Control, Rules, Step, StepRule, Stop, descend};
use crate::tension::{Limits, null_space, quadratic};

/// Steps allowed; tensions are almost linear in f_ini, so that few are needed.
const STEPS: u32 = 30;
/// Difference of initial tensions for derivatives, as a fraction of the range of the limits.
const DIFFERENCE: f64 = 1e-4;
/// Distance from the optimum, as a fraction of the range, below which the search ends.
const SETTLED: f64 = 1e-7;
/// Distance, as a fraction of the range, below which two ends count as one optimum.
const AGREEING: f64 = 1e-4;
/// Weight of the fit against the length of a step, in squared tensions.
const WEIGHT: f64 = 100.0;
/// Fraction of the largest curvature added to all, so that components that the poses do not determine do not change.
const RIDGE: f64 = 1e-9;

/// The f_ini within the limits with emerging tensions nearest to the target over these poses (eq. 3.42): the best
/// result of several starts.
///
/// Errors are rigid machines, targets that no pose has, and limits that no balanced tensions at the initial pose keep.
pub fn optimum(task: &Task<'_>, target: &Target, poses: &[Pose]) -> Result<Optimum, InputError> {
    let wanted = wanted(task, target, poses)?;
    let ranges = task.limits.minimum().iter().zip(task.limits.maximum()).map(|(least, largest)| largest - least);
    let range = ranges.fold(1.0, f64::max);
    let basis = null_space(&task.machine.structure_matrix(&task.pose)?)?;
    let search = Search { task, poses, wanted: &wanted, basis, range };
    let starts = starts(task, target, range)?;
    let mut ends = Vec::with_capacity(starts.len());
    for start in &starts {
        ends.push(search.descend(start.clone())?);
    }
    let mut best = 0;
    for other in 1..ends.len() {
        if ends[other].trial.is_better_than(&ends[best].trial) {
            best = other;
        }
    }
    let agrees = |end: &&End| {
        let pairs = end.trial.tensions.iter().zip(&ends[best].trial.tensions);
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) <= AGREEING * range
    };
    let agreeing = ends.iter().filter(agrees).count();
    let End { trial, iterations, is_settled } = ends.swap_remove(best);
    let tolerance = 1e-6 * range;
    let is_at = |&cable: &usize| {
        let f = trial.tensions[cable];
        f <= task.limits.minimum()[cable] + tolerance || f >= task.limits.maximum()[cable] - tolerance
    };
    Ok(Optimum {
        at_limits: (0..trial.tensions.len()).filter(is_at).collect(),
        fit: Fit::of(&trial.emerging, &wanted, task.limits),
        offsets: trial.offsets,
        tensions: trial.tensions,
        iterations,
        starts: starts.len(),
        agreeing,
        is_settled,
    })
}

/// End of the steps from one start.
struct End {
    trial: Trial,
    iterations: u32,
    is_settled: bool,
}

struct Search<'a> {
    task: &'a Task<'a>,
    poses: &'a [Pose],
    wanted: &'a [WantedTensions],
    /// H at the initial pose.
    basis: DMatrix<f64>,
    /// The widest range of the limits (N).
    range: f64,
}

/// Initial tensions and the tensions that emerge with them.
struct Trial {
    tensions: Vec<f64>,
    offsets: Vec<f64>,
    emerging: Vec<Option<Vec<f64>>>,
    /// f̂ − f_ref (N); zeros where one of them is unknown.
    residual: DVector<f64>,
    /// Number of poses that count.
    counted: usize,
}

impl Trial {
    /// Mean square over the poses that count (N²).
    fn cost(&self) -> f64 {
        if self.counted == 0 { f64::INFINITY } else { self.residual.norm_squared() / self.counted as f64 }
    }

    /// More poses with an answer are better; at equal numbers the lower cost.
    fn is_better_than(&self, other: &Self) -> bool {
        self.counted > other.counted || (self.counted == other.counted && self.cost() < other.cost())
    }
}

/// Distance from the target, as a problem of the common descent loop.
struct Descent<'a, 's> {
    search: &'a Search<'s>,
    /// `None` before the start was evaluated.
    here: Option<Trial>,
    there: Option<Trial>,
    /// Step in the tensions, within the limits (N).
    way: Vec<f64>,
    refusal: Option<InputError>,
}

impl Descent<'_, '_> {
    fn way(&self, here: &Trial) -> Result<Vec<f64>, InputError> {
        let (step, root) = self.search.step(here, DIFFERENCE * self.search.range)?;
        let goal = self.search.within(&here.tensions, &step, &root)?;
        Ok(goal.iter().zip(&here.tensions).map(|(goal, from)| goal - from).collect())
    }
}

impl solve::Problem for Descent<'_, '_> {
    type Number = f64;

    fn step(&mut self, _: &Control<f64>) -> Step<f64> {
        let way = self.here.as_ref().map_or_else(|| Ok(Vec::new()), |here| self.way(here));
        match way {
            Ok(way) => self.way = way,
            Err(refusal) => self.refusal = Some(refusal),
        }
        let size = self.way.iter().fold(0.0_f64, |most, part| most.max(part.abs()));
        Step::whole(size, self.refusal.is_none())
    }

    fn evaluate(&mut self, fraction: f64, _: bool) -> solve::Trial<f64> {
        let Some(here) = &self.here else { return solve::Trial::new(1.0, true) };
        let tensions = here.tensions.iter().zip(&self.way).map(|(from, part)| from + fraction * part).collect();
        match self.search.at(tensions) {
            Ok(there) => self.there = Some(there),
            Err(refusal) => (self.there, self.refusal) = (None, Some(refusal)),
        }
        let helps = self.there.as_ref().is_some_and(|there| there.is_better_than(here));
        solve::Trial::new(1.0, helps)
    }

    fn accept(&mut self, helps: bool, _: f64) {
        if helps {
            self.here = self.there.take();
        }
    }

    /// Always true: if no fraction of a step helps, the search has converged.
    fn rests(&mut self, _: f64, _: f64) -> bool {
        true
    }
}

impl Search<'_> {
    /// Takes steps from one start until they converge.
    fn descend(&self, start: Vec<f64>) -> Result<End, InputError> {
        let start = self.at(start)?;
        let mut descent = Descent { search: self, here: None, there: Some(start), way: Vec::new(), refusal: None };
        let rules = Rules {
            tolerance: SETTLED * self.range,
            max_iterations: STEPS,
            least_gain: 0.0,
            rule: StepRule::Shortening,
        };
        let end = descend(&mut descent, &rules);
        let is_settled = end.stop() == Stop::Stationary;
        match descent {
            Descent { refusal: Some(refusal), .. } => Err(refusal),
            Descent { here: Some(trial), .. } | Descent { there: Some(trial), .. } => {
                Ok(End { trial, iterations: end.iterations as u32, is_settled })
            }
            Descent { here: None, there: None, .. } => unreachable!("the start is always there"),
        }
    }

    fn at(&self, tensions: Vec<f64>) -> Result<Trial, InputError> {
        let offsets = offsets_of(self.task, &tensions)?;
        let emerging = emerging(self.task, &offsets, self.poses)?;
        let cables = tensions.len();
        let mut residual = DVector::zeros(cables * self.poses.len());
        let mut counted = 0;
        for (pose, (tensions, wanted)) in emerging.iter().zip(self.wanted).enumerate() {
            let (Some(tensions), Ok(wanted)) = (tensions, wanted) else { continue };
            counted += 1;
            for cable in 0..cables {
                residual[pose * cables + cable] = tensions[cable] - wanted[cable];
            }
        }
        Ok(Trial { tensions, offsets, emerging, residual, counted })
    }

    /// The step in λ to the least squares, and the root of their curvature per pose.
    fn step(&self, here: &Trial, difference: f64) -> Result<(DVector<f64>, DMatrix<f64>), InputError> {
        let dimension = self.basis.ncols();
        let mut jacobian = DMatrix::zeros(here.residual.len(), dimension);
        for (column, way) in self.basis.column_iter().enumerate() {
            let tensions = here.tensions.iter().zip(way.iter()).map(|(f, part)| f + difference * part).collect();
            let there = self.at(tensions)?;
            let cables = here.tensions.len();
            for pose in (0..self.poses.len()).filter(|&pose| there.emerging[pose].is_some()) {
                for row in pose * cables..(pose + 1) * cables {
                    jacobian[(row, column)] = (there.residual[row] - here.residual[row]) / difference;
                }
            }
        }
        let per_pose = 1.0 / here.counted.max(1) as f64;
        let mut curvature = jacobian.transpose() * &jacobian * per_pose;
        let ridge = RIDGE * curvature.diagonal().max().max(f64::MIN_POSITIVE);
        for k in 0..dimension {
            curvature[(k, k)] += ridge;
        }
        let slope = jacobian.transpose() * &here.residual * per_pose;
        let root = Cholesky::new(curvature);
        Ok(match root {
            Some(root) => (-root.solve(&slope), root.l().transpose()),
            // a curvature of rounding: no step
            None => (DVector::zeros(dimension), DMatrix::identity(dimension, dimension)),
        })
    }

    /// The tensions f + H λ after a step, or the best within the limits in the metric of the step's root.
    ///
    /// Unknowns are the difference from the step's end in that metric, and the tensions. These have a small weight, the
    /// smaller the larger `WEIGHT` is, which draws them to their previous values; at the end, when steps vanish, it has
    /// no effect.
    fn within(&self, from: &[f64], step: &DVector<f64>, root: &DMatrix<f64>) -> Result<Vec<f64>, InputError> {
        let end = DVector::from_column_slice(from) + &self.basis * step;
        let limits = self.task.limits;
        if limits.contain(end.as_slice(), limits.tolerance()) {
            return Ok(end.as_slice().to_vec());
        }
        let (cables, dimension) = self.basis.shape();
        let inverse = root.clone().try_inverse().unwrap_or_else(|| DMatrix::identity(dimension, dimension));
        let mut matrix = DMatrix::zeros(cables, dimension + cables);
        matrix.columns_mut(0, dimension).copy_from(&(&self.basis * inverse / WEIGHT.sqrt()));
        for cable in 0..cables {
            matrix[(cable, dimension + cable)] = -1.0;
        }
        // far beyond any tensions in the metric
        let far = 1e4 * limits.maximum().iter().fold(1.0, |most: f64, limit| most.max(limit.abs()));
        let joined = |end: f64, limits: &[f64]| [&vec![end; dimension], limits].concat();
        let both = Limits::new(joined(-far, limits.minimum()), joined(far, limits.maximum()))?;
        let reference = joined(0.0, from);
        let found = quadratic::solve(&matrix, end.as_slice(), &both, Some(&reference))?;
        match found.status {
            quadratic::Status::Feasible => Ok(found.tensions[dimension..].to_vec()),
            _ => Err(InputError::NotBalanced {
                reason: "every balanced set of tensions breaks the limits of a cable".to_owned(),
            }),
        }
    }
}

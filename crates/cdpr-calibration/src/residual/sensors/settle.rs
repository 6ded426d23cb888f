//! Search for pose and tensions of one sample at which all its sensors agree best.

use nalgebra::{Cholesky, DMatrix, DVector};

use super::rows::{SampleSensors, SensorRows};
use crate::residual::Latent;
use crate::residual::balance::rows::RowModel;
use cdpr_model::geometry::Twist;

/// Steps at most.
const STEPS: u32 = 100;
/// Steps of Gauss and Newton before second derivatives are worth their evaluations: bends of residuals beside weakly held turns make them slow.
const PLAIN_STEPS: u32 = 8;
/// Share of the last promise from which on plain steps are slow.
const SLOW: f64 = 0.1;
/// Step at which a pose is found, in standard deviations, relative to a larger norm of the residuals.
const FOUND: f64 = 1e-7;
/// Share of the squares that the next step may still promise where a pose is sought no longer.
const NEAR: f64 = 1e-6;
/// Damping of the first step, and the least that is told from none.
const DAMPING: f64 = 1e-3;
const LEAST_DAMPING: f64 = 1e-9;
/// Damping from which on a pose is as good as it gets.
const MOST_DAMPING: f64 = 1e12;
/// Displacement (m, rad) over which gradients are compared: bends of rows are those of lengths of metres.
const DISPLACEMENT: f64 = 1e-6;

/// End of a search.
#[derive(Clone, Debug)]
pub(super) struct Settled {
    pub(super) latent: Latent,
    pub(super) square: f64,
    /// False where the steps ended on the way: the squares are small there, not least.
    pub(super) is_least: bool,
}

impl Settled {
    /// The better of two ends: one that is least before one that is not, then the smaller squares; the first where they are the same.
    pub(super) fn better(self, other: Self) -> Self {
        let is_behind = (self.is_least, -self.square) < (other.is_least, -other.square);
        if is_behind { other } else { self }
    }
}

impl SampleSensors<'_> {
    /// Pose and tensions that make the squares of a sample least, from some near them; `None` if it has no rows.
    pub(super) fn settle(&self, model: &RowModel<'_>, sample: usize, from: &Latent) -> Option<Settled> {
        let mut here = (from.clone(), self.rows(model, sample, from)?);
        let (mut damping, mut gain, mut is_slow) = (DAMPING, f64::INFINITY, false);
        for round in 0..STEPS {
            let square = here.1.residuals.norm_squared();
            let curvature = match round < PLAIN_STEPS && !is_slow {
                true => here.1.by_latent.tr_mul(&here.1.by_latent),
                false => self.curvature(model, sample, (&here.0, &here.1))?,
            };
            let Some((step, promised)) = newton_step(&here.1, curvature, damping) else {
                damping = (10.0 * damping).max(DAMPING);
                continue;
            };
            is_slow |= round > 1 && promised > SLOW * gain;
            gain = promised;
            let trial = self.displaced(sample, &here.0, &step);
            let there = self.rows(model, sample, &trial);
            if gain <= FOUND * FOUND * square.max(1.0) && there.is_some() {
                return Some(Settled { latent: trial, square, is_least: true });
            }
            match there.filter(|rows| rows.residuals.norm_squared() <= square) {
                Some(rows) => {
                    here = (trial, rows);
                    damping = if damping < LEAST_DAMPING { 0.0 } else { 0.1 * damping };
                }
                None => damping = (10.0 * damping).max(DAMPING),
            }
            if damping > MOST_DAMPING {
                break;
            }
        }
        // near enough for parameters that are still far from their optimum
        let square = here.1.residuals.norm_squared();
        Some(Settled { latent: here.0, square, is_least: gain <= NEAR * square.max(1.0) })
    }

    /// Half the second derivative of the squares by what is unknown, from differences of gradients.
    fn curvature(
        &self,
        model: &RowModel<'_>,
        sample: usize,
        (at, rows): (&Latent, &SensorRows),
    ) -> Option<DMatrix<f64>> {
        let count = self.unknowns(sample);
        let gradient = |k: usize, amount: f64| {
            let mut step = DVector::zeros(count);
            step[k] = amount;
            let rows = self.rows(model, sample, &self.displaced(sample, at, &step))?;
            Some(rows.by_latent.tr_mul(&rows.residuals))
        };
        let here = rows.by_latent.tr_mul(&rows.residuals);
        let turns = self.directions[sample].len();
        let mut curvature = DMatrix::zeros(count, count);
        for k in 0..count {
            // a newton moves rows as little as a micrometre does
            let amount = if k < turns { DISPLACEMENT } else { DISPLACEMENT * at.tensions[k - turns].abs().max(1.0) };
            let change = (gradient(k, amount)? - &here) / amount;
            curvature.set_column(k, &change);
        }
        let transposed = curvature.transpose();
        Some((curvature + transposed) * 0.5)
    }

    fn displaced(&self, sample: usize, from: &Latent, step: &DVector<f64>) -> Latent {
        let directions = &self.directions[sample];
        let twist: Twist = directions.iter().zip(step.iter()).map(|(twist, amount)| twist * *amount).sum();
        let mut tensions = from.tensions.clone();
        tensions.iter_mut().zip(step.iter().skip(directions.len())).for_each(|(tension, change)| *tension += change);
        Latent { pose: from.pose.displaced(&twist), tensions }
    }
}

/// A damped step with columns of unit size, and the squares that it promises to gain; `None` if the curvature goes down somewhere.
fn newton_step(rows: &SensorRows, mut curvature: DMatrix<f64>, damping: f64) -> Option<(DVector<f64>, f64)> {
    let size = |column: usize| rows.by_latent.column(column).norm().max(f64::MIN_POSITIVE).recip();
    let scale: Vec<f64> = (0..rows.by_latent.ncols()).map(size).collect();
    let pull = -rows.by_latent.tr_mul(&rows.residuals);
    for (column, of_column) in scale.iter().enumerate() {
        for (row, of_row) in scale.iter().enumerate() {
            curvature[(row, column)] *= of_row * of_column;
        }
        // a direction that no sensor sees stays where it is
        curvature[(column, column)] += damping.max(UNSEEN);
    }
    let scaled = DVector::from_fn(scale.len(), |k, _| scale[k] * pull[k]);
    let solution = Cholesky::new(curvature)?.solve(&scaled);
    let gain = scaled.dot(&solution);
    Some((DVector::from_fn(scale.len(), |k, _| scale[k] * solution[k]), gain))
}

/// Damping that keeps singular curvatures regular, far below what steps notice.
const UNSEEN: f64 = 1e-13;

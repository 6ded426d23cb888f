//! Information JᵀΣ⁻¹J of every candidate, in blocks of parameters that no row ties together.

use std::ops::Range;

use nalgebra::{DMatrix, DVector};

use super::criterion::{DesignCriterion, inverse, log_det};
use super::plan_error::PlanError;
use crate::fit::{InputError, RowWeights, Settings};
use crate::identifiability::{prior_weights, rank_and_condition, singular_values};
use crate::problem::Problem;
use crate::residual::Given;
use crate::residual::entries::{RowNoise, length_rows};
use crate::unit_scale::joint_scales;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;
use cdpr_model::scalar::TriangularFactor;

/// Share of the mean information by which directions that nothing tells of are held while designs are compared.
const HELD: f64 = 1e-10;

/// Rows of poses by the parameters of one block, pose by pose.
type PoseRows = Vec<DMatrix<f64>>;

/// Information of candidates and of what is known already.
pub(super) struct Information {
    blocks: Vec<Block>,
    candidates: usize,
}

/// Parameters that rows tie together.
struct Block {
    /// Whitened rows of every candidate.
    rows: PoseRows,
    /// JᵀΣ⁻¹J of every candidate.
    own: Vec<DMatrix<f64>>,
    /// Whitened rows of the poses measured already.
    given: PoseRows,
    /// 1/σ of priors, 0 without one.
    priors: Vec<f64>,
    /// Information of these poses and of priors.
    base: DMatrix<f64>,
    /// Mean of uᵀu over candidates and cables, u the derivatives of a length.
    region: DMatrix<f64>,
    /// Metres that a unit of each parameter is worth.
    scales: Vec<f64>,
    /// Diagonal that is added while designs are compared.
    held: DVector<f64>,
}

/// Numbers of a design.
pub(super) struct Summary {
    pub(super) rank: usize,
    pub(super) log_det: Option<f64>,
    pub(super) condition: f64,
    pub(super) sigma_min: f64,
    pub(super) trace_inverse: Option<f64>,
    pub(super) i_value: Option<f64>,
}

impl Information {
    /// Of candidates and poses measured already, with these priors.
    pub(super) fn of(
        model: &Model,
        samples: &Samples,
        given: Option<&Samples>,
        parameters: &[Parameter],
        settings: &Settings,
    ) -> Result<Self, PlanError> {
        let is_stated = samples.sigmas != Default::default();
        let (rows, blocks) = stacked(model, samples, parameters, is_stated)?;
        let (lengths, _) = stacked(model, samples, parameters, false)?;
        let places: Vec<Vec<usize>> =
            blocks.into_iter().map(Iterator::collect).filter(|places: &Vec<usize>| !places.is_empty()).collect();
        let given_rows = given.map(|given| {
            let has_own = samples.sigmas != Default::default() && given.sigmas != Default::default();
            let sigmas = if has_own { given.sigmas } else { samples.sigmas };
            let is_stated = sigmas != Default::default();
            Ok::<_, PlanError>(stacked(model, &Samples { sigmas, ..given.clone() }, parameters, is_stated)?.0)
        });
        let given_rows = given_rows.transpose()?;
        let priors = prior_weights(parameters, settings);
        let mean_length = vec![samples.lengths.iter().sum::<f64>() / samples.lengths.len().max(1) as f64];
        let scales = joint_scales(model, parameters, &mean_length, samples.tensions.as_deref().unwrap_or(&[]));
        let columns = |matrices: &[DMatrix<f64>], places: &[usize]| -> PoseRows {
            matrices.iter().map(|matrix| without_zero_rows(matrix.select_columns(places))).collect()
        };
        // lengths stand last among the rows of a pose
        let before = lengths.first().map_or(0, |rows| rows.nrows() - model.cable_count());
        let block = |places: &Vec<usize>| {
            let rows = columns(&rows, places);
            let own: Vec<DMatrix<f64>> = rows.iter().map(|rows| rows.tr_mul(rows)).collect();
            let given = given_rows.as_deref().map(|given| columns(given, places)).unwrap_or_default();
            let mut base =
                DMatrix::from_diagonal(&DVector::from_iterator(places.len(), places.iter().map(|&k| priors[k])));
            given.iter().for_each(|rows| base += rows.tr_mul(rows));
            let mut region = DMatrix::zeros(places.len(), places.len());
            for matrix in &lengths {
                let of_lengths = matrix.rows(before, model.cable_count()).select_columns(places);
                region += of_lengths.tr_mul(&of_lengths);
            }
            region /= (lengths.len() * model.cable_count()) as f64;
            let mean: DMatrix<f64> = own.iter().sum::<DMatrix<f64>>() / own.len() as f64;
            let largest = mean.diagonal().max();
            let scales: Vec<f64> = places.iter().map(|&k| scales[k]).collect();
            let held = mean.diagonal().map(|entry| HELD * if entry > 0.0 { entry } else { largest });
            Block {
                rows,
                own,
                given,
                priors: places.iter().map(|&k| priors[k].sqrt()).collect(),
                base,
                region,
                scales,
                held,
            }
        };
        Ok(Self { blocks: places.iter().map(block).collect(), candidates: samples.len() })
    }

    pub(super) fn candidates(&self) -> usize {
        self.candidates
    }

    /// Number of parameters.
    pub(super) fn parameter_count(&self) -> usize {
        self.blocks.iter().map(|block| block.scales.len()).sum()
    }

    /// Steps that the score of one set takes, to within a factor.
    pub(super) fn effort(&self) -> f64 {
        self.blocks.iter().map(|block| (block.scales.len() as f64).powi(3) + 500.0).sum()
    }

    /// M of what is known already, regular.
    pub(super) fn nothing(&self) -> Vec<DMatrix<f64>> {
        self.blocks.iter().map(|block| &block.base + DMatrix::from_diagonal(&block.held)).collect()
    }

    /// M of a set, regular.
    pub(super) fn regular(&self, chosen: &[usize]) -> Vec<DMatrix<f64>> {
        let mut sum = self.nothing();
        chosen.iter().for_each(|&candidate| self.add(&mut sum, candidate));
        sum
    }

    /// Adds a candidate to M.
    pub(super) fn add(&self, sum: &mut [DMatrix<f64>], candidate: usize) {
        sum.iter_mut().zip(&self.blocks).for_each(|(sum, block)| *sum += &block.own[candidate]);
    }

    /// Takes a candidate from M.
    pub(super) fn take(&self, sum: &mut [DMatrix<f64>], candidate: usize) {
        sum.iter_mut().zip(&self.blocks).for_each(|(sum, block)| *sum -= &block.own[candidate]);
    }

    /// Score of M; smaller is better.
    pub(super) fn score(&self, criterion: DesignCriterion, sum: &[DMatrix<f64>]) -> f64 {
        let blocks = self.blocks.iter().zip(sum);
        criterion.joined(blocks.map(|(block, sum)| criterion.of_block(sum, &block.region, &block.scales)))
    }

    /// Score of M with one more candidate, in scratch memory of its size.
    pub(super) fn score_with(
        &self,
        criterion: DesignCriterion,
        sum: &[DMatrix<f64>],
        scratch: &mut [DMatrix<f64>],
        candidate: usize,
    ) -> f64 {
        scratch.iter_mut().zip(sum).for_each(|(own, sum)| own.copy_from(sum));
        self.add(scratch, candidate);
        self.score(criterion, scratch)
    }

    /// Numbers of a set, with what is known already.
    pub(super) fn summary(&self, chosen: &[usize]) -> Summary {
        let (mut values, mut rows) = (Vec::new(), 0);
        let (mut log_dets, mut traces, mut variances) = (Some(0.0), Some(0.0), Some(0.0));
        for block in &self.blocks {
            let mut factor = TriangularFactor::new(block.scales.len());
            for matrix in chosen.iter().map(|&candidate| &block.rows[candidate]).chain(&block.given) {
                matrix.row_iter().for_each(|row| factor.push(row.iter().copied()));
                rows += matrix.nrows();
            }
            let of_rows = factor.into_matrix();
            let mut with_priors = TriangularFactor::of(&of_rows);
            with_priors.push_diagonal(block.priors.iter().copied());
            let own_values = singular_values(of_rows);
            let mut sum = block.base.clone();
            chosen.iter().for_each(|&candidate| sum += &block.own[candidate]);
            // below full rank the Cholesky factor of rounding would be one of numbers that mean nothing
            let is_known = rank_and_condition(&singular_values(with_priors.into_matrix()), rows).1.is_finite();
            let add = |total: Option<f64>, own: Option<f64>| Some(total? + own.filter(|_| is_known)?);
            log_dets = add(log_dets, log_det(&sum));
            let inverse = inverse(&sum);
            traces = add(traces, inverse.as_ref().map(DMatrix::trace));
            variances = add(variances, inverse.map(|inverse| inverse.component_mul(&block.region).sum()));
            values.extend(own_values);
        }
        let (rank, condition) = rank_and_condition(&values, rows);
        let smallest = values.iter().copied().fold(f64::INFINITY, f64::min);
        Summary {
            rank,
            log_det: log_dets,
            condition,
            sigma_min: if condition.is_finite() { smallest } else { 0.0 },
            trace_inverse: traces,
            i_value: variances,
        }
    }
}

/// Rows of every sample by all parameters, whitened by stated accuracies or as they are, of elastic models wrenches first; and the parameters'
/// places in blocks that no row ties together.
fn stacked(
    model: &Model,
    samples: &Samples,
    parameters: &[Parameter],
    is_whitened: bool,
) -> Result<(PoseRows, Vec<Range<usize>>), PlanError> {
    let settings = Settings::default();
    let given = Given { model, samples, parameters, settings: &settings };
    let noise = if is_whitened { RowNoise::Stated } else { RowNoise::Even(RowWeights::default()) };
    let mut problem = Problem::of(length_rows(&given, noise)?, samples, parameters, &settings)?;
    let blocks = problem.residual.blocks(parameters.len());
    let rows = problem.rows()?;
    let of_sample = |sample: usize| rows.jacobian.rows(sample * rows.size(), rows.size()).into_owned();
    Ok((finite((0..samples.len()).map(of_sample).collect())?, blocks))
}

fn finite(rows: Vec<DMatrix<f64>>) -> Result<Vec<DMatrix<f64>>, PlanError> {
    match rows.iter().all(|matrix| matrix.iter().all(|entry| entry.is_finite())) {
        true => Ok(rows),
        false => Err(InputError::NotFinite.into()),
    }
}

/// Rows that say something of the parameters.
fn without_zero_rows(matrix: DMatrix<f64>) -> DMatrix<f64> {
    let kept: Vec<usize> =
        (0..matrix.nrows()).filter(|&row| matrix.row(row).iter().any(|entry| *entry != 0.0)).collect();
    matrix.select_rows(&kept)
}

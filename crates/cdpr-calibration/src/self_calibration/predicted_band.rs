//! Bands of the poses that a robot calibrated without measured poses predicts: what noise leaves of its parameters, and what held numbers are off by.

use nalgebra::{Cholesky, DMatrix, DVector, DVectorView, Dyn, Vector3};

use super::gauge::{Gauge, rigid_motions};
use super::held::Held;
use super::internal::InternalResidual;
use super::question::Question;
use crate::fit::prior_sigma;
use crate::residual::rows::Rows;
use crate::residual::{Poseless, Residual};
use crate::unit_scale::joint_scales;
use cdpr_model::control::error_statistics::diagonal;
use cdpr_model::finding::Finding;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;
use cdpr_model::scalar::decomposition::svd;

/// Bands of predicted positions over the sampled poses, as root mean squares, after the motions of everything together that data leave free.
#[derive(Clone, Debug, PartialEq)]
pub struct PredictedBand {
    /// By the covariance of the free parameters (m).
    pub by_parameters_m: f64,
    /// By held numbers within their accuracies (m).
    pub by_held_m: f64,
    /// Both (m).
    pub band_m: f64,
    /// The largest of both at a sampled pose (m).
    pub largest_m: f64,
    /// Diagonal of the box of the sampled positions (m).
    pub diagonal_m: f64,
    /// Held numbers that data cannot see, and the distance to measure.
    pub findings: Vec<Finding>,
}

impl PredictedBand {
    /// Share of the sampled region that the band is.
    pub fn share(&self) -> f64 {
        self.band_m / self.diagonal_m
    }
}

/// Displacement that finite differences are made of (m).
const STEP: f64 = 1e-5;
/// Standard deviation of a parameter that neither data nor an accuracy determine (m).
const UNTOLD: f64 = 10.0;
/// Cosine of motions that are the same.
const SAME: f64 = 1.0 - 1e-4;
/// Singular value, beside the largest, of motions that depend on others.
const DEPENDENT: f64 = 1e-6;

/// An optimum with what is known of it.
pub(super) struct At<'a, 'q> {
    pub(super) question: &'a Question<'q>,
    pub(super) model: &'a Model,
    /// The parameters that were searched.
    pub(super) kept: &'a [Parameter],
    pub(super) gauge: &'a Gauge,
    pub(super) poses: &'a [Pose],
    /// Factor of the deviations that the rows' weights give.
    pub(super) inflation: f64,
}

/// Information on free parameters and held numbers, and what they do to poses. Held numbers are in their deviations, parameters in metres or the deviations of their
/// priors.
pub(super) struct Information {
    pub(super) held: Vec<Held>,
    /// Number of free parameters; behind them stand the held numbers, kind by kind.
    pub(super) free: usize,
    /// Parameters with their changes by a unit of each column.
    pub(super) columns: Vec<Vec<(Parameter, f64)>>,
    /// Sum of the squares, with those of priors.
    pub(super) matrix: DMatrix<f64>,
    /// Covariance.
    pub(super) covariance: DMatrix<f64>,
    /// Mean of what is known after the data; zero where residuals say nothing of held numbers.
    pub(super) mean: DVector<f64>,
    /// Change of the positions, sample by sample, by each column.
    pub(super) displacements: DMatrix<f64>,
    /// The same without the motions that data leave free.
    pub(super) fields: DMatrix<f64>,
    pub(super) rows: usize,
}

impl At<'_, '_> {
    /// Information at the optimum; `None` if poses do not follow the parameters.
    pub(super) fn information(&self) -> Option<Information> {
        let held = Held::of(self.question, self.model, self.kept);
        let numbers = held.iter().flat_map(|held| held.numbers.iter().map(|number| (number.clone(), held.sigma)));
        let mut parameters: Vec<Parameter> = self.question.parameters.clone();
        parameters.extend(held.iter().flat_map(|held| held.numbers.iter().flatten().map(|(parameter, _)| *parameter)));
        // rows stand by cables, behind them load and recording
        parameters.sort_unstable_by_key(|parameter| (!parameter.kind.is_of_cable(), *parameter));
        parameters.dedup();
        let lengths = &self.question.internal.samples.lengths;
        let metres = joint_scales(self.model, &parameters, lengths, self.question.tensions());
        let place = |parameter: &Parameter| parameters.iter().position(|other| other == parameter);
        let settings = self.question.settings;
        let of_free = |parameter: &Parameter| {
            let unit = match prior_sigma(settings, parameter.kind).filter(|sigma| *sigma > 0.0) {
                Some(sigma) => (sigma, 1.0),
                None => (place(parameter).map_or(1.0, |place| metres[place]).recip(), UNTOLD.recip()),
            };
            (vec![(*parameter, unit.0)], unit.1)
        };
        let mut columns: Vec<(Vec<(Parameter, f64)>, f64)> = self.kept.iter().map(of_free).collect();
        let scaled = |(number, sigma): (Vec<(Parameter, f64)>, f64)| {
            (number.into_iter().map(|(parameter, change)| (parameter, sigma * change)).collect(), 1.0)
        };
        columns.extend(numbers.map(scaled));
        let priors = columns.iter().map(|(_, weight)| weight * weight);
        let priors = DMatrix::from_diagonal(&DVector::from_iterator(columns.len(), priors));
        let columns: Vec<Vec<(Parameter, f64)>> = columns.into_iter().map(|(column, _)| column).collect();
        let combined = combinations(&columns, &parameters)?;

        let mut probe = Probe::of(self, &parameters)?;
        let jacobian = &probe.rows.jacobian * &combined / self.inflation;
        let mut gradient = jacobian.tr_mul(&(&probe.rows.residuals / self.inflation));
        // at an optimum the rows balance the priors
        gradient.rows_mut(0, self.kept.len()).fill(0.0);
        let matrix = jacobian.tr_mul(&jacobian) + priors;
        let covariance = Cholesky::new(matrix.clone())?.inverse();
        let displacements = probe.displacements(&combined, &metres)?;
        let motions = self.free_motions(&mut probe, &metres)?;
        let fields = &displacements - &motions * motions.tr_mul(&displacements);
        Some(Information {
            held,
            free: self.kept.len(),
            columns,
            mean: -&covariance * gradient,
            covariance,
            matrix,
            displacements,
            fields,
            rows: jacobian.nrows(),
        })
    }

    /// Motions of all positions together that the data leave free, at right angles.
    fn free_motions(&self, probe: &mut Probe<'_>, metres: &[f64]) -> Option<DMatrix<f64>> {
        let none = DMatrix::zeros(3 * self.poses.len(), 0);
        let moves = &self.gauge.moves;
        if moves.ncols() == 0 {
            return Some(none);
        }
        let of_column = |column: DVectorView<'_, f64>| {
            let changes = self.question.parameters.iter().copied().zip(column.iter().copied());
            changes.collect::<Vec<_>>()
        };
        let columns: Vec<Vec<(Parameter, f64)>> = moves.column_iter().map(of_column).collect();
        let open = probe.displacements(&combinations(&columns, probe.parameters)?, metres)?;
        let rigid: Vec<DVector<f64>> = rigid_motions(self.model)
            .iter()
            .map(|(shift, turn)| stacked(self.poses.iter().map(|pose| shift + turn.cross(&pose.position))))
            .collect();
        let (open, rigid) = (orthonormal(open), orthonormal(DMatrix::from_columns(&rigid)));
        let Some(found) = svd(open.tr_mul(&rigid), false, true) else { return Some(none) };
        let shared: Vec<usize> =
            (0..found.singular_values.len()).filter(|k| found.singular_values[*k] > SAME).collect();
        let right = found.v_t?.transpose();
        Some(rigid * DMatrix::from_fn(right.nrows(), shared.len(), |row, column| right[(row, shared[column])]))
    }
}

/// Rows and poses near an optimum.
struct Probe<'a> {
    residual: InternalResidual<'a>,
    parameters: &'a [Parameter],
    values: Vec<f64>,
    poses: Vec<Pose>,
    rows: Rows,
}

impl<'a> Probe<'a> {
    fn of(at: &At<'a, '_>, parameters: &'a [Parameter]) -> Option<Self> {
        let question = at.question;
        let mut residual = question.sensing.residual(at.model, &question.internal, parameters, &question.equations);
        residual.begin_at(at.poses);
        let values: Vec<f64> = parameters.iter().map(|parameter| parameter.value(at.model.robot())).collect();
        let mut rows = Rows::new(residual.layout(), parameters.len());
        residual.write(&values, &mut rows).then_some(())?;
        Some(Self { poses: residual.poses(), residual, parameters, values, rows })
    }

    /// Changes of the positions by unit steps along combinations of the parameters, by central differences.
    fn displacements(&mut self, combined: &DMatrix<f64>, metres: &[f64]) -> Option<DMatrix<f64>> {
        let mut all = DMatrix::zeros(3 * self.poses.len(), combined.ncols());
        let mut rows = self.rows.clone();
        for (mut target, direction) in all.column_iter_mut().zip(combined.column_iter()) {
            let length =
                direction.iter().zip(metres).map(|(change, metres)| (change * metres).abs()).fold(0.0, f64::max);
            if !(length > 0.0) {
                continue;
            }
            let step = STEP / length;
            let mut at = |step: f64| {
                let moved: Vec<f64> =
                    self.values.iter().zip(&direction).map(|(value, change)| value + step * change).collect();
                self.residual.begin_at(&self.poses);
                self.residual.write(&moved, &mut rows).then(|| self.residual.poses())
            };
            let (ahead, behind) = (at(step), at(-step));
            let size = [&ahead, &behind].into_iter().flatten().count() as f64 * step;
            // a number at the end of its range moves to one side
            let ahead = positions(ahead.as_ref().unwrap_or(&self.poses));
            let behind = positions(behind.as_ref().unwrap_or(&self.poses));
            (size > 0.0).then(|| target.copy_from(&((ahead - behind) / size)))?;
        }
        Some(all)
    }
}

/// Columns of combinations over parameters; `None` if one is missing.
fn combinations(columns: &[Vec<(Parameter, f64)>], parameters: &[Parameter]) -> Option<DMatrix<f64>> {
    let mut combined = DMatrix::zeros(parameters.len(), columns.len());
    for (k, column) in columns.iter().enumerate() {
        for (parameter, change) in column {
            combined[(parameters.iter().position(|other| other == parameter)?, k)] = *change;
        }
    }
    Some(combined)
}

fn stacked(vectors: impl Iterator<Item = Vector3<f64>>) -> DVector<f64> {
    DVector::from_vec(vectors.flat_map(|vector| [vector.x, vector.y, vector.z]).collect())
}

fn positions(poses: &[Pose]) -> DVector<f64> {
    stacked(poses.iter().map(|pose| pose.position))
}

/// Directions at right angles that columns span.
fn orthonormal(columns: DMatrix<f64>) -> DMatrix<f64> {
    let rows = columns.nrows();
    let Some(found) = svd(columns, true, false) else { return DMatrix::zeros(rows, 0) };
    let largest = found.singular_values.amax();
    let places: Vec<usize> =
        (0..found.singular_values.len()).filter(|k| found.singular_values[*k] > DEPENDENT * largest).collect();
    let Some(left) = found.u else { return DMatrix::zeros(rows, 0) };
    DMatrix::from_fn(rows, places.len(), |row, column| left[(row, places[column])])
}

impl Information {
    /// Number of sampled poses.
    pub(super) fn samples(&self) -> usize {
        self.fields.nrows() / 3
    }

    /// Bands without findings; `None` if they are no numbers.
    pub(super) fn band(&self, poses: &[Pose]) -> Option<PredictedBand> {
        let count = self.samples() as f64;
        let shift = &self.fields * &self.mean;
        let spread = &self.fields * &self.covariance;
        let square = |row: usize| spread.row(row).dot(&self.fields.row(row)) + shift[row].powi(2);
        let squares: Vec<f64> =
            (0..self.samples()).map(|sample| (3 * sample..3 * sample + 3).map(square).sum()).collect();
        let of_free = self.fields.columns(0, self.free);
        let by_parameters = (of_free * self.of_free()?.inverse()).component_mul(&of_free).sum().max(0.0) / count;
        let band = squares.iter().sum::<f64>() / count;
        let largest_m = squares.iter().copied().fold(0.0, f64::max).sqrt();
        let diagonal_m = diagonal(|| poses.iter().map(|pose| pose.position));
        (band.is_finite() && diagonal_m > 0.0).then(|| PredictedBand {
            by_parameters_m: by_parameters.sqrt(),
            by_held_m: (band - by_parameters).max(0.0).sqrt(),
            band_m: band.sqrt(),
            largest_m,
            diagonal_m,
            findings: Vec::new(),
        })
    }

    /// Information on the free parameters where held numbers are right.
    pub(super) fn of_free(&self) -> Option<Cholesky<f64, Dyn>> {
        Cholesky::new(self.matrix.view((0, 0), (self.free, self.free)).into_owned())
    }
}

//! Identifiability of parameters from data: rank, condition, standard deviations, weak directions, correlations.

use std::ops::Range;

use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

use super::correlated_rows;
use super::fit::{Settings, prior_sigma};
use super::minimize::unknowns::Unknowns;
use super::noise::Noise;
use super::norms::Norms;
use super::residual::rows::GroupRows;
use super::words::{Direction, describe};
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::{Parameter, ParameterKind};
use cdpr_model::scalar::TriangularFactor;
use cdpr_model::scalar::decomposition::svd;

/// Two parameters that the data hardly separate.
#[derive(Clone, Debug, PartialEq)]
pub struct Correlation {
    /// Name of the one.
    pub first: String,
    /// Name of the other.
    pub second: String,
    /// Correlation coefficient of their errors.
    pub coefficient: f64,
}

/// Identifiability of a fit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Analysis {
    /// Rank of the Jacobian of all residuals by all free parameters.
    pub rank: usize,
    /// Its singular values in SI units, from large to small (eq. 4.23).
    pub singular_values: Vec<f64>,
    /// Ratio of the largest to the smallest singular value; infinite below full rank.
    pub condition: f64,
    /// The same with columns scaled to length one.
    pub condition_scaled: f64,
    /// Directions in parameter space that the data leave open or nearly so, in words.
    pub weak_directions: Vec<String>,
    /// Number of those directions; sentences tell several at once.
    pub weak_direction_count: usize,
    /// Largest standard deviation along any of them (m, scales times the mean length and the like); infinite where one is not
    /// determined at all, 0 without any.
    pub weak_deviation: f64,
    /// Cables whose stiffness the data leave open, in words.
    pub unknown_stiffness: Option<String>,
    /// Pairs of parameters with a correlation above 0.95.
    pub correlations: Vec<Correlation>,
    /// Correlation coefficients of all pairs: row i holds those of parameter i with the parameters 0 to i. NaN where one of the
    /// two is not determined, 0 between cables that are identified apart.
    pub correlation_rows: Vec<Vec<f64>>,
    /// Directions that neither data nor priors determine.
    pub(super) undetermined: usize,
    /// Standard deviation per free parameter.
    pub(super) sigmas: Vec<Option<f64>>,
    /// Half width of a 95 % interval of a parameter, in standard deviations: 1.96, or Student's t where residuals tell the noise.
    pub quantile_95: f64,
    /// Factor of the deviations that the rows' weights give.
    pub(super) inflation: f64,
    /// Longest correlation time of residuals over consecutive samples; 1 where these are independent.
    pub(super) correlation_time: f64,
    /// Warning about residuals that repeat each other; `None` where they are independent.
    pub(super) repeated_rows: Option<String>,
}

impl Analysis {
    /// Writes the directions with their number and the largest deviation.
    pub(super) fn set_weak_directions(&mut self, model: &Model, directions: Vec<Direction>) {
        self.weak_direction_count = directions.len();
        self.weak_deviation = directions.iter().map(Direction::deviation).fold(0.0, f64::max);
        self.weak_directions = describe(model, directions);
    }

    /// Writes all coefficients (row i: with the parameters 0 to i) and the pairs above the limit.
    pub(super) fn set_correlations(&mut self, rows: Vec<Vec<f64>>, name: &dyn Fn(usize) -> String) {
        let pairs =
            rows.iter().enumerate().flat_map(|(i, row)| row[..i].iter().enumerate().map(move |(j, c)| (i, j, *c)));
        let strong = pairs.filter(|(_, _, coefficient)| coefficient.abs() > CORRELATION_LIMIT);
        let named = |(i, j, coefficient)| Correlation { first: name(j), second: name(i), coefficient };
        self.correlations = strong.map(named).collect();
        self.correlation_rows = rows;
    }
}

/// Correlations above this are reported.
const CORRELATION_LIMIT: f64 = 0.95;

/// Singular values with their right singular vectors.
pub(super) struct Spectrum {
    pub(super) values: Vec<f64>,
    vectors: DMatrix<f64>,
}

/// Analyses blocks of parameters at their optimum. Where a block's rows depend on their neighbours, its deviations are those of correlated noise.
pub(super) fn analyse(
    model: &Model,
    samples: &Samples,
    unknowns: &Unknowns<'_>,
    groups: &[GroupRows],
    norms: &Norms,
    noise: &Noise,
) -> Analysis {
    let mut analysis = Analysis::default();
    let (mut plain_values, mut scaled_values) = (Vec::new(), Vec::new());
    let (mut directions, mut rows, mut longest_time) = (Vec::new(), Vec::new(), 1.0_f64);
    let settings = unknowns.settings;
    let rotation = mean_rotation(samples);
    for group in groups.iter().filter(|group| !group.parameters.is_empty()) {
        let parameters = &unknowns.parameters[group.parameters.clone()];
        let plain = group.plain.clone().into_matrix();
        let told = parameters.len().saturating_sub(group.conventions);
        plain_values.extend(singular_values(plain.clone()).into_iter().take(told));
        scaled_values.extend(singular_values(with_unit_columns(plain)).into_iter().take(told));

        let times = correlated_rows::times(group, norms);
        let time = correlated_rows::typical(&times);
        longest_time = longest_time.max(time);
        let priors = prior_weights(parameters, settings);
        let mut weighted = group.weighted.clone();
        weighted.push_diagonal(priors.iter().map(|weight| weight.sqrt()));
        let correlated = (time > 1.0).then(|| correlated_rows::information(group, &times));
        let uncertainty = Uncertainty::new(&spectrum(weighted), noise.inflation, &priors, correlated.as_ref());
        analysis.undetermined += uncertainty.undetermined;
        rows.extend(uncertainty.correlation_rows(rows.len()));
        let named = Named {
            parameters,
            axes: model.axes(),
            cables: group.cables.clone(),
            scale: DVector::from_column_slice(&unknowns.scale[group.parameters.clone()]),
        };
        directions.extend(uncertainty.weak_directions(&named, &rotation, settings.weak_direction_limit));
        analysis.sigmas.extend(uncertainty.sigmas);
    }
    analysis.set_correlations(rows, &|k| unknowns.parameters[k].name(model.robot()));
    analysis.inflation = noise.inflation * longest_time.sqrt();
    analysis.quantile_95 = noise.quantile(longest_time);
    let count = groups.iter().map(|group| group.count).max().unwrap_or(0);
    (_, analysis.condition) = rank_and_condition(&plain_values, count);
    // compliances in 1/N beside anchors in m are twelve decades apart whatever the data tell: columns of length one tell the rank
    (analysis.rank, analysis.condition_scaled) = rank_and_condition(&scaled_values, count);
    plain_values.sort_by(|a, b| b.total_cmp(a));
    analysis.singular_values = plain_values;
    analysis.set_weak_directions(model, directions);
    analysis.correlation_time = longest_time;
    analysis.repeated_rows =
        (longest_time > 1.0).then(|| correlated_rows::words(longest_time, samples.len(), groups.len() > 1));
    analysis
}

/// Singular values with right singular vectors of rows with this triangular factor.
pub(super) fn spectrum(factor: TriangularFactor) -> Spectrum {
    let factor = factor.into_matrix();
    let columns = factor.ncols();
    let Some(decomposition) = svd(factor, false, true) else {
        // nothing is known of any direction
        return Spectrum { values: vec![0.0; columns], vectors: DMatrix::identity(columns, columns) };
    };
    let vectors = decomposition.v_t.map(|v_t| v_t.transpose()).unwrap_or_else(|| DMatrix::identity(columns, columns));
    Spectrum { values: decomposition.singular_values.iter().copied().collect(), vectors }
}

/// Singular values of a matrix with no fewer rows than columns, from large to small; zeros where a number is not finite.
pub(super) fn singular_values(matrix: DMatrix<f64>) -> Vec<f64> {
    let columns = matrix.ncols();
    svd(matrix, false, false).map_or_else(|| vec![0.0; columns], |found| found.singular_values.as_slice().to_vec())
}

pub(super) fn with_unit_columns(mut matrix: DMatrix<f64>) -> DMatrix<f64> {
    for mut column in matrix.column_iter_mut() {
        let norm = column.norm();
        if norm > 0.0 {
            column /= norm;
        }
    }
    matrix
}

/// 1/σ² of each parameter's prior, 0 without one.
pub(super) fn prior_weights(parameters: &[Parameter], settings: &Settings) -> Vec<f64> {
    let weight =
        |parameter: &Parameter| prior_sigma(settings, parameter.kind).map_or(0.0, |sigma| 1.0 / (sigma * sigma));
    parameters.iter().map(weight).collect()
}

/// Relative size below which a singular value is rounding.
fn rank_tolerance(rows: usize) -> f64 {
    10.0 * rows as f64 * f64::EPSILON
}

pub(super) fn rank_and_condition(values: &[f64], rows: usize) -> (usize, f64) {
    let largest = values.iter().copied().fold(0.0, f64::max);
    let smallest = values.iter().copied().fold(f64::INFINITY, f64::min);
    let rank = values.iter().filter(|&&value| value > rank_tolerance(rows) * largest).count();
    let condition = if rank == values.len() { largest / smallest } else { f64::INFINITY };
    (rank, if values.is_empty() { 1.0 } else { condition })
}

pub(super) fn mean_rotation(samples: &Samples) -> Matrix3<f64> {
    let sum: Matrix3<f64> = samples.poses.iter().map(|pose| pose.rotation_matrix()).sum();
    sum / samples.len() as f64
}

/// Posterior of parameters that are judged together.
pub(super) struct Uncertainty {
    /// Covariance in the determined directions.
    covariance: DMatrix<f64>,
    pub(super) sigmas: Vec<Option<f64>>,
    pub(super) undetermined: usize,
    /// Standard deviation along each singular vector; infinite where undetermined.
    deviations: Vec<f64>,
    vectors: DMatrix<f64>,
}

impl Uncertainty {
    /// Posterior of rows whose noise is `factor` times what their weights say, and of priors with these weights (1/σ², 0
    /// without one).
    ///
    /// The estimate is that of the weights as they are, P Jᵀ W r with P = (JᵀWJ + Λ)⁻¹, so its covariance is
    /// P (g JᵀWJ + Λ) P = g P − (g − 1) P Λ P, g the square of the factor: what a prior tells does not become less certain
    /// because the data do.
    ///
    /// Rows that depend on their neighbours have Jᵀ W C W J in place of JᵀWJ in the middle, C their correlation: `correlated`.
    pub(super) fn new(
        posterior: &Spectrum,
        factor: f64,
        prior_weights: &[f64],
        correlated: Option<&DMatrix<f64>>,
    ) -> Self {
        let count = posterior.values.len();
        let largest = posterior.values.iter().copied().fold(0.0, f64::max);
        let determined = |value: f64| value > rank_tolerance(count.max(100)) * largest;
        let mut open = vec![false; count];
        // V/s in the determined directions: P is its square
        let mut root = posterior.vectors.clone();
        for (mut vector, &value) in root.column_iter_mut().zip(&posterior.values) {
            if determined(value) {
                vector /= value;
                continue;
            }
            (0..count).filter(|&k| vector[k].abs() > 1e-6).for_each(|k| open[k] = true);
            vector.fill(0.0);
        }
        let plain = &root * root.transpose();
        let inflation = factor * factor;
        let mut of_priors = plain.clone();
        for (mut column, &weight) in of_priors.column_iter_mut().zip(prior_weights) {
            column *= weight;
        }
        let covariance = match correlated {
            None => &plain * inflation - of_priors * &plain * (inflation - 1.0),
            Some(correlated) => &plain * correlated * &plain * inflation + of_priors * &plain,
        };
        // along a singular vector v the same by v alone: P v = v/s²
        let deviation = |(j, &value): (usize, &f64)| match determined(value) {
            true if correlated.is_some() => {
                let vector = posterior.vectors.column(j);
                vector.dot(&(&covariance * vector)).max(0.0).sqrt()
            }
            true => {
                let vector = posterior.vectors.column(j);
                let squares = vector.iter().zip(prior_weights).map(|(v, weight)| weight * v * v);
                let of_priors = squares.sum::<f64>() / (value * value);
                (inflation - (inflation - 1.0) * of_priors).max(0.0).sqrt() / value
            }
            false => f64::INFINITY,
        };
        let deviations: Vec<f64> = posterior.values.iter().enumerate().map(deviation).collect();
        let sigmas = (0..count).map(|k| (!open[k]).then(|| covariance[(k, k)].max(0.0).sqrt())).collect();
        let undetermined = deviations.iter().filter(|deviation| deviation.is_infinite()).count();
        Self { covariance, sigmas, undetermined, deviations, vectors: posterior.vectors.clone() }
    }

    /// The lower triangle of correlation coefficients, after so many parameters that these have nothing to do with.
    pub(super) fn correlation_rows(&self, before: usize) -> Vec<Vec<f64>> {
        let coefficient = |i: usize, j: usize| match (self.sigmas[i], self.sigmas[j]) {
            (Some(first), Some(second)) => self.covariance[(i, j)] / (first * second),
            _ => f64::NAN,
        };
        let row = |i: usize| (0..before).map(|_| 0.0).chain((0..=i).map(|j| coefficient(i, j))).collect();
        (0..self.sigmas.len()).map(row).collect()
    }

    /// Directions whose standard deviation exceeds the limit (m, by what the parameters are worth): first the translations
    /// of frame anchor and platform anchor together that explain them, then what is left, each as coefficients.
    pub(super) fn weak_directions(&self, named: &Named<'_>, rotation: &Matrix3<f64>, limit: f64) -> Vec<Direction> {
        let mut open: Vec<(DVector<f64>, f64)> = Vec::new(); // orthonormal but for the worth of parameters
        for (j, &deviation) in self.deviations.iter().enumerate() {
            let direction = self.vectors.column(j).component_mul(&named.scale);
            let deviation = deviation * direction.norm();
            if deviation > limit {
                open.push((direction.normalize(), deviation));
            }
        }
        let mut found = Vec::new();
        let mut rest: Vec<(DVector<f64>, f64)> = open.clone();
        for (cable, axis) in named.cables.clone().flat_map(|cable| (0..3).map(move |axis| (cable, axis))) {
            let Some(together) = named.anchors_together(cable, axis, rotation) else { continue };
            let inside: f64 = open.iter().map(|(vector, _)| vector.dot(&together).powi(2)).sum();
            if inside < 0.9 {
                continue;
            }
            // the deviation along it, from the open directions it is made of
            let variance: f64 = open.iter().map(|(vector, s)| (vector.dot(&together) * s).powi(2)).sum();
            found.push(Direction::AnchorsTogether { cable, axis, deviation: variance.sqrt() });
            rest.iter_mut().for_each(|(vector, _)| *vector -= &together * vector.dot(&together));
        }
        // as many directions are left as the translations do not explain: those that keep most of their length
        rest.sort_by(|a, b| b.0.norm().total_cmp(&a.0.norm()));
        rest.truncate(open.len().saturating_sub(found.len()));
        for (vector, deviation) in rest {
            let coefficients = named.parameters.iter().copied().zip(vector.normalize().iter().copied()).collect();
            found.push(Direction::Combination { coefficients, deviation });
        }
        found
    }
}

/// Parameters that are judged together, and what gives their directions names.
pub(super) struct Named<'a> {
    pub(super) parameters: &'a [Parameter],
    /// Axes of the motion pattern (world and platform).
    pub(super) axes: &'a [Vector3<f64>],
    /// Cables that the parameters belong to.
    pub(super) cables: Range<usize>,
    /// Metres that one unit of each parameter is worth.
    pub(super) scale: DVector<f64>,
}

impl Named<'_> {
    /// Unit direction that moves frame anchor and platform anchor of a cable together along one of the pattern's axes, for
    /// a platform that keeps this rotation; `None` unless all components of both are free.
    fn anchors_together(&self, cable: usize, axis: usize, rotation: &Matrix3<f64>) -> Option<DVector<f64>> {
        let count = |kind| self.parameters.iter().filter(|p| p.cable == cable && p.kind == kind).count();
        let (frame, platform) = (ParameterKind::FrameAnchor, ParameterKind::PlatformAnchor);
        if axis >= self.axes.len() || count(frame) < self.axes.len() || count(platform) < self.axes.len() {
            return None;
        }
        let in_platform = rotation.transpose() * self.axes[axis];
        let component = |parameter: &Parameter| match parameter.kind {
            _ if parameter.cable != cable => 0.0,
            ParameterKind::FrameAnchor => f64::from(u8::from(parameter.axis == axis)),
            ParameterKind::PlatformAnchor => self.axes[parameter.axis].dot(&in_platform),
            _ => 0.0,
        };
        let direction = DVector::from_iterator(self.parameters.len(), self.parameters.iter().map(component));
        Some(direction.normalize())
    }
}

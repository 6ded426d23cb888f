//! Rows of frames once the parameters have taken what they can explain.

use nalgebra::{DMatrix, DVector};

use super::directions::{Directions, is_anchor};
use super::rows::Fitted;
use crate::fit::checks::is_at_bound;
use crate::residual::rows::RowBlock;
use cdpr_model::geometry::Twist;
use cdpr_model::robot::Parameter;
use cdpr_model::scalar::decomposition::svd;

/// Directions with a singular value below this share of that of all rows with the parameters held are free whatever the data.
const FREE: f64 = 1e-6;
/// Ridge of the parameters, as a share of the length of their columns: keeps undetermined ones where they are.
const RIDGE: f64 = 1e-9;
/// Rows of the frames, parameters eliminated.
pub(super) struct Eliminated {
    /// Change of all parameters by one metre of each direction of the frames.
    pub(super) following: DMatrix<f64>,
    /// Directions that the data tell, one per column, with their standard deviations in units of the weights.
    pub(super) told: DMatrix<f64>,
    pub(super) deviations: Vec<f64>,
    /// Directions that no row resists, one per column.
    pub(super) free: DMatrix<f64>,
    /// Gauss–Newton step along the told directions.
    newton: DVector<f64>,
    blocks: Vec<Factors>,
}

/// Factors and rows of a block.
struct Factors {
    /// Its parameters that move, by their place in the list of all.
    moving: Vec<usize>,
    /// Upper factor of their normal equations.
    triangle: DMatrix<f64>,
    /// Rows by these parameters, and by the directions of the frames.
    by_parameters: DMatrix<f64>,
    by_frames: DMatrix<f64>,
}

impl Eliminated {
    /// `None` if a row is not finite.
    pub(super) fn of(fitted: &Fitted, parameters: &[Parameter], directions: &Directions) -> Option<Self> {
        let count = directions.list.len();
        let is_held = |place: usize| is_at_bound(fitted.values[place], fitted.start[place], parameters[place].bounds());
        let along = |columns: Vec<Twist>| {
            DMatrix::from_fn(fitted.basis.len(), count, |k, column| fitted.basis[k].dot(&columns[column]))
        };
        let axes = |block: &RowBlock| -> Option<Vec<DMatrix<f64>>> {
            let residuals = &block.wrenches.as_ref()?.residuals;
            let of_sample = |(pose, wrench)| along(directions.changes_of_axes(pose, wrench).collect());
            Some(block.poses.iter().zip(residuals).map(of_sample).collect())
        };
        let mut following = DMatrix::zeros(parameters.len(), count);
        let (mut rests, mut blocks, mut held) = (DMatrix::zeros(0, count + 1), Vec::new(), 0.0);
        for block in &fitted.blocks {
            let moving: Vec<usize> = (0..block.parameters.len()).filter(|k| !is_held(block.parameters[*k])).collect();
            let motions: Vec<DMatrix<f64>> =
                block.poses.iter().map(|pose| along(directions.motions(pose).collect())).collect();
            let matrix = stacked(block, &moving, fitted, (&motions, axes(block).as_deref()));
            let (rows, own) = (block.by_pose.nrows(), moving.len());
            let by_parameters = matrix.view((0, 0), (rows, own)).into_owned();
            let by_frames = matrix.view((0, own), (rows, count)).into_owned();
            held += by_frames.norm_squared();
            let factor = upper_factor(matrix);
            let triangle = factor.view((0, 0), (own, own)).into_owned();
            let follows = triangle.solve_upper_triangular(&(-factor.view((0, own), (own, count)).into_owned()))?;
            let moving: Vec<usize> = moving.into_iter().map(|k| block.parameters[k]).collect();
            for (row, &place) in moving.iter().enumerate() {
                following.row_mut(place).copy_from(&follows.row(row));
            }
            blocks.push(Factors { moving, triangle, by_parameters, by_frames });
            let rest = factor.view((own, own), (count + 1, count + 1)).into_owned();
            let before = rests.nrows();
            rests = rests.resize_vertically(before + count + 1, 0.0);
            rests.rows_mut(before, count + 1).copy_from(&rest);
        }
        let factor = upper_factor(rests);
        let right = factor.view((0, count), (count, 1)).into_owned();
        let decomposition = svd(factor.view((0, 0), (count, count)).into_owned(), true, true)?;
        let (left, vectors) = (decomposition.u?, decomposition.v_t?.transpose());
        let values = decomposition.singular_values;
        let is_told = |k: &usize| values[*k] > FREE * held.sqrt();
        let told: Vec<usize> = (0..count).filter(is_told).collect();
        let free: Vec<usize> = (0..count).filter(|k| !is_told(k)).collect();
        let along = |&k: &usize| vectors.column(k) * (-left.column(k).dot(&right.column(0)) / values[k]);
        Some(Self {
            following,
            deviations: told.iter().map(|&k| 1.0 / values[k]).collect(),
            newton: told.iter().map(along).fold(DVector::zeros(count), |sum, part| sum + part),
            told: vectors.select_columns(&told),
            free: vectors.select_columns(&free),
            blocks,
        })
    }

    /// True for parameters that moved with the frames, by their place.
    pub(super) fn moves(&self, place: usize) -> bool {
        self.blocks.iter().any(|block| block.moving.contains(&place))
    }

    /// Covariance of parameters and frames by the noise of the rows, in the gauge where the free directions do not move.
    ///
    /// Rows of a sample that stand in different blocks have noise in common, that of the pose: residuals tell their correlation. Noise
    /// of the data is `inflation` times what the weights say, that of priors is not.
    pub(super) fn covariance(&self, fitted: &Fitted, inflation: f64) -> Option<DMatrix<f64>> {
        let (count, frames) = self.following.shape();
        let told = &self.told
            * DMatrix::from_diagonal(&DVector::from_iterator(
                self.deviations.len(),
                self.deviations.iter().map(|deviation| deviation * deviation),
            ))
            * self.told.transpose();
        // errors of all unknowns by one unit of noise of each row
        let errors = |block: &Factors, by_parameters: &DMatrix<f64>, by_frames: &DMatrix<f64>| {
            let follows = self.following.select_rows(&block.moving);
            let of_frames = &told * (by_frames + by_parameters * &follows).transpose();
            let half = block.triangle.tr_solve_upper_triangular(&by_parameters.transpose())?;
            let own = block.triangle.solve_upper_triangular(&half)?;
            let mut errors = (&self.following * &of_frames).resize_vertically(count + frames, 0.0);
            errors.rows_mut(count, frames).copy_from(&of_frames);
            for (row, &place) in block.moving.iter().enumerate() {
                let mut target = errors.row_mut(place);
                target += own.row(row);
            }
            Some(errors)
        };
        let of_data: Option<Vec<DMatrix<f64>>> =
            self.blocks.iter().map(|block| errors(block, &block.by_parameters, &block.by_frames)).collect();
        let of_data = of_data?;
        let mut covariance = DMatrix::zeros(count + frames, count + frames);
        for (i, first) in of_data.iter().enumerate() {
            for (j, second) in of_data.iter().enumerate() {
                let together = if i == j { 1.0 } else { correlation(&fitted.blocks[i], &fitted.blocks[j]) };
                covariance += first * second.transpose() * (together * inflation * inflation);
            }
        }
        for block in &self.blocks {
            let roots = block.moving.iter().map(|&place| fitted.priors[place].sqrt());
            let rows = DMatrix::from_diagonal(&DVector::from_iterator(block.moving.len(), roots));
            let of_priors = errors(block, &rows, &DMatrix::zeros(block.moving.len(), frames))?;
            covariance += &of_priors * of_priors.transpose();
        }
        Some(covariance)
    }

    /// Motions of the anchors by the free directions: those of all anchors' components in the list of parameters.
    pub(super) fn anchors_by_free(&self, parameters: &[Parameter]) -> DMatrix<f64> {
        let moved = &self.following * &self.free;
        DMatrix::from_fn(parameters.len(), moved.ncols(), |row, k| {
            if is_anchor(&parameters[row]) { moved[(row, k)] } else { 0.0 }
        })
    }

    /// Step of the frames (m, one of each direction): Gauss–Newton where the data tell, no longer than the extent of the poses, and towards the
    /// least change of the file's anchors where they do not.
    pub(super) fn step(&self, fitted: &Fitted, parameters: &[Parameter], extent: f64) -> DVector<f64> {
        let size = self.newton.amax();
        let mut step = if size > extent { &self.newton * (extent / size) } else { self.newton.clone() };
        if self.free.ncols() > 0 {
            let follows = &self.following * &step;
            let change = DVector::from_fn(parameters.len(), |k, _| fitted.values[k] + follows[k] - fitted.start[k]);
            step += &self.free * least_change(&self.anchors_by_free(parameters), &change);
        }
        step
    }
}

/// Correlation of the residuals of two cables, sample by sample.
fn correlation(first: &RowBlock, second: &RowBlock) -> f64 {
    let coefficient = first.residuals.dot(&second.residuals) / (first.residuals.norm() * second.residuals.norm());
    if coefficient.is_finite() { coefficient } else { 0.0 }
}

/// Amounts of the free directions that leave the anchors nearest to where they were.
pub(super) fn least_change(anchors: &DMatrix<f64>, change: &DVector<f64>) -> DVector<f64> {
    let none = || DVector::zeros(anchors.ncols());
    let Some(decomposition) = svd(anchors.clone(), true, true) else { return none() };
    let tolerance = RIDGE * decomposition.singular_values.max();
    decomposition.solve(&-change, tolerance.max(f64::MIN_POSITIVE)).unwrap_or_else(|_| none())
}

/// \[J_p J_ξ r\] of a block with the rows of priors and ridges.
fn stacked(
    block: &RowBlock,
    moving: &[usize],
    fitted: &Fitted,
    (motions, axes): (&[DMatrix<f64>], Option<&[DMatrix<f64>]>),
) -> DMatrix<f64> {
    let (rows, own) = (block.by_pose.nrows(), moving.len());
    let count = motions.first().map_or(0, DMatrix::ncols);
    let mut matrix = DMatrix::zeros((rows + 2 * own).max(own + count + 1), own + count + 1);
    for (column, &k) in moving.iter().enumerate() {
        matrix.view_mut((0, column), (rows, 1)).copy_from(&block.by_parameters.column(k));
    }
    for (sample, motion) in motions.iter().enumerate() {
        let (first, size) = (sample * block.rows_of_sample, block.rows_of_sample);
        let mut by_frames = block.by_pose.rows(first, size) * motion;
        if let (Some(wrenches), Some(axes)) = (&block.wrenches, axes) {
            by_frames -= wrenches.whitened.rows(first, size) * &axes[sample];
        }
        matrix.view_mut((first, own), (size, count)).copy_from(&by_frames);
    }
    matrix.view_mut((0, own + count), (rows, 1)).copy_from(&block.residuals);
    for (column, &k) in moving.iter().enumerate() {
        let place = block.parameters[k];
        let (prior, row) = (fitted.priors[place].sqrt(), rows + 2 * column);
        matrix[(row, column)] = prior;
        matrix[(row, own + count)] = prior * (fitted.values[place] - fitted.start[place]);
        let length = matrix.view((0, column), (rows + 2 * own, 1)).norm();
        matrix[(row + 1, column)] = RIDGE * if length > 0.0 { length } else { 1.0 };
    }
    matrix
}

fn upper_factor(matrix: DMatrix<f64>) -> DMatrix<f64> {
    matrix.qr().r()
}

//! Frame anchors beside those of another robot, after the motion that brings them together best.

use nalgebra::{DMatrix, DVector};

use cdpr_model::model::Model;
use cdpr_model::robot::Robot;
use cdpr_model::scalar::decomposition::svd;

/// Frame anchors beside those of another robot, after the shift and turn, and the mirror image where data leave it free, that brings them together best
/// (Procrustes).
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Name of the other robot.
    pub robot: String,
    /// Root mean square of the anchors' distances from its anchors (m).
    pub rms_m: f64,
    /// Distance of each anchor, cable by cable (m).
    pub distance_m: Vec<f64>,
    /// Factor by which the other robot is larger; it is not taken away from the distances.
    pub scale: f64,
    /// True where the mirror image was taken.
    pub is_mirrored: bool,
}

impl Comparison {
    /// Anchors of a model beside those of a robot with as many cables, in the axes of the model's pattern; `None` if cables differ or all anchors coincide.
    pub fn of(model: &Model, other: &Robot, may_mirror: bool) -> Option<Self> {
        let (own, others) = (coordinates(model, model.robot()), coordinates(model, other));
        if own.ncols() != others.ncols() {
            return None;
        }
        let [own, others] = [centred(own), centred(others)];
        let dimension = own.nrows();
        let found = svd(&others * own.transpose(), true, true)?;
        let (left, right) = (found.u?, found.v_t?);
        let determinant = (&left * &right).determinant();
        let is_mirrored = determinant < 0.0 && may_mirror;
        let mut signs = DVector::repeat(dimension, 1.0);
        if determinant < 0.0 && !may_mirror {
            signs[dimension - 1] = -1.0;
        }
        let turn = left * DMatrix::from_diagonal(&signs) * right;
        let moved = turn * &own;
        let scale = found.singular_values.dot(&signs) / own.norm_squared();
        let distance_m: Vec<f64> = (&others - moved).column_iter().map(|apart| apart.norm()).collect();
        let squares: f64 = distance_m.iter().map(|distance| distance * distance).sum();
        let rms_m = (squares / distance_m.len() as f64).sqrt();
        scale.is_finite().then(|| Self { robot: other.name.clone(), rms_m, distance_m, scale, is_mirrored })
    }
}

/// Frame anchors in the axes of a pattern, a column each.
fn coordinates(model: &Model, robot: &Robot) -> DMatrix<f64> {
    let axes = model.axes();
    DMatrix::from_fn(axes.len(), robot.cables.len(), |row, cable| axes[row].dot(&robot.cables[cable].frame_anchor))
}

fn centred(mut points: DMatrix<f64>) -> DMatrix<f64> {
    let mean = points.column_mean();
    points.column_iter_mut().for_each(|mut point| point -= &mean);
    points
}

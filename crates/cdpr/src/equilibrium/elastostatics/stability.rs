//! Is an equilibrium stable, and where to go when it is not.

use nalgebra::DMatrix;

use super::Problem;
use super::descent::{End, Stop, Tensions};
use super::multipliers::Rigid;
use super::search::Attempt;
use crate::geometry::{Pose, Twist};
use crate::scalar::LANES;
use crate::scalar::decomposition::{smallest_eigenvalue, smallest_eigenvalue_of, svd, symmetric_eigen};

/// How far from an unstable equilibrium to start again, relative to the mean length.
const ESCAPE: f64 = 0.02;

/// Smallest eigenvalue of the stiffness (lower triangle), rotations divided by the platform radius (N/m).
pub(super) fn stability(problem: &Problem<'_>, stiffness: &[[f64; 6]; 6]) -> f64 {
    match problem.model.dof() {
        2 => smallest_eigenvalue_of(scaled::<2>(problem, stiffness)),
        3 => smallest_eigenvalue_of(scaled::<3>(problem, stiffness)),
        _ => smallest_eigenvalue_of(scaled::<6>(problem, stiffness)),
    }
}

/// Lower triangle.
fn scaled<const N: usize>(problem: &Problem<'_>, stiffness: &[[f64; 6]; 6]) -> [[f64; N]; N] {
    let inverse: [f64; N] = std::array::from_fn(|row| 1.0 / radius(problem, row));
    std::array::from_fn(|row| std::array::from_fn(|column| stiffness[row][column] * inverse[row] * inverse[column]))
}

/// 1 for a translation, the platform radius for a rotation.
fn radius(problem: &Problem<'_>, entry: usize) -> f64 {
    if entry < problem.model.axes().len() { 1.0 } else { problem.platform_radius }
}

/// Smallest eigenvalue of the stiffness on the motions that leave the lengths of taut rigid cables as they are: −K_G − ∂w/∂x
/// and what elastic cables add. Infinite where there is no such motion.
pub(super) fn beside_rigid_cables(problem: &Problem<'_>, rigid: &Rigid<'_>, tensions: &Tensions, end: &End) -> f64 {
    let n = problem.model.dof();
    let taut: Vec<usize> =
        rigid.cables().filter(|cable| tensions.accepted[cable / LANES][cable % LANES] > 0.0).collect();
    let Ok(structure_matrix) = problem.model.structure_matrix(&end.pose) else { return f64::NAN };
    let held = DMatrix::from_fn(n, n, |row, column| {
        let of = |cable: &usize| structure_matrix[(row, *cable)] / radius(problem, row);
        taut.get(column).map_or(0.0, of)
    });
    // A square matrix, so that the decomposition has all n directions.
    let Some(directions) = svd(held, true, false).and_then(|decomposition| decomposition.u) else { return f64::NAN };
    let singular_values = DMatrix::from_fn(n, 1, |column, _| {
        taut.iter()
            .map(|&cable| {
                let along: f64 = (0..n)
                    .map(|row| directions[(row, column)] * structure_matrix[(row, cable)] / radius(problem, row))
                    .sum();
                along * along
            })
            .sum::<f64>()
            .sqrt()
    });
    let free: Vec<usize> = (0..n).filter(|&column| singular_values[column] < 1e-9).collect();
    if free.is_empty() {
        return f64::INFINITY;
    }
    let kernel = directions.select_columns(&free);
    let stiffness = DMatrix::from_fn(n, n, |row, column| {
        end.stiffness[row.max(column)][row.min(column)] / (radius(problem, row) * radius(problem, column))
    });
    smallest_eigenvalue(kernel.transpose() * stiffness * kernel)
}

/// Two poses beside an unstable equilibrium, along the direction in which it falls; nothing beside other ends.
pub(super) fn escapes(problem: &Problem<'_>, attempt: &Attempt) -> [Option<Pose>; 2] {
    if attempt.end.stop != Stop::Stationary || attempt.stability.is_nan() {
        return [None; 2];
    }
    let n = problem.model.dof();
    let stiffness = DMatrix::from_fn(n, n, |row, column| {
        attempt.end.stiffness[row.max(column)][row.min(column)] / (radius(problem, row) * radius(problem, column))
    });
    let Some(eigen) = symmetric_eigen(stiffness) else { return [None; 2] };
    let weakest = eigen.eigenvectors.column(eigen.eigenvalues.imin());
    let mut twist = Twist::zeros();
    for (index, direction) in problem.model.twist_basis().iter().enumerate() {
        twist += direction * (weakest[index] / radius(problem, index));
    }
    let largest = f64::max(twist.fixed_rows::<3>(0).norm() / problem.mean_length, twist.fixed_rows::<3>(3).norm());
    let step = twist * (ESCAPE / largest);
    [Some(attempt.end.pose.displaced(&step)), Some(attempt.end.pose.displaced(&-step))]
}

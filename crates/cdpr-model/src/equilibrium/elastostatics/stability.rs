//! Stability of an equilibrium, and starts beside an unstable one.

use nalgebra::DMatrix;

use super::attempt::Attempt;
use super::descent::{EquilibriumEnd, Stop, Tensions};
use super::rigid::Rigid;
use super::{Problem, Settings};
use crate::geometry::{Pose, Twist};
use crate::scalar::LANES;
use crate::scalar::decomposition::{smallest_eigenvalue, svd, symmetric_eigen};
use crate::scalar::eigenvalue::smallest_eigenvalue_of;
use crate::tension::{Limits, quadratic};

/// Distance of a new start from an unstable equilibrium, relative to the mean length.
const ESCAPE: f64 = 0.02;

/// Smallest eigenvalue of the stiffness (lower triangle), rotations divided by the platform radius (N/m).
pub(super) fn stability(problem: &Problem<'_>, stiffness: &[[f64; 6]; 6]) -> f64 {
    match problem.model.dof() {
        2 => smallest_eigenvalue_of(scaled::<2>(problem, stiffness)),
        3 => smallest_eigenvalue_of(scaled::<3>(problem, stiffness)),
        _ => smallest_eigenvalue_of(scaled::<6>(problem, stiffness)),
    }
}

/// Lower triangle of the stiffness, rotations divided by the platform radius (N/m).
fn scaled<const N: usize>(problem: &Problem<'_>, stiffness: &[[f64; 6]; 6]) -> [[f64; N]; N] {
    let inverse: [f64; N] = std::array::from_fn(|row| 1.0 / radius(problem, row));
    std::array::from_fn(|row| std::array::from_fn(|column| stiffness[row][column] * inverse[row] * inverse[column]))
}

/// 1 for a translation, the platform radius for a rotation.
fn radius(problem: &Problem<'_>, entry: usize) -> f64 {
    if entry < problem.model.axes().len() { 1.0 } else { problem.platform_radius }
}

/// Smallest eigenvalue of the stiffness at an equilibrium of elastic cables (N/m).
///
/// A cable between slack and taut holds in one direction only: its stiffness counts if such cables together hold all
/// weak motions.
pub(super) fn of_cables(problem: &Problem<'_>, tensions: &Tensions, end: &EquilibriumEnd, undecided: f64) -> f64 {
    let touches = |cable: &usize| {
        let (group, lane) = (cable / LANES, cable % LANES);
        let least = problem.springs[group].rest_length[lane] - problem.settings.length_tolerance;
        tensions.accepted[group][lane].abs() <= undecided && tensions.accepted_lengths[group][lane] >= least
    };
    let mut touching = (0..problem.model.cable_count()).filter(touches).peekable();
    if touching.peek().is_none() {
        return stability(problem, &end.stiffness);
    }
    let touching: Vec<usize> = touching.collect();
    let Some(columns) = columns(problem, &end.pose) else { return f64::NAN };
    let beside = without(problem, &touching, &end.pose);
    let n = problem.model.dof();
    match weakest(problem, &DMatrix::identity(n, n), beside.clone(), &columns.select_columns(&touching)) {
        Weakest::Held(_) => {
            let add = |mut sum: DMatrix<f64>, cable: usize| {
                let column = columns.column(cable);
                sum.ger(problem.springs[cable / LANES].stiffness[cable % LANES], &column, &column, 1.0);
                sum
            };
            smallest_eigenvalue(touching.into_iter().fold(beside, add))
        }
        Weakest::Free(smallest) => smallest,
    }
}

/// The stiffness at a pose without these cables (N/m).
fn without(problem: &Problem<'_>, cables: &[usize], pose: &Pose) -> DMatrix<f64> {
    let mut springs = problem.springs.to_vec();
    for &cable in cables {
        springs[cable / LANES].stiffness[cable % LANES] = 0.0;
    }
    let settings = Settings { max_iterations: 0, ..problem.settings.clone() };
    let still = Problem { springs: &springs, settings: &settings, ..*problem };
    let end = still.descend(pose, &mut Tensions::new(springs.len()));
    whole(problem, &end.stiffness)
}

/// Smallest eigenvalue (N/m) of the stiffness on the motions that do not change the lengths of taut rigid cables: −K_G
/// − ∂w/∂x and the part of elastic cables. Infinite if there is no such motion. Cables that are just taut hold in one
/// direction only.
///
/// The stiffness of a polished end has only the part of elastic cables; others include virtual springs, which must not
/// count.
pub(super) fn beside_rigid_cables(
    problem: &Problem<'_>,
    rigid: &Rigid<'_>,
    tensions: &Tensions,
    end: &EquilibriumEnd,
    is_polished: bool,
) -> f64 {
    let n = problem.model.dof();
    let Some(columns) = columns(problem, &end.pose) else { return f64::NAN };
    let tension = |cable: usize| tensions.accepted[cable / LANES][cable % LANES];
    let undecided = problem.undecided(tensions);
    let (taut, slack): (Vec<usize>, Vec<usize>) = rigid.cables().partition(|&cable| tension(cable) > undecided);
    let stiffness = match is_polished {
        true => whole(problem, &end.stiffness),
        false => without(problem, &slack, &end.pose),
    };
    let touches = |cable: &usize| {
        let (path, _) = problem.model.path_or_nan(*cable, &end.pose);
        path.length >= rigid.lengths[*cable] - problem.settings.length_tolerance
    };
    let touching: Vec<usize> = slack.into_iter().filter(touches).collect();
    // a square matrix, so that the decomposition has all n directions
    let held = DMatrix::from_fn(n, n, |row, column| taut.get(column).map_or(0.0, |&cable| columns[(row, cable)]));
    let Some(directions) = svd(held, true, false).and_then(|decomposition| decomposition.u) else { return f64::NAN };
    let along = |direction: usize| {
        let of = |&cable: &usize| directions.column(direction).dot(&columns.column(cable));
        taut.iter().map(|cable| of(cable).powi(2)).sum::<f64>().sqrt()
    };
    let free: Vec<usize> = (0..n).filter(|&direction| along(direction) < 1e-9).collect();
    if free.is_empty() {
        return f64::INFINITY;
    }
    let kernel = directions.select_columns(&free);
    match weakest(problem, &kernel, stiffness, &columns.select_columns(&touching)) {
        Weakest::Held(others) => others,
        Weakest::Free(smallest) => smallest,
    }
}

/// Outcome of `weakest`: whether the weak motions are held.
enum Weakest {
    /// Held by cables that are just taut, since each such motion lengthens some of them; with the smallest eigenvalue
    /// of the other motions (N/m), infinite if there are none.
    Held(f64),
    /// Not held: the smallest eigenvalue of the stiffness (N/m).
    Free(f64),
}

/// Finds out whether cables that are just taut hold the weak motions of a stiffness, among the combinations of the
/// columns of `motions`.
fn weakest(problem: &Problem<'_>, motions: &DMatrix<f64>, stiffness: DMatrix<f64>, touching: &DMatrix<f64>) -> Weakest {
    let Some(eigen) = symmetric_eigen(motions.transpose() * stiffness * motions) else {
        return Weakest::Free(f64::NAN);
    };
    let values = &eigen.eigenvalues;
    let is_weak = |index: &usize| values[*index] <= problem.indifferent_stiffness();
    let (weak, strong): (Vec<usize>, Vec<usize>) = (0..values.len()).partition(is_weak);
    if weak.is_empty() || touching.ncols() <= weak.len() {
        return Weakest::Free(values.min());
    }
    let free = motions * eigen.eigenvectors.select_columns(&weak);
    match blocks_all(&(free.transpose() * touching)) {
        true => Weakest::Held(strong.into_iter().map(|index| values[index]).fold(f64::INFINITY, f64::min)),
        false => Weakest::Free(values.min()),
    }
}

/// True if every motion lengthens some cable. Each column is minus a cable's lengthening by each motion; the condition
/// is that tensions above zero balance each other and that the columns span all motions.
fn blocks_all(columns: &DMatrix<f64>) -> bool {
    let largest = columns.amax();
    let Some(decomposition) = svd(columns.clone(), false, false) else { return false };
    if !(decomposition.singular_values.min() > 1e-9 * largest) {
        return false;
    }
    let no_wrench = vec![0.0; columns.nrows()];
    let Ok(limits) = Limits::uniform(columns.ncols(), 1.0, 1e6) else { return false };
    let balance = quadratic::solve(&(columns / largest), &no_wrench, &limits, None);
    balance.is_ok_and(|found| found.status == quadratic::Status::Feasible)
}

/// The structure matrix with moments divided by the platform radius; `None` if a cable has no path.
fn columns(problem: &Problem<'_>, pose: &Pose) -> Option<DMatrix<f64>> {
    let mut columns = problem.model.structure_matrix(pose).ok()?;
    for (row, mut entries) in columns.row_iter_mut().enumerate() {
        entries /= radius(problem, row);
    }
    Some(columns)
}

/// Both triangles of the stiffness, rotations divided by the platform radius (N/m).
fn whole(problem: &Problem<'_>, stiffness: &[[f64; 6]; 6]) -> DMatrix<f64> {
    let n = problem.model.dof();
    DMatrix::from_fn(n, n, |row, column| {
        stiffness[row.max(column)][row.min(column)] / (radius(problem, row) * radius(problem, column))
    })
}

/// Two poses on both sides of an unstable equilibrium, along its softest motion; `None` twice for other ends.
pub(super) fn escapes(problem: &Problem<'_>, attempt: &Attempt) -> [Option<Pose>; 2] {
    if attempt.end.stop != Stop::Stationary || attempt.stability.is_nan() {
        return [None; 2];
    }
    let Some(eigen) = symmetric_eigen(whole(problem, &attempt.end.stiffness)) else { return [None; 2] };
    let weakest = eigen.eigenvectors.column(eigen.eigenvalues.imin());
    let mut twist = Twist::zeros();
    for (index, direction) in problem.model.twist_basis().iter().enumerate() {
        twist += direction * (weakest[index] / radius(problem, index));
    }
    let largest = f64::max(twist.fixed_rows::<3>(0).norm() / problem.mean_length, twist.fixed_rows::<3>(3).norm());
    let step = twist * (ESCAPE / largest);
    [Some(attempt.end.pose.displaced(&step)), Some(attempt.end.pose.displaced(&-step))]
}

//! Wrench closure: the cables can balance any load if their tensions may be large enough.

use nalgebra::{DMatrix, Vector3};

use super::cables::fixed_directions;
use super::minors::Minors;
use super::narrowing::{Closing, Narrowing, largest};
use super::{Criterion, Spans, Verdict};
use crate::WorkspaceError;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::scalar::decomposition::svd;
use cdpr_model::tension::Limits;
use cdpr_model::tension::quadratic::{Solver, Status};

/// Positive tensions without a load, Aᵀ f = 0 with f > 0, and a structure matrix of full rank (Pott 2018, ch. 5):
/// exact.
///
/// The margin (–) is the largest possible ratio of the smallest tension to the mean: max min f / mean f over Aᵀ f = 0.
/// It is 1 if all cables can pull alike, 0 on the boundary, and below zero minus the smallest push that one cable would
/// need; −∞ if the rank is deficient.
///
/// Between point outlets and anchors, closure changes along a straight line only where a minor of the structure matrix
/// changes its sign, and minors times cable lengths are polynomials there: rays are exact then.
#[derive(Clone, Debug)]
pub struct WrenchClosure<'a> {
    model: &'a Model,
}

/// Tensions below this fraction of their sum are rounding errors of zero.
const LEAST: f64 = 1e-9;
/// Singular values below this fraction of the largest are rounding errors of zero.
const LOST: f64 = 1e-9;

impl<'a> WrenchClosure<'a> {
    /// The criterion for a model of straight cables.
    pub fn new(model: &'a Model) -> Result<Self, WorkspaceError> {
        fixed_directions(model, "wrench-closure").map(|()| Self { model })
    }

    fn qp(&self) -> Solver {
        Solver::new(self.model.cable_count(), self.model.dof() + 1)
    }

    /// True if the tensions with this structure matrix can be `LEAST` or more, for a sum of 1.
    fn all_pull(&self, qp: &mut Solver, matrix: &DMatrix<f64>) -> bool {
        qp.forget();
        let limits = Limits::uniform(matrix.ncols(), LEAST, 1.0);
        let with_sum = with_sum(matrix);
        limits.is_ok_and(|limits| {
            let found = qp.solve(&with_sum, &sum_of_one(matrix.nrows()), &limits, None);
            found.is_ok_and(|found| found.status == Status::Feasible)
        })
    }

    /// The largest possible least tension for a sum of 1.
    fn least_tension(&self, qp: &mut Solver, matrix: &DMatrix<f64>) -> Result<Narrowing, WorkspaceError> {
        let cable_count = matrix.ncols();
        let limits = Limits::uniform(cable_count, 0.0, 1.0)?;
        // for a sum of 1 no tension can exceed what the others leave
        let closing = Closing { limits: &limits, rise: 1.0, fall: cable_count as f64 - 1.0 };
        let start = Narrowing { cable: None, ..closing.end() };
        let wrench = sum_of_one(matrix.nrows());
        Ok(largest(qp, &with_sum(matrix), &wrench, &closing, start)?)
    }
}

/// The structure matrix with a further row that sums the tensions.
fn with_sum(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    matrix.clone().insert_row(matrix.nrows(), 1.0)
}

/// Wrench that stands for no load and tensions that sum to 1.
fn sum_of_one(dof: usize) -> Vec<f64> {
    let mut wrench = vec![0.0; dof + 1];
    wrench[dof] = -1.0;
    wrench
}

/// Rank of a structure matrix, with its rows divided by their norms, since forces and moments differ in unit.
pub(crate) fn rank(matrix: &DMatrix<f64>) -> usize {
    let mut rows = matrix.clone();
    for mut row in rows.row_iter_mut() {
        let length = row.norm();
        if length > 0.0 {
            row /= length;
        }
    }
    let Some(decomposition) = svd(rows, false, false) else { return 0 };
    let values = &decomposition.singular_values;
    values.iter().filter(|&&value| value > LOST * values.max()).count()
}

impl Criterion for WrenchClosure<'_> {
    fn name(&self) -> &str {
        "wrench-closure"
    }

    fn unit(&self) -> &str {
        "1"
    }

    fn judge(&self, pose: &Pose) -> Verdict {
        let matrix = match self.model.structure_matrix(pose) {
            Ok(matrix) => matrix,
            Err(error) => return Verdict::impossible(error.to_string(), Some(error.cable() - 1)),
        };
        let (rank, dof, cable_count) = (rank(&matrix), matrix.nrows(), matrix.ncols());
        if rank < dof {
            let reason = format!("the structure matrix has rank {rank} of {dof}: in some direction no cable acts");
            return Verdict::impossible(reason, None);
        }
        if cable_count <= dof {
            let reason = format!("{cable_count} cables cannot pull against each other in {dof} degrees of freedom");
            return Verdict::impossible(reason, None);
        }
        let mut qp = self.qp();
        let holds = self.all_pull(&mut qp, &matrix);
        let Narrowing { amount, cable } = match self.least_tension(&mut qp, &matrix) {
            Ok(narrowing) => narrowing,
            Err(error) => return Verdict::impossible(error.to_string(), None),
        };
        let margin = amount * cable_count as f64;
        match holds {
            true => Verdict::held(margin, cable),
            false => Verdict::failed(margin, reason(margin, cable), cable),
        }
    }

    fn holds(&self, pose: &Pose) -> bool {
        let Ok(matrix) = self.model.structure_matrix(pose) else { return false };
        self.all_pull(&mut self.qp(), &matrix) && rank(&matrix) == matrix.nrows()
    }

    fn holds_along(&self, start: &Pose, direction: &Vector3<f64>, length: f64) -> Option<Spans> {
        let marks = Minors::along(self.model, start, direction, length)?.sign_changes();
        let ends = marks.iter().copied().chain([length]);
        let holds = |[from, to]: &[f64; 2]| {
            let position = start.position + direction * (0.5 * (from + to));
            self.holds(&Pose { position, ..*start })
        };
        let starts = [0.0].into_iter().chain(marks.iter().copied());
        Some(Spans::of(starts.zip(ends).map(|(from, to)| [from, to]).filter(holds)))
    }
}

fn reason(margin: f64, cable: Option<usize>) -> String {
    let which = cable.map_or_else(|| "one cable".to_owned(), |cable| format!("cable {}", cable + 1));
    match margin.is_finite() {
        true => format!(
            "the cables cannot all pull without a load: whatever the others do, {which} or one against it would have to \
             push, by {:.3} of the mean tension at least",
            -margin
        ),
        false => {
            "the cables cannot hold each other without a load: those that pull need others that push as much".to_owned()
        }
    }
}

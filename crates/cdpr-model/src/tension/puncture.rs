//! The puncture method (Müller, Reichert and Bruckmann 2015): low tensions without a search.
//!
//! The minimum-norm tensions that balance the load, −A⁺ᵀ w, mostly miss the lower limits. The segment from there to the
//! (improved) closed form stays balanced; the answer is its first point that keeps all limits. If the minimum-norm
//! tensions keep the limits themselves, they are the answer.
//!
//! **Where it fails:** where the improved closed form does. **Continuity:** continuous wherever that is; with kinks
//! where another cable becomes the last one to reach its limit. **Warm start:** none. **Derivative:** from both ends of
//! the segment, and from the cable that reaches its limit last.

use nalgebra::DVector;

use super::affine::{Affine, add_scaled};
use super::distribute::{
    Chosen, Derivative, Distribute, FoundTensions, NoDerivative, ON_LIMIT, Problem, Task, Written, between,
};
use super::response::optimum::Optimum;
use super::{InputError, Limits, closed_form, improved_closed_form};

/// Memory for the solutions of the balance and for the one of minimum norm.
#[derive(Clone, Debug)]
pub(super) struct Puncture {
    balanced: Affine,
    minimum_norm: Vec<f64>,
}

impl Puncture {
    pub(super) fn new(cable_count: usize, dof: usize) -> Self {
        Self { balanced: Affine::new(cable_count, dof), minimum_norm: vec![0.0; cable_count] }
    }
}

impl Distribute for Puncture {
    fn search(&mut self, task: &Task<'_>, found: &mut FoundTensions<'_>) -> Result<bool, InputError> {
        let Problem { structure_matrix, wrench } = task.problem;
        let Self { balanced, minimum_norm } = self;
        Ok(balanced.load(structure_matrix, wrench)?
            && search(balanced, found.limits, task.reference, minimum_norm, found.tensions))
    }

    fn derivative(&self, chosen: &Chosen<'_>) -> Written {
        Ok(Some(Box::new(Follower::of(chosen)?)))
    }
}

/// Writes the tensions; true if they keep the limits. `minimum_norm` is memory for one number per cable.
fn search(
    balanced: &mut Affine,
    limits: &Limits,
    reference: &[f64],
    minimum_norm: &mut [f64],
    tensions: &mut [f64],
) -> bool {
    minimum_norm.copy_from_slice(balanced.minimum_norm());
    if !improved_closed_form::search(balanced, limits, reference, tensions) {
        return false;
    }
    let mut part = 0.0_f64;
    for (cable, (outer, inner)) in minimum_norm.iter().zip(tensions.iter()).enumerate() {
        let (least, largest) = (limits.minimum()[cable], limits.maximum()[cable]);
        let limit = outer.clamp(least, largest);
        if limit != *outer && inner != outer {
            part = part.max((limit - outer) / (inner - outer));
        }
    }
    let part = part.min(1.0);
    for (inner, outer) in tensions.iter_mut().zip(minimum_norm.iter()) {
        *inner = outer + part * (*inner - outer);
    }
    true
}

/// Derivative of the first point within the limits.
#[derive(Clone, Debug)]
struct Follower {
    /// Derivatives of the minimum-norm tensions, and of the improved closed form.
    ends: [Optimum; 2],
    /// Vector from the minimum-norm tensions to the improved closed form (N).
    way: Vec<f64>,
    /// Fraction of the segment up to the answer, and the cable that is on its limit there; `None` if the minimum-norm
    /// tensions keep the limits.
    at: Option<(f64, usize)>,
}

impl Follower {
    fn of(chosen: &Chosen<'_>) -> Result<Self, NoDerivative> {
        let Chosen { problem, limits, .. } = *chosen;
        let matrix = problem.structure_matrix;
        let [minimum_norm, inner] = ends(&problem, limits)?;
        let way: Vec<f64> = inner.iter().zip(&minimum_norm).map(|(inner, outer)| inner - outer).collect();
        let mut at = None;
        for (cable, (outer, way)) in minimum_norm.iter().zip(&way).enumerate() {
            let limit = outer.clamp(limits.minimum()[cable], limits.maximum()[cable]);
            let part = (limit - outer) / way;
            if limit != *outer && *way != 0.0 && at.is_none_or(|(most, _)| part > most) {
                at = Some((part, cable));
            }
        }
        let all = (0..matrix.ncols()).collect();
        let of_shortest = Optimum::nearest(matrix, &minimum_norm, all, &|_| 0.0);
        let free = between(limits, &inner, ON_LIMIT);
        let of_inner = Optimum::nearest(matrix, &inner, free, &|cable| limits.middle(cable));
        let ends = [of_shortest.ok_or(NoDerivative::Pinned)?, of_inner.ok_or(NoDerivative::Pinned)?];
        Ok(Self { ends, way, at })
    }
}

/// The minimum-norm tensions and the improved closed form (N); those that keep the limits to rounding are clamped to
/// them.
fn ends(problem: &Problem<'_>, limits: &Limits) -> Result<[Vec<f64>; 2], InputError> {
    let Problem { structure_matrix, wrench } = *problem;
    let (dof, cable_count) = structure_matrix.shape();
    let zeros = vec![0.0; cable_count];
    let mut solver = closed_form::Solver::new(cable_count, dof);
    let shortest = solver.solve(structure_matrix, wrench, limits, Some(&zeros))?;
    let mut minimum_norm = shortest.tensions.clone();
    if shortest.balanced && shortest.within_limits {
        limits.clamp(&mut minimum_norm);
    }
    let middle: Vec<f64> = (0..cable_count).map(|cable| limits.middle(cable)).collect();
    let (mut balanced, mut inner) = (Affine::new(cable_count, dof), zeros);
    if balanced.load(structure_matrix, wrench)?
        && improved_closed_form::search(&mut balanced, limits, &middle, &mut inner)
    {
        limits.clamp(&mut inner);
    }
    Ok([minimum_norm, inner])
}

impl Derivative for Follower {
    fn change(&self, cable: usize, column: &[f64], wrench: &[f64]) -> DVector<f64> {
        let [outer, inner] = self.ends.each_ref().map(|end| end.change(cable, column, wrench));
        let Some((part, blocking)) = self.at else { return outer };
        let mut change = outer * (1.0 - part) + inner * part;
        // the cable on its limit stays there
        let further = -change[blocking] / self.way[blocking];
        add_scaled(change.as_mut_slice(), further, &self.way);
        change
    }

    fn change_by_reference(&self, _cable: usize) -> DVector<f64> {
        // the minimum-norm end has no reference that could be moved cable by cable
        DVector::zeros(self.way.len())
    }
}

//! The centroid of all allowed tensions, at any redundancy.
//!
//! In the coordinates λ of f + H λ the allowed tensions are a polytope: none or a point (redundancy 0), a segment (1,
//! its midpoint), a polygon (2, the barycentre of Gouttefarde et al. 2015), a polyhedron and so on. Volume and centroid
//! follow from those of the facets, which are polytopes of one dimension less: with the distance bᵢ of facet i from any
//! one point and its volume Vᵢ, r V = Σ bᵢ Vᵢ, and the centroid is that of cones over the facets. The recursion ends at
//! segments, which have the vertices of polygons as ends. It is exact to rounding.
//!
//! **Cost:** m limits above and below give 2m facets, each with 2m − 2 of its own, and so on: the cost grows by a
//! factor of about 2m with every further degree of redundancy (see the table in the book). The method gives up after
//! some seconds' work, and at once beyond 8 degrees. **Continuity:** continuous as long as the set keeps its dimension.
//! If the set is thinner than rounding in some direction, the answer is the optimum of the quadratic programme. **Warm
//! start:** none.

use super::affine::Affine;
use super::distribute::{Cause, Chosen, Distribute, FoundTensions, NoDerivative, Problem, Status, Task, Written};
use super::polytope::{Centroid, Polytope};
use super::response::centroid;
use super::{InputError, Limits, quadratic};

/// Memory for the solutions of the balance, for one polytope, and for the start around which it is built.
#[derive(Clone, Debug)]
pub(super) struct CentroidMethod {
    balanced: Affine,
    polytope: Polytope,
    row: Vec<f64>,
    start: Vec<f64>,
}

impl CentroidMethod {
    pub(super) fn new(cable_count: usize, dof: usize) -> Self {
        Self {
            balanced: Affine::new(cable_count, dof),
            // lost rank only adds dimensions, for which memory is then claimed
            polytope: Polytope::new(cable_count.saturating_sub(dof), 2 * cable_count),
            row: vec![0.0; cable_count],
            start: vec![0.0; cable_count],
        }
    }

    /// Moves allowed tensions to the centroid of the allowed set; they stay where they are if the set has no volume.
    /// `balanced` holds the solutions of the balance and is used up. The error is the dimension of a set with too many
    /// faces.
    fn run(&mut self, limits: &Limits, tensions: &mut [f64]) -> Result<(), usize> {
        let balanced = &mut self.balanced;
        for (cable, (least, largest)) in limits.minimum().iter().zip(limits.maximum()).enumerate() {
            if largest - least <= limits.tolerance() {
                balanced.fix(cable, *least, tensions);
            }
        }
        let dimension = balanced.dimension();
        let unit = limits.diameter();
        if dimension == 0 || !(unit > 0.0 && unit.is_finite()) {
            return Ok(());
        }
        // distances in units of the diameter: no point of the set is further away than 1
        self.polytope.begin(dimension);
        for (cable, tension) in tensions.iter().enumerate() {
            for column in 0..dimension {
                self.row[column] = balanced.column(column)[cable];
            }
            let row = &mut self.row[..dimension];
            self.polytope.add(row, (limits.maximum()[cable] - tension) / unit);
            row.iter_mut().for_each(|entry| *entry = -*entry);
            self.polytope.add(row, (tension - limits.minimum()[cable]) / unit);
        }
        let centre = match self.polytope.centroid() {
            Centroid::Found(centre) => centre,
            Centroid::NoVolume => return Ok(()),
            Centroid::TooManyFaces => return Err(dimension),
        };
        self.start.copy_from_slice(tensions);
        for (cable, tension) in tensions.iter_mut().enumerate() {
            let mut away = 0.0;
            for column in 0..dimension {
                away += centre[column] * balanced.column(column)[cable];
            }
            *tension += unit * away;
        }
        // the centroid of a set of almost no volume consists of rounding errors
        if !limits.contain(tensions, 10.0 * limits.tolerance()) {
            tensions.copy_from_slice(&self.start);
        }
        Ok(())
    }
}

impl Distribute for CentroidMethod {
    fn refine(
        &mut self,
        task: &Task<'_>,
        _qp: &mut quadratic::Solver,
        found: &mut FoundTensions<'_>,
    ) -> Result<(), InputError> {
        if *found.status != Status::Feasible {
            return Ok(());
        }
        let Problem { structure_matrix, wrench } = task.problem;
        self.balanced.load(structure_matrix, wrench)?;
        if let Err(dimension) = self.run(found.limits, found.tensions) {
            (*found.status, *found.cause) = (Status::NotFound, Cause::TooManyFaces { dimension });
        }
        Ok(())
    }

    fn derivative(&self, chosen: &Chosen<'_>) -> Written {
        let Chosen { problem, limits, tensions } = chosen;
        let found = centroid::Centroid::of(problem.structure_matrix, limits, tensions).ok_or(NoDerivative::Thin)?;
        Ok(Some(Box::new(found)))
    }
}

//! Wrench feasibility of a whole set of wrenches.

use super::cables::{check_limits, fixed_directions, length_scale, named, not_negative};
use super::{Criterion, Verdict};
use crate::WorkspaceError;
use crate::wrench_set::{Margin, Payload, RequiredSet, Zonotope, most_hyperplanes, row_lengths};
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::robot::Robot;
use cdpr_model::statics::Load;
use cdpr_model::tension::{InputError, Limits};

/// The wrenches that a task requires at a pose.
#[derive(Clone, Debug, PartialEq)]
pub enum Requirement {
    /// The load at the pose, plus every wrench of a set (rows of the structure matrix; N, N·m).
    AroundLoad(Load, RequiredSet),
    /// A payload: a range of masses, at rest (static) or in a box of accelerations (dynamic).
    Payload(Payload),
}

/// Tensions within limits balance every wrench that the task requires: the required set lies in the available wrench
/// set (Bouchard, Gosselin, Moore 2010); exact for any set.
///
/// The margin is the capacity margin (N; see [`Margin::distance`]): the radius of the largest ball that can be added to
/// every required wrench, moments divided by the length scale; if it is negative, minus the excess over the worst
/// facet.
#[derive(Clone, Debug)]
pub(crate) struct WrenchSetFeasible<'a> {
    model: &'a Model,
    limits: Limits,
    requirement: Requirement,
    row_lengths: Vec<f64>,
}

const NAME: &str = "wrench-set-feasible";

impl<'a> WrenchSetFeasible<'a> {
    /// The criterion for straight cables; the length scale (m) is the platform radius if none is given.
    pub(crate) fn new(
        model: &'a Model,
        limits: &Limits,
        requirement: Requirement,
        scale: Option<f64>,
    ) -> Result<Self, WorkspaceError> {
        check_limits(model, limits)?;
        fixed_directions(model, NAME)?;
        match &requirement {
            Requirement::AroundLoad(_, set) if !set.fits(model.dof()) => {
                return Err(InputError::NotFinite { what: "required set of wrenches" }.into());
            }
            Requirement::AroundLoad(..) => {}
            Requirement::Payload(payload) => payload.check()?,
        }
        let row_lengths = row_lengths(model, length_scale(model, NAME, scale)?);
        Ok(Self { model, limits: limits.clone(), requirement, row_lengths })
    }

    /// The criterion for a load and any further force F and moment M that share an ellipsoid,
    /// (|F|/force)² + (|M|/moment)² ≤ 1 (N, N·m).
    pub(crate) fn with_ball(
        model: &'a Model,
        limits: &Limits,
        load: &Load,
        [force, moment]: [f64; 2],
        scale: Option<f64>,
    ) -> Result<Self, WorkspaceError> {
        not_negative(NAME, "further force", force, "it is a finite force of 0 or more (N)")?;
        not_negative(NAME, "further moment", moment, "it is a finite moment of 0 or more (N·m)")?;
        let translations = model.robot().motion_pattern.translations();
        let radius = (0..model.dof()).map(|row| if row < translations { force } else { moment }).collect();
        let set = RequiredSet::Ball { center: vec![0.0; model.dof()], radius };
        Self::new(model, limits, Requirement::AroundLoad(*load, set), scale)
    }

    /// The available wrench set at a pose, or the verdict that there is none.
    pub(crate) fn available(&self, pose: &Pose) -> Result<Zonotope, Verdict> {
        let matrix = self
            .model
            .structure_matrix(pose)
            .map_err(|error| Verdict::impossible(error.to_string(), Some(error.cable() - 1)))?;
        Zonotope::available(&matrix, &self.limits, &self.row_lengths)
            .map_err(|error| Verdict::impossible(error.to_string(), None))
    }

    /// The wrenches that the task requires at a pose (rows of the structure matrix; N, N·m).
    pub(crate) fn required(&self, pose: &Pose) -> RequiredSet {
        match &self.requirement {
            Requirement::AroundLoad(load, set) => set.shifted(load.in_pattern(self.model, pose).as_slice()),
            Requirement::Payload(payload) => payload.required(self.model, pose),
        }
    }
}

impl Criterion for WrenchSetFeasible<'_> {
    fn name(&self) -> &str {
        NAME
    }

    fn unit(&self) -> &str {
        "N"
    }

    fn effort(&self) -> f64 {
        // measured with eight cables in space, which have at most 56 hyperplanes
        300.0 * (most_hyperplanes(self.model.cable_count(), self.model.dof()) / 56.0).max(1.0)
    }

    fn judge(&self, pose: &Pose) -> Verdict {
        let set = match self.available(pose) {
            Ok(set) => set,
            Err(verdict) => return verdict,
        };
        match set.margin(&self.required(pose)) {
            None => Verdict::impossible("the required wrenches are not finite at this pose", None),
            Some(margin) if margin.distance >= 0.0 => Verdict::held(margin.distance, margin.cable),
            Some(margin) => Verdict::failed(margin.distance, words(self.model.robot(), &margin), margin.cable),
        }
    }

    fn holds(&self, pose: &Pose) -> bool {
        self.available(pose).is_ok_and(|set| set.contains_set(&self.required(pose)))
    }
}

/// Text with the outermost wrench and the cables that limit the available set there.
fn words(robot: &Robot, margin: &Margin) -> String {
    let rows: Vec<String> = margin.wrench.iter().map(|row| format!("{:.1}", row + 0.0)).collect();
    let lacking = -margin.distance;
    let list = |cables: &[usize]| {
        let names: Vec<String> = cables.iter().map(|&cable| named(robot, cable)).collect();
        names.join(", ")
    };
    let facet = &margin.half_space;
    let ends = match (facet.at_largest.as_slice(), facet.at_least.as_slice()) {
        ([], []) => "no cable acts there".to_owned(),
        (most, []) => format!("with {} at the largest tension", list(most)),
        ([], least) => format!("with {} at the least tension", list(least)),
        (most, least) => format!("with {} at the largest and {} at the least tension", list(most), list(least)),
    };
    format!("the wrench [{}] lies {lacking:.1} N outside what the cables can balance, {ends}", rows.join(", "))
}

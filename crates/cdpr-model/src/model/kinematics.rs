//! The model type and its functions at one pose.

use std::sync::Arc;

use nalgebra::Vector3;

use super::CableGroup;
use super::composition::{Cables, Composition, StretchEffect};
use super::error::{ModelError, Need, require};
use super::laws;
use super::winches::winches_of;
use crate::cable::elasticity::{Elasticity, linear_elasticity};
use crate::cable::law::CableLaw;
use crate::cable::outlet::{self, Contact, Outlet};
use crate::cable::stretch::hysteresis::Memory;
use crate::cable::winch::Winch;
use crate::cable::wrench::wrench;
use crate::cable::{CableEnd, CableInput, CablePath, CableState, CableStateError, GeometryError};
use crate::geometry::{Pose, Twist};
use crate::robot::{Cable, Law, Robot, TensionPlace};
use crate::scalar::LANES;

/// A robot with chosen effects. Immutable: a changed parameter makes a new model. A clone shares its numbers.
#[derive(Clone, Debug)]
pub struct Model {
    parts: Arc<Parts>,
}

/// Robot, effects, and the numbers of the formulas that follow from them.
#[derive(Clone, Debug)]
struct Parts {
    robot: Robot,
    composition: Composition,
    twist_basis: Vec<Twist>,
    axes: Vec<Vector3<f64>>,
    groups: Vec<CableGroup>,
    elasticity: Vec<Elasticity<f64>>,
    laws: Vec<CableLaw>,
    /// Winch per cable, see [`Model::winch`].
    winches: Vec<Option<Winch>>,
}

impl Model {
    /// A model of this robot with these effects.
    pub fn new(robot: Robot, composition: Composition) -> Result<Self, ModelError> {
        if robot.cables.is_empty() {
            return Err(ModelError::NoCables { robot: robot.name });
        }
        if composition.pulley {
            for (index, cable) in robot.cables.iter().enumerate() {
                let hint = ", or place pulleys by the anchors of the point model";
                require(
                    cable.pulley_swivel_axis().is_some(),
                    Need { effect: "pulley", key: "pulley_swivel_axis", hint },
                    index,
                    cable,
                )?;
                require(
                    cable.pulley_radius().is_some(),
                    Need { effect: "pulley", key: "pulley_radius_m", hint },
                    index,
                    cable,
                )?;
            }
            check_wrap_sides(&robot)?;
        }
        let elasticity = match composition.stretch.law().filter(|law| law.effect == StretchEffect::Linear) {
            Some(linear) => elasticity_of(&robot, linear)?,
            None => vec![Elasticity::RIGID; robot.cables.len()],
        };
        let twist_basis = robot.motion_pattern.twist_basis(robot.plane);
        let axes =
            twist_basis[..robot.motion_pattern.translations()].iter().map(|t| t.fixed_rows::<3>(0).into()).collect();
        let laws = laws::laws(&robot, composition, &elasticity)?;
        let chunks = robot.cables.chunks(LANES).zip(laws.chunks(LANES)).zip(elasticity.chunks(LANES));
        let groups = chunks.map(|((cables, laws), linear)| group(cables, laws, linear)).collect();
        let winches = winches_of(&robot, composition.drum)?;
        let parts = Parts { robot, composition, twist_basis, axes, groups, elasticity, laws, winches };
        Ok(Self { parts: Arc::new(parts) })
    }

    /// The model with cables in these memories, one per cable; no effect for laws without memory.
    pub fn with_memories(&self, memories: &[Memory]) -> Self {
        let mut model = self.clone();
        for (law, memory) in Arc::make_mut(&mut model.parts).laws.iter_mut().zip(memories) {
            law.stretch = law.stretch.with_memory(memory);
        }
        model
    }

    /// Winch per cable, `None` for those without one.
    pub(super) fn winches(&self) -> &[Option<Winch>] {
        &self.parts.winches
    }

    /// The robot.
    pub fn robot(&self) -> &Robot {
        &self.parts.robot
    }

    /// The effects.
    pub fn composition(&self) -> Composition {
        self.parts.composition
    }

    /// Laws that the cables obey.
    pub fn cables(&self) -> Cables {
        self.parts.composition.cables()
    }

    /// True if controlled lengths depend on tensions, see `Composition::needs_tensions`.
    pub fn needs_tensions(&self) -> bool {
        self.parts.composition.needs_tensions()
    }

    /// Frame and platform anchors of straight cables (world, m; platform, m); `None` with pulleys or with cables that
    /// have weight.
    pub fn straight_lines(&self) -> Option<impl Iterator<Item = (&Vector3<f64>, &Vector3<f64>)>> {
        let is_straight = !self.parts.composition.pulley && self.cables().has_fixed_directions();
        is_straight.then(|| self.parts.robot.cables.iter().map(|cable| (&cable.frame_anchor, &cable.platform_anchor)))
    }

    /// Number of cables m.
    pub fn cable_count(&self) -> usize {
        self.parts.robot.cables.len()
    }

    /// Number of degrees of freedom n.
    pub fn dof(&self) -> usize {
        self.parts.twist_basis.len()
    }

    /// The n directions a pose can move in (columns of twists).
    pub fn twist_basis(&self) -> &[Twist] {
        &self.parts.twist_basis
    }

    /// World directions of the coordinates of an anchor in this pattern: e₁, e₂ of a planar robot, otherwise x, y, z.
    pub fn axes(&self) -> &[Vector3<f64>] {
        &self.parts.axes
    }

    /// Elasticity of one cable (0-based); [`Elasticity::RIGID`] in a model without the effect `elastic`.
    pub fn elasticity(&self, cable: usize) -> &Elasticity<f64> {
        &self.parts.elasticity[cable]
    }

    /// The law of one cable (0-based) with all its effects.
    pub fn law(&self, cable: usize) -> &CableLaw {
        &self.parts.laws[cable]
    }

    /// State of one cable (0-based) at rest at a pose, with one more quantity given.
    ///
    /// Does not check that its straight cable has a path ([`Model::path`] does).
    pub fn cable_state(&self, cable: usize, pose: &Pose, input: CableInput) -> Result<CableState, CableStateError> {
        self.parts.laws[cable].state(self.cable_end(cable, pose.position.into(), &pose.rotation_rows()), input)
    }

    /// End of one cable (0-based) on a platform given by position and rotation rows.
    #[inline]
    pub fn cable_end(&self, cable: usize, position: [f64; 3], rotation: &[[f64; 3]; 3]) -> CableEnd<f64> {
        CableEnd::at(position, rotation, self.parts.robot.cables[cable].platform_anchor.into())
    }

    /// A tension as the robot measures it: at the outlet, unless the file states the platform anchor.
    pub fn measured_tension(&self, cable: usize, tension: f64) -> CableInput {
        match self.parts.robot.cables[cable].tension_at {
            Some(TensionPlace::Platform) => CableInput::PlatformTension(tension),
            _ => CableInput::OutletTension(tension),
        }
    }

    /// Cables in groups of eight lanes.
    pub fn groups(&self) -> &[CableGroup] {
        &self.parts.groups
    }

    /// Outlet of one cable (0-based).
    pub fn outlet(&self, cable: usize) -> &Outlet<f64> {
        &self.parts.laws[cable].outlet
    }

    /// Path and moment arm b = R b_P of one cable (0-based) at a pose; an error if it has no path.
    pub fn path(&self, cable: usize, pose: &Pose) -> Result<(CablePath<f64>, Vector3<f64>), GeometryError> {
        let (path, end) = self.checked_path(cable, pose.position.into(), &pose.rotation_rows())?;
        Ok((path, end.moment_arm.into()))
    }

    /// Contact point of one straight cable (0-based) with its pulley at a pose, with the derivatives of free length,
    /// arc and contact point by the platform's motion (eq. 2.83–2.87), and the cable's end; an error if it has no path.
    /// Without pulleys the contact point is the frame anchor.
    pub fn contact(&self, cable: usize, pose: &Pose) -> Result<(Contact<f64>, CableEnd<f64>), GeometryError> {
        let (path, end) = self.checked_path(cable, pose.position.into(), &pose.rotation_rows())?;
        Ok((self.parts.laws[cable].outlet.contact(end.anchor, &path), end))
    }

    /// [`Model::path`] and end for a pose given by position and rotation rows, which many cables share. Inlined, so
    /// that callers that use only the length do not compute derivatives.
    #[inline(always)]
    pub fn checked_path(
        &self,
        cable: usize,
        position: [f64; 3],
        rotation: &[[f64; 3]; 3],
    ) -> Result<(CablePath<f64>, CableEnd<f64>), GeometryError> {
        let (path, end) = self.path_at(cable, position, rotation);
        match self.parts.laws[cable].outlet.degeneracy(cable + 1, end.anchor, &path) {
            Some(reason) => Err(reason),
            None => Ok((path, end)),
        }
    }

    /// [`Model::path`] without a check: its numbers are not finite if there is no path.
    pub fn path_or_nan(&self, cable: usize, pose: &Pose) -> (CablePath<f64>, Vector3<f64>) {
        let (path, end) = self.path_at(cable, pose.position.into(), &pose.rotation_rows());
        (path, end.moment_arm.into())
    }

    /// [`Model::path_or_nan`] and end for a pose given by position and rotation rows, which many cables share.
    #[inline(always)]
    pub fn path_at(
        &self,
        cable: usize,
        position: [f64; 3],
        rotation: &[[f64; 3]; 3],
    ) -> (CablePath<f64>, CableEnd<f64>) {
        let end = self.cable_end(cable, position, rotation);
        (self.parts.laws[cable].outlet.path(end.anchor), end)
    }

    /// Swivel angle of one cable's pulley at a pose, right-handed about its swivel axis from a reference direction
    /// (world), in (−π, π] (rad): the reading of an encoder at the swivel.
    ///
    /// `None` in a model without pulleys, for a pulley that does not swivel, and if the angle is not determined because
    /// the platform anchor or the reference lies on the swivel axis.
    pub fn swivel_angle(&self, cable: usize, pose: &Pose, reference: &Vector3<f64>) -> Option<f64> {
        let Outlet::Swivel { frame_anchor, swivel_axis, .. } = self.parts.laws[cable].outlet else { return None };
        let anchor = pose.transform(&self.parts.robot.cables[cable].platform_anchor);
        outlet::pulley::swivel_angle(frame_anchor, swivel_axis, (*reference).into(), anchor.into())
    }

    /// [`Model::structure_column`] for a pose given by position and rotation rows.
    pub(super) fn checked_structure_column(
        &self,
        cable: usize,
        position: [f64; 3],
        rotation: &[[f64; 3]; 3],
    ) -> Result<Twist, GeometryError> {
        let (path, end) = self.checked_path(cable, position, rotation)?;
        Ok(wrench(end.moment_arm, path.direction).into())
    }

    /// Column \[u; b × u\] of one cable (0-based; world).
    pub(super) fn structure_column(&self, cable: usize, pose: &Pose) -> Result<Twist, GeometryError> {
        let (path, moment_arm) = self.path(cable, pose)?;
        Ok(wrench(moment_arm.into(), path.direction).into())
    }

    /// Length that the robot records for the geometric length q of a rigid cable: length_scale · q + length_offset (m).
    pub fn recorded_length(&self, cable: usize, length: f64) -> f64 {
        self.parts.laws[cable].recording.length(length)
    }

    /// Controlled length q_θ for a recorded one: the inverse of [`Model::recorded_length`] (m).
    pub fn controlled_length(&self, cable: usize, recorded: f64) -> f64 {
        self.parts.laws[cable].recording.controlled_length(recorded)
    }

    /// Tension that the robot records for a true one: tension_scale · f + tension_offset (N).
    pub fn recorded_tension(&self, cable: usize, tension: f64) -> f64 {
        self.parts.laws[cable].recording.tension(tension)
    }

    /// True tension for a recorded one: the inverse of `Model::recorded_tension` (N).
    pub fn real_tension(&self, cable: usize, recorded: f64) -> f64 {
        self.parts.laws[cable].recording.real_tension(recorded)
    }

    /// Mean distance of the platform anchors from the platform origin (m), which converts angles to lengths.
    ///
    /// 1 m for a platform without extent.
    pub fn platform_radius(&self) -> f64 {
        let sum: f64 = self.parts.robot.cables.iter().map(|cable| cable.platform_anchor.norm()).sum();
        let mean = sum / self.cable_count() as f64;
        if mean > 0.0 { mean } else { 1.0 }
    }
}

/// Checks that pulleys that do not swivel belong to a planar robot, and to all of its cables or to none.
fn check_wrap_sides(robot: &Robot) -> Result<(), ModelError> {
    let with_side = |cable: &Cable| cable.pulley_wrap_side.is_some();
    let Some(first) = robot.cables.iter().position(with_side) else { return Ok(()) };
    if !robot.motion_pattern.is_planar() {
        return Err(ModelError::SpatialWrapSide { cable: first + 1, name: robot.cables[first].name.clone() });
    }
    let hint = ": the pulleys of a robot all swivel or none does";
    robot.cables.iter().enumerate().try_for_each(|(index, cable)| {
        require(with_side(cable), Need { effect: "pulley", key: "pulley_wrap_side", hint }, index, cable)
    })
}

fn elasticity_of(robot: &Robot, entry: &Law) -> Result<Vec<Elasticity<f64>>, ModelError> {
    let law = |(index, cable): (usize, &Cable)| {
        let law = linear_elasticity(cable);
        require(law.is_some(), Need { effect: entry.word, key: entry.keys[0], hint: entry.hint }, index, cable)?;
        Ok(law.unwrap_or(Elasticity::RIGID))
    };
    robot.cables.iter().enumerate().map(law).collect()
}

/// Packs up to eight cables; copies of the last one with weight 0 pad the group.
fn group(cables: &[Cable], laws: &[CableLaw], linear: &[Elasticity<f64>]) -> CableGroup {
    let at = |lane: usize| lane.min(cables.len() - 1);
    let outlets: Vec<Outlet<f64>> = laws.iter().map(|law| law.outlet).collect();
    CableGroup {
        outlet: Outlet::pack(&outlets),
        platform_anchor: [0, 1, 2].map(|axis| std::array::from_fn(|lane| cables[at(lane)].platform_anchor[axis])),
        weight: std::array::from_fn(|lane| if lane < cables.len() { 1.0 } else { 0.0 }),
        elasticity: [
            std::array::from_fn(|lane| linear[at(lane)].by_length),
            std::array::from_fn(|lane| linear[at(lane)].by_controlled_length),
            std::array::from_fn(|lane| linear[at(lane)].constant),
        ],
    }
}

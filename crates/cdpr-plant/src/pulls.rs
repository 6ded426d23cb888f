//! Pulls of all cables at a pose: geometry, tensions from the laws, and their wrench.

use cdpr_core::structure;

use super::cable_motion::CableMotion;
use super::error::StepError;
use super::plant::Plant;
use super::stage_start::Start;

use cdpr_model::cable::wrench::wrench;
use cdpr_model::cable::{CableInput, CableState};
use cdpr_model::geometry::{Pose, Twist, Wrench};
use cdpr_model::scalar::{LANES, dispatch_narrow};
use cdpr_model::statics::StaticsError;

/// Geometry and laws of all cables at a pose, in memory that is allocated once.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Pulls {
    /// True if the lengths belong to the pose.
    pub(super) is_current: bool,
    /// q (m); eight numbers per group of cables, as for the next three lists.
    pub(super) lengths: Vec<f64>,
    /// Controlled lengths of ideal winches at the end of the step (m).
    pub(super) ends: Vec<f64>,
    /// Unstrained lengths (m).
    unstrained: Vec<f64>,
    /// 1 for a whole cable, 0 for a broken one.
    whole: Vec<f64>,
    /// Tensions of linear laws (N).
    tensions: Vec<f64>,
    /// ∂f/∂q of linear laws (N/m).
    stiffnesses: Vec<f64>,
    /// Wrench of the cables if forces do not depend on speeds.
    rest: Wrench,
    /// \[u; b × u\] (world); if forces do not depend on speeds, those of an earlier pose.
    pub(super) columns: Vec<[f64; 6]>,
    /// Wrap angles on pulleys (rad); zero if no friction needs them.
    pub(super) wraps: Vec<f64>,
    /// Values of the laws at the lengths and controlled lengths.
    pub(super) laws: Vec<LawPull>,
    /// True for cables that pull at the start of a piece of a kick.
    pub(super) pulling: Vec<bool>,
    /// Drums within a step.
    pub(super) drums: Vec<DrumWork>,
    /// True if a drum has dry friction.
    pub(super) is_dry: bool,
    /// True if the motion at a pose is linear in speeds while no cable is clipped.
    pub(super) is_linear: bool,
    /// State at the start of the stages.
    pub(super) start: Start,
}

/// Work memory of a drum within a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct DrumWork {
    /// True if a brake or a stop holds it.
    pub(super) is_held: bool,
    /// Torque of its motor at the drum (N·m), positive against the cable.
    pub(super) motor: f64,
    /// Direction in which it turns or begins to turn: 1 where cable is paid out, −1 where it is reeled in.
    pub(super) direction: f64,
    /// ∂q_θ/∂φ at the pose (m/rad).
    pub(super) radius: f64,
    /// Speed at the stage of a kick (rad/s).
    pub(super) trial: f64,
    /// Acceleration at the stage of a kick (rad/s²).
    pub(super) acceleration: f64,
    /// Weighted sum of the stages' accelerations (rad/s²).
    pub(super) sum: f64,
    /// Term of the series of a kick (rad/s).
    pub(super) term: f64,
    /// Speed before a kick (rad/s).
    pub(super) before: f64,
}

/// Value of a cable's law at its lengths.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct LawPull {
    /// Tension along the column (N), continued below zero.
    pub(super) tension: f64,
    /// Tension at the outlet minus that along the column (N): the weight of a sagging cable.
    pub(super) weight: f64,
    /// d (N·s/m).
    pub(super) damping: f64,
}

impl LawPull {
    /// Value for a broken cable.
    const NONE: Self = Self { tension: 0.0, weight: 0.0, damping: 0.0 };

    /// Tension on the platform of a cable with this elongation rate (m/s): the sum of law and damper, clipped at zero
    /// (N).
    #[inline]
    pub(super) fn clipped(&self, rate: f64) -> f64 {
        (self.tension + self.damping * rate).max(0.0)
    }
}

impl Pulls {
    pub(super) fn new(cables: usize, drums: usize) -> Self {
        let padded = || vec![0.0; cables.next_multiple_of(LANES)];
        Self {
            is_current: false,
            lengths: padded(),
            ends: vec![0.0; cables],
            unstrained: padded(),
            whole: padded(),
            tensions: padded(),
            stiffnesses: padded(),
            rest: Wrench::zeros(),
            columns: vec![[0.0; 6]; cables],
            wraps: vec![0.0; cables],
            laws: vec![LawPull::NONE; cables],
            pulling: vec![false; cables],
            drums: vec![DrumWork::default(); drums],
            is_dry: false,
            is_linear: true,
            start: Start::new(cables),
        }
    }

    /// Computes lengths and directions at a pose, and the tensions of the laws.
    #[inline]
    pub(super) fn find(&mut self, plant: &Plant, pose: &Pose, cables: &mut [CableMotion]) -> Result<(), StepError> {
        if plant.sags {
            return self.find_shapes(plant, pose, cables);
        }
        let is_told_anew = self.tell(cables);
        if self.is_current && !is_told_anew {
            return Ok(());
        }
        let in_lanes = self.find_lines(plant, pose)? && plant.is_linear;
        for (index, cable) in cables.iter().enumerate() {
            self.laws[index] = match in_lanes {
                true => plant.linear_pull(index, cable, (self.tensions[index], self.stiffnesses[index])),
                false => plant.law_pull(index, cable, self.lengths[index]),
            };
        }
        if plant.asks_wraps {
            self.find_wraps(plant, pose)?;
        }
        if !in_lanes {
            self.rest = self.wrench(&Twist::zeros(), |_| 0.0);
        }
        self.is_current = true;
        Ok(())
    }

    /// Copies unstrained lengths and the flags of whole cables; true if any differs.
    #[inline]
    fn tell(&mut self, cables: &[CableMotion]) -> bool {
        let mut differs = false;
        for (index, cable) in cables.iter().enumerate() {
            let (length, whole) = (cable.unstrained_length(), if cable.is_broken { 0.0 } else { 1.0 });
            differs |= self.unstrained[index] != length || self.whole[index] != whole;
            (self.unstrained[index], self.whole[index]) = (length, whole);
        }
        differs
    }

    /// Computes lengths and columns; true if the tensions of linear laws were computed too.
    #[inline]
    fn find_lines(&mut self, plant: &Plant, pose: &Pose) -> Result<bool, StepError> {
        let (position, rotation) = (pose.position.into(), pose.rotation_rows());
        let asked = if plant.asks_columns { self.columns.len() } else { 0 };
        let kernel = structure::Pulls {
            groups: plant.model.groups(),
            position,
            rotation: &rotation,
            unstrained: &self.unstrained,
            whole: &self.whole,
            lengths: &mut self.lengths,
            tensions: &mut self.tensions,
            stiffnesses: &mut self.stiffnesses,
            columns: &mut self.columns[..asked],
        };
        if let Some(wrench) = dispatch_narrow(kernel) {
            self.rest = wrench;
            return Ok(true);
        }
        for cable in 0..plant.model.cable_count() {
            let found = plant.model.checked_path(cable, position, &rotation);
            let (path, end) = found.map_err(StaticsError::from)?;
            self.lengths[cable] = path.length;
            self.columns[cable] = wrench(end.moment_arm, path.direction);
        }
        Ok(false)
    }

    /// Computes the wrap angles of straight cables.
    fn find_wraps(&mut self, plant: &Plant, pose: &Pose) -> Result<(), StepError> {
        let (position, rotation) = (pose.position.into(), pose.rotation_rows());
        for (cable, wrap) in self.wraps.iter_mut().enumerate() {
            *wrap = plant.model.checked_path(cable, position, &rotation).map_err(StaticsError::from)?.0.wrap_angle;
        }
        Ok(())
    }

    /// Computes cables with weight, each from its last shape.
    fn find_shapes(&mut self, plant: &Plant, pose: &Pose, cables: &mut [CableMotion]) -> Result<(), StepError> {
        let (position, rotation) = (pose.position.into(), pose.rotation_rows());
        for (index, cable) in cables.iter_mut().enumerate() {
            if cable.is_broken {
                (self.columns[index], self.laws[index]) = ([0.0; 6], LawPull::NONE);
                continue;
            }
            let (path, end) = plant.model.checked_path(index, position, &rotation).map_err(StaticsError::from)?;
            let (law, input) = (plant.model.law(index), CableInput::ControlledLength(cable.unstrained_length()));
            let found = match &cable.memory {
                Some(memory) => law.with_memory(memory).state_on(&path, &end, input, cable.span),
                None => law.state_on(&path, &end, input, cable.span),
            };
            let state: CableState = found.map_err(|reason| StaticsError::of_cable(index, path.length, reason))?;
            cable.span = Some(state.span);
            (self.lengths[index], self.wraps[index]) = (state.strained_length, state.wrap_angle);
            self.columns[index] = wrench(end.moment_arm, state.direction);
            let stiffness = state.tangent.map(|row| cdpr_model::scalar::dot(row, state.direction));
            self.laws[index] = LawPull {
                tension: state.platform_tension,
                weight: state.outlet_tension - state.platform_tension,
                damping: plant.damping[index].coefficient(-cdpr_model::scalar::dot(stiffness, state.direction)),
            };
        }
        self.rest = self.wrench(&Twist::zeros(), |_| 0.0);
        self.is_current = true;
        Ok(())
    }

    /// Wrench of all cables on a platform with a twist (N, N·m).
    #[inline]
    pub(super) fn wrench(&self, twist: &Twist, rates: impl Fn(usize) -> f64) -> Wrench {
        let mut sum = Wrench::zeros();
        for (index, (law, column)) in self.laws.iter().zip(&self.columns).enumerate() {
            let tension = law.clipped(elongation_rate(column, twist) - rates(index));
            for row in 0..6 {
                sum[row] += tension * column[row];
            }
        }
        sum
    }

    /// Wrench of all cables if forces do not depend on speeds (N, N·m).
    #[inline]
    pub(super) fn wrench_at_rest(&self) -> Wrench {
        self.rest
    }
}

/// q̇ = −\[u; b × u\]·\[v; ω\] (m/s): the involute property holds over pulleys too.
#[inline]
pub(super) fn elongation_rate(column: &[f64; 6], twist: &Twist) -> f64 {
    -(0..6).map(|row| column[row] * twist[row]).sum::<f64>()
}

impl Plant {
    /// Value of the law of one straight, linear cable from its tension (N) and stiffness (N/m).
    #[inline]
    fn linear_pull(&self, index: usize, cable: &CableMotion, (tension, stiffness): (f64, f64)) -> LawPull {
        if cable.is_broken {
            return LawPull::NONE;
        }
        LawPull { tension, weight: 0.0, damping: self.damping[index].coefficient(stiffness) }
    }

    /// Value of the law of one straight cable at a geometric length (m).
    #[inline]
    fn law_pull(&self, index: usize, cable: &CableMotion, length: f64) -> LawPull {
        if cable.is_broken {
            return LawPull::NONE;
        }
        let tension = self.model.law(index).continued_tension(length, cable.unstrained_length(), cable.memory.as_ref());
        match tension {
            Some(tension) => LawPull {
                tension: tension.value,
                weight: 0.0,
                damping: self.damping[index].coefficient(tension.by_length),
            },
            // refused when a plant is made
            None => LawPull::NONE,
        }
    }
}

//! Kicks: the effect of forces at a fixed pose on the speeds of platform and drums.
//!
//! While no cable is clipped and friction does not fall with speed, the speeds y at a fixed pose obey ẏ = a − K y: after a time t they are
//! y + t φ₁(−t K)(a − K y), φ₁(z) = (eᶻ − 1)/z. Its series is applied to the vector, so that dampers of all cables act together, coupled through the
//! platform. K is symmetric in the product of kinetic energy, in which the terms shrink by less than t ‖K‖/k: the series ends where a term is
//! [`REMAINDER`] of the first one, and kicks whose series is long are cut into pieces. Other kicks follow the classical Runge–Kutta rule.

use nalgebra::{Matrix3, Matrix6, Vector3};

use super::cable_motion::CableMotion;
use super::error::StepError;
use super::momentum::{Inertia, Momentum};
use super::plant::Plant;
use super::pulls::elongation_rate;
use super::state::PlantState;
use cdpr_model::geometry::{Pose, Twist, Wrench};

/// Remainder of a series, as a share of the change of the speeds (norm of kinetic energy).
const REMAINDER: f64 = 1e-12;

/// Most terms of a series: enough for t ‖K‖ = 1.
const TERMS: u32 = 16;

/// Most pieces of a kick.
const PIECES: u32 = 64;

impl Plant {
    /// Applies the forces at the pose for a time (s).
    #[inline]
    pub(super) fn kick(&self, state: &mut PlantState, time: f64) -> Result<(), StepError> {
        state.pulls.find(self, &state.pose, &mut state.cables)?;
        let load = state.load(self);
        if self.drums.is_empty() && !self.dissipates {
            let center = state.inertia.center(&state.pose);
            let rate = state.inertia.rate(&center, &(state.pulls.wrench_at_rest() + load));
            state.momentum = added(&state.momentum, &rate, time);
            return Ok(());
        }
        if !self.drums.is_empty() {
            self.look_at_drums(state)?;
        }
        if state.pulls.is_linear && self.kick_by_series(state, &load, time) {
            return Ok(());
        }
        match self.drums.is_empty() {
            true => self.kick_by_stages(state, &load, time),
            false => self.kick_drums_by_stages(state, &load, time),
        }
        Ok(())
    }

    /// The kick of platform and ideal winches by the classical Runge–Kutta rule.
    fn kick_by_stages(&self, state: &mut PlantState, load: &Wrench, time: f64) {
        let center = state.inertia.center(&state.pose);
        let (pulls, cables, inertia) = (&state.pulls, &state.cables, &state.inertia);
        let rate = |momentum: &Momentum| {
            let twist = inertia.twist(&state.pose, momentum);
            let wrench = pulls.wrench(&twist, |cable| cables[cable].controlled_length_rate) + load;
            inertia.rate(&center, &(wrench + inertia.drag(&twist)))
        };
        let start = state.momentum;
        let first = rate(&start);
        let second = rate(&added(&start, &first, 0.5 * time));
        let third = rate(&added(&start, &second, 0.5 * time));
        let fourth = rate(&added(&start, &third, time));
        let sum = added(&added(&first, &second, 2.0), &added(&fourth, &third, 2.0), 1.0);
        state.momentum = added(&start, &sum, time / 6.0);
    }

    /// The kick by its series. False, with the speeds as they were, where a cable is clipped on the way or too many pieces are needed.
    fn kick_by_series(&self, state: &mut PlantState, load: &Wrench, time: f64) -> bool {
        let (start, body) = (state.momentum, Frozen::of(&state.inertia, &state.pose));
        for (work, cable) in state.pulls.drums.iter_mut().zip(&state.cables) {
            work.before = cable.drum_speed;
        }
        let mut pieces = 1;
        while pieces <= PIECES {
            let time = time / f64::from(pieces);
            let ended = (0..pieces).map(|_| self.piece(state, (load, &body), time)).find(|end| *end != Piece::Done);
            if ended.is_none() {
                return true;
            }
            state.momentum = start;
            for (cable, work) in state.cables.iter_mut().zip(&state.pulls.drums) {
                (cable.drum_speed, cable.controlled_length_rate) = (work.before, work.radius * work.before);
            }
            if ended == Some(Piece::Clipped) {
                return false;
            }
            pieces *= 4;
        }
        false
    }

    /// A piece of a kick by its series.
    fn piece(&self, state: &mut PlantState, (load, body): (&Wrench, &Frozen), time: f64) -> Piece {
        let twist = body.twist(&state.momentum);
        let (wrench, spread) = match self.drums.is_empty() {
            true => self.pull(state, &twist),
            false => (self.pull_with_drums(state, &twist), None),
        };
        let mut term = body.rate(&(wrench + load + body.inertia.drag(&twist)), time);
        state.pulls.drums.iter_mut().for_each(|work| {
            work.term = work.acceleration * time;
            work.sum = work.term;
        });
        let (mut sum, mut first) = (term, 0.0);
        for count in 1..=TERMS {
            let twist = body.twist(&term);
            let energy = body.energy(&term, &twist) + self.energy_of_drums(state);
            if count == 1 {
                first = energy;
            }
            if energy <= REMAINDER * REMAINDER * first {
                state.momentum = added(&state.momentum, &sum, 1.0);
                for (cable, work) in state.cables.iter_mut().zip(&state.pulls.drums) {
                    cable.drum_speed += work.sum;
                    cable.controlled_length_rate = work.radius * cable.drum_speed;
                }
                return if self.keeps_sides(state, body) { Piece::Done } else { Piece::Clipped };
            }
            let time = time / f64::from(count + 1);
            let wrench = match &spread {
                Some(spread) => body.inertia.drag(&twist) - spread * twist,
                None => body.inertia.drag(&twist) + self.damp_with_drums(state, &twist, time),
            };
            term = body.rate(&wrench, time);
            sum = added(&sum, &term, 1.0);
        }
        Piece::Long
    }

    /// Wrench of the cables on a platform with a twist (N, N·m), and by how much of another twist it falls while the same cables pull.
    #[inline]
    fn pull(&self, state: &mut PlantState, twist: &Twist) -> (Wrench, Option<Matrix6<f64>>) {
        let (mut wrench, mut spread) = (Wrench::zeros(), Matrix6::zeros());
        let pulls = &mut state.pulls;
        for (index, (law, column)) in pulls.laws.iter().zip(&pulls.columns).enumerate() {
            let rate = elongation_rate(column, twist) - state.cables[index].controlled_length_rate;
            let tension = law.tension + law.damping * rate;
            pulls.pulling[index] = tension > 0.0;
            if tension > 0.0 {
                (0..6).for_each(|row| wrench[row] += tension * column[row]);
                for across in 0..6 {
                    let damping = law.damping * column[across];
                    (0..6).for_each(|row| spread[(row, across)] += damping * column[row]);
                }
            }
        }
        (wrench, Some(spread))
    }

    /// Wrench of the cables on a platform with a twist (N, N·m); the accelerations of the drums are stored in the state's work memory.
    #[inline]
    fn pull_with_drums(&self, state: &mut PlantState, twist: &Twist) -> Wrench {
        state.pulls.drums.iter_mut().for_each(|work| work.acceleration = 0.0);
        let wrench = self.accelerate(state, twist, 0.0);
        let pulls = &mut state.pulls;
        for index in 0..self.drums.len() {
            let rate = elongation_rate(&pulls.columns[index], twist) - state.cables[index].controlled_length_rate;
            pulls.pulling[index] = pulls.laws[index].tension + pulls.laws[index].damping * rate > 0.0;
        }
        wrench
    }

    /// Change of the wrench of the cables (N, N·m) by a change of the speeds, of the platform by a twist and of the drums by their terms, and the
    /// next terms of the drums: their accelerations by it times a time (s).
    #[inline]
    fn damp_with_drums(&self, state: &mut PlantState, twist: &Twist, time: f64) -> Wrench {
        let (mut wrench, pulls) = (Wrench::zeros(), &mut state.pulls);
        for (index, drum) in self.drums.iter().enumerate() {
            let (law, column, work) = (&pulls.laws[index], &pulls.columns[index], &mut pulls.drums[index]);
            let friction = &state.friction[index];
            let mut pull = 0.0;
            if pulls.pulling[index] && law.damping != 0.0 {
                pull = law.damping * (elongation_rate(column, twist) - work.radius * work.term);
                (0..6).for_each(|row| wrench[row] += pull * column[row]);
            }
            if state.cables[index].is_stuck {
                continue;
            }
            let driven = work.radius * pull * friction.passed_on(pulls.wraps[index], work.direction);
            work.term = (driven - friction.viscous * work.term) / drum.inertia * time;
            work.sum += work.term;
        }
        wrench
    }

    /// Energy of the drums at the speeds of a term (J).
    #[inline]
    fn energy_of_drums(&self, state: &PlantState) -> f64 {
        self.drums.iter().zip(&state.pulls.drums).map(|(drum, work)| 0.5 * drum.inertia * work.term * work.term).sum()
    }

    /// True if the same cables pull at the present speeds as did at the start of the piece.
    #[inline]
    fn keeps_sides(&self, state: &PlantState, body: &Frozen) -> bool {
        let (twist, pulls) = (body.twist(&state.momentum), &state.pulls);
        let keeps = |(index, cable): (usize, &CableMotion)| {
            let law = &pulls.laws[index];
            let rate = elongation_rate(&pulls.columns[index], &twist) - cable.controlled_length_rate;
            law.damping == 0.0 || (law.tension + law.damping * rate > 0.0) == pulls.pulling[index]
        };
        state.cables.iter().enumerate().all(keeps)
    }
}

/// How a piece of a kick ended.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Piece {
    Done,
    /// Its series has too many terms.
    Long,
    /// A cable began or ceased to pull.
    Clipped,
}

/// A body at a fixed pose.
struct Frozen {
    inertia: Inertia,
    /// R I_c⁻¹ Rᵀ.
    inverse_inertia: Matrix3<f64>,
    inverse_mass: f64,
    /// From the platform origin to the centre of mass (world, m).
    center: Vector3<f64>,
}

impl Frozen {
    #[inline]
    fn of(inertia: &Inertia, pose: &Pose) -> Self {
        let (center, inverse_mass) = (inertia.center(pose), 1.0 / inertia.body.mass);
        Self { inertia: *inertia, inverse_inertia: inertia.inverse_inertia_at(pose), inverse_mass, center }
    }

    /// Twist of the platform origin (world axes).
    #[inline]
    fn twist(&self, momentum: &Momentum) -> Twist {
        let omega = self.inverse_inertia * momentum.angular;
        let v = momentum.linear * self.inverse_mass - omega.cross(&self.center);
        Twist::new(v.x, v.y, v.z, omega.x, omega.y, omega.z)
    }

    /// Change of the momentum by a wrench during a time (s).
    #[inline]
    fn rate(&self, wrench: &Wrench, time: f64) -> Momentum {
        let rate = self.inertia.rate(&self.center, wrench);
        Momentum { linear: rate.linear * time, angular: rate.angular * time }
    }

    /// Kinetic energy (J) of a momentum and its twist.
    #[inline]
    fn energy(&self, momentum: &Momentum, twist: &Twist) -> f64 {
        let turning = (0..3).map(|k| momentum.angular[k] * twist[3 + k]).sum::<f64>();
        0.5 * (momentum.linear.norm_squared() * self.inverse_mass + turning)
    }
}

/// a + s b.
#[inline]
pub(super) fn added(a: &Momentum, b: &Momentum, fraction: f64) -> Momentum {
    Momentum { linear: a.linear + b.linear * fraction, angular: a.angular + b.angular * fraction }
}

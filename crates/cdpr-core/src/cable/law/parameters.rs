//! Derivatives of a cable at given tension by its own parameters.

use super::matrix4::Matrix4;
use super::{CableLaw, Kind};
use crate::cable::elasticity::StiffnessBasis;
use crate::cable::span::{Change, Shape};
use crate::cable::state::CableState;
use crate::cable::stretch::Stretch;
use crate::cable::stretch::hysteresis::Motion;
use crate::scalar::{add, cross, dot, rotate, scale, sub};

/// A parameter of one cable other than its anchors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LawParameter {
    /// r_p (m).
    PulleyRadius,
    /// Turn of the pulley with its swivel axis about its entry D, along this rotation vector (world, rad).
    PulleyTurn([f64; 3]),
    /// κ = 1/EA of a linear law (1/N).
    Compliance,
    /// q_h (m).
    HiddenLength,
    /// Weight per unstrained length of a cable that sags: change of it per unit of the parameter (world, N/m per unit), gravity for a linear density.
    Weight([f64; 3]),
    /// Parameter of the law of stretch with this index, counted from 0.
    Stretch(usize),
}

/// Change of a cable per unit of a parameter, at fixed platform anchor and tension at the outlet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LawChange {
    /// Derivative of the pull on the platform (N per unit).
    pub pull: [f64; 3],
    /// Derivative of q_θ (m per unit).
    pub controlled_length: f64,
}

impl CableLaw {
    /// Derivative of a cable's state by a parameter; zero for one that the law does not have.
    pub fn by_parameter(&self, state: &CableState, parameter: LawParameter) -> LawChange {
        let length_change = |controlled_length| LawChange { pull: [0.0; 3], controlled_length };
        match (self.kind, parameter) {
            (Kind::Sagging(shape), _) => {
                let path = self.path(state.end.anchor);
                let side = Self::chord(&path).map_or(1.0, |chord| chord.side);
                let evaluation = self.evaluate(shape, &state.span, side);
                let (end, length) = self.sagging_change(shape, state, parameter, side);
                let change = self.held_change(state, &evaluation.by_state, end, length);
                match parameter {
                    // the platform carries the weight's whole length less
                    LawParameter::Weight(weight) => {
                        LawChange { pull: add(change.pull, scale(state.span.length, weight)), ..change }
                    }
                    _ => change,
                }
            }
            (_, LawParameter::PulleyRadius) => match self.outlet.pulley() {
                Some(_) => {
                    let path = self.path(state.end.anchor);
                    let by_length = self.length(path.length, state.outlet_tension).by_length;
                    LawChange {
                        pull: scale(state.outlet_tension, path.direction_by_radius),
                        controlled_length: by_length * path.length_by_radius,
                    }
                }
                None => length_change(0.0),
            },
            (_, LawParameter::PulleyTurn(turn)) => {
                let path = self.path(state.end.anchor);
                let by_length = self.length(path.length, state.outlet_tension).by_length;
                // turning the pulley equals turning the platform anchor the other way about D, then the result back
                let moved = cross(turn, sub(state.end.anchor, *self.outlet.frame_anchor()));
                let direction = sub(cross(turn, path.direction), rotate(&path.direction_gradient, moved));
                LawChange {
                    pull: scale(state.outlet_tension, direction),
                    controlled_length: by_length * dot(path.direction, moved),
                }
            }
            (Kind::Linear(law, Some(basis)), _) => {
                let controlled = law.controlled_length_gradient(
                    state.strained_length,
                    state.outlet_tension,
                    self.hidden_length,
                    law.by_length + law.by_controlled_length,
                    basis == StiffnessBasis::Unstrained,
                );
                length_change(match parameter {
                    LawParameter::Compliance => controlled.by_compliance,
                    LawParameter::HiddenLength => controlled.by_hidden_length,
                    _ => 0.0,
                })
            }
            (Kind::Stretching, LawParameter::HiddenLength) => {
                let (strain, _) = self.stretch.strain(state.outlet_tension);
                length_change(1.0 / (1.0 + strain) - 1.0)
            }
            (Kind::Stretching, LawParameter::Stretch(number)) => {
                let (strain, _) = self.stretch.strain(state.outlet_tension);
                let by_number = self.stretch.strain_by_number(state.outlet_tension, number);
                length_change(-(state.controlled_length + self.hidden_length) / (1.0 + strain) * by_number)
            }
            (Kind::Rigid | Kind::Linear(..) | Kind::Stretching, _) => length_change(0.0),
        }
    }

    /// The linearized motion of a straight cable with a memory to its state, and ∂q_θ/∂ε at its end at fixed tension
    /// (m); `None` for other cables.
    pub fn motion(&self, state: &CableState) -> Option<(Motion, f64)> {
        let (Stretch::Hysteresis(law, memory), Kind::Stretching) = (&self.stretch, self.kind) else { return None };
        let motion = law.motion(state.outlet_tension, memory);
        Some((motion, -(state.controlled_length + self.hidden_length) / (1.0 + motion.strain)))
    }

    /// Changes of the end (m) and of the controlled length (m) per unit of a parameter, at a fixed state.
    fn sagging_change(&self, shape: Shape, cable: &CableState, parameter: LawParameter, side: f64) -> ([f64; 3], f64) {
        let state = &cable.span;
        let frame = self.frame_end(state, side);
        let ratio = frame.ratio;
        match (parameter, &frame.outlet) {
            (LawParameter::PulleyRadius, Some((pulley, outlet))) => {
                let (contact, wrapped) = outlet.by_radius(pulley);
                (contact, ratio * wrapped)
            }
            (LawParameter::PulleyTurn(turn), Some((pulley, outlet))) => {
                let against = scale(-1.0 / cable.outlet_tension, cross(turn, state.force));
                let (contact, wrapped) = outlet.derivative(pulley, against);
                (add(cross(turn, outlet.contact), contact), ratio * pulley.radius * wrapped)
            }
            (LawParameter::PulleyRadius | LawParameter::PulleyTurn(_), None) => ([0.0; 3], 0.0),
            (LawParameter::Compliance, _) if !matches!(self.stretch, Stretch::Linear(_)) => ([0.0; 3], 0.0),
            (LawParameter::Compliance, _) => {
                // ∫ τ ds, for finite elements too
                let middle = add(state.force, scale(-0.5 * state.length, self.weight));
                (scale(state.length, middle), -frame.outside * ratio * ratio * cable.outlet_tension)
            }
            (LawParameter::HiddenLength, _) => ([0.0; 3], ratio - 1.0),
            (LawParameter::Weight(weight), _) => {
                let (_, [end]) =
                    shape.with_derivatives(state, self.weight, &self.stretch, &[Change::of_weight(weight)]);
                (end, 0.0)
            }
            (LawParameter::Stretch(number), _) => {
                let by_number = self.stretch.strain_by_number(cable.outlet_tension, number);
                let end = shape.by_stretch_number(state, self.weight, &self.stretch, number);
                (end, -frame.outside * ratio * ratio * by_number)
            }
        }
    }

    /// Change of pull and controlled length when the state adjusts so that the end and the outlet tension stay; `end`
    /// (m) and `length` (m) are the changes at fixed state.
    fn held_change(&self, cable: &CableState, by_state: &Matrix4, end: [f64; 3], length: f64) -> LawChange {
        let [x, y, z] = scale(1.0 / cable.outlet_tension, cable.span.force);
        let mut rows = *by_state;
        let length_row = rows.0[3];
        rows.0[3] = [x, y, z, 0.0];
        let state = rows.solve([[-end[0]], [-end[1]], [-end[2]], [0.0]]).map(|[entry]| entry);
        let pull = add(scale(-1.0, [state[0], state[1], state[2]]), scale(state[3], self.weight));
        let by_state: f64 = length_row.iter().zip(state).map(|(by, change)| by * change).sum();
        LawChange { pull, controlled_length: length + by_state }
    }
}

//! How a cable at given tension changes with its own parameters.

use super::solve::Matrix4;
use super::{CableLaw, Hold, Kind};
use crate::cable::stretch::Stretch;
use crate::scalar::{add, dot, scale};

/// A parameter of one cable, beside its anchors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LawParameter {
    /// r_p (m).
    PulleyRadius,
    /// κ = 1/EA of a linear law (1/N).
    Compliance,
    /// q_h (m).
    HiddenLength,
}

/// Change of a cable per unit of a parameter, at fixed platform anchor and tension at the outlet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LawChange {
    /// Of the pull on the platform (N per unit).
    pub pull: [f64; 3],
    /// Of q_θ (m per unit).
    pub controlled_length: f64,
}

impl CableLaw {
    /// Derivative of a hold at this platform anchor by a parameter; zero for one that the law does not have, and for compliance and
    /// hidden length of a linear law, which has its own ([`crate::cable::elasticity::Elasticity::controlled_length_gradient`]).
    pub fn by_parameter(&self, hold: &Hold, platform_anchor: [f64; 3], parameter: LawParameter) -> LawChange {
        let tension = hold.outlet_tension;
        match self.kind {
            Kind::Sagging(shape) => {
                let side = self.chord(platform_anchor).map_or(1.0, |chord| chord.side);
                let evaluation = self.evaluate(shape, &hold.state, side);
                let (end, length) = self.sagging_change(hold, parameter, side);
                self.held_change(hold, &evaluation.by_state, end, length)
            }
            _ => match (parameter, self.outlet.pulley()) {
                (LawParameter::PulleyRadius, Some(_)) => {
                    let course = self.course(platform_anchor);
                    LawChange {
                        pull: scale(tension, course.direction_by_radius),
                        controlled_length: self.length(course.length, tension).by_length * course.length_by_radius,
                    }
                }
                (LawParameter::HiddenLength, _) if self.kind == Kind::Stretching => {
                    let (strain, _) = self.stretch.strain(tension);
                    LawChange { pull: [0.0; 3], controlled_length: 1.0 / (1.0 + strain) - 1.0 }
                }
                _ => LawChange { pull: [0.0; 3], controlled_length: 0.0 },
            },
        }
    }

    /// Changes of end and controlled length at a fixed state.
    fn sagging_change(&self, hold: &Hold, parameter: LawParameter, side: f64) -> ([f64; 3], f64) {
        let state = &hold.state;
        let frame = self.frame_end(state, side);
        let ratio = frame.ratio;
        match (parameter, &frame.outlet) {
            (LawParameter::PulleyRadius, Some((pulley, outlet))) => {
                let (contact, wrapped) = outlet.by_radius(pulley);
                (contact, ratio * wrapped)
            }
            (LawParameter::PulleyRadius, None) => ([0.0; 3], 0.0),
            (LawParameter::Compliance, _) if !matches!(self.stretch, Stretch::Linear(_)) => ([0.0; 3], 0.0),
            (LawParameter::Compliance, _) => {
                // ∫ τ ds, of elements too
                let middle = add(state.force, scale(-0.5 * state.length, self.weight));
                (scale(state.length, middle), -frame.outside * ratio * ratio * hold.outlet_tension)
            }
            (LawParameter::HiddenLength, _) => ([0.0; 3], ratio - 1.0),
        }
    }

    /// What the state does so that end and tension stay.
    fn held_change(&self, hold: &Hold, by_state: &Matrix4, end: [f64; 3], length: f64) -> LawChange {
        let [x, y, z] = scale(1.0 / hold.outlet_tension, hold.state.force);
        let mut rows = *by_state;
        let length_row = rows.0[3];
        rows.0[3] = [x, y, z, 0.0];
        let state = rows.solve([[-end[0]], [-end[1]], [-end[2]], [0.0]]).map(|[entry]| entry);
        let pull = add(scale(-1.0, [state[0], state[1], state[2]]), scale(state[3], self.weight));
        let by_state: f64 = length_row.iter().zip(state).map(|(by, change)| by * change).sum();
        LawChange { pull, controlled_length: length + by_state }
    }
}

/// Change of the tension at the outlet that keeps the tension at the platform when the pull changes at fixed outlet tension.
pub(crate) fn outlet_change(hold: &Hold, pull: [f64; 3]) -> f64 {
    -dot(hold.direction, pull) / dot(hold.direction, hold.by_tension)
}

//! The equations of a cable with weight, and their derivatives by its state.

use super::CableLaw;
use super::solve::Matrix4;
use crate::cable::outlet::bent::{self, Outlet, Pulley};
use crate::cable::span::{Change, Shape, State};
use crate::scalar::{add, dot, scale, sub};

/// A state put into the equations.
#[derive(Clone, Copy, Debug)]
pub(super) struct Evaluation {
    /// C + S, where the end comes to lie (world, m).
    pub(super) end: [f64; 3],
    /// q_θ (m).
    pub(super) controlled_length: f64,
    /// τ(L), minus the pull on the platform (N).
    pub(super) end_force: [f64; 3],
    /// Wrap angle (rad).
    pub(super) wrap_angle: f64,
    /// Rows: end, q_θ; columns: F, L.
    pub(super) by_state: Matrix4,
}

/// Change of end and controlled length along a change of state or parameter.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moved {
    pub(super) end: [f64; 3],
    pub(super) controlled_length: f64,
}

impl CableLaw {
    /// The pulley as the cable meets it on this side of the axis.
    pub(super) fn bent_pulley(&self, side: f64) -> Option<Pulley<f64>> {
        self.pulley.map(|(swivel_axis, radius)| Pulley { swivel_axis, radius, side })
    }

    /// The equations at a state; `side` tells on which side of the swivel axis the cable leaves.
    pub(super) fn evaluate(&self, shape: Shape, state: &State<f64>, side: f64) -> Evaluation {
        let tension = dot(state.force, state.force).sqrt();
        let direction = scale(1.0 / tension, state.force);
        let pulley = self.bent_pulley(side);
        let outlet = pulley.map(|pulley| (pulley, bent::outlet(&pulley, direction)));
        let (contact, wrap_angle) = outlet.map_or(([0.0; 3], 0.0), |(_, outlet)| (outlet.contact, outlet.wrap_angle));
        let wrapped = self.pulley.map_or(0.0, |(_, radius)| radius * wrap_angle);
        let (strain, _) = self.stretch.strain(tension);
        let outside = wrapped + self.hidden_length - self.series_compliance * tension;
        let contact = add(self.frame_anchor, contact);
        let (span, columns) = shape.with_derivatives(state, self.weight, &self.stretch, &Change::OF_STATE);
        let by_state = Matrix4::of_columns(std::array::from_fn(|index| {
            let moved = self.moved(state, outlet.as_ref(), &Change::OF_STATE[index], columns[index]);
            let [x, y, z] = moved.end;
            [x, y, z, moved.controlled_length]
        }));
        Evaluation {
            end: add(contact, span),
            controlled_length: state.length + outside / (1.0 + strain) - self.hidden_length,
            end_force: sub(state.force, scale(state.length, self.weight)),
            wrap_angle,
            by_state,
        }
    }

    /// How end and controlled length move along a change of state or weight that moves the span by this.
    #[inline(always)]
    pub(super) fn moved(
        &self,
        state: &State<f64>,
        outlet: Option<&(Pulley<f64>, Outlet<f64>)>,
        change: &Change,
        span: [f64; 3],
    ) -> Moved {
        let tension = dot(state.force, state.force).sqrt();
        let t = scale(1.0 / tension, state.force);
        let d_tension = dot(t, change.force);
        let turned = scale(1.0 / tension, sub(change.force, scale(d_tension, t)));
        let (d_contact, d_wrap) = outlet.map_or(([0.0; 3], 0.0), |(pulley, outlet)| outlet.derivative(pulley, turned));
        let (radius, wrap) = outlet.map_or((0.0, 0.0), |(pulley, outlet)| (pulley.radius, outlet.wrap_angle));
        let (strain, slope) = self.stretch.strain(tension);
        let ratio = 1.0 / (1.0 + strain);
        let outside = radius * wrap + self.hidden_length - self.series_compliance * tension;
        let d_outside = radius * d_wrap - self.series_compliance * d_tension;
        Moved {
            end: add(d_contact, span),
            controlled_length: change.length + ratio * (d_outside - outside * ratio * slope * d_tension),
        }
    }
}

//! The equations of a cable with weight, and their derivatives by its state.

#[cfg(not(feature = "std"))]
use num_traits::Float as _;

use super::CableLaw;
use super::matrix4::Matrix4;
use crate::cable::outlet::bent::{self, Outlet, Pulley};
use crate::cable::span::{Change, Shape, SpanState};
use crate::scalar::{add, dot, scale, sub};

/// The equations evaluated at a state.
#[derive(Clone, Copy, Debug)]
pub(super) struct Evaluation {
    /// C + S, the position of the cable's end (world, m).
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
    /// The pulley of this cable, which leaves on `side` of the swivel axis; `None` if it has a point outlet.
    pub(super) fn bent_pulley(&self, side: f64) -> Option<Pulley<f64>> {
        self.outlet.pulley().map(|(&swivel_axis, &radius)| Pulley { swivel_axis, radius, side })
    }

    /// Tension, direction, outlet and strain at the frame's end in a state; the cable leaves on `side` of the swivel
    /// axis.
    pub(super) fn frame_end(&self, state: &SpanState<f64>, side: f64) -> FrameEnd {
        let tension = dot(state.force, state.force).sqrt();
        let direction = scale(1.0 / tension, state.force);
        let outlet = self.bent_pulley(side).map(|pulley| (pulley, bent::outlet(&pulley, direction)));
        let wrapped = outlet.map_or(0.0, |(pulley, outlet)| pulley.radius * outlet.wrap_angle);
        let (strain, slope) = self.stretch.strain(tension);
        let outside = wrapped + self.hidden_length - self.series_compliance * tension;
        FrameEnd { tension, direction, outlet, outside, ratio: 1.0 / (1.0 + strain), slope }
    }

    /// Evaluates the equations at a state; `side` as in [`Self::frame_end`].
    pub(super) fn evaluate(&self, shape: Shape, state: &SpanState<f64>, side: f64) -> Evaluation {
        let frame = self.frame_end(state, side);
        let (contact, wrap_angle) =
            frame.outlet.map_or(([0.0; 3], 0.0), |(_, outlet)| (outlet.contact, outlet.wrap_angle));
        let (span, columns) = shape.with_derivatives(state, self.weight, &self.stretch, &Change::OF_STATE);
        let by_state = Matrix4::of_columns(core::array::from_fn(|index| {
            let moved = self.moved(&frame, &Change::OF_STATE[index], columns[index]);
            let [x, y, z] = moved.end;
            [x, y, z, moved.controlled_length]
        }));
        Evaluation {
            end: add(add(*self.outlet.frame_anchor(), contact), span),
            controlled_length: state.length + frame.outside * frame.ratio - self.hidden_length,
            end_force: sub(state.force, scale(state.length, self.weight)),
            wrap_angle,
            by_state,
        }
    }

    /// Change of end and controlled length along a `change` of state or weight that moves the span by `span` (m).
    #[inline]
    pub(super) fn moved(&self, frame: &FrameEnd, change: &Change, span: [f64; 3]) -> Moved {
        let FrameEnd { tension, direction: t, ratio, .. } = *frame;
        let d_tension = dot(t, change.force);
        let turned = scale(1.0 / tension, sub(change.force, scale(d_tension, t)));
        let (d_contact, d_wrapped) = frame.outlet.as_ref().map_or(([0.0; 3], 0.0), |(pulley, outlet)| {
            let (contact, wrap) = outlet.derivative(pulley, turned);
            (contact, pulley.radius * wrap)
        });
        let d_outside = d_wrapped - self.series_compliance * d_tension;
        Moved {
            end: add(d_contact, span),
            controlled_length: change.length + ratio * (d_outside - frame.outside * ratio * frame.slope * d_tension),
        }
    }
}

/// Quantities at the frame's end of a cable in a given state.
#[derive(Clone, Copy, Debug)]
pub(super) struct FrameEnd {
    /// |F| (N).
    tension: f64,
    /// F/|F|.
    direction: [f64; 3],
    pub(super) outlet: Option<(Pulley<f64>, Outlet<f64>)>,
    /// Strained length between winch and outlet, less the stretch of the compliance in series (m).
    pub(super) outside: f64,
    /// 1/(1 + ε) at the outlet.
    pub(super) ratio: f64,
    /// ∂ε/∂T at the outlet (1/N).
    slope: f64,
}

//! The law of a straight cable: one equation between length, controlled length and tension.

use super::{CableLaw, Kind};
use crate::cable::elasticity::Elasticity;
use crate::cable::path::CablePath;
use crate::cable::span;
use crate::cable::state::{CableInput, CableState, CableStateError, Recording};
use crate::cable::wrench::CableEnd;
use crate::scalar::scale;

/// The equation q_θ(q, f) with its derivatives.
#[derive(Clone, Copy, Debug)]
pub(super) struct Length {
    value: f64,
    pub(super) by_length: f64,
    by_tension: f64,
}

impl CableLaw {
    #[inline]
    pub(super) fn straight_state(
        &self,
        path: &CablePath<f64>,
        end: &CableEnd<f64>,
        input: CableInput,
    ) -> Result<CableState, CableStateError> {
        if !(path.length.is_finite() && path.free_length > 0.0) {
            return Err(CableStateError::NoCourse);
        }
        let q = path.length;
        let state = |tension: f64, length: &Length| straight(path, end, self.recording, tension, length);
        match input {
            CableInput::OutletTension(tension) | CableInput::PlatformTension(tension) => {
                Ok(state(tension, &self.length(q, tension)))
            }
            CableInput::ControlledLength(controlled_length) => {
                let tension = self.straight_tension(q, controlled_length)?;
                Ok(state(tension, &Length { value: controlled_length, ..self.length(q, tension) }))
            }
        }
    }

    /// Elasticity of a straight cable with a law in closed form; `None` for other cables.
    #[inline]
    pub(super) fn closed_form(&self) -> Option<Elasticity<f64>> {
        match self.kind {
            Kind::Rigid => Some(Elasticity::RIGID),
            Kind::Linear(law, _) => Some(law),
            Kind::Stretching | Kind::Sagging(_) => None,
        }
    }

    /// q_θ (m) with its derivatives for a cable of this geometric length (m) and tension (N).
    #[inline]
    pub(super) fn length(&self, q: f64, tension: f64) -> Length {
        match self.closed_form() {
            Some(law) => linear(&law, q, tension),
            None => {
                let (strain, slope) = self.stretch.strain(tension);
                let ratio = 1.0 / (1.0 + strain);
                let strained = q + self.hidden_length - self.series_compliance * tension;
                Length {
                    value: strained * ratio - self.hidden_length,
                    by_length: ratio,
                    by_tension: -ratio * (self.series_compliance + strained * ratio * slope),
                }
            }
        }
    }

    /// Tension of a cable of this geometric and controlled length (N), 0 if slack.
    fn straight_tension(&self, q: f64, controlled_length: f64) -> Result<f64, CableStateError> {
        if !(q > controlled_length) {
            return Ok(0.0);
        }
        if let Some(law) = self.closed_form() {
            return match law.is_rigid() {
                true => Err(CableStateError::TooShort { controlled_length, least: q }),
                false => Ok(law.tension(q, controlled_length).value),
            };
        }
        // the length falls with the tension, with no bound on its slope: Newton's method within a bracket
        let (mut low, mut high) = (0.0, 1.0);
        while self.length(q, high).value > controlled_length {
            low = high;
            high *= 4.0;
            if high > 1e15 {
                return Err(CableStateError::TooShort { controlled_length, least: q });
            }
        }
        let mut tension = 0.5 * (low + high);
        for iteration in 0..200 {
            let length = self.length(q, tension);
            let gap = length.value - controlled_length;
            if gap > 0.0 {
                low = tension
            } else {
                high = tension
            }
            let mut next = tension - gap / length.by_tension;
            if !(next > low && next < high) {
                next = 0.5 * (low + high);
            }
            if (next - tension).abs() <= 4.0 * f64::EPSILON * tension || iteration == 199 {
                return Ok(next);
            }
            tension = next;
        }
        Ok(tension)
    }
}

/// State of the straight cable on its path, with this tension and controlled length.
#[inline]
fn straight(
    path: &CablePath<f64>,
    end: &CableEnd<f64>,
    recording: Recording,
    tension: f64,
    length: &Length,
) -> CableState {
    let u = path.direction;
    // ∂f/∂q at fixed q_θ, and ∂f/∂q_θ; both 0 for a slack cable, not finite for a rigid one
    let taut = tension > 0.0;
    let stiffness = if taut { -length.by_length / length.by_tension } else { 0.0 };
    let by_controlled = if taut { 1.0 / length.by_tension } else { 0.0 };
    let [x, y, z] = path.direction_gradient;
    let turning = [scale(tension, x), scale(tension, y), scale(tension, z)];
    // δq = −u·δp_B; an array's `map` would be a call
    let row = |k: usize| {
        let pull = stiffness * u[k];
        [turning[k][0] - pull * u[0], turning[k][1] - pull * u[1], turning[k][2] - pull * u[2]]
    };
    CableState {
        end: *end,
        recording,
        is_given_at_platform: false,
        span: span::SpanState { force: scale(-tension, u), length: path.free_length * length.by_length },
        controlled_length: length.value,
        pull: scale(tension, u),
        direction: u,
        outlet_tension: tension,
        platform_tension: tension,
        wrap_angle: path.wrap_angle,
        strained_length: path.length,
        tangent: [row(0), row(1), row(2)],
        tangent_at_tension: turning,
        by_controlled_length: scale(by_controlled, u),
        by_tension: u,
        controlled_length_by_tension: length.by_tension,
        controlled_length_by_anchor: scale(-length.by_length, u),
    }
}

/// The straight cable on a path as a spring of 1 N/m with a tension of any sign (N): a least-squares fit of lengths is
/// the equilibrium of these springs (eq. 2.81).
pub fn unit_spring(path: &CablePath<f64>, end: &CableEnd<f64>, recording: Recording, tension: f64) -> CableState {
    const UNIT: Elasticity<f64> = Elasticity { by_length: 0.0, by_controlled_length: 0.0, constant: 1.0 };
    straight(path, end, recording, tension, &linear(&UNIT, path.length, tension))
}

#[inline]
fn linear(law: &Elasticity<f64>, q: f64, tension: f64) -> Length {
    let value = law.controlled_length(q, tension);
    let inverse = 1.0 / (1.0 + tension * law.by_controlled_length);
    Length {
        value,
        by_length: (1.0 - tension * law.by_length) * inverse,
        by_tension: -(law.compliance(q, value) * inverse),
    }
}

//! Laws of cables in dual numbers: straight ones from their polynomial or hysteresis, those with weight by Newton steps
//! on the equations of the converged catenary, of which the last one differentiates it implicitly.

use cdpr_core::cable::outlet::bent;
use nalgebra::{Const, Matrix4, SVector};
use num_dual::{DualNum, DualVec};

use super::super::cable_motion::CableMotion;
use cdpr_model::cable::elasticity::Elasticity;
use cdpr_model::cable::law::{CableLaw, Kind};
use cdpr_model::cable::outlet::Outlet;
use cdpr_model::cable::span;
use cdpr_model::cable::stretch::Stretch;
use cdpr_model::model::Model;
use cdpr_model::scalar::{Select, Smooth, add, dot, scale, sub};

/// Number of variables of a motion.
pub(super) const COUNT: usize = 50;

/// Number with the derivatives by all variables.
pub(super) type Dual = DualVec<f64, Const<COUNT>>;

/// Tension of a cable on the platform from its law, its direction there, and the excess of the tension at the outlet.
pub(super) fn law_of(
    model: &Model,
    cable: usize,
    motion: &CableMotion,
    anchor: [Dual; 3],
    unstrained: Dual,
) -> (Dual, [Dual; 3], Dual) {
    let own = model.law(cable);
    let law = motion.memory.map_or_else(|| own.clone(), |memory| own.with_memory(&memory));
    let coefficients = model.robot().cables[cable].tension_of_strain.clone().unwrap_or_default();
    if let (Kind::Sagging(_), Some(near)) = (law.kind, &motion.span) {
        let (pull, outside) = sagging(&law, &coefficients, anchor, unstrained, near);
        let tension = dot(pull, pull).sqrt();
        return (tension, scale(Dual::from(1.0) / tension, pull), outside - tension);
    }
    let outlet: Outlet<Dual> = law.outlet.map(|number| Dual::from(*number));
    let path = outlet.path(anchor);
    (straight(&law, &coefficients, path.length, unstrained), path.direction, Dual::from(0.0))
}

/// T(ε) and its slope: the polynomial of the file, or the branch of a memory.
fn stretch(law: &CableLaw, coefficients: &[f64], strain: Dual) -> (Dual, Dual) {
    if let Stretch::Hysteresis(hysteresis, memory) = &law.stretch {
        return hysteresis.tension(strain, memory);
    }
    let power = |of: &dyn Fn(i32, f64) -> Dual| {
        let terms = coefficients.iter().enumerate().map(|(k, c)| of(k as i32, *c) * DualNum::powi(&strain, k as i32));
        terms.fold(Dual::from(0.0), |sum, term| sum + term)
    };
    (strain * power(&|_, c| Dual::from(c)), power(&|k, c| Dual::from(c * f64::from(k + 1))))
}

/// Tension of a straight cable from its law, also below zero.
fn straight(law: &CableLaw, coefficients: &[f64], length: Dual, unstrained: Dual) -> Dual {
    let Kind::Linear(linear, _) = law.kind else {
        // c_s T(ε) + (q_θ + q_h)(1 + ε) = q + q_h: Newton's steps in dual numbers end at value and derivatives
        let (strained, unstrained) = (length + law.hidden_length, unstrained + law.hidden_length);
        let mut strain = strained / unstrained - 1.0;
        for _ in 0..20 {
            let (tension, slope) = stretch(law, coefficients, strain);
            let gap = tension * law.series_compliance + unstrained * (strain + 1.0) - strained;
            strain -= gap / (slope * law.series_compliance + unstrained);
        }
        return stretch(law, coefficients, strain).0;
    };
    let [by_length, by_controlled_length, constant] =
        [linear.by_length, linear.by_controlled_length, linear.constant].map(Dual::from);
    Elasticity { by_length, by_controlled_length, constant }.tension(length, unstrained).value
}

/// The pull of a cable with weight on the platform and its tension at the outlet, from a nearby state.
fn sagging(
    law: &CableLaw,
    coefficients: &[f64],
    anchor: [Dual; 3],
    unstrained: Dual,
    near: &span::SpanState<f64>,
) -> ([Dual; 3], Dual) {
    let [x, y, z] = near.force;
    let start = [x, y, z, near.length];
    let equations = Equations { law, coefficients, side: side(law, anchor.map(|part| part.re)) };
    // the plain Jacobian at the start, by dual numbers of the four unknowns
    let unknowns: [DualVec<f64, Const<4>>; 4] =
        std::array::from_fn(|k| DualVec::new(start[k], num_dual::Derivative::some(SVector::<f64, 4>::ith(k, 1.0))));
    let rows = equations.of(unknowns).map(|row| row.eps.unwrap_generic(Const, Const::<1>));
    let inverse = Matrix4::from_fn(|row, column| rows[row][column]).try_inverse().unwrap();
    let mut state = start.map(Dual::from);
    for _ in 0..4 {
        let [x, y, z, length] = equations.of(state);
        let gaps = [x - anchor[0], y - anchor[1], z - anchor[2], length - unstrained];
        let step = |row: usize| (0..4).fold(Dual::from(0.0), |sum, k| sum + gaps[k] * inverse[(row, k)]);
        state = std::array::from_fn(|row| state[row] - step(row));
    }
    let force = [state[0], state[1], state[2]];
    let weight = law.weight.map(Dual::from);
    (sub(scale(state[3], weight), force), dot(force, force).sqrt())
}

/// Side of the swivel axis on which a cable leaves its pulley.
fn side(law: &CableLaw, anchor: [f64; 3]) -> f64 {
    if law.outlet.path(anchor).wrap_angle > std::f64::consts::PI { -1.0 } else { 1.0 }
}

/// C(F) + S(F, L) and L + (r_p β + q_h − c_s |F|)/(1 + ε(|F|)) − q_h.
struct Equations<'a> {
    law: &'a CableLaw,
    coefficients: &'a [f64],
    side: f64,
}

impl Equations<'_> {
    fn of<T: Smooth + Select>(&self, [x, y, z, length]: [T; 4]) -> [T; 4] {
        let (force, law) = ([x, y, z], self.law);
        let number = |value: f64| length.constant(value);
        let Kind::Sagging(shape) = law.kind else { panic!("a cable with weight") };
        let tension = dot(force, force).sqrt();
        let (mut end, mut wrapped) = (law.outlet.frame_anchor().map(number), number(0.0));
        if let Outlet::Swivel { swivel_axis, radius, .. } = &law.outlet {
            let pulley =
                bent::Pulley { swivel_axis: swivel_axis.map(number), radius: number(*radius), side: self.side };
            let outlet = bent::outlet(&pulley, scale(number(1.0) / tension, force));
            (end, wrapped) = (add(end, outlet.contact), pulley.radius * outlet.wrap_angle);
        }
        let state = span::SpanState { force, length };
        let [x, y, z] = add(end, shape.vector(&state, law.weight.map(number), &law.stretch));
        let outside = wrapped + number(law.hidden_length) - number(law.series_compliance) * tension;
        let strained = number(1.0) + self.strain(tension);
        [x, y, z, length + outside / strained - number(law.hidden_length)]
    }

    /// ε(T).
    fn strain<T: Smooth + Select>(&self, tension: T) -> T {
        let number = |value: f64| tension.constant(value);
        match &self.law.stretch {
            Stretch::Rigid => number(0.0),
            Stretch::Linear(compliance) => number(*compliance) * tension,
            Stretch::Hysteresis(law, memory) => law.strain(tension, memory).0,
            // other laws without a memory: here the file's polynomial
            _ => {
                // f = Σ c_k ε^k by Horner's rule, inverted by Newton's
                let mut strain = tension / number(self.coefficients[0]);
                for _ in 0..30 {
                    let (mut value, mut slope) = (number(0.0), number(0.0));
                    for (k, c) in self.coefficients.iter().enumerate().rev() {
                        value = (value + number(*c)) * strain;
                        slope = slope * strain + number(c * (k + 1) as f64);
                    }
                    strain = strain - (value - tension) / slope;
                }
                strain
            }
        }
    }
}

//! Results of every composition for a cable at rest, differentiated by dual numbers of its equations.

use nalgebra::{Const, DMatrix, SVector, Vector3};
use num_dual::DualVec;

use super::*;
use crate::cable::elasticity::Elasticity;
use crate::cable::law::{Kind, LawParameter};
use crate::cable::outlet::{Outlet, bent};
use crate::cable::span::{Shape, SpanState};
use crate::cable::stretch::Stretch;
use crate::cable::{CablePath, CableState};
use crate::scalar::{Real, Smooth, add, cross, dot, rotate, scale, sub};

/// Derivatives by the unknowns of the equations (force and length of a span, or the tension of a straight cable), and
/// by the given quantities.
type Dual = DualVec<f64, Const<COUNT>>;
const STATE: usize = 0;
const TWIST: usize = 4;
const PLATFORM_ANCHOR: usize = 10;
const FRAME_ANCHOR: usize = 13;
const RADIUS: usize = 16;
const COMPLIANCE: usize = 17;
const HIDDEN: usize = 18;
const PULLEY_TURN: usize = 19;
const DENSITY: usize = 22;
const COUNT: usize = 23;

fn variable(value: f64, index: usize) -> Dual {
    Dual::new(value, num_dual::Derivative::some(SVector::<f64, COUNT>::ith(index, 1.0)))
}

fn vector(values: Vector3<f64>, first: usize) -> [Dual; 3] {
    [0, 1, 2].map(|k| variable(values[k], first + k))
}

fn constants(values: [f64; 3]) -> [Dual; 3] {
    values.map(Dual::from)
}

/// A unit vector of the pulley, turned by the variables of its rotation.
fn turned(unit: [Dual; 3]) -> [Dual; 3] {
    add(unit, cross(vector(Vector3::zeros(), PULLEY_TURN), unit))
}

fn gradient(dual: &Dual) -> SVector<f64, COUNT> {
    dual.eps.unwrap_generic(Const, Const::<1>)
}

/// The equations of one cable at the state that the library found, and quantities that follow from the state.
struct Twin {
    /// Equations that vanish, apart from the known quantity: three rows of a span, none of a straight cable.
    equations: Vec<Dual>,
    pull: [Dual; 3],
    moment_arm: [Dual; 3],
    controlled_length: Dual,
    outlet_tension: Dual,
    platform_tension: Dual,
}

impl Twin {
    fn of(model: &Model, index: usize, pose: &Pose, state: &CableState) -> Self {
        let cable = &model.robot().cables[index];
        let turn = vector(Vector3::zeros(), TWIST + 3);
        let rows = pose.rotation_rows().map(|row| row.map(Dual::from));
        let turned = rotate(&rows, vector(cable.platform_anchor, PLATFORM_ANCHOR));
        let moment_arm = add(turned, cross(turn, turned));
        let anchor = add(vector(pose.position, TWIST), moment_arm);
        match model.law(index).kind {
            Kind::Sagging(shape) => Self::sagging(model, index, shape, anchor, moment_arm, state),
            _ => Self::straight(model, index, anchor, moment_arm, state),
        }
    }

    fn straight(model: &Model, index: usize, anchor: [Dual; 3], moment_arm: [Dual; 3], state: &CableState) -> Self {
        let (cable, law) = (&model.robot().cables[index], model.law(index));
        let mut outlet = law.outlet.map(|number| Dual::from(*number));
        *outlet.frame_anchor_mut() = vector(cable.frame_anchor, FRAME_ANCHOR);
        outlet.radius_mut().into_iter().for_each(|radius| *radius = variable(radius.re, RADIUS));
        match &mut outlet {
            Outlet::Point { .. } => {}
            Outlet::Swivel { swivel_axis, .. } => *swivel_axis = turned(*swivel_axis),
            Outlet::Sided { swivel_axis, side, .. } => {
                (*swivel_axis, *side) = (turned(*swivel_axis), turned(*side));
            }
        }
        let path: CablePath<Dual> = outlet.path(anchor);
        let tension = variable(state.outlet_tension, STATE);
        let hidden = variable(law.hidden_length, HIDDEN);
        let controlled_length = match law.kind {
            Kind::Rigid => path.length,
            Kind::Linear(linear, _) => {
                dual_elasticity(model, index, &linear, hidden).controlled_length(path.length, tension)
            }
            _ => {
                let (strain, slope) = law.stretch.strain(tension.re);
                let strained = path.length + hidden - tension * law.series_compliance;
                strained / (tension.chain(strain, slope) + 1.0) - hidden
            }
        };
        Self {
            equations: Vec::new(),
            pull: scale(tension, path.direction),
            moment_arm,
            controlled_length,
            outlet_tension: tension,
            platform_tension: tension,
        }
    }

    fn sagging(
        model: &Model,
        index: usize,
        shape: Shape,
        anchor: [Dual; 3],
        moment_arm: [Dual; 3],
        state: &CableState,
    ) -> Self {
        let (cable, law) = (&model.robot().cables[index], model.law(index));
        let found = state.span;
        let (force, length) = (vector(found.force.into(), STATE), variable(found.length, STATE + 3));
        let tension = dot(force, force).sqrt();
        let density = cable.linear_density.unwrap_or(0.0);
        let gravity = constants(model.robot().gravity.unwrap_or_else(Vector3::zeros).into());
        let weight = add(constants(law.weight), scale(variable(density, DENSITY) - density, gravity));
        let hidden = variable(law.hidden_length, HIDDEN);
        let mut span = shape.vector(&SpanState { force, length }, weight, &law.stretch);
        let (strain, slope) = law.stretch.strain(tension.re);
        let mut strain = tension.chain(strain, slope);
        if let Stretch::Linear(compliance) = law.stretch {
            // the stretch of a span is linear in the compliance: κ ∫ τ ds
            let more = variable(compliance, COMPLIANCE) - compliance;
            span = add(span, scale(more * length, sub(force, scale(length * 0.5, weight))));
            strain += more * tension;
        }
        let end_force = sub(force, scale(length, weight));
        let twin = |side: f64| {
            let (mut contact, mut wrapped) = (constants([0.0; 3]), Dual::from(0.0));
            if let Some((&axis, &radius)) = law.outlet.pulley() {
                let swivel_axis = turned(constants(axis));
                let pulley = bent::Pulley { swivel_axis, radius: variable(radius, RADIUS), side };
                let outlet = bent::outlet(&pulley, scale(Dual::from(1.0) / tension, force));
                (contact, wrapped) = (outlet.contact, pulley.radius * outlet.wrap_angle);
            }
            let end = add(add(vector(cable.frame_anchor, FRAME_ANCHOR), contact), span);
            let outside = wrapped + hidden - tension * law.series_compliance;
            Self {
                equations: sub(end, anchor).to_vec(),
                pull: scale(Dual::from(-1.0), end_force),
                moment_arm,
                controlled_length: length + outside / (strain + 1.0) - hidden,
                outlet_tension: tension,
                platform_tension: dot(end_force, end_force).sqrt(),
            }
        };
        // the cable leaves the axis on the side on which its equations hold
        let gap = |twin: &Self| twin.equations.iter().map(|row| row.re.abs()).fold(0.0, f64::max);
        let (near, far) = (twin(1.0), twin(-1.0));
        let best = if gap(&near) < gap(&far) { near } else { far };
        // Newton's method ends at rounding of lengths of 15 m
        assert!(gap(&best) < 1e-10, "{}: {:e} m", model.composition(), gap(&best));
        best
    }

    /// Wrench \[t; b × t\] on the platform.
    fn wrench(&self) -> [Dual; 6] {
        let ([x, y, z], [u, v, w]) = (self.pull, cross(self.moment_arm, self.pull));
        [x, y, z, u, v, w]
    }

    /// Total derivatives of quantities by all given numbers (columns) at fixed `known`, and by `known` itself (last
    /// column).
    fn total(&self, known: &Dual, quantities: &[Dual]) -> DMatrix<f64> {
        let rows: Vec<_> = self.equations.iter().chain([known]).map(gradient).collect();
        let states = rows.len();
        let by_state = DMatrix::from_fn(states, states, |row, column| rows[row][STATE + column]);
        let given = COUNT - TWIST + 1;
        let change = DMatrix::from_fn(states, given, |row, column| match column + 1 == given {
            true => f64::from(u8::from(row + 1 == states)),
            false => -rows[row][TWIST + column],
        });
        let state = by_state.lu().solve(&change).expect("the equations determine the state");
        DMatrix::from_fn(quantities.len(), given, |row, column| {
            let by = gradient(&quantities[row]);
            let direct = if column + 1 == given { 0.0 } else { by[TWIST + column] };
            direct + (0..states).map(|k| by[STATE + k] * state[(k, column)]).sum::<f64>()
        })
    }
}

/// The linear law with dual compliance and hidden length.
fn dual_elasticity(model: &Model, index: usize, law: &Elasticity<f64>, hidden: Dual) -> Elasticity<Dual> {
    let specific = law.by_length + law.by_controlled_length;
    let more = if specific > 0.0 { variable(specific, COMPLIANCE) } else { Dual::from(0.0) };
    let by = |fraction: f64| if fraction > 0.0 { more } else { Dual::from(0.0) };
    let rest = law.constant - specific * model.law(index).hidden_length;
    Elasticity {
        by_length: by(law.by_length),
        by_controlled_length: by(law.by_controlled_length),
        constant: more * hidden + rest,
    }
}

/// Largest difference of two lists, relative to their largest entry.
fn difference(found: &[f64], expected: impl IntoIterator<Item = f64>) -> f64 {
    let expected: Vec<f64> = expected.into_iter().collect();
    assert_eq!(found.len(), expected.len());
    let size = expected.iter().fold(1e-300, |most, x| f64::max(most, x.abs()));
    found.iter().zip(expected).map(|(a, b)| (a - b).abs() / size).fold(0.0, f64::max)
}

/// Rounding in the solution of four equations with the condition of a taut cable's stiffness.
const ROUNDING: f64 = 1e-8;

/// Stiffness, wrench, controlled length and their derivatives by pose, controlled length, tension and parameters: every
/// composition, eight random robots (two of them planar), three poses each, every cable.
#[test]
fn every_derivative_of_every_composition_agrees_with_dual_numbers() {
    for seed in 1..=8 {
        let robot = random_robot(seed);
        for model in models(&robot) {
            for (pose, tensions) in random_states(&model, 100 + seed, 3) {
                for (index, &tension) in tensions.iter().enumerate() {
                    let state = &cable_state(&model, &pose, index, tension).unwrap();
                    check_by_pose(&model, index, &pose, state);
                    check_by_tension(&model, index, &pose, state);
                    check_by_parameters(&model, index, &pose, state);
                    check_symmetry(&model, index, state);
                    check_drum(&model, index, state.controlled_length);
                }
            }
        }
    }
}

fn check_by_pose(model: &Model, index: usize, pose: &Pose, state: &CableState) {
    let twin = Twin::of(model, index, pose, state);
    let composition = model.composition();
    let mut wanted = vec![(twin.outlet_tension, -state.wrench_by_pose(), "tension")];
    if composition.needs_tensions() {
        // a rigid straight cable has no finite stiffness
        wanted.push((twin.controlled_length, state.stiffness(), "length"));
    }
    for (known, stiffness, name) in wanted {
        let total = twin.total(&known, &twin.wrench());
        let expected = (0..6).flat_map(|column| (0..6).map(move |row| (row, column))).map(|at| -total[at]);
        let off = difference(stiffness.as_slice(), expected);
        assert!(off < ROUNDING, "{composition}, cable {index}, wrench at fixed {name}: {off:e}");
    }
    let total = twin.total(&twin.outlet_tension, &[twin.controlled_length]);
    let off = difference(&state.controlled_length_by_anchor, (0..3).map(|column| total[(0, column)]));
    assert!(off < ROUNDING, "{composition}, cable {index}, length by anchor: {off:e}");
}

fn check_by_tension(model: &Model, index: usize, pose: &Pose, state: &CableState) {
    let twin = Twin::of(model, index, pose, state);
    let composition = model.composition();
    let last = COUNT - TWIST;
    let known = if state.is_given_at_platform { twin.platform_tension } else { twin.outlet_tension };
    let total = twin.total(&known, &twin.wrench());
    let off = difference(state.wrench_by_tension().as_slice(), (0..6).map(|row| total[(row, last)]));
    assert!(off < ROUNDING, "{composition}, cable {index}, wrench by tension: {off:e}");
    if composition.needs_tensions() {
        let total = twin.total(&twin.controlled_length, &twin.wrench());
        let off = difference(state.wrench_by_controlled_length().as_slice(), (0..6).map(|row| total[(row, last)]));
        assert!(off < ROUNDING, "{composition}, cable {index}, wrench by length: {off:e}");
        let total = twin.total(&twin.outlet_tension, &[twin.controlled_length]);
        let off = difference(&[state.controlled_length_by_tension], [total[(0, last)]]);
        assert!(off < ROUNDING, "{composition}, cable {index}, length by tension: {off:e}");
    }
}

fn check_by_parameters(model: &Model, index: usize, pose: &Pose, state: &CableState) {
    let twin = Twin::of(model, index, pose, state);
    let (composition, law) = (model.composition(), model.law(index));
    let total = twin.total(&twin.outlet_tension, &[twin.pull[0], twin.pull[1], twin.pull[2], twin.controlled_length]);
    let gravity = model.robot().gravity.unwrap_or_else(Vector3::zeros);
    let parameters = [
        (LawParameter::PulleyRadius, RADIUS),
        (LawParameter::Weight(gravity.into()), DENSITY),
        (LawParameter::Compliance, COMPLIANCE),
        (LawParameter::HiddenLength, HIDDEN),
        (LawParameter::PulleyTurn([1.0, 0.0, 0.0]), PULLEY_TURN),
        (LawParameter::PulleyTurn([0.0, 1.0, 0.0]), PULLEY_TURN + 1),
        (LawParameter::PulleyTurn([0.0, 0.0, 1.0]), PULLEY_TURN + 2),
    ];
    for (parameter, column) in parameters {
        let change = law.by_parameter(state, parameter);
        let expected = |row: usize| total[(row, column - TWIST)];
        let off = difference(&change.pull, (0..3).map(expected));
        let none = (0..4).all(|row| expected(row) == 0.0) && change.pull == [0.0; 3] && change.controlled_length == 0.0;
        // pulls change by exactly 0 if only the length changes
        let pulls_agree = off < ROUNDING || change.pull.iter().all(|x| x.abs() < 1e-12 * state.outlet_tension);
        assert!(none || pulls_agree, "{composition}, cable {index}, pull by {parameter:?}: {off:e}");
        let off = difference(&[change.controlled_length], [expected(3)]);
        // lengths in metres per unit, to 1e-13 of them if the parameter has almost no effect
        let agrees = off < ROUNDING || (change.controlled_length - expected(3)).abs() < 1e-13;
        assert!(none || agrees, "{composition}, cable {index}, length by {parameter:?}: {off:e}");
    }
    // moving the outlet equals moving the platform anchor the other way
    for k in 0..3 {
        let (frame, platform) = (total[(3, FRAME_ANCHOR - TWIST + k)], state.controlled_length_by_anchor[k]);
        assert!((frame + platform).abs() < ROUNDING, "{composition}, cable {index}: {frame} {platform}");
    }
}

/// The tangent is the Hessian of an energy, up to the terms that the law neglects (see [`crate::cable::law`]): the
/// weight on the pulley, and for a chain of elements the weight of one.
fn check_symmetry(model: &Model, index: usize, state: &CableState) {
    let tangent = state.tangent;
    if !tangent.iter().flatten().all(|x| x.is_finite()) {
        assert!(!model.needs_tensions());
        return;
    }
    let size = tangent.iter().flatten().fold(0.0, |most, x| f64::max(most, x.abs()));
    let allowed = match (model.law(index).kind, model.law(index).outlet.pulley().is_some()) {
        (Kind::Sagging(_), true) => 1e-3,
        (Kind::Sagging(Shape::FiniteElements(_)), false) => 1e-5,
        _ => 1e-9,
    };
    for (row, column) in [(0, 1), (0, 2), (1, 2)] {
        let skew = (tangent[row][column] - tangent[column][row]).abs() / size;
        assert!(skew < allowed, "{}, cable {index}: {skew:e}", model.composition());
    }
}

/// Angle and length of a drum are inverse to each other, and so are their derivatives (with dual numbers in the winch's
/// own tests).
fn check_drum(model: &Model, index: usize, length: f64) {
    if !model.composition().drum {
        return;
    }
    let angle = model.motor_angle(index, length).unwrap();
    let back = model.controlled_length_of_motor_angle(index, angle).unwrap();
    // rounding of angles of 1e3 rad
    assert!((back - length).abs() < 1e-11, "{length} {back}");
    let gear_ratio = model.robot().cables[index].winch.gear_ratio.expect("has a gear");
    let by_angle = model.motor_angle_gradient(index, angle).unwrap().by_angle / gear_ratio;
    let h = 1e-5;
    let slope =
        (model.motor_angle(index, length + h).unwrap() - model.motor_angle(index, length - h).unwrap()) / (2.0 * h);
    assert!((slope * by_angle - 1.0).abs() < 1e-6, "{slope} {by_angle}");
}

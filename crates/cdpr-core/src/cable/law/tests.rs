//! Catenaries against closed forms, both ways round, and the laws that every cable obeys.

use nalgebra::{Const, SVector};
use num_dual::DualVec;

use super::*;
use crate::cable::outlet::bent;
use crate::cable::span::Change;
use crate::cable::stretch::two_piece::TwoPiece;
use crate::scalar::{Real, Smooth, add, cross, dot, scale, sub};

/// A 14 mm steel cable of 0.8 kg/m (EA 10 MN) over a pulley whose swivel axis is tilted.
fn steel(shape: Shape, with_pulley: bool) -> CableLaw {
    let axis = [0.2, -0.1, 0.95];
    let norm = dot(axis, axis).sqrt();
    let frame_anchor = [1.0, -2.0, 6.0];
    CableLaw {
        outlet: match with_pulley {
            true => Outlet::Swivel { frame_anchor, swivel_axis: scale(1.0 / norm, axis), radius: 0.16 },
            false => Outlet::Point { frame_anchor },
        },
        stretch: Stretch::Linear(1e-7),
        hidden_length: 3.0,
        series_compliance: 2e-7,
        weight: [0.0, 0.0, -0.8 * 9.81],
        recording: Recording::EXACT,
        kind: Kind::Sagging(shape),
    }
}

fn shapes() -> [Shape; 2] {
    [Shape::Catenary, Shape::FiniteElements(7)]
}

/// A sequence of numbers in [−1, 1) from a seed.
fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

fn anchors(count: usize) -> impl Iterator<Item = [f64; 3]> {
    let mut seed = 7;
    std::iter::repeat_with(move || [6.0 * random(&mut seed), 6.0 * random(&mut seed), 4.0 + 5.0 * random(&mut seed)])
        .take(count)
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let d = sub(a, b);
    dot(d, d).sqrt()
}

/// From tension to length and back, taut to slack: Newton's method leaves rounding errors, multiplied by the stiffness
/// of a taut cable (1e6 N/m).
#[test]
fn tension_and_length_lead_to_each_other() {
    let (mut solved, mut solved_both, mut lost) = (0, 0, 0);
    for (index, anchor) in anchors(500).enumerate() {
        for shape in shapes() {
            let law = steel(shape, index % 2 == 0);
            for tension in [60.0, 150.0, 1e3, 1.2e4] {
                let Ok(cable) = law.state(anchor, CableInput::OutletTension(tension)) else { continue };
                // at the least tension of a span the length is sensitive to it, so bisection ends there
                assert!(
                    (cable.outlet_tension / tension - 1.0).abs() < 1e-9,
                    "{anchor:?} {tension} {} {shape:?} {}",
                    cable.outlet_tension,
                    law.outlet.pulley().is_some()
                );
                let Ok(back) = law.state(anchor, CableInput::ControlledLength(cable.controlled_length)) else {
                    lost += 1;
                    continue;
                };
                let gap = distance(cable.pull, back.pull);
                assert!(gap < 1e-6 * tension, "{index} {shape:?} {tension} {anchor:?}: {gap}");
                if let Ok(other) = law.state(anchor, CableInput::PlatformTension(cable.platform_tension)) {
                    assert!(other.controlled_length <= cable.controlled_length + 1e-9, "the taut length is meant");
                    solved_both += 1;
                }
                solved += 1;
            }
        }
    }
    // a slack cable that hangs along a swivel axis lies in no unique plane
    assert!(lost < 5, "{lost}");
    // 60 N do not carry every cable of up to 15 m and 8 N/m
    assert!(solved > 3_600 && solved_both > solved - 5, "{solved} {solved_both}");
}

/// Every length of an elastic cable has a shape, up to three times the distance.
#[test]
fn every_length_has_a_shape() {
    for (index, anchor) in anchors(150).enumerate() {
        for with_pulley in [false, true] {
            let mut law = steel(Shape::Catenary, with_pulley);
            // a slack cable hangs down from its pulley: along a tilted axis it would lie in no unique plane
            if let Outlet::Swivel { swivel_axis, .. } = &mut law.outlet {
                *swivel_axis = [0.0, 0.0, 1.0];
            }
            let chord = CableLaw::chord(&law.path(anchor)).unwrap().length;
            for fraction in [0.98, 0.999, 1.0, 1.001, 1.05, 1.5, 3.0] {
                let cable = law.state(anchor, CableInput::ControlledLength(fraction * chord));
                let cable =
                    cable.unwrap_or_else(|error| panic!("{index} {fraction} {anchor:?} {with_pulley}: {error}"));
                assert!((cable.controlled_length - fraction * chord).abs() < 1e-9);
            }
        }
    }
}

/// A cable too heavy to be computed has no shape at any length: the search for its tension gives up after a bounded
/// number of steps, and its error counts the steps for all lengths.
#[test]
fn the_search_for_a_cable_without_a_shape_ends() {
    let bounded = solve::MAX_STEPS..solve::MAX_STEPS + solve::MAX_NEWTON_STEPS;
    for density in [1e14, 1e20] {
        let weight = [0.0, 0.0, -9.81 * density];
        let law = CableLaw { weight, stretch: Stretch::Linear(1e-6), ..steel(Shape::Catenary, false) };
        for known in [CableInput::OutletTension(3e3), CableInput::PlatformTension(3e3)] {
            match law.state([-3.0, -2.0, 11.0], known) {
                Err(CableStateError::NotConverged { iterations, .. }) => {
                    assert!(bounded.contains(&iterations), "{iterations}")
                }
                other => panic!("{density} {known:?}: {other:?}"),
            }
        }
    }
}

/// The whole span is in balance: forces, and moments about the outlet with the weight at every point of its curve.
#[test]
fn forces_and_moments_of_the_span_balance() {
    for anchor in anchors(200) {
        let law = steel(Shape::Catenary, false);
        let Ok(cable) = law.state(anchor, CableInput::OutletTension(400.0)) else { continue };
        let (state, length) = (cable.span, cable.span.length);
        let total = sub(add(state.force, cable.pull), scale(length, law.weight));
        assert!(dot(total, total).sqrt() < 1e-9, "{total:?}");
        // moment of the weight: ∫ r × p ds by Gauss panels over the shape of a shorter cable with the same force
        let moment = integral(length, |s| {
            let part = SpanState { force: state.force, length: s };
            cross(Shape::Catenary.vector(&part, law.weight, &law.stretch), law.weight)
        });
        let end = sub(anchor, *law.outlet.frame_anchor());
        let missing = sub(moment, cross(end, cable.pull));
        assert!(dot(missing, missing).sqrt() < 1e-9 * 400.0 * 10.0, "{missing:?}");
    }
}

/// Composite Gauss quadrature with 200 panels of two points: 1e-12 for smooth shapes.
fn integral(length: f64, f: impl Fn(f64) -> [f64; 3]) -> [f64; 3] {
    let panels = 200;
    let h = length / f64::from(panels);
    let offset = 0.5 / 3.0_f64.sqrt();
    let mut sum = [0.0; 3];
    for panel in 0..panels {
        for side in [-offset, offset] {
            let s = (f64::from(panel) + 0.5 + side) * h;
            sum = add(sum, scale(0.5 * h, f(s)));
        }
    }
    sum
}

/// A cable that does not stretch, ends level: L = (2H/w) sinh(w d/2H), and the end tension is √(H² + (wL/2)²).
#[test]
fn a_level_inextensible_cable_is_the_classical_catenary() {
    let weight = 7.85;
    let law = CableLaw {
        outlet: Outlet::Point { frame_anchor: [0.0, 0.0, 5.0] },
        stretch: Stretch::Rigid,
        hidden_length: 0.0,
        series_compliance: 0.0,
        weight: [0.0, 0.0, -weight],
        ..steel(Shape::Catenary, false)
    };
    let width = 10.0;
    for horizontal in [20.0, 100.0, 5e3] {
        let length = 2.0 * horizontal / weight * (0.5 * weight * width / horizontal).sinh();
        let tension = f64::hypot(horizontal, 0.5 * weight * length);
        let anchor = [width, 0.0, 5.0];
        let mut holds = vec![law.state(anchor, CableInput::ControlledLength(length)).unwrap()];
        // if w d/2H is 1.2 or more, this length is the slacker of two that have its tension
        if horizontal > 0.5 * weight * width / 1.19 {
            holds.push(law.state(anchor, CableInput::OutletTension(tension)).unwrap());
        }
        for cable in holds {
            assert!((cable.controlled_length / length - 1.0).abs() < 1e-11, "{horizontal}");
            assert!(
                (cable.outlet_tension / tension - 1.0).abs() < 1e-9
                    && (cable.platform_tension / tension - 1.0).abs() < 1e-9
            );
        }
    }
    let short = law.state([width, 0.0, 5.0], CableInput::ControlledLength(9.9));
    assert!(matches!(short, Err(CableStateError::TooShort { .. })), "{short:?}");
}

/// A span 6 m wide and 4 m high of 0.8 kg/m: above 24.4 N at the lower end two lengths have the tension, below none.
#[test]
fn the_least_tension_of_a_span_is_found_and_the_taut_length_is_meant() {
    let law = CableLaw {
        outlet: Outlet::Point { frame_anchor: [0.0, 0.0, 4.0] },
        stretch: Stretch::Rigid,
        hidden_length: 0.0,
        series_compliance: 0.0,
        ..steel(Shape::Catenary, false)
    };
    let anchor = [6.0, 0.0, 0.0];
    let too_low = law.state(anchor, CableInput::PlatformTension(24.0));
    match too_low {
        Err(CableStateError::TensionTooLow { least, .. }) => assert!((least - 24.4).abs() < 0.05, "{least}"),
        other => panic!("{other:?}"),
    }
    let taut = law.state(anchor, CableInput::PlatformTension(24.6)).unwrap();
    let tighter = law.state(anchor, CableInput::PlatformTension(30.0)).unwrap();
    assert!(tighter.controlled_length < taut.controlled_length);
}

/// A tension near zero is refused with the least possible one, which has a state: rope and steel, with pulleys or not.
#[test]
fn the_least_tension_of_a_cable_is_told_wherever_it_ends() {
    for (density, with_pulley) in [(0.05, false), (0.05, true), (0.8, false), (0.8, true)] {
        let weight = [0.0, 0.0, -9.81 * density];
        for (stretch, kind) in
            [(Stretch::Linear(2e-6), Shape::Catenary), (Stretch::Linear(1e-7), Shape::FiniteElements(12))]
        {
            let law = CableLaw { weight, stretch, ..steel(kind, with_pulley) };
            for anchor in anchors(25) {
                let least = match law.state(anchor, CableInput::OutletTension(1e-3)) {
                    Err(CableStateError::TensionTooLow { least, .. }) => least,
                    other => panic!("{density} {with_pulley} {anchor:?}: {other:?}"),
                };
                let cable = law.state(anchor, CableInput::OutletTension(1.01 * least));
                assert!(cable.is_ok(), "{density} {with_pulley} {anchor:?}: {cable:?}, least {least} N");
            }
        }
    }
}

/// The chain of elements tends to the catenary with the square of their number.
#[test]
fn finite_elements_converge_with_order_two() {
    let anchor = [6.0, 1.0, 1.5];
    let exact = steel(Shape::Catenary, true).state(anchor, CableInput::OutletTension(150.0)).unwrap();
    let error = |count: usize| {
        let cable = steel(Shape::FiniteElements(count), true).state(anchor, CableInput::OutletTension(150.0)).unwrap();
        (cable.controlled_length - exact.controlled_length).abs()
    };
    for count in [8, 16, 32, 64] {
        let order = (error(count) / error(2 * count)).log2();
        assert!((order - 2.0).abs() < 0.05, "{count} elements: {:.3e} m, order {order:.3}", error(count));
    }
}

/// Straight or with weight, with pulleys or not, below and above the knee of a two-piece law: derivatives by a number
/// at a given tension are slopes of solved states (to 1e-6: central differences of 1e-4, with Newton's rounding).
#[test]
fn derivatives_by_the_numbers_of_a_law_are_slopes_of_solved_states() {
    let law = |numbers: [f64; 3], kind: Kind, with_pulley: bool| {
        let [below, above, knee] = numbers;
        let stretch = Stretch::TwoPiece(TwoPiece { below, above, knee });
        CableLaw { stretch, kind, ..steel(Shape::Catenary, with_pulley) }
    };
    let numbers = [2e6, 9e6, 3e-4];
    let kinds = [Kind::Stretching, Kind::Sagging(Shape::Catenary), Kind::Sagging(Shape::FiniteElements(7))];
    for (anchor, with_pulley) in anchors(12).zip([true, false].into_iter().cycle()) {
        for (kind, tension) in kinds.into_iter().flat_map(|kind| [(kind, 300.0), (kind, 1500.0)]) {
            let known = CableInput::OutletTension(tension);
            let state = law(numbers, kind, with_pulley).state(anchor, known).unwrap();
            for number in 0..3 {
                let found = law(numbers, kind, with_pulley).by_parameter(&state, LawParameter::Stretch(number));
                let h = 1e-4 * numbers[number];
                let [ahead, behind] = [h, -h].map(|by| {
                    let mut moved = numbers;
                    moved[number] += by;
                    law(moved, kind, with_pulley).state(anchor, known).unwrap()
                });
                let slope = scale(0.5 / h, sub(ahead.pull, behind.pull));
                let length = (ahead.controlled_length - behind.controlled_length) / (2.0 * h);
                // a relative change of the number moves pulls by newtons and lengths by millimetres
                let [pull_off, length_off] = [distance(slope, found.pull), (length - found.controlled_length).abs()]
                    .map(|off| off * numbers[number]);
                assert!(
                    pull_off < 1e-4 && length_off < 1e-8,
                    "{kind:?} {tension} {number}: {pull_off:e} {length_off:e}"
                );
            }
        }
    }
}

/// Without weight the span is the straight cable, in values and derivatives, and the limit is smooth.
#[test]
fn weight_zero_is_the_straight_cable() {
    for (anchor, with_pulley) in anchors(100).zip([true, false].into_iter().cycle()) {
        let law = |weight: f64| CableLaw { weight: [0.0, 0.0, -weight], ..steel(Shape::Catenary, with_pulley) };
        let straight = CableLaw { kind: Kind::Stretching, ..law(0.0) };
        let known = CableInput::OutletTension(900.0);
        let (expected, found) = (straight.state(anchor, known).unwrap(), law(0.0).state(anchor, known).unwrap());
        assert!((expected.controlled_length - found.controlled_length).abs() < 1e-12);
        assert!(distance(expected.pull, found.pull) < 1e-9);
        for k in 0..3 {
            for j in 0..3 {
                let scale = expected.tangent[k][k].abs() + 1e3;
                assert!((expected.tangent[k][j] - found.tangent[k][j]).abs() < 1e-7 * scale);
            }
        }
        let sag = |weight: f64| law(weight).state(anchor, known).unwrap().controlled_length - found.controlled_length;
        // strain by the weight's own tension, 1e-7 · w L²/2, and sag, w² L³/(24 T²), for L up to 16 m
        for weight in [0.1, 0.01, 0.001] {
            assert!(sag(weight).abs() < 1.3e-5 * weight + 3e-4 * weight * weight + 1e-12, "{weight}: {}", sag(weight));
        }
    }
}

/// Every derivative of a state agrees with central differences of the full solve.
#[test]
fn derivatives_of_a_state_are_those_of_the_solve() {
    for (index, anchor) in anchors(40).enumerate() {
        for law in [
            steel(Shape::Catenary, index % 2 == 0),
            steel(Shape::FiniteElements(5), index % 2 == 1),
            CableLaw { kind: Kind::Stretching, ..steel(Shape::Catenary, true) },
        ] {
            let Ok(cable) = law.state(anchor, CableInput::OutletTension(700.0)) else { continue };
            let h = 1e-6;
            let at = |axis: usize, step: f64, known: CableInput| {
                let mut moved = anchor;
                moved[axis] += step;
                law.state(moved, known).unwrap()
            };
            let length = CableInput::ControlledLength(cable.controlled_length);
            let stiffest = (0..3).map(|k| cable.tangent[k][k].abs()).fold(0.0, f64::max);
            for axis in 0..3 {
                let slope = scale(0.5 / h, sub(at(axis, h, length).pull, at(axis, -h, length).pull));
                for row in 0..3 {
                    // truncation goes with h² and the curvature of the law
                    assert!(
                        (slope[row] - cable.tangent[row][axis]).abs() < 2e-5 * stiffest,
                        "{law:?} {anchor:?} {} {} {stiffest}",
                        slope[row],
                        cable.tangent[row][axis]
                    );
                    let (one, other) = (cable.tangent[row][axis], cable.tangent[axis][row]);
                    // The weight on the pulley is left out: at its edge, an asymmetry of w r_p at 700 N. A chain of
                    // elements takes up cable at all of them, not at the outlet alone: 1/n² of the weight's fraction.
                    let missing = match (law.kind, law.outlet.pulley().is_some()) {
                        (Kind::Sagging(_), true) => 1e-4,
                        (Kind::Sagging(Shape::FiniteElements(_)), false) => 1e-7,
                        _ => 1e-10,
                    };
                    assert!((one - other).abs() < missing * stiffest, "symmetric: {one} {other}");
                }
                let (ahead, behind) =
                    (at(axis, h, CableInput::OutletTension(700.0)), at(axis, -h, CableInput::OutletTension(700.0)));
                let slope = (ahead.controlled_length - behind.controlled_length) / (2.0 * h);
                assert!((slope - cable.controlled_length_by_anchor[axis]).abs() < 1e-7);
            }
            let (more, less) = (
                law.state(anchor, CableInput::OutletTension(701.0)).unwrap(),
                law.state(anchor, CableInput::OutletTension(699.0)).unwrap(),
            );
            let by_tension = 0.5 * (more.controlled_length - less.controlled_length);
            assert!((by_tension / cable.controlled_length_by_tension - 1.0).abs() < 1e-4);
            let pulls = scale(0.5, sub(more.pull, less.pull));
            assert!(distance(pulls, cable.by_tension) < 1e-5);
            let by_length: f64 = dot(cable.by_controlled_length, cable.direction) * by_tension;
            assert!((by_length - dot(pulls, cable.direction)).abs() < 1e-3);
        }
    }
}

/// Derivatives of end and controlled length by force, length, weight and radius.
type Dual = DualVec<f64, Const<8>>;

/// The equations written once more in dual numbers, which then differentiate them.
#[test]
fn equations_agree_with_dual_numbers() {
    let variable =
        |value: f64, index: usize| Dual::new(value, num_dual::Derivative::some(SVector::<f64, 8>::ith(index, 1.0)));
    let vector = |values: [f64; 3], first: usize| [0, 1, 2].map(|k| variable(values[k], first + k));
    for shape in shapes() {
        let law = steel(shape, true);
        let (&axis, &radius) = law.outlet.pulley().unwrap();
        let state = SpanState { force: [300.0, -150.0, -420.0], length: 7.3 };
        let dual_state = SpanState { force: vector(state.force, 0), length: variable(state.length, 3) };
        let weight = vector(law.weight, 4);
        let tension = dot(dual_state.force, dual_state.force).sqrt();
        let radius_dual = variable(radius, 7);
        let pulley = bent::Pulley { swivel_axis: axis.map(Dual::from), radius: radius_dual, side: 1.0 };
        let outlet = bent::outlet(&pulley, scale(Dual::from(1.0) / tension, dual_state.force));
        let end = add(outlet.contact, shape.vector(&dual_state, weight, &law.stretch));
        let strain = tension * 1e-7;
        let outside = radius_dual * outlet.wrap_angle + law.hidden_length - tension * law.series_compliance;
        let controlled = dual_state.length + outside / (strain + 1.0) - law.hidden_length;
        let evaluation = law.evaluate(shape, &state, 1.0);
        let gradient = |dual: &Dual| dual.eps.unwrap_generic(Const, Const::<1>);
        let plain = law.bent_pulley(1.0).unwrap();
        let direction = scale(1.0 / dot(state.force, state.force).sqrt(), state.force);
        let plain_outlet = bent::outlet(&plain, direction);
        for row in 0..4 {
            let dual = if row < 3 { end[row] } else { controlled };
            let expected = gradient(&dual);
            for column in 0..4 {
                let found = evaluation.by_state.0[row][column];
                assert!((found - expected[column]).abs() < 1e-13, "{shape:?} {row} {column}: {found} {expected}");
            }
            for axis in 0..3 {
                let mut unit = [0.0; 3];
                unit[axis] = 1.0;
                let change = Change::of_weight(unit);
                let (_, [span]) = shape.with_derivatives(&state, law.weight, &law.stretch, &[change]);
                let moved = law.moved(&law.frame_end(&state, 1.0), &change, span);
                let found = if row < 3 { moved.end[row] } else { moved.controlled_length };
                assert!((found - expected[4 + axis]).abs() < 1e-13, "{shape:?} {row} weight {axis}");
            }
            let (by_radius, wrapped) = plain_outlet.by_radius(&plain);
            let found = if row < 3 { by_radius[row] } else { wrapped / (1.0 + strain.value()) };
            assert!((found - expected[7]).abs() < 1e-13, "{shape:?} {row} radius");
        }
    }
}

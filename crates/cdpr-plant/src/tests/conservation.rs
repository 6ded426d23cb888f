//! Quantities that a machine without losses conserves, and the fall of errors with the step.

use nalgebra::Vector3;

use super::super::Command;
use super::super::events::CableBreak;
use super::*;

/// Euler's top: with all cables cut and no gravity, angular momentum and energy stay.
#[test]
fn a_free_body_keeps_energy_and_angular_momentum() {
    let mut robot = simulator();
    robot.gravity = Some(Vector3::zeros());
    robot.external_wrench = None;
    let plant = plant(robot, Composition::ELASTIC, 0.0);
    let mut state = at_home(&plant, 3000.0);
    (0..8).for_each(|cable| plant.apply(&mut state, &CableBreak { cable }));
    state.set_twist(&Twist::new(0.3, -0.2, 0.1, 2.0, 0.3, -1.5));
    let (momentum, energy) = (state.momentum, plant.energy(&state).unwrap().total());
    let center = state.pose.position + state.inertia.center(&state.pose);
    hold(&plant, &mut state, 1e-3, 20_000);
    assert_eq!(state.momentum, momentum, "forces of nothing");
    // rounding of 20 000 steps, which move and turn the body six times each
    assert!((plant.energy(&state).unwrap().total() / energy - 1.0).abs() < 1e-12);
    assert!((state.pose.rotation.norm() - 1.0).abs() < 1e-15);
    let moved = state.pose.position + state.inertia.center(&state.pose) - center;
    assert!((moved - momentum.linear * (20.0 / 604.5)).norm() < 1e-10, "the centre of mass goes straight");
    // relative to the platform's origin, as a twist is
    let (twist, arm) = (state.twist(), state.inertia.center(&state.pose));
    let seen = state.inertia.momentum(&state.pose, &twist);
    assert!((seen.angular - momentum.angular).norm() / momentum.angular.norm() < 1e-12, "{arm}");
}

/// A platform under air damping alone slows down as exp(−D t/m), and its turn about a principal axis as exp(−D t/J).
#[test]
fn damping_of_the_platform_slows_it_down() {
    let mut robot = simulator();
    robot.gravity = Some(Vector3::zeros());
    robot.external_wrench = None;
    robot.platform.center_of_mass = Some(Vector3::zeros());
    robot.platform.inertia = Some(Matrix3::from_diagonal(&Vector3::new(117.0, 121.0, 62.5)));
    (robot.platform.damping, robot.platform.rotational_damping) = (Some(300.0), Some(40.0));
    let plant = plant(robot, Composition::ELASTIC, 0.0);
    let mut state = at_home(&plant, 3000.0);
    (0..8).for_each(|cable| plant.apply(&mut state, &CableBreak { cable }));
    let start = Twist::new(0.3, -0.2, 0.1, 0.0, 0.0, -1.5);
    state.set_twist(&start);
    hold(&plant, &mut state, 1e-3, 1000);
    let (slower, turning) = ((-300.0_f64 / 604.5).exp(), (-40.0_f64 / 62.5).exp());
    let expected = Twist::from_fn(|row, _| start[row] * if row < 3 { slower } else { turning });
    // rounding of a thousand steps; the method is exact to (D h/m)⁵
    assert!((state.twist() - expected).amax() < 1e-13, "{}", state.twist());
}

/// Energies of a conservative robot over a time, one after every step.
fn energies(step: f64, seconds: f64) -> Vec<f64> {
    let plant = plant(simulator(), Composition::ELASTIC, 0.0);
    let rest = at_home(&plant, 6000.0);
    let mut state = displaced(&plant, &rest, &[0.004, -0.002, 0.003, 0.002, -0.003, 0.004]);
    let lengths: Vec<f64> = state.cables.iter().map(|cable| cable.controlled_length).collect();
    let zero = plant.energy(&rest).unwrap().total();
    let mut energies = vec![plant.energy(&state).unwrap().total() - zero];
    for _ in 0..(seconds / step).round() as usize {
        plant.step(&mut state, &Command::lengths(&lengths), step).unwrap();
        energies.push(plant.energy(&state).unwrap().total() - zero);
    }
    assert!(state.cables.iter().all(|cable| cable.tension > 0.0), "every cable stays taut");
    energies
}

fn oscillation(energies: &[f64]) -> f64 {
    let (low, high) = energies.iter().fold((f64::MAX, f64::MIN), |(low, high), &e| (low.min(e), high.max(e)));
    0.5 * (high - low) / energies[0]
}

/// At 1 ms over 60 s: the energy of the motion, averaged over a second, that is over ten periods and more, has a
/// relative trend below 1e-6.
#[test]
fn a_conservative_robot_keeps_its_energy_for_a_minute() {
    let energies = energies(1e-3, 60.0);
    let mean = |second: usize| energies[1000 * second..1000 * (second + 1)].iter().sum::<f64>() / 1000.0;
    let trend = (0..60).map(|second| (mean(second) / mean(0) - 1.0).abs()).fold(0.0, f64::max);
    println!("trend {trend:.1e}, oscillation {:.1e}", oscillation(&energies));
    assert!(trend < 1e-6, "{trend:e}");
    assert!(oscillation(&energies) < 1e-6, "{:e}", oscillation(&energies));
}

/// The amplitude of the energy's oscillation falls with the fourth power of the step, the order of the method.
#[test]
fn the_oscillation_of_the_energy_falls_with_the_order_of_the_method() {
    let [coarse, fine] = [8e-3, 4e-3].map(|step| oscillation(&energies(step, 4.0)));
    let order = (coarse / fine).log2();
    println!("oscillations {coarse:.2e} {fine:.2e}, order {order:.2}");
    assert!((3.5..5.5).contains(&order), "{order}");
}

/// Pose after one second at several steps: the error falls with the fourth power, for a robot in space with
/// translations and rotations, over pulleys or points, with dampers and without, and for one in a plane.
#[test]
fn the_method_has_order_four() {
    for (robot, damping, level, composition) in [
        (simulator(), 0.0, 6000.0, Composition::ELASTIC),
        (simulator(), 3000.0, 6000.0, Composition::ELASTIC),
        (plate(), 0.0, 60.0, Composition::ELASTIC),
    ] {
        let name = robot.name.clone();
        let plant = plant(robot, composition, damping);
        let rest = at_home(&plant, level);
        let small = [0.004, -0.003, 0.005, 0.004, -0.003, 0.004];
        let end = |step: f64| {
            let mut state = displaced(&plant, &rest, &small);
            hold(&plant, &mut state, step, (1.0 / step).round() as usize);
            state
        };
        let exact = end(2.5e-4);
        let [coarse, fine] = [4e-3, 2e-3].map(|step| apart(&end(step).pose, &exact.pose));
        let order = (coarse / fine).log2();
        println!("{name}, damping {damping}: {coarse:.2e} m at 4 ms, {fine:.2e} m at 2 ms, order {order:.2}");
        assert!((3.5..5.5).contains(&order), "{name}: {order}");
    }
}

/// A restored snapshot gives the same bits, independent of the steps in between.
#[test]
fn a_restored_snapshot_goes_on_to_the_same_bits() {
    let plant = plant(simulator(), Composition::ELASTIC, 500.0);
    let mut state = displaced(&plant, &at_home(&plant, 3000.0), &[0.05, 0.0, 0.0, 0.0, 0.05, 0.0]);
    hold(&plant, &mut state, 1e-3, 50);
    let snapshot = state.clone();
    hold(&plant, &mut state, 1e-3, 50);
    let mut again = snapshot.clone();
    plant.apply(&mut state, &CableBreak { cable: 2 });
    hold(&plant, &mut state, 1e-3, 10);
    hold(&plant, &mut again, 1e-3, 50);
    let mut first = snapshot;
    hold(&plant, &mut first, 1e-3, 50);
    assert_eq!(first, again);
    assert_eq!(first.pose.numbers().map(f64::to_bits), again.pose.numbers().map(f64::to_bits));
}

/// Acceleration and wrench are inverse to each other, and the rate of the momentum is the wrench about the centre of
/// mass.
#[test]
fn acceleration_and_wrench_are_inverse_to_each_other_and_to_the_motion() {
    let plant = plant(simulator(), Composition::ELASTIC, 0.0);
    let mut state = displaced(&plant, &at_home(&plant, 3000.0), &[0.01, 0.02, -0.03, 0.1, -0.2, 0.3]);
    let twist = Twist::new(0.5, -0.4, 0.3, 0.8, -0.7, 0.6);
    let wrench = Twist::new(100.0, -200.0, 300.0, 40.0, 50.0, -60.0);
    let inertia = state.inertia;
    let acceleration = inertia.acceleration(plant.model(), &state.pose, &twist, &wrench);
    let back = inertia.wrench_of_acceleration(&state.pose, &twist, &acceleration);
    assert!((back - wrench).amax() < 1e-9, "rounding of some hundreds of newtons");
    // the free body with that momentum, under a wrench for a short time h: central differences of its twist
    state.set_twist(&twist);
    let h = 1e-4; // truncation ~ h², rounding ~ ε/h
    let side = |h: f64| {
        let rate = inertia.rate(&inertia.center(&state.pose), &wrench);
        let momentum = super::super::kicks::added(&state.momentum, &rate, h);
        inertia.twist(&inertia.drift(&state.pose, &state.momentum, h).unwrap(), &momentum)
    };
    let slope = (side(h) - side(-h)) / (2.0 * h);
    assert!((slope - acceleration).amax() < 1e-6, "{slope} {acceleration}");
}

//! Winches with inertia.

use super::super::plant::Drum;
use super::*;

fn with_drums(coulomb: f64, damping: f64) -> Plant {
    let mut robot = simulator();
    for cable in &mut robot.cables {
        // the energy of a spring is a function of q − q_θ: drums exchange energy with the cables
        cable.stiffness = Some(CableStiffness::Spring(2e5));
        cable.winch.radius = Some(0.1525);
        cable.winch.drum_inertia = Some(0.6);
        cable.winch.coulomb_friction = Some(coulomb);
    }
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    let damping = vec![Damping { constant: damping, time: 0.0 }; 8];
    Plant::with_damping(model, Winches::Drums, damping).unwrap()
}

/// Torques that hold the start do the work τ φ: with it the energy of platform, cables and drums is constant.
#[test]
fn drums_give_and_take_what_cables_store() {
    let plant = with_drums(0.0, 0.0);
    let rest = at_home(&plant, 6000.0);
    let torques = plant.holding_torques(&rest).unwrap();
    let mut state = rest.clone();
    state.set_twist(&Twist::new(0.02, -0.01, 0.03, 0.01, 0.02, -0.01));
    let energy = |state: &PlantState| {
        let work: f64 = state
            .cables
            .iter()
            .zip(&rest.cables)
            .zip(&torques)
            .map(|((now, start), torque)| torque * (now.drum_angle - start.drum_angle))
            .sum();
        plant.energy(state).unwrap().total() + work
    };
    let (start, moving) = (energy(&state), plant.energy(&state).unwrap().kinetic);
    for _ in 0..500 {
        plant.step(&mut state, &Command::torques(&torques), 1e-3).unwrap();
    }
    let moved = state.cables.iter().zip(&rest.cables).map(|(a, b)| (a.drum_angle - b.drum_angle).abs());
    assert!(moved.fold(0.0, f64::max) > 1e-3, "the drums turn");
    assert!((energy(&state) - start).abs() < 1e-6 * moving, "{:e}", (energy(&state) - start) / moving);
}

/// Friction holds drums below its torque, and above it they slide; a brake (commands of lengths) always holds them.
#[test]
fn friction_sticks_and_slides() {
    let plant = with_drums(50.0, 3000.0);
    let rest = at_home(&plant, 6000.0);
    let torques = plant.holding_torques(&rest).unwrap();
    let turned = |more: f64, steps: usize| {
        let mut state = rest.clone();
        let told: Vec<f64> = torques.iter().map(|torque| torque + more).collect();
        for _ in 0..steps {
            plant.step(&mut state, &Command::torques(&told), 1e-3).unwrap();
        }
        state.cables[0].drum_angle - rest.cables[0].drum_angle
    };
    assert_eq!(turned(49.0, 100), 0.0);
    assert!(turned(60.0, 100) < -1e-6, "reels in: {}", turned(60.0, 100));
    assert!(turned(-60.0, 100) > 1e-6, "pays out");
    let mut braked = displaced(&plant, &rest, &[0.02, 0.0, 0.0, 0.0, 0.0, 0.0]);
    hold(&plant, &mut braked, 1e-3, 100);
    assert_eq!(braked.cables[0].drum_angle, rest.cables[0].drum_angle);
}

/// Linearised, a drum on a cable fixed at its other end has the natural frequency √(k r²/J).
#[test]
fn a_drum_on_a_cable_has_its_natural_frequency() {
    let mut plant = with_drums(0.0, 0.0);
    // a platform that is practically fixed
    plant.inertia.body.mass = 1e9;
    plant.inertia.body.inertia *= 1e9;
    plant.drums.iter_mut().for_each(|drum| *drum = Drum { inertia: 0.6, ..*drum });
    let state = at_home(&plant, 6000.0);
    let modes = plant.linearize(&state).unwrap().modes().unwrap();
    let expected = 0.1525 * (2e5_f64 / 0.6).sqrt() / std::f64::consts::TAU;
    for mode in &modes[6..] {
        assert!((mode.frequency / expected - 1.0).abs() < 1e-4, "{} {expected}", mode.frequency);
    }
}

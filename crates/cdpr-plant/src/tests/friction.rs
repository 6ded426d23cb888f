//! Friction of drums and pulleys: its losses, its hold, and its limits.

use super::super::error_control::Passage;
use super::*;
use cdpr_model::model::place_pulleys;
use cdpr_model::robot::Cable;

/// The simulator over pulleys on drums, with these frictions.
fn machine(change: impl Fn(&mut Cable)) -> Plant {
    let mut robot = simulator();
    for cable in &mut robot.cables {
        // the energy of a spring is a function of q − q_θ
        cable.stiffness = Some(CableStiffness::Spring(2e5));
        cable.winch.radius = Some(0.1525);
        cable.winch.drum_inertia = Some(0.6);
        cable.winch.viscous_friction = Some(5.0);
    }
    let mut robot = place_pulleys(&robot, &[(0.161, Vector3::z()); 8], &robot.home_or_middle()).unwrap();
    robot.cables.iter_mut().for_each(change);
    Plant::new(Model::new(robot, "pulley+elastic".parse().unwrap()).unwrap(), Winches::Drums).unwrap()
}

fn coulomb(cable: &mut Cable, sliding: f64, standing: Option<(f64, f64)>) {
    cable.winch.coulomb_friction = Some(sliding);
    cable.winch.static_friction = standing.map(|(torque, _)| torque);
    cable.winch.stribeck_speed = standing.map(|(_, speed)| speed);
}

/// Torques that hold the start, plus `more` (N·m).
fn torques(plant: &Plant, rest: &PlantState, more: f64) -> Vec<f64> {
    plant.holding_torques(rest).unwrap().iter().map(|torque| torque + more).collect()
}

fn run(plant: &Plant, state: &mut PlantState, torques: &[f64], step: f64, seconds: f64) {
    for _ in 0..(seconds / step).round() as usize {
        plant.step(state, &Command::torques(torques), step).unwrap();
    }
}

/// Power lost to friction (W), computed independently from the speeds of the drums and the tensions at the outlets.
fn loss(plant: &Plant, state: &PlantState) -> f64 {
    let robot = plant.model().robot();
    let of = |(index, cable): (usize, &super::super::CableMotion)| {
        let (winch, speed) = (&robot.cables[index].winch, cable.drum_speed);
        let sliding = winch.coulomb_friction.unwrap_or(0.0);
        let excess = winch.static_friction.unwrap_or(sliding) - sliding;
        let dry = sliding + excess * (-(speed / winch.stribeck_speed.unwrap_or(1.0)).powi(2)).exp();
        let wrap = plant.model().path(index, &state.pose).unwrap().0.wrap_angle;
        let exponent = robot.cables[index].pulley_friction.unwrap_or(0.0) * wrap;
        let passed_on = if speed > 0.0 { (-exponent).exp() } else { exponent.exp() };
        // paid out, the drum's side of the pulley has less tension than the outlet; reeled in, more
        let at_pulley = cable.tension * 0.1525 * speed * (1.0 - passed_on);
        dry * speed.abs() + winch.viscous_friction.unwrap() * speed * speed + at_pulley
    };
    state.cables.iter().enumerate().map(of).sum()
}

/// While drums slide: stored energy + friction losses = work of the motors.
#[test]
fn what_friction_takes_is_missing_in_the_energy() {
    for (more, name) in [(-80.0, "paid out"), (200.0, "reeled in")] {
        let plant = machine(|cable| {
            coulomb(cable, 10.0, Some((15.0, 0.3)));
            cable.pulley_friction = Some(0.03);
            cable.pulley_inertia = Some(0.2);
        });
        let rest = at_home(&plant, 6000.0);
        let told = torques(&plant, &rest, more);
        let mut state = rest.clone();
        // past the first reversal of every drum, after which its direction is constant for a while
        run(&plant, &mut state, &told, 1e-3, 0.005);
        let begin = state.clone();
        let energy = |state: &PlantState| plant.energy(state).unwrap().total();
        let work = |state: &PlantState| -> f64 {
            let drums = state.cables.iter().zip(&begin.cables).zip(&told);
            drums.map(|((now, start), torque)| torque * (start.drum_angle - now.drum_angle)).sum()
        };
        let (step, count) = (2.5e-4, 80);
        let mut taken = 0.0;
        for index in 0..=count {
            // Simpson's rule
            let weight = if index == 0 || index == count { 1.0 } else { f64::from(2 + 2 * (index % 2)) };
            taken += weight * step / 3.0 * loss(&plant, &state);
            if index < count {
                run(&plant, &mut state, &told, step, step);
            }
        }
        let way =
            |(a, b): (&super::super::CableMotion, &super::super::CableMotion)| (a.drum_angle - b.drum_angle).abs();
        assert!(state.cables.iter().zip(&begin.cables).map(way).fold(f64::MAX, f64::min) > 1e-4, "every drum turns");
        let missing = work(&state) - (energy(&state) - energy(&begin)) - taken;
        println!("{name}: friction took {taken:.4} J, {missing:.1e} J are missing");
        assert!(taken > 0.1 && missing.abs() < 1e-6 * taken, "{name}: {missing:e} of {taken}");
    }
}

/// In their limits the laws with more terms agree with the simple ones: static friction equal to Coulomb's and a pulley without friction to the last
/// bit, a Stribeck speed that no drum reaches or that every drum exceeds to the rounding of another rule for kicks.
#[test]
fn the_limits_of_friction_are_the_laws_without_it() {
    let end = |change: &dyn Fn(&mut Cable)| {
        let plant = machine(change);
        let rest = at_home(&plant, 6000.0);
        let mut state = rest.clone();
        // all drums already turn: one that starts has its static friction at least at its first evaluation
        for cable in &mut state.cables {
            (cable.drum_speed, cable.controlled_length_rate) = (0.5, 0.5 * 0.1525);
        }
        run(&plant, &mut state, &torques(&plant, &rest, -100.0), 1e-3, 0.02);
        (state.pose, state.cables.iter().map(|cable| cable.drum_speed).collect::<Vec<_>>())
    };
    let plain = |sliding: f64| end(&move |cable| coulomb(cable, sliding, None));
    assert_eq!(end(&|cable| coulomb(cable, 20.0, Some((20.0, 0.1)))), plain(20.0));
    for (speed, sliding) in [(1e-9, 20.0), (1e12, 50.0)] {
        let (found, expected) = (end(&|cable| coulomb(cable, 20.0, Some((50.0, speed)))), plain(sliding));
        let gaps = found.1.iter().zip(&expected.1).map(|(a, b)| (a - b).abs());
        // speeds of 1 rad/s, kicks of 1e-13 of their change
        assert!(apart(&found.0, &expected.0) < 1e-12 && gaps.fold(0.0, f64::max) < 1e-11, "{found:?} {expected:?}");
    }
    let without = |cable: &mut Cable| {
        coulomb(cable, 20.0, None);
        (cable.pulley_friction, cable.pulley_inertia) = (Some(0.0), Some(0.0));
    };
    assert_eq!(end(&without), plain(20.0));
    assert_ne!(end(&|cable| coulomb(cable, 20.0, Some((50.0, 0.3)))), plain(20.0));
    // the difference falls with μ
    let gap = |friction: f64| {
        let rough = end(&move |cable| {
            coulomb(cable, 20.0, None);
            cable.pulley_friction = Some(friction);
        });
        apart(&rough.0, &plain(20.0).0)
    };
    let ratio = gap(1e-3) / gap(1e-4);
    assert!((ratio - 10.0).abs() < 0.1, "{ratio}");
}

/// A drum at rest begins to turn where its torque leaves the range held by Coulomb and Stribeck friction and the
/// pulley.
#[test]
fn drums_stick_up_to_their_static_friction_and_that_of_the_pulley() {
    let plant = machine(|cable| {
        coulomb(cable, 20.0, Some((50.0, 0.3)));
        cable.pulley_friction = Some(0.05);
    });
    let rest = at_home(&plant, 6000.0);
    let turned = |more: f64| {
        let mut state = rest.clone();
        // one drum alone
        let mut told = torques(&plant, &rest, 0.0);
        told[2] += more;
        run(&plant, &mut state, &told, 1e-3, 0.01);
        state.cables[2].drum_angle - rest.cables[2].drum_angle
    };
    let wrap = plant.model().path(2, &rest.pose).unwrap().0.wrap_angle;
    let pull = 0.1525 * rest.cables[2].tension;
    let (out, back) = (pull * (1.0 - (-0.05 * wrap).exp()) + 50.0, pull * ((0.05 * wrap).exp() - 1.0) + 50.0);
    assert!(out > 60.0 && back > out, "the pulley holds, too: {out} {back}");
    assert_eq!((turned(back - 0.1), turned(0.1 - out)), (0.0, 0.0));
    assert!(turned(back + 0.1) < 0.0 && turned(-0.1 - out) > 0.0);
}

/// Drums that stick, slide and reverse, with a snapshot that is restored.
#[test]
fn a_restored_snapshot_of_drums_with_friction_goes_on_to_the_same_bits() {
    let plant = machine(|cable| {
        coulomb(cable, 20.0, Some((50.0, 0.3)));
        cable.pulley_friction = Some(0.05);
    });
    let mut state = displaced(&plant, &at_home(&plant, 3000.0), &[0.05, 0.0, 0.0, 0.0, 0.05, 0.0]);
    let told = torques(&plant, &state, 0.0);
    run(&plant, &mut state, &told, 1e-3, 0.05);
    let (snapshot, mut again) = (state.clone(), state.clone());
    run(&plant, &mut state, &told, 1e-3, 0.1);
    let stuck = |state: &PlantState| state.cables.iter().filter(|cable| cable.is_stuck).count();
    assert!(state.cables.iter().any(|cable| cable.drum_speed != 0.0) || stuck(&state) != stuck(&snapshot));
    run(&plant, &mut again, &told, 1e-3, 0.1);
    assert_eq!(state, again);
}

/// A pulley that turns with its drum's rim adds inertia to the drum, by the squared ratio of their radii.
#[test]
fn inertia_of_a_pulley_counts_at_its_drum() {
    let plain = machine(|cable| cable.winch.drum_inertia = Some(0.6 + 0.4 * (0.1525_f64 / 0.161).powi(2)));
    let turning = machine(|cable| cable.pulley_inertia = Some(0.4));
    for (a, b) in plain.drums.iter().zip(&turning.drums) {
        assert!((a.inertia - b.inertia).abs() < 1e-15);
    }
}

/// If friction falls with speed, drums accelerate faster: the step must follow them.
#[test]
fn steps_too_large_for_a_steep_fall_of_friction_are_refused() {
    let scenario = |speed: f64, more: &str, change: &dyn Fn(&mut Cable)| {
        let text = "[machine]\nrobot = \"x\"\nmodel = \"pulley+elastic\"\nwinches = \"drums\"\n[start]\npose = [0, 0, 1.5, 0, 0, 0]\n\
                    tension_method = \"closed-form\"\n[control]\nkind = \"torques\"\n[time]\nduration_s = 0.01\n"
            .to_owned()
            + more;
        let scenario = super::super::Scenario::from_toml_bytes(text.as_bytes(), "s.toml").unwrap();
        let plant = machine(|cable| {
            coulomb(cable, 20.0, Some((50.0, speed)));
            change(cable);
        });
        super::super::Simulation::new(&scenario, plant.model().robot().clone())
    };
    let same = |_: &mut Cable| {};
    assert!(scenario(0.1, "", &same).is_ok());
    // 30 N·m √(2/e)/1e-3 rad/s over 0.6 kg m²
    let error = scenario(1e-3, "", &same).unwrap_err().to_string();
    assert!(error.contains("too large") && error.contains("step_s = 2.0e-5"), "{error}");
}

/// Drums that stick, slide and turn round, against the integrator with error control, which cuts its steps at the same switches by itself: order four.
#[test]
fn switches_of_drums_are_met_as_an_integrator_with_error_control_meets_them() {
    // friction that falls with speed is as fast as the drum passes its Stribeck speed: `judges/friction`
    let plant = machine(|cable| {
        coulomb(cable, 10.0, None);
        cable.pulley_friction = Some(0.01);
    });
    let start = at_home(&plant, 6000.0);
    let told = Command::torques(&torques(&plant, &start, 0.0));
    let start = displaced(&plant, &start, &[0.02, 0.0, 0.0, 0.0, 0.02, 0.0]);
    let (time, mut expected, mut switches) = (0.25, start.clone(), 0);
    let passage = Passage { time, tolerance: 1e-12, wrenches: [cdpr_model::geometry::Wrench::zeros(); 2] };
    let mut stuck = vec![true; 8];
    let mut count = |state: &PlantState| {
        let now: Vec<bool> = state.cables.iter().map(|cable| cable.is_stuck).collect();
        switches += now.iter().zip(&stuck).filter(|(now, before)| now != before).count();
        stuck = now;
    };
    plant.advance(&mut expected, &told, &passage, &mut count).unwrap();
    assert!(switches > 20, "{switches} switches");
    let [coarse, fine] = [1e-3, 5e-4].map(|step| {
        let mut state = start.clone();
        for _ in 0..(time / step).round() as usize {
            plant.step(&mut state, &told, step).unwrap();
        }
        for (found, expected) in state.cables.iter().zip(&expected.cables) {
            assert_eq!((found.is_stuck, found.is_stuck && found.drum_speed != 0.0), (expected.is_stuck, false));
            // a cable has some 2e5 N/m
            assert!((found.tension - expected.tension).abs() < 1e-2, "{} {}", found.tension, expected.tension);
        }
        apart(&state.pose, &expected.pose)
    });
    println!("{switches} switches, {coarse:.1e} and {fine:.1e} m");
    assert!(coarse < 1e-9 && coarse > 8.0 * fine, "{coarse:e} {fine:e}");
}

/// A drum that stands is held by what its cable and motor leave: the log's friction torque, which balances both.
#[test]
fn the_friction_of_a_drum_that_stands_is_its_reaction() {
    let plant = machine(|cable| coulomb(cable, 20.0, Some((50.0, 0.3))));
    let rest = at_home(&plant, 6000.0);
    assert!((0..8).all(|drum| rest.cables[drum].is_stuck && plant.friction_torque(&rest, drum) == Some(0.0)));
    let mut state = rest.clone();
    run(&plant, &mut state, &torques(&plant, &rest, -30.0), 1e-3, 0.01);
    for drum in 0..8 {
        assert!((plant.friction_torque(&state, drum).unwrap() - 30.0).abs() < 1e-9 && state.cables[drum].is_stuck);
    }
    // T_s at the moment it begins to turn, T_c + (T_s − T_c) exp(−(φ̇/φ̇_s)²) + d φ̇ later
    run(&plant, &mut state, &torques(&plant, &rest, -80.0), 1e-3, 0.002);
    let speed = state.cables[0].drum_speed;
    let expected = 20.0 + 30.0 * (-(speed / 0.3).powi(2)).exp() + 5.0 * speed;
    assert!(
        speed > 0.01
            && !state.cables[0].is_stuck
            && (plant.friction_torque(&state, 0).unwrap() - expected).abs() < 1e-12,
        "{speed} {expected}"
    );
}

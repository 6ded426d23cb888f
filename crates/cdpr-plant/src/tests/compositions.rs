//! Every composition: rest is the static library's equilibrium, and stiffness the derivative of forces.

use super::super::events::{LoadChange, WrenchChange};
use super::*;
use cdpr_model::model::place_pulleys;
use cdpr_model::statics::Load;

/// A rope with hysteresis.
pub(super) fn rope() -> cdpr_model::robot::HysteresisTable {
    cdpr_model::robot::HysteresisTable {
        strain: vec![0.0, 2e-3, 5e-3, 1e-2],
        loading_N: vec![0.0, 3.5e3, 9.5e3, 2.1e4],
        unloading_N: vec![0.0, 3.0e3, 9.0e3, 2.05e4],
        transition_strain: vec![4e-4],
        loading_slope_N: None,
        unloading_slope_N: None,
        transition_share: None,
    }
}

/// The simulator with every key that effects need.
fn complete() -> Robot {
    let mut robot = simulator();
    for cable in &mut robot.cables {
        let stiffness = cable.stiffness;
        cdpr_model::robot::LAWS.iter().for_each(|law| law.exemplify(cable, 1.5e6));
        cable.stiffness = stiffness;
        cable.linear_density = Some(0.7);
        cable.hidden_length = Some(9.0);
        cable.series_compliance = Some(2e-7);
        cable.tension_of_strain = Some(vec![1.5e6, 6e7]);
        cable.tension_max = Some(20_000.0);
        cable.hysteresis = Some(rope());
    }
    let pulleys = vec![(0.161, Vector3::z()); 8];
    place_pulleys(&robot, &pulleys, &robot.home_or_middle()).unwrap()
}

/// Compositions that stretch; drums wind as ideal winches do.
fn stretching() -> impl Iterator<Item = Composition> {
    Composition::all().filter(|composition| composition.is_elastic() && !composition.drum)
}

/// At rest nothing moves: half a second after the start the pose is still that at which tensions balance the load.
#[test]
fn every_composition_rests_where_its_tensions_balance_the_load() {
    let mut count = 0;
    for composition in stretching() {
        let plant = plant(complete(), composition, 200.0);
        let start = at_home(&plant, 4000.0);
        let mut state = start.clone();
        let steps = if plant.sags { 20 } else { 200 };
        hold(&plant, &mut state, 1e-3, steps);
        let moved = apart(&start.pose, &state.pose);
        // residual of the balance, 1e-7 N and N·m, over a stiffness of 1e6 N/m and N·m/rad; a sagging rope has the
        // memory of the strain at its outlet and stretches by that in its middle, which is less by its weight
        let remembers_with_weight = plant.sags && composition.stretch == cdpr_model::model::StretchEffect::Hysteresis;
        let tolerance = if remembers_with_weight { 1e-5 } else { 1e-9 };
        assert!(moved < tolerance, "{composition}: {moved:e}");
        count += 1;
    }
    assert_eq!(count, 6 * cdpr_model::robot::LAWS.len());
}

/// Displaced and damped, every composition without memory comes to rest at `Model::forward` of its lengths; with
/// hysteresis the equilibrium depends on the path.
#[test]
fn a_damped_machine_comes_to_rest_at_the_forward_problem() {
    for composition in ["elastic", "pulley+elastic", "polynomial", "pulley+elastic+catenary"] {
        let composition: Composition = composition.parse().unwrap();
        let plant = plant(complete(), composition, 9000.0);
        let rest = at_home(&plant, 4000.0);
        let mut state = displaced(&plant, &rest, &[0.02, -0.01, 0.015, 0.01, 0.02, -0.01]);
        let lengths: Vec<f64> = state.cables.iter().map(|cable| cable.controlled_length).collect();
        plant.apply(&mut state, &WrenchChange(Twist::new(100.0, 50.0, -300.0, 20.0, -40.0, 30.0)));
        let load = plant.model().robot().external_wrench.as_ref().unwrap().wrench + state.external;
        hold(&plant, &mut state, 2e-3, if plant.sags { 1500 } else { 4000 });
        let mut robot = plant.model().robot().clone();
        robot.external_wrench.as_mut().unwrap().wrench = load;
        let load = Load::of(&robot).unwrap();
        let mut solved = cdpr_model::equilibrium::State::at_home(plant.model());
        let found = plant.model().forward(&lengths, Some(&load), Some(&rest.pose), &mut solved).unwrap();
        let gap = apart(&found.pose, &state.pose);
        println!("{composition}: {gap:.1e} m");
        assert!(gap < 1e-9, "{composition}: {gap:e}");
        for (cable, tension) in state.cables.iter().zip(&found.tensions) {
            assert!((cable.tension - tension).abs() < 1e-3, "{composition}");
        }
    }
}

/// The linearisation against central differences of the wrench on the platform, for every composition: at rest, and
/// with a load taken up.
#[test]
fn the_stiffness_is_the_derivative_of_the_wrench() {
    for composition in stretching() {
        let plant = plant(complete(), composition, 100.0);
        let mut state = at_home(&plant, 4000.0);
        plant.apply(&mut state, &LoadChange { mass: 50.0, place: Vector3::new(0.5, -0.2, 0.3) });
        plant.observe(&mut state).unwrap();
        let linear = plant.linearize(&state).unwrap();
        let wrench = |state: &PlantState| {
            let mut state = state.clone();
            state.pulls.find(&plant, &state.pose, &mut state.cables).unwrap();
            state.pulls.wrench_at_rest() + state.load(&plant)
        };
        // along one branch of a hysteresis no common direction has increasing strain in every cable, so it is left out
        if state.cables[0].memory.is_some() {
            continue;
        }
        let h = 1e-5; // truncation ~ h², rounding 1e-8 N/h of a sagging cable
        let largest = linear.stiffness.amax();
        for column in 0..6 {
            let side = |h: f64| {
                let mut moved = state.clone();
                moved.set_pose(state.pose.displaced(&Twist::ith(column, h)));
                wrench(&moved)
            };
            let slope = (side(h) - side(-h)) / (2.0 * h);
            let gap = (0..6).map(|row| (slope[row] + linear.stiffness[(row, column)]).abs()).fold(0.0, f64::max);
            assert!(gap < 2e-7 * largest, "{composition}: {gap:e} of {largest:e}");
        }
        for cable in 0..8 {
            let side = |h: f64| {
                let mut moved = state.clone();
                moved.cables[cable].controlled_length += h;
                wrench(&moved)
            };
            let slope = (side(h) - side(-h)) / (2.0 * h);
            let gap = (0..6).map(|row| (slope[row] - linear.inputs[(row, 6 + cable)]).abs()).fold(0.0, f64::max);
            assert!(gap < 2e-7 * largest, "{composition}, length: {gap:e} of {largest:e}");
        }
    }
}

/// A load that is taken up hangs at the library's equilibrium, in space and for a point.
#[test]
fn a_load_leads_to_the_equilibrium_with_its_weight() {
    let plant = plant(simulator(), Composition::ELASTIC, 9000.0);
    let rest = at_home(&plant, 4000.0);
    let mut state = rest.clone();
    let place = Vector3::new(0.4, -0.3, 0.2);
    plant.apply(&mut state, &LoadChange { mass: 80.0, place });
    hold(&plant, &mut state, 2e-3, 4000);
    let mut robot = plant.model().robot().clone();
    let body = cdpr_model::robot::Body::of(&robot).unwrap().with_point_mass(80.0, &place).unwrap();
    robot.platform.mass = Some(body.mass);
    robot.platform.center_of_mass = Some(body.center_of_mass);
    let lengths: Vec<f64> = rest.cables.iter().map(|cable| cable.controlled_length).collect();
    let mut solved = cdpr_model::equilibrium::State::at_home(plant.model());
    let load = Load::of(&robot).unwrap();
    let found = plant.model().forward(&lengths, Some(&load), Some(&rest.pose), &mut solved).unwrap();
    assert!(apart(&found.pose, &state.pose) < 1e-9, "{:e}", apart(&found.pose, &state.pose));
}

/// A cable never pushes: neither a slack law nor a compressed damper; and a damper of a slack cable pulls only while
/// the sum of law and damper is positive.
#[test]
fn law_and_damper_are_clipped_together() {
    let plant = plant(simulator(), Composition::ELASTIC, 5000.0);
    let mut state = at_home(&plant, 3000.0);
    let towards = |state: &PlantState, cable: usize, speed: f64| {
        let column = state.pulls.columns[cable];
        Twist::new(column[0], column[1], column[2], 0.0, 0.0, 0.0) * speed
    };
    // towards the outlet: the cable shortens
    let twist = towards(&state, 0, 5.0);
    state.set_twist(&twist);
    plant.observe(&mut state).unwrap();
    assert_eq!(state.cables[0].tension, 0.0);
    let (law, before) = (state.pulls.laws[0], state.cables[0].controlled_length);
    let twist = towards(&state, 0, -0.1);
    state.set_twist(&twist);
    plant.observe(&mut state).unwrap();
    let expected = law.tension + 5000.0 * 0.1;
    assert!((state.cables[0].tension - expected).abs() < 1e-6);
    // a law 200 N below zero with a damper that pulls 500 N
    let stiffness = plant.model().law(0).continued_tension(state.cables[0].length, before, None).unwrap();
    state.cables[0].controlled_length += (stiffness.value + 200.0) / -stiffness.by_controlled_length;
    plant.observe(&mut state).unwrap();
    assert!((200.0..400.0).contains(&state.cables[0].tension), "{}", state.cables[0].tension);
}

//! Small motions: modes of the linearisation have the frequencies of the time series.

use super::*;

/// The state displaced along a mode, by too little for nonlinear geometry to matter.
fn along(plant: &Plant, rest: &PlantState, mode: usize, size: f64) -> (PlantState, Vec<super::super::Mode>) {
    let modes = plant.linearize(rest).unwrap().modes().unwrap();
    let shape = &modes[mode].shape;
    let scaled: Vec<f64> = shape.iter().map(|part| part / shape.amax() * size).collect();
    (displaced(plant, rest, &scaled), modes)
}

/// Frequency of an oscillating number from its zero crossings, interpolated between two steps (Hz).
fn frequency(values: &[f64], step: f64) -> f64 {
    let mut crossings = Vec::new();
    for (index, pair) in values.windows(2).enumerate() {
        if pair[0] < 0.0 && pair[1] >= 0.0 {
            crossings.push((index as f64 + pair[0] / (pair[0] - pair[1])) * step);
        }
    }
    (crossings.len() - 1) as f64 / (crossings[crossings.len() - 1] - crossings[0])
}

#[test]
fn every_mode_swings_with_its_frequency() {
    for (robot, level, composition) in
        [(simulator(), 6000.0, "elastic"), (plate(), 60.0, "elastic"), (simulator(), 6000.0, "pulley+elastic")]
    {
        let composition: Composition = composition.parse().unwrap();
        let robot = match composition.pulley {
            true => {
                let home = robot.home_or_middle();
                cdpr_model::model::place_pulleys(&robot, &[(0.161, Vector3::z()); 8], &home).unwrap()
            }
            false => robot,
        };
        let plant = plant(robot, composition, 0.0);
        let rest = at_home(&plant, level);
        for mode in 0..plant.model().dof() {
            let (mut state, modes) = along(&plant, &rest, mode, 1e-5);
            let mode = &modes[mode];
            let (row, _) = mode.shape.argmax();
            let row = if mode.shape[row].abs() < mode.shape.amax() { mode.shape.iamax() } else { row };
            let basis = plant.model().twist_basis()[row];
            let step = 5e-4;
            let mut series = Vec::new();
            for _ in 0..(10.0 / mode.frequency / step) as usize {
                hold(&plant, &mut state, step, 1);
                series.push(basis.dot(&rest.pose.displacement_to(&state.pose)));
            }
            let found = frequency(&series, step);
            assert!((found / mode.frequency - 1.0).abs() < 1e-3, "{found} {}", mode.frequency);
            assert!((mode.participation.sum() - 1.0).abs() < 1e-9);
        }
    }
}

/// The amplitude of a damped mode falls as exp(−ζ ω t).
#[test]
fn a_damped_mode_decays_by_its_ratio() {
    let plant = plant(simulator(), Composition::ELASTIC, 400.0);
    let rest = at_home(&plant, 6000.0);
    let (state, modes) = along(&plant, &rest, 5, 1e-5);
    let mode = &modes[5];
    let zero = plant.energy(&rest).unwrap().total();
    let energy = |state: &PlantState| plant.energy(state).unwrap().total() - zero;
    let mut later = state.clone();
    let periods = 10.0;
    // whole periods of the damped oscillation, at whose ends the fraction of kinetic energy is the same
    let omega = std::f64::consts::TAU * mode.frequency;
    let time = periods * std::f64::consts::TAU / (omega * (1.0 - mode.damping_ratio.powi(2)).sqrt());
    hold(&plant, &mut later, time / 2000.0, 2000);
    let found = -(energy(&later) / energy(&state)).ln() / (2.0 * omega * time);
    println!("damping ratio {found:.6}, linear {:.6}", mode.damping_ratio);
    // dampers couple the modes, more strongly for larger ratios
    assert!((found / mode.damping_ratio - 1.0).abs() < 0.03, "{found} {}", mode.damping_ratio);
}

/// A and B of the linearisation against differences of the whole motion over a short time.
#[test]
fn the_system_matrix_is_the_derivative_of_the_motion() {
    let plant = plant(simulator(), Composition::ELASTIC, 2000.0);
    let rest = at_home(&plant, 6000.0);
    let linear = plant.linearize(&rest).unwrap();
    let (a, b) = (linear.system_matrix().unwrap(), linear.input_matrix().unwrap());
    let (time, h) = (1e-4, 1e-6);
    // exp(A t) by its series
    let flow = (1..12).rev().fold(nalgebra::DMatrix::identity(12, 12), |sum, k| {
        nalgebra::DMatrix::identity(12, 12) + &a * sum * (time / f64::from(k))
    });
    let numbers = |state: &PlantState| {
        let (away, twist) = (rest.pose.displacement_to(&state.pose), state.twist());
        nalgebra::DVector::from_fn(12, |row, _| if row < 6 { away[row] } else { twist[row - 6] })
    };
    for column in 0..12 {
        let side = |h: f64| {
            let mut state = rest.clone();
            match column < 6 {
                true => state.set_pose(rest.pose.displaced(&Twist::ith(column, h))),
                false => state.set_twist(&Twist::ith(column - 6, h)),
            }
            hold(&plant, &mut state, time / 10.0, 10);
            numbers(&state)
        };
        let slope = (side(h) - side(-h)) / (2.0 * h);
        let gap = (slope - flow.column(column)).amax() / flow.column(column).amax();
        assert!(gap < 1e-6, "column {column}: {gap:e}");
    }
    // a length paid out at once changes the twist by B t
    for cable in 0..8 {
        let side = |h: f64| {
            let mut state = rest.clone();
            state.cables[cable].controlled_length += h;
            let time = 1e-5;
            hold(&plant, &mut state, time, 1);
            numbers(&state) / time
        };
        let slope = (side(h) - side(-h)) / (2.0 * h);
        let column = b.column(6 + cable);
        // the twist of the first 10 µs has changed by ω t, a thousandth
        assert!((slope.rows(6, 6) - column.rows(6, 6)).amax() < 2e-3 * column.amax(), "cable {cable}");
    }
}

//! A and B of the linearisation against dual numbers of the whole motion, written independently: outlets and laws in
//! dual numbers, Newton and Euler about the centre of mass instead of the platform origin, drums by the radius that a
//! spool loses with every turn.

use nalgebra::{Const, DMatrix, SVector};

use super::super::events::{CableBreak, LoadChange, Slip};
use super::super::plant::Drum;
use super::dual_laws::{COUNT, Dual, law_of};
use super::*;
use cdpr_model::cable::stretch::hysteresis::{Memory, TRANSITION_LIMIT};
use cdpr_model::model::place_pulleys;
use cdpr_model::scalar::{Real, add, cross, dot, rotate, rotate_back, scale, sub};

/// First index of each group of variables: displacement and twist (six each), angles and speeds of drums, wrench,
/// controlled lengths or torques, and their rates.
const POSE: usize = 0;
const TWIST: usize = 6;
const ANGLE: usize = 12;
const SPEED: usize = 20;
const WRENCH: usize = 28;
const INPUT: usize = 34;
const RATE: usize = 42;

fn variable(value: f64, index: usize) -> Dual {
    Dual::new(value, num_dual::Derivative::some(SVector::<f64, COUNT>::ith(index, 1.0)))
}

fn vector(values: [f64; 3], first: usize) -> [Dual; 3] {
    [0, 1, 2].map(|k| variable(values[k], first + k))
}

fn constants<T: Real>(one: T, values: impl Into<[f64; 3]>) -> [T; 3] {
    values.into().map(|value| one.constant(value))
}

fn gradient(dual: &Dual) -> SVector<f64, COUNT> {
    dual.eps.unwrap_generic(Const, Const::<1>)
}

/// R a for a platform turned by the variables of its pose.
fn turned(pose: &Pose, a: [Dual; 3]) -> [Dual; 3] {
    let a = rotate(&pose.rotation_rows().map(|row| row.map(Dual::from)), a);
    add(a, cross(vector([0.0; 3], POSE + 3), a))
}

/// Rᵀ a.
fn turned_back(pose: &Pose, a: [Dual; 3]) -> [Dual; 3] {
    let a = sub(a, cross(vector([0.0; 3], POSE + 3), a));
    rotate_back(&pose.rotation_rows().map(|row| row.map(Dual::from)), a)
}

fn times(matrix: &Matrix3<f64>, a: [Dual; 3]) -> [Dual; 3] {
    [0, 1, 2].map(|row| a[0] * matrix[(row, 0)] + a[1] * matrix[(row, 1)] + a[2] * matrix[(row, 2)])
}

/// Motion of a machine in dual numbers: accelerations \[v̇; ω̇\] and those of the drums.
struct Twin<'a> {
    plant: &'a Plant,
    state: &'a PlantState,
}

impl Twin<'_> {
    /// Velocity and angular velocity.
    fn twist(&self) -> ([Dual; 3], [Dual; 3]) {
        let twist = self.state.twist();
        (vector([twist[0], twist[1], twist[2]], TWIST), vector([twist[3], twist[4], twist[5]], TWIST + 3))
    }

    /// Controlled length of a winch, its rate and the radius of its drum.
    fn winch(&self, cable: usize) -> (Dual, Dual, Dual) {
        let motion = &self.state.cables[cable];
        if self.plant.drums.is_empty() {
            let (length, rate) = (motion.controlled_length, motion.controlled_length_rate);
            return (variable(length, INPUT + cable), variable(rate, RATE + cable), Dual::from(0.0));
        }
        // the length that one radian pays out, r − Q φ/2 of a spool
        let winch = &self.plant.model().robot().cables[cable].winch;
        let (angle, speed) = (variable(motion.drum_angle, ANGLE + cable), variable(motion.drum_speed, SPEED + cable));
        let radius =
            -(angle - winch.start_angle.unwrap_or(0.0)) * (0.5 * winch.build_up.unwrap_or(0.0)) + winch.radius.unwrap();
        (radius * (angle - angle.re) + motion.controlled_length, radius * speed, radius)
    }

    /// Pull of a cable on the platform, its moment arm, its tension at the drum and the drum's radius.
    fn pull(&self, cable: usize) -> ([Dual; 3], [Dual; 3], Dual, Dual) {
        let (model, motion) = (self.plant.model(), &self.state.cables[cable]);
        let (length, rate, radius) = self.winch(cable);
        let arm = turned(&self.state.pose, constants(rate, model.robot().cables[cable].platform_anchor));
        let (velocity, omega) = self.twist();
        let anchor = add(vector(self.state.pose.position.into(), POSE), arm);
        let (law, direction, weight) = law_of(model, cable, motion, anchor, length + motion.slip);
        let grows = -dot(direction, add(velocity, cross(omega, arm))) - rate;
        let sum = law + grows * self.damping(cable);
        let pulls = !motion.is_broken && sum.re > 0.0;
        let zero = Dual::from(0.0);
        let (tension, at_drum) = if pulls { (sum, sum + weight) } else { (zero, zero) };
        (scale(tension, direction), arm, at_drum, radius)
    }

    /// Damping coefficient d at the state, which needs no derivative since the elongation rate is zero. For ropes the
    /// plant's own value: their stiffness jumps where the motion reverses.
    fn damping(&self, cable: usize) -> f64 {
        let (motion, law) = (&self.state.cables[cable], self.plant.model().law(cable));
        match law.continued_tension(motion.length, motion.unstrained_length(), None) {
            Some(tension) if motion.memory.is_none() => self.plant.damping[cable].coefficient(tension.by_length),
            _ => self.state.pulls.laws[cable].damping,
        }
    }

    fn accelerations(&self) -> ([Dual; 3], [Dual; 3], Vec<Dual>) {
        let (pose, inertia) = (&self.state.pose, &self.state.inertia);
        let one = Dual::from(1.0);
        let (mut force, mut moment) = (vector([0.0; 3], WRENCH), vector([0.0; 3], WRENCH + 3));
        let mut drums = Vec::new();
        for cable in 0..self.plant.model().cable_count() {
            let (pull, arm, tension, radius) = self.pull(cable);
            (force, moment) = (add(force, pull), add(moment, cross(arm, pull)));
            if let Some(Drum { inertia, friction, gear }) = self.plant.drums.get(cable) {
                let speed = variable(self.state.cables[cable].drum_speed, SPEED + cable);
                let torques = self.plant.holding_torques(self.state).unwrap();
                let motor = variable(torques[cable], INPUT + cable) * *gear;
                drums.push((radius * tension - motor - speed * friction.viscous) / *inertia);
            }
        }
        let constant = self.plant.load().constant_part() + self.state.external;
        force = add(force, constants(one, [constant[0], constant[1], constant[2]]));
        moment = add(moment, constants(one, [constant[3], constant[4], constant[5]]));
        let body = inertia.body;
        let center = turned(pose, constants(one, body.center_of_mass));
        // weight acts at the centre of mass, about which the moment is taken
        let (weight, _) = self.plant.load().weight();
        let weight = weight + self.plant.gravity * self.state.added.mass;
        let about_center = sub(moment, cross(center, force));
        force = add(force, constants(one, weight));
        let (velocity, omega) = self.twist();
        let platform = &self.plant.model().robot().platform;
        let drag = scale(one * platform.damping.unwrap_or(0.0), velocity);
        let about_center = add(about_center, cross(center, drag));
        let about_center = sub(about_center, scale(one * platform.rotational_damping.unwrap_or(0.0), omega));
        force = sub(force, drag);
        let spin = turned(pose, times(&body.inertia, turned_back(pose, omega)));
        let model = self.plant.model();
        let (mut inverse, mut along) = (Matrix3::zeros(), Matrix3::identity());
        if model.robot().motion_pattern.is_planar() {
            let normal = model.robot().plane.normal();
            along -= normal * normal.transpose();
            inverse += normal * normal.transpose() / normal.dot(&(body.inertia * normal));
        } else {
            inverse = body.inertia.try_inverse().unwrap();
        }
        let turning = turned(pose, times(&inverse, turned_back(pose, sub(about_center, cross(omega, spin)))));
        let of_center = scale(one / body.mass, times(&along, force));
        let moving = sub(sub(of_center, cross(turning, center)), cross(omega, cross(omega, center)));
        (moving, turning, drums)
    }
}

/// The lower rows of A and B by dual numbers, in the degrees of freedom.
fn expected(plant: &Plant, state: &PlantState) -> (DMatrix<f64>, DMatrix<f64>) {
    let (v, omega, drums) = Twin { plant, state }.accelerations();
    let (basis, m) = (plant.model().twist_basis(), plant.model().cable_count());
    let (n, size) = (basis.len(), basis.len() + drums.len());
    let entry = |row: usize| match row < n {
        true => (0..3).fold(Dual::from(0.0), |sum, k| sum + v[k] * basis[row][k] + omega[k] * basis[row][3 + k]),
        false => drums[row - n],
    };
    let rows: Vec<_> = (0..size).map(|row| gradient(&entry(row))).collect();
    let along =
        |row: usize, dof: usize, first: usize| (0..6).map(|k| rows[row][first + k] * basis[dof][k]).sum::<f64>();
    let a = DMatrix::from_fn(size, 2 * size, |row, column| match (column / size, column % size) {
        (0, dof) if dof < n => along(row, dof, POSE),
        (0, dof) => rows[row][ANGLE + dof - n],
        (_, dof) if dof < n => along(row, dof, TWIST),
        (_, dof) => rows[row][SPEED + dof - n],
    });
    let inputs = n + if drums.is_empty() { 2 * m } else { m };
    let b = DMatrix::from_fn(size, inputs, |row, column| match column {
        dof if dof < n => along(row, dof, WRENCH),
        input if input < n + m => rows[row][INPUT + input - n],
        input => rows[row][RATE + input - n - m],
    });
    (a, b)
}

/// Largest difference of two matrices relative to the largest entry of each kind of columns.
fn difference(found: &DMatrix<f64>, expected: &DMatrix<f64>) -> f64 {
    assert_eq!(found.shape(), expected.shape());
    let gap = |(a, b): (nalgebra::DVectorView<'_, f64>, nalgebra::DVectorView<'_, f64>)| {
        (a - b).amax() / b.amax().max(1e-300)
    };
    found
        .column_iter()
        .zip(expected.column_iter())
        .filter(|(a, b)| a.amax() + b.amax() > 0.0)
        .map(gap)
        .fold(0.0, f64::max)
}

/// The simulator with every key that its compositions need.
fn complete() -> Robot {
    let mut robot = simulator();
    (robot.platform.damping, robot.platform.rotational_damping) = (Some(70.0), Some(30.0));
    for (index, cable) in robot.cables.iter_mut().enumerate() {
        cable.hidden_length = Some(9.0);
        cable.series_compliance = Some(2e-7);
        cable.tension_of_strain = Some(vec![1.5e6, 6e7]);
        cable.tension_max = Some(20_000.0);
        cable.linear_density = Some(0.7);
        cable.hysteresis = Some(super::compositions::rope());
        cable.winch.radius = Some(0.1525);
        cable.winch.drum_inertia = Some(0.6);
        cable.winch.viscous_friction = Some(3.0);
        cable.winch.gear_ratio = Some(7.0);
        cable.winch.build_up = Some(1e-4 * index as f64);
    }
    place_pulleys(&robot, &[(0.161, Vector3::z()); 8], &robot.home_or_middle()).unwrap()
}

/// Rounding of lengths of 12 m against elongations of 0.1 m and less, through the mass matrix.
const ROUNDING: f64 = 1e-10;

/// Points and pulleys, laws by actual and unstrained length and by a polynomial, ideal winches and spools, dampers of
/// both kinds, a load taken up off the centre; all cables taut, some slack, one broken.
#[test]
fn the_linearisation_agrees_with_dual_numbers() {
    let mut worst: f64 = 0.0;
    for composition in ["elastic", "pulley+elastic", "polynomial", "pulley+polynomial"] {
        for (winches, basis) in [
            (Winches::Ideal, StiffnessBasis::Unstrained),
            (Winches::Ideal, StiffnessBasis::Actual),
            (Winches::Drums, StiffnessBasis::Unstrained),
        ] {
            let mut robot = complete();
            robot.cables.iter_mut().for_each(|cable| cable.stiffness_by = Some(basis));
            let model = Model::new(robot, composition.parse().unwrap()).unwrap();
            let damping = (0..8).map(|k| Damping { constant: 100.0 * f64::from(k), time: 1e-3 }).collect();
            let plant = Plant::with_damping(model, winches, damping).unwrap();
            for slack in [&[][..], &[1, 6][..]] {
                let mut state = at_home(&plant, 4000.0);
                // paid out by more than the elongation of some centimetres
                slack.iter().for_each(|&cable| plant.apply(&mut state, &Slip { cable, length: 0.3 }));
                if !slack.is_empty() {
                    plant.apply(&mut state, &CableBreak { cable: 3 });
                    plant.apply(&mut state, &LoadChange { mass: 50.0, place: Vector3::new(0.5, -0.2, 0.3) });
                }
                plant.observe(&mut state).unwrap();
                worst = worst.max(check(&plant, &mut state, slack));
            }
        }
    }
    println!("simulator: A and B agree to {worst:.1e}");
}

/// Ropes with hysteresis, on a branch that their memory reaches smoothly, and cables with weight: by catenaries and
/// finite elements, over pulleys, with every law of stretch, held by drums.
#[test]
fn the_linearisation_of_ropes_and_of_cables_with_weight_agrees_with_dual_numbers() {
    let mut worst: f64 = 0.0;
    for (composition, winches, rounding) in [
        ("hysteresis", Winches::Ideal, ROUNDING),
        ("pulley+hysteresis", Winches::Drums, ROUNDING),
        ("elastic+catenary", Winches::Ideal, ROUNDING),
        ("pulley+elastic+catenary", Winches::Drums, ROUNDING),
        ("pulley+elastic+finite-element", Winches::Ideal, ROUNDING),
        ("polynomial+catenary", Winches::Drums, ROUNDING),
        ("pulley+hysteresis+catenary", Winches::Ideal, ROUNDING),
    ] {
        let mut robot = complete();
        robot.cables.iter_mut().for_each(|cable| cable.stiffness_by = Some(StiffnessBasis::Unstrained));
        let model = Model::new(robot, composition.parse().unwrap()).unwrap();
        let damping = (0..8).map(|k| Damping { constant: 100.0 * f64::from(k), time: 1e-3 }).collect();
        let plant = Plant::with_damping(model, winches, damping).unwrap();
        let mut state = at_home(&plant, 4000.0);
        plant.apply(&mut state, &LoadChange { mass: 50.0, place: Vector3::new(0.5, -0.2, 0.3) });
        plant.observe(&mut state).unwrap();
        for memory in state.cables.iter_mut().filter_map(|cable| cable.memory.as_mut()) {
            // stretched from below, less than the transition before
            *memory = Memory { strain: memory.strain - 1e-4, stops: [0.1; TRANSITION_LIMIT] };
        }
        state.pulls.is_current = false;
        state.pulls.find(&plant, &state.pose, &mut state.cables).unwrap();
        for (cable, law) in state.cables.iter_mut().zip(&state.pulls.laws) {
            cable.tension = law.tension + law.weight;
        }
        worst = worst.max(check_within(&plant, &mut state, &[], rounding));
    }
    println!("hysteresis and weight: A and B agree to {worst:.1e}");
}

/// Three degrees of freedom in a plane.
#[test]
fn the_linearisation_of_a_planar_machine_agrees_with_dual_numbers() {
    let mut robot = plate();
    robot.platform.center_of_mass = Some(Vector3::new(0.02, -0.03, 0.01));
    let plant = plant(robot, Composition::ELASTIC, 20.0);
    let mut state = at_home(&plant, 60.0);
    let worst = check(&plant, &mut state, &[]);
    println!("plate: A and B agree to {worst:.1e}");
}

/// Compares A and B of a state; a wrench makes its equilibrium exact, as the linearisation assumes.
fn check(plant: &Plant, state: &mut PlantState, slack: &[usize]) -> f64 {
    check_within(plant, state, slack, ROUNDING)
}

fn check_within(plant: &Plant, state: &mut PlantState, slack: &[usize], rounding: f64) -> f64 {
    let taut = state.cables.iter().enumerate().filter(|(_, cable)| cable.tension > 0.0);
    let count = if slack.is_empty() { state.cables.len() } else { state.cables.len() - slack.len() - 1 };
    assert_eq!(taut.count(), count, "tensions are as the case says");
    let acceleration = plant.acceleration(state, &Twist::zeros());
    let pose = state.pose;
    state.external -= state.inertia.wrench_of_acceleration(&pose, &Twist::zeros(), &acceleration);
    let linear = plant.linearize(state).unwrap();
    let (a, b) = (linear.system_matrix().unwrap(), linear.input_matrix().unwrap());
    let (size, (by_state, by_input)) = (linear.size(), expected(plant, state));
    let off = [
        difference(&a.rows(size, size).into_owned(), &by_state),
        difference(&b.rows(size, size).into_owned(), &by_input),
    ];
    let composition = plant.model().composition();
    assert!(off.iter().all(|off| *off < rounding), "{composition}, slack {slack:?}: {off:?}");
    off[0].max(off[1])
}

/// For a moving machine, the acceleration in every degree of freedom agrees with the equations about the centre of
/// mass.
#[test]
fn forward_dynamics_agree_with_equations_about_the_centre_of_mass() {
    for composition in ["pulley+polynomial", "pulley+hysteresis", "elastic+catenary", "pulley+polynomial+catenary"] {
        let model = Model::new(complete(), composition.parse().unwrap()).unwrap();
        let damping = vec![Damping { constant: 300.0, time: 1e-3 }; 8];
        let plant = Plant::with_damping(model, Winches::Ideal, damping).unwrap();
        let mut state = displaced(&plant, &at_home(&plant, 4000.0), &[0.03, -0.02, 0.01, 0.05, -0.1, 0.04]);
        state.set_twist(&Twist::new(0.5, -0.4, 0.3, 0.8, -0.7, 0.6));
        plant.observe(&mut state).unwrap();
        let found = plant.acceleration(&state, &Twist::zeros());
        let (v, omega, _) = Twin { plant: &plant, state: &state }.accelerations();
        let expected = Twist::new(v[0].re, v[1].re, v[2].re, omega[0].re, omega[1].re, omega[2].re);
        let gap = (found - expected).amax() / expected.amax();
        assert!(gap < 1e-9, "{composition}: {gap:e}");
    }
}

/// The wrench of an acceleration is the rate of the momentum by a dual number of time, and the mass matrix is the
/// momentum's derivative by the twist.
#[test]
fn inverse_dynamics_are_the_derivative_of_the_momentum_by_dual_numbers() {
    type Time = num_dual::DualVec<f64, Const<7>>;
    let plant = plant(simulator(), Composition::ELASTIC, 0.0);
    let state = displaced(&plant, &at_home(&plant, 3000.0), &[0.01, 0.02, -0.03, 0.1, -0.2, 0.3]);
    let twist = Twist::new(0.5, -0.4, 0.3, 0.8, -0.7, 0.6);
    let acceleration = Twist::new(2.0, -1.0, 3.0, 4.0, -2.0, 1.0);
    // the first derivative by time, the others by the twist
    let number = |value: f64, rate: f64, component: usize| {
        let mut slope = SVector::<f64, 7>::zeros();
        (slope[0], slope[1 + component]) = (rate, 1.0);
        Time::new(value, num_dual::Derivative::some(slope))
    };
    let now: [Time; 6] = std::array::from_fn(|k| number(twist[k], acceleration[k], k));
    let (v, omega) = ([now[0], now[1], now[2]], [now[3], now[4], now[5]]);
    let time = Time::new(0.0, num_dual::Derivative::some(SVector::<f64, 7>::ith(0, 1.0)));
    let turn = [twist[3], twist[4], twist[5]].map(|rate| time * rate);
    let rows = state.pose.rotation_rows().map(|row| row.map(Time::from));
    let ahead = |a: [Time; 3]| {
        let a = rotate(&rows, a);
        add(a, cross(turn, a))
    };
    let body = state.inertia.body;
    let center = ahead(body.center_of_mass.map(Time::from).into());
    let linear = scale(Time::from(body.mass), add(v, cross(omega, center)));
    let inside = rotate_back(&rows, sub(omega, cross(turn, omega)));
    let spin = [0, 1, 2].map(|row| (0..3).fold(Time::from(0.0), |sum, k| sum + inside[k] * body.inertia[(row, k)]));
    let spin = ahead(spin);
    let slope = |dual: &Time, index: usize| dual.eps.unwrap_generic(Const, Const::<1>)[index];
    let place: [f64; 3] = center.map(|x| x.re);
    // about the platform origin: L_c + s × p, where s does not move in the derivative
    let about_origin = |index: usize| {
        let (force, turning) = (linear.map(|x| slope(&x, index)), spin.map(|x| slope(&x, index)));
        let moment = add(turning, cross(place, force));
        Twist::new(force[0], force[1], force[2], moment[0], moment[1], moment[2])
    };
    let found = state.inertia.wrench_of_acceleration(&state.pose, &twist, &acceleration);
    assert!((found - about_origin(0)).amax() < 1e-13 * found.amax(), "{found} {}", about_origin(0));
    let mass = state.inertia.mass_matrix(&state.pose);
    for column in 0..6 {
        let gap = (mass.column(column) - about_origin(1 + column)).amax();
        assert!(gap < 1e-13 * mass.amax(), "column {column}: {gap:e}");
    }
}

//! Another integrator with error control, on equations about the platform origin that are written independently: with
//! velocities and a quaternion instead of momenta and turns.

use differential_equations::prelude::{ExplicitRungeKutta, IVP, ODE};

use super::*;
use cdpr_model::statics::Load;

type Numbers = [f64; 13];

/// The simulator's equations of motion.
struct Equations<'a> {
    plant: &'a Plant,
    load: Load,
    lengths: Vec<f64>,
    damping: f64,
}

impl Equations<'_> {
    fn pose(numbers: &Numbers) -> Pose {
        let pose = Pose::from_numbers(std::array::from_fn(|k| numbers[k]));
        // the integrator keeps the quaternion's norm only within its errors
        Pose { rotation: nalgebra::UnitQuaternion::new_normalize(*pose.rotation.quaternion()), ..pose }
    }
}

impl ODE<f64, Numbers> for Equations<'_> {
    fn diff(&self, _time: f64, numbers: &Numbers, rates: &mut Numbers) {
        let (model, pose) = (self.plant.model(), Self::pose(numbers));
        let twist = Twist::from_fn(|row, _| numbers[7 + row]);
        let mut wrench = self.load.wrench(&pose);
        for cable in 0..model.cable_count() {
            let (path, arm) = model.path(cable, &pose).unwrap();
            let u = Vector3::from(path.direction);
            let moment = arm.cross(&u);
            let column = Twist::new(u.x, u.y, u.z, moment.x, moment.y, moment.z);
            let law = model.elasticity(cable).tension(path.length, self.lengths[cable]).value;
            wrench += column * (law - self.damping * column.dot(&twist)).max(0.0);
        }
        let acceleration = self.plant.inertia.acceleration(model, &pose, &twist, &wrench);
        let (omega, [x, y, z, w]) = ([twist[3], twist[4], twist[5]], [numbers[3], numbers[4], numbers[5], numbers[6]]);
        // q' = ½ (0, ω) q
        let turn = [
            omega[0] * w + omega[1] * z - omega[2] * y,
            omega[1] * w + omega[2] * x - omega[0] * z,
            omega[2] * w + omega[0] * y - omega[1] * x,
            -(omega[0] * x + omega[1] * y + omega[2] * z),
        ];
        for row in 0..3 {
            rates[row] = twist[row];
        }
        for (row, rate) in turn.iter().enumerate() {
            rates[3 + row] = 0.5 * rate;
        }
        for row in 0..6 {
            rates[7 + row] = acceleration[row];
        }
    }
}

/// Pose of a machine after a time (s) at its present lengths, from the library's integrator; linear laws, dampers of
/// one constant.
pub(super) fn reference(plant: &Plant, state: &PlantState, damping: f64, seconds: f64) -> Pose {
    let lengths = state.cables.iter().map(|cable| cable.controlled_length).collect();
    let (pose, twist) = (state.pose.numbers(), state.twist());
    let start: Numbers = std::array::from_fn(|row| if row < 7 { pose[row] } else { twist[row - 7] });
    let equations = Equations { plant, load: *plant.load(), lengths, damping };
    let method = ExplicitRungeKutta::dop853().rtol(1e-12).atol(1e-12).max_steps(1_000_000);
    let solved = IVP::ode(&equations, 0.0, seconds, start).method(method).solve().unwrap();
    Equations::pose(solved.y.last().unwrap())
}

/// A second of motion, with every cable taut and with some that go slack, with and without dampers.
#[test]
fn a_step_agrees_with_an_integrator_that_controls_its_error() {
    let mut worst: f64 = 0.0;
    for (damping, size, step, tolerance) in [
        (0.0, 1.0, 1e-3, 1e-9),
        (2000.0, 1.0, 1e-3, 1e-9),
        (0.0, 12.0, 1e-4, 1e-9),
        (0.0, 12.0, 1e-3, 2e-8),
        (300.0, 12.0, 1e-3, 5e-8),
    ] {
        let plant = plant(simulator(), Composition::ELASTIC, damping);
        let rest = at_home(&plant, 6000.0);
        let shift = [0.004, -0.003, 0.003, 0.002, -0.002, 0.003].map(|part| size * part);
        let mut state = displaced(&plant, &rest, &shift);
        state.set_twist(&Twist::new(0.05, -0.03, 0.02, 0.1, 0.15, -0.1));
        let lengths: Vec<f64> = rest.cables.iter().map(|cable| cable.controlled_length).collect();
        let expected = reference(&plant, &state, damping, 1.0);
        let mut slack = false;
        for _ in 0..(1.0_f64 / step).round() as usize {
            hold(&plant, &mut state, step, 1);
            slack |= state.cables.iter().any(|cable| cable.tension == 0.0);
        }
        assert_eq!(slack, size > 1.0, "cables go slack in the large motion only");
        let gap = apart(&expected, &state.pose);
        // the same steps over kinks
        let mut uncut = displaced(&plant, &rest, &shift);
        uncut.set_twist(&Twist::new(0.05, -0.03, 0.02, 0.1, 0.15, -0.1));
        for _ in 0..(1.0_f64 / step).round() as usize {
            let command = Command::lengths(&lengths);
            plant.prepare(&mut uncut, &command, step).unwrap();
            plant.stages(&mut uncut, step).unwrap();
            plant.finish(&mut uncut);
        }
        let over = apart(&expected, &uncut.pose);
        println!("damping {damping}, slack {slack}, step {step} s: {gap:.1e} m, without cuts {over:.1e} m");
        assert!(gap < tolerance, "{damping} {size}: {gap:e}");
        // steps without a kink give the same bits
        assert!(if slack { over > 10.0 * gap } else { uncut.pose == state.pose }, "{damping} {size}: {over:e} {gap:e}");
        worst = worst.max(gap);
    }
    assert!(worst > 0.0, "two programs are never one");
}

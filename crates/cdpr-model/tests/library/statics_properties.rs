//! Stiffness is that of the forward problem, and no numbers make the statics panic.

use super::support::{random_pose, simulator, with_pulleys};
use cdpr_model::equilibrium::elastostatics::{self, Settings, Status};
use cdpr_model::geometry::{Pose, Twist, Wrench};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::{CableStiffness, Robot};
use cdpr_model::statics::{Load, Stability, Stiffness, balanced_wrench, controlled_lengths, section_wrench, split};
use cdpr_testing::property;
use nalgebra::Vector3;
use proptest::prelude::*;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Where the cables and the load bring the platform, started from near there.
fn equilibrium(model: &Model, lengths: &[f64], load: &Load, guess: &Pose) -> Pose {
    let solution =
        elastostatics::solve(model, lengths, load, guess, &Settings::default()).expect("takes these lengths");
    assert_eq!(solution.status, Status::Converged, "{:?}", solution.reason);
    solution.pose
}

/// K_wx⁻¹ and −K_wx⁻¹ K_wq against central differences of the full, independent solve.
#[test]
fn compliance_is_that_of_the_forward_problem() {
    let mut rng = ChaCha8Rng::seed_from_u64(11);
    for composition in [Composition::ELASTIC, Composition::PULLEY_ELASTIC] {
        let robot = with_pulleys(&simulator(), 0.161);
        let model = Model::new(robot, composition).expect("is elastic");
        for _ in 0..5 {
            let pose = random_pose(model.robot(), 0.1, &mut rng);
            let tensions: Vec<f64> = (0..8).map(|_| rng.random_range(2000.0..6000.0)).collect();
            let wrench = balanced_wrench(&model, &pose, &tensions).expect("has courses");
            let stiffness = Stiffness::at(&model, &pose, &tensions, &Load::constant(wrench)).expect("stretches");
            assert_eq!(stiffness.stability(), Stability::Stable);
            let lengths = controlled_lengths(&model, &pose, &tensions).expect("stretches");
            assert_eq!(lengths, stiffness.controlled_lengths);
            let compliance = stiffness.compliance().expect("is stiff");
            for axis in 0..6 {
                let moved = |step: f64| {
                    let load = Load::constant(wrench + Wrench::ith(axis, step));
                    pose.displacement_to(&equilibrium(&model, &lengths, &load, &pose))
                };
                let slope = (moved(10.0) - moved(-10.0)) / 20.0;
                // of 1e-6 m/N: steps of 1e-5 m, squared, and the solver's 1e-12 m over 20 N
                assert!((slope - compliance.column(axis)).amax() < 1e-11, "{composition}, axis {axis}: {slope}");
            }
            let by_length = stiffness.pose_by_controlled_lengths().expect("is stiff");
            for cable in 0..8 {
                let moved = |step: f64| {
                    let mut changed = lengths.clone();
                    changed[cable] += step;
                    pose.displacement_to(&equilibrium(&model, &changed, &Load::constant(wrench), &pose))
                };
                let slope = (moved(1e-5) - moved(-1e-5)) / 2e-5;
                assert!((slope - by_length.column(cable)).amax() < 1e-6, "{composition}, cable {}", cable + 1);
            }
        }
    }
}

/// Numbers that are usual, extreme or none.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![4 => -10.0..10.0, 2 => 0.0..1e4, 1 => any::<f64>(), 1 => Just(0.0), 1 => Just(f64::NAN)]
}

fn robots() -> [Robot; 3] {
    let planar = Robot::builtin("planar-example").expect("is built in");
    let mut turning = Robot::builtin("kntu-planar").expect("is built in");
    turning.cables.iter_mut().for_each(|cable| cable.stiffness = Some(CableStiffness::Spring(1e4)));
    [planar, turning, with_pulleys(&simulator(), 0.161)]
}

proptest! {
    #![proptest_config(property::cases(300))]

    #[test]
    fn no_numbers_make_the_statics_panic(
        position in [number(), number(), number()],
        turn in [number(), number(), number()],
        tensions in prop::collection::vec(number(), 0..10),
        wrench in [number(), number(), number(), number(), number(), number()],
        cables in prop::collection::vec(0_usize..10, 0..5),
    ) {
        for robot in robots() {
            let composition = if robot.cables[0].pulley_swivel_axis().is_some() {
                Composition::PULLEY_ELASTIC
            } else {
                Composition::ELASTIC
            };
            let model = Model::new(robot, composition).expect("is elastic");
            let mut tensions = tensions.clone();
            if tensions.len() > 4 {
                tensions.resize(model.cable_count(), 1000.0);
            }
            let turn = Twist::new(0.0, 0.0, 0.0, turn[0], turn[1], turn[2]);
            let pose = Pose { position: Vector3::from(position), ..Pose::identity() }.displaced(&turn);
            let load = Load::constant(Wrench::from(wrench));
            if let Ok(parts) = split(&model, &pose, &tensions) {
                prop_assert!(parts.rank <= model.dof() && parts.internal.len() == tensions.len());
            }
            let _ = section_wrench(&model, &pose, &tensions, &cables);
            if let Ok(lengths) = controlled_lengths(&model, &pose, &tensions) {
                prop_assert!(lengths.iter().all(|&length| length > 0.0));
            }
            if let Ok(stiffness) = Stiffness::at(&model, &pose, &tensions, &load) {
                let (values, stability) = (stiffness.eigenvalues(), stiffness.stability());
                prop_assert!(values.iter().all(|value| value.is_finite()));
                prop_assert!(stability != Stability::Stable || values[0] > 0.0);
                let _ = (stiffness.compliance(), stiffness.pose_by_controlled_lengths());
            }
        }
    }
}

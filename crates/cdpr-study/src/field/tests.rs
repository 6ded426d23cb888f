use super::*;
use cdpr_model::control::Initial;
use cdpr_model::control::winch_offsets;
use cdpr_model::geometry::Pose;
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::Robot;

fn planar(control: Composition, machine: Composition) -> (Model, Model, Vec<f64>) {
    let robot = Robot::builtin("planar-example").unwrap();
    let control = Model::new(robot.clone(), control).unwrap();
    let machine = Model::new(robot.clone(), machine).unwrap();
    let initial: Initial = toml::from_str("pose = [0, 5.2]\ntension_method = \"closed-form\"").unwrap();
    let pose = robot.motion_pattern.pose(robot.plane, &initial.pose).unwrap();
    let offsets = winch_offsets(&initial, &control, &machine, &pose).unwrap();
    (control, machine, offsets)
}

fn at(x: f64, y: f64) -> Pose {
    Pose { position: nalgebra::Vector3::new(x, y, 0.0), ..Pose::identity() }
}

fn grid(min: [f64; 2], max: [f64; 2], count: usize) -> Vec<Pose> {
    let along = |axis: usize, index: usize| min[axis] + (max[axis] - min[axis]) * index as f64 / (count - 1) as f64;
    (0..count * count).map(|cell| at(along(0, cell / count), along(1, cell % count))).collect()
}

/// maths.md, sec. 4: 57.14 and 117.83 mm, and 0.589 % of 9.71 m, to all digits given there.
#[test]
fn the_planar_example_has_the_errors_of_the_dissertation() {
    let (control, machine, offsets) = planar(Composition::STANDARD, Composition::ELASTIC);
    let driving = Driving::new(&control, &machine, &offsets).unwrap();
    let wide = field(&driving, &grid([-4.0, 0.5], [4.0, 6.0], 5)).summary;
    assert!((wide.position_error_m.mean - 0.05714).abs() < 5e-6, "{wide:?}");
    assert!((wide.diameter_m - 9.708).abs() < 1e-3);
    assert!((wide.relative_position_error.unwrap() - 0.00589).abs() < 5e-6);
    let low = field(&driving, &grid([-3.0, 0.4], [2.0, 1.0], 4)).summary;
    assert!((low.position_error_m.mean - 0.11783).abs() < 5e-6, "{low:?}");
}

/// The error at the three positions of maths.md, given to a millimetre: the field changes by about a hundredth of the
/// distance.
#[test]
fn the_error_of_the_planar_example_vanishes_at_three_places() {
    let (control, machine, offsets) = planar(Composition::STANDARD, Composition::ELASTIC);
    let driving = Driving::new(&control, &machine, &offsets).unwrap();
    for (x, y) in [(0.0, 5.2), (-3.974, 2.694), (3.557, 2.803)] {
        let error = driving.outcome(&at(x, y)).pose.position - at(x, y).position;
        assert!(error.norm() < 5e-5, "({x}, {y}): {error}");
    }
}

/// Towards a zero of the error, the error falls in proportion to the distance, and that of the linear step with its
/// square.
#[test]
fn half_the_error_leaves_a_quarter_of_what_the_linear_step_misses() {
    let (control, machine, offsets) = planar(Composition::STANDARD, Composition::ELASTIC);
    let driving = Driving::new(&control, &machine, &offsets).unwrap();
    let missed = |distance: f64| {
        let sample = sample(&mut driving.operation(), &at(distance, 5.2 - 0.5 * distance));
        let (exact, linear) = (sample.exact.unwrap(), sample.linear.unwrap());
        (exact.norm(), (linear - exact).norm())
    };
    for distance in [0.4, 0.2] {
        let ((whole, misses), (half, half_misses)) = (missed(distance), missed(0.5 * distance));
        // the next order of both is the distance divided by the size of the robot
        assert!((whole / half - 2.0).abs() < 0.5 * distance, "{whole} {half}");
        assert!((misses / half_misses - 4.0).abs() < 3.0 * distance, "{misses} {half_misses}");
    }
}

/// Under force control a control model like the machine makes no error at all (eq. 3.25, 3.26), to 1e-9 m.
#[test]
fn a_control_model_like_its_machine_makes_no_error() {
    let (control, machine, offsets) = planar(Composition::ELASTIC, Composition::ELASTIC);
    let driving = Driving::new(&control, &machine, &offsets).unwrap();
    let found = field(&driving, &grid([-2.0, 2.0], [2.0, 6.0], 7));
    assert_eq!(found.summary.converged, 49);
    assert!(found.summary.position_error_m.max < 1e-9, "{:?}", found.summary);
    assert!(found.summary.linear_position_error_m.max < 1e-9, "{:?}", found.summary);
}

/// For a rigid machine with other anchors the least-squares step is exact to first order too.
#[test]
fn the_linear_step_of_a_rigid_machine_is_that_of_least_squares() {
    let robot = Robot::builtin("planar-example").unwrap();
    let missed = |shift: f64| {
        let mut moved = robot.clone();
        moved.cables[1].frame_anchor.x += shift;
        let control = Model::new(robot.clone(), Composition::STANDARD).unwrap();
        let machine = Model::new(moved, Composition::STANDARD).unwrap();
        let driving = Driving::new(&control, &machine, &[0.0; 4]).unwrap();
        let sample = sample(&mut driving.operation(), &at(1.0, 3.0));
        let (exact, linear) = (sample.exact.unwrap(), sample.linear.unwrap());
        (exact.norm(), (linear - exact).norm())
    };
    let ((whole, misses), (_, half_misses)) = (missed(0.02), missed(0.01));
    assert!(whole > 1e-3);
    assert!((misses / half_misses - 4.0).abs() < 0.1, "{misses} {half_misses}");
}

/// Towards a zero of the error, the tension error of the step falls with the square of the distance.
#[test]
fn a_third_of_the_distance_leaves_a_ninth_of_what_the_step_misses_of_the_tensions() {
    let (control, machine, offsets) = planar(Composition::STANDARD, Composition::ELASTIC);
    let driving = Driving::new(&control, &machine, &offsets).unwrap();
    let missed = |distance: f64| {
        let pose = at(distance, 5.2 - 0.5 * distance);
        let exact = driving.outcome(&pose).tensions.unwrap();
        let step = linear::held(&mut driving.operation(), &pose).unwrap().tensions(&machine);
        step.iter().zip(&exact).map(|(step, exact)| (step - exact).powi(2)).sum::<f64>().sqrt()
    };
    let [far, near] = [missed(0.3), missed(0.1)];
    // a ninth, with some margin for the third order
    assert!(near > 1e-3 && near < far / 8.0 && near > far / 10.0, "{far} {near}");
}

/// −(∂q_θ/∂x)/(∂q_θ/∂T) is the change of a tension at fixed length: central differences over poses at which the cables
/// are held.
#[test]
fn tensions_follow_the_platform_at_fixed_lengths_as_differences_say() {
    let mut robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    for cable in &mut robot.cables {
        cable.linear_density = Some(0.3);
    }
    robot.gravity = Some(nalgebra::Vector3::new(0.0, 0.0, -9.81));
    for composition in ["elastic", "elastic+catenary"] {
        let machine = Model::new(robot.clone(), composition.parse().unwrap()).unwrap();
        let pose = Pose::from_xyz_angles(nalgebra::Vector3::new(0.4, -0.7, 1.6), [0.05, -0.03, 0.1]);
        let tensions = [3678.0, 2169.0, 4250.0, 1708.0, 3985.0, 2394.0, 4715.0, 1684.0];
        let lengths = cdpr_model::statics::controlled_lengths(&machine, &pose, &tensions).unwrap();
        let tension = |pose: &Pose, cable: usize| {
            let input = cdpr_model::cable::CableInput::ControlledLength(lengths[cable]);
            machine.cable_state(cable, pose, input).unwrap().outlet_tension
        };
        // large enough for lengths accurate to 1e-12 m in cables of 1e6 N/m
        let h = 1e-5;
        let held = linear::Held::at(&machine, &pose, &lengths).unwrap();
        for twist in machine.twist_basis() {
            let changes = held.changes_along(twist);
            for (cable, change) in changes.iter().enumerate() {
                let ends = [h, -h].map(|step| tension(&pose.displaced(&(*twist * step)), cable));
                let slope = (ends[0] - ends[1]) / (2.0 * h);
                assert!((slope - change).abs() < 1e-4 * slope.abs() + 1.0, "{composition} {cable}: {slope} {change}");
            }
        }
    }
}

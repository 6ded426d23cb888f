//! Costs of accuracy on the twin.

use crate::sweep::{PreparedSweep, Row, Subjects, Sweep};
use cdpr_model::geometry::Pose;
use cdpr_model::robot::Robot;
use nalgebra::Vector3;

const SWEEP: &str = "study = 's.toml'
[calibration]
poses = [20, 60]
records = 2
accuracy_m = [0.005]
[[calibration.sensor]]
name = 'tracker'
position_m = 0.0001
price = 100
[[calibration.sensor]]
name = 'cameras'
position_m = 0.002
[[calibration.sensor]]
name = 'none'
[[calibration.model]]
model = 'standard'
free = 'frame-anchor'
[[calibration.model]]
model = 'elastic'
free = 'frame-anchor,platform-anchor,compliance,wrench'
prior = ['platform-anchor=0.02']
price = 50
";

/// Kinematics levels off at the effects it lacks, for any sensor; force control improves further with sensor and poses;
/// without a tracker the elastic model cannot be calibrated, and the reason is given.
#[test]
fn better_sensors_and_more_poses_pay_for_the_model_that_can_use_them() {
    let study = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../studies/twin-measurements.toml"));
    let robot = |name: &str| Robot::builtin(name).unwrap().to_toml();
    let subjects = Subjects {
        study: study.to_owned(),
        control: robot("cablerobot-simulator-helicopter"),
        machine: robot("cablerobot-simulator-helicopter-elastostatic-calibrated"),
        offset_robot: None,
    };
    let sweep = Sweep::from_toml_bytes(SWEEP.as_bytes(), "sweep.toml").unwrap();
    let points = sweep.points();
    assert_eq!((points.len(), &points[0], &points[11]), (12, &vec![1.0, 1.0, 20.0], &vec![3.0, 2.0, 60.0]));
    let table = sweep.calibration.as_ref().unwrap();
    assert_eq!(table.at(&points[3]).unwrap().price, 100.0 + 50.0 + 60.0);
    let prepared = PreparedSweep::new(&sweep, &subjects).unwrap();
    let rows: Vec<Row> = points.iter().enumerate().map(|(k, values)| prepared.calibration_row(k, values)).collect();
    let driven =
        |k: usize| rows[k].calibration.as_ref().unwrap_or_else(|| panic!("{:?}", rows[k].reason)).driven_position_m;
    // 0 to 3 tracker, 4 to 7 cameras, 8 to 11 none; two models of two numbers of poses each
    assert!((0.0025..0.0045).contains(&driven(1)) && driven(5) < 1.3 * driven(1), "{} {}", driven(1), driven(5));
    assert!(
        driven(3) < 0.3 * driven(1) && driven(3) < driven(7) && driven(7) < driven(6),
        "{:?}",
        [2, 3, 6, 7].map(driven)
    );
    let tracked = rows[3].calibration.as_ref().unwrap();
    assert!(
        tracked.validation_position_m.unwrap() < rows[7].calibration.as_ref().unwrap().validation_position_m.unwrap()
    );
    assert!(rows[9].calibration.as_ref().is_none_or(|found| found.validation_position_m.is_none()));
    // tensions in equilibrium with the load calibrate an elastic model without a tracker
    let elastic = rows[11].calibration.as_ref().unwrap_or_else(|| panic!("{:?}", rows[11].reason));
    assert_eq!((elastic.parameter_count, elastic.validation_position_m), (62, None));
    assert_eq!(prepared.calibration_row(3, &points[3]), rows[3], "the same every time");
}

/// A rotated and shifted frame is found, and leaves no error.
#[test]
fn a_frame_of_the_robots_own_is_no_error() {
    let frame = Pose::from_xyz_angles(Vector3::new(0.1, -0.2, 0.05), [0.02, -0.3, 0.1]);
    let commanded = [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 2.0, 1.5], [-1.0, 1.0, 0.5]]
        .map(|position| Pose { position: position.into(), ..Pose::identity() });
    let emerged = commanded.map(|pose| {
        let back = frame.rotation.inverse() * (pose.position - frame.position);
        (pose, Pose { position: back, rotation: frame.rotation.inverse() * pose.rotation })
    });
    let found = super::best_frame(&emerged, None);
    assert!((found.position - frame.position).norm() < 1e-14 && found.angle_to(&frame) < 1e-14, "{found:?}");
    assert!(super::missed(&emerged, &found).iter().all(|missed| *missed < 1e-14));
}

#[test]
fn tables_that_state_no_calibration_are_refused() {
    let of = |text: &str| Sweep::from_toml_bytes(text.as_bytes(), "sweep.toml").unwrap_err().to_string();
    assert!(of(&SWEEP.replace("[20, 60]", "[]")).contains("`poses` is empty"));
    assert!(of(&SWEEP.replace("[20, 60]", "[0]")).contains("0 poses"));
    assert!(of(&SWEEP.replace("price = 50", "price = -1")).contains("`price`"));
    assert!(of(&SWEEP.replace("'elastic'", "'elastik'")).contains("`elastik` is no composition"));
}

//! Readers meet arbitrary bytes: they never panic, and what they accept is finite and comes back unchanged.

use cdpr::measurement::{Reading, Samples, Sidecar, Split};
use cdpr::metamodel::Study;
use cdpr::robot::{Robot, builtin};
use proptest::prelude::*;

/// Every number of a robot.
fn numbers(robot: &Robot) -> Vec<f64> {
    let mut numbers = Vec::new();
    for cable in &robot.cables {
        numbers.extend(cable.frame_anchor.iter().chain(cable.platform_anchor.iter()));
        numbers.extend(cable.pulley_swivel_axis.iter().flat_map(|axis| axis.iter().copied().collect::<Vec<_>>()));
        numbers.extend([cable.pulley_radius, cable.tension_min, cable.tension_max].iter().flatten());
        numbers.extend([cable.axial_stiffness, cable.axial_compliance, cable.spring_constant].iter().flatten());
        numbers.extend([cable.hidden_length, cable.series_compliance].iter().flatten());
        numbers.extend([cable.length_scale, cable.length_offset].iter().flatten());
        numbers.extend([cable.tension_scale, cable.tension_offset].iter().flatten());
    }
    numbers.extend(robot.gravity.iter().flat_map(|gravity| gravity.iter().copied().collect::<Vec<_>>()));
    numbers.extend(robot.home.iter().flat_map(|home| home.position.iter().copied().collect::<Vec<_>>()));
    numbers.extend(robot.home.iter().flat_map(|home| home.rotation.coords.iter().copied().collect::<Vec<_>>()));
    numbers.extend(robot.platform.mass);
    numbers.extend(robot.platform.inertia.iter().flat_map(|inertia| inertia.iter().copied().collect::<Vec<_>>()));
    numbers.extend(robot.external_wrench.iter().flat_map(|it| it.wrench.iter().copied().collect::<Vec<_>>()));
    numbers
}

fn check(bytes: &[u8]) {
    match Robot::from_toml_bytes(bytes, "any.toml") {
        Ok(robot) => {
            assert!(numbers(&robot).iter().all(|number| number.is_finite()));
            let written = robot.to_toml();
            assert_eq!(Robot::from_toml(&written, "written.toml").as_ref(), Ok(&robot), "{written}");
            robot.warnings();
        }
        Err(error) => {
            // the place is shown, whatever it is
            assert!(!error.to_string().is_empty() && error.place.iter().all(|place| place.snippet().contains('^')));
        }
    }
}

const STUDY: &str = include_str!("../../cdpr-cli/src/commands/demo/training.toml");

const SIDECAR: &str = "layout_version = 1\n[sigmas]\nposition_m = 0.001\nlength_m = 0.0002\n[provenance]\nseed = 3\n";

const DATA: &str = "\
x_m,y_m,cable_length_m_1,cable_length_m_2,cable_length_mm_3,cable_length_m_4,tension_N_1,tension_N_2,tension_N_3,tension_N_4,set,t_s
0.5,4.0,7.6,6.0,6800.5,6.0,1000,1001,1002,1003,train,0
1.5,3.0,9.0,6.1,7159,4.3,1100,1101,1102,1103,validation,0.5
";

/// Data of the planar example are refused, or have as many finite numbers as they should; splits of them never panic.
fn check_data(bytes: &[u8]) {
    let robot = Robot::builtin("planar-example").expect("is built in");
    match Samples::from_csv(bytes, "any.csv", &robot) {
        Ok(Reading { samples, .. }) => {
            assert!(!samples.is_empty());
            assert_eq!((samples.cable_count, samples.lengths.len()), (4, 4 * samples.len()));
            assert!(samples.lengths.iter().chain(samples.tensions.iter().flatten()).all(|number| number.is_finite()));
            assert!(samples.poses.iter().all(|pose| pose.is_finite()));
            let again = Samples::from_csv(samples.to_csv(&robot).as_bytes(), "again.csv", &robot);
            // names of sets may need quotes, which only a table program would give them
            if samples.set.is_none() {
                assert_eq!(again.expect("reads its own text").samples.lengths, samples.lengths);
            }
            for split in [Split::Column, Split::Blocks(2), Split::Region(2)] {
                let _ = split.folds(&samples, 1);
            }
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

fn check_study(bytes: &[u8]) {
    if let Ok(study) = Study::from_toml_bytes(bytes, "any.toml") {
        study.remarks();
        let robot = Robot::builtin("cablerobot-simulator-helicopter").expect("is built in");
        let _ = study.initial_pose(&robot);
        let grid = study.poses.as_ref().and_then(|poses| poses.grid.as_ref());
        let points: usize = grid.map_or(1, |grid| grid.count.iter().fold(1, |all, &count| all.saturating_mul(count)));
        if points < 10_000
            && let Ok(poses) = study.commanded_poses(&robot, Vec::new(), 1)
        {
            assert!(poses.iter().all(|commanded| commanded.pose.is_finite()));
        }
    }
}

/// One small damage to a file; positions are shares of its length.
#[derive(Clone, Debug)]
enum Damage {
    Flip(f64, u8),
    Delete(f64, usize),
    SwapLines(f64, f64),
    ReplaceValue(f64, &'static str),
}

const VALUES: [&str; 16] = [
    "nan",
    "inf",
    "-inf",
    "1e308",
    "1e30",
    "-1",
    "0",
    "-0.0",
    "1e-320",
    "0.1",
    "3.0000000000000004",
    "\"2T\"",
    "[]",
    "[0.6, 0.0, 0.8]",
    "[1.0, 2.0]",
    "\"\"",
];

fn damage() -> impl Strategy<Value = Damage> {
    let share = || 0.0..1.0f64;
    prop_oneof![
        (share(), any::<u8>()).prop_map(|(at, byte)| Damage::Flip(at, byte)),
        (share(), 1..200usize).prop_map(|(at, count)| Damage::Delete(at, count)),
        (share(), share()).prop_map(|(one, other)| Damage::SwapLines(one, other)),
        (share(), 0..VALUES.len()).prop_map(|(at, index)| Damage::ReplaceValue(at, VALUES[index])),
    ]
}

fn damaged(mut bytes: Vec<u8>, damage: &Damage) -> Vec<u8> {
    let index = |share: f64, length: usize| ((share * length as f64) as usize).min(length.saturating_sub(1));
    if bytes.is_empty() {
        return bytes;
    }
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    match *damage {
        Damage::Flip(at, byte) => {
            let at = index(at, bytes.len());
            bytes[at] ^= byte;
            bytes
        }
        Damage::Delete(at, count) => {
            let at = index(at, bytes.len());
            bytes.drain(at..(at + count).min(bytes.len()));
            bytes
        }
        Damage::SwapLines(one, other) => {
            let text = text(&bytes);
            let mut lines: Vec<&str> = text.lines().collect();
            let (one, other) = (index(one, lines.len()), index(other, lines.len()));
            lines.swap(one, other);
            lines.join("\n").into_bytes()
        }
        Damage::ReplaceValue(at, value) => {
            let text = text(&bytes);
            let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
            let line = index(at, lines.len());
            if let Some((key, _)) = lines[line].split_once(" = ") {
                lines[line] = format!("{key} = {value}");
            }
            lines.join("\n").into_bytes()
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn arbitrary_bytes_never_panic_a_robot_reader(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        check(&bytes);
    }

    #[test]
    fn a_damaged_robot_file_is_refused_or_comes_back_unchanged(
        robot in 0..23usize,
        damages in proptest::collection::vec(damage(), 0..4),
    ) {
        let text = builtin::names().nth(robot).and_then(builtin::find).expect("23 are built in");
        check(&damages.iter().fold(text.as_bytes().to_vec(), damaged));
    }

    #[test]
    fn arbitrary_bytes_never_panic_a_reader_of_measurements_or_studies(
        bytes in proptest::collection::vec(any::<u8>(), 0..300),
    ) {
        check_data(&bytes);
        check_study(&bytes);
        let _ = Sidecar::from_toml_bytes(&bytes, "any.meta.toml");
    }

    #[test]
    fn damaged_measurements_and_studies_are_refused_or_make_sense(damages in proptest::collection::vec(damage(), 1..4)) {
        let apply = |text: &str| damages.iter().fold(text.as_bytes().to_vec(), damaged);
        check_data(&apply(DATA));
        check_study(&apply(STUDY));
        if let Ok(sidecar) = Sidecar::from_toml_bytes(&apply(SIDECAR), "any.meta.toml") {
            assert!(sidecar.sigmas.position.is_none_or(|sigma| sigma.is_finite() && sigma >= 0.0));
        }
    }

    /// Printed orientations have rounding errors of every size up to the accepted one.
    #[test]
    fn any_orientation_and_direction_comes_back_to_the_bit(
        angles in proptest::array::uniform3(-7.0..7.0f64),
        digits in 6..17usize,
        angle in -1e3..1e3f64,
    ) {
        let pose = cdpr::geometry::Pose::from_xyz_angles(Default::default(), angles);
        let (matrix, print) = (pose.rotation_matrix(), |number: f64| format!("{number:.digits$}"));
        let row = |row: usize| format!("[{}]", [0, 1, 2].map(|column| print(matrix[(row, column)])).join(", "));
        let spatial = builtin::find("caroca-pulleys").expect("it is built in")
            .replace("[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]   #", &format!("[{}, {}, {}] #", row(0), row(1), row(2)))
            .replace("swivel_axis = [0.0, 0.0, 1.0]", &format!("swivel_axis = {}", row(1)));
        check(spatial.as_bytes());
        // six digits may be too few for a rotation matrix to be orthonormal to 1e-6
        prop_assert!(digits == 6 || Robot::from_toml(&spatial, "spatial.toml").is_ok());
        let planar = builtin::find("cucablerobot-planar").expect("it is built in")
            .replace("angle_rad = 0.0", &format!("angle_rad = {}", print(angle)));
        prop_assert!(Robot::from_toml(&planar, "planar.toml").is_ok());
        check(planar.as_bytes());
    }
}

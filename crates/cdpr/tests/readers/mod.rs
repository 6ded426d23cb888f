//! Readers and what must hold of them for any bytes, for property tests and fuzzing alike.
//!
//! Nothing may panic; what is accepted is finite and comes back unchanged.
#![allow(dead_code, reason = "tests, the long run and the fuzz targets use different parts")]

pub(crate) mod caspr;
mod mutation;

use std::sync::LazyLock;

use cdpr::calibration::compensation::compensate;
use cdpr::compensation::Compensation;
use cdpr::measurement::{Reading, Samples, Sidecar, Split};
use cdpr::model::{Composition, Model};
use cdpr::robot::{Robot, builtin};
use cdpr::study::Study;
#[allow(unused_imports, reason = "fuzz targets damage files themselves")]
pub(crate) use mutation::mutated;

/// A reader of files.
pub(crate) struct Reader {
    pub(crate) name: &'static str,
    /// Files that it reads, to be damaged.
    pub(crate) corpus: fn() -> Vec<Vec<u8>>,
    /// Fails when the reader does something wrong.
    pub(crate) check: fn(&[u8]),
}

/// All readers.
pub(crate) const READERS: [Reader; 7] = [
    Reader { name: "robot", corpus: robots, check: check_robot },
    Reader { name: "measurements", corpus: || vec![DATA.into(), WIDE_DATA.into()], check: check_data },
    Reader { name: "study", corpus: studies, check: check_study },
    Reader { name: "sidecar", corpus: || vec![SIDECAR.into()], check: check_sidecar },
    Reader { name: "compensation", corpus: || vec![map().into_bytes()], check: check_map },
    Reader { name: "caspr-bodies", corpus: || vec![caspr::BODIES.into()], check: caspr::check_bodies },
    Reader { name: "caspr-cables", corpus: || vec![caspr::CABLES.into()], check: caspr::check_cables },
];

/// The check of the reader of this name.
pub(crate) fn check(name: &str, bytes: &[u8]) {
    let reader = READERS.iter().find(|reader| reader.name == name);
    (reader.expect("a reader of that name").check)(bytes);
}

fn robots() -> Vec<Vec<u8>> {
    builtin::names().filter_map(builtin::find).map(|text| text.as_bytes().to_vec()).collect()
}

fn studies() -> Vec<Vec<u8>> {
    [
        include_str!("../../../cdpr-cli/src/commands/demo/training.toml"),
        include_str!("../../../../studies/twin-nominal.toml"),
        include_str!("../../../../studies/planar-wide-grid.toml"),
        STUDY,
    ]
    .map(|text| text.as_bytes().to_vec())
    .to_vec()
}

/// Every number of a robot.
fn numbers(robot: &Robot) -> Vec<f64> {
    let mut numbers = Vec::new();
    for cable in &robot.cables {
        numbers.extend(cable.frame_anchor.iter().chain(cable.platform_anchor.iter()));
        numbers.extend(cable.pulley_swivel_axis().iter().flat_map(|axis| axis.iter().copied().collect::<Vec<_>>()));
        numbers.extend([cable.pulley_radius(), cable.tension_min, cable.tension_max].iter().flatten());
        numbers.extend([cable.axial_stiffness(), cable.axial_compliance(), cable.spring_constant()].iter().flatten());
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

/// A robot is refused with the place of the fault, or finite and written as it was read.
pub(crate) fn check_robot(bytes: &[u8]) {
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

/// Keys that the studies of the repository leave out.
const STUDY: &str = "\
[control]
robot = \"planar-example\"
[machine]
robot = \"planar-example-calibrated\"
model = \"elastic\"
[initial]
pose = [0, 5.2]
tension_method = \"qp\"
offset_robot = \"planar-example\"
[limits]
tension_min_N = 100
tension_max_N = 9e3
position_error_max_m = 0.01
rotation_error_max_rad = 0.02
[poses.file]
path = \"poses.csv\"
set = \"train\"
[noise]
position_m = 1e-3
";

const SIDECAR: &str = "layout_version = 1\n[sigmas]\nposition_m = 0.001\nlength_m = 0.0002\n[provenance]\nseed = 3\n";

const DATA: &str = "\
x_m,y_m,cable_length_m_1,cable_length_m_2,cable_length_mm_3,cable_length_m_4,tension_N_1,tension_N_2,tension_N_3,tension_N_4,set,t_s
0.5,4.0,7.6,6.0,6800.5,6.0,1000,1001,1002,1003,train,0
1.5,3.0,9.0,6.1,7159,4.3,1100,1101,1102,1103,validation,0.5
";

const WIDE_DATA: &str = "\
x_mm,y_mm,angle_deg,cable_length_m_1,cable_length_m_2,cable_length_m_3,cable_length_m_4,colour
500.0,4e3,1.5,7.6,6.0,6.8005,6.0,\"red, or so\"
1500,3000,-2,9.0,6.1,7.159,4.3,blue
";

/// Data of the planar example are refused, or have as many finite numbers as they should; splits of them never panic.
pub(crate) fn check_data(bytes: &[u8]) {
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

/// A study is refused, or its poses are finite.
pub(crate) fn check_study(bytes: &[u8]) {
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

/// The planar example, rigid.
static PLANAR: LazyLock<Model> = LazyLock::new(|| {
    Model::new(Robot::builtin("planar-example").expect("is built in"), Composition::STANDARD).expect("is a model")
});

/// A map of smooth errors.
fn map() -> String {
    let model = &*PLANAR;
    let mut samples = Samples { cable_count: model.cable_count(), ..Samples::default() };
    for k in 0..12 {
        let (x, y) = (f64::from(k % 4) - 1.5, 3.0 + f64::from(k / 4));
        let pose = model.robot().motion_pattern.pose(model.robot().plane, &[x, y]).expect("is a pose");
        let lengths = model.cable_lengths(&pose).expect("have a path");
        samples.lengths.extend(lengths.iter().map(|length| length + 0.01 * (0.3 * x).sin()));
        samples.poses.push(pose);
    }
    compensate(model, &samples, None, 0).expect("is a map").map.to_toml()
}

/// A map is refused, or corrects by numbers and a share of itself everywhere.
pub(crate) fn check_map(bytes: &[u8]) {
    let model = &*PLANAR;
    let Ok(map) = Compensation::from_toml_bytes(bytes, "any.toml", model) else { return };
    for components in [[0.0, 4.0], [0.7, 3.1], [-1.0, 4.9], [1.52, 4.0], [9.0, 9.0]] {
        let pose = model.robot().motion_pattern.pose(model.robot().plane, &components).expect("is a pose");
        let correction = map.at(&pose);
        assert!((0.0..=1.0).contains(&correction.fraction) && correction.lengths.iter().all(|own| own.is_finite()));
    }
    let text = map.to_toml();
    let again = Compensation::from_toml_bytes(text.as_bytes(), "any.toml", model).expect("is a map again");
    assert_eq!(again.to_toml(), text);
}

/// A sidecar is refused, or its accuracies make sense.
pub(crate) fn check_sidecar(bytes: &[u8]) {
    if let Ok(sidecar) = Sidecar::from_toml_bytes(bytes, "any.meta.toml") {
        let sigmas = [sidecar.sigmas.position, sidecar.sigmas.rotation, sidecar.sigmas.length, sidecar.sigmas.tension];
        assert!(sigmas.into_iter().flatten().all(|sigma| sigma.is_finite() && sigma >= 0.0));
    }
}

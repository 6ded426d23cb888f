//! CASPR's own models, beside the project: imported to the same numbers as the converted files, or told what they lack.

use std::path::{Path, PathBuf};

use cdpr_model::robot::Robot;
use cdpr_model::robot::caspr::{self, Files, Import, Loss, Options};

/// A folder beside the project; `None`, said aloud, when it is absent outside CI.
#[expect(clippy::print_stderr, reason = "a skipped test says so")]
fn shared(folder: &str) -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data").join(folder);
    if folder.is_dir() {
        return Some(folder);
    }
    assert!(std::env::var_os("CI").is_none_or(|ci| ci != "true"), "{} is absent", folder.display());
    eprintln!("skipped: {} is absent", folder.display());
    None
}

/// The model in a folder; its files are called `…_bodies.xml` and `…_cables.xml`.
fn import(folder: &Path, cable_set: Option<&str>) -> Import {
    let file = |ending: &str| {
        let mut entries = std::fs::read_dir(folder).expect("the folder is readable").map(|entry| entry.unwrap().path());
        entries.find(|path| path.to_string_lossy().ends_with(ending)).expect("every model has both files")
    };
    let (bodies, cables) = (file("_bodies.xml"), file("_cables.xml"));
    let files = Files {
        bodies: &std::fs::read(&bodies).unwrap(),
        bodies_name: &bodies.display().to_string(),
        cables: &std::fs::read(&cables).unwrap(),
        cables_name: &cables.display().to_string(),
    };
    let options = Options { cable_set, name: None };
    caspr::import(&files, &options).unwrap_or_else(|error| panic!("{error}"))
}

/// All numbers that a model reads, with a word for each.
fn numbers(robot: &Robot, with_home: bool) -> Vec<(String, Option<f64>)> {
    let mut all: Vec<(String, Option<f64>)> = Vec::new();
    let mut add = |what: &str, list: &[f64]| all.extend(list.iter().map(|number| (what.to_owned(), Some(*number))));
    add("gravity", robot.gravity.unwrap().as_slice());
    add("mass", &[robot.platform.mass.unwrap()]);
    add("centre of mass", robot.platform.center_of_mass.unwrap().as_slice());
    add("inertia", robot.platform.inertia.unwrap().as_slice());
    let travel = robot.travel.as_ref().unwrap();
    add("travel", travel.min.as_slice());
    add("travel", travel.max.as_slice());
    let home = robot.home.unwrap();
    if with_home {
        add("home", home.position.as_slice());
    }
    add("orientation", home.rotation.coords.as_slice());
    for cable in &robot.cables {
        add(&cable.name, cable.frame_anchor.as_slice());
        add(&cable.name, cable.platform_anchor.as_slice());
        add(&cable.name, cable.pulley_swivel_axis().unwrap_or_default().as_slice());
    }
    for cable in &robot.cables {
        let scalars = [cable.tension_min, cable.tension_max, cable.pulley_radius(), cable.axial_stiffness()];
        all.extend(scalars.map(|scalar| (cable.name.clone(), scalar)));
    }
    all
}

/// Folder of the model, converted file, cable set (else the default), and whether the converted file kept the home pose:
/// FAST's initial pose breaks its tension limits, so the collection gives it another.
const CONVERTED: [(&str, &str, Option<&str>, bool); 9] = [
    ("2_DoF_VSD", "two-dof-vsd", None, true),
    ("CAROCA", "caroca", None, true),
    ("CAROCA", "caroca-pulleys", Some("with_rotating_pulleys"), true),
    ("CUCableRobot", "cucablerobot", None, true),
    ("CoGiRo", "cogiro", None, true),
    ("FAST", "fast", None, false),
    ("IPAnema_2", "ipanema-2", None, true),
    ("KNTU_planar", "kntu-planar", None, true),
    ("NIST_ROBOCRANE", "nist-robocrane", None, true),
];

#[test]
fn imported_models_have_the_numbers_of_the_converted_files() {
    let (Some(models), Some(robots)) = (shared("caspr-xml"), shared("robots")) else { return };
    for (folder, name, cable_set, with_home) in CONVERTED {
        let imported = import(&models.join(folder), cable_set).robot;
        let text = std::fs::read_to_string(robots.join(format!("{name}.toml"))).unwrap();
        let converted = Robot::from_toml(&text, name).unwrap();
        assert_eq!(imported.motion_pattern, converted.motion_pattern, "{name}");
        assert_eq!(imported.plane, converted.plane, "{name}");
        let names = |robot: &Robot| robot.cables.iter().map(|cable| cable.name.clone()).collect::<Vec<_>>();
        assert_eq!(names(&imported), names(&converted), "{name}");
        let (ours, theirs) = (numbers(&imported, with_home), numbers(&converted, with_home));
        assert_eq!(ours.len(), theirs.len());
        for ((what, one), (_, other)) in ours.iter().zip(&theirs) {
            // the same decimal digits give the same number; 1e-12 leaves room for a quaternion made of angles
            let same = match (one, other) {
                (Some(one), Some(other)) => (one - other).abs() <= 1e-12 * one.abs().max(1.0),
                (one, other) => one == other,
            };
            assert!(same, "{name}, {what}: {one:?} is not {other:?}");
        }
    }
}

/// What each of the ten models exercises, in the words of its NOTICE.
#[test]
fn all_ten_models_are_imported_and_what_they_lack_is_told() {
    let Some(models) = shared("caspr-xml") else { return };
    let mut count = 0;
    for (folder, joint, cables, sets, acting) in [
        ("CoGiRo", "SPATIAL_EULER_XYZ", 8, 1, vec![]),
        ("IPAnema_2", "SPATIAL_EULER_XYZ", 8, 2, vec![]),
        ("CAROCA", "SPATIAL_EULER_XYZ", 8, 3, vec![]),
        ("FAST", "SPATIAL_EULER_XYZ", 6, 1, vec![]),
        ("NIST_ROBOCRANE", "SPATIAL_EULER_XYZ", 6, 1, vec![]),
        ("The_Cable_Robot_Simulator", "SPATIAL_EULER_XYZ", 8, 2, vec![]),
        ("KNTU_planar", "PLANAR_XY", 4, 1, vec![]),
        (
            "2_DoF_VSD",
            "P_XY",
            4,
            3,
            ["cable 1", "cable 2", "cable 3", "cable 4"].map(|n| (Loss::Simplified, n)).to_vec(),
        ),
        (
            "Passive_springs_planar",
            "PLANAR_YZ",
            4,
            2,
            ["spring 1", "spring 2", "spring 3", "spring 4"].map(|n| (Loss::LeftOut, n)).to_vec(),
        ),
        ("CUCableRobot", "SPATIAL_EULER_XYZ", 8, 4, vec![]),
    ] {
        let import = import(&models.join(folder), None);
        assert_eq!((import.joint.as_str(), import.robot.cable_count()), (joint, cables), "{folder}");
        assert_eq!(import.cable_sets.len(), sets, "{folder}");
        let told = import.findings.iter().filter(|finding| finding.loss != Loss::Ignored);
        let told: Vec<(Loss, &str)> = told.map(|it| (it.loss, it.name.as_deref().unwrap_or_default())).collect();
        assert_eq!(told, acting, "{folder}");
        count += 1;
    }
    assert_eq!(count, 10);
}

#[test]
fn every_cable_set_of_every_model_makes_a_robot_that_is_read_back() {
    let Some(models) = shared("caspr-xml") else { return };
    let mut count = 0;
    for entry in std::fs::read_dir(models).unwrap().map(|entry| entry.unwrap().path()) {
        if !entry.is_dir() || entry.ends_with("templates") {
            continue;
        }
        for set in import(&entry, None).cable_sets {
            let robot = import(&entry, Some(&set)).robot;
            assert_eq!(Robot::from_toml(&robot.to_toml(), "again").unwrap(), robot, "{}: {set}", entry.display());
            count += 1;
        }
    }
    assert_eq!(count, 20);
}

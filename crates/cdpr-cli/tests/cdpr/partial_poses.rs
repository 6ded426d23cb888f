//! Records of one reflector: positions without orientation, in a world of the tracker's own.

use nalgebra::{UnitQuaternion, Vector3};

use super::cdpr_in;

/// Study of a robot whose recorded lengths are up to 20 mm too long.
const STUDY: &str = r#"[control]
robot = "cogiro"
[machine]
robot = "machine.toml"
[initial]
pose = [0, 0, 2, 0, 0, 0]
offset = "none"
[poses.random]
count = 40
min = [-3, -2, 1, -0.2, -0.2, -0.2]
max = [3, 2, 3, 0.2, 0.2, 0.2]
[noise]
position_m = 0.001
rotation_rad = 0.001
length_m = 0.001
"#;

fn offset(cable: usize) -> f64 {
    0.02 * (1.3 * cable as f64).sin()
}

/// `reflector.csv`: the record of a reflector at (0.3, −0.2, 0.4) m on the platform, in a world at (6, −4, 1.5) m that is turned by 2 rad.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let mut robot = cdpr_model::robot::Robot::builtin("cogiro").unwrap();
    for (cable, own) in robot.cables.iter_mut().enumerate() {
        own.length_offset = Some(offset(cable));
    }
    std::fs::write(path("machine.toml"), robot.to_toml()).unwrap();
    std::fs::write(path("study.toml"), STUDY).unwrap();
    let run = cdpr_in(folder.path(), "simulate study.toml --out full.csv");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let text = std::fs::read_to_string(path("full.csv")).unwrap();
    let mut lines = text.lines();
    let mut seen = format!("x_m,y_m,z_m,{}\n", lines.next().unwrap().splitn(8, ',').last().unwrap());
    let world = UnitQuaternion::from_scaled_axis(Vector3::z() * 2.0);
    for line in lines {
        let cells: Vec<&str> = line.splitn(8, ',').collect();
        let number = |k: usize| cells[k].parse::<f64>().unwrap();
        let turn = nalgebra::Quaternion::new(number(6), number(3), number(4), number(5));
        let reflector = UnitQuaternion::from_quaternion(turn) * Vector3::new(0.3, -0.2, 0.4);
        let place = Vector3::new(number(0), number(1), number(2)) + reflector;
        let own = world.inverse() * (place - Vector3::new(6.0, -4.0, 1.5));
        seen.push_str(&format!("{},{},{},{}\n", own.x, own.y, own.z, cells[7]));
    }
    std::fs::write(path("reflector.csv"), seen).unwrap();
    std::fs::copy(path("full.meta.toml"), path("reflector.meta.toml")).unwrap();
    folder
}

/// Offsets within three deviations, the sensors called what they are; `select` takes the frames that the data need.
#[test]
fn one_reflector_calibrates_eight_winches() {
    let folder = folder();
    let command = "identify cogiro reflector.csv --free length-offset,tracker-frame,marker-frame --format json";
    let run = cdpr_in(folder.path(), command);
    let answer = run.json();
    assert_eq!((run.exit_code, &answer["status"]), (0, &"converged-with-caution".into()), "{}", run.stderr);
    assert!(run.stderr.contains("positions without orientation"), "{}", run.stderr);
    let parameters = answer["parameters"].as_array().unwrap();
    for (cable, own) in parameters.iter().take(8).enumerate() {
        let (value, sigma) = (own["value"].as_f64().unwrap(), own["sigma"].as_f64().unwrap());
        assert!((value - offset(cable)).abs() < 3.0 * sigma && sigma < 0.004, "{own}");
    }
    let names: Vec<&str> = parameters.iter().skip(8).map(|own| own["name"].as_str().unwrap()).collect();
    assert_eq!(names[..3], ["tracker-frame.x", "tracker-frame.y", "tracker-frame.z"]);
    assert_eq!(names[6..], ["marker-frame.x", "marker-frame.y", "marker-frame.z"]);
    let sensors: Vec<&str> =
        answer["sensors"].as_array().unwrap().iter().map(|own| own["sensor"].as_str().unwrap()).collect();
    assert_eq!(sensors, ["length", "position"]);

    let ladder = "standard;standard:length-offset,tracker-frame;standard:length-offset,tracker-frame,marker-frame";
    let run = cdpr_in(folder.path(), &format!("select cogiro reflector.csv --candidates {ladder} --format json"));
    assert_eq!(run.json()["recommended"], "standard:length-offset,tracker-frame,marker-frame", "{}", run.stderr);

    // misspelled orientations are no missing ones
    let text = std::fs::read_to_string(folder.path().join("full.csv")).unwrap();
    std::fs::write(folder.path().join("typo.csv"), text.replacen("qx,qy,qz,qw", "q_x,q_y,q_z,q_w", 1)).unwrap();
    let typo = cdpr_in(folder.path(), "identify cogiro typo.csv --free length-offset");
    assert_eq!(typo.exit_code, 2, "{}{}", typo.stdout, typo.stderr);
}

use super::*;
use cdpr_model::robot::Robot;

const STUDY: &str = r#"
[control]
robot = "planar-example"
[machine]
robot = "planar-example"
model = "elastic"
[initial]
pose = [0, 5.2]
tension_method = "closed-form"
[limits]
tension_min_N = 1000
tension_max_N = 8000
"#;

fn subjects() -> Subjects {
    let robot = Robot::builtin("planar-example").unwrap().to_toml();
    Subjects { study: STUDY.to_owned(), control: robot.clone(), machine: robot, offset_robot: None }
}

fn sweep(parameters: &str) -> Sweep {
    let text = format!(
        "study = \"s.toml\"\nbounds_m = [-6, 6, -1, 9]\nstep_m = 0.1\nposition_error_max_m = [0.01]\n{parameters}"
    );
    Sweep::from_toml_bytes(text.as_bytes(), "sweep.toml").unwrap()
}

fn fractions(sweep: &Sweep) -> Vec<f64> {
    let subjects = subjects();
    let points = sweep.points();
    let prepared = PreparedSweep::new(sweep, &subjects).unwrap();
    let rows = points.iter().enumerate().map(|(point, values)| prepared.row(point, values));
    rows.map(|row| row.reachable.unwrap_or_else(|| panic!("{:?}", row.reason)) / row.physical.unwrap()).collect()
}

/// Fig. 3.17 to 3.19: above 200 kN stiffness hardly changes the reachable workspace, 70.5 to 72.8 %; cells of 10 cm are
/// accurate to about half a percent.
#[test]
fn stiffer_cables_reach_hardly_more() {
    let sweep = sweep(
        "[[parameter]]\nkey = \"both.cable[*].axial_stiffness_EA_N\"\nfrom = 2e5\nto = 3.5e6\ncount = 4\nspacing = \"logarithmic\"",
    );
    for fraction in fractions(&sweep) {
        assert!((0.70..0.733).contains(&fraction), "{fraction}");
    }
}

/// Fig. 3.20: of the tension levels in eq. 3.41, f_max = 6000 N reaches most.
#[test]
fn the_best_initial_tensions_aim_at_6000_newtons() {
    let values = [4000.0, 5000.0, 6000.0, 7000.0, 8000.0];
    let sweep =
        sweep("[[parameter]]\nkey = \"study.initial.tension_limits_N[2]\"\nvalues = [4000, 5000, 6000, 7000, 8000]");
    let mut subjects = subjects();
    subjects.study = subjects.study.replace("tension_method", "tension_limits_N = [1000, 8000]\ntension_method");
    let prepared = PreparedSweep::new(&sweep, &subjects).unwrap();
    let fraction = |point: usize| {
        let row = prepared.row(point, &values[point..=point]);
        row.reachable.unwrap_or_else(|| panic!("{:?}", row.reason))
    };
    let areas: Vec<f64> = (0..5).map(fraction).collect();
    let best = (0..5).max_by(|&a, &b| areas[a].total_cmp(&areas[b])).unwrap();
    assert_eq!(values[best], 6000.0, "{areas:?}");
}

#[test]
fn keys_name_entries_from_one_and_add_what_a_table_lacks() {
    let mut file: toml::Table = "[[cable]]\nr = 1\na = [1, 2]\n[[cable]]\nr = 2\na = [3, 4]".parse().unwrap();
    let set =
        |file: &mut toml::Table, key: &str, value: f64| key.parse::<Key>().and_then(|key| key.set(file, value, None));
    set(&mut file, "machine.cable[*].r", 5.0).unwrap();
    set(&mut file, "machine.cable[2].a[1]", 6.0).unwrap();
    set(&mut file, "machine.mass", 7.0).unwrap();
    let expected: toml::Table =
        "mass = 7.0\n[[cable]]\nr = 5.0\na = [1, 2]\n[[cable]]\nr = 5.0\na = [6.0, 4]".parse().unwrap();
    assert_eq!(file, expected);
    let wrong = |key: &str| set(&mut file.clone(), key, 1.0).unwrap_err().to_string();
    assert!(wrong("machine.cable[3].r").contains("there are 2 entries, not 3"));
    assert!(wrong("cable[1].r").contains("names no file"));
    assert!(wrong("both.cable[0].r").contains("[1], [2], … or [*]"));
    assert!(wrong("both.platform.mass_kg").contains("there is no `platform`"));
    for key in ["machine.cable[*].r", "both.frame-anchor[1].x", "study.initial.pose[1]", "placed_pulley_radius_m"] {
        assert_eq!(key.parse::<Key>().unwrap().to_string(), key);
    }
}

#[test]
fn what_cannot_be_built_has_a_reason() {
    let sweep = sweep("[[parameter]]\nkey = \"machine.cable[*].axial_stiffness_EA_N\"\nvalues = [-1]");
    let subjects = subjects();
    let row = PreparedSweep::new(&sweep, &subjects).unwrap().row(0, &[-1.0]);
    assert!(row.reachable.is_none() && row.reason.unwrap().contains("axial_stiffness_EA_N"));
    let refused = |text: &str| Sweep::from_toml_bytes(text.as_bytes(), "sweep.toml").unwrap_err().to_string();
    assert!(refused("study = \"s\"\nparameter = []").contains("at least one parameter"));
    assert!(refused("study = \"s\"\n[[parameter]]\nkey = \"both.x\"\nfrom = 1").contains("either `values`"));
}

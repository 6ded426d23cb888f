//! `load`, `stiffness`, and `ik` of elastic models.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::Value;

use super::{SQUARE, cdpr, cdpr_in, file_with, numbers};

const SIMULATOR: &str = "cablerobot-simulator-helicopter-kinematic-calibrated";

/// Eq. 6.22.
const TENSIONS: &str = "3678,2169,4250,1708,3985,2394,4715,1684";

/// Tensions of the planar example at its home pose that balance 1962 N.
const PLANAR: &str = "5808,5909,2390,2421";

/// The square with elastic cables of 1 kN and 100 kg in an upright plane.
fn elastic_square() -> String {
    let elastic = SQUARE.replace("platform_anchor_m", "axial_stiffness_EA_N = 1000.0\nplatform_anchor_m");
    elastic.replace("[home_pose]", "gravity_m_s2 = [0.0, -9.81]\n\n[platform]\nmass_kg = 1.0\n\n[home_pose]")
}

fn matrix(value: &Value) -> Vec<Vec<f64>> {
    value.as_array().unwrap().iter().map(numbers).collect()
}

#[test]
fn the_load_of_the_simulator_is_the_one_printed() {
    let run = cdpr(&format!("load {SIMULATOR} --pose 0,0,1.5,0,0,0 --tensions {TENSIONS} --format json"));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json_with(&["status", "force_N", "moment_Nm", "internal_N", "external_N"]);
    let found = [numbers(&answer["force_N"]), numbers(&answer["moment_Nm"])].concat();
    let printed = [22.2, -163.4, -6005.5, 179.9, -755.8, 43.6];
    // the tensions are printed as integers
    assert!(found.iter().zip(printed).all(|(found, printed)| (found - printed).abs() < 0.6), "{found:?}");
    let (internal, external) = (numbers(&answer["internal_N"]), numbers(&answer["external_N"]));
    let sums = internal.iter().zip(&external).map(|(internal, external)| internal + external);
    assert!(sums.zip(TENSIONS.split(',')).all(|(sum, given)| (sum - given.parse::<f64>().unwrap()).abs() < 1e-9));
}

/// In the middle of the square equal tensions cancel: they are internal altogether.
#[test]
fn equal_tensions_of_the_square_carry_nothing() {
    let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
    let answer = cdpr_in(folder.path(), "load square.toml --pose 5,4 --tensions 50,50,50,50 --format json").json();
    assert!(numbers(&answer["force_N"]).iter().chain(&numbers(&answer["external_N"])).all(|x| x.abs() < 1e-12));
    assert!(answer["moment_Nm"].is_null(), "a point has no moment: {answer}");
    let planar = cdpr("load kntu-planar --pose 0,0,0 --tensions 1,2,3,4 --format json").json();
    assert!(planar["moment_Nm"].is_number() && planar["force_N"].as_array().unwrap().len() == 2, "{planar}");
}

#[test]
fn groups_of_cables_have_their_share_of_the_load() {
    let load = format!("load {SIMULATOR} --pose 0,0,1.5,0,0,0 --tensions {TENSIONS}");
    let run = cdpr(&format!("{load} --group upper=1,3,5,7 --group lower=2,4,6,8 --format json"));
    let answer = run.json_with(&["sections"]);
    let of = |section: usize| numbers(&answer["sections"][section]["force_N"]);
    assert_eq!(answer["sections"][1]["name"], "lower");
    for (axis, force) in numbers(&answer["force_N"]).into_iter().enumerate() {
        assert!((of(0)[axis] + of(1)[axis] + force).abs() < 1e-9);
    }
    for (group, fault) in [
        ("upper", "a name, `=` and cable numbers expected"),
        ("upper=1,x", "`x` is not a cable number"),
        ("upper=0", "counted from 1"),
        ("upper=1,9", "cable 9, but the robot has the cables 1 to 8"),
        ("upper=1,1", "names cable 1 twice"),
    ] {
        let run = cdpr(&format!("{load} --group {group}"));
        assert!(run.exit_code == 2 && run.stderr.contains(fault), "{group}: {}", run.stderr);
    }
}

/// tension_scale 2 and offset 10 N of cable a: the record 110 N is 50 N.
#[test]
fn recorded_tensions_lose_the_scale_and_offset_of_the_file() {
    let text = SQUARE.replacen("tension_min_N = 10.0", "tension_scale = 2.0\ntension_offset_N = 10.0", 1);
    let (folder, _) = file_with("square.toml", text.as_bytes());
    let load = |tensions: &str| {
        cdpr_in(folder.path(), &format!("load square.toml --pose 5,4 {tensions} --format json")).json()
    };
    let (recorded, real) = (load("--recorded --tensions 110,50,50,50"), load("--tensions 50,50,50,50"));
    assert_eq!(recorded, real);
}

#[test]
fn a_load_where_a_cable_has_no_course_is_a_negative_answer() {
    let run = cdpr(&format!("load planar-example --pose -6,8 --tensions {PLANAR} --format json"));
    assert_eq!((run.exit_code, run.json()["status"].as_str()), (1, Some("singular")));
    assert!(run.json_with(&["force_N"])["force_N"].is_null());
}

#[test]
fn stiffness_is_the_sum_of_its_parts_and_compliance_its_inverse() {
    for arguments in [
        format!("planar-example --pose 0,5.2 --tensions {PLANAR}"),
        format!("{SIMULATOR} --pose 0,0,1.5,0.1,0.2,-0.1 --tensions {TENSIONS} --wrench 0,0,-6000,0,-700,0"),
    ] {
        let run = cdpr(&format!("stiffness {arguments} --format json"));
        assert_eq!(run.exit_code, 0, "{}{}", run.stdout, run.stderr);
        let answer = run.json_with(&["status", "stiffness", "geometric", "cable", "gravity", "compliance"]);
        assert_eq!(answer["status"], "stable");
        let of = |key: &str| matrix(&answer[key]);
        let (system, geometric, cable, gravity) = (of("stiffness"), of("geometric"), of("cable"), of("gravity"));
        let compliance = of("compliance");
        for i in 0..system.len() {
            for j in 0..system.len() {
                let parts = cable[i][j] - geometric[i][j] - gravity[i][j];
                assert!((system[i][j] - parts).abs() < 1e-6 && geometric[i][j] != cable[i][j]);
                let product: f64 = (0..system.len()).map(|k| system[i][k] * compliance[k][j]).sum();
                // entries of 1e6 by rounding of 1e-16
                assert!((product - if i == j { 1.0 } else { 0.0 }).abs() < 1e-8);
            }
        }
    }
}

#[test]
fn rigid_models_have_no_stiffness_and_say_which_has() {
    let run = cdpr(&format!("stiffness planar-example --model standard --pose 0,5.2 --tensions {PLANAR}"));
    assert_eq!(run.exit_code, 2);
    assert!(run.stderr.contains("rigid") && run.stderr.contains("`--model elastic`"), "{}", run.stderr);
}

#[test]
fn tensions_that_hold_nothing_or_do_not_balance_are_told() {
    let slack = cdpr("stiffness planar-example --pose 0,5.2 --tensions 0,0,0,0 --format json");
    assert_eq!((slack.exit_code, slack.json()["status"].as_str()), (1, Some("indifferent")));
    let answer = slack.json();
    assert!(answer["compliance"].is_null() && answer["reason"].as_str().unwrap().contains("4 of them slack"));
    let unbalanced = cdpr("stiffness planar-example --pose 0,5.2 --tensions 5808,5909,2390,5000 --format json");
    let warnings = unbalanced.json()["warnings"].to_string();
    assert!(unbalanced.exit_code == 0 && warnings.contains("do not balance the load"), "{warnings}");
}

#[test]
fn what_a_file_lacks_for_stiffness_is_named_by_its_key() {
    for (robot, pose, key) in [
        ("cogiro", "0,0,2,0,0,0", "axial_stiffness_EA_N"),
        ("cablerobot-simulator-helicopter-design", "0,0,2.5,0,0,0", "axial_stiffness_EA_N"),
    ] {
        for command in ["stiffness", "ik --model elastic"] {
            let run = cdpr(&format!("{command} {robot} --pose {pose} --tensions 1,1,1,1,1,1,1,1"));
            assert!(run.exit_code == 2 && run.stderr.contains(key), "{command} {robot}: {}", run.stderr);
        }
    }
    let massless = elastic_square().replace("mass_kg = 1.0\n", "");
    let (folder, _) = file_with("square.toml", massless.as_bytes());
    let run = cdpr_in(folder.path(), "stiffness square.toml --pose 5,4 --tensions 1,1,1,1");
    assert!(
        run.exit_code == 2 && run.stderr.contains("`mass_kg`") && run.stderr.contains("--wrench"),
        "{}",
        run.stderr
    );
}

#[test]
fn tensions_and_wrenches_at_fault_are_told_by_their_place() {
    for command in ["load planar-example", "stiffness planar-example", "ik planar-example --model elastic"] {
        for (tensions, fault) in [
            ("1,2,3", "expected 4 cable tensions"),
            ("1,2,-3,4", "cable 3: a tension of -3 N would push"),
            ("1,nan,3,4", "component 2"),
            ("1,2,3,4e9", "cable 4"),
        ] {
            let run = cdpr(&format!("{command} --pose 0,5 --tensions {tensions}"));
            let is_estimate = command.starts_with("load") && tensions.contains("e9");
            assert_eq!(run.exit_code, if is_estimate { 0 } else { 2 }, "{command} {tensions}: {}", run.stderr);
            assert!(is_estimate || run.stderr.contains(fault), "{command} {tensions}: {}", run.stderr);
        }
    }
    for command in ["stiffness", "ik --model elastic"] {
        let run = cdpr(&format!("{command} planar-example --pose 0,5 --tensions {PLANAR} --wrench 1,2,3"));
        assert!(run.exit_code == 2 && run.stderr.contains("fx,fy, found 3 numbers"), "{}", run.stderr);
    }
}

/// q_θ = q (1 − f/k_F), with k_F = 200 kN.
#[test]
fn elastic_cables_are_paid_out_shorter_by_their_stretch() {
    let run = cdpr(&format!("ik planar-example --model elastic --pose 0,5.2 --tensions {PLANAR} --format json"));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json_with(&["cable_lengths_m", "controlled_lengths_m", "tensions_N"]);
    let (lengths, controlled) = (numbers(&answer["cable_lengths_m"]), numbers(&answer["controlled_lengths_m"]));
    let tensions = numbers(&answer["tensions_N"]);
    for cable in 0..4 {
        let expected = lengths[cable] * (1.0 - tensions[cable] / 2e5);
        assert!((controlled[cable] - expected).abs() < 1e-12 && controlled[cable] < lengths[cable]);
    }
}

#[test]
fn tensions_given_to_a_rigid_model_are_remarked_upon() {
    let with = cdpr(&format!("ik planar-example --pose 0,5.2 --tensions {PLANAR} --format json"));
    assert!(with.exit_code == 0 && with.stderr.contains("`--model elastic`"), "{}", with.stderr);
    let (mut remarked, plain) = (with.json(), cdpr("ik planar-example --pose 0,5.2 --format json").json());
    assert!(remarked["warnings"][0].as_str().unwrap().contains("`--model elastic`"), "{remarked}");
    remarked["warnings"] = plain["warnings"].clone();
    assert_eq!(remarked, plain);
}

/// Whatever numbers come, the answer is one of the exit codes with a word on it, never a panic (101) or a signal.
#[test]
fn no_numbers_make_the_statics_panic() {
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    let words = ["0", "-1", "1e308", "-1e308", "1e-320", "5", "nan", "", "x", "1e200", "3000", "0.1"];
    let list = |rng: &mut ChaCha8Rng, count: usize| {
        let count = if rng.random_range(0..8) == 0 { count + 1 } else { count };
        // mostly numbers that get past the reader
        let word = |rng: &mut ChaCha8Rng| match rng.random_range(0..12) {
            0 => words[rng.random_range(0..words.len())].to_owned(),
            1 => format!("1e{}", rng.random_range(-320..308)),
            _ => format!("{}", rng.random_range(0.0..9.0)),
        };
        (0..count).map(|_| word(rng)).collect::<Vec<_>>().join(",")
    };
    for round in 0..150 {
        let (robot, dof, cables) = [("planar-example", 2, 4), (SIMULATOR, 6, 8)][round % 2];
        let command = ["load", "stiffness", "ik --model elastic"][round % 3];
        let mut line =
            format!("{command} {robot} --pose={} --tensions={}", list(&mut rng, dof), list(&mut rng, cables));
        if command != "load" && rng.random() {
            line.push_str(&format!(" --wrench={}", list(&mut rng, dof)));
        }
        line.push_str([" --format json", ""][rng.random_range(0..2)]);
        let run = cdpr(&line);
        assert!((0..=3).contains(&run.exit_code), "{line}: {}\n{}", run.exit_code, run.stderr);
        assert!(run.exit_code < 2 || !run.stderr.is_empty(), "{line}");
        assert!(run.exit_code != 0 || !run.stdout.contains("NaN"), "{line}: {}", run.stdout);
    }
}

/// At the home pose the tensions nearest to the middle of the limits are the printed ones, and balance the load.
#[test]
fn tensions_default_to_the_distribution_within_limits() {
    for command in ["ik --model elastic", "stiffness"] {
        let run = cdpr(&format!("{command} planar-example --pose 0,5.2 --format json"));
        assert_eq!(run.exit_code, 0, "{command}: {}", run.stderr);
        let tensions = numbers(&run.json()["tensions_N"]);
        let printed = PLANAR.split(',').map(|number| number.parse::<f64>().unwrap());
        // printed as integers
        assert!(tensions.iter().zip(printed).all(|(found, printed)| (found - printed).abs() < 0.5), "{tensions:?}");
    }
    let stiffness = cdpr("stiffness planar-example --pose 1,4 --wrench 300,-2500 --format json");
    let residual = numbers(&stiffness.json()["wrench_residual"]);
    assert!(residual.iter().all(|x| x.abs() < 1e-8), "{residual:?}");
}

#[test]
fn without_tensions_that_balance_the_load_the_answer_is_no_with_a_reason() {
    for command in ["ik --model elastic", "stiffness"] {
        let run = cdpr(&format!("{command} planar-example --pose 0,5.2 --wrench 0,-50000 --format json"));
        assert_eq!(run.exit_code, 1, "{command}: {}", run.stderr);
        let answer = run.json_with(&["status", "reason", "controlled_lengths_m"]);
        assert_eq!(answer["status"], "infeasible");
        assert!(answer["reason"].as_str().unwrap().contains("cable"), "{answer}");
        let singular = cdpr(&format!("{command} planar-example --pose -6,8 --format json"));
        assert_eq!((singular.exit_code, singular.json()["status"].as_str()), (1, Some("singular")), "{command}");
    }
    // the geometry is answered all the same
    let ik = cdpr("ik --model elastic planar-example --pose 0,5.2 --wrench 0,-50000 --format json").json();
    assert!(ik["cable_lengths_m"][0].is_number() && ik["controlled_lengths_m"][0].is_null(), "{ik}");
}

#[test]
fn missing_limits_are_named_where_tensions_are_not_given() {
    let (folder, _) = file_with("square.toml", elastic_square().as_bytes());
    for command in ["ik --model elastic", "stiffness"] {
        let run = cdpr_in(folder.path(), &format!("{command} square.toml --pose 5,4"));
        assert!(run.exit_code == 2 && run.stderr.contains("`tension_min_N`"), "{command}: {}", run.stderr);
        assert!(run.stderr.contains("--tensions"), "{command}: {}", run.stderr);
    }
}

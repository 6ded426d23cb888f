//! `tension`, and what `check` says about the home pose.

use std::path::Path;

use serde_json::Value;

use super::{SQUARE, cdpr, cdpr_in, file_with, numbers};

/// Miermeister 2021, Fig. 3.17; the optimum is the closed form where that keeps the limits.
#[test]
fn both_methods_give_the_published_tensions_of_the_planar_example() {
    for method in ["qp", "closed-form"] {
        let run = cdpr(&format!(
            "tension planar-example --pose 0,5.2 --wrench 0,-1962 --min 1000 --max 8000 --method {method} --format json"
        ));
        assert_eq!(run.exit_code, 0, "{}", run.stderr);
        let answer = run.json_with(&["status", "tensions_N", "wrench_residual", "reason", "pose", "method"]);
        assert_eq!((answer["status"].as_str(), answer["method"].as_str()), (Some("feasible"), Some(method)));
        let found = numbers(&answer["tensions_N"]);
        let expected = [5807.9, 5908.7, 2390.0, 2421.2];
        assert!(found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 0.1), "{found:?}");
        assert!(numbers(&answer["wrench_residual"]).iter().all(|rest| rest.abs() < 1e-8));
    }
}

#[test]
fn a_load_too_heavy_is_a_negative_answer_that_names_the_cables() {
    let run = cdpr("tension planar-example --pose 0,5.2 --wrench 0,-40000 --format json");
    assert_eq!(run.exit_code, 1, "{}", run.stdout);
    let answer = run.json_with(&["certificate"]);
    assert_eq!(answer["status"], "infeasible");
    assert!(answer["tensions_N"].is_null());
    let reason = answer["reason"].as_str().unwrap();
    // by hand: across cable 1, cable 2 alone holds the load and the 1000 N of cables 3 and 4 (cable 1 would need 44.5 kN)
    let least = "even with cables 3 and 4 at the least tension";
    assert_eq!(reason, format!("{least}, cable 2 would need 46.2 kN, its limit allows 8.00 kN"));
    let proof = &answer["certificate"];
    assert!(proof["reachable_N"].as_f64().unwrap() < proof["required_N"].as_f64().unwrap(), "{proof}");
    // the closed form always gives its tensions
    let closed = cdpr("tension planar-example --pose 0,5.2 --wrench 0,-40000 --method closed-form --format json");
    assert_eq!((closed.exit_code, numbers(&closed.json()["tensions_N"]).len()), (1, 4));
    assert!(closed.json()["reason"].as_str().unwrap().contains("cable 1 has"), "{}", closed.stdout);
    let text = cdpr("tension planar-example --pose 0,5.2 --wrench 0,-40000");
    assert!(text.exit_code == 1 && text.stdout.contains(reason), "{}", text.stdout);
}

#[test]
fn what_is_missing_or_wrong_is_named() {
    let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
    for (arguments, faults) in [
        ("--pose 5,4", vec!["gravity_m_s2", "--wrench"]),
        ("--pose 5,4 --wrench 0,-10", vec!["square.toml: the tension limits of cable 2", "tension_min_N", "--min"]),
        ("--pose 5,4 --wrench 0,-10 --min 1", vec!["cable 2", "tension_max_N", "--max"]),
        ("--pose 5,4 --wrench 0,-10 --min 9 --max 1", vec!["--min", "above the largest 1 N"]),
        ("--pose 5,4 --wrench 0,-10,0", vec!["takes the wrench components fx,fz, found 3 numbers"]),
        ("--pose 5,4 --wrench 0,nan", vec!["component 2: `nan` is not a finite number"]),
        ("--pose 5,4 --min -1", vec!["-1 is below 0"]),
        ("--pose 5,4 --method guess", vec!["there is no method `guess`", "nearest-wrench"]),
        ("--pose 5,4 --method barier", vec!["did you mean `barrier`?"]),
        ("--pose 5,4 --wrench 0,-10 --min 1 --max 9 --p 0.5", vec!["tensions::option", "--p", "from 1 to 8"]),
        ("--pose 5,4 --wrench 0,-10 --min 1 --max 9 --rate 5", vec!["tensions::option", "--previous"]),
        (
            "--pose 5,4 --wrench 0,-10 --min 1 --max 9 --reference 1",
            vec!["--reference", "reference tensions, one per cable"],
        ),
        ("--pose 5,4 --reference often", vec!["middle, previous or tensions expected"]),
    ] {
        let run = cdpr_in(folder.path(), &format!("tension square.toml {arguments}"));
        assert_eq!(run.exit_code, 2, "{arguments}: {}", run.stdout);
        for fault in faults {
            assert!(run.stderr.contains(fault), "{arguments}: {}", run.stderr);
        }
    }
}

/// Names and summaries of all methods, as the schema of studies states them.
fn methods() -> Vec<(String, String)> {
    let schema = cdpr("schema study").json();
    let choices = schema["$defs"]["Method"]["oneOf"].as_array().expect("a list of choices").clone();
    let text = |value: &Value| value.as_str().expect("text").to_owned();
    choices.iter().map(|choice| (text(&choice["const"]), text(&choice["description"]))).collect()
}

#[test]
fn help_errors_and_book_list_every_method_in_the_words_of_its_entry() {
    let (short, long) = (cdpr("tension -h").stdout, cdpr("tension --help").stdout);
    let wrong = cdpr("tension planar-example --pose 0,5.2 --method middle").stderr;
    let book = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/book/src/tension-distribution.md");
    let book = std::fs::read_to_string(book).expect("the chapter");
    let rows: Vec<&str> = book.lines().skip_while(|line| !line.starts_with("| `--method` |")).skip(2).collect();
    let rows: Vec<&str> = rows.into_iter().take_while(|line| line.starts_with('|')).collect();
    let plain = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut expected = Vec::new();
    for (method, summary) in methods() {
        let default = if method == "qp" { " (default)" } else { "" };
        expected.push(format!("| `{method}`{default} | {summary} |"));
        assert!(plain(&long).contains(&format!("{method}: {summary}")), "{long}");
        assert!(short.contains(&method) && wrong.contains(&method), "{method}: {short}{wrong}");
    }
    assert_eq!(rows, expected);
}

/// What the names promise: low, in between and high.
#[test]
fn every_method_answers_within_the_limits() {
    let mut sums = Vec::new();
    // the closed form breaks limits where it has to
    for (method, _) in methods().into_iter().filter(|(method, _)| method != "closed-form") {
        let run = cdpr(&format!(
            "tension planar-example --pose 0,5.2 --wrench 0,-1962 --min 1000 --max 8000 --method {method} --format json"
        ));
        assert_eq!(run.exit_code, 0, "{method}: {}", run.stderr);
        let answer = run.json_with(&["status", "tensions_N", "wrench_residual", "reason", "iterations"]);
        assert_eq!((answer["status"].as_str(), answer["method"].as_str()), (Some("feasible"), Some(method.as_str())));
        let tensions = numbers(&answer["tensions_N"]);
        assert!(tensions.iter().all(|f| (1000.0..=8000.0).contains(f)), "{method}: {tensions:?}");
        assert!(numbers(&answer["wrench_residual"]).iter().all(|rest| rest.abs() < 1e-3), "{method}: {answer}");
        sums.push((method, tensions.iter().sum::<f64>()));
    }
    let of = |name: &str| sums.iter().find(|(method, _)| method == name).unwrap().1;
    assert!(of("minimum") < of("puncture") && of("puncture") <= of("qp") && of("qp") < of("maximum"), "{sums:?}");
}

#[test]
fn the_nearest_wrench_says_what_it_lacks() {
    let command = "tension planar-example --pose 0,5.2 --wrench 0,-40000 --method nearest-wrench";
    let run = cdpr(&format!("{command} --format json"));
    assert_eq!(run.exit_code, 1, "{}", run.stderr);
    let answer =
        run.json_with(&["tensions_N", "missing_wrench_N_Nm", "missing_force_N", "missing_moment_Nm", "certificate"]);
    assert_eq!((answer["status"].as_str(), answer["proved"].as_bool()), (Some("infeasible"), Some(true)));
    let tensions = numbers(&answer["tensions_N"]);
    assert!(tensions.iter().all(|f| (1000.0..=8000.0).contains(f)), "{tensions:?}");
    let missing = numbers(&answer["missing_wrench_N_Nm"]);
    let residual = numbers(&answer["wrench_residual"]);
    assert!(missing.iter().zip(&residual).all(|(missing, rest)| (missing + rest).abs() < 1e-9), "{answer}");
    let force = answer["missing_force_N"].as_f64().unwrap();
    assert!((force - missing[0].hypot(missing[1])).abs() < 1e-9 && force > 20e3, "{answer}");
    // a point has no moments
    assert_eq!(answer["missing_moment_Nm"], 0.0);
    assert!(answer["moment_length_m"].is_null());
    let text = cdpr(command);
    assert!(text.stdout.contains("these tensions lack"), "{}", text.stdout);
    let spatial =
        cdpr("tension cogiro --pose 0,0,2,0,0,0 --wrench 0,0,-90000,0,0,0 --method nearest-wrench --format json");
    assert!(spatial.json()["moment_length_m"].as_f64().unwrap() > 0.3, "{}", spatial.stdout);
}

/// Where a method misses tensions that exist, the answer says that its verdict is no proof.
#[test]
fn a_method_that_finds_none_where_there_are_some_says_so() {
    let command = "tension planar-example --pose 0,5.2 --wrench 0,-5000 --min 1000 --max 8000";
    let closed = cdpr(&format!("{command} --method closed-form --format json"));
    assert_eq!(closed.exit_code, 1, "{}", closed.stdout);
    assert_eq!(
        (closed.json()["status"].as_str(), closed.json()["proved"].as_bool()),
        (Some("infeasible"), Some(false))
    );
    assert!(closed.json()["reason"].as_str().unwrap().contains("qp does"), "{}", closed.stdout);
    assert_eq!(cdpr(command).exit_code, 0);
    let text = cdpr(&format!("{command} --method closed-form"));
    assert!(text.stdout.contains("not found by closed-form"), "{}", text.stdout);
}

#[test]
fn rates_and_references_are_kept() {
    let command = "tension planar-example --pose 0,5.2 --wrench 0,-1962 --min 1000 --max 8000";
    let previous = "5750,5850,2350,2380";
    let near = cdpr(&format!(
        "{command} --reference previous --previous {previous} --rate 1000 --time-step 0.1 --format json"
    ));
    assert_eq!(near.exit_code, 0, "{}", near.stdout);
    let tensions = numbers(&near.json()["tensions_N"]);
    let limits = numbers(&near.json()["tension_max_N"]);
    for (cable, before) in [5750.0, 5850.0, 2350.0, 2380.0].into_iter().enumerate() {
        assert!((tensions[cable] - before).abs() <= 100.0 && limits[cable] == before + 100.0, "{tensions:?}");
    }
    let far = cdpr(&format!("{command} --previous 2000,2000,6000,6000 --rate 1000 --time-step 0.1 --format json"));
    assert_eq!(far.exit_code, 1, "{}", far.stdout);
    assert!(far.json()["reason"].as_str().unwrap().contains("without the rates there are tensions"), "{}", far.stdout);
}

#[test]
fn a_load_that_overflows_is_a_numerical_failure() {
    let run = cdpr("tension planar-example --pose 0,5.2 --wrench 0,1e300 --format json");
    assert_eq!((run.exit_code, run.json()["status"].as_str()), (3, Some("error")), "{}", run.stdout);
}

#[test]
fn check_tells_whether_the_home_pose_can_be_held() {
    let home = |arguments: &str| cdpr(&format!("check {arguments} --format json")).json()["home"].clone();
    assert_eq!(home("planar-example")["feasible"], true);
    let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
    let run = cdpr_in(folder.path(), "check square.toml --format json").json();
    assert!(run["home"]["feasible"].is_null());
    assert!(run["home"]["feasible_note"].as_str().unwrap().contains("gravity_m_s2"), "{run}");
}

/// Forces whose squares no computer holds are an overflow, told in words; a cable that only cannot hang so would be a negative answer.
#[test]
fn cables_pulled_beyond_all_numbers_are_told_without_one() {
    let robot = include_str!("../../../cdpr-model/robots/planar-example.toml");
    let key = "axial_stiffness_EA_N = 200000.0";
    let (folder, _) =
        file_with("robot.toml", robot.replace(key, &format!("{key}\nlinear_density_kg_per_m = 0.1")).as_bytes());
    for (command, code) in [
        ("tension robot.toml --pose 0,1e90 --max 1e100", 3),
        ("ik robot.toml --pose 0,4 --tensions 1e300,1e300,1e300,1e300", 2),
    ] {
        for model in ["catenary", "elastic+finite-element"] {
            let run = cdpr_in(folder.path(), &format!("{command} --model {model}"));
            assert_eq!(run.exit_code, code, "{command} {model}: {}{}", run.stdout, run.stderr);
            assert!(run.stderr.contains("too large to calculate with"), "{command} {model}: {}", run.stderr);
            assert!(!run.stderr.contains("NaN") && !run.stderr.contains("inf m"), "{command} {model}: {}", run.stderr);
        }
    }
}

//! `tension`, and what `check` says about the home pose.

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
        ("--pose 5,4 --wrench 0,-10", vec!["cable 2", "tension_min_N", "--min"]),
        ("--pose 5,4 --wrench 0,-10 --min 1", vec!["cable 2", "tension_max_N", "--max"]),
        ("--pose 5,4 --wrench 0,-10 --min 9 --max 1", vec!["--min", "above the largest 1 N"]),
        ("--pose 5,4 --wrench 0,-10,0", vec!["takes the wrench components fx,fy, found 3 numbers"]),
        ("--pose 5,4 --wrench 0,nan", vec!["component 2: `nan` is not a finite number"]),
        ("--pose 5,4 --min -1", vec!["-1 is below 0"]),
        ("--pose 5,4 --method barrier", vec!["`barrier` is not part of this version"]),
        ("--pose 5,4 --method guess", vec!["there is no method `guess`"]),
    ] {
        let run = cdpr_in(folder.path(), &format!("tension square.toml {arguments}"));
        assert_eq!(run.exit_code, 2, "{arguments}: {}", run.stdout);
        for fault in faults {
            assert!(run.stderr.contains(fault), "{arguments}: {}", run.stderr);
        }
    }
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

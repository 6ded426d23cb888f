//! `cdpr advise`: the control model that is good enough.

use super::cdpr;

#[test]
fn the_planar_example_needs_elasticity_only_where_millimetres_count() {
    let run = cdpr("advise planar-example --task=-0.5,0.5,4.7,5.7 --accuracy 0.1 --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json_with(&["recommended", "candidates", "must_be_modelled", "may_be_left_out", "timing"]);
    assert_eq!(answer["recommended"], "standard");
    assert_eq!(answer["poses"], 25);
    let run = cdpr("advise planar-example --task=-0.5,0.5,4.7,5.7 --accuracy 0.0001 --format json");
    let answer = run.json();
    assert!(answer["recommended"].as_str().unwrap().contains("elastic"), "{answer}");
    let must = answer["must_be_modelled"].as_array().unwrap();
    let elastic = must.iter().find(|effect| effect["effect"] == "elastic").expect("elasticity must be modelled");
    assert!(elastic["position_error_max_m"].as_f64().unwrap() > 1e-4);
    // the last candidate is like the machine
    let candidates = answer["candidates"].as_array().unwrap();
    let full = candidates.last().unwrap();
    assert_eq!(full["model"], answer["machine"]);
    assert!(full["position_error_m"]["max"].as_f64().unwrap() < 1e-9);
}

/// Effects that were not judged and errors of numbers stand beside the verdict.
#[test]
fn effects_that_were_not_judged_and_wrong_numbers_stand_beside_the_verdict() {
    let command = "advise planar-example --task=-0.5,0.5,4.7,5.7 --accuracy 0.1";
    let answer = cdpr(&format!("{command} --format json")).json_with(&["not_judged", "parameter_errors"]);
    let not_judged: Vec<&str> =
        answer["not_judged"].as_array().unwrap().iter().map(|effect| effect.as_str().unwrap()).collect();
    assert!(not_judged.contains(&"pulley") && !not_judged.contains(&"elastic"), "{answer}");
    let errors = answer["parameter_errors"].as_array().unwrap();
    let anchors: Vec<_> = errors.iter().filter(|error| error["kind"] == "frame-anchor").collect();
    assert_eq!(anchors.len(), 1, "an anchor beside its place in the file is one error: {answer}");
    let of = |key: &str| anchors[0][key].as_f64().unwrap();
    // two deviations of anchors that are off so far move the platform by no more than the accuracy, and by most of it
    let moved = 2.0 * of("sigma_alone") * of("position_max_m_per_unit");
    assert!(moved < 0.11 && moved > 0.05, "{moved}");
    let words = cdpr(command).prose();
    let [verdict, not_judged, errors] =
        ["recommended: ", "; not judged: pulley, drum, ", "errors of its numbers come on top"]
            .map(|part| words.find(part).unwrap_or_else(|| panic!("{part}: {words}")));
    assert!(verdict < not_judged && not_judged < errors && errors - verdict < 600, "{words}");
}

#[test]
fn tensions_of_control_models_are_chosen_as_the_command_says() {
    let advised = |method: &str| {
        let run = cdpr(&format!("advise planar-example --task=-0.5,0.5,4.7,5.7 --accuracy 0.1 {method} --format json"));
        assert_eq!(run.exit_code, 0, "{}", run.stderr);
        run.json()["candidates"][0]["tension_error_N"].as_f64().unwrap()
    };
    // what a kinematic model misses is counted from another reference
    assert!((advised("") - advised("--tension-method minimum")).abs() > 100.0);
    assert_eq!(advised(""), advised("--tension-method qp"));
}

#[test]
fn a_task_out_of_reach_is_a_negative_answer() {
    let run = cdpr("advise planar-example --task=-8,8,4,6 --accuracy 0.01");
    assert_eq!(run.exit_code, 1, "{}", run.stderr);
    assert!(run.stdout.contains("of the task"), "{}", run.stdout);
}

#[test]
fn tasks_and_accuracies_that_are_none_are_refused() {
    for (arguments, words) in [
        ("--task=1,0,2,3 --accuracy 0.01", "--task"),
        ("--task=1,x --accuracy 0.01", "component 2"),
        ("--task=-1,1,4,6 --accuracy 0", "no largest error"),
        ("--task=-1,1,4,6 --accuracy 0.01 --count 1", "--count"),
    ] {
        let run = cdpr(&format!("advise planar-example {arguments}"));
        assert_eq!(run.exit_code, 2, "{arguments}");
        assert!(run.stderr.contains(words), "{arguments}: {}", run.stderr);
    }
}

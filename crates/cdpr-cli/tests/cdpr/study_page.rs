//! `cdpr study`: the page beside the other files of its folder.

use serde_json::Value;

use super::cdpr_in;

/// What the program of a page reads.
fn block(page: &str) -> Value {
    let (_, rest) = page.split_once("id=\"cdpr-data\">").unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

/// The planar example under this control model with a grid of poses.
fn study(model: &str, min: [f64; 2], max: [f64; 2]) -> String {
    format!(
        "[control]\nrobot = \"planar-example\"\nmodel = \"{model}\"\n[machine]\nrobot = \"planar-example\"\nmodel = \"elastic\"\n[initial]\n\
         pose = [0, 5.2]\ntension_method = \"closed-form\"\n[limits]\ntension_min_N = 1000\ntension_max_N = 8000\n\
         [poses.grid]\nmin = {min:?}\nmax = {max:?}\ncount = [2, 2]\n"
    )
}

#[test]
fn the_page_tells_the_numbers_of_the_result_and_is_the_same_every_time() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("study.toml"), study("standard", [-2.0, 2.0], [2.0, 5.0])).unwrap();
    let written = || {
        let run = cdpr_in(folder.path(), "study study.toml --out result --format json");
        assert_eq!(run.exit_code, 0, "{}", run.stderr);
        assert!(run.json()["files"].as_array().unwrap().iter().any(|name| name == "report.html"));
        std::fs::read_to_string(folder.path().join("result/report.html")).unwrap()
    };
    let page = written();
    assert!(page == written(), "the same command writes the same page");
    let result: Value =
        serde_json::from_slice(&std::fs::read(folder.path().join("result/result.json")).unwrap()).unwrap();
    let answer = block(&page)["result"].clone();
    for (key, told) in answer.as_object().unwrap() {
        assert_eq!(*told, result[key], "{key}");
    }
    let errors = block(&page)["samples"]["error_m"].clone();
    let length = |error: &Value| error[0].as_f64().unwrap().hypot(error[1].as_f64().unwrap());
    let mean = errors.as_array().unwrap().iter().map(length).sum::<f64>() / 4.0;
    // six digits of every error are written
    assert!((mean / result["position_error_m"]["mean"].as_f64().unwrap() - 1.0).abs() < 1e-5);
    assert!(page.contains("cdpr study study.toml --out result"), "the command can be repeated");
}

/// Above the frame no tensions hold the platform, and a control model that knows tensions has nothing to send: the page says so.
#[test]
fn poses_without_an_answer_are_told_with_their_reason() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("study.toml"), study("elastic", [0.0, 4.0], [0.0, 9.0])).unwrap();
    let run = cdpr_in(folder.path(), "study study.toml --out result --format json");
    assert_eq!(run.exit_code, 1, "{}", run.stderr);
    let page = std::fs::read_to_string(folder.path().join("result/report.html")).unwrap();
    let reason = run.json()["reason"].as_str().unwrap().to_owned();
    assert!(page.contains(&reason[..30]), "{reason}");
    let samples = block(&page)["samples"].clone();
    assert!(samples["error_m"][0].is_array() && samples["error_m"][1].is_null());
    assert!(samples["reason"][0].is_null() && samples["reason"][1].is_string());
}

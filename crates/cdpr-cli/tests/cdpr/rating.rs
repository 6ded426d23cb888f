//! Criteria of a selection side by side, and the uncertainty of an identification.

use super::cdpr_in;

/// The whole pose and its position alone choose different models of the demo's training data; rigid and elastic models have no common AIC.
#[test]
fn criteria_stand_side_by_side_and_say_where_they_disagree() {
    let folder = tempfile::tempdir().unwrap();
    cdpr_in(folder.path(), "demo --out data");
    let select = "select data/robot.toml data/training.csv --regions 4 --out result";
    let candidates = "--candidates standard;standard:frame-anchor,length-offset,length-scale;elastic:frame-anchor,length-offset,compliance,wrench";
    let answer = cdpr_in(folder.path(), &format!("{select} {candidates} --format json")).json();
    let of = |index: usize, key: &str| answer["candidates"][index][key].clone();
    let number = |index: usize, key: &str| of(index, key).as_f64().unwrap();
    assert_eq!(answer["recommended"], of(2, "name"));
    assert_eq!(answer["rating"]["agrees"], false);
    let words = answer["rating"]["words"].as_str().unwrap();
    assert!(
        words.starts_with("the criteria disagree: `elastic:frame-anchor,length-offset,compliance,wrench` by"),
        "{words}"
    );
    let criteria = answer["rating"]["criteria"].as_array().unwrap();
    let choice = |name: &str| criteria.iter().find(|one| one["name"] == name).unwrap()["candidate"].clone();
    assert_eq!(
        (choice("one-standard-error"), choice("aic"), choice("bic")),
        (of(2, "name"), of(2, "name"), of(2, "name"))
    );
    assert_eq!((choice("leave-region-out"), choice("least-error")), (of(2, "name"), of(1, "name")));
    // 40 mm against 4: no charge for 40 parameters makes up for that
    assert!(number(0, "aicc") > number(1, "aicc") + 1000.0 && number(0, "bic") > number(1, "bic") + 1000.0);
    assert!(number(1, "bic") > number(1, "aic"), "ln n is above 2");
    assert_eq!((of(1, "with_wrenches"), of(2, "with_wrenches")), (false.into(), true.into()));
    let held = of(2, "leave_region_out");
    assert!(held["criterion"].as_f64().unwrap() < of(1, "leave_region_out")["criterion"].as_f64().unwrap());
    assert_eq!(held["samples"], 155);
    let page = std::fs::read_to_string(folder.path().join("result/report.html")).unwrap();
    assert!(page.contains("By other criteria") && page.contains("The criteria disagree:"));
    let text = cdpr_in(folder.path(), &format!("{select} {candidates} --verbose")).stdout;
    assert!(text.contains("the criteria disagree: ") && text.contains("ΔAIC"), "{text}");
    let refused = cdpr_in(folder.path(), "select data/robot.toml data/training.csv --regions 500");
    assert_eq!(refused.exit_code, 2);
    assert!(refused.stderr.contains("500 folds need at least 500 samples"), "{}", refused.stderr);
}

/// Profiles, bootstrap and bands of an identification: keys, files, and what is refused.
#[test]
fn an_identification_tells_its_uncertainty_three_ways() {
    let folder = tempfile::tempdir().unwrap();
    cdpr_in(folder.path(), "demo --out data");
    let identify = "identify data/robot.toml data/training.csv --free frame-anchor --loss squared --starts 1";
    let arguments = "--profile frame-anchor[1].x,frame-anchor[2] --bootstrap 100 --uncertainty out";
    let run = cdpr_in(folder.path(), &format!("{identify} {arguments} --format json"));
    let answer = run.json();
    let profiles = answer["profiles"].as_array().unwrap();
    let names: Vec<&str> = profiles.iter().map(|one| one["parameter"].as_str().unwrap()).collect();
    assert_eq!(names, ["frame-anchor[1].x", "frame-anchor[2].x", "frame-anchor[2].y", "frame-anchor[2].z"]);
    for profile in profiles {
        let number = |value: &serde_json::Value| value.as_f64().unwrap();
        let half = 0.5 * (number(&profile["interval"][1]) - number(&profile["interval"][0]));
        // anchors of cables metres long that are known to centimetres are nearly a linear problem
        assert!((half / (1.96 * number(&profile["sigma"])) - 1.0).abs() < 0.02, "{profile}");
        let points = profile["points"].as_array().unwrap();
        assert!(points.iter().all(|point| number(&point["held"]) >= number(&point["refitted"]) - 1e-6), "{profile}");
    }
    let bootstrap = &answer["bootstrap"];
    assert_eq!((bootstrap["replicates"].as_u64(), bootstrap["parameters"].as_array().unwrap().len()), (Some(100), 24));
    let warned = answer["warnings"].as_array().unwrap().contains(&bootstrap["warning"]);
    assert_eq!(warned, !bootstrap["warning"].is_null());
    for name in ["profiles.csv", "profiles.svg", "bootstrap.csv", "pose-bands.csv"] {
        assert!(folder.path().join("out").join(name).is_file(), "{name}");
    }
    let again = cdpr_in(folder.path(), &format!("{identify} {arguments} --threads 1 --format json")).json();
    assert_eq!(again["bootstrap"], *bootstrap);
    let text = cdpr_in(folder.path(), &format!("{identify} {arguments} --report page.html")).stdout;
    let page = std::fs::read_to_string(folder.path().join("page.html")).unwrap();
    assert_eq!(page.matches("end of the 95 % interval: ").count(), 8, "two ends of four profiles");
    assert_eq!(page.matches(", bootstrap: ").count(), 24, "a dot for every parameter");
    assert!(text.contains("by profile, from") && text.contains("bootstrap / linear"), "{text}");
    let unknown = cdpr_in(folder.path(), &format!("{identify} --profile compliance"));
    assert_eq!(unknown.exit_code, 2);
    assert!(unknown.stderr.contains("`compliance` is no free parameter of this fit"), "{}", unknown.stderr);
    assert_eq!(cdpr_in(folder.path(), &format!("{identify} --bootstrap 50 --split blocks:3")).exit_code, 2);
}

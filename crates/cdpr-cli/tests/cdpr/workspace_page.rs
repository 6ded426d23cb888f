//! `cdpr workspace --page`: the file that it writes, and results laid over others.

use serde_json::Value;

use super::cdpr_in;

const ASKED: &str = "workspace planar-example --method hull --rays 90 --max 8000";

/// What the program of a page reads.
fn block(page: &str) -> Value {
    let (_, rest) = page.split_once("id=\"cdpr-data\">").unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

#[test]
fn the_page_shows_the_area_that_the_answer_gives_and_an_earlier_one_beside_it() {
    let folder = tempfile::tempdir().unwrap();
    let earlier = cdpr_in(folder.path(), &format!("{ASKED} --min 500 --page wide.html"));
    assert_eq!(earlier.exit_code, 0, "{}", earlier.stderr);
    let run = cdpr_in(folder.path(), &format!("{ASKED} --min 1000 --page both.html --overlay wide.html --format json"));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let page = std::fs::read_to_string(folder.path().join("both.html")).unwrap();
    let data = block(&page);
    let area = run.json()["area_m2"].as_f64().unwrap();
    let regions = data["regions"].as_array().unwrap();
    assert_eq!(regions.len(), 2);
    // six digits are written
    assert!((regions[0]["measure"].as_f64().unwrap() / area - 1.0).abs() < 1e-5);
    assert_eq!(regions[0]["outlines_m"][0].as_array().unwrap().len(), 90);
    assert_eq!(regions[0]["name"], "wrench-feasible, 1000 N to 8000 N, hull");
    assert_eq!(regions[1]["name"], "wrench-feasible, 500 N to 8000 N, hull");
    let margins = data["grid"]["margin"].as_array().unwrap();
    let held = margins.iter().filter(|margin| margin.as_f64().is_some_and(|margin| margin >= 0.0)).count();
    assert!(held > 0 && held < margins.len(), "the grid reaches beyond the area: {held} of {}", margins.len());
    assert!(page.contains("--page both.html"), "the command can be repeated");
}

#[test]
fn the_same_command_writes_the_same_page() {
    let folder = tempfile::tempdir().unwrap();
    let written = || {
        let run = cdpr_in(folder.path(), &format!("{ASKED} --page page.html"));
        assert_eq!(run.exit_code, 0, "{}", run.stderr);
        std::fs::read(folder.path().join("page.html")).unwrap()
    };
    assert!(written() == written());
}

#[test]
fn a_page_without_a_hull_still_tells_the_size() {
    let folder = tempfile::tempdir().unwrap();
    let run = cdpr_in(folder.path(), "workspace planar-example --step 0.5 --page page.html --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let data = block(&std::fs::read_to_string(folder.path().join("page.html")).unwrap());
    let area = run.json()["area_m2"].as_f64().unwrap();
    assert!((data["regions"][0]["measure"].as_f64().unwrap() / area - 1.0).abs() < 1e-5);
    assert_eq!(data["regions"][0]["unit"], "m²");
}

/// Where rays enter the workspace again there is no area to head the page with, least of all that of an earlier page.
#[test]
fn an_earlier_result_never_stands_for_one_that_was_not_found() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(cdpr_in(folder.path(), &format!("{ASKED} --min 1000 --page wide.html")).exit_code, 0);
    let asked = "workspace planar-example --method hull --min 2000 --max 8000 --page page.html --overlay wide.html";
    let run = cdpr_in(folder.path(), &format!("{asked} --format json"));
    assert_eq!((run.exit_code, run.json()["status"].as_str()), (1, Some("not-star-shaped")));
    let page = std::fs::read_to_string(folder.path().join("page.html")).unwrap();
    assert!(!page.contains("class=\"line\">"), "no size heads the page");
    assert!(page.contains("enter the workspace again"), "the reason is told");
    assert_eq!(block(&page)["regions"].as_array().unwrap().len(), 1);
}

#[test]
fn what_cannot_be_laid_over_is_refused_before_anything_is_computed_and_no_page_is_left() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("report.html"), "<p>nothing of use</p>").unwrap();
    for (options, code, exit_code) in [
        ("--overlay report.html", "workspace::overlay", 2),
        ("--page page.html --overlay report.html", "workspace::overlay", 2),
        ("--page page.html --overlay missing.html", "io::read", 4),
        ("--page missing/page.html", "io::write", 4),
    ] {
        let run = cdpr_in(folder.path(), &format!("workspace planar-example --step 1 {options} --format json"));
        assert_eq!((run.exit_code, run.json()["code"].as_str()), (exit_code, Some(code)), "{}", run.stdout);
        assert!(!folder.path().join("page.html").exists());
    }
}

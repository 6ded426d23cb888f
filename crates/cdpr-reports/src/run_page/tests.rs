//! Pages of runs: well formed, complete and silent towards the network.

use cdpr_model::robot::Robot;
use cdpr_plant as plant;

use super::RunPage;
use crate::answers::RunAnswer;
use crate::recording::{Moment, Occurrence, Recording, Violation};

fn recording(robot: &Robot, count: u32) -> Recording<'_> {
    let moment = |k: u32| Moment {
        time: 0.01 * f64::from(k),
        pose: robot.home.unwrap(),
        tensions: (0..robot.cables.len()).map(|cable| 100.0 * (k as usize + cable) as f64).collect(),
    };
    let event = Occurrence { time: 0.5, words: "a wrench <b> acts".to_owned(), cable: None, breaks: false };
    let limits = vec![(50.0, 1e5); robot.cables.len()];
    Recording { robot, moments: (0..count).map(moment).collect(), events: vec![event], limits }
}

/// The first cable starts without tension.
fn slack(robot: &Robot, (limit, bound): (Option<&'static str>, f64)) -> Vec<Violation> {
    let found = plant::Violation { cable: 0, limit, bound, from: 0.0, to: 0.0, duration: 0.001, worst: 0.0 };
    Violation::all(&[found], robot)
}

fn page(recording: &Recording<'_>, violations: &[Violation], status: &'static str) -> String {
    let answer =
        RunAnswer { status, tension_max: 20_000.0, warnings: vec!["a `warning`".to_owned()], ..RunAnswer::default() };
    let facts = [("Machine", "elastic".to_owned())];
    let page = RunPage {
        recording,
        violations,
        answer: &answer,
        name: "scenario",
        facts: &facts,
        command: "cdpr run scenario.toml --out run",
        version: "0",
    };
    page.render().unwrap()
}

#[test]
fn the_page_is_well_formed_asks_nothing_of_the_network_and_tells_what_is_broken() {
    for name in ["cablerobot-simulator-helicopter", "planar-example"] {
        let robot = Robot::builtin(name).unwrap();
        let text = page(&recording(&robot, 200), &slack(&robot, (Some("tension_min_N"), 50.0)), "completed");
        for found in ["src=\"http", "href=\"http", "<b>"] {
            assert!(!text.contains(found), "{name}: {found}");
        }
        assert!(text.contains("class=\"verdict bad\"") && text.contains("limits are broken"), "{name}");
        assert!(text.contains("slack, below its 50 N") && !text.contains("stay within their limits"), "{name}");
        assert!(text.contains("data-time="), "{name}: figures follow the clock");
        let data = text.split("id=\"cdpr-data\"").nth(1).unwrap();
        let json = data.split_once('>').unwrap().1.split_once("</script>").unwrap().0;
        let data: serde_json::Value = serde_json::from_str(json).unwrap();
        assert_eq!(data["moments"]["time_s"].as_array().unwrap().len(), 200, "{name}");
        assert_eq!(data["robot"]["plane"].is_null(), name != "planar-example");
    }
}

/// A run of an hour must not make a page of gigabytes.
#[test]
fn long_runs_are_thinned_out_and_keep_their_end() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter").unwrap();
    let text = page(&recording(&robot, 60_000), &[], "failed");
    assert!(text.len() < 4_000_000, "{}", text.len());
    assert!(text.contains("599.99") && text.contains("class=\"verdict bad\""));
}

/// A slack cable breaks no limit where none is stated: a warning, and no red mark.
#[test]
fn a_slack_cable_alone_breaks_nothing() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter").unwrap();
    let text = page(&recording(&robot, 200), &slack(&robot, (None, 0.0)), "completed");
    assert!(text.contains("class=\"verdict warned\"") && text.contains("stay within their limits"));
    assert!(text.contains("\"broken_limits\":[]"));
}

//! Pages of the repository's studies and of ones made up here: well-formed, self-contained, and telling what the library
//! computes.

use std::path::Path;

use cdpr_model::geometry::Pose;
use cdpr_model::robot::Robot;
use cdpr_study::field::{Sample, field};
use cdpr_study::{Robots, Study};
use cdpr_workspace::Criterion;
use serde_json::Value as Json;

use super::*;
use crate::answers::StudyAnswer;
use crate::html_page::reading::{assert_stands_alone, data, markup};

/// A study of this repository.
fn experiment(name: &str) -> Experiment {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies").join(name);
    let study = Study::from_toml_bytes(&std::fs::read(&path).unwrap(), name).unwrap();
    let robot = |named: &str| match path.with_file_name(named) {
        file if named.contains('.') => Robot::from_toml_bytes(&std::fs::read(file).unwrap(), named).unwrap(),
        _ => Robot::builtin(named).unwrap(),
    };
    let robots = Robots::of(&study, |named| Ok::<_, std::convert::Infallible>(robot(named))).unwrap();
    Experiment::new(study, robots).unwrap()
}

fn found(experiment: &Experiment) -> Field {
    let commands = experiment.poses(Vec::new(), 0).unwrap();
    let poses: Vec<Pose> = commands.iter().map(|command| command.pose).collect();
    field(&experiment.driving().unwrap(), &poses)
}

fn page(experiment: &Experiment, found: &Field) -> String {
    let warnings = ["a `key` without effect".to_owned()];
    let command = "cdpr study study.toml --out result";
    let answer = StudyAnswer::new(experiment, found, 3, Vec::new());
    let page = StudyPage {
        experiment,
        answer: &answer,
        name: "a <study>",
        found,
        warnings: &warnings,
        command,
        seed: 3,
        version: "0.1.0",
    };
    render(&page).unwrap()
}

fn numbers(value: &Json) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

/// True where every number is the other one to so many digits.
fn agree(shown: &[f64], computed: &[f64], count: i32) -> bool {
    let close = |(a, b): (&f64, &f64)| (a - b).abs() <= 0.51 * 10_f64.powi(1 - count) * b.abs();
    shown.len() == computed.len() && shown.iter().zip(computed).all(close)
}

#[test]
fn the_page_is_well_formed_and_asks_nothing_of_the_network() {
    for name in ["planar-wide-grid.toml", "twin-nominal.toml"] {
        let experiment = experiment(name);
        let page = page(&experiment, &found(&experiment));
        assert_stands_alone(&page);
        let markup = markup(&page);
        assert!(!markup.contains("<study>") && markup.contains("a &lt;study&gt;"), "names stay text");
    }
}

/// Every pose of the page has the error, the linear step and the tensions that the library gives, to the six digits written.
#[test]
fn the_poses_of_the_page_hold_what_the_library_computes() {
    for name in ["planar-low-grid.toml", "twin-nominal.toml"] {
        let experiment = experiment(name);
        let found = found(&experiment);
        let data = data(&page(&experiment, &found));
        let robot = experiment.machine.robot();
        let axes = data["robot"]["axes"].as_array().unwrap().len();
        assert_eq!(data["samples"]["number"].as_array().unwrap().len(), found.samples.len());
        for (index, sample) in found.samples.iter().enumerate() {
            let of = |key: &str| numbers(&data["samples"][key][index]);
            let shift = |twist: &cdpr_model::geometry::Twist| twist.as_slice()[..axes].to_vec();
            assert!(agree(&of("error_m"), &shift(&sample.exact.unwrap()), 6));
            assert!(agree(&of("linear_m"), &shift(&sample.linear.unwrap()), 6));
            assert!(agree(&of("tensions_N"), sample.outcome.tensions.as_ref().unwrap(), 6));
            let commanded = robot.motion_pattern.pose_to_components(robot.plane, &sample.commanded);
            assert!(agree(&of("commanded"), &commanded, 7));
            if robot.motion_pattern.has_rotation() {
                assert!(agree(&of("error_rad"), &sample.exact.unwrap().as_slice()[3..], 6));
            }
        }
        let mean = data["result"]["position_error_m"]["mean"].as_f64().unwrap();
        assert!((mean - found.summary.position_error_m.mean).abs() < 1e-15);
    }
}

/// Contours run through values of the library: every 41st node of both regions is asked again.
#[test]
fn the_regions_of_the_page_hold_what_the_library_computes() {
    let experiment = experiment("planar-wide-grid.toml");
    let data = data(&page(&experiment, &found(&experiment)));
    let driving = experiment.driving().unwrap();
    let physical = experiment.feasible(&experiment.machine).unwrap();
    let regions = data["regions"].as_array().unwrap();
    assert_eq!(regions.len(), 2);
    let (mut inside, mut outside) = (0, 0);
    for region in regions {
        let axis = |k: usize, index: u64| {
            let nodes = &region["axes"][k];
            nodes["start_m"].as_f64().unwrap() + index as f64 * nodes["step_m"].as_f64().unwrap()
        };
        let columns = region["axes"][0]["count"].as_u64().unwrap();
        let count = region["error_m"].as_array().unwrap().len() as u64;
        assert_eq!(count, columns * region["axes"][1]["count"].as_u64().unwrap());
        for node in (0..count).step_by(41) {
            let mut pose = Pose::identity();
            (pose.position.x, pose.position.y) = (axis(0, node % columns), axis(1, node / columns));
            let Sample { exact, .. } = field(&driving, &[pose]).samples[0];
            let shown = &region["error_m"][node as usize];
            match exact {
                Some(error) => assert!(agree(&numbers(shown), &error.as_slice()[..2], 6), "node {node}: {shown}"),
                None => assert!(shown.is_null(), "node {node}: {shown}"),
            }
            let is_held = region["physical"][node as usize].as_f64().is_some_and(|margin| margin >= 0.0);
            assert_eq!(is_held, physical.judge(&pose).holds(), "node {node}");
            *(if is_held { &mut inside } else { &mut outside }) += 1;
        }
    }
    assert!(inside > 20 && outside > 5, "both kinds were seen: {inside}, {outside}");
}

#[test]
fn a_study_of_one_pose_has_a_page_and_its_region_is_the_whole_workspace() {
    let mut experiment = experiment("planar-wide-grid.toml");
    let grid = experiment.study.poses.as_mut().unwrap().grid.as_mut().unwrap();
    grid.count = vec![1, 1];
    let data = data(&page(&experiment, &found(&experiment)));
    assert_eq!(data["samples"]["total"], 1);
    assert_eq!(data["regions"].as_array().unwrap().len(), 1);
}

/// Slices lie at the three heights of the grid; every 37th node of each is asked again, in the orientation of all poses.
#[test]
fn the_slices_of_a_spatial_study_hold_what_the_library_computes() {
    let experiment = experiment("twin-nominal.toml");
    let data = data(&page(&experiment, &found(&experiment)));
    let regions = data["regions"].as_array().unwrap();
    let heights: Vec<f64> = regions.iter().map(|region| region["level_m"].as_f64().unwrap()).collect();
    assert_eq!(heights, [1.25, 1.625, 2.0]);
    let driving = experiment.driving().unwrap();
    for (region, height) in regions.iter().zip(heights) {
        assert_eq!(region["plane"], serde_json::json!([0, 1]));
        let axis = |k: usize| &region["axes"][k];
        let columns = axis(0)["count"].as_u64().unwrap();
        let place = |k: usize, index: u64| {
            axis(k)["start_m"].as_f64().unwrap() + index as f64 * axis(k)["step_m"].as_f64().unwrap()
        };
        let errors = region["error_m"].as_array().unwrap();
        assert!(errors.len() > 400, "{}", errors.len());
        for node in (0..errors.len() as u64).step_by(37) {
            let mut pose = Pose::identity();
            pose.position = [place(0, node % columns), place(1, node / columns), height].into();
            let error = field(&driving, &[pose]).samples[0].exact.unwrap();
            assert!(agree(&numbers(&errors[node as usize]), &error.as_slice()[..3], 6), "node {node} at {height} m");
        }
    }
}

#[test]
fn poses_on_a_line_have_no_slice_and_those_in_an_upright_plane_an_upright_one() {
    let mut experiment = experiment("twin-nominal.toml");
    let mut planes = |count: [usize; 6]| {
        experiment.study.poses.as_mut().unwrap().grid.as_mut().unwrap().count = count.to_vec();
        let data = data(&page(&experiment, &found(&experiment)));
        let regions = data["regions"].as_array().unwrap();
        regions.iter().map(|region| (region["plane"].clone(), region["level_m"].as_f64())).collect::<Vec<_>>()
    };
    assert!(planes([5, 1, 1, 1, 1, 1]).is_empty());
    assert_eq!(planes([3, 1, 3, 1, 1, 1]), [(serde_json::json!([0, 2]), Some(0.0))]);
    assert_eq!(planes([1, 3, 3, 1, 1, 1]), [(serde_json::json!([1, 2]), Some(0.0))]);
    // more heights than slices
    assert_eq!(planes([2, 2, 9, 1, 1, 1]).len(), 5);
}

//! The page on simulated data: well-formed, self-contained, escaped, and telling the numbers of the selection.

use std::sync::LazyLock;

use cdpr_calibration::candidate::parse_list;
use cdpr_calibration::selection::{Selection, SelectionCriterion, Settings, Warnings, select};
use cdpr_model::geometry::{MotionPattern, Plane, Pose};
use cdpr_model::measurement::{Fold, Samples};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::{Cable, Groove, Platform, Robot};
use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, Normal};

use super::*;
use crate::answers::{Answer, SelectionAnswer};
use crate::html_page::reading::{data, markup, parsed};

/// A box of 8 × 6 × 4 m with the cables at its corners.
fn spatial_robot(name: &str) -> Robot {
    let corner = |index: usize, size: [f64; 3]| {
        let sign = |bit: usize| if index >> bit & 1 == 1 { 0.5 } else { -0.5 };
        Vector3::new(sign(0) * size[0], sign(1) * size[1], sign(2) * size[2])
    };
    let cable = |index: usize| Cable {
        name: (index + 1).to_string(),
        frame_anchor: corner(index, [8.0, 6.0, 4.0]),
        // low corners pull at the top and the other way round, which keeps the platform level
        platform_anchor: corner(index ^ 0b100, [0.6, 0.5, 0.4]),
        ..Cable::default()
    };
    robot(name, MotionPattern::Spatial, (0..8).map(cable).collect())
}

/// A point held by four cables in the xz plane.
fn planar_robot() -> Robot {
    let cable = |(index, at): (usize, [f64; 2])| Cable {
        name: format!("winch-{}", index + 1),
        frame_anchor: Vector3::new(at[0], 0.0, at[1]),
        ..Cable::default()
    };
    let corners = [[-1.0, 0.0], [1.0, 0.0], [1.0, 1.5], [-1.0, 1.5]];
    let mut robot = robot("plate", MotionPattern::PlanarPoint, corners.into_iter().enumerate().map(cable).collect());
    robot.plane = Plane::from_axes("xz").unwrap();
    robot
}

fn robot(name: &str, motion_pattern: MotionPattern, cables: Vec<Cable>) -> Robot {
    Robot {
        name: name.to_owned(),
        title: None,
        motion_pattern,
        kind: None,
        plane: Plane::default(),
        gravity: None,
        notes: vec![],
        assumptions: vec![],
        source: None,
        platform: Platform::default(),
        home: None,
        external_wrench: None,
        travel: None,
        cables,
        reference_checks: vec![],
        calibration: None,
        tracked: None,
        obstacles: vec![],
    }
}

/// Noisy measurements (1 mm) of the robot with offsets of up to 40 mm along a curve through its workspace.
fn measured(robot: &Robot, count: usize) -> Samples {
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    let mut machine = robot.clone();
    for cable in &mut machine.cables {
        cable.length_offset = Some(rng.random_range(-0.04..0.04));
    }
    let model = Model::new(machine, Composition::STANDARD).unwrap();
    let noise = Normal::new(0.0, 1e-3).unwrap();
    let mut samples = Samples { cable_count: robot.cable_count(), ..Samples::default() };
    samples.sigmas = SensorSigmas { length: Some(1e-3), ..SensorSigmas::default() };
    for index in 0..count {
        let t = 6.3 * index as f64 / count as f64;
        let pose = pose_at(robot, t);
        for (cable, length) in model.cable_lengths(&pose).unwrap().into_iter().enumerate() {
            samples.lengths.push(model.recorded_length(cable, length) + noise.sample(&mut rng));
        }
        samples.poses.push(pose);
    }
    samples
}

fn pose_at(robot: &Robot, t: f64) -> Pose {
    if robot.motion_pattern.is_planar() {
        return Pose {
            position: Vector3::new(0.6 * (3.0 * t).sin(), 0.0, 0.7 + 0.4 * (4.0 * t).cos()),
            ..Pose::identity()
        };
    }
    let position = Vector3::new(2.0 * (3.0 * t).sin(), 1.6 * (4.0 * t).cos(), 0.9 * (5.0 * t).sin());
    Pose::from_xyz_angles(position, [0.1 * t.sin(), 0.1 * (2.0 * t).cos(), 0.15 * (3.0 * t).sin()])
}

fn fifths(count: usize) -> Vec<Fold> {
    let fold = |k: usize| {
        let (validation, train) = (0..count).partition(|index| index * 5 / count == k);
        Fold { name: format!("block {} of 5", k + 1), train, validation }
    };
    (0..5).map(fold).collect()
}

fn selected(robot: &Robot, samples: &Samples, candidates: &str, requirements: &[&str]) -> Selection {
    let settings = Settings {
        requirements: requirements.iter().map(|text| text.parse().unwrap()).collect(),
        seed: 1,
        ..Settings::default()
    };
    select(
        robot,
        &parse_list(candidates).unwrap(),
        samples,
        &fifths(samples.len()),
        &settings,
        &cdpr_calibration::unobserved,
    )
    .unwrap()
}

fn page(robot: &Robot, samples: &Samples, selection: &Selection) -> String {
    render(&report(robot, samples, selection, &fifths(samples.len()))).unwrap()
}

fn report<'a>(robot: &'a Robot, samples: &'a Samples, selection: &'a Selection, folds: &'a [Fold]) -> Report<'a> {
    static WARNINGS: LazyLock<Warnings> =
        LazyLock::new(|| Warnings { remarks: vec!["column `remark` was ignored".to_owned()], doubts: Vec::new() });
    Report {
        purpose: Purpose::Selection,
        command: "cdpr select robot.toml data.csv --split blocks --require 'position_mean_m=0.005'",
        robot,
        samples,
        data_count: samples.len(),
        folds,
        is_held_out: true,
        data_name: "data.csv",
        validation_name: "five contiguous blocks that take turns",
        selection,
        criterion: SelectionCriterion::Position,
        seed: 1,
        version: "0.1.0",
        warnings: &WARNINGS,
        additions: &[],
    }
}

const LADDER: &str = "standard;standard:length-offset;standard:length-offset,length-scale;standard:frame-anchor;\
                      standard:frame-anchor,length-offset,length-scale;pulley";

fn has_text(document: &roxmltree::Document<'_>, wanted: &str) -> bool {
    let texts: Vec<&str> =
        document.descendants().filter(|node| node.is_text()).filter_map(|node| node.text()).collect();
    texts.concat().contains(wanted)
}

#[test]
fn the_page_is_well_formed_and_tells_the_numbers_of_the_selection() {
    let robot = spatial_robot("box");
    let samples = measured(&robot, 150);
    let selection = selected(&robot, &samples, LADDER, &["position_mean_m=0.005", "position_max_m=1e-6"]);
    assert_eq!(selection.recommended, None, "nobody is that good");
    let selection = Selection { recommended: Some(1), ..selection };
    let text = page(&robot, &samples, &selection);
    keep("report-spatial.html", &text);
    let text = markup(&text);
    let document = parsed(&text);
    let judgement = selection.candidates[1].outcome.as_ref().unwrap();
    let value = SelectionCriterion::Position.format_with_error(judgement.criterion, judgement.standard_error);
    for wanted in ["standard:length-offset", &value, "length-offset[8]", "not identified: ", "3R3T", "block 5 of 5"] {
        assert!(has_text(&document, wanted), "{wanted}");
    }
    assert_eq!(text, markup(&page(&robot, &samples, &selection)), "the same input gives the same page");
}

#[test]
fn nothing_on_the_page_comes_from_the_network_and_every_link_has_its_target() {
    let robot = spatial_robot("box");
    let samples = measured(&robot, 60);
    let text = page(&robot, &samples, &selected(&robot, &samples, LADDER, &[]));
    let text = markup(&text);
    let document = parsed(&text);
    let ids: Vec<&str> = document.descendants().filter_map(|node| node.attribute("id")).collect();
    for node in document.descendants() {
        assert!(!matches!(node.tag_name().name(), "link" | "img" | "iframe"));
        assert_eq!(node.attribute("src"), None);
        if let Some(target) = node.attribute("href") {
            assert!(target.strip_prefix('#').is_some_and(|id| ids.contains(&id)), "{target}");
        }
    }
    let mut unique = ids.clone();
    unique.sort_unstable();
    unique.dedup();
    assert_eq!(unique.len(), ids.len(), "ids are unique");
}

/// On clean data, on data with rows that are wrong, and where two cables are swapped, which nobody may trust.
#[test]
fn text_json_and_page_tell_the_same_warnings_and_the_verdict_has_their_colour() {
    let robot = spatial_robot("box");
    let clean = measured(&robot, 100);
    let mut dirty = clean.clone();
    [17, 60].into_iter().for_each(|row: usize| dirty.poses[row].position.x += 0.3);
    let mut swapped = clean.clone();
    swapped.sigmas.position = Some(1e-3);
    swapped.lengths.chunks_mut(8).for_each(|lengths| lengths.swap(2, 4));
    for (samples, class, first) in
        [(clean, "good", "column"), (dirty, "warned", "outliers: 2 of"), (swapped, "bad", "the cables look permuted")]
    {
        let selection = selected(&robot, &samples, "standard;standard:length-offset", &[]);
        let folds = fifths(samples.len());
        let report = report(&robot, &samples, &selection, &folds);
        let answer = SelectionAnswer::new(&report);
        assert!(answer.warnings.list()[0].starts_with(first), "{:?}", answer.warnings);
        let text = answer.words(None);
        let html = markup(&render(&report).unwrap());
        let document = parsed(&html);
        let list = document.descendants().find(|node| node.attribute("id") == Some("warnings")).unwrap();
        let words = |node: roxmltree::Node<'_, '_>| -> String {
            node.descendants().filter(|node| node.is_text()).filter_map(|node| node.text()).collect()
        };
        let told: Vec<String> = list.descendants().filter(|node| node.has_tag_name("li")).map(words).collect();
        let expected: Vec<String> = answer.warnings.list().iter().map(|warning| warning.replace('`', "")).collect();
        assert_eq!(told, expected);
        assert!(answer.warnings.list().iter().all(|warning| text.matches(warning).count() == 1), "{text}");
        assert!(html.contains(&format!("class=\"verdict {class}\"")), "{class}");
        let status = match class {
            "good" => "recommended",
            "warned" => "recommended-with-caution",
            _ => "not-trusted",
        };
        let is_no = class == "bad";
        assert_eq!((answer.status, answer.trusted, answer.is_negative()), (status, !is_no, is_no));
    }
}

/// A verdict is green where nothing speaks against it, and only there.
#[test]
fn the_verdict_is_good_without_any_warning() {
    let robot = spatial_robot("box");
    let samples = measured(&robot, 100);
    let selection = selected(&robot, &samples, "standard;standard:length-offset", &[]);
    let folds = fifths(samples.len());
    let report = Report { warnings: &Warnings::default(), ..report(&robot, &samples, &selection, &folds) };
    assert_eq!(SelectionAnswer::new(&report).warnings.list(), Vec::<String>::new());
    let html = render(&report).unwrap();
    assert!(html.contains("class=\"verdict good\"") && !html.contains("id=\"warnings\""));
}

/// A drum stands where the file says, as long as its groove, and the cable leaves it on a tangent: r² + s² is the square of the way to the axis.
#[test]
fn drums_are_drawn_where_the_file_states_their_place() {
    let mut robot = spatial_robot("box");
    let anchor = robot.cables[2].frame_anchor;
    let winch = &mut robot.cables[2].winch;
    (winch.radius, winch.axis) = (Some(0.1), Some(Vector3::x().into()));
    winch.position = Some(anchor + Vector3::new(0.0, 0.3, -2.0));
    winch.groove = Some(Groove { pitch: 0.01, ends: None });
    let samples = measured(&robot, 60);
    let selection = selected(&robot, &samples, "standard;standard:length-offset", &[]);
    let data = data(&page(&robot, &samples, &selection));
    let cables = data["robot"]["cables"].as_array().unwrap();
    assert!((0..8).all(|cable| cables[cable]["drum"].is_null() == (cable != 2)));
    let drum = &cables[2]["drum"];
    let point = |value: &serde_json::Value| Vector3::from_fn(|k, _| value[k].as_f64().unwrap());
    let (from, to) = (point(&drum["from_m"]), point(&drum["to_m"]));
    assert!((from - robot.cables[2].winch.position.unwrap()).norm() < 1e-6);
    assert!((to - from).normalize().dot(&Vector3::x()) > 1.0 - 1e-9 && drum["radius_m"] == 0.1);
    let [contact, pulley] = [0, 1].map(|end| point(&drum["way_m"][end]));
    assert!((pulley - robot.cables[2].frame_anchor).norm() < 1e-6);
    let across = |way: Vector3<f64>| Vector3::new(0.0, way.y, way.z).norm();
    assert!((across(contact - from) - 0.1).abs() < 1e-5);
    assert!((0.01 + across(pulley - contact).powi(2) - across(pulley - from).powi(2)).abs() < 1e-4);
}

#[test]
fn hostile_names_stay_text() {
    let name = "<script>alert('1')</script>\"&\u{0}{{ 7*7 }}";
    let mut robot = spatial_robot(name);
    robot.title = Some("</title><b onload=x>".to_owned());
    robot.cables[2].name = "</svg><script>".to_owned();
    let samples = measured(&robot, 40);
    let selection = selected(&robot, &samples, "standard;standard:length-offset", &[]);
    let selection = Selection { reason: "`<i>` & `".to_owned(), ..selection };
    let text = page(&robot, &samples, &selection);
    let text = markup(&text);
    let document = parsed(&text);
    let scripts = document.descendants().filter(|node| node.tag_name().name() == "script").count();
    assert_eq!(scripts, 1, "the data block is the only one besides the program");
    assert!(document.descendants().all(|node| !node.has_attribute("onload")));
    let cables = &data(&page(&robot, &samples, &selection))["robot"]["cables"];
    assert_eq!(cables[2]["name"], "</svg><script>");
    assert!(has_text(&document, "<script>alert('1')</script>\"&\u{fffd}{{ 7*7 }}"));
}

#[test]
fn a_page_without_any_recommendation_says_so_and_shows_the_best() {
    let robot = planar_robot();
    let samples = measured(&robot, 700);
    let selection = selected(&robot, &samples, "standard;standard:length-offset", &["position_max_m=1e-9"]);
    let text = page(&robot, &samples, &selection);
    keep("report-planar.html", &text);
    let text = markup(&text);
    let document = parsed(&text);
    assert!(has_text(&document, "No candidate recommended"));
    assert!(has_text(&document, "✗ broken: largest position error (position_max_m)"));
    for column in ["rotation, °", "rotation mean, °"] {
        assert!(!has_text(&document, column), "a point does not turn");
    }
}

#[test]
fn a_single_candidate_without_validation_data_is_reported_by_its_fit() {
    let robot = spatial_robot("box");
    let samples = measured(&robot, 30);
    let mut selection = selected(&robot, &samples, "standard:frame-anchor,platform-anchor", &[]);
    if let Ok(judgement) = &mut selection.candidates[0].outcome {
        judgement.validation_errors = Default::default();
        judgement.validation = judgement.validation_errors.blocks();
        judgement.validation_samples.clear();
        (judgement.criterion, judgement.standard_error) = (f64::NAN, f64::NAN);
        judgement.fit.analysis.condition = f64::INFINITY;
    }
    let text = page(&robot, &samples, &selection);
    keep("report-identify.html", &text);
    let text = markup(&text);
    let document = parsed(&text);
    assert!(has_text(&document, "Identified control model"));
    assert!(has_text(&document, "Data of the fit: mean position error"));
    assert!(has_text(&document, "∞") && !text.contains("NaN") && !text.contains(">inf"));
}

/// The block holds the numbers of the selection, row by row in the order of the data.
#[test]
fn the_data_of_the_page_are_those_of_the_selection() {
    let robot = planar_robot();
    let samples = measured(&robot, 50);
    let selection = selected(&robot, &samples, "standard;standard:length-offset", &[]);
    let data = data(&page(&robot, &samples, &selection));
    let shown = selection.recommended.unwrap();
    assert_eq!((&data["shown"], &data["given"]), (&shown.into(), &0.into()));
    let judgement = selection.candidates[shown].outcome.as_ref().unwrap();
    let own = &data["result"]["candidates"][shown];
    assert_eq!(own["validation"]["position_error_m"]["mean"], judgement.validation.position_error_m.mean);
    assert_eq!(own["parameters"][3]["value"], judgement.fit.parameters[3].value);
    assert!(own["parameters"][3]["nominal"].is_null(), "the robot states no length offset");
    let told = &data["samples"];
    assert_eq!(told["number"].as_array().unwrap().len(), 50);
    assert_eq!(told["number"][7], 8);
    let row = judgement.validation_samples.iter().position(|&sample| sample == 7).unwrap();
    let residual = told["calibrated"]["length_error_m"][7][2].as_f64().unwrap();
    let expected = judgement.validation_errors.length[row * 4 + 2];
    assert!((residual - expected).abs() <= 6e-4 * expected.abs(), "rounded to four digits: {residual} {expected}");
    assert!(told["length_change_m"][0].is_null() && told["length_change_m"][1][0].is_number());
    assert!(told["calibrated"]["tension_error_N"].is_null(), "a rigid model knows no tensions");
    assert_eq!(data["robot"]["axes"], serde_json::json!(["x", "z"]));
    assert_eq!(data["correlation"][3], serde_json::json!([0.0, 0.0, 0.0, 1.0]), "one offset for each cable");
}

/// Long trajectories are thinned out: the file stays small enough to send. Sixty times the same samples stand for one.
#[test]
fn many_samples_do_not_make_a_large_file() {
    let robot = spatial_robot("box");
    let samples = measured(&robot, 100);
    let mut selection = selected(&robot, &samples, "standard:length-offset", &[]);
    let repeated: Vec<usize> = (0..6000).map(|index| index % 100).collect();
    if let Ok(judgement) = &mut selection.candidates[0].outcome {
        let once = judgement.validation_errors.clone();
        (1..60).for_each(|_| judgement.validation_errors.extend(&once));
        judgement.validation = judgement.validation_errors.blocks();
        judgement.validation_samples = (0..6000).collect();
    }
    let text = page(&robot, &samples.subset(&repeated), &selection);
    keep("report-long.html", &text);
    assert!(text.len() < 2_000_000, "{}", text.len());
    let samples = &data(&text)["samples"];
    let kept = samples["number"].as_array().unwrap().len();
    assert_eq!(samples["total"], 6000);
    assert!((1000..6000).contains(&kept), "{kept} samples are in the page");
    assert!(text.contains("The page holds a part of the samples"));
}

/// Keeps a page to look at, in the folder that the variable names.
fn keep(name: &str, page: &str) {
    if let Some(folder) = std::env::var_os("CDPR_KEEP_REPORTS") {
        std::fs::write(std::path::Path::new(&folder).join(name), page).unwrap();
    }
}

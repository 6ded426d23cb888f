//! Doubts that a robot file raises by itself: each mistake is named, and no robot of the collections is accused.

use std::path::{Path, PathBuf};

use cdpr_model::finding::{Finding, FindingKind};
use cdpr_model::robot::{Robot, builtin};

/// Robots of a folder; none where it is absent, which CI does not allow.
#[expect(clippy::print_stderr, reason = "a test that skips says so")]
fn robots_in(folder: &str) -> Vec<(PathBuf, Robot)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(folder);
    let Ok(entries) = std::fs::read_dir(&folder) else {
        assert!(std::env::var("CI").as_deref() != Ok("true"), "CI must have {}", folder.display());
        eprintln!("skipped: {} is not here", folder.display());
        return Vec::new();
    };
    let files = entries.map(|entry| entry.unwrap().path());
    let robots = files.filter_map(|path| {
        let is_robot = path.extension()? == "toml";
        let text = std::fs::read_to_string(&path).ok().filter(|text| is_robot && text.contains("motion_pattern"))?;
        let robot = Robot::from_toml(&text, &path.display().to_string()).unwrap_or_else(|error| panic!("{error}"));
        Some((path, robot))
    });
    robots.collect()
}

fn template(name: &str) -> Robot {
    let path = format!("../cdpr-cli/src/commands/new/templates/{name}-robot.toml");
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap();
    Robot::from_toml(&text, name).unwrap()
}

#[test]
fn no_robot_of_the_collections_is_accused() {
    let mut count = 0;
    for folder in ["studies/robots", "crates/cdpr-cli/src/commands/new/templates", "../shared/data/robots"] {
        for (path, robot) in robots_in(folder) {
            assert_eq!(robot.doubts(), [], "{}", path.display());
            count += 1;
        }
    }
    for name in builtin::names() {
        assert_eq!(Robot::builtin(name).unwrap().doubts(), [], "{name}");
        count += 1;
    }
    assert!(count > 30, "{count}");
}

/// A sound robot with one mistake, and the doubt that it raises: kind, cable from 1, and some of its words.
struct Mistaken {
    template: &'static str,
    mistake: fn(&mut Robot),
    kind: FindingKind,
    cable: Option<usize>,
    words: &'static str,
}

const fn mistaken(template: &'static str, mistake: fn(&mut Robot), kind: FindingKind, words: &'static str) -> Mistaken {
    Mistaken { template, mistake, kind, cable: None, words }
}

fn check(all: &[Mistaken]) {
    for one in all {
        let mut robot = template(one.template);
        (one.mistake)(&mut robot);
        let doubts = robot.doubts();
        let is_meant = |doubt: &&Finding| doubt.kind == one.kind && doubt.text.contains(one.words);
        let found = doubts.iter().find(is_meant).unwrap_or_else(|| panic!("{}: {doubts:?}", one.words));
        assert_eq!(found.cable, one.cable.map(|cable| cable - 1), "{}", found.text);
    }
}

fn each_anchor(robot: &mut Robot, change: impl Fn(&mut nalgebra::Vector3<f64>)) {
    robot.cables.iter_mut().for_each(|cable| change(&mut cable.frame_anchor));
}

#[test]
fn gravity_upside_down_is_asked_about() {
    let turn = |robot: &mut Robot| robot.gravity = robot.gravity.map(|gravity| -gravity);
    check(&[
        mistaken("suspended-camera", turn, FindingKind::Gravity, "points along +z"),
        mistaken("box", turn, FindingKind::Gravity, "points along +z"),
        mistaken("wall-plotter", turn, FindingKind::Gravity, "points along +"),
    ]);
    // a file whose z points downwards throughout is none
    let mut downwards = template("suspended-camera");
    turn(&mut downwards);
    each_anchor(&mut downwards, |a| a.z = -a.z);
    downwards.home = downwards.home.map(|mut home| {
        home.position.z = -home.position.z;
        home
    });
    assert_eq!(downwards.doubts(), []);
}

#[test]
fn anchors_below_a_platform_that_hangs_are_asked_about() {
    check(&[
        mistaken(
            "suspended-camera",
            |robot| each_anchor(robot, |a| a.z = 0.0),
            FindingKind::Anchor,
            "all frame anchors lie below",
        ),
        Mistaken {
            cable: Some(2),
            ..mistaken(
                "wall-plotter",
                |robot| robot.cables[1].frame_anchor.z = -1.0,
                FindingKind::Anchor,
                "below the platform at the home pose: 2 cables hold 2 degrees",
            )
        },
    ]);
}

#[test]
fn platform_anchors_in_the_world_are_asked_about() {
    let into_world = |robot: &mut Robot| {
        let home = robot.home_or_middle();
        robot
            .cables
            .iter_mut()
            .for_each(|cable| cable.platform_anchor = home.position + home.rotation * cable.platform_anchor);
    };
    check(&[
        mistaken("box", into_world, FindingKind::Frame, "are they stated in the world frame?"),
        mistaken("planar-frame", into_world, FindingKind::Frame, "are they stated in the world frame?"),
        mistaken("suspended-camera", into_world, FindingKind::Frame, "are they stated in the world frame?"),
    ]);
}

#[test]
fn an_anchor_beside_the_symmetry_of_the_others_is_asked_about() {
    check(&[
        Mistaken {
            cable: Some(3),
            ..mistaken(
                "suspended-camera",
                |robot| robot.cables[2].frame_anchor.z = 6.6,
                FindingKind::Anchor,
                "0.600 m beside (6.000, 4.000, 6.000) m",
            )
        },
        // three corners of a rectangle tell the fourth, but not which pair is right
        mistaken(
            "suspended-camera",
            |robot| robot.cables[2].frame_anchor.x = 6.6,
            FindingKind::Anchor,
            "or else that of cable 2 beside (6.600, -4.000, 6.000) m",
        ),
        Mistaken {
            cable: Some(6),
            ..mistaken(
                "box",
                |robot| robot.cables[5].frame_anchor.y += 0.3,
                FindingKind::Anchor,
                "frame anchor of cable 6",
            )
        },
        Mistaken {
            cable: Some(1),
            ..mistaken(
                "box",
                |robot| robot.cables[0].platform_anchor.x = -0.35,
                FindingKind::Anchor,
                "platform anchor of cable 1",
            )
        },
    ]);
    // what an axis of the file does not mirror is no symmetry
    let mut trapezoid = template("suspended-camera");
    for cable in [2, 3] {
        trapezoid.cables[cable].frame_anchor.x *= 0.7;
    }
    assert_eq!(trapezoid.doubts(), []);
}

#[test]
fn numbers_of_the_size_of_another_unit_are_asked_about() {
    let unit = FindingKind::Unit;
    check(&[
        mistaken("suspended-camera", |robot| each_anchor(robot, |a| *a *= 1e3), unit, "apart: are they millimetres?"),
        mistaken("wall-plotter", |robot| each_anchor(robot, |a| *a *= 300.0), unit, "are the anchors millimetres?"),
        mistaken(
            "box",
            |robot| robot.cables.iter_mut().for_each(|cable| cable.platform_anchor *= 1e3),
            unit,
            "from the platform's origin, in a frame of",
        ),
        mistaken(
            "suspended-camera",
            |robot| robot.home.iter_mut().for_each(|home| home.position *= 1e3),
            unit,
            "is it in millimetres? Its key ends in _m",
        ),
        mistaken(
            "suspended-camera",
            |robot| robot.travel.iter_mut().for_each(|travel| travel.max *= 1e3),
            unit,
            "the [workspace] box is",
        ),
        mistaken(
            "box",
            |robot| robot.gravity.iter_mut().for_each(|gravity| *gravity *= 1e3),
            unit,
            "millimetres per second squared",
        ),
        mistaken("box", |robot| robot.gravity.iter_mut().for_each(|gravity| *gravity /= 9.81), unit, "multiples of g"),
        mistaken("box", |robot| robot.platform.mass = Some(10_000.0), unit, "is mass_kg in grams"),
        mistaken("box", |robot| stiffen(robot, 1e6), unit, "modulus of elasticity in Pa"),
        mistaken("box", |robot| stiffen(robot, 1e-3), unit, "is axial_stiffness_EA_N in kilonewtons?"),
        mistaken("box", |robot| robot.cables[0].diameter = Some(2.0), unit, "diameter_m of 2 m"),
        mistaken(
            "suspended-camera",
            |robot| robot.cables[0].linear_density = Some(4.0),
            unit,
            "is the density in grams per metre?",
        ),
        mistaken("box", |robot| robot.cables[0].winch.radius = Some(40.0), unit, "drum_radius_m of 40 m"),
    ]);
}

fn stiffen(robot: &mut Robot, by: f64) {
    for cable in &mut robot.cables {
        let stiffness = by * cable.axial_stiffness().unwrap();
        cable.stiffness = Some(cdpr_model::robot::CableStiffness::Axial(stiffness));
    }
}

use std::path::Path;

use super::{Chain, ChainStep};
use crate::force_tracking::TrackingVerdict;
use crate::{Experiment, Robots, Study};
use cdpr_model::control::CommandedPose;
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::Robot;

const REGION: [[f64; 2]; 3] = [[-2.0, 2.0], [-2.0, 2.0], [0.75, 2.75]];

/// A study of the book.
pub(crate) fn experiment(name: &str) -> Experiment {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies");
    of_text(&std::fs::read_to_string(folder.join(format!("{name}.toml"))).unwrap())
}

/// A study beside those of the book.
fn of_text(text: &str) -> Experiment {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies");
    let study = Study::from_toml_bytes(text.as_bytes(), "study.toml").unwrap();
    let read = |name: &str| match Robot::builtin(name) {
        Some(robot) => Ok(robot),
        None => Robot::from_file(folder.join(name)),
    };
    Experiment::new(study.clone(), Robots::of(&study, read).unwrap()).unwrap()
}

fn chain(experiment: &Experiment, region: &[[f64; 2]]) -> Chain {
    let commands = [0, 2].map(|seed| experiment.commands(Vec::new(), seed).unwrap());
    experiment.chain([&commands[0], &commands[1]], region, [0, 2]).unwrap()
}

fn near(chain: &Chain, name: &str, read: fn(&ChainStep) -> f64, expected: f64, fraction: f64) {
    let value = read(chain.steps.iter().find(|step| step.name == name).unwrap());
    assert!((value / expected - 1.0).abs() < fraction, "{name}: {value}, expected {expected} within {fraction}");
}

fn position(step: &ChainStep) -> f64 {
    1e3 * step.position_mean_m
}

fn rotation(step: &ChainStep) -> f64 {
    step.rotation_mean_rad.to_degrees()
}

fn tension(step: &ChainStep) -> f64 {
    step.tension_mean_norm.unwrap()
}

/// Every stage of chapter 6 on its rebuilt machine agrees with the single commands run by hand, whose three digits
/// allow a percent. From sec. 6.4 on the commands by hand have another record, see the next test.
#[test]
fn the_twin_goes_through_chapter_six() {
    let found = chain(&experiment("twin-chain"), &REGION);
    let is_named = |step: &ChainStep| crate::study::STAGES.contains(&step.name);
    assert!(found.steps.iter().all(is_named) && found.steps.len() == crate::study::STAGES.len());
    let step = |name: &str| found.steps.iter().find(|step| step.name == name).unwrap();
    near(&found, "reference", position, 37.23, 0.01);
    near(&found, "identified", position, 3.90, 0.01);
    near(&found, "identified", rotation, 0.280, 0.01);
    near(&found, "driven", position, 3.146, 0.01);
    near(&found, "driven", rotation, 0.229, 0.01);
    near(&found, "driven", |step| 1e3 * step.length_mean_abs_m, 2.115, 0.01);
    near(&found, "identified-again", position, 3.88, 0.01);
    near(&found, "identified-again", rotation, 0.224, 0.01);
    near(&found, "reduced-nominal", position, 38.94, 0.01);
    near(&found, "reduced-identified", position, 4.17, 0.01);
    near(&found, "elastostatic-nominal", position, 36.8, 0.002);
    near(&found, "elastostatic-nominal", tension, 2554.0, 0.002);
    near(&found, "elastostatic-identified", position, 1.74, 0.005);
    near(&found, "elastostatic-identified", tension, 162.0, 0.005);
    near(&found, "force-control-nominal", position, 37.9, 0.002);
    near(&found, "force-control-nominal", tension, 2330.0, 0.002);
    near(&found, "force-control", position, 0.617, 0.002);
    near(&found, "force-control", tension, 67.4, 0.002);
    near(&found, "force-control-edges", position, 0.924, 0.002);
    near(&found, "force-control-edges", tension, 200.0, 0.005);
    near(&found, "kinematic-edges", position, 7.56, 0.002);
    let full = step("constant-orientation").identified.unwrap();
    assert_eq!((full.rank, full.parameter_count), (24, 48));
    assert_eq!(step("elastostatic-identified").identified.unwrap().parameter_count, 62);
    assert_eq!((step("force-control").samples, step("force-control-edges").samples), (75, 132));
    assert_eq!(step("force-control-edges").slack_samples, Some(0));
    assert!(step("kinematic-edges").slack_samples.unwrap() > 20);
    let tracking = found.force_tracking.unwrap();
    assert_eq!(tracking.verdict, TrackingVerdict::Better);
    assert_eq!(tracking.after_mean_norm_N, tension(step("force-control")));
    assert_eq!(tracking.before_mean_norm_N, tension(step("force-control-nominal")));
    // the second record of the same machine moves anchors less than the first did
    assert!(found.second_change_m[1] < 0.5 * found.first_change_m[1], "{found:?}");
    assert!(found.left_out.is_empty() && found.calibrated.len() == 2);
}

/// The calculation by hand (0.631 mm and 69.5 N under force control, where the chain has 0.617 mm and 67.4 N) measured its
/// elastostatic record under the controller with the printed anchors, eq. 6.7, and the chain under the one that it has
/// identified itself. Poses and noise are the same, what the sensors see differs, and so do the 62 parameters: with the printed
/// anchors the chain gives every number of the calculation by hand to its last digit.
#[test]
fn the_printed_anchors_make_the_record_of_the_calculation_by_hand() {
    let nominal = experiment("twin-chain");
    let printed = Robot::builtin("cablerobot-simulator-helicopter-kinematic-calibrated").unwrap();
    let driven = nominal.with_control(Model::new(printed, Composition::STANDARD).unwrap());
    let commands = nominal.commands(Vec::new(), 0).unwrap();
    let is_level = |one: &&CommandedPose| one.shortened.is_none() && one.pose.angle_to(&nominal.start) < 1e-9;
    let level: Vec<CommandedPose> = commands.iter().filter(is_level).cloned().collect();
    let mut found = Chain::before_all_stages();
    found.elastostatic((&nominal, &driven), (&commands, &level), &REGION, 0).unwrap();
    // half of the last digit
    near(&found, "elastostatic-nominal", position, 36.73, 0.005 / 36.73);
    near(&found, "elastostatic-nominal", rotation, 1.108, 0.0005 / 1.108);
    near(&found, "elastostatic-nominal", tension, 2557.8, 0.05 / 2557.8);
    near(&found, "elastostatic-identified", position, 1.738, 0.0005 / 1.738);
    near(&found, "elastostatic-identified", rotation, 0.091, 0.0005 / 0.091);
    near(&found, "elastostatic-identified", tension, 162.3, 0.05 / 162.3);
    near(&found, "force-control", position, 0.631, 0.0005 / 0.631);
    near(&found, "force-control", tension, 69.5, 0.05 / 69.5);
    near(&found, "force-control-edges", position, 0.939, 0.0005 / 0.939);
    near(&found, "force-control-edges", rotation, 0.053, 0.0005 / 0.053);
    near(&found, "force-control-edges", tension, 199.6, 0.05 / 199.6);
    near(&found, "kinematic-edges", position, 8.98, 0.005 / 8.98);
    assert_eq!(found.steps.last().and_then(|step| step.slack_samples), Some(39));
}

/// Force control of the planar example on a machine with pulleys that its models lack (sec. 4.5): the identification makes the
/// poses of the record fit and the tensions that emerge under force control worse; before it 136.4 N.
#[test]
fn a_chain_whose_identification_spoils_force_control_says_so() {
    let study = r#"
        control = { robot = "planar-example" }
        machine = { robot = "robots/planar-tracking-machine.toml", model = "pulley+elastic" }
        prediction = { robot = "planar-example", model = "elastic" }
        initial = { pose = [0, 5.2], offset_m = [0.292369, 0.302969, 0.346300, 0.353732] }
        limits = { tension_min_N = 1000, tension_max_N = 8000 }
        noise = { position_m = 1e-4, length_m = 1e-4, tension_N = 10 }
        [poses.grid]
        min = [-4, 0.5]
        max = [4, 6]
        count = [5, 5]
    "#;
    let found = chain(&of_text(study), &[[-4.5, 4.5], [0.2, 6.5]]);
    let tracking = found.force_tracking.unwrap();
    assert!(tracking.is_worse(), "{tracking:?}");
    // the tension method of a study is the distribution nearest the middle of the limits, as the closed form within them
    assert!((tracking.before_mean_norm_N - 136.4).abs() < 0.05, "{tracking:?}");
    near(&found, "elastostatic-nominal", position, 15.2, 0.01);
    assert!(position(&found.steps[5]) < 5.0, "{:?}", found.steps[5]);
}

/// A study of a point in a plane without a nominal elastostatic model runs the stages it can and names those left out.
#[test]
fn stages_that_a_study_has_nothing_for_are_left_out_in_words() {
    let found = chain(&experiment("planar-wide-grid"), &[[-4.5, 4.5], [0.2, 6.5]]);
    let names: Vec<&str> = found.steps.iter().map(|step| step.name).collect();
    assert_eq!(names, ["reference", "identified", "driven", "identified-again"]);
    assert_eq!(found.left_out.len(), 2, "{:?}", found.left_out);
    assert!(found.left_out[0].contains("does not turn") && found.left_out[1].contains("[prediction]"));
    // sec. 4.4: 57.14 mm with the nominal controller, 40.49 with the optimum
    let position: Vec<f64> = found.steps.iter().map(|step| 1e3 * step.position_mean_m).collect();
    assert!((position[0] - 57.14).abs() < 0.02 && (position[2] - 40.49).abs() < 0.02, "{position:?}");
}

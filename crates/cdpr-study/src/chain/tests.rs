use std::path::Path;

use super::{Chain, ChainStep};
use crate::{Experiment, Robots, Study};
use cdpr_model::robot::Robot;

const REGION: [[f64; 2]; 3] = [[-2.0, 2.0], [-2.0, 2.0], [0.75, 2.75]];

/// A study of the book.
pub(crate) fn experiment(name: &str) -> Experiment {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies");
    let path = folder.join(format!("{name}.toml"));
    let study = Study::from_toml_bytes(&std::fs::read(&path).unwrap(), &path.display().to_string()).unwrap();
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

/// Every stage of chapter 6 on its rebuilt machine agrees with the single commands run by hand, whose three digits
/// allow a percent. There the elastostatic record was made with the printed anchors (eq. 6.7) instead of the identified
/// ones, which changes later stages by some percent, and the kinematic controller on the edges, where cables hang
/// slack, by more.
#[test]
fn the_twin_goes_through_chapter_six() {
    let found = chain(&experiment("twin-chain"), &REGION);
    let is_named = |step: &ChainStep| crate::study::STAGES.contains(&step.name);
    assert!(found.steps.iter().all(is_named) && found.steps.len() == crate::study::STAGES.len());
    let step = |name: &str| found.steps.iter().find(|step| step.name == name).unwrap();
    let near = |name: &str, read: fn(&ChainStep) -> f64, expected: f64, fraction: f64| {
        let value = read(step(name));
        assert!((value / expected - 1.0).abs() < fraction, "{name}: {value}, expected {expected} within {fraction}");
    };
    let position = |step: &ChainStep| 1e3 * step.position_mean_m;
    let rotation = |step: &ChainStep| step.rotation_mean_rad.to_degrees();
    let tension = |step: &ChainStep| step.tension_mean_norm.unwrap();
    near("reference", position, 37.23, 0.01);
    near("identified", position, 3.90, 0.01);
    near("identified", rotation, 0.280, 0.01);
    near("driven", position, 3.146, 0.01);
    near("driven", rotation, 0.229, 0.01);
    near("driven", |step| 1e3 * step.length_mean_abs_m, 2.115, 0.01);
    near("identified-again", position, 3.88, 0.01);
    near("identified-again", rotation, 0.224, 0.01);
    near("reduced-nominal", position, 38.94, 0.01);
    near("reduced-identified", position, 4.17, 0.01);
    near("elastostatic-nominal", position, 36.73, 0.02);
    near("elastostatic-nominal", rotation, 1.108, 0.02);
    near("elastostatic-nominal", tension, 2557.8, 0.02);
    near("elastostatic-identified", position, 1.738, 0.02);
    near("elastostatic-identified", rotation, 0.091, 0.02);
    near("elastostatic-identified", tension, 162.3, 0.02);
    near("force-control", position, 0.631, 0.05);
    near("force-control", tension, 69.5, 0.05);
    near("force-control-edges", position, 0.939, 0.05);
    near("force-control-edges", tension, 199.6, 0.05);
    near("kinematic-edges", position, 8.98, 0.25);
    let full = step("constant-orientation").identified.unwrap();
    assert_eq!((full.rank, full.parameter_count), (24, 48));
    assert_eq!(step("elastostatic-identified").identified.unwrap().parameter_count, 62);
    assert_eq!((step("force-control").samples, step("force-control-edges").samples), (75, 132));
    assert_eq!(step("force-control-edges").slack_samples, Some(0));
    assert!(step("kinematic-edges").slack_samples.unwrap() > 20);
    // the second record of the same machine moves anchors less than the first did
    assert!(found.second_change_m[1] < 0.5 * found.first_change_m[1], "{found:?}");
    assert!(found.left_out.is_empty() && found.calibrated.len() == 2);
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

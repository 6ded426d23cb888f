use super::*;
use cdpr_model::robot::{HysteresisTable, Robot};

fn task(robot: &Robot, half: f64, count: usize) -> Vec<Pose> {
    let home = robot.home.unwrap();
    let axes = robot.motion_pattern.is_planar();
    let along = |index: usize| half * (2.0 * index as f64 / (count - 1) as f64 - 1.0);
    let shifted = |cell: usize| {
        let (i, j) = (cell / count, cell % count);
        let second = if axes { nalgebra::Vector3::y() } else { nalgebra::Vector3::z() };
        let shift = nalgebra::Vector3::x() * along(i) + second * along(j);
        Pose { position: home.position + shift, ..home }
    };
    (0..count * count).map(shifted).collect()
}

fn advice(name: &str, half: f64, accuracy: f64) -> Advice {
    let robot = Robot::builtin(name).unwrap();
    let supported = Composition::supported(&robot).unwrap();
    let poses = task(&robot, half, 5);
    let machine = Model::new(robot, supported.richest).unwrap();
    advise(&machine, &supported, &poses, accuracy, Method::Qp).unwrap()
}

/// The control model like the machine makes no error; the simplest sufficient model is recommended, and no other.
#[test]
fn the_simplest_model_that_reaches_the_task_is_recommended() {
    let strict = advice("planar-example", 0.5, 1e-4);
    let loose = advice("planar-example", 0.5, 0.1);
    let full = strict.candidates.last().unwrap();
    assert_eq!(full.control, strict.machine);
    assert!(full.position_error.max < 1e-9 && full.left_out.is_empty(), "{full:?}");
    assert_eq!((full.reached, strict.attainable, strict.compared), (25, 25, 25));
    let chosen = |advice: &Advice| advice.candidates[advice.recommended.unwrap()].control;
    assert_eq!(chosen(&loose), Composition::STANDARD);
    assert!(chosen(&strict).is_elastic(), "{strict:?}");
    for pair in strict.candidates.windows(2) {
        assert!(pair[0].control.effect_count() <= pair[1].control.effect_count());
    }
    let standard = &strict.candidates[0];
    assert!(standard.left_out.contains(&"elastic") && standard.tension_error.unwrap() > 1.0, "{standard:?}");
    assert!(standard.reached < 25 && strict.reached_share(standard) < 1.0);
}

#[test]
fn a_file_without_effects_leaves_nothing_to_choose() {
    let mut robot = Robot::builtin("planar-example").unwrap();
    for cable in &mut robot.cables {
        *cable = cdpr_model::robot::Cable {
            name: cable.name.clone(),
            frame_anchor: cable.frame_anchor,
            platform_anchor: cable.platform_anchor,
            ..Default::default()
        };
    }
    let supported = Composition::supported(&robot).unwrap();
    let poses = task(&robot, 0.5, 2);
    let machine = Model::new(robot, supported.richest).unwrap();
    let error = advise(&machine, &supported, &poses, 0.01, Method::Qp).unwrap_err();
    assert!(matches!(error, AdviceError::NothingToChoose { .. }), "{error}");
}

/// The planar example with the keys that `cdpr test-bench` writes beside the stiffness: a hysteresis table with strokes
/// 2 % apart.
fn with_hysteresis() -> Robot {
    let mut robot = Robot::builtin("planar-example").unwrap();
    for cable in &mut robot.cables {
        cable.hysteresis = Some(HysteresisTable {
            strain: vec![0.0, 0.02, 0.1],
            loading_N: vec![0.0, 4050.0, 22000.0],
            unloading_N: vec![0.0, 3950.0, 22000.0],
            transition_strain: vec![0.002],
            ..HysteresisTable::default()
        });
    }
    robot
}

/// Of the models with one effect, the one with hysteresis is the machine's: it comes last, the numbers of its table
/// count as parameters, and every pose that it reaches is attainable.
#[test]
fn the_machine_is_judged_by_the_model_that_is_like_it() {
    let robot = with_hysteresis();
    let supported = Composition::supported(&robot).unwrap();
    assert_eq!(supported.richest.to_string(), "hysteresis");
    let poses = task(&robot, 0.5, 5);
    let machine = Model::new(robot, supported.richest).unwrap();
    let advice = advise(&machine, &supported, &poses, 0.03, Method::Qp).unwrap();
    let names: Vec<String> = advice.candidates.iter().map(|candidate| candidate.control.to_string()).collect();
    assert_eq!(names, ["standard", "elastic", "hysteresis"]);
    let full = advice.like_the_machine().unwrap();
    assert_eq!(full, advice.candidates.last().unwrap());
    // two tensions above zero on either branch, and one transition, for each of four cables
    assert_eq!((full.parameter_count, advice.candidates[1].parameter_count), (20, 4));
    assert_eq!((full.reached, advice.attainable), (25, 25), "{advice:?}");
    // it has the machine's memory, so that no error is left
    assert!(full.position_error.max < 1e-9 && advice.candidates[1].position_error.max > 1e-6, "{advice:?}");
}

/// A task that leaves the workspace: the models fail at different poses, and are compared at those where all have an
/// answer.
#[test]
fn errors_are_compared_at_the_same_poses() {
    let advice = advice("planar-example", 4.5, 1.0);
    let answered: Vec<usize> = advice.candidates.iter().map(|candidate| candidate.answered).collect();
    let (least, most) = (answered.iter().min().unwrap(), answered.iter().max().unwrap());
    assert!(least < most && advice.compared <= *least && advice.compared > 0, "{answered:?} {}", advice.compared);
    let full = advice.like_the_machine().unwrap();
    assert!(full.position_error.max < 1e-9 && full.tension_error.unwrap() < 1e-3, "{full:?}");
    assert!(full.reason.is_some(), "{full:?}");
    // attainable poses are those that any candidate reaches
    assert!(advice.attainable < advice.poses && advice.attainable >= full.reached, "{advice:?}");
    assert!(advice.candidates.iter().all(|candidate| advice.reached_share(candidate) <= 1.0));
}

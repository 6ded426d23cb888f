use super::*;
use crate::robot::Robot;

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
    advise(&machine, &supported, &poses, accuracy, TensionMethod::Qp).unwrap()
}

/// The control model like the machine makes no error; the simplest that is good enough is taken, and only that.
#[test]
fn the_simplest_model_that_reaches_the_task_is_recommended() {
    let strict = advice("planar-example", 0.5, 1e-4);
    let loose = advice("planar-example", 0.5, 0.1);
    let full = strict.candidates.last().unwrap();
    assert_eq!(full.control, strict.machine);
    assert!(full.position_error.max < 1e-9 && full.left_out.is_empty(), "{full:?}");
    assert_eq!(full.reached_share, 1.0);
    let chosen = |advice: &Advice| advice.candidates[advice.recommended.unwrap()].control;
    assert_eq!(chosen(&loose), Composition::STANDARD);
    assert!(chosen(&strict).is_elastic(), "{strict:?}");
    for pair in strict.candidates.windows(2) {
        assert!(pair[0].control.effect_count() <= pair[1].control.effect_count());
    }
    let standard = &strict.candidates[0];
    assert!(standard.left_out.contains(&"elastic") && standard.tension_error.unwrap() > 1.0, "{standard:?}");
    assert!(standard.reached_share < 1.0);
}

#[test]
fn a_file_without_effects_leaves_nothing_to_choose() {
    let mut robot = Robot::builtin("planar-example").unwrap();
    for cable in &mut robot.cables {
        *cable = crate::robot::Cable {
            name: cable.name.clone(),
            frame_anchor: cable.frame_anchor,
            platform_anchor: cable.platform_anchor,
            ..Default::default()
        };
    }
    let supported = Composition::supported(&robot).unwrap();
    let poses = task(&robot, 0.5, 2);
    let machine = Model::new(robot, supported.richest).unwrap();
    let error = advise(&machine, &supported, &poses, 0.01, TensionMethod::Qp).unwrap_err();
    assert!(matches!(error, AdviceError::NothingToChoose { .. }), "{error}");
}

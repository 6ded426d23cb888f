use super::*;
use crate::geometry::{MotionPattern, Plane};
use crate::robot::{Cable, Groove, GrooveEnds, Platform};

/// A robot of each pattern with every number stated, the planar ones in planes whose normals are negative axes too.
fn robots() -> Vec<Robot> {
    let cube = Robot::builtin("cablerobot-simulator-helicopter").unwrap();
    let planes = [(MotionPattern::Planar, "xz"), (MotionPattern::PlanarPoint, "zx"), (MotionPattern::Planar, "yx")];
    let patterns = [(MotionPattern::Spatial, "xy"), (MotionPattern::SpatialPoint, "xy")].into_iter().chain(planes);
    let of = |(motion_pattern, axes): (MotionPattern, &str)| {
        let mut robot = Robot { motion_pattern, plane: Plane::from_axes(axes).unwrap(), ..cube.clone() };
        robot.platform = Platform { mass: Some(0.0), ..Platform::default() };
        // an axis of the world, in every plane, so that turns are read back to the bit
        for cable in &mut robot.cables {
            cable.set_pulley_swivel_axis(Vector3::x());
            cable.winch.axis = Some(Vector3::x().into());
        }
        for (index, parameter) in robot.parameters().collect::<Vec<_>>().into_iter().enumerate() {
            parameter.set(&mut robot, 0.25 + 0.125 * index as f64);
        }
        robot
    };
    patterns.map(of).collect()
}

#[test]
fn a_value_that_is_set_is_the_value_that_is_got() {
    for mut robot in robots() {
        for parameter in robot.parameters().collect::<Vec<_>>() {
            parameter.set(&mut robot, 0.1);
            assert_eq!(parameter.get(&robot), Some(0.1), "{}", parameter.name(&robot));
            assert_eq!(parameter.value(&robot), 0.1, "{}", parameter.name(&robot));
        }
    }
}

/// Stiffness and compliance are two forms of one number: `set` uses the form in which it is stated.
#[test]
fn to_set_the_value_that_a_robot_has_changes_nothing() {
    let built_in = crate::robot::builtin::names().map(|name| Robot::builtin(name).unwrap());
    for robot in built_in.chain(robots()) {
        for parameter in robot.parameters() {
            let is_inverse = |cable: &Cable| match parameter.kind {
                ParameterKind::Compliance => cable.axial_compliance().is_none(),
                ParameterKind::AxialStiffness => cable.axial_stiffness().is_none(),
                _ => false,
            };
            let Some(value) = parameter.get(&robot).filter(|_| !is_inverse(&robot.cables[parameter.cable])) else {
                continue;
            };
            let mut changed = robot.clone();
            parameter.set(&mut changed, value);
            assert_eq!(changed, robot, "{}", parameter.name(&robot));
        }
    }
}

#[test]
fn one_parameter_moves_no_other() {
    let same_number = |a: ParameterKind, b: ParameterKind| {
        use ParameterKind as Kind;
        let groups: [&[Kind]; 2] = [
            &[Kind::AxialStiffness, Kind::Compliance, Kind::SpringConstant],
            &[Kind::Force, Kind::Moment, Kind::Wrench],
        ];
        groups.iter().any(|group| group.contains(&a) && group.contains(&b))
    };
    for robot in robots() {
        for parameter in robot.parameters() {
            let mut changed = robot.clone();
            parameter.set(&mut changed, 77.0);
            for other in robot.parameters().filter(|&other| other != parameter) {
                let is_moved = other.get(&changed) != other.get(&robot);
                let may_move = other.cable == parameter.cable && same_number(parameter.kind, other.kind);
                assert!(!is_moved || may_move, "{} moved {}", parameter.name(&robot), other.name(&robot));
            }
        }
    }
}

#[test]
fn names_and_keys_spell_the_parameter_they_come_from() {
    let mut spelled = std::collections::BTreeSet::new();
    for robot in robots() {
        for parameter in robot.parameters() {
            let name = parameter.name(&robot);
            assert_eq!(Parameter::named(&name, &robot), Some(vec![parameter]), "{name}");
            if let Some(key) = parameter.key(&robot) {
                assert_eq!(Parameter::named(&key, &robot), Some(vec![parameter]), "{key}");
            }
            spelled.insert(parameter.kind);
        }
    }
    assert_eq!(spelled.len(), ParameterKind::ALL.len());
}

#[test]
fn numbers_of_laws_are_parameters_under_the_names_of_their_entries() {
    for (place, number) in crate::robot::stretch::registry::law_numbers().enumerate() {
        let kind = ParameterKind::Stretch(crate::robot::StretchNumber::at(place));
        assert_eq!((kind.name(), kind.key(), kind.unit()), (number.name, number.key, number.unit));
        assert!(ParameterKind::IDENTIFIED.contains(&kind) && ParameterKind::ALL.contains(&kind));
    }
}

#[test]
fn names_and_keys_are_those_that_files_and_results_use() {
    let [spatial, _, planar, ..] = &robots()[..] else { panic!("five robots") };
    let one = |text: &str, robot: &Robot| match Parameter::named(text, robot).as_deref() {
        Some(&[parameter]) => (parameter.name(robot), parameter.key(robot)),
        other => panic!("{text}: {other:?}"),
    };
    for (text, name) in [
        ("cable[2].frame_anchor_m[3]", "frame-anchor[2].z"),
        ("cable[8].axial_stiffness_EA_N", "axial-stiffness[8]"),
        ("platform.center_of_mass_m[1]", "center-of-mass.x"),
        ("external_wrench.moment_Nm[2]", "moment.y"),
        ("gravity_m_s2[3]", "gravity.z"),
    ] {
        assert_eq!(one(text, spatial), (name.to_owned(), Some(text.to_owned())));
    }
    assert_eq!(one("cable[1].platform_anchor_m[2]", planar).0, "platform-anchor[1].z");
    assert_eq!(one("external_wrench.moment_Nm", planar).0, "moment");
    assert_eq!(one("wrench.moment", planar), ("wrench.moment".to_owned(), None));
    assert_eq!(Parameter::named("cable[*].hidden_length_m", planar).unwrap().len(), planar.cable_count());
    assert_eq!(Parameter::named("drum-radius[1,3]", spatial).unwrap().len(), 2);
    for nothing in [
        "",
        "mas",
        "mass[1]",
        "cable.hidden_length_m",
        "cable[99].hidden_length_m",
        "cable[0].hidden_length_m",
        "cable[1].frame_anchor_m",
        "cable[1].frame_anchor_m[4]",
        "cable[1].name",
        "platform.hidden_length_m",
        "hidden_length_m",
        "frame-anchor[1].w",
        "wrench",
    ] {
        assert_eq!(Parameter::named(nothing, spatial), None, "{nothing}");
    }
}

/// Numbers that a robot may have can be written to its file and read back: ranges of files and of parameters are the
/// same.
#[test]
fn values_out_of_range_are_those_that_robot_files_refuse() {
    let robot = Robot::builtin("cucablerobot").unwrap();
    for parameter in robot.parameters().filter(|parameter| parameter.kind.owner() == Owner::Cable) {
        for value in [-1.0, 0.0, 1e-31] {
            let mut changed = robot.clone();
            let cable = &mut changed.cables[parameter.cable];
            let ends = Some(GrooveEnds { length: 0.5, layer_height: None });
            (cable.stiffness, cable.winch.groove) = (None, Some(Groove { pitch: 0.01, ends }));
            parameter.set(&mut changed, value);
            let is_refused = Robot::from_toml(&changed.to_toml(), "changed.toml").is_err_and(|error| {
                ["robot::negative", "robot::not-positive", "robot::gear-ratio"].contains(&error.code)
            });
            assert_eq!(is_refused, !parameter.kind.range().contains(value), "{} = {value}", parameter.name(&robot));
        }
    }
}

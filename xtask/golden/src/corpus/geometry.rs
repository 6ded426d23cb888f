//! Robots, lengths and poses: every built-in robot, and those of `../shared`.

use crate::group::Group;

/// Built-in robots, and a pose off their home.
const ROBOTS: &[(&str, &str)] = &[
    ("planar-example", "0.5,4"),
    ("planar-example-calibrated", "-0.7,4.6"),
    ("cablerobot-simulator-icosahedron", "0.3,-0.2,2.6,0.05,-0.03,0.1"),
    ("cablerobot-simulator-helicopter", "0.4,-0.3,1.7,0.05,-0.04,0.08"),
    ("cablerobot-simulator-helicopter-design", "0.2,0.2,2.4,0.02,0.03,-0.05"),
    ("cablerobot-simulator-helicopter-kinematic-calibrated", "1,0.5,1.7,0,0.05,0.1"),
    ("cablerobot-simulator-helicopter-elastostatic-calibrated", "-0.5,0.4,1.6,0.03,0,-0.1"),
    ("ipanema-1", "0.1,0.2,1.1,0.05,0.05,0.1"),
    ("ipanema-2", "0.3,-0.2,3.2,0.05,0.02,0.1"),
    ("macarm", "1.2,1.1,1.25,0.05,0.02,0.1"),
    ("spatial-7-cable", "0.55,0.45,0.52,0.05,0.02,0.1"),
    ("cu-brick", "1.1,0.4,1.1,0.05,0.02,0.1"),
    ("xl-laser", "2.2,1.9,1.3,0.05,0.02,0.1"),
    ("cucablerobot", "1.2,1.1,1.05,0.05,0.02,0.1"),
    ("cogiro", "0.2,-0.3,2.1,0.05,0,0.1"),
    ("caroca", "0.3,0.2,1.1,0.02,0.01,0.05"),
    ("caroca-pulleys", "0.3,0.2,1.1,0.02,0.01,0.05"),
    ("fast", "5,-3,152,0.01,0.02,0"),
    ("nist-robocrane", "0.1,0.05,1.55,0.02,0.01,0.05"),
    ("swinburne-suspended", "2.1,1.9,1.1,0.02,0.01,0.05"),
    ("kntu-planar", "0.05,0.03,0.1"),
    ("two-dof-vsd", "0.25,0.36"),
    ("cucablerobot-planar", "1.2,1.05,0.1"),
];

/// Robots of `../shared/data/robots` that are not built in.
const SHARED: &[(&str, &str)] = &[
    ("cablar-1r2t", "0.3,2.6,0.1"),
    ("cablar-2t", "0.3,2.6"),
    ("caroca-gazebo", "0.2,0.1,1.1,0.02,0.01,0.05"),
    ("grab-prototype-33", "-0.26,1.18,0.21,-0.01,0,0.005"),
    ("gtcable-planar", "1.5,1.1,0.05"),
    ("ipanema-3", "0.1,0.1,0.1,0.02,0.01,0.05"),
    ("irma4u-lab3", "0.05,0.02,0.6,0.02,0.01,0.05"),
    ("irma4u-mar25", "0.05,0.02,0.6,0.02,0.01,0.05"),
    ("irma8-platform-winches", "0.05,0.05,0.05,0.02,0.01,0.05"),
    ("isw-planar-2t", "0.1,0.1"),
    ("laser-engraver-planar", "0.05,0.02,0.05"),
    ("ntnu-planar", "0.05,0.02,0.05"),
    ("ueland-8-cable", "0.1,0.1,0.1,0.02,0.01,0.05"),
];

/// Robots with an effect besides, and its name.
const EFFECTS: &[(&str, &str, &str)] = &[
    ("planar-example", "0.5,4", "elastic"),
    ("planar-example-calibrated", "-0.7,4.6", "elastic"),
    ("cablerobot-simulator-helicopter", "0.4,-0.3,1.7,0.05,-0.04,0.08", "elastic"),
    ("cablerobot-simulator-helicopter-elastostatic-calibrated", "-0.5,0.4,1.6,0.03,0,-0.1", "elastic"),
    ("cucablerobot", "1.2,1.1,1.05,0.05,0.02,0.1", "pulley"),
    ("caroca-pulleys", "0.3,0.2,1.1,0.02,0.01,0.05", "pulley"),
];

/// Groups.
pub(crate) fn groups() -> Vec<Group> {
    let built_in = ROBOTS.iter().map(|(robot, pose)| of_robot(&format!("robot-{robot}"), robot, pose));
    let shared = SHARED.iter().map(|(robot, pose)| {
        of_robot(&format!("shared-robot-{robot}"), &format!("{{shared}}/data/robots/{robot}.toml"), pose)
    });
    built_in.chain(shared).chain([effects(), placed()]).collect()
}

fn of_robot(name: &str, robot: &str, pose: &str) -> Group {
    Group::new(name)
        .call(&format!("check {robot}"))
        .call(&format!("ik {robot} --pose {pose}"))
        .call(&format!("fk {robot} --lengths {{lengths}}"))
        .call(&format!("tension {robot} --pose {pose}"))
        .call(&format!("load {robot} --pose {pose} --tensions {{lengths}}"))
}

fn effects() -> Group {
    EFFECTS.iter().fold(Group::new("effects"), |group, (robot, pose, model)| {
        group
            .call(&format!("ik {robot} --pose {pose} --model {model}"))
            .call(&format!("fk {robot} --lengths {{lengths}} --model {model}"))
            .call(&format!("model {robot} --pose {pose}"))
    })
}

fn placed() -> Group {
    let planar = "place-pulleys planar-example --axis 0,1 --axis 0,1 --axis=-1,0 --axis 1,0 --radius 0.1";
    Group::new("placed-pulleys")
        .call(&format!("{planar} --out planar.toml"))
        .calls("ik planar.toml --pose 0.5,4 --model %", &["pulley", "pulley+elastic"])
        .call("fk planar.toml --model pulley+elastic --lengths {lengths} --guess 0,4")
        .call("place-pulleys cogiro --axis 0,0,1 --radius 0.05 --pose 0.2,0,2,0,0,0 --out cogiro.toml")
        .call("ik cogiro.toml --pose 0.3,0.2,2.1,0,0,0.1 --model pulley --jacobians")
        .call("model planar.toml --pose 0.5,4 --wrench 0,-3000")
        .call("place-pulleys cogiro --radius 0.05 --out no-axes.toml")
}

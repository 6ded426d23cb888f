//! Laws of cables: every composition on a robot that has the keys of all.

use super::LAB;
use crate::group::Group;

const POSE: &str = "0.2,0.1,1.3,0.05,0.02,0.1";
const RIGID: &[&str] = &["standard", "pulley", "drum", "pulley+drum"];
const STRETCHING: &[&str] = &[
    "elastic",
    "polynomial",
    "hysteresis",
    "catenary",
    "finite-element",
    "pulley+elastic",
    "drum+elastic",
    "pulley+drum+elastic",
    "pulley+polynomial",
    "pulley+hysteresis",
    "elastic+catenary",
    "pulley+elastic+catenary",
];

/// Groups.
pub(crate) fn groups() -> Vec<Group> {
    let rigid = RIGID.iter().map(|model| of_model(model));
    let stretching = STRETCHING.iter().map(|model| {
        of_model(model)
            .call(&format!("fk lab.toml --lengths {{lengths}} --model {model} --wrench 10,5,-120,0,1,0"))
            .call(&format!("stiffness lab.toml --pose {POSE} --model {model}"))
            .call(&format!("modes lab.toml --pose {POSE} --model {model}"))
            .call(&format!("ik lab.toml --pose {POSE} --model {model} --tensions 300,250,300,250,200,150,200,150"))
            .call(&format!(
                "dynamics lab.toml --pose {POSE} --model {model} --twist 0.1,0,0.2,0,0.1,0 --lengths {{lengths}}"
            ))
    });
    rigid.chain(stretching).chain([drums(), unknown()]).collect()
}

fn of_model(model: &str) -> Group {
    Group::new(&format!("law-{model}"))
        .write("lab.toml", LAB)
        .call(&format!("ik lab.toml --pose {POSE} --model {model}"))
        .call(&format!("fk lab.toml --lengths {{lengths}} --model {model}"))
}

fn drums() -> Group {
    Group::new("drums")
        .write("lab.toml", LAB)
        .call(&format!("modes lab.toml --pose {POSE} --winches drums"))
        .call(&format!("modes lab.toml --pose {POSE} --winches drums --model pulley+elastic"))
        .call("fk lab.toml --model drum --motor-angles 10,40,40,10,20,60,60,20")
        .call("fk lab.toml --motor-angles 10,40,40,10,20,60,60,20")
        .call(&format!("model lab.toml --pose {POSE}"))
        .call("check lab.toml")
}

/// Effects that the file does not have.
fn unknown() -> Group {
    Group::new("law-unknown")
        .calls("ik planar-example --pose 0.5,4 --model %", &["pulley", "catenary", "two-piece", "elastic+elastic"])
        .call("stiffness planar-example --pose 0.5,4 --model standard")
}

//! Tensions by every method, loads, stiffness, dynamics, modes.

use super::LAB;
use crate::group::Group;

const METHODS: &[&str] = &[
    "qp",
    "closed-form",
    "improved-closed-form",
    "puncture",
    "dykstra",
    "centroid",
    "minimum",
    "maximum",
    "barrier",
    "nearest-wrench",
];

/// Name of a group, robot, pose, a load within reach and one beyond.
const ROBOTS: &[[&str; 5]] = &[
    ["planar", "planar-example", "0,5.2", "0,-1962", "0,-60000"],
    ["plate", "cucablerobot-planar", "1.2,1.05,0.1", "0,-5,0", "0,-90000,0"],
    ["cogiro", "cogiro", "0.2,-0.3,2.1,0.05,0,0.1", "0,0,-3000,0,0,0", "0,0,300000,0,0,0"],
    ["seven", "spatial-7-cable", "0.55,0.45,0.52,0.05,0.02,0.1", "0,0,-10,0,0,0", "0,0,-1e5,0,0,0"],
    ["lab", "lab.toml", "0.2,0.1,1.3,0.05,0.02,0.1", "20,-10,-150,1,0,2", "0,0,-9000,0,0,0"],
];

/// Groups.
pub(crate) fn groups() -> Vec<Group> {
    let methods = ROBOTS.iter().map(|[name, robot, pose, load, beyond]| {
        let start = Group::new(&format!("tension-{name}")).write("lab.toml", LAB);
        METHODS
            .iter()
            .fold(start, |group, method| {
                group.call(&format!("tension {robot} --pose {pose} --wrench {load} --method {method}"))
            })
            .call(&format!("tension {robot} --pose {pose} --wrench {beyond}"))
            .call(&format!("tension {robot} --pose {pose} --wrench {beyond} --method nearest-wrench"))
            .call(&format!("tension {robot} --pose {pose} --wrench {beyond} --method improved-closed-form"))
    });
    methods.chain([choices(), loads(), stiffness(), dynamics(), modes()]).collect()
}

fn choices() -> Group {
    let previous = "tension planar-example --pose 0,5.2 --previous 5000,5000,3000,3000";
    Group::new("tension-choices")
        .calls("tension planar-example --pose 0,5.2 --method maximum --p %", &["1", "3", "8"])
        .calls("tension planar-example --pose 0,5.2 --method minimum --p %", &["1", "4"])
        .call("tension planar-example --pose 0,5.2 --wrench 0,-1962 --min 1000 --max 4000")
        .call("tension planar-example --pose 0,5.2 --reference 2000,2500,1500,1500")
        .call(&format!("{previous} --reference previous --rate 20000 --time-step 0.05"))
        .call(&format!("{previous} --reference previous --rate 100 --time-step 0.01"))
        .call("tension cogiro --pose 0,0,2,0,0,0 --method nearest-wrench --wrench 0,0,9e5,0,0,0 --moment-length 0.5")
        .call("tension {shared}/cases/cube-indeterminate/robot.toml --pose 0,0,2,0,0,0")
        .call("fk {shared}/cases/cube-indeterminate/robot.toml --lengths 3.237283,3.237283,3.237283,3.237283")
}

fn loads() -> Group {
    let helicopter = "cablerobot-simulator-helicopter-kinematic-calibrated --pose 0,0,1.5,0,0,0";
    let tensions = "3678,2169,4250,1708,3985,2394,4715,1684";
    Group::new("loads")
        .call("load planar-example --pose 0,5.2 --tensions 5808,5909,2390,2421")
        .call(&format!("load {helicopter} --tensions {tensions} --group upper=1,3,5,7 --group lower=2,4,6,8"))
        .call(&format!("load {helicopter} --tensions {tensions} --recorded"))
        .call("fk planar-example --tensions 5808,5909,2390,2421")
        .call(&format!("fk cablerobot-simulator-helicopter --tensions {tensions} --wrench 0,0,-5500,0,-480,0"))
        .call("fk planar-example --lengths 6.62,5.73,7.21")
}

fn stiffness() -> Group {
    let helicopter = "stiffness cablerobot-simulator-helicopter --pose 0,0,1.5,0,0,0";
    Group::new("stiffness")
        .calls("stiffness planar-example --pose %", &["0,5.2", "-3,2", "3,6"])
        .call(&format!("{helicopter} --tensions 3678,2169,4250,1708,3985,2394,4715,1684"))
        .call(&format!("{helicopter} --wrench 0,0,-5500,0,-480,0"))
        .call("stiffness cablerobot-simulator-helicopter-elastostatic-calibrated --pose 1,0.5,1.7,0.1,0,0.1")
}

fn dynamics() -> Group {
    let machine = "dynamics {studies}/robots/simulator-in-motion.toml --pose 0,0,1.5,0,0,0";
    Group::new("dynamics")
        .write("lab.toml", LAB)
        .call(&format!("{machine} --acceleration 0,0,2,0,0,0"))
        .call(&format!("{machine} --twist 1,0,0,0,0,0.5 --tensions 3678,2169,4250,1708,3985,2394,4715,1684"))
        .call(&format!("{machine} --acceleration 0,0,20,0,0,0"))
        .call("dynamics lab.toml --pose 0.2,0.1,1.3,0.05,0.02,0.1 --twist 0.5,0.2,0,0.4,0.1,0.3 --acceleration 1,0,1,0,0.5,0")
        .call("dynamics lab.toml --pose 0.2,0.1,1.3,0.05,0.02,0.1 --wrench 0,0,-50,0,0,1")
}

fn modes() -> Group {
    let machine = "modes {studies}/robots/simulator-in-motion.toml --pose";
    Group::new("modes")
        .call(&format!("{machine} 0,0,1.5,0,0,0"))
        .call(&format!("{machine} 0.5,-0.3,1.7,0.05,0,0.1 --winches drums"))
        .call(&format!("{machine} 0,0,1.5,0,0,0 --tensions 6090,7840,5430,8260,5800,9300,6670,8310"))
}

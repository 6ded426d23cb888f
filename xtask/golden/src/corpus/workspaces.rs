//! Workspaces: criteria, methods, archetypes, advice.

use super::LAB;
use crate::group::Group;

const CRITERIA: &[&str] = &[
    "wrench-feasible",
    "wrench-closure",
    "wrench-set-feasible:force=10,moment=1",
    "stiffness:least=1",
    "stability",
    "natural-frequency:least=1",
    "condition:largest=5",
    "dexterity:least=0.1",
    "cable-length:least=1,largest=3.5",
    "cable-interference:diameter=0.01",
    "platform-interference",
    "validity",
];
const ARCHETYPES: &[&str] = &["total-orientation", "inclusion-orientation", "maximal", "dextrous"];

/// Groups.
pub(crate) fn groups() -> Vec<Group> {
    vec![all_effects(), planar(), spatial(), lab(), advice(), boxes()]
}

/// The machine with every effect under each control model.
fn all_effects() -> Group {
    Group::new("advice-of-the-lab")
        .whole_only()
        .write("lab.toml", LAB)
        .call("advise lab.toml --task=-0.5,0.5,-0.4,0.4,1,1.5 --accuracy 0.002 --count 2")
}

/// Payload, acceleration and speed in boxes; one is too wide.
fn boxes() -> Group {
    Group::new("capability")
        .call("capability planar-example --box=-1,1,3,5")
        .call("capability cogiro --box=-1,1,-1,1,1,2 --payload-place 0.1 --gap 0.05")
        .call("capability cogiro --box=-8,3,-2,2,1,3")
        .call("capability kntu-planar --box=-0.3,0.3,-0.3,0.3 --rotation 0.05")
}

fn planar() -> Group {
    CRITERIA
        .iter()
        .fold(Group::new("workspace-planar"), |group, criterion| {
            group.call(&format!("workspace planar-example --model elastic --step 0.5 --criterion {criterion}"))
        })
        .calls(
            "workspace planar-example --method %",
            &["grid", "octree", "hull", "grid --step 0.2", "octree --step 0.2", "hull --rays 36"],
        )
        .calls(
            "workspace planar-example --wrench 0,-9000 --min 500 --max 6000 --method %",
            &["grid --step 0.3", "hull --rays 36"],
        )
        .call("workspace planar-example --wrench 0,-60000 --step 1")
        .call_and_read("workspace planar-example --method hull --rays 24 --mesh hull.csv", &["hull.csv"])
        .calls("workspace cucablerobot-planar --step 0.1 --angles -0.2,0.2,3 --archetype %", ARCHETYPES)
        .call("workspace cucablerobot-planar --step 0.1 --rotation 0.2 --criterion wrench-closure")
}

fn spatial() -> Group {
    Group::new("workspace-spatial")
        .calls("workspace cogiro --method %", &["hull", "grid --step 1", "octree --step 0.5", "hull --rays 60"])
        .calls("workspace ipanema-1 --method %", &["grid --step 0.4", "hull --rays 60"])
        .calls(
            "workspace ipanema-1 --step 0.5 --angles -0.2,0.2,3,-0.2,0.2,3,0,0,1 --orientations 10 --archetype %",
            ARCHETYPES,
        )
        .call("workspace cablerobot-simulator-icosahedron --wrench 0,0,-4905,0,0,0 --min 1000 --max 9000 --method hull --rays 80")
        .call("workspace spatial-7-cable --step 0.2 --criterion wrench-closure")
        .call("workspace fast --step 60")
}

fn lab() -> Group {
    CRITERIA
        .iter()
        .fold(Group::new("workspace-lab").write("lab.toml", LAB), |group, criterion| {
            group.call(&format!("workspace lab.toml --model pulley+elastic --step 0.6 --criterion {criterion}"))
        })
        .call("workspace lab.toml --model pulley --step 0.6 --criterion pulley-wrap:least=0,largest=3")
        .call("workspace lab.toml --model pulley+elastic --step 0.5 --criterion wrench-feasible --criterion stiffness:least=1e4")
        .call("workspace lab.toml --step 0.5 --criterion obstacles")
        .call("workspace lab.toml --step 0.5 --criterion no-such")
}

fn advice() -> Group {
    Group::new("advice")
        .call("advise planar-example --task=-1,1,4,6 --accuracy 0.005")
        .call("advise cablerobot-simulator-helicopter --task=-1,1,-1,1,1.2,2 --accuracy 0.005 --count 3")
        .call("advise cablerobot-simulator-helicopter --task=-1,1,-1,1,1.2,2 --accuracy 0.05 --count 2 --tension-method centroid")
        .call("advise planar-example --task=-9,9,-4,16 --accuracy 0.005")
}

//! Studies: of the book, of the templates, and of machines with every effect.

use super::LAB;
use crate::group::Group;

const BOOK: &[&str] = &[
    "planar-circle",
    "planar-force-circle",
    "planar-force-control",
    "planar-force-tracking",
    "planar-initial-tension",
    "planar-low-calibrated",
    "planar-pulleys",
    "planar-small-circle",
    "planar-unloaded-3000",
    "planar-validation",
    "planar-wide-grid",
    "twin-compensated",
    "twin-elastostatic-nominal",
    "twin-kinematic-calibrated",
    "twin-nominal",
    "twin-winch-offsets",
];
/// Studies of all questions: small ones.
const ASKED: &[&str] =
    &["planar-wide-grid", "planar-pulleys", "planar-force-control", "planar-low-calibrated", "twin-nominal"];
const SWEEPS: &[&str] = &[
    "sweep-planar-anchor",
    "sweep-planar-force-control",
    "sweep-planar-pulleys",
    "sweep-planar-pulleys-soft",
    "sweep-planar-stiffness-four",
    "sweep-planar-tension-stiff",
];
const TEMPLATES: &[&str] = &["wall-plotter", "suspended-camera", "planar-frame", "box"];
const METHODS: &[&str] = &["closed-form", "improved-closed-form", "dykstra", "centroid", "minimum", "barrier"];

/// Groups.
pub(crate) fn groups() -> Vec<Group> {
    let templates = TEMPLATES.iter().map(|name| of_template(name));
    let large = [costs(), campaign(), sweeps(), wide_sweeps()];
    large.into_iter().chain([asked(), accuracy(), chain(), memory()]).chain(templates).collect()
}

fn accuracy() -> Group {
    BOOK.iter()
        .fold(Group::new("accuracy"), |group, study| group.call(&format!("accuracy {{studies}}/{study}.toml")))
        .calls("accuracy {studies}/planar-force-control.toml --tension-method %", METHODS)
        .call("accuracy {studies}/planar-wide-calibrated.toml --against {studies}/planar-wide-grid.toml")
        .call("accuracy {studies}/planar-disconnected.toml")
}

fn asked() -> Group {
    ASKED.iter().fold(Group::new("asked"), |group, study| {
        let file = format!("{{studies}}/{study}.toml");
        group
            .call_and_read(&format!("study {file} --out {study}"), &[&format!("{study}/errors.csv")])
            .call(&format!("reachable {file} --step 0.5 --accuracy 0.002,0.01,0.05 --linear"))
            .call(&format!("reachable {file} --method hull --rays 36"))
            .call(&format!("sensitivity {file} --robots 50"))
            .call(&format!("initial-tension {file} --stages 2"))
    })
    .call("reachable {studies}/planar-wide-grid.toml --method hull --rays 24 --vary 'machine frame-anchor[1].x' --change 0.01")
    .call("initial-tension {studies}/planar-small-circle.toml --target minimum")
    .call("sensitivity {studies}/twin-tolerances.toml --engine linear --robots 200")
    .call("sensitivity {studies}/twin-tolerances.toml --robots 20 --offsets set-anew --accuracy 0.004")
}

fn sweeps() -> Group {
    let all = SWEEPS.iter().fold(Group::new("sweeps"), |group, sweep| {
        group.call_and_read(
            &format!("sweep all {{studies}}/{sweep}.toml --out {sweep}"),
            &[&format!("{sweep}/result.csv")],
        )
    });
    all.call("sweep plan {studies}/sweep-planar-force-control.toml --out parts")
        .call("sweep run parts --shard 1/2")
        .call("sweep merge parts")
        .call("sweep run parts --shard 2/2")
        .call_and_read("sweep merge parts --quiet", &["parts/result.csv"])
}

fn wide_sweeps() -> Group {
    ["sweep-planar-stiffness", "sweep-planar-tension"].iter().fold(
        Group::new("wide-sweeps").whole_only(),
        |group, sweep| {
            group.call_and_read(
                &format!("sweep all {{studies}}/{sweep}.toml --out {sweep}"),
                &[&format!("{sweep}/result.csv")],
            )
        },
    )
}

fn costs() -> Group {
    let sweep = "sweep all {studies}/sweep-twin-cost.toml --out costs";
    Group::new("costs").whole_only().call_and_read(sweep, &["costs/result.csv"])
}

fn campaign() -> Group {
    Group::new("campaign").call("campaign {studies}/twin-campaign.toml --out rounds --seed 3")
}

fn chain() -> Group {
    Group::new("chain")
        .call("chain {studies}/twin-chain.toml")
        .call("chain {studies}/twin-chain.toml --region=-2,2,-2,2,0.75,2.75 --seed 5")
        .call("accuracy {studies}/planar-force-circle-identified.toml")
        .call("benchmark")
        .call("benchmark --robots planar-example,cogiro,cucablerobot --seed 2")
        .call("benchmark --robots cablerobot-simulator-helicopter --models standard,elastic")
}

/// A study of a machine with a law that remembers, or with drums.
fn memory() -> Group {
    let study = |model: &str, more: &str| {
        format!(
            "[control]\nrobot = \"lab.toml\"\nmodel = \"pulley\"\n[machine]\nrobot = \"lab.toml\"\nmodel = \"{model}\"\n\
             [initial]\npose = [0, 0, 1.25, 0, 0, 0]\ntension_method = \"qp\"\n[limits]\nposition_error_max_m = 0.02\n{more}\
             [poses.grid]\nmin = [-0.4, -0.3, 1, 0, 0, 0]\nmax = [0.4, 0.3, 1.5, 0.1, 0, 0]\ncount = [2, 2, 2, 2, 1, 1]\n\
             [noise]\nposition_m = 0.0005\nlength_m = 0.0002\n"
        )
    };
    let models = ["pulley+hysteresis", "pulley+polynomial", "pulley+drum+elastic", "pulley+elastic+catenary"];
    let start = Group::new("machines").write("lab.toml", LAB);
    let group = models.iter().fold(start, |group, model| {
        let file = format!("{}.toml", model.replace('+', "-"));
        group
            .write(&file, &study(model, ""))
            .call(&format!("accuracy {file}"))
            .call(&format!("sensitivity {file} --robots 10"))
    });
    group
        .write("remembers.toml", &study("pulley+hysteresis", "[history]\nreach = \"in-order\"\nsub_steps = 2\n"))
        .call("accuracy remembers.toml --stroke 0.05")
        .call("reachable pulley-polynomial.toml --step 0.8")
}

/// A folder of a template, and its machine with anchors that deviate.
fn of_template(name: &str) -> Group {
    Group::new(&format!("template-{name}"))
        .call(&format!("new {name} --out ."))
        .call("accuracy study.toml")
        .call_and_read("study study.toml --out errors", &["errors/errors.csv"])
        .call_and_read("simulate study.toml --out data.csv --seed 5", &["data.csv"])
        .call("reachable study.toml --step 0.5")
        .call("reachable study.toml --method hull --rays 40")
        .call("sensitivity study.toml --robots 20")
        .call("initial-tension study.toml --stages 2")
        .call("plan robot.toml --free frame-anchor --count 6 --study study.toml --out planned.csv")
        .call("plan robot.toml --model elastic --free frame-anchor,compliance --count 8 --study study.toml --criterion a --out more.csv --starts 5")
}

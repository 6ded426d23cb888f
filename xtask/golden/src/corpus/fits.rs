//! Fits: robots, models, objectives, losses and dirt. Calibrated robots are compared by the lengths that they command at ten poses.

use crate::dirt::Dirt;
use crate::group::Group;

/// A robot of a template, whose machine has other anchors.
struct Scene {
    template: &'static str,
    seed: u64,
    /// Ten poses off those of the study.
    poses: &'static str,
}

const CAMERA: Scene = Scene { template: "suspended-camera", seed: 11, poses: POSES_3T };
const BOX: Scene = Scene { template: "box", seed: 12, poses: POSES_3R3T };
const FRAME: Scene = Scene { template: "planar-frame", seed: 13, poses: POSES_1R2T };
const PLOTTER: Scene = Scene { template: "wall-plotter", seed: 14, poses: POSES_2T };

const POSES_2T: &str = include_str!("../../inputs/poses-2t.csv");
const POSES_3T: &str = include_str!("../../inputs/poses-3t.csv");
const POSES_1R2T: &str = include_str!("../../inputs/poses-1r2t.csv");
pub(super) const POSES_3R3T: &str = include_str!("../../inputs/poses-3r3t.csv");

const DIRT: &[(&str, Dirt)] = &[
    ("outliers", Dirt::Outliers),
    ("displaced", Dirt::DisplacedRow),
    ("offset", Dirt::Offset),
    ("scale", Dirt::Scale),
    ("unit", Dirt::WrongUnit),
    ("swapped", Dirt::SwappedCables),
    ("missing", Dirt::MissingRows),
    ("gaps", Dirt::Gaps),
    ("twice", Dirt::Twice),
    ("few", Dirt::First(5)),
    ("noisy", Dirt::NoisyPositions),
];

const PRIOR: &str = "--prior frame-anchor=0.02";

/// Groups.
pub(crate) fn groups() -> Vec<Group> {
    let mut groups = vec![choices_without_poses(), selections(), self_calibration(), elastic()];
    for scene in [CAMERA, BOX, FRAME, PLOTTER] {
        groups.extend([ways(&scene), dirty(&scene), others(&scene)]);
    }
    groups
}

impl Scene {
    /// Folder with robot, machine, measurements to fit and to judge by, and ten poses.
    fn start(&self, name: &str) -> Group {
        let Self { template, seed, poses } = self;
        let elastic = |robot: &str| format!("robot = \"{robot}.toml\"\nmodel = \"elastic\"");
        Group::new(&format!("{name}-{template}"))
            .prepare(&format!("new {template} --out ."))
            .deviate("robot.toml", "machine.toml", 0.015, *seed)
            .write("poses.csv", poses)
            .replace("study.toml", &elastic("robot"), &elastic("machine"))
            .prepare(&format!("simulate study.toml --out data.csv --seed {seed}"))
            .prepare(&format!("simulate study.toml --out judge.csv --seed {}", seed + 100))
    }
}

impl Group {
    /// A fit of the standard model, and the lengths at ten poses that its robot commands.
    fn fit(self, name: &str, words: &str) -> Self {
        self.fit_model(name, "standard", words)
    }

    /// A fit of a model, and the lengths at ten poses that its robot commands.
    pub(super) fn fit_model(self, name: &str, model: &str, words: &str) -> Self {
        let lengths = format!("{name}-lengths.csv");
        let export = format!("export lengths {name}.toml --poses poses.csv --model {model} --out {lengths}");
        self.call(&format!("identify robot.toml {words} --model {model} --out {name}.toml"))
            .call_and_read(&export, &[&lengths])
    }
}

/// Objectives, losses, costs, minimizers, priors, splits, and what is told beside a fit.
fn ways(scene: &Scene) -> Group {
    let plain = "data.csv --free frame-anchor,length-offset";
    let group = scene.start("ways").fit("plain", plain);
    let group = ["pose", "both"].iter().fold(group, |group, objective| {
        group.fit(&format!("by-{objective}"), &format!("{plain} --objective {objective} {PRIOR}"))
    });
    let group = ["huber", "cauchy", "squared"]
        .iter()
        .fold(group, |group, loss| group.fit(&format!("loss-{loss}"), &format!("{plain} --loss {loss}")));
    let group = ["mean", "max"]
        .iter()
        .fold(group, |group, cost| group.fit(&format!("least-{cost}"), &format!("{plain} --minimize {cost}")));
    group
        .calls(&format!("identify robot.toml {plain} --minimizer %"), &["gauss-newton", "dogleg", "trust-region"])
        .fit("prior", &format!("{plain} --prior frame-anchor=0.005"))
        .fit("held", &format!("{plain} --hold frame-anchor[1] --validation judge.csv"))
        .calls(&format!("identify robot.toml {plain} --split %"), &["blocks:4", "kfold:3", "region:2"])
        .call(&format!("identify robot.toml {plain} --compare-objectives --drive study.toml"))
        .call(&format!("identify robot.toml {plain} --course --scale auto"))
        .call_and_read(
            &format!(
                "identify robot.toml {plain} {PRIOR} --profile length-offset[1] --bootstrap 20 --uncertainty bands"
            ),
            &["bands/pose-bands.csv"],
        )
        .calls(&format!("identify robot.toml {plain} --path %"), &["ridge", "lasso", "group-lasso"])
        .call("evaluate plain.toml judge.csv")
        .call_and_read("evaluate plain.toml judge.csv --model elastic --out-errors errors.csv", &["errors.csv"])
}

/// Measurements spoilt in every way.
fn dirty(scene: &Scene) -> Group {
    let group = DIRT.iter().fold(scene.start("dirt"), |group, (name, dirt)| {
        let words = format!("{name}-data.csv --free frame-anchor,length-offset --prior frame-anchor=0.02");
        let group = group.spoil("data.csv", &format!("{name}-data.csv"), *dirt, scene.seed + 7);
        // these are refused
        match dirt {
            Dirt::WrongUnit | Dirt::Gaps => group.call(&format!("identify robot.toml {words}")),
            _ => group.fit(name, &words),
        }
    });
    group
        .call("identify robot.toml gaps-data.csv --free length-offset --skip-invalid")
        .call("identify robot.toml outliers-data.csv --free length-offset --loss cauchy --objective pose")
        .call("identify robot.toml few-data.csv --free frame-anchor,length-offset,length-scale")
        .calls("evaluate robot.toml %-data.csv", &["swapped", "unit", "scale"])
        .call("select robot.toml outliers-data.csv --candidates 'standard;standard:length-offset;standard:frame-anchor,length-offset'")
}

/// Corrections, plans with measurements given, and motions of tracker and marker.
fn others(scene: &Scene) -> Group {
    scene
        .start("others")
        .fit("plain", "data.csv --free frame-anchor,length-offset")
        .call("compensate plain.toml data.csv --out map.toml --split kfold:4")
        .call("evaluate plain.toml judge.csv --compensation map.toml")
        .call("plan robot.toml --free frame-anchor --count 3 --candidates judge.csv --given data.csv --criterion i --starts 4 --out next.csv")
        .call("plan robot.toml --free frame-anchor,length-offset --count 12 --candidates judge.csv --criterion e --starts 4 --out best.csv")
        .call("identify robot.toml data.csv --free length-offset,tracker-frame")
        .call("identify robot.toml data.csv --free frame-anchor,no-such")
        .call("select robot.toml data.csv --validation judge.csv")
}

fn selections() -> Group {
    let candidates = "--candidates 'standard;standard:length-offset;standard:frame-anchor,length-offset;elastic:frame-anchor,length-offset'";
    BOX.start("select")
        .call_and_read(&format!("select robot.toml data.csv {candidates} --out chosen"), &["chosen/candidates.csv"])
        .calls(&format!("select robot.toml data.csv {candidates} --criterion %"), &["rotation", "length", "tension"])
        .calls(&format!("select robot.toml data.csv {candidates} --split %"), &["blocks:3", "kfold:4", "region:3"])
        .call(&format!("select robot.toml data.csv {candidates} --validation judge.csv --require position_mean_m=0.0001"))
        .call(&format!("select robot.toml data.csv {candidates} --validation judge.csv --require position_mean_m=0.01 --regions 3"))
        .call("select robot.toml data.csv --candidates 'standard;standard:frame-anchor' --objective pose --prior frame-anchor=0.01")
        .call("export csv chosen --out tables")
        .call("export svg chosen --out figures")
}

fn self_calibration() -> Group {
    let group = CAMERA.start("poseless").spoil("data.csv", "lengths.csv", Dirt::NoPoses, 1);
    group
        .calls("identify robot.toml lengths.csv --free frame-anchor --gauge %", &["anchors", "least-change", "known"])
        .call_and_read(
            "identify robot.toml lengths.csv --free frame-anchor --known distance[1,2]=8.01+-0.002 --out-poses found.csv",
            &["found.csv"],
        )
        .call("identify robot.toml lengths.csv --free length-offset")
        .call("identify robot.toml lengths.csv --free frame-anchor,length-offset --prior frame-anchor=0.01")
        .call("evaluate robot.toml lengths.csv")
}

fn choices_without_poses() -> Group {
    CAMERA
        .start("poseless-choice")
        .whole_only()
        .spoil("data.csv", "lengths.csv", Dirt::NoPoses, 1)
        .call("select robot.toml lengths.csv")
}

fn elastic() -> Group {
    let anchors = "data.csv --free frame-anchor,compliance,wrench --prior frame-anchor=0.02";
    let group = BOX.start("elastic").spoil("data.csv", "no-tensions.csv", Dirt::NoTensions, 1);
    group
        .fit_model("anchors", "elastic", anchors)
        .fit_model("hidden", "elastic", "data.csv --free length-offset,hidden-length,compliance --prior hidden-length=0.5")
        .fit_model("cells", "elastic", "data.csv --free length-offset,tension-offset,tension-scale --prior tension-scale=0.02")
        .fit_model("by-pose", "elastic", "data.csv --free frame-anchor,length-offset --objective pose --prior frame-anchor=0.02")
        .calls(&format!("identify robot.toml {anchors} --model elastic --loss %"), &["huber", "cauchy"])
        .calls(&format!("identify robot.toml {anchors} --model elastic --minimizer %"), &["dogleg", "trust-region"])
        .call(&format!("identify robot.toml {anchors} --model elastic --row-weight length=1e4,wrench=1"))
        .call(&format!("identify robot.toml {anchors} --model elastic --split kfold:3 --starts 3"))
        .call(&format!("identify robot.toml {anchors} --model elastic --path lasso --shrink frame-anchor"))
        .call_and_read(
            &format!("identify robot.toml {anchors} --model elastic --profile compliance[1] --uncertainty bands"),
            &["bands/pose-bands.csv"],
        )
        .call("identify robot.toml no-tensions.csv --model elastic --free compliance")
        .call("evaluate anchors.toml judge.csv --model elastic")
        .call("compensate anchors.toml data.csv --model elastic --out map.toml")
        .call("plan robot.toml --model elastic --free frame-anchor,compliance --count 8 --candidates judge.csv --tension-levels 2 --starts 3 --out plan.csv")
}

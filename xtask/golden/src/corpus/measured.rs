//! Data of `../shared`: cases that went wrong once, and records of real machines. They are read, and never copied.

use crate::group::Group;

/// Cases: folder, and whether it has measurements to judge by.
const CASES: &[(&str, &str)] = &[
    ("01-metres-in-mm-columns-camera", ""),
    ("02-lefthanded-and-0.001-camera", ""),
    ("03-positions-in-feet-camera", ""),
    ("04-positions-in-feet-box", ""),
    ("06-tensions-in-kgf", ""),
    ("08-file-pasted-twice", ""),
    ("10-cable-reclamped", ""),
    ("11-payload-tripled-in-validation", "validation.csv"),
    ("12-other-day-offsets-10mm", "validation.csv"),
    ("13-corner", ""),
    ("15-encoder-stuck", ""),
    ("16-zyx-euler", ""),
    ("17-cables-from-0", ""),
    ("18-inches-in-one-column", ""),
    ("19-quoted-header-with-blanks", ""),
    ("20-clean-wall-plotter-false-alarm", ""),
    ("22-mirrored-camera", ""),
    ("23-underconstrained-clean-false-alarm", "validation.csv"),
    ("25-noisy-tracker-underfit", ""),
    ("26-cable-never-taut", ""),
    ("27-validation-is-training", "data.csv"),
    ("28-set-column-other-words", ""),
    ("29-frame-anchor-sigma", "validation.csv"),
];

/// Models of CASPR: folder, and first word of its files.
const CASPR: &[(&str, &str)] = &[
    ("2_DoF_VSD", "2_DoF_VSD"),
    ("CAROCA", "CAROCA"),
    ("CUCableRobot", "CUHK_CUCableRobot"),
    ("CoGiRo", "CoGiRo"),
    ("FAST", "FAST"),
    ("IPAnema_2", "IPAnema_2"),
    ("KNTU_planar", "KNTU_planar"),
    ("NIST_ROBOCRANE", "NIST_RoboCrane"),
    ("Passive_springs_planar", "Passive_springs_planar"),
];

/// Groups.
pub(crate) fn groups() -> Vec<Group> {
    let cases = CASES.iter().map(|(folder, validation)| of_case(folder, validation));
    [gear(), without_poses(), real()]
        .into_iter()
        .chain(cases)
        .chain([caspr(), trackers(), mural(), firmware()])
        .collect()
}

fn of_case(folder: &str, validation: &str) -> Group {
    let case = format!("{{shared}}/cases/{folder}");
    let data = format!("{case}/robot.toml {case}/data.csv");
    let judged = if validation.is_empty() { String::new() } else { format!(" --validation {case}/{validation}") };
    Group::new(&format!("case-{folder}"))
        .call(&format!("select {data}{judged}"))
        .call(&format!("identify {data} --free frame-anchor,length-offset{judged} --out calibrated.toml"))
        .call(&format!("evaluate {data}"))
}

fn gear() -> Group {
    let case = "{shared}/cases/07-selfcalibration-gear-5-percent-camera";
    Group::new("case-07")
        .whole_only()
        .call(&format!("identify {case}/robot.toml {case}/data.csv --free frame-anchor"))
        .call(&format!("identify {case}/robot.toml {case}/right-gear.csv --free length-offset"))
        .call(&format!("select {case}/robot.toml {case}/data.csv"))
}

fn without_poses() -> Group {
    let [belts, suspended, turned, homing] =
        ["maslow4-six-points", "self-calibration-suspended", "self-calibration-6dof", "three-cable-homing"]
            .map(|folder| format!("{{shared}}/cases/{folder}"));
    let helicopter = "cablerobot-simulator-helicopter-kinematic-calibrated";
    Group::new("cases-without-poses")
        .calls(
            &format!("identify {belts}/robot.toml {belts}/% --free frame-anchor --sigma length_m=0.0005"),
            &["data.csv", "data-ordinary.csv"],
        )
        .call(&format!("identify {belts}/robot.toml {belts}/data.csv --free frame-anchor --gauge least-change"))
        .call(&format!(
            "identify {suspended}/robot.toml {suspended}/data.csv --free length-offset --sigma length_m=0.0005"
        ))
        .call(&format!("evaluate {suspended}/robot.toml {suspended}/data-with-true-poses.csv"))
        .call(&format!("evaluate {helicopter} {turned}/poseless-one.csv"))
        .call(&format!("evaluate {helicopter} {turned}/poseless-20deg.csv"))
        .call(&format!("evaluate {homing}/robot.toml {homing}/data.csv"))
}

fn real() -> Group {
    let sets = "{shared}/data/measurements";
    let gtcable = format!("{{shared}}/data/robots/gtcable-planar.toml {sets}/gtcable-concentric-diamonds/samples.csv");
    let bed = format!("{sets}/hangprinter-hp4-bed/robot.toml {sets}/hangprinter-hp4-bed/known.csv");
    let probe = format!("{sets}/hangprinter-hp4-probe/robot.toml {sets}/hangprinter-hp4-probe/known.csv");
    let irma = format!("{{shared}}/data/robots/irma4u-mar25.toml {sets}/irma4u-selfcalib-8-final/static-poses.csv");
    Group::new("records")
        .call(&format!("evaluate {gtcable}"))
        .calls(&format!("identify {gtcable} --free %"), &["length-offset", "frame-anchor,length-offset"])
        .call(&format!("identify {gtcable} --free frame-anchor,length-offset --loss huber --split blocks:4"))
        .call(&format!("evaluate {bed}"))
        .call(&format!("identify {bed} --free frame-anchor,length-offset --prior frame-anchor=0.05"))
        .call(&format!("identify {probe} --free length-offset"))
        .call(&format!("evaluate {irma} --model pulley"))
        .call(&format!("identify {irma} --model pulley --free length-offset"))
}

fn caspr() -> Group {
    CASPR.iter().fold(Group::new("caspr"), |group, (folder, name)| {
        let files = format!("{{shared}}/data/caspr-xml/{folder}/{name}");
        group
            .call(&format!("import caspr {files}_bodies.xml {files}_cables.xml --out {folder}.toml"))
            .call(&format!("check {folder}.toml"))
    })
}

fn trackers() -> Group {
    let [far, inverse] = ["tracker-far", "tracker-inverse-pose"].map(|folder| format!("{{shared}}/cases/{folder}"));
    let sigma = "--sigma position_m=0.0005,rotation_rad=0.0003,length_m=0.0005";
    Group::new("trackers")
        .call(&format!("identify {far}/robot.toml {far}/data.csv --free length-offset,tracker-frame,marker-frame {sigma}"))
        .calls(
            &format!("identify {inverse}/robot.toml {inverse}/he-%.csv --free length-offset,tracker-frame,marker-frame {sigma}"),
            &["ok", "inv", "invpose", "wxyz"],
        )
}

fn mural() -> Group {
    let case = "{shared}/cases/mural-carriage";
    Group::new("mural")
        .calls(&format!("ik {case}/robot.toml --pose %"), &["0.3,-0.5,0", "0.65,-0.61,0", "0.3,-0.5,-0.414089"])
        .calls(&format!("fk {case}/robot.toml --lengths %"), &["0.549787,1.090615", "1.331337,0.916574"])
        .calls(&format!("accuracy {case}/%.toml"), &["study", "study43", "study44"])
}

fn firmware() -> Group {
    let robot = |case: &str| format!("{{shared}}/cases/{case}/robot.toml");
    let bed = "{shared}/data/measurements/hangprinter-hp4-bed/robot.toml";
    Group::new("firmware")
        .call_and_read(&format!("export klipper {} --out five.cfg", robot("hangprinter-5-anchors")), &["five.cfg"])
        .call(&format!("export reprapfirmware {} --out five.g", robot("hangprinter-5-anchors")))
        .call(&format!("export klipper {} --out beside.cfg", robot("klipper-offsets")))
        .call_and_read(&format!("export klipper {bed} --out bed.cfg"), &["bed.cfg"])
        .call_and_read(&format!("export reprapfirmware {bed} --out bed.g"), &["bed.g"])
}

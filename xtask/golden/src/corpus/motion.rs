//! Machines in time.

use super::LAB;
use crate::group::Group;

/// A plate in a vertical plane on four springs.
const PLATE: &str = include_str!("../../inputs/plate.toml");

/// Name, and lines of the scenario.
const EVENTS: &[(&str, &str)] = &[
    ("quiet", ""),
    ("cable-break", "[[event]]\ntime_s = 0.1\nkind = \"cable-break\"\ncable = 2\n"),
    ("winch-stop", "[[event]]\ntime_s = 0.1\nkind = \"winch-stop\"\ncable = 1\n"),
    ("slip", "[[event]]\ntime_s = 0.1\nkind = \"slip\"\ncable = 3\nlength_m = 0.01\n"),
    ("load", "[[event]]\ntime_s = 0.1\nkind = \"load\"\nmass_kg = 1.5\nposition_m = [0.05, 0]\n"),
    ("wrench", "[[event]]\ntime_s = 0.1\nkind = \"wrench\"\nwrench = [5, -3, 0.2]\n"),
];
const SENSORS: &str = "[sensors]\nseed = 4\nrate_Hz = 50\n[sensors.encoders]\nresolution_m = 2e-5\n[sensors.load_pins]\nnoise_N = 2\n\
                       [sensors.tracker]\nrate_Hz = 50\nposition_noise_m = 0.001\nrotation_noise_rad = 0.001\n";

/// Groups.
pub(crate) fn groups() -> Vec<Group> {
    vec![book(), plate(), lab()]
}

fn scenario(robot: &str, pose: &str, more: &str) -> String {
    format!(
        "[machine]\nrobot = \"{robot}\"\n{more}\n[time]\nduration_s = 0.3\nstep_s = 0.001\nrecord_s = 0.01\n[start]\npose = [{pose}]\n\
         tension_method = \"closed-form\"\n"
    )
}

fn book() -> Group {
    Group::new("runs-of-the-book")
        .call_and_read("run {studies}/scenario-cable-break.toml --out broken", &["broken/log.csv"])
        .call_and_read(
            "run {studies}/scenario-measuring.toml --out measured",
            &["measured/log.csv", "measured/measurements.csv"],
        )
        .call("evaluate {studies}/robots/simulator-in-motion.toml measured/measurements.csv --static --model elastic")
}

fn plate() -> Group {
    let start = Group::new("runs-of-a-plate").write("plate.toml", PLATE);
    let group = EVENTS.iter().fold(start, |group, (name, event)| {
        let text = scenario("plate.toml", "1.9, 1.4, 0", "cable_damping_N_s_per_m = 5.0");
        let text = text + "displacement = [0.02, 0, 0.03]\n" + event + SENSORS;
        group.write(&format!("{name}.toml"), &text).call_and_read(
            &format!("run {name}.toml --out {name}"),
            &[&format!("{name}/log.csv"), &format!("{name}/measurements.csv")],
        )
    });
    let changes = "[control]\nkind = \"length-changes\"\ntime_s = [0, 0.1, 0.3]\nlength_change_m = [[0, 0, 0, 0], [0.02, -0.01, 0, 0], [0.03, 0, -0.02, 0]]\n";
    let text = scenario("plate.toml", "1.9, 1.4, 0", "cable_damping_N_s_per_m = 5.0") + changes;
    let exact = text.replace("[time]\n", "[time]\nintegrator = \"error-controlled\"\ntolerance = 1e-7\n");
    group
        .write("changes.toml", &text)
        .call_and_read("run changes.toml --out changes", &["changes/log.csv"])
        .write("exact.toml", &exact)
        .call_and_read("run exact.toml --out exact", &["exact/log.csv"])
        .call("modes plate.toml --pose 1.9,1.4,0")
        .call("dynamics plate.toml --pose 1.9,1.4,0 --acceleration 0.5,0,0.1")
        .call("stiffness plate.toml --pose 1.9,1.4,0.1")
}

fn lab() -> Group {
    let models = ["elastic", "pulley+elastic", "pulley+hysteresis", "polynomial", "elastic+catenary"];
    let start = Group::new("runs-of-the-lab").write("lab.toml", LAB);
    let group = models.iter().fold(start, |group, model| {
        let file = model.replace('+', "-");
        let text = scenario("lab.toml", "0.1, 0, 1.3, 0, 0, 0.1", &format!("model = \"{model}\""));
        group
            .write(&format!("{file}.toml"), &(text + "displacement = [0.005, 0, 0.003, 0.01, 0, 0]\n"))
            .call_and_read(&format!("run {file}.toml --out {file}"), &[&format!("{file}/log.csv")])
    });
    let text = scenario("lab.toml", "0.1, 0, 1.3, 0, 0, 0.1", "model = \"elastic\"\nwinches = \"drums\"");
    let stop = "[[event]]\ntime_s = 0.1\nkind = \"winch-stop\"\ncable = 3\n";
    group
        .write(
            "drums.toml",
            &(text + "displacement = [0.005, 0, 0.003, 0.01, 0, 0]\n" + "[control]\nkind = \"torques\"\n" + stop),
        )
        .call_and_read("run drums.toml --out drums", &["drums/log.csv"])
}

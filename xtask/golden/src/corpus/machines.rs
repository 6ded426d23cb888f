//! Fits of machines with more than templates have: the dissertation's, pulleys and drums, cables on a test bench.

use super::LAB;
use super::fits::POSES_3R3T;
use crate::group::Group;

/// Groups.
pub(crate) fn groups() -> Vec<Group> {
    vec![twin(), laws(), test_bench(), frequency_response(), friction(), demo()]
}

/// The machine of the dissertation.
fn twin() -> Group {
    let kinematic = "identify cablerobot-simulator-helicopter kinematic.csv --free frame-anchor";
    let elastostatic = "identify cablerobot-simulator-helicopter elastostatic.csv --model elastic \
                        --free frame-anchor,platform-anchor,compliance,wrench";
    Group::new("twin")
        .prepare("simulate {studies}/twin-kinematic-measurements.toml --out kinematic.csv")
        .prepare("simulate {studies}/twin-elastostatic-measurements.toml --out elastostatic.csv --seed 2")
        .call_and_read(&format!("{kinematic} --loss squared --uncertainty bands"), &["bands/pose-bands.csv"])
        .call(&format!("{elastostatic} --prior platform-anchor=0.02 --out twin.toml"))
        .call("evaluate twin.toml kinematic.csv --model elastic")
        .call(elastostatic)
}

/// Pulleys and drums, whose numbers are free.
fn laws() -> Group {
    let study = |model: &str| {
        format!(
            "[control]\nrobot = \"lab.toml\"\nmodel = \"{model}\"\n[machine]\nrobot = \"machine.toml\"\nmodel = \"{model}\"\n\
             [initial]\npose = [0, 0, 1.25, 0, 0, 0]\noffset = \"none\"\n\
             [poses.grid]\nmin = [-0.5, -0.4, 0.9, 0, 0, 0]\nmax = [0.5, 0.4, 1.6, 0, 0, 0]\ncount = [3, 3, 3, 1, 1, 1]\n\
             [poses.random]\ncount = 10\nrotation_rad = [0.1, 0.1, 0.1]\n\
             [noise]\nposition_m = 0.0005\nrotation_rad = 0.0005\nlength_m = 0.0002\ntension_N = 2\n"
        )
    };
    let anchors = "--free frame-anchor --prior frame-anchor=0.02";
    Group::new("fits-of-laws")
        .write("robot.toml", LAB)
        .write("lab.toml", LAB)
        .write("poses.csv", POSES_3R3T)
        .deviate("lab.toml", "machine.toml", 0.005, 21)
        .write("pulleys.toml", &study("pulley"))
        .write("drums.toml", &study("pulley+drum"))
        .write("elastic.toml", &study("pulley+elastic"))
        .write("sag.toml", &study("elastic+catenary"))
        .prepare("simulate pulleys.toml --out pulleys.csv --seed 1")
        .prepare("simulate drums.toml --out drums.csv --seed 2 --motor-angles")
        .prepare("simulate elastic.toml --out elastic.csv --seed 3")
        .prepare("simulate sag.toml --out sag.csv --seed 4")
        .fit_model("pulleys", "pulley", "pulleys.csv --free frame-anchor,pulley-radius --prior frame-anchor=0.01,pulley-radius=0.002")
        .fit_model("swivels", "pulley", "pulleys.csv --free frame-anchor,swivel-axis --prior frame-anchor=0.01,swivel-axis=0.02")
        .fit_model("drums", "pulley+drum", "drums.csv --free drum-radius,start-length --prior drum-radius=0.001")
        .fit_model("ideal", "pulley", "drums.csv --free drum-radius,start-length --prior drum-radius=0.001")
        .fit_model("elastic", "pulley+elastic", &format!("elastic.csv {anchors}"))
        .fit_model("sag", "elastic+catenary", &format!("sag.csv {anchors}"))
        .call("evaluate lab.toml elastic.csv --model pulley+hysteresis")
        .call("evaluate lab.toml elastic.csv --model pulley+polynomial")
        .call("select lab.toml elastic.csv --candidates 'standard:frame-anchor;pulley:frame-anchor;pulley+elastic:frame-anchor' --prior frame-anchor=0.02")
}

/// Two cycles of a stiffening cable with friction, by Bouc's and Wen's equation.
fn record() -> String {
    let mut text = "elongation_mm,tension_kN\n".to_owned();
    let (mut before, mut z) = (0.0, -1.0_f64);
    for row in 0..1204 {
        let (cycle, place) = (row / 301, f64::from(row % 301) / 300.0);
        let elongation: f64 = 30.0 * if cycle % 2 == 0 { place } else { 1.0 - place };
        let step: f64 = elongation - before;
        z = step.signum() + (z - step.signum()) * (-step.abs() / 2.0).exp();
        before = elongation;
        let elastic = 0.3 + 0.08 * elongation + 1.2e-4 * elongation.powi(3);
        text += &format!("{elongation:.6},{:.9}\n", elastic + z * (0.03 + 0.05 * elastic));
    }
    text
}

fn test_bench() -> Group {
    Group::new("test-bench")
        .write("record.csv", &record())
        .calls("test-bench record.csv --length 10 --pieces %", &["4", "6", "8"])
        .call("test-bench record.csv --length 2")
}

/// A lag of 20 ms and one of 5 ms, in succession, under a sum of sines, with scatter that is the same everywhere.
fn response() -> String {
    let mut text = "t_s,motor_torque_Nm,tension_N\n".to_owned();
    for row in 0..3000_u32 {
        let time = 0.005 * f64::from(row);
        let (mut told, mut said) = (0.0, 0.02 * f64::from(row * 7919 % 101) - 1.0);
        for k in 1..=60_u32 {
            let turn = std::f64::consts::PI * f64::from(k);
            let phase = turn * time + 0.7 * f64::from(k * k);
            let (slow, fast) = (0.02 * turn, 0.005 * turn);
            told += phase.cos();
            said += 5.0 * (phase - slow.atan() - fast.atan()).cos() / (1_f64.hypot(slow) * 1_f64.hypot(fast));
        }
        text += &format!("{time:.3},{told:.6},{said:.6}\n");
    }
    text
}

/// Plateaus of a winch under two loads, lifted and lowered, with friction that grows with the load and falls with speed.
fn plateaus(loads: &[f64], directions: &[f64]) -> String {
    let mut text = "motor_speed_rad_per_s,motor_torque_Nm,load_Nm\n".to_owned();
    let mut row = 0;
    for load in loads {
        for speed in [0.5_f64, 1.0, 2.0, 4.0, 8.0, 16.0] {
            for direction in directions {
                let friction = 0.04 + 0.05 * load + 8e-4 * speed + 0.03 * (-(speed / 1.5).powi(2)).exp();
                let shake = 1e-3 * (f64::from((row * 7919 + 13) % 101) / 50.0 - 1.0);
                row += 1;
                text +=
                    &format!("{},{:.6},{load}\n", direction * speed, 0.95 * load + 0.02 + direction * friction + shake);
            }
        }
    }
    text
}

fn frequency_response() -> Group {
    Group::new("frequency-response")
        .write("record.csv", &response())
        .call("frequency-response record.csv")
        .calls("frequency-response record.csv --orders %", &["1,0", "2,0", "2,0,delay"])
        .call("frequency-response record.csv --window 1 --coherence 0.9")
        .call("frequency-response record.csv --method sine")
}

fn friction() -> Group {
    Group::new("friction")
        .write("both.csv", &plateaus(&[0.2, 1.0], &[1.0, -1.0]))
        .write("one.csv", &plateaus(&[1.0], &[1.0, -1.0]))
        .write("lifting.csv", &plateaus(&[0.2, 1.0], &[1.0]))
        .calls("friction %", &["both.csv", "one.csv", "lifting.csv"])
        .call("friction one.csv both.csv")
}

fn demo() -> Group {
    Group::new("demo")
        .call("demo --out demo")
        .call("demo --out other --candidates 'standard:frame-anchor;elastic:frame-anchor,compliance,wrench' --seed 3")
        .call("export csv demo --out tables")
}

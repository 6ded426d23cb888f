//! `frequency-response`.

use std::f64::consts::TAU;
use std::fmt::Write;

use super::{cdpr_in, file_with};

/// Closed form of the drum on a cable: −3 dB at 12.00 Hz, peak gain and frequency (J = 1.37 kg·m², r = 0.1525 m, c = 27.37 N·m·s/rad, k = 147 kN/m).
const CUTOFF: f64 = 12.00;
const GAIN: f64 = 1.0 / 0.1525;

/// Twenty seconds of the tension above 2 kN of that drum under a sweep of the torque, by small steps of its equation, with a little noise.
pub(crate) fn record() -> String {
    let mut text = "t_s,motor_torque_Nm,tension_N\n".to_owned();
    let (inertia, r, friction, stiffness) = (1.37, 0.1525, 27.37, 147e3);
    let (step, inside) = (0.005, 50);
    let fine = step / f64::from(inside);
    let (mut angle, mut speed, mut random) = (0.0_f64, 0.0_f64, 1_u64);
    for row in 0..4000 {
        for k in 0..inside {
            // speeds stand in the middle of small steps, angles at their ends
            let time = f64::from(row * inside + k) * fine;
            let torque = 40.0 * sweep(time);
            speed += fine * (torque - stiffness * r * r * angle - friction * speed) / inertia;
            angle += fine * speed;
        }
        let time = f64::from(row + 1) * step;
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let noise = (random >> 33) as f64 / f64::from(1_u32 << 31) - 0.5;
        let torque = 305.0 + 40.0 * sweep(time);
        writeln!(text, "{time:.3},{torque:.6},{:.4}", 2000.0 + stiffness * r * angle + 20.0 * noise).unwrap();
    }
    text
}

/// From 0.5 to 40 Hz over 20 s, by equal factors in equal times.
fn sweep(time: f64) -> f64 {
    let rate = 80_f64.ln() / 20.0;
    (TAU * 0.5 * ((rate * time).exp() - 1.0) / rate).sin()
}

#[test]
fn cutoff_and_peak_of_a_record_are_those_of_the_closed_form() {
    let (folder, _) = file_with("record.csv", record().as_bytes());
    let run = cdpr_in(folder.path(), "frequency-response record.csv --format json");
    assert_eq!(run.exit_code, 0, "{}{}", run.stdout, run.stderr);
    let answer = run.json();
    let number = |key: &str| answer[key].as_f64().unwrap_or_else(|| panic!("no {key} in {answer}"));
    // what the task allows; an integration by steps of 0.1 ms adds 0.1 %
    assert!((number("cutoff_Hz") / CUTOFF - 1.0).abs() < 0.02, "{}", number("cutoff_Hz"));
    // 1/(2 ζ √(1 − ζ²)) times the gain at rest
    assert!((number("peak_gain") / (2.541 * GAIN) - 1.0).abs() < 0.02, "{}", number("peak_gain"));
    let model = &answer["model"];
    assert_eq!((model["poles"].as_array().unwrap().len(), model["zeros"].as_array().unwrap().len()), (2, 0), "{model}");
    assert!((model["gain"].as_f64().unwrap() / GAIN - 1.0).abs() < 0.02, "{model}");
    assert!((model["poles"][0]["damping"].as_f64().unwrap() - 0.200).abs() < 0.01, "{model}");
    let band = &answer["cutoff_band_Hz"];
    assert!(band[0].as_f64().unwrap() < number("cutoff_Hz") && number("cutoff_Hz") < band[1].as_f64().unwrap());
    let points = answer["points"].as_array().unwrap();
    assert!(
        points.len() > 50 && points.iter().all(|point| (0.0..=1.0).contains(&point["coherence"].as_f64().unwrap()))
    );
}

#[test]
fn words_begin_with_the_record_and_tell_band_cutoff_peak_and_poles() {
    let (folder, _) = file_with("record.csv", record().as_bytes());
    let run = cdpr_in(folder.path(), "frequency-response record.csv");
    assert!(run.stdout.starts_with("record.csv: motor_torque_Nm to tension_N"), "{}", run.stdout);
    for part in ["15 windows", "lowest trusted frequency", "cut-off: 1", "N per N·m", "2 poles, 0 zeros", "damping"] {
        assert!(run.stdout.contains(part), "{part} is not in {}", run.stdout);
    }
}

/// A record that ends below the cut-off, noise in place of an output, and the first seconds of a sweep: negative, with the reason, and without a cut-off.
#[test]
fn records_that_do_not_tell_a_cutoff_are_answered_by_why() {
    let whole = record();
    let rows: Vec<&str> = whole.lines().skip(1).collect();
    let table = |rows: &[&str]| format!("t_s,motor_torque_Nm,tension_N\n{}\n", rows.join("\n"));
    let noise = |row: &&str| {
        let fields: Vec<&str> = row.split(',').collect();
        let bits = fields[0].bytes().fold(7_u64, |sum, byte| sum.wrapping_mul(1_099_511_628_211) ^ u64::from(byte));
        format!("{},{},{}", fields[0], fields[1], bits.wrapping_mul(6_364_136_223_846_793_005) >> 40)
    };
    let noise: Vec<String> = rows.iter().map(noise).collect();
    let noise: Vec<&str> = noise.iter().map(String::as_str).collect();
    for (text, status, part) in [
        // 14 of 20 s: up to 10.7 Hz
        (table(&rows[..2800]), "not-identifiable", "cut-off lies above"),
        (table(&noise), "not-trusted", "noise hides the output"),
        // 6 s: up to 1.9 Hz, 1.3 Hz apart
        (table(&rows[..1200]), "not-identifiable", "too short"),
    ] {
        let (folder, _) = file_with("record.csv", text.as_bytes());
        let run = cdpr_in(folder.path(), "frequency-response record.csv --format json");
        let answer = run.json();
        assert_eq!((run.exit_code, answer["status"].as_str()), (1, Some(status)), "{answer}");
        assert!(answer["reason"].as_str().unwrap().contains(part), "{part} is not in {}", answer["reason"]);
        assert!(answer["cutoff_Hz"].is_null() && answer["peak_gain"].is_null(), "{answer}");
    }
}

#[test]
fn records_that_will_not_do_are_refused_with_their_line() {
    let whole = record();
    let gap: String =
        whole.lines().enumerate().filter(|(k, _)| !(300..310).contains(k)).map(|(_, l)| format!("{l}\n")).collect();
    let exchanged = {
        let mut lines: Vec<&str> = whole.lines().collect();
        lines.swap(50, 51);
        lines.join("\n")
    };
    for (text, more, code, part) in [
        (gap, "", "record::uneven", "record.csv:301:1"),
        (exchanged, "", "record::time-order", "out of order"),
        (whole.replace("motor_torque_Nm", "torque"), "", "csv::missing-column", "--input COLUMN"),
        (whole.replace("t_s", "t_min"), "", "csv::unknown-unit", "t_ms"),
        (whole.replacen(",305.6", ",abc", 1), "", "csv::not-a-number", "abc"),
        (whole.lines().take(40).map(|line| format!("{line}\n")).collect(), "", "record::too-few-rows", "64"),
        (whole.clone(), " --window 15", "record::too-few-windows", "at most 6.667 s"),
        (whole.clone(), " --method sine", "record::no-steps", "h1"),
        (whole.clone(), " --orders 1,2", "setting::value", "zeros"),
        (whole.clone(), " --coherence 2", "setting::value", "coherence"),
    ] {
        let (folder, _) = file_with("record.csv", text.as_bytes());
        let run = cdpr_in(folder.path(), &format!("frequency-response record.csv{more} --format json"));
        assert_eq!((run.exit_code, run.json()["code"].as_str()), (2, Some(code)), "{}", run.stderr);
        assert!(run.stderr.contains(part), "{part} is not in {}", run.stderr);
    }
}

#[test]
fn the_page_has_curves_poles_and_the_cutoff() {
    let (folder, _) = file_with("record.csv", record().as_bytes());
    let run = cdpr_in(folder.path(), "frequency-response record.csv --report page.html --format json");
    assert_eq!((run.exit_code, run.json()["report"].as_str()), (0, Some("page.html")), "{}", run.stderr);
    let page = std::fs::read_to_string(folder.path().join("page.html")).unwrap();
    for part in ["Cut-off at 1", "frequency in Hz", "class=\"band\"", "\u{2212}3 dB", "2 poles, 0 zeros", "damping"] {
        assert!(page.contains(part), "{part} is not in the page");
    }
}

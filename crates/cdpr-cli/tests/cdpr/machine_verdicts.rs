//! Verdicts on machines in time: broken limits, runs that end early or record too much, and stability in `modes`, `stiffness` and `fk` alike.

use std::path::Path;

use super::running::{PLATE, SCENARIO, folder};
use super::{cdpr_in, numbers, root};

/// A plate on cables of 3000 N/m whose anchors are one point: it turns freely about it, but for a mass that hangs below it (m).
fn turning(below: f64) -> String {
    let plate =
        ["[-0.2, 0.1]", "[0.2, 0.1]", "[0.2, -0.1]", "[-0.2, -0.1]"].iter().fold(PLATE.to_owned(), |text, anchor| {
            text.replace(&format!("platform_anchor_m = {anchor}"), "platform_anchor_m = [0.1, 0.05]")
        });
    plate.replace("center_of_mass_m = [0.02, 0.05]", &format!("center_of_mass_m = [0.1, {}]", 0.05 - below))
}

fn written(folder: &Path, name: &str) -> String {
    String::from_utf8_lossy(&std::fs::read(folder.join("out").join(name)).unwrap()).into_owned()
}

/// One row at the start and one at the end show nothing, the steps between them do: text, JSON, page, recording and exit code say the same.
#[test]
fn a_limit_broken_between_the_rows_is_told_everywhere() {
    let swing = SCENARIO.replace("record_s = 0.01", "record_s = 0.2").replace("time_s = 0.1\n", "time_s = 0.2\n");
    let swing = swing.replace("displacement = [0.02, 0, 0.03]", "twist = [0.8, 0, 0]");
    // cable 4 begins with 273 N, ends with 283 N, and has 307 N on the way
    let swing = swing.replace("tension_method = \"closed-form\"", "tensions_N = [256, 235, 257, 273]");
    let folder = folder(&swing);
    let narrow = PLATE.replace("tension_max_N = 500.0", "tension_max_N = 303.0");
    std::fs::write(folder.path().join("plate-in-motion.toml"), narrow).unwrap();
    let run = cdpr_in(folder.path(), "run scenario.toml --out out --format json");
    let answer = run.json_with(&["status", "reason", "violations", "warnings"]);
    assert_eq!((run.exit_code, answer["status"].as_str()), (1, Some("completed")), "{answer}");
    let violations = answer["violations"].as_array().unwrap();
    let worst = violations.iter().find(|one| one["limit"] == "tension_max_N").unwrap();
    assert_eq!(worst["worst_N"], answer["tension_max_N"], "{violations:?}");
    let within = |key: &str| worst[key].as_f64().unwrap();
    assert!(within("worst_N") > 303.0 && within("first_s") < 0.2 && within("duration_s") > 0.0, "{worst}");
    let words = worst["words"].as_str().unwrap();
    assert!(words.contains("above its 303 N"), "{words}");
    let first = violations[0]["words"].as_str().unwrap();
    for text in [answer["reason"].as_str().unwrap(), answer["warnings"][0].as_str().unwrap()] {
        assert!(text.contains(first), "{text}");
    }
    assert!(written(folder.path(), "log.mcap").contains(words));
    let page = written(folder.path(), "report.html");
    assert!(
        page.contains("class=\"verdict bad\"") && page.contains(words) && !page.contains("stay within their limits")
    );
    let text = cdpr_in(folder.path(), "run scenario.toml --out out");
    assert_eq!(text.exit_code, 1);
    assert!(
        text.stdout.contains("completed: limits are broken: ") && text.stdout.contains("tension_max_N = 303"),
        "{}",
        text.stdout
    );
}

/// The measuring scenario with tensions in the middle of the limits: cable 3 comes down to 733 N for 28 ms, which no row of the log shows, under a limit
/// of 1000 N. It answered `violations: []`, and "all tensions stay within their limits".
#[test]
fn the_733_newtons_of_the_measuring_scenario_break_a_limit() {
    let text = std::fs::read_to_string(root().join("studies/scenario-measuring.toml")).unwrap();
    let middle: Vec<&str> = text.lines().filter(|line| !line.starts_with("tensions_N")).collect();
    let text = middle.join("\n").replace("robots/simulator-in-motion.toml", "robot.toml");
    let folder = folder(&text.replace("duration_s = 76", "duration_s = 4"));
    // with the mass properties of eq. 6.30, with which it was told
    let robot = std::fs::read_to_string(root().join("studies/robots/simulator-in-motion.toml")).unwrap();
    let robot = robot
        .replace("mass_kg = 764.5", "mass_kg = 604.5")
        .replace("center_of_mass_m = [-0.08, 0.0, 0.0]", "center_of_mass_m = [-0.0869, -0.0493, 0.0]")
        .replace(
            "[[207.8, 0.0, 0.0], [0.0, 208.0, 0.0], [0.0, 0.0, 67.2]]",
            "[[117.0, 0.0, 0.0], [0.0, 121.0, 0.0], [0.0, 0.0, 62.5]]",
        );
    std::fs::write(folder.path().join("robot.toml"), robot).unwrap();
    let run = cdpr_in(folder.path(), "run scenario.toml --out out --format json");
    let answer = run.json();
    assert_eq!((run.exit_code, answer["violations"].as_array().unwrap().len()), (1, 1), "{}", answer["violations"]);
    let found = &answer["violations"][0];
    assert_eq!(
        (&found["limit"], &found["cable"], &found["limit_N"]),
        (&"tension_min_N".into(), &3.into(), &1000.0.into())
    );
    let near = |key: &str, expected: f64, by: f64| (found[key].as_f64().unwrap() - expected).abs() < by;
    assert!(
        near("worst_N", 733.27, 0.01) && near("first_s", 3.751, 1e-9) && near("duration_s", 0.028, 1e-9),
        "{found}"
    );
    let log = written(folder.path(), "log.csv");
    let column = log.lines().next().unwrap().split(',').position(|name| name == "tension_N_3").unwrap();
    let of_rows = log.lines().skip(1).map(|row| row.split(',').nth(column).unwrap().parse::<f64>().unwrap());
    assert!(of_rows.fold(f64::INFINITY, f64::min) > 1000.0, "a row shows it");
    let page = written(folder.path(), "report.html");
    assert!(page.contains("cable 3 down to 733.3 N, below its 1000 N") && !page.contains("stay within"));
}

/// A winch that reels in more than there is, and a spin of 1e6 N·m, end the run: `failed` with the reason, everywhere.
#[test]
fn a_run_that_cannot_go_on_fails_with_its_reason() {
    let control = "[control]\nkind = \"length-changes\"\ntime_s = [0, 0.2]\nlength_change_m = [[0, 0, 0, 0], [0, 0, 0, -3.0]]\n[time]";
    let reeled = SCENARIO.replace("[time]", control);
    let wrench = "kind = \"wrench\"\nwrench = [0, 0, 1e6]\n";
    let spun = SCENARIO.replace("kind = \"cable-break\"\ncable = 2\n", wrench);
    for (scenario, reason) in [(reeled, "cable 4 has no length left"), (spun, "rad within a step")] {
        let folder = folder(&scenario);
        let run = cdpr_in(folder.path(), "run scenario.toml --out out --format json");
        let answer = run.json_with(&["status", "reason", "final"]);
        assert_eq!((run.exit_code, answer["status"].as_str()), (1, Some("failed")), "{answer}");
        assert!(answer["reason"].as_str().unwrap().contains(reason), "{answer}");
        assert!(numbers(&answer["final"]["cable_lengths_m"]).iter().all(|length| *length > 0.0), "{answer}");
        let page = written(folder.path(), "report.html");
        assert!(page.contains(reason) && page.contains("class=\"verdict bad\""), "{reason}");
    }
}

/// 20 000 s with a row a millisecond are twenty million rows: refused before the first, with a record that would do.
#[test]
fn a_run_that_records_too_much_is_refused_before_it() {
    let long =
        SCENARIO.replace("duration_s = 0.2", "duration_s = 20000").replace("record_s = 0.01", "record_s = 0.001");
    let folder = folder(&long);
    let run = cdpr_in(folder.path(), "run scenario.toml --out out --format json");
    assert_eq!(run.exit_code, 2, "{}", run.stderr);
    let answer = run.json();
    assert_eq!(answer["code"], "run::volume");
    assert!(answer["reason"].as_str().unwrap().contains("2.00 × 10⁷ rows"), "{answer}");
    assert!(!folder.path().join("out").exists());
    let help = answer["help"].as_str().unwrap();
    let record = help.split("record_s, as ").nth(1).unwrap().split(',').next().unwrap();
    assert!(help.contains("--yes"), "{help}");
    // a platform that spins too fast ends at once what is not refused
    let ended = |text: &str, options: &str| {
        let spinning = text.replace("displacement = [0.02, 0, 0.03]", "twist = [0, 0, 5000]");
        std::fs::write(folder.path().join("scenario.toml"), spinning).unwrap();
        cdpr_in(folder.path(), &format!("run scenario.toml --out out {options}")).exit_code
    };
    let mended = long.replace("record_s = 0.001", &format!("record_s = {record}"));
    assert_eq!([ended(&long, ""), ended(&long, "--yes"), ended(&mended, "")], [2, 1, 1]);
}

/// Events behind the end and inertias that no body has are warnings in text, JSON and page.
#[test]
fn what_never_happens_and_what_cannot_be_is_warned_of() {
    let late = "[[event]]\ntime_s = 5.0\nkind = \"winch-stop\"\ncable = 3\n[time]";
    let folder = folder(&SCENARIO.replace("[time]", late));
    let run = cdpr_in(folder.path(), "run scenario.toml --out out --format json").json();
    let warning = "the event winch-stop of cable 3 at 5 s never happens: the run ends at 0.2 s";
    assert!(run["warnings"].as_array().unwrap().iter().any(|one| one.as_str().unwrap().starts_with(warning)), "{run}");
    assert!(written(folder.path(), "report.html").contains(warning));
    assert!(cdpr_in(folder.path(), "run scenario.toml --out out").stdout.contains(&format!("caution: {warning}")));
    // principal moments of 10, 20 and 67.2 kg·m²
    let robot = std::fs::read_to_string(root().join("studies/robots/simulator-in-motion.toml")).unwrap();
    let thin = robot.replace("[[207.8, 0.0, 0.0], [0.0, 208.0, 0.0]", "[[10.0, 0.0, 0.0], [0.0, 20.0, 0.0]");
    assert_ne!(robot, thin);
    std::fs::write(folder.path().join("thin.toml"), thin).unwrap();
    let scenario =
        "[machine]\nrobot = \"thin.toml\"\n[start]\npose = [0, 0, 1.5, 0, 0, 0]\n[time]\nduration_s = 0.01\n";
    std::fs::write(folder.path().join("scenario.toml"), scenario).unwrap();
    for command in ["run scenario.toml --out out", "modes thin.toml --pose 0,0,1.5,0,0,0", "check thin.toml"] {
        let text = cdpr_in(folder.path(), command).prose();
        assert!(text.contains("moments of inertia of 10.00, 20.00 and 67.20 kg·m²"), "{command}: {text}");
        let json = cdpr_in(folder.path(), &format!("{command} --format json")).json();
        assert!(json["warnings"].to_string().contains("triangle rule"), "{command}: {json}");
    }
}

/// Tensions that do not balance the load: `modes` warns as `stiffness` does, in text and JSON.
#[test]
fn modes_out_of_balance_are_warned_of_as_stiffness_is() {
    let folder = folder(SCENARIO);
    for command in ["modes", "stiffness"] {
        let ask = |tensions: &str, format: &str| {
            let asked =
                format!("{command} plate-in-motion.toml --pose 1.9,1.4,0 --tensions {tensions} --format {format}");
            cdpr_in(folder.path(), &asked)
        };
        let text = ask("300,100,100,100", "text").stdout;
        assert!(text.lines().nth(1).unwrap().starts_with("warning: the tensions do not balance the load"), "{text}");
        let json = ask("300,100,100,100", "json").json();
        assert!(json["warnings"][0].as_str().unwrap().contains("are missing"), "{json}");
        let found = cdpr_in(folder.path(), "tension plate-in-motion.toml --pose 1.9,1.4,0 --format json").json();
        let words: Vec<String> = numbers(&found["tensions_N"]).iter().map(f64::to_string).collect();
        assert_eq!(ask(&words.join(","), "json").json()["warnings"], serde_json::json!([]), "{command}");
    }
}

/// A plate that turns freely about one point, and one whose mass hangs a nanometre below it (4e-6 N/m beside 12 000 N/m), are indifferent in all three
/// commands; a millimetre below the point is stable, above it unstable.
#[test]
fn a_stiffness_that_counts_as_none_is_indifferent_in_all_commands() {
    let folder = tempfile::tempdir().unwrap();
    for (below, expected) in [(0.0, "indifferent"), (1e-9, "indifferent"), (1e-3, "stable"), (-1e-3, "unstable")] {
        std::fs::write(folder.path().join("robot.toml"), turning(below)).unwrap();
        let ask = |command: &str| {
            let run = cdpr_in(folder.path(), &format!("{command} --format json"));
            assert_eq!(
                run.exit_code,
                i32::from(!command.starts_with("ik") && expected != "stable"),
                "{command} {below}: {}",
                run.stderr
            );
            run.json()
        };
        // by hand: 2 · 0.6 (140.875 − 100) N carry 5 kg
        let pose = "robot.toml --pose 1.9,1.45,0 --tensions 100,100,140.875,140.875";
        for command in ["modes", "stiffness"] {
            let answer = ask(&format!("{command} {pose}"));
            assert_eq!(answer["status"], expected, "{command} {below}: {}", answer["reason"]);
            assert_eq!(answer["warnings"], serde_json::json!([]), "{command} {below}");
        }
        let lengths: Vec<String> = numbers(&ask(&format!("ik {pose} --model elastic"))["controlled_lengths_m"])
            .iter()
            .map(f64::to_string)
            .collect();
        // an unstable equilibrium is left for a stable one
        if expected != "unstable" {
            let found =
                ask(&format!("fk robot.toml --model elastic --guess 1.9,1.45,0 --lengths {}", lengths.join(",")));
            assert_eq!(found["stability"], expected, "fk {below}: {}", found["reason"]);
        }
    }
}

//! `cdpr compensate` and the maps that it writes; `cdpr benchmark`; what accuracy costs.

use std::fmt::Write;

use super::{cdpr_in, numbers, root};

/// Samples of the planar example with a smooth error of every length, or noise in its place.
fn samples(is_smooth: bool) -> String {
    let mut text = "x_m,y_m,cable_length_m_1,cable_length_m_2,cable_length_m_3,cable_length_m_4\n".to_owned();
    let anchors = [(-6.0, 8.0), (5.0, 8.0), (-5.0, 0.0), (5.0, 0.5)];
    let mut state = 12345_u64;
    for k in 0..49 {
        let (x, y) = (f64::from(k % 7) - 3.0, 2.0 + 0.7 * f64::from(k / 7));
        write!(text, "{x},{y}").unwrap();
        for (cable, (a, b)) in anchors.iter().enumerate() {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let noise = (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5;
            let error = if is_smooth { 0.01 * (0.4 * x + cable as f64).sin() + 1e-4 * noise } else { 0.01 * noise };
            write!(text, ",{}", f64::hypot(a - x, b - y) + error).unwrap();
        }
        text.push('\n');
    }
    text
}

/// A smooth error is corrected on samples held out and in `evaluate`, lengths of `ik` have it; noise, poses beyond and other models are refused.
#[test]
fn maps_correct_smooth_errors_and_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    for (name, is_smooth) in [("smooth.csv", true), ("noise.csv", false)] {
        std::fs::write(folder.path().join(name), samples(is_smooth)).unwrap();
    }
    let run = cdpr_in(folder.path(), "compensate planar-example smooth.csv --out map.toml --format json");
    assert_eq!(run.exit_code, 0, "{} {}", run.stdout, run.stderr);
    let answer = run.json();
    let mean = |answer: &serde_json::Value| answer["position_error_m"]["mean"].as_f64().unwrap();
    assert_eq!((answer["status"].as_str(), answer["samples"].as_u64()), (Some("helps"), Some(49)));
    let (with, without) = (mean(&answer["held_out"]["with"]), mean(&answer["held_out"]["without"]));
    assert!(with < 0.1 * without, "{with} {without}");
    let alone = cdpr_in(folder.path(), "evaluate planar-example smooth.csv --format json").json();
    let mapped =
        cdpr_in(folder.path(), "evaluate planar-example smooth.csv --compensation map.toml --format json").json();
    assert!(mean(&mapped) < 0.05 * mean(&alone), "{} {}", mean(&mapped), mean(&alone));
    assert_eq!((&mapped["compensation"]["file"], &mapped["compensation"]["outside"]), (&"map.toml".into(), &0.into()));
    let ik = cdpr_in(folder.path(), "ik planar-example --pose 0.5,4 --compensation map.toml --format json").json();
    let [lengths, correction, corrected] =
        ["controlled_lengths_m", "correction_m", "corrected_lengths_m"].map(|key| numbers(&ik[key]));
    for cable in 0..4 {
        let smooth = 0.01 * (0.4 * 0.5 + cable as f64).sin();
        assert!((correction[cable] - smooth).abs() < 2e-4, "{correction:?}");
        assert!((corrected[cable] - lengths[cable] - correction[cable]).abs() < 1e-12);
    }
    for (arguments, code) in [
        ("ik planar-example --pose 4.5,4 --compensation map.toml", "compensation::outside"),
        ("ik planar-example --model elastic --pose 0.5,4 --compensation map.toml", "compensation::other-model"),
        ("evaluate planar-example-calibrated smooth.csv --compensation map.toml", "compensation::other-model"),
    ] {
        let run = cdpr_in(folder.path(), &format!("{arguments} --format json"));
        assert_eq!((run.exit_code, run.json()["code"].as_str()), (2, Some(code)), "{arguments}: {}", run.stdout);
    }
    let broken = std::fs::read_to_string(folder.path().join("map.toml"))
        .unwrap()
        .replace("layout_version = 1", "layout_version = 2");
    std::fs::write(folder.path().join("broken.toml"), broken).unwrap();
    let run = cdpr_in(folder.path(), "ik planar-example --pose 0.5,4 --compensation broken.toml --format json");
    assert_eq!((run.exit_code, run.json()["code"].as_str()), (2, Some("compensation::file")));
    let noise = cdpr_in(folder.path(), "compensate planar-example noise.csv --out none.toml --format json");
    assert_eq!((noise.exit_code, noise.json()["status"].as_str()), (1, Some("no-help")), "{}", noise.stdout);
    assert!(!folder.path().join("none.toml").exists() && noise.json()["reason"].as_str().unwrap().contains("noise"));
}

/// Rows of every robot and model beside those that are printed; the same files on any number of threads.
#[test]
fn robots_stand_beside_what_is_printed_of_real_machines() {
    let folder = tempfile::tempdir().unwrap();
    let of = |out: &str, threads: usize| {
        let robots = "planar-example,cablerobot-simulator-helicopter,ipanema-1";
        cdpr_in(folder.path(), &format!("benchmark --robots {robots} --out {out} --threads {threads} --format json"))
    };
    let (run, other) = (of("one", 1), of("two", 2));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json();
    let rows = answer["rows"].as_array().unwrap();
    let names: Vec<String> =
        rows.iter().map(|row| format!("{} {}", row["robot"], row["model"]).replace('"', "")).collect();
    assert!(
        names.contains(&"planar-example elastic".to_owned()) && names.contains(&"ipanema-1 standard".to_owned()),
        "{names:?}"
    );
    let printed = answer["printed"].as_array().unwrap();
    assert!(
        printed
            .iter()
            .any(|one| one["machine"].as_str().unwrap().contains("IPAnema") && one["position_mean_m"] == 0.0414)
    );
    assert!(printed.iter().any(|one| one["position_mean_m"] == 0.0398));
    assert!((printed[1]["rotation_mean_rad"].as_f64().unwrap().to_degrees() - 1.9).abs() < 1e-12);
    assert_eq!(answer["rows"], other.json()["rows"]);
    let read = |out: &str, name: &str| std::fs::read_to_string(folder.path().join(out).join(name)).unwrap();
    assert_eq!(read("one", "result.csv"), read("two", "result.csv"));
    assert_eq!(read("one", "result.csv").lines().count(), 1 + rows.len() + printed.len());
    let columns: std::collections::BTreeSet<usize> = read("one", "result.csv").lines().map(fields).collect();
    assert_eq!(columns.len(), 1, "every row has as many cells: {columns:?}");
    let page = read("one", "report.html");
    assert!(page.contains("IPAnema, unladen") && page.contains("<svg") && page.contains("Rules"));
    let none = cdpr_in(folder.path(), "benchmark --robots planar-example --models pulley+catenary --format json");
    assert_eq!((none.exit_code, none.json()["status"].as_str()), (1, Some("nothing")), "{}", none.stdout);
}

/// Cells of a row, commas in quotes not counted.
fn fields(line: &str) -> usize {
    1 + line.split('"').step_by(2).map(|plain| plain.matches(',').count()).sum::<usize>()
}

/// A sweep over calibrations in shards: the cheapest within an accuracy in words, the same as at once.
#[test]
fn the_cheapest_calibration_within_an_accuracy_is_told() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::copy(root().join("studies/twin-measurements.toml"), folder.path().join("twin-measurements.toml")).unwrap();
    let text = std::fs::read_to_string(root().join("studies/sweep-twin-cost.toml")).unwrap();
    let text = text.replace("[15, 30, 60, 90]", "[20, 60]").replace("records = 3", "records = 1");
    std::fs::write(folder.path().join("cost.toml"), text).unwrap();
    let run = |arguments: &str| {
        let run = cdpr_in(folder.path(), &format!("sweep {arguments} --format json"));
        assert_eq!(run.exit_code, 0, "{arguments}: {} {}", run.stdout, run.stderr);
        run.json()
    };
    run("plan cost.toml --out cost");
    assert_eq!(run("run cost --shard 2/2")["computed"], 6);
    assert_eq!(run("run cost")["already_there"], 6);
    let merged = run("merge cost");
    let rows = merged["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 12);
    let cheapest = merged["cheapest"].as_array().unwrap();
    let of = |place: usize| (cheapest[place]["point"].as_u64(), cheapest[place]["words"].as_str().unwrap());
    // 10 mm without a sensor of poses and by kinematics, 1 mm by the elastic model alone
    let (ten, one) = (of(0), of(3));
    let row = |point: Option<u64>| &rows[point.unwrap() as usize];
    assert_eq!(row(ten.0)["sensor"], "none", "{ten:?}");
    assert!(row(ten.0)["validation_position_m"].is_null() && row(ten.0)["validation_length_m"].is_number());
    assert_eq!(row(one.0)["model"], "elastic", "{one:?}");
    assert!(one.1.starts_with("for 1 mm: ") && one.1.contains("at a price of"), "{one:?}");
    for (place, accuracy) in [0.01, 0.005, 0.002, 0.001].into_iter().enumerate() {
        let price = |row: &&serde_json::Value| row["price"].as_f64().unwrap();
        let within =
            rows.iter().filter(|row| row["driven_position_m"].as_f64().is_some_and(|driven| driven <= accuracy));
        let least = within.map(|row| price(&row)).fold(f64::INFINITY, f64::min);
        assert_eq!(cheapest[place]["price"].as_f64(), Some(least), "{accuracy}");
    }
    // who measures no poses has tensions, which contradict the lengths of cables that do not stretch: these are calibrated by lengths alone, with tensions they drove 11 to 13 mm
    let driven = |row: usize| (rows[row]["sensor"].as_str(), rows[row]["driven_position_m"].as_f64().unwrap());
    assert_eq!((driven(9).0, driven(11).0), (Some("none"), Some("none")));
    assert!(
        driven(11).1 < 0.6 * driven(9).1 && driven(9).1 < 0.0095,
        "elastic {:?}, standard {:?}",
        driven(11),
        driven(9)
    );
    let read = |name: &str| std::fs::read_to_string(folder.path().join("cost").join(name)).unwrap();
    assert!(read("result.svg").contains("poses measured") && read("result.csv").lines().count() == 13);
}

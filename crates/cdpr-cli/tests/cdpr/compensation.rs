//! `cdpr compensate` and the maps that it writes; `cdpr benchmark`; what accuracy costs.

use std::fmt::Write;

use super::{cdpr_in, numbers, root};

/// Samples of the planar example with a smooth error of every length, or noise in its place.
pub(super) fn samples(is_smooth: bool) -> String {
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

/// A study drives with the map of its controller and says what it would be without; who changes the controller refuses it.
#[test]
fn studies_drive_with_the_map_of_their_controller() {
    let folder = tempfile::tempdir().unwrap();
    let study = root().join("studies/twin-compensated.toml");
    let run = |arguments: &str| cdpr_in(folder.path(), &format!("{arguments} --format json"));
    let answer = |arguments: &str| {
        let run = run(arguments);
        assert_eq!(run.exit_code, 0, "{arguments}: {}", run.stderr);
        run.json()
    };
    let mean = |answer: &serde_json::Value| answer["position_error_m"]["mean"].as_f64().unwrap();
    let accuracy = answer(&format!("accuracy {}", study.display()));
    let (with, map) = (mean(&accuracy), &accuracy["compensation"]);
    // as studies/README.md has them
    assert!((with - 0.001).abs() < 5e-6 && (mean(&map["without"]) - 0.00417).abs() < 5e-6, "{with} {map}");
    let told = format!("{} of 80 poses lie beyond", map["outside"]);
    assert!(map["outside"] == 0 || accuracy["warnings"].to_string().contains(&told), "{}", accuracy["warnings"]);
    assert!(accuracy["control"].as_str().unwrap().ends_with("corrected by maps/twin-kinematic.toml"), "{accuracy}");
    let words = cdpr_in(folder.path(), &format!("accuracy {}", study.display())).stdout;
    assert!(words.contains("with its map positions are missed by 0.999 instead of 4.170 mm"), "{words}");
    let whole = answer(&format!("study {} --out whole", study.display()));
    assert_eq!((mean(&whole), mean(&whole["compensation"]["without"])), (with, mean(&map["without"])));
    let page = std::fs::read_to_string(folder.path().join("whole/report.html")).unwrap();
    assert!(page.contains("Without its map the control model misses by") && page.contains("corrected by"));
    // the record of a machine that is driven with the map has what was sent
    let text = std::fs::read_to_string(&study).unwrap();
    let maps = root().join("studies/maps").display().to_string();
    let limits = "[limits]\nposition_error_max_m = 0.003\n[campaign]\nfree = \"frame-anchor\"\nposes_per_round = 9\n";
    let own = format!("{}\n{limits}", text.replace("\"maps/", &format!("\"{maps}/")));
    std::fs::write(folder.path().join("own.toml"), &own).unwrap();
    std::fs::write(folder.path().join("alone.toml"), own.replace("compensation", "# compensation")).unwrap();
    let [own, alone] = ["own", "alone"].map(|name| answer(&format!("simulate {name}.toml --out {name}.csv")));
    assert!(own["control"].as_str().unwrap().contains("corrected by") && alone.get("control").is_none());
    let [own, alone] = ["own", "alone"].map(|name| {
        let table = std::fs::read_to_string(folder.path().join(name).with_extension("csv")).unwrap();
        table.lines().nth(1).unwrap().split(',').map(|cell| cell.parse::<f64>().unwrap()).collect::<Vec<_>>()
    });
    let apart = own[7..15].iter().zip(&alone[7..15]).map(|(own, alone)| (own - alone).abs()).fold(0.0, f64::max);
    assert!(apart > 1e-3, "{apart}");
    // more is reached within 3 mm, and without the map what a study without one reaches
    let bounds = "--bounds=-1.2,1.2,-1.2,1.2,1.3,1.9 --step 0.6";
    let [own, alone] = ["own", "alone"].map(|name| answer(&format!("reachable {name}.toml {bounds}")));
    let size = |answer: &serde_json::Value| answer["reachable_volume_m3"].as_f64().unwrap();
    assert!(size(&own) > 1.2 * size(&alone), "{} {}", size(&own), size(&alone));
    assert_eq!(size(&own["compensation"]["without"]), size(&alone));
    std::fs::write(
        folder.path().join("sweep.toml"),
        "study = \"own.toml\"\nposition_error_max_m = [0.01]\nstep_m = 1.0\n[[parameter]]\nkey = \"study.limits.position_error_max_m\"\nvalues = [0.003, 0.004]\n",
    )
    .unwrap();
    for refused in [
        "sensitivity own.toml",
        "initial-tension own.toml",
        "campaign own.toml --out rounds",
        "chain own.toml",
        "sweep plan sweep.toml --out swept",
        "identify cablerobot-simulator-helicopter own.csv --free frame-anchor --drive own.toml",
    ] {
        let run = run(refused);
        let answer = run.json();
        assert_eq!(
            (run.exit_code, answer["code"].as_str()),
            (2, Some("study::compensation")),
            "{refused}: {}",
            run.stdout
        );
        assert!(answer["reason"].as_str().unwrap().contains("cannot take a map: "), "{refused}: {}", run.stdout);
    }
}

/// Lengths with their correction go to a controller as a table, which leads back to the poses; formats without a place for a map refuse it.
#[test]
fn tables_of_lengths_have_the_map_and_lead_back() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("smooth.csv", &samples(true));
    write("poses.csv", "x_m,y_m\n0.5,4\n-1.3,3.1\n2.2,5.4\n");
    write("beyond.csv", "x_m,y_m\n0.5,4\n4.5,4\n");
    let run = |arguments: &str| cdpr_in(folder.path(), &format!("{arguments} --format json"));
    assert_eq!(run("compensate planar-example smooth.csv --out map.toml").exit_code, 0);
    let table = run("export lengths planar-example --poses poses.csv --compensation map.toml --out table.csv");
    assert_eq!(table.exit_code, 0, "{}", table.stderr);
    let ik = run("ik planar-example --pose -1.3,3.1 --compensation map.toml").json();
    assert_eq!(table.json()["cable_lengths_m"][1], ik["corrected_lengths_m"]);
    let errors = |answer: &serde_json::Value| {
        [answer["position_error_m"]["max"].as_f64().unwrap(), answer["length_error_m"]["max"].as_f64().unwrap()]
    };
    let with = errors(&run("evaluate planar-example table.csv --compensation map.toml").json());
    let without = errors(&run("evaluate planar-example table.csv").json());
    // turns of pose and correction end at a tenth of a nanometre
    assert!(with[0] < 1e-9 && with[1] < 1e-12 && without.iter().all(|error| *error > 1e-3), "{with:?} {without:?}");
    let elastic = cdpr_in(folder.path(), "export lengths planar-example --model elastic --poses poses.csv");
    assert_eq!(elastic.exit_code, 0, "{}", elastic.stderr);
    write("elastic.csv", &elastic.stdout);
    let read = run("evaluate planar-example elastic.csv --model elastic").json();
    assert!(errors(&read).iter().all(|error| *error < 1e-9) && read["tension_error_N"]["max"].as_f64().unwrap() < 1e-3);
    for (arguments, code) in [
        ("lengths planar-example --poses beyond.csv --compensation map.toml", "compensation::outside"),
        (
            "lengths planar-example --model elastic --poses poses.csv --compensation map.toml",
            "compensation::other-model",
        ),
        ("klipper planar-example --compensation map.toml", "usage::value"),
        ("svg result --compensation map.toml", "usage::value"),
        ("csv result --poses poses.csv", "usage::value"),
        ("reprapfirmware planar-example --model pulley", "usage::value"),
    ] {
        let refused = run(&format!("export {arguments}"));
        assert_eq!(
            (refused.exit_code, refused.json()["code"].as_str()),
            (2, Some(code)),
            "{arguments}: {}",
            refused.stdout
        );
    }
    assert!(
        run("export lengths planar-example --poses beyond.csv --compensation map.toml").stdout.contains("pose 2: ")
    );
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
    // a robot whose source prints no errors of a machine has nothing beside it
    let alone = cdpr_in(folder.path(), "benchmark --robots planar-example --models standard");
    assert!(!alone.stdout.contains("printed of real machines"), "{}", alone.stdout);
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

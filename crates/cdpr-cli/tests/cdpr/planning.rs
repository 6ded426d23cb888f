//! `cdpr plan`: designs against check values, reach, levels of tension, and what no plan can be made of.

use std::fmt::Write;

use super::{cdpr_in, numbers, root};

/// The 75 poses of sec. 6.1: z runs fastest, then y.
fn grid() -> String {
    let mut text = "x_m,y_m,z_m,qx,qy,qz,qw\n".to_owned();
    for (x, y) in [-1.5, -0.75, 0.0, 0.75, 1.5].iter().flat_map(|x| [-1.5, -0.75, 0.0, 0.75, 1.5].map(|y| (x, y))) {
        [1.25, 1.625, 2.0].iter().for_each(|z| writeln!(text, "{x},{y},{z},0,0,0,1").unwrap());
    }
    text
}

const PLAN: &str = "plan cablerobot-simulator-helicopter --free frame-anchor --candidates grid.csv --out poses.csv";

/// C23: an independent computation. The file that is written is one of candidates and of studies again.
#[test]
fn the_best_eight_poses_are_the_corners() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("grid.csv"), grid()).unwrap();
    let run = cdpr_in(folder.path(), &format!("{PLAN} --count 8 --format json"));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json();
    let mut poses = numbers(&answer["poses"]);
    poses.sort_by(f64::total_cmp);
    assert_eq!(poses, [1.0, 3.0, 13.0, 15.0, 61.0, 63.0, 73.0, 75.0]);
    for (key, value, digits) in [
        ("log_det", -24.3330, 5e-5),
        ("condition", 20.2515, 5e-5),
        ("i_value", 0.26125, 5e-6),
        ("sigma_min", 0.13788, 5e-6),
    ] {
        assert!((answer[key].as_f64().unwrap() - value).abs() < digits, "{key}: {}", answer[key]);
    }
    assert!(answer["warnings"].to_string().contains("no accuracy of the sensors is stated"));
    let curve = answer["curve"].as_array().unwrap();
    assert!(curve.iter().any(|point| point["count"] == 8 && point["log_det"] == answer["log_det"]));
    let again = cdpr_in(
        folder.path(),
        "plan cablerobot-simulator-helicopter --free frame-anchor --candidates poses.csv --count 8 --out again.csv --format json",
    );
    assert_eq!(numbers(&again.json()["poses"]).len(), 8);
    assert!((again.json()["log_det"].as_f64().unwrap() + 24.3330).abs() < 5e-5);
    let one = cdpr_in(folder.path(), &format!("{PLAN} --count 16 --threads 1 --format json"));
    let two = cdpr_in(folder.path(), &format!("{PLAN} --count 16 --threads 2 --format json"));
    assert_eq!(one.stdout, two.stdout);
    assert!(one.json()["log_det"].as_f64().unwrap() >= -9.883_155);
    assert!(one.json()["grid"]["efficiency"].as_f64().unwrap() < 0.9);
}

/// Poses beyond the reach of a study's controller are left out; levels of tension join elastic ones; measured poses count.
#[test]
fn plans_know_reach_tensions_and_what_is_measured() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("grid.csv"), grid()).unwrap();
    let study = root().join("studies/planar-wide-grid.toml");
    let planar = format!("plan planar-example --free frame-anchor --study {}", study.display());
    let answer = cdpr_in(folder.path(), &format!("{planar} --count 4 --out poses.csv --format json")).json();
    assert_eq!((answer["candidates"].as_u64(), answer["left_out"].as_array().unwrap().len()), (Some(22), 3));
    assert!(answer["left_out"][0]["reason"].as_str().unwrap().contains("more than its largest tension"));
    let elastic = "plan cablerobot-simulator-helicopter-elastostatic-calibrated --model elastic --free compliance,frame-anchor --candidates grid.csv --starts 1 \
                   --sigma position_m=0.001,rotation_rad=0.001,length_m=0.0002,tension_N=50 --out levels.csv --format json";
    let of = |levels: usize| cdpr_in(folder.path(), &format!("{elastic} --count 12 --tension-levels {levels}")).json();
    let (one, three) = (of(1), of(3));
    assert!(
        three["log_det"].as_f64().unwrap() > one["log_det"].as_f64().unwrap() + 1.0,
        "{} {}",
        one["log_det"],
        three["log_det"]
    );
    let table = std::fs::read_to_string(folder.path().join("levels.csv")).unwrap();
    assert!(table.lines().next().unwrap().ends_with("tension_N_8") && table.lines().count() == 13);
    let tests = cdpr_in(folder.path(), &format!("{elastic} --count 12 --tension-tests 0.03")).json();
    assert!(tests["log_det"].as_f64().unwrap() > one["log_det"].as_f64().unwrap() + 1.0, "{}", tests["log_det"]);
    let shortened: Vec<&serde_json::Value> =
        tests["tension_tests"].as_array().unwrap().iter().filter(|test| !test.is_null()).collect();
    assert!(!shortened.is_empty() && shortened.iter().all(|test| test["shorten_m"] == 0.03));
    let table = std::fs::read_to_string(folder.path().join("levels.csv")).unwrap();
    assert_eq!(table.matches("tension-test-").count(), shortened.len());
    // tension tests of a study are candidates of elastic models
    let twin = root().join("studies/twin-measurements.toml");
    let study = elastic.replace("--candidates grid.csv", &format!("--study {}", twin.display()));
    let answer = cdpr_in(folder.path(), &format!("{study} --count 12")).json();
    assert!(answer["tension_tests"].as_array().is_some_and(|tests| tests.iter().any(|test| !test.is_null())));
    let measured = cdpr_in(folder.path(), &format!("{PLAN} --count 8")).exit_code;
    assert_eq!(measured, 0);
    let next = cdpr_in(
        folder.path(),
        &format!("{} --given poses.csv --count 1 --format json", PLAN.replace("--out poses", "--out next")),
    );
    assert!(next.json()["log_det"].as_f64().unwrap() > -24.3, "{}", next.stdout);
    assert_eq!(next.json()["given"], 8);
}

/// Cables that remember: the path tells the side from which every pose is come to.
#[test]
fn cables_that_remember_have_a_direction_of_approach() {
    let folder = super::studies::folder_with_hysteresis();
    let poses = "x_m,y_m\n-1,4\n1,4\n-1,6\n1,6\n0,5\n";
    std::fs::write(folder.path().join("grid.csv"), poses).unwrap();
    let run = cdpr_in(
        folder.path(),
        "plan robot.toml --model hysteresis --free frame-anchor --count 4 --candidates grid.csv --out poses.csv --format json",
    );
    let answer = run.json();
    let approach = answer["approach"].as_array().unwrap_or_else(|| panic!("{} {}", run.stdout, run.stderr));
    assert_eq!(approach.len(), 4);
    for direction in approach {
        let length: f64 = numbers(direction).iter().map(|own| own * own).sum();
        assert!((length - 1.0).abs() < 1e-12, "{direction}");
    }
    assert!(answer["warnings"].to_string().contains("the cables remember"));
}

/// Frame and platform anchors of a platform that never turns are open: exit code 1 with the reason.
#[test]
fn what_no_poses_tell_is_said() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("grid.csv"), grid()).unwrap();
    let open = PLAN.replace("frame-anchor ", "frame-anchor,platform-anchor ");
    let run = cdpr_in(folder.path(), &format!("{open} --count 20 --format json"));
    assert_eq!(run.exit_code, 1, "{}", run.stderr);
    let answer = run.json();
    assert_eq!((answer["status"].as_str(), answer["log_det"].is_null()), (Some("not-determined"), true));
    assert_eq!((answer["rank"].as_u64(), answer["parameter_count"].as_u64()), (Some(24), Some(48)));
    assert!(answer["weak_whatever_is_measured"].to_string().contains("together along x"));
    let known = cdpr_in(
        folder.path(),
        &format!("{open} --count 20 --prior platform-anchor=0.02 --sigma length_m=0.001 --format json"),
    );
    assert_eq!(known.exit_code, 0, "{}", known.stdout);
    for (arguments, code) in [
        ("--count 0", "plan::count"),
        ("--count 76", "plan::count"),
        ("--count 8 --tension-levels 2", "plan::tension-levels"),
        ("--count 8 --tension-tests 0.03", "plan::tension-levels"),
        ("--count 8 --prior frame-anchor=0.02", "plan::priors"),
        ("--count 8 --hold frame-anchor", "parameter::none-free"),
    ] {
        let run = cdpr_in(folder.path(), &format!("{PLAN} {arguments} --format json"));
        assert_eq!((run.exit_code, run.json()["code"].as_str()), (2, Some(code)), "{arguments}");
    }
    let drums =
        cdpr_in(folder.path(), &format!("{} --count 8 --format json", PLAN.replace("frame-anchor", "clock-offset")));
    assert_eq!(drums.json()["code"], "plan::parameter");
}

/// An elastic controller that a campaign of files asks for poses at levels of tension: the files of two rounds lead to what the machine's own records do.
#[test]
fn levels_of_tension_are_asked_of_files_too() {
    let folder = tempfile::tempdir().unwrap();
    let study = |record: &str| {
        format!(
            "[control]\nrobot = \"planar-example\"\nmodel = \"elastic\"\n[machine]\nrobot = \"planar-example-calibrated\"\nmodel = \"elastic\"\n\
             [initial]\npose = [0, 5.2]\noffset = \"none\"\n[limits]\ntension_min_N = 500\ntension_max_N = 9000\n[poses.grid]\nmin = [-1, 4]\n\
             max = [1, 6]\ncount = [3, 3]\n[noise]\nposition_m = 0.0005\nlength_m = 0.0002\ntension_N = 20\n[campaign]\nfree = \"frame-anchor\"\n\
             poses_per_round = 8\ntension_levels = 3\nrounds = 2\nrecord = \"{record}\"\n"
        )
    };
    for record in ["virtual", "files"] {
        std::fs::write(folder.path().join(format!("{record}.toml")), study(record)).unwrap();
    }
    let run = |record: &str| cdpr_in(folder.path(), &format!("campaign {record}.toml --out {record} --format json"));
    let made = run("virtual");
    assert_eq!(made.exit_code, 0, "{} {}", made.stdout, made.stderr);
    for round in 1..=2 {
        let waiting = run("files");
        assert_eq!((waiting.exit_code, waiting.json()["status"].as_str()), (0, Some("waiting")), "{}", waiting.stdout);
        let [own, other] = ["files", "virtual"].map(|name| folder.path().join(format!("{name}/round-{round}")));
        let order = std::fs::read_to_string(own.join("poses.csv")).unwrap();
        assert_eq!(order, std::fs::read_to_string(other.join("poses.csv")).unwrap(), "round {round}");
        // the order says which lengths and tensions belong to a level: a pose stands there with several
        assert!(order.lines().next().unwrap().contains("tension_N_4"), "{order}");
        let poses: std::collections::BTreeSet<String> =
            order.lines().skip(1).map(|line| line.split(',').take(2).collect::<Vec<_>>().join(",")).collect();
        assert!(poses.len() < order.lines().count() - 1, "round {round}: {order}");
        for name in ["record.csv", "record.meta.toml"] {
            std::fs::copy(other.join(name), own.join(name)).unwrap();
        }
    }
    let (files, made) = (run("files").json(), made.json());
    assert_eq!(files["status"], "rounds-over", "{files}");
    for round in 0..2 {
        let [own, other] = [&files, &made].map(|answer| &answer["rounds"][round]);
        for key in ["poses", "new_poses", "candidates", "validation", "predicted", "deviation_m", "rank"] {
            assert_eq!(own[key], other[key], "round {round}: {key}");
        }
        assert!(own["driven"].is_null() && !other["driven"].is_null());
    }
}

/// The twin in rounds, again from its records, and from files that are put there by hand.
#[test]
fn campaigns_go_from_round_to_round() {
    let folder = tempfile::tempdir().unwrap();
    let study = root().join("studies/twin-campaign.toml");
    let campaign = format!("campaign {} --out rounds --format json", study.display());
    let run = cdpr_in(folder.path(), &campaign);
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json();
    let rounds = answer["rounds"].as_array().unwrap();
    let driven = |round: &serde_json::Value| round["driven"]["position_error_m"]["mean"].as_f64().unwrap();
    assert_eq!(
        (rounds.len(), rounds[4]["poses"].as_u64(), answer["status"].as_str()),
        (5, Some(45), Some("budget-spent"))
    );
    // all 91 poses lead to 3.15 mm
    assert!(driven(&answer["nominal"]) > 0.035 && driven(&rounds[4]) < 0.0032);
    assert!(rounds[4]["reach_share"].as_f64() > answer["nominal"]["reach_share"].as_f64());
    assert!(rounds[4]["validation"]["position_error_m"]["mean"].as_f64().unwrap() < 0.006);
    assert_eq!(cdpr_in(folder.path(), &campaign).stdout, run.stdout, "all records are there");
    let page = std::fs::read_to_string(folder.path().join("rounds/report.html")).unwrap();
    assert!(page.contains("Poses in reach") && page.contains("all 45 poses of the budget are measured"));
    // the same with records put there by hand, as a real robot's are
    let text = std::fs::read_to_string(&study).unwrap();
    std::fs::write(folder.path().join("real.toml"), format!("{text}record = \"files\"\n")).unwrap();
    let real = "campaign real.toml --out real --format json";
    let waiting = cdpr_in(folder.path(), real);
    assert_eq!(
        (waiting.exit_code, waiting.json()["status"].as_str(), waiting.json()["waits_for"].as_u64()),
        (0, Some("waiting"), Some(9))
    );
    for name in ["poses.csv", "record.csv", "record.meta.toml"] {
        let [own, other] = ["real", "rounds"].map(|campaign| folder.path().join(campaign).join("round-1").join(name));
        match name {
            "poses.csv" => assert_eq!(std::fs::read(own).unwrap(), std::fs::read(other).unwrap()),
            _ => drop(std::fs::copy(other, own).unwrap()),
        }
    }
    let next = cdpr_in(folder.path(), real).json();
    assert_eq!(next["rounds"][0]["predicted"], rounds[0]["predicted"]);
    assert!(next["rounds"][0]["driven"].is_null() && next["reason"].as_str().unwrap().contains("round 2"));
    // a folder belongs to one study
    let other = cdpr_in(folder.path(), "campaign real.toml --out rounds --format json");
    assert_eq!((other.exit_code, other.json()["code"].as_str()), (2, Some("campaign::other-study")));
    let none = cdpr_in(
        folder.path(),
        &format!("campaign {} --out none --format json", root().join("studies/twin-nominal.toml").display()),
    );
    assert_eq!((none.exit_code, none.json()["code"].as_str()), (2, Some("campaign::no-table")));
}

/// A study's map moves the lengths that its machine is told, and with them tensions: other poses are within the limits than without it.
#[test]
fn reach_is_that_of_a_controller_with_its_map() {
    let folder = tempfile::tempdir().unwrap();
    let study = root().join("studies/twin-compensated.toml");
    let text = std::fs::read_to_string(&study).unwrap();
    std::fs::write(folder.path().join("without.toml"), text.replace("\ncompensation = ", "\n# compensation = "))
        .unwrap();
    std::fs::write(folder.path().join("nowhere.toml"), text.replace("maps/", "nowhere/")).unwrap();
    let plan = |study: &str| {
        let robot = "cablerobot-simulator-helicopter-kinematic-calibrated";
        let options = "--free frame-anchor --count 12 --starts 1 --out poses.csv --format json";
        cdpr_in(folder.path(), &format!("plan {robot} --study {study} {options}"))
    };
    let reached = |study: &str| {
        let answer = plan(study).json();
        let left_out = answer["left_out"].as_array().unwrap().len() as u64;
        let reached = answer["candidates"].as_u64().unwrap();
        assert_eq!(reached + left_out, 80, "64 of a grid and 16 at random");
        reached
    };
    let (with, without) = (reached(&study.display().to_string()), reached("without.toml"));
    assert!(with != without && with.min(without) >= 40, "{with} {without}");
    let refused = plan("nowhere.toml");
    assert!(refused.exit_code != 0 && refused.stderr.contains("twin-kinematic.toml"), "{}", refused.stderr);
}

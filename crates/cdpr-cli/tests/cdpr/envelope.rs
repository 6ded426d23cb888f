//! Keys of every JSON answer, whichever command gives it: program, layout, status, robot, warnings.

use std::collections::BTreeSet;
use std::path::Path;

use serde_json::Value;

use super::{Run, cdpr, cdpr_in, frequency_response, friction, import, running, test_bench};

/// A study with a remark (its machine lacks what the control model has), tolerances and sensors.
const STUDY: &str = "[control]\nrobot = \"planar-example\"\nmodel = \"elastic\"\n[machine]\nrobot = \"planar-example\"\n[initial]\n\
                     pose = [0, 5.2]\noffset = \"none\"\n[limits]\nposition_error_max_m = 0.05\n[poses.grid]\nmin = [-1, 4]\n\
                     max = [1, 6]\ncount = [4, 4]\n[noise]\nposition_m = 0.001\nlength_m = 0.0005\n[tolerances]\nrobots = 10\n\
                     accuracy_m = 0.2\n[tolerances.machine]\nframe_anchor_m = 0.002\n";

/// The same with an elastic machine, whose winches are set by tensions.
const ELASTIC: &str = "[control]\nrobot = \"planar-example\"\n[machine]\nrobot = \"planar-example\"\nmodel = \"elastic\"\n[initial]\n\
                       pose = [0, 5.2]\ntension_method = \"closed-form\"\n[limits]\ntension_min_N = 1000\ntension_max_N = 8000\n\
                       [poses.grid]\nmin = [-1, 4]\nmax = [1, 6]\ncount = [3, 3]\n";

const SWEEP: &str = "study = \"elastic.toml\"\nposition_error_max_m = [0.01]\nbounds_m = [-6, 6, -1, 9]\nstep_m = 1.0\n[[parameter]]\n\
                     key = \"study.limits.tension_max_N\"\nvalues = [6000, 8000]\n";

/// An answer of every command, with the robot that it is about; those of one command in the order in which they can run.
const CASES: [(&str, Option<&str>); 50] = [
    ("robots", None),
    ("robots cogiro", None),
    ("new", None),
    ("new planar-circle", None),
    ("new box", None),
    ("check planar-example", Some("planar-example")),
    ("ik planar-example --pose 0,5", Some("planar-example")),
    ("ik planar-example --pose -6,8", Some("planar-example")),
    ("fk planar-example --lengths 6.6,5.7,7.2,6.2", Some("planar-example")),
    ("tension planar-example --pose 0,5.2", Some("planar-example")),
    ("tension planar-example --pose 0,5.2 --wrench 0,-60000", Some("planar-example")),
    ("load planar-example --pose 0,5.2 --tensions 5808,5909,2390,2421", Some("planar-example")),
    ("stiffness planar-example --model elastic --pose 0,5.2", Some("planar-example")),
    ("dynamics plate-in-motion.toml --pose 1.9,1.4,0", Some("moving-plate")),
    ("modes plate-in-motion.toml --pose 1.9,1.4,0", Some("moving-plate")),
    ("workspace planar-example --step 1", Some("planar-example")),
    ("workspace planar-example --wrench 0,-60000 --step 1", Some("planar-example")),
    ("capability planar-example --box=-1,1,3,5", Some("planar-example")),
    ("model planar-example --pose 0,5.2", Some("planar-example")),
    ("advise planar-example --task=-1,1,4,6 --accuracy 0.01 --count 2", Some("planar-example")),
    ("place-pulleys planar-example --axis 0,1 --out placed.toml", Some("planar-example")),
    ("simulate study.toml --out data.csv", Some("planar-example")),
    (
        "plan planar-example --free length-offset --count 3 --candidates data.csv --out planned.csv",
        Some("planar-example"),
    ),
    ("identify planar-example data.csv --free length-offset", Some("planar-example")),
    ("evaluate planar-example data.csv", Some("planar-example")),
    ("compensate planar-example data.csv --out map.toml", Some("planar-example")),
    ("select planar-example data.csv --candidates standard --out result", Some("planar-example")),
    ("campaign campaign.toml --out campaign", Some("planar-example")),
    ("accuracy study.toml", Some("planar-example")),
    ("study study.toml --out studied", Some("planar-example")),
    ("chain elastic.toml", Some("planar-example")),
    ("benchmark --robots planar-example --models standard", None),
    ("reachable study.toml --step 1", Some("planar-example")),
    ("initial-tension elastic.toml", Some("planar-example")),
    ("sensitivity study.toml", Some("planar-example")),
    ("sweep plan sweep.toml --out swept", Some("planar-example")),
    ("sweep run swept", Some("planar-example")),
    ("sweep merge swept", Some("planar-example")),
    ("sweep all sweep.toml --out swept-too", Some("planar-example")),
    ("run scenario.toml --out moved", Some("moving-plate")),
    ("demo --candidates standard --out demo", Some("cablerobot-simulator-helicopter")),
    ("test-bench record.csv --length 10", None),
    ("frequency-response response.csv", None),
    ("friction winch.csv", None),
    ("import caspr plate_bodies.xml plate_cables.xml --out plate.toml", Some("plate")),
    ("export csv result", Some("planar-example")),
    ("schema robot", None),
    ("explain", None),
    ("completions bash", None),
    ("man", None),
];

fn folder() -> tempfile::TempDir {
    let folder = import::model();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("study.toml", STUDY);
    write("elastic.toml", ELASTIC);
    let campaign = STUDY.replace("model = \"elastic\"", "model = \"standard\"");
    write(
        "campaign.toml",
        &format!("{campaign}[campaign]\nfree = \"length-offset\"\nposes_per_round = 4\nrounds = 2\n"),
    );
    write("sweep.toml", SWEEP);
    write("record.csv", &test_bench::record());
    write("response.csv", &frequency_response::record());
    write("winch.csv", &friction::record());
    write("scenario.toml", running::SCENARIO);
    write("plate-in-motion.toml", running::PLATE);
    folder
}

/// Asserts what every object says; tells whether something was told on stderr.
fn assert_enveloped(run: &Run, arguments: &str, robot: Option<&str>) -> bool {
    let answer = run.json();
    assert_eq!(answer["program"], concat!("cdpr ", env!("CARGO_PKG_VERSION")), "{arguments}: {answer}");
    assert_eq!(answer["layout_version"], 1, "{arguments}");
    assert!(answer["status"].as_str().is_some_and(|status| !status.is_empty()), "{arguments}: {answer}");
    let has_reason = answer["reason"].as_str().is_some_and(|reason| !reason.is_empty());
    assert!(run.exit_code == 0 || has_reason, "{arguments}: no reason in {answer}");
    assert_eq!(answer.get("robot").and_then(Value::as_str), robot, "{arguments}");
    let warnings = answer["warnings"].as_array().unwrap_or_else(|| panic!("{arguments}: no warnings in {answer}"));
    let notes: Vec<&str> = run.stderr.lines().filter_map(|line| line.strip_prefix("note: ")).collect();
    for note in &notes {
        assert!(warnings.iter().any(|warning| warning == note), "{arguments}: `{note}` is not in {warnings:?}");
    }
    !notes.is_empty()
}

/// Names of the commands that the help lists in its groups.
pub(super) fn commands() -> BTreeSet<String> {
    let help = cdpr("--help").stdout;
    let lines = help.lines().skip_while(|line| !line.starts_with("Usage:")).take_while(|line| *line != "Options:");
    // lines that go on with a description are indented more
    let names = lines.filter_map(|line| line.strip_prefix("  ").filter(|rest| !rest.starts_with(' ')));
    names.filter_map(|line| line.split_whitespace().next().map(str::to_owned)).collect()
}

#[test]
fn every_answer_of_every_command_has_program_layout_status_robot_and_warnings() {
    let tried: BTreeSet<String> =
        CASES.iter().filter_map(|(arguments, _)| arguments.split(' ').next().map(str::to_owned)).collect();
    assert_eq!(tried, commands(), "each command has a case");
    let folder = folder();
    let mut noted = 0;
    for (arguments, robot) in CASES {
        let run = cdpr_in(folder.path(), &format!("{arguments} --format json"));
        assert!(run.exit_code <= 1, "{arguments}: {}", run.stderr);
        noted += usize::from(assert_enveloped(&run, arguments, robot));
    }
    assert!(noted > 6, "only {noted} cases told a note");
}

#[test]
fn failures_have_the_same_keys_and_what_was_told_before_them() {
    let folder = folder();
    for (arguments, robot) in [
        ("check nowhere.toml", None),
        ("ik planar-example", None),
        ("nonsense", None),
        ("accuracy study.toml --tension-method none-such", None),
        ("reachable study.toml --step -1", Some("planar-example")),
        ("fk planar-example --lengths 1,2", Some("planar-example")),
    ] {
        let run = cdpr_in(folder.path(), &format!("{arguments} --format json"));
        assert!(run.exit_code > 1, "{arguments}: {}", run.stdout);
        assert_enveloped(&run, arguments, robot);
        assert_eq!(run.json()["status"], "error", "{arguments}");
    }
}

fn parsed(path: &Path) -> Value {
    serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap()
}

/// `--quiet` keeps notes from stderr, not from the object; files keep what stdout says.
#[test]
fn notes_stay_in_the_object_when_quiet_and_in_the_files_of_a_result() {
    let folder = folder();
    let loud = cdpr_in(folder.path(), "study study.toml --out loud --format json").json();
    let quiet = cdpr_in(folder.path(), "study study.toml --out quiet --format json --quiet");
    assert_eq!((quiet.stderr.as_str(), &quiet.json()), ("", &loud));
    let told = "is poorer than the control model";
    assert!(loud["warnings"][0].as_str().unwrap().contains(told), "{loud}");
    assert_eq!(parsed(&folder.path().join("loud/result.json")), loud);
    let page = std::fs::read_to_string(folder.path().join("loud/report.html")).unwrap();
    assert!(page.contains(told), "the note is not on the page");
    let table = "x_m,y_m,mood,cable_length_m_1,cable_length_m_2,cable_length_m_3,cable_length_m_4\n";
    let rows: String = (0..12).map(|row| format!("{},{},1,6.4,6.4,6.4,6.{row}\n", 0.1 * f64::from(row), 5)).collect();
    std::fs::write(folder.path().join("moody.csv"), format!("{table}{rows}")).unwrap();
    let run =
        cdpr_in(folder.path(), "select planar-example moody.csv --candidates standard --out chosen --format json");
    let report = std::fs::read_to_string(folder.path().join("chosen/report.html")).unwrap();
    let run_of_identify =
        cdpr_in(folder.path(), "identify planar-example moody.csv --free length-offset --report fit.html");
    assert!(run_of_identify.stderr.contains("mood"), "{}", run_of_identify.stderr);
    let fit = std::fs::read_to_string(folder.path().join("fit.html")).unwrap();
    for (text, what) in [(run.stdout, "answer"), (report, "report of select"), (fit, "report of identify")] {
        assert!(text.contains("mood"), "the {what} does not tell of the ignored column");
    }
    assert_eq!(parsed(&folder.path().join("chosen/result.json"))["layout_version"], 1);
}

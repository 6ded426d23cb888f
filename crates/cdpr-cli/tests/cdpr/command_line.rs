//! What holds for every command.

use super::{cdpr, cdpr_in, file_with};

/// The folder of the repository.
const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

pub(crate) const COMMANDS: &[&str] = &[
    "select",
    "accuracy",
    "study",
    "reachable",
    "initial-tension",
    "sweep",
    "sensitivity",
    "simulate",
    "run",
    "demo",
    "robots",
    "new",
    "check",
    "ik",
    "fk",
    "tension",
    "load",
    "stiffness",
    "dynamics",
    "modes",
    "workspace",
    "capability",
    "model",
    "advise",
    "place-pulleys",
    "plan",
    "campaign",
    "identify",
    "evaluate",
    "compensate",
    "benchmark",
    "test-bench",
    "frequency-response",
    "friction",
    "import",
    "export",
    "schema",
    "explain",
    "completions",
    "man",
];

#[test]
fn help_of_every_command_shows_an_example() {
    for command in COMMANDS {
        let run = cdpr(&format!("{command} --help"));
        assert_eq!(run.exit_code, 0, "{command}");
        let example = format!("Examples:\n  cdpr {command}");
        assert!(run.stdout.contains(&example), "{command}: {}", run.stdout);
        assert!(cdpr("--help").stdout.contains(&format!("  {command} ")), "{command}");
        for file in run.stdout.split_whitespace().filter(|word| word.starts_with("studies/")) {
            assert!(std::path::Path::new(&format!("{ROOT}/{file}")).is_file(), "{command} names {file}");
        }
    }
}

/// `cdpr help COMMAND` was "unrecognized subcommand 'help'".
#[test]
fn help_of_every_command_is_told_by_the_command_help_too() {
    for command in COMMANDS.iter().copied().chain(["import caspr"]) {
        let run = cdpr(&format!("help {command}"));
        assert_eq!((run.exit_code, run.stderr.as_str()), (0, ""), "{command}");
        assert_eq!(run.stdout, cdpr(&format!("{command} --help")).stdout, "{command}");
    }
    assert_eq!(cdpr("help").stdout, cdpr("--help").stdout);
    let unknown = cdpr("help identfy --format json");
    assert_eq!((unknown.exit_code, unknown.stdout.contains("usage::unknown-command")), (2, true), "{}", unknown.stdout);
}

#[test]
fn version_names_program_and_version() {
    assert_eq!(cdpr("--version").stdout, format!("cdpr {}\n", env!("CARGO_PKG_VERSION")));
}

#[test]
fn wrong_usage_is_exit_code_2_and_a_json_object_where_json_was_asked_for() {
    for arguments in ["", "nonsense", "ik planar-example", "ik planar-example --pose 1,2 --format yaml", "schema wine"]
    {
        let run = cdpr(arguments);
        assert_eq!(run.exit_code, 2, "{arguments}");
        assert!(run.stdout.is_empty() && !run.stderr.is_empty(), "{arguments}");
    }
    let error = cdpr("ik planar-example --format json").json_with(&["status", "reason", "exit_code"]);
    assert_eq!(error["status"], "error");
    assert!(error["reason"].as_str().unwrap().contains("--pose"), "{error}");
}

#[test]
fn the_component_of_a_list_at_fault_is_named() {
    for (arguments, fault) in [
        ("ik planar-example --pose 1,x", "component 2: `x` is not a number"),
        ("ik planar-example --pose nan,1", "component 1: `nan` is not a finite number"),
        ("ik planar-example --pose 1,2,3", "x,y, found 3 numbers"),
        ("fk planar-example --lengths 1,2,3", "expected 4 cable lengths"),
        ("fk planar-example --lengths 1,2,-3,4", "cable 3"),
        ("fk planar-example --lengths 1,2,3,4 --guess 1", "--guess"),
    ] {
        let run = cdpr(arguments);
        assert_eq!(run.exit_code, 2, "{arguments}");
        assert!(run.stderr.contains(fault), "{arguments}: {}", run.stderr);
    }
}

#[test]
fn an_unknown_robot_is_answered_by_the_one_meant() {
    let run = cdpr("check planar-exampel");
    assert_eq!(run.exit_code, 2);
    assert!(run.stderr.contains("did you mean `planar-example`?"), "{}", run.stderr);
    let template = cdpr("ik suspended-camera --pose 0,0,1");
    assert!(template.stderr.contains("`cdpr new suspended-camera`"), "{}", template.stderr);
    let anchors = cdpr("identify planar-example data.csv --free anchors");
    assert!(anchors.stderr.contains("did you mean `frame-anchor` or `platform-anchor`?"), "{}", anchors.stderr);
    let nothing_like_it = cdpr("check qqq");
    assert!(nothing_like_it.stderr.contains("cogiro"), "{}", nothing_like_it.stderr);
}

#[test]
fn a_missing_file_is_exit_code_4_with_what_was_looked_for() {
    for arguments in ["check nowhere/robot.toml", "evaluate planar-example nowhere.csv"] {
        let run = cdpr(arguments);
        assert_eq!(run.exit_code, 4, "{arguments}");
        assert!(run.stderr.contains("nowhere") && run.stderr.contains("no such file"), "{}", run.stderr);
    }
    let run = cdpr("place-pulleys planar-example --axis 0,1 --out nowhere/robot.toml --format json");
    assert_eq!((run.exit_code, run.json()["exit_code"].as_i64()), (4, Some(4)));
}

#[test]
fn a_robot_is_a_path_or_a_built_in_name() {
    let (folder, _) = file_with("square", super::SQUARE.as_bytes());
    assert_eq!(cdpr_in(folder.path(), "check square").exit_code, 0);
    assert_eq!(cdpr_in(folder.path(), "check ./square").exit_code, 0);
    assert_eq!(cdpr_in(folder.path(), "check ./planar-example").exit_code, 4);
}

#[test]
fn stderr_is_without_colour_when_it_is_not_a_terminal() {
    for arguments in ["check planar-exampel", "nonsense", "ik planar-example --pose x"] {
        assert!(!cdpr(arguments).stderr.contains('\x1b'), "{arguments}");
    }
}

#[test]
fn schemas_are_json_schemas() {
    for format in ["robot", "study", "measurement"] {
        let schema = cdpr(&format!("schema {format}")).json_with(&["$schema", "properties"]);
        let mut answer = cdpr(&format!("schema {format} --format json")).json();
        // the object for scripts says besides what every answer says
        for key in ["program", "layout_version", "status", "warnings"] {
            assert!(answer.as_object_mut().unwrap().remove(key).is_some(), "{key}");
        }
        assert_eq!(schema, answer);
    }
}

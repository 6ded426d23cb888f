//! `cdpr new`: what it writes runs as it is, and nothing of the user's is lost.

use std::path::Path;

use serde_json::Value;

use super::{Run, cdpr, cdpr_in, listed, numbers};

const TEMPLATES: [(&str, &str); 4] =
    [("wall-plotter", "2T"), ("suspended-camera", "3T"), ("planar-frame", "1R2T"), ("box", "3R3T")];

fn done(run: Run, command: &str) -> Run {
    assert_eq!(run.exit_code, 0, "{command}: {}{}", run.stdout, run.stderr);
    run
}

/// The repository's folder of studies.
fn studies() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies")
}

/// Commands that the head of a file tells.
fn told(path: &Path) -> Vec<String> {
    let text = std::fs::read_to_string(path).unwrap();
    let lines = text.lines().filter_map(|line| line.strip_prefix("#   cdpr "));
    lines.map(|line| line.split("  ").next().unwrap().to_owned()).collect()
}

#[test]
fn every_command_that_the_heads_of_the_templates_tell_runs_on_what_was_written() {
    for (name, pattern) in TEMPLATES {
        let folder = tempfile::tempdir().unwrap();
        let command = format!("new {pattern} --format json");
        let written = done(cdpr_in(folder.path(), &command), &command).json_with(&["written", "try"]);
        assert_eq!(written["written"].as_array().unwrap().len(), 3, "{written}");
        let inside = folder.path().join(name);
        let commands: Vec<String> =
            ["robot.toml", "study.toml", "scenario.toml"].iter().flat_map(|file| told(&inside.join(file))).collect();
        for word in [
            "check",
            "ik",
            "fk",
            "workspace",
            "accuracy",
            "study",
            "reachable",
            "sensitivity",
            "campaign",
            "simulate",
            "identify",
            "run",
        ] {
            assert!(commands.iter().any(|command| command.starts_with(word)), "{name} does not tell {word}");
        }
        for command in &commands {
            done(cdpr_in(&inside, command), &format!("{name}: {command}"));
        }
        // the answer tells the same commands, for the folder that they were given from
        let tried: Vec<&str> = written["try"].as_array().unwrap().iter().map(|one| one.as_str().unwrap()).collect();
        assert_eq!(tried.len(), commands.len());
        for command in tried.iter().filter(|command| command.contains(" check ") || command.contains(" accuracy ")) {
            done(cdpr_in(folder.path(), command.strip_prefix("cdpr ").unwrap()), command);
        }
    }
}

/// No template is singular, slack or ambiguous where it stands: lengths of the home pose lead back to it, and the file has nothing to warn of.
#[test]
fn lengths_of_a_templates_home_pose_lead_back_to_it() {
    for (name, pattern) in TEMPLATES {
        let folder = tempfile::tempdir().unwrap();
        done(cdpr_in(folder.path(), &format!("new {name} --out .")), name);
        let check = done(cdpr_in(folder.path(), "check robot.toml --format json"), name).json();
        assert_eq!((&check["motion_pattern"], &check["home"]["feasible"]), (&pattern.into(), &true.into()), "{check}");
        assert_eq!(check["warnings"], Value::Array(Vec::new()), "{name}");
        assert!(check["home"]["condition"].as_f64().unwrap() < 5.0, "{check}");
        let home = cdpr_in(folder.path(), "fk robot.toml --lengths 1 --format json");
        assert_eq!(home.exit_code, 2, "one length is too few");
        let pose = match pattern {
            "2T" => "1,0.75",
            "3T" => "0,0,3",
            "1R2T" => "1.5,1,0",
            _ => "0,0,1.25,0,0,0",
        };
        let lengths = done(cdpr_in(folder.path(), &format!("ik robot.toml --pose {pose} --format json")), name).json();
        let lengths = listed(&numbers(&lengths["cable_lengths_m"]));
        let back = done(cdpr_in(folder.path(), &format!("fk robot.toml --lengths {lengths}")), name);
        assert!(back.stdout.contains("exact") || back.stdout.contains("converged"), "{}", back.stdout);
    }
}

#[test]
fn files_that_are_there_are_replaced_only_by_force() {
    let folder = tempfile::tempdir().unwrap();
    let [robot, study] = ["robot.toml", "study.toml"].map(|name| folder.path().join("mine").join(name));
    std::fs::create_dir(folder.path().join("mine")).unwrap();
    std::fs::write(&study, "my own").unwrap();
    let refused = cdpr_in(folder.path(), "new box --out mine --format json");
    assert_eq!((refused.exit_code, &refused.json()["code"]), (2, &"new::file-exists".into()), "{}", refused.stderr);
    assert!(refused.stderr.contains("study.toml") && refused.stderr.contains("--force"), "{}", refused.stderr);
    assert!(!robot.exists(), "all files of a name or none");
    assert_eq!(std::fs::read_to_string(&study).unwrap(), "my own");
    done(cdpr_in(folder.path(), "new box --out mine --force"), "--force");
    assert!(std::fs::read_to_string(&study).unwrap().contains("[machine]"));
    // what is there as it would be written is no obstacle, and another template in its place is
    let again = done(cdpr_in(folder.path(), "new box --out mine --format json"), "again").json();
    assert_eq!(again["written"], Value::Array(Vec::new()));
    let written = std::fs::read_to_string(&robot).unwrap();
    assert_eq!(cdpr_in(folder.path(), "new wall-plotter --out mine").exit_code, 2);
    assert_eq!(std::fs::read_to_string(&robot).unwrap(), written);
    let left: Vec<_> = std::fs::read_dir(folder.path().join("mine")).unwrap().collect();
    assert_eq!(left.len(), 3, "no temporary file stays");
}

/// Poses and robots of a study come with it, and the commands of its head run from the folder above.
#[test]
fn studies_of_the_book_run_from_where_they_are_written() {
    let folder = tempfile::tempdir().unwrap();
    for (name, command) in [
        ("planar-circle", "study studies/planar-circle.toml --out circle"),
        ("twin-elastostatic-nominal", "accuracy studies/twin-elastostatic-nominal.toml"),
        ("planar-stiff", "accuracy studies/planar-stiff.toml"),
    ] {
        let written = done(cdpr_in(folder.path(), &format!("new {name}")), name);
        assert!(written.stdout.contains("cdpr "), "{}", written.stdout);
        done(cdpr_in(folder.path(), command), command);
    }
    let elsewhere = folder.path().join("my sweep");
    std::fs::create_dir(&elsewhere).unwrap();
    let sweep = done(cdpr_in(&elsewhere, "new sweep-planar-pulleys --out ."), "sweep");
    assert!(elsewhere.join("planar-pulleys.toml").is_file(), "{}", sweep.stdout);
    done(cdpr_in(&elsewhere, "sweep plan sweep-planar-pulleys.toml --out plan"), "plan");
    done(cdpr_in(folder.path(), "new studies --out all"), "studies");
    for path in ["poses/planar-circle.csv", "planar-wide-grid.toml", "robots/planar-stiff.toml"] {
        let original = std::fs::read(studies().join(path)).unwrap();
        assert_eq!(std::fs::read(folder.path().join("all").join(path)).unwrap(), original, "{path}");
    }
}

#[test]
fn all_names_are_listed_and_a_wrong_one_is_answered_by_the_one_meant() {
    let list = done(cdpr("new --list --format json"), "list").json_with(&["templates", "studies"]);
    let patterns: Vec<&str> =
        list["templates"].as_array().unwrap().iter().map(|entry| entry["motion_pattern"].as_str().unwrap()).collect();
    assert_eq!(patterns, TEMPLATES.map(|(_, pattern)| pattern));
    let count = std::fs::read_dir(studies())
        .unwrap()
        .filter(|entry| entry.as_ref().unwrap().path().extension().is_some_and(|ending| ending == "toml"));
    assert_eq!(list["studies"].as_array().unwrap().len(), count.count());
    assert_eq!(cdpr("new").stdout, cdpr("new --list").stdout);
    let wrong = cdpr("new suspended-camra --format json");
    assert_eq!((wrong.exit_code, &wrong.json()["code"]), (2, &"new::unknown-name".into()));
    assert!(wrong.stderr.contains("did you mean `suspended-camera`?"), "{}", wrong.stderr);
    assert_eq!(cdpr("new --force").exit_code, 2);
}

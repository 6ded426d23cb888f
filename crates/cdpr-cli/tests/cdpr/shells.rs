//! Completions, man pages, and the options that every command takes.

use std::process::Command;

use super::{cdpr, cdpr_in};
use crate::command_line::COMMANDS;

#[test]
fn every_shell_has_a_script_and_those_that_ask_are_told_every_command() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let run = cdpr(&format!("completions {shell}"));
        assert_eq!(run.exit_code, 0, "{shell}: {}", run.stderr);
        let asks = run.stdout.contains(" complete -- ");
        assert_eq!(asks, !["elvish", "powershell"].contains(&shell), "{shell}");
        let told = if asks { asked(&[""]) } else { run.stdout.clone() };
        for command in COMMANDS {
            assert!(told.contains(command), "{shell} does not know {command}");
        }
        let json = cdpr(&format!("completions {shell} --format json")).json();
        assert_eq!((json["shell"].as_str(), json["script"].as_str()), (Some(shell), Some(run.stdout.as_str())));
    }
}

/// Answer to the scripts for these words.
fn asked(words: &[&str]) -> String {
    let run = super::run(assert_cmd::Command::cargo_bin("cdpr").unwrap().args(["complete", "--"]).args(words));
    assert_eq!((run.exit_code, run.stderr.as_str()), (0, ""), "{words:?}");
    run.stdout
}

/// Nothing is checked without a bash. `cargo xtask test --only shells` asks zsh and fish, too.
#[test]
#[expect(clippy::print_stderr, reason = "a test that skips says so")]
fn the_completions_of_bash_are_a_script_that_completes_an_option_and_a_value() {
    let folder = tempfile::tempdir().unwrap();
    let script = folder.path().join("cdpr.bash");
    std::fs::write(&script, cdpr("completions bash").stdout).unwrap();
    let program = assert_cmd::cargo::cargo_bin("cdpr");
    for (line, words, proposed) in [
        ("cdpr select --requ", "cdpr select --requ", "--require\n"),
        ("cdpr ik --model=pulley+e", "cdpr ik --model = pulley+e", "pulley+elastic\n"),
        ("cdpr explain ragged-row csv::ra", "cdpr explain ragged-row csv :: ra", ""),
        ("cdpr explain csv::ragged", "cdpr explain csv :: ragged", "ragged-row\n"),
    ] {
        let last = words.split(' ').count() - 1;
        let ask = format!(
            "source '{}'; COMP_LINE='{line}' COMP_POINT={} COMP_WORDS=({words}) COMP_CWORD={last}; _cdpr '{}'; \
             printf '%s\n' \"${{COMPREPLY[@]}}\"",
            script.display(),
            line.len(),
            program.display()
        );
        let Ok(output) = Command::new("bash").args(["--norc", "-c", &ask]).output() else {
            eprintln!("skipped: there is no bash");
            return;
        };
        let found = String::from_utf8_lossy(&output.stdout).into_owned();
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        match proposed {
            // where no value is left, options
            "" => assert!(found.lines().all(|word| word.starts_with('-') || word.is_empty()), "{line}: {found}{error}"),
            _ => assert_eq!(found, proposed, "{line}: {error}"),
        }
    }
}

#[test]
fn there_is_a_man_page_of_every_command_with_its_examples() {
    let folder = tempfile::tempdir().unwrap();
    let run = cdpr_in(folder.path(), "man --out man1 --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let text = |name: &str| std::fs::read_to_string(folder.path().join("man1").join(name)).unwrap();
    assert!(text("cdpr.1").contains(".SH EXAMPLES\n.nf\n  cdpr robots\n"));
    for command in COMMANDS {
        let page = text(&format!("cdpr-{command}.1"));
        assert!(page.contains(".SH EXAMPLES") && page.contains(".SH SYNOPSIS"), "{command}: {page}");
    }
    assert!(text("cdpr-import-caspr.1").contains("cable\\-set"));
    assert_eq!(cdpr("man").stdout, text("cdpr.1"));
}

#[test]
fn quiet_leaves_the_answer_and_drops_the_notes() {
    let (folder, _) = super::file_with("square.toml", super::SQUARE.as_bytes());
    let heading = "x_m,z_m,mood,cable_length_m_1,cable_length_m_2,cable_length_m_3,cable_length_m_4\n";
    std::fs::write(folder.path().join("data.csv"), format!("{heading}5,4,1,6.4,6.4,6.4,6.4\n")).unwrap();
    let loud = cdpr_in(folder.path(), "evaluate square.toml data.csv");
    assert!(loud.stderr.contains("mood"), "{}", loud.stderr);
    for quiet in ["evaluate square.toml data.csv --quiet", "-q evaluate square.toml data.csv"] {
        let run = cdpr_in(folder.path(), quiet);
        assert_eq!((run.exit_code, run.stdout.as_str(), run.stderr.as_str()), (0, loud.stdout.as_str(), ""));
    }
    let error = cdpr("check planar-exampel --quiet");
    assert!(error.exit_code == 2 && error.stderr.contains("planar-example"), "errors are told: {}", error.stderr);
}

#[test]
fn colour_can_be_forced_and_forbidden() {
    let stderr = |arguments: &str, variables: &[(&str, &str)]| {
        let mut command = assert_cmd::Command::cargo_bin("cdpr").unwrap();
        command.env_remove("NO_COLOR").env_remove("CLICOLOR_FORCE").envs(variables.iter().copied());
        super::run(command.args(arguments.split_whitespace())).stderr
    };
    for arguments in ["check planar-exampel", "nonsense", "ik planar-example"] {
        let is_coloured =
            |more: &str, variables: &[(&str, &str)]| stderr(&format!("{arguments}{more}"), variables).contains('\x1b');
        assert!(is_coloured(" --color always", &[]), "{arguments}");
        assert!(is_coloured("", &[("CLICOLOR_FORCE", "1")]), "{arguments}");
        assert!(!is_coloured("", &[("CLICOLOR_FORCE", "1"), ("NO_COLOR", "1")]), "{arguments}");
        assert!(!is_coloured(" --color=never", &[("CLICOLOR_FORCE", "1")]), "{arguments}");
    }
}

#[test]
fn no_threads_at_all_is_wrong_usage() {
    assert_eq!(cdpr("robots --threads 0").exit_code, 2);
    assert_eq!(cdpr("robots --threads 2").exit_code, 0);
}

/// Every started thread takes memory and time to start, and gains nothing beyond the processors.
#[test]
fn more_threads_than_a_machine_can_use_are_not_started() {
    let many = cdpr("ik planar-example --pose 0.5,4 --threads 65535");
    assert_eq!(many.stdout, cdpr("ik planar-example --pose 0.5,4 --threads 1").stdout);
    assert!(many.exit_code == 0 && many.stderr.contains("are started"), "{}", many.stderr);
    assert!(!cdpr("ik planar-example --pose 0.5,4 --threads 64").stderr.contains("are started"));
}

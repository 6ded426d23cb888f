//! Files given where a file of another kind is read.

use std::path::Path;

use super::{cdpr, cdpr_in};

/// A folder with one file of every kind, beside the robot and study of a template.
fn folder_of_kinds() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    assert_eq!(cdpr(&format!("new wall-plotter --out {}", folder.path().display())).exit_code, 0);
    write("sweep.toml", "study = \"study.toml\"\n[[parameter]]\nname = \"step_m\"\nvalues = [1, 2]\n");
    write("data.csv", "x_m,y_m,cable_length_m_1,cable_length_m_2\n0.2,0.3,1,1\n");
    write("map.toml", "layout_version = 1\nrobot = \"wall-plotter\"\nnoise_ratio = 0.1\n");
    write("bodies.xml", "<?xml version=\"1.0\"?>\n<bodies_system/>\n");
    write("cables.xml", "<cables default_cable_set=\"a\"/>\n");
    write("arm.urdf", "<robot name=\"arm\"><link name=\"base\"/></robot>\n");
    write("result.json", "{\"status\": \"ok\", \"rank\": 2}\n");
    write("report.html", "<!doctype html>\n<html lang=\"en\"></html>\n");
    std::fs::write(folder.path().join("sheet.xlsx"), b"PK\x03\x04\xff\xfe").unwrap();
    folder
}

fn check(folder: &Path, arguments: &str, words: [&str; 2]) {
    let run = cdpr_in(folder, arguments);
    assert_eq!(run.exit_code, 2, "{arguments}: {}", run.stderr);
    assert!(run.stderr.contains("file::other-kind"), "{arguments}: {}", run.stderr);
    for part in words {
        assert!(run.stderr.contains(part), "{arguments}: `{part}` is missing in {}", run.stderr);
    }
}

#[test]
fn a_file_of_another_kind_is_named_with_the_command_that_takes_it() {
    let folder = folder_of_kinds();
    for (arguments, is, taken) in [
        ("check study.toml", "this is a study, and a robot file is expected here", "`cdpr accuracy study.toml`"),
        ("check scenario.toml", "this is a scenario, and a robot file", "`cdpr run scenario.toml --out DIR`"),
        ("check sweep.toml", "this is a sweep, and a robot file", "`cdpr sweep plan sweep.toml --out DIR`"),
        ("evaluate data.csv robot.toml", "this is a table (CSV), and a robot file", "`cdpr evaluate ROBOT data.csv`"),
        ("check map.toml", "this is a map that corrects lengths", "--compensation map.toml"),
        (
            "check bodies.xml",
            "this is CASPR's file of bodies",
            "`cdpr import caspr bodies.xml CABLES.xml --out ROBOT.toml`",
        ),
        (
            "check cables.xml",
            "this is CASPR's file of cables",
            "`cdpr import caspr BODIES.xml cables.xml --out ROBOT.toml`",
        ),
        ("check arm.urdf", "this is a model of a simulator of rigid bodies (URDF", "`cdpr new`"),
        ("check result.json", "this is JSON, as commands answer", "`cdpr export csv result.json`"),
        ("check report.html", "this is a page", "result.json"),
        ("check sheet.xlsx", "this is an archive or a workbook", "save the sheet as CSV"),
        ("accuracy robot.toml", "this is a robot file, and a study is expected", "`cdpr check robot.toml`"),
        ("accuracy scenario.toml", "this is a scenario, and a study is expected", "`cdpr run scenario.toml --out DIR`"),
        ("run study.toml --out run", "this is a study, and a scenario is expected", "`cdpr accuracy study.toml`"),
        ("run robot.toml --out run", "this is a robot file, and a scenario is expected", "`cdpr check robot.toml`"),
        ("sweep plan study.toml --out plan", "this is a study, and a sweep is expected", "`cdpr accuracy study.toml`"),
        (
            "evaluate robot.toml study.toml",
            "this is a study, and a table (CSV) is expected",
            "`cdpr accuracy study.toml`",
        ),
        ("evaluate robot.toml result.json", "this is JSON", "`cdpr export csv result.json`"),
        ("evaluate robot.toml data.csv --merge robot.toml", "this is a robot file, and a table (CSV)", "`cdpr check"),
        (
            "frequency-response scenario.toml",
            "this is a scenario, and a table (CSV)",
            "`cdpr run scenario.toml --out DIR`",
        ),
        ("test-bench robot.toml --length 1", "this is a robot file, and a table (CSV)", "`cdpr check robot.toml`"),
        ("ik robot.toml --pose 0.2,0.3 --compensation study.toml", "this is a study, and a map", "`cdpr accuracy"),
        (
            "import caspr robot.toml cables.xml --out a.toml",
            "this is a robot file, and CASPR's file of bodies",
            "`cdpr check",
        ),
        ("export csv robot.toml", "this is a robot file, and JSON", "`cdpr check robot.toml`"),
        (
            "export lengths robot.toml --poses study.toml",
            "this is a study, and a table (CSV)",
            "`cdpr accuracy study.toml`",
        ),
    ] {
        check(folder.path(), arguments, [is, taken]);
    }
    // the robot of a study in another folder is named from here
    std::fs::create_dir(folder.path().join("below")).unwrap();
    std::fs::rename(folder.path().join("study.toml"), folder.path().join("below/study.toml")).unwrap();
    check(folder.path(), "check below/study.toml", ["a study", "the robot of its machine is below/robot.toml"]);
}

#[test]
fn mistakes_within_a_file_of_the_right_kind_are_told_as_before() {
    let folder = folder_of_kinds();
    let text = std::fs::read_to_string(folder.path().join("robot.toml")).unwrap();
    std::fs::write(folder.path().join("typo.toml"), text.replace("frame_anchor_m", "frame_ancor_m")).unwrap();
    for (arguments, code) in [
        ("check typo.toml", "toml::unknown-key"),
        ("evaluate robot.toml data.csv --columns x_m=none", "csv::"),
        ("accuracy typo.toml", "file::other-kind"),
    ] {
        let run = cdpr_in(folder.path(), arguments);
        assert!(run.exit_code == 2 && run.stderr.contains(code), "{arguments}: {}", run.stderr);
    }
    let json = cdpr_in(folder.path(), "check study.toml --format json").json();
    assert_eq!((&json["code"], &json["file"]), (&"file::other-kind".into(), &"study.toml".into()));
}

//! `cdpr export`: figures of a result.

use std::path::Path;

use super::{cdpr_in, numbers};

fn demo() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(cdpr_in(folder.path(), "demo --out demo").exit_code, 0);
    folder
}

/// Rows of a table as fields; none of these tables has quotes around what is compared.
fn rows(path: &Path) -> Vec<Vec<String>> {
    let text = std::fs::read_to_string(path).unwrap();
    text.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

#[test]
fn drawings_are_well_formed_stand_alone_and_name_their_units() {
    let folder = demo();
    let run = cdpr_in(folder.path(), "export svg demo --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json_with(&["result", "candidate", "out", "files", "skipped"]);
    assert_eq!((answer["out"].as_str(), answer["skipped"].as_array().map(Vec::len)), (Some("demo/figures"), Some(0)));
    for (name, shown) in [
        ("model-ladder.svg", "mean pose error on validation data in mm, logarithmic"),
        ("residuals.svg", "residual in mm"),
        ("error-map-xy.svg", "position error in mm"),
        ("error-map-xz.svg", "z in m"),
        ("correlations.svg", "platform-anchor[3].y"),
        ("singular-values.svg", "singular value"),
        ("convergence.svg", "weighted sum of squares"),
    ] {
        assert!(answer["files"].as_array().unwrap().iter().any(|file| file == name), "{name}");
        let text = std::fs::read_to_string(folder.path().join("demo/figures").join(name)).unwrap();
        let document = roxmltree::Document::parse(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
        let root = document.root_element();
        assert_eq!(root.tag_name().namespace(), Some("http://www.w3.org/2000/svg"));
        let width: f64 = root.attribute("width").unwrap().strip_suffix("mm").unwrap().parse().unwrap();
        assert!(width <= 180.0, "{name} fits a page of A4");
        assert!(document.descendants().any(|node| node.text() == Some(shown)), "`{shown}` is not in {name}");
        let refers = |name: &str| name == "href" || name == "src";
        assert!(!document.descendants().any(|node| node.attributes().any(|it| refers(it.name()))), "{name}");
    }
}

#[test]
fn tables_hold_the_numbers_of_the_result() {
    let folder = demo();
    let run = cdpr_in(folder.path(), "export csv demo --out tables");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let result: serde_json::Value =
        serde_json::from_slice(&std::fs::read(folder.path().join("demo/result.json")).unwrap()).unwrap();
    let recommended = result["recommended"].as_str().unwrap();
    let candidates = result["candidates"].as_array().unwrap();
    let own = candidates.iter().find(|candidate| candidate["name"] == recommended).unwrap();
    let table = |name: &str| rows(&folder.path().join("tables").join(name));

    let ladder = table("model-ladder.csv");
    assert_eq!(ladder.len(), 1 + candidates.len());
    let first = &candidates[0];
    let errors = [first["train"]["position_error_m"]["mean"].as_f64(), first["criterion"].as_f64()];
    let at = |column: usize| ladder[1][column].parse::<f64>().ok();
    assert_eq!([at(4), at(5)], errors, "the first candidate frees nothing, so that its line has no quotes");
    let compared = ["mean", "difference", "difference_standard_error"].map(|key| first["compared"][key].as_f64());
    assert_eq!([at(7), at(8), at(9)], compared);
    assert_eq!((compared[1], ladder[1][10].as_str()), (first["difference_m"].as_f64(), "false"), "not calibrated");

    let errors = table("pose-errors.csv");
    let column: Vec<f64> = errors[1..].iter().map(|row| row[4].parse().unwrap()).collect();
    let mean = column.iter().sum::<f64>() / column.len() as f64;
    let stated = own["validation"]["position_error_m"]["mean"].as_f64().unwrap();
    assert!((mean - stated).abs() < 1e-12 * stated, "{mean} is not {stated}"); // another order of summation
    assert_eq!(table("residuals.csv")[0].len(), 9);

    let count = usize::try_from(own["parameter_count"].as_u64().unwrap()).unwrap();
    assert_eq!(table("parameters.csv").len(), 1 + count);
    let correlations = table("correlations.csv");
    assert_eq!(correlations.len(), 1 + count);
    for i in 1..=count {
        let entry = |i: usize, j: usize| correlations[i][j].parse::<f64>().unwrap();
        assert!((entry(i, i) - 1.0).abs() < 1e-12, "rounding of a quotient");
        (1..i).for_each(|j| assert!(entry(i, j) == entry(j, i) && entry(i, j).abs() <= 1.0 + 1e-12));
    }
    let values = table("singular-values.csv");
    let [largest, smallest] = [&values[1], values.last().unwrap()].map(|row| row[1].parse::<f64>().unwrap());
    let condition = own["condition"].as_f64().unwrap();
    assert!((largest / smallest / condition - 1.0).abs() < 1e-12, "condition is their ratio");
}

#[test]
fn an_identifications_answer_has_figures_too() {
    let folder = demo();
    let fit = cdpr_in(
        folder.path(),
        "identify demo/robot.toml demo/training.csv --free frame-anchor,length-offset --format json",
    );
    std::fs::write(folder.path().join("fit.json"), &fit.stdout).unwrap();
    let run = cdpr_in(folder.path(), "export csv fit.json --out tables --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    assert_eq!(run.json()["files"], serde_json::json!(["parameters.csv", "singular-values.csv", "convergence.csv"]));
    assert!(run.stderr.contains("model-ladder.csv is not written: no candidates"), "{}", run.stderr);
    let values = rows(&folder.path().join("tables/singular-values.csv"));
    let read: Vec<f64> = values[1..].iter().map(|row| row[1].parse().unwrap()).collect();
    assert_eq!(read, numbers(&fit.json()["singular_values"]));
}

#[test]
fn what_is_no_result_is_refused_with_its_place() {
    let folder = demo();
    let path = folder.path().join("demo");
    assert_eq!(cdpr_in(folder.path(), "export svg nowhere").exit_code, 4);
    let refused = |place: &str, message: &str| {
        let run = cdpr_in(folder.path(), "export svg demo --out out");
        assert_eq!(run.exit_code, 2, "{message}");
        assert!(run.stderr.contains(place) && run.stderr.contains(message), "{}", run.stderr);
        assert!(!folder.path().join("out").exists(), "nothing is written");
    };
    let table = path.join("singular-values.csv");
    std::fs::write(&table, "candidate,number,singular_value\n\"a\",1,x\nb\n").unwrap();
    refused("demo/singular-values.csv:3", "no table");
    std::fs::write(&table, "candidate,number,value\n").unwrap();
    refused("demo/singular-values.csv:1", "`singular_value` is missing");
    std::fs::write(path.join("result.json"), "{\"candidates\": 5}").unwrap();
    refused("demo/result.json:1", "no result");
    std::fs::write(path.join("result.json"), "{\n  \"criterion\": \"beauty\"\n}").unwrap();
    refused("demo/result.json:2", "unknown variant `beauty`, expected one of `position`, `rotation`");
    std::fs::remove_file(path.join("result.json")).unwrap();
    assert!(cdpr_in(folder.path(), "export svg demo").stderr.contains("RESULT is a folder"));
}

/// A folder that lacks a table, of an older version for instance, gives the other figures and says what is missing.
#[test]
fn missing_tables_are_said_and_cost_only_their_own_figures() {
    let folder = demo();
    std::fs::remove_file(folder.path().join("demo/correlations.csv")).unwrap();
    let run = cdpr_in(folder.path(), "export svg demo");
    assert_eq!(run.exit_code, 0);
    assert!(run.stderr.contains("correlations.svg is not written"), "{}", run.stderr);
    assert!(folder.path().join("demo/figures/residuals.svg").exists());
}

/// Lines of a printer's configuration say of a robot what its file does, in millimetres.
#[test]
fn firmware_reads_back_the_anchors_and_spools_of_the_robot() {
    let folder = tempfile::tempdir().unwrap();
    let anchors = [
        [0.016, -1.61288, -0.13365],
        [1.27426, 1.21179, -0.15572],
        [-1.41237, 0.73526, -0.15511],
        [0.02143, 0.00227, 2.36536],
    ];
    let radii = [0.07581, 0.07594, 0.07539, 0.0752];
    let advantages = [2.0, 2.0, 2.0, 4.0];
    let mut robot =
        "layout_version = 1\nname = \"printer\"\nmotion_pattern = \"3T\"\nkind = \"spatial\"\ncable_count = 4\n"
            .to_owned();
    for k in 0..4 {
        robot += &format!(
            "[[cable]]\nname = \"{k}\"\nframe_anchor_m = {:?}\ndrum_radius_m = {}\nspool_build_up_m = 5e-5\nmechanical_advantage = {}\ngear_ratio = 12.75\n",
            anchors[k], radii[k], advantages[k]
        );
    }
    std::fs::write(folder.path().join("printer.toml"), robot).unwrap();
    let numbers = |text: &str| -> Vec<f64> { text.split(':').map(|number| number.parse().unwrap()).collect() };
    let near = |found: f64, expected: f64| assert!((found - expected).abs() < 6e-4, "{found} {expected}");

    let run = cdpr_in(folder.path(), "export reprapfirmware printer.toml");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    assert!(run.stderr.contains("gear_ratio 12.75:12.75:12.75:12.75"), "{}", run.stderr);
    let words: Vec<Vec<&str>> = run.stdout.lines().map(|line| line.split(' ').collect()).collect();
    assert_eq!((words[0][0], words[0][1], words[1][0]), ("M669", "K6", "M666"));
    for ((word, letter), anchor) in words[0][2..].iter().zip("ABCD".chars()).zip(anchors) {
        let found = numbers(word.strip_prefix(letter).unwrap());
        found.into_iter().zip(anchor).for_each(|(found, metres)| near(found, 1e3 * metres));
    }
    let field = |letter: char| numbers(words[1].iter().find_map(|word| word.strip_prefix(letter)).unwrap());
    assert_eq!((field('Q'), field('U')), (vec![0.05], advantages.to_vec()));
    field('R').into_iter().zip(radii).for_each(|(found, metres)| near(found, 1e3 * metres));

    let run = cdpr_in(folder.path(), "export klipper printer.toml --out printer.cfg");
    assert!(run.exit_code == 0 && run.stderr.contains("spool_build_up_m"), "{}", run.stderr);
    let text = std::fs::read_to_string(folder.path().join("printer.cfg")).unwrap();
    let sections: Vec<&str> = text.split("[stepper_").skip(1).collect();
    assert_eq!(sections.len(), 4);
    for (k, section) in sections.into_iter().enumerate() {
        let value = |key: &str| -> f64 {
            section.lines().find_map(|line| line.strip_prefix(&format!("{key}: "))).unwrap().parse().unwrap()
        };
        ["anchor_x", "anchor_y", "anchor_z"]
            .into_iter()
            .zip(anchors[k])
            .for_each(|(key, metres)| near(value(key), 1e3 * metres));
        near(value("rotation_distance"), 1e3 * std::f64::consts::TAU * radii[k] / (12.75 * advantages[k]));
    }

    let refused = cdpr_in(folder.path(), "export klipper cablerobot-simulator-helicopter");
    assert!(refused.exit_code == 2 && refused.stderr.contains("export::firmware"), "{}", refused.stderr);
}

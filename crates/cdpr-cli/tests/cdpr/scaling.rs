//! Scales, weights of rows and maps of the condition in `cdpr identify`.

use super::{Run, cdpr_in, root};

/// Record of the example of sec. 4.5, in a folder of its own.
fn recorded() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let study = root().join("studies/planar-force-tracking.toml");
    let run = cdpr_in(folder.path(), &format!("simulate {} --out tracking.csv", study.display()));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    folder
}

fn identify(folder: &tempfile::TempDir, options: &str) -> Run {
    let free = "--model elastic --starts 1 --free frame-anchor,compliance,wrench";
    cdpr_in(folder.path(), &format!("identify planar-example tracking.csv {free} {options}"))
}

/// The figure of the chapter, and the numbers beside it; what is asked of scales changes no parameter, what is asked of weights does.
#[test]
fn scales_tell_the_condition_apart_and_move_nothing() {
    let folder = recorded();
    let weights = "--row-weight length=1e4,wrench=1";
    let scales = "--scale axial-stiffness=1e6,wrench=1e3 --condition-map axial-stiffness,wrench map.svg";
    let scaled = identify(&folder, &format!("{weights} {scales} --format json")).json();
    let figure = root().join("docs/book/src/figures/condition-map.svg");
    let drawn = std::fs::read_to_string(folder.path().join("map.svg")).unwrap();
    assert!(drawn == std::fs::read_to_string(figure).unwrap(), "draw the figure of the chapter again");
    let number = |key: &str| scaled["scaling"][key].as_f64().unwrap();
    assert!((number("condition_scaled") - 12.8).abs() < 0.05, "{}", number("condition_scaled"));
    let influences = scaled["scaling"]["influences"].as_array().unwrap();
    let product: f64 = influences.iter().map(|one| one["factor"].as_f64().unwrap()).product();
    assert!((product / number("condition") - 1.0).abs() < 1e-9);
    let plain = identify(&folder, &format!("{weights} --format json")).json();
    assert_eq!(plain["parameters"], scaled["parameters"]);
    assert!(plain.get("scaling").is_none());
    let cost = plain["history"].as_array().unwrap().last().unwrap().as_f64().unwrap();
    assert!((cost - 179_195.718).abs() < 0.01, "{cost}");
    let by_accuracies = identify(&folder, "--format json").json();
    assert_ne!(plain["parameters"][0]["value"], by_accuracies["parameters"][0]["value"]);
}

#[test]
fn found_scales_are_named_in_text_and_page() {
    let folder = recorded();
    let run = identify(&folder, "--row-weight length=1e4,wrench=1 --scale auto --report page.html");
    for words in ["under found scales", "is structure ", "  samples: κ "] {
        assert!(run.stdout.contains(words), "{words}: {}", run.stdout);
    }
    let page = std::fs::read_to_string(folder.path().join("page.html")).unwrap();
    assert!(page.contains("What makes the condition"));
}

#[test]
fn scales_that_cannot_be_are_refused() {
    let folder = recorded();
    for (options, code) in [
        ("--scale width=3", "parameter::unknown-name"),
        ("--scale wrench=0", "scale::syntax"),
        ("--condition-map wrench map.svg", "scale::syntax"),
        ("--condition-map wrench,length-offset map.svg", "scale::syntax"),
        ("--row-weight length=1 --loss huber", "setting::cost"),
    ] {
        let run = identify(&folder, options);
        assert!(run.exit_code == 2 && run.stderr.contains(code), "{options}: {}", run.stderr);
    }
}

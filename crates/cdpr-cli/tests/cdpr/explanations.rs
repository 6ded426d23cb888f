//! Error codes: shown with every error, explained by `cdpr explain`.

use super::{SQUARE, cdpr, cdpr_in, file_with};

#[test]
fn an_error_shows_its_code_in_words_and_in_json_and_the_code_is_explained() {
    let (folder, _) = file_with("robot.toml", SQUARE.replacen("frame_anchor_m", "frame_ancor_m", 1).as_bytes());
    for (arguments, code) in [
        ("check robot.toml", "toml::unknown-key"),
        ("check planar-exampel", "robot::unknown-name"),
        ("check nowhere.toml", "io::read"),
        ("check", "usage::missing-argument"),
        ("nonsense", "usage::unknown-command"),
        ("check planar-example --wide", "usage::unknown-option"),
        ("schema wine", "usage::value"),
        ("ik planar-example --pose 1,2 --model pully", "model::unknown-effect"),
        ("ik planar-example --pose 1,2 --model pulley", "model::missing-key"),
        ("ik planar-example --pose 1,2,3", "pose::component-count"),
        ("fk planar-example --lengths 1,2,3", "lengths::count"),
        ("load planar-example --pose 1,2 --tensions 1,2,-3,4", "tensions::negative"),
        ("identify planar-example data.csv --free frame-ankor", "parameter::unknown-name"),
        ("select planar-example data.csv --require position=1", "requirement::unknown-figure"),
        ("select planar-example data.csv --split halves", "split::syntax"),
        ("identify planar-example data.csv --free frame-anchor --row-weight 3", "scale::syntax"),
        ("select planar-example data.csv --candidates ;", "candidate::none"),
        ("explain nothing-like-it", "usage::unknown-code"),
        ("place-pulleys planar-example --axis 0,1 --out nowhere/robot.toml --radius 0.1", "io::write"),
    ] {
        let run = cdpr_in(folder.path(), &format!("{arguments} --format json"));
        assert_eq!(run.json()["code"], code, "{arguments}: {}", run.stderr);
        assert!(run.stderr.starts_with(&format!("error[{code}]: ")), "{arguments}: {}", run.stderr);
        let page = cdpr(&format!("explain {code}"));
        assert_eq!(page.exit_code, 0, "{code}");
        assert!(page.stdout.starts_with(code) && page.stdout.contains("Mend: "), "{}", page.stdout);
    }
}

#[test]
fn without_a_code_all_are_listed() {
    let list = cdpr("explain").stdout;
    let codes = cdpr("explain --format json").json()["codes"].as_array().unwrap().clone();
    assert!(codes.len() > 100, "{}", codes.len());
    assert!(codes.iter().all(|entry| list.contains(entry["code"].as_str().unwrap())));
}

#[test]
fn the_last_part_of_a_code_is_enough_where_it_is_unique() {
    assert_eq!(cdpr("explain ragged-row").stdout, cdpr("explain csv::ragged-row").stdout);
    let ambiguous = cdpr("explain empty");
    assert_eq!(ambiguous.exit_code, 2);
    assert!(
        ambiguous.stderr.contains("csv::empty") && ambiguous.stderr.contains("toml::empty"),
        "{}",
        ambiguous.stderr
    );
    assert!(cdpr("explain csv::raged-row").stderr.contains("did you mean `csv::ragged-row`?"));
}

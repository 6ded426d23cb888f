//! Words proposed for command lines.

use clap::CommandFactory;

use super::proposals::Files;
use super::*;
use crate::CommandLine;

/// Words proposed for a command line without `cdpr`, whose last word is the one after the last blank.
fn proposed(line: &str) -> Vec<String> {
    told(line).1
}

/// The first line of the answer, and the words.
fn told(line: &str) -> (String, Vec<String>) {
    let words: Vec<String> = line.split(' ').map(str::to_owned).collect();
    let answer = answer(CommandLine::command(), &words);
    let (first, rest) = answer.split_once('\n').unwrap();
    (first.to_owned(), rest.lines().map(|line| line.split_once('\t').unwrap().0.to_owned()).collect())
}

fn assert_has(line: &str, words: &[&str]) {
    let found = proposed(line);
    words.iter().for_each(|word| assert!(found.iter().any(|one| one == word), "{line}: no {word} in {found:?}"));
}

fn assert_lacks(line: &str, words: &[&str]) {
    let found = proposed(line);
    words.iter().for_each(|word| assert!(!found.iter().any(|one| one == word), "{line}: {word} in {found:?}"));
}

#[test]
fn scripts_alone_ask() {
    let asked = |line: &str| asked(&line.split(' ').map(OsString::from).collect::<Vec<_>>());
    assert_eq!(asked("cdpr complete -- fk x"), Some(vec!["fk".to_owned(), "x".to_owned()]));
    assert_eq!(asked("cdpr complete fk"), None);
    assert_eq!(asked("cdpr completions bash"), None);
}

#[test]
fn commands_are_proposed_first_and_options_after_a_dash() {
    assert_has("", &["fk", "identify", "completions", "help"]);
    assert_eq!(proposed("iden"), ["identify"]);
    assert_eq!(proposed("help iden"), ["identify"]);
    assert_eq!(proposed("import "), ["caspr", "help"]);
    assert_has("-", &["--format", "--help", "--version"]);
    assert_has("fk planar-example -", &["--lengths", "--model", "--format", "--quiet", "--help"]);
    // where no value is left to name, options are what may come
    assert_has("fk planar-example ", &["--lengths"]);
    assert_eq!(proposed("fk planar-example -- "), [""; 0]);
}

#[test]
fn an_option_is_given_once_unless_it_may_be_repeated() {
    assert_lacks("workspace planar-example --model pulley --", &["--model"]);
    assert_lacks("workspace planar-example --model=pulley --", &["--model"]);
    assert_has("workspace planar-example --criterion wrench-closure --", &["--criterion", "--model"]);
}

#[test]
fn robots_are_built_in_names_and_files() {
    let (first, robots) = told("fk ");
    assert_eq!(first, ".toml space");
    assert!(robots.iter().map(String::as_str).eq(cdpr_model::robot::builtin::names()), "{robots:?}");
    assert_has("fk --model pulley ", &["cogiro"]);
    assert_has("--format json fk ", &["cogiro"]);
    assert_eq!(told("robots pl").0, "none space");
    assert_has("benchmark --robots cogiro,", &["cogiro,ipanema-1"]);
    assert_lacks("benchmark --robots cogiro,", &["cogiro,cogiro"]);
    assert_has("identify r.toml d.csv --compare ", &["cogiro"]);
}

#[test]
fn effects_are_those_that_fit_what_is_composed() {
    let (first, single) = told("ik cogiro --model ");
    assert_eq!(first, "none open");
    assert!(
        ["standard", "pulley", "drum", "elastic", "catenary"].iter().all(|word| single.iter().any(|one| one == word))
    );
    assert_has("ik cogiro --model pulley+", &["pulley+elastic", "pulley+catenary"]);
    assert_lacks("ik cogiro --model pulley+", &["pulley+pulley", "pulley+standard"]);
    assert_lacks("ik cogiro --model elastic+pulley+", &["elastic+pulley+hysteresis", "elastic+pulley+elastic"]);
    assert_has("ik cogiro --model=elastic+pulley+", &["--model=elastic+pulley+finite-element"]);
    assert_eq!(proposed("ik cogiro --model standard+"), [""; 0]);
    assert_has("benchmark --models standard,pulley+", &["standard,pulley+elastic"]);
}

#[test]
fn parameters_are_those_that_a_list_lacks() {
    assert_has("identify r d --free ", &["frame-anchor", "length-offset", "clock-offset"]);
    assert_has("identify r d --free frame-anchor,", &["frame-anchor,length-offset"]);
    assert_lacks("identify r d --free frame-anchor,", &["frame-anchor,frame-anchor"]);
    assert_lacks("identify r d --free frame-anchor[1,3],", &["frame-anchor[1,3],frame-anchor"]);
    assert_has("identify r d --free frame-anchor[1,3],", &["frame-anchor[1,3],platform-anchor"]);
    assert_eq!(proposed("identify r d --free frame-anchor[1,"), [""; 0]);
    assert_has("select r d --prior platform-anchor=0.02,", &["platform-anchor=0.02,frame-anchor="]);
    assert_has("identify r d --known ", &["distance[", "level["]);
    assert_has("identify r d --scale ", &["auto", "compliance=", "axial-stiffness="]);
    assert_has("identify r d --condition-map ", &["compliance"]);
    assert_eq!(told("identify r d --condition-map compliance,wrench "), ("any space".to_owned(), Vec::new()));
}

#[test]
fn criteria_come_with_their_numbers() {
    let criteria = proposed("workspace cogiro --criterion ");
    let names = cdpr_workspace::criterion::registry::ENTRIES.iter().map(|entry| entry.name);
    assert!(criteria.iter().map(|word| word.trim_end_matches(':')).eq(names), "{criteria:?}");
    assert_has("workspace cogiro --criterion wrench-set-feasible:", &["wrench-set-feasible:force="]);
    let next = "workspace cogiro --criterion wrench-set-feasible:force=10,";
    assert_has(next, &["wrench-set-feasible:force=10,moment="]);
    assert_lacks(next, &["wrench-set-feasible:force=10,force="]);
}

#[test]
fn candidates_are_models_with_their_free_parameters() {
    assert_has("select r d --candidates standard;pul", &["standard;pulley"]);
    assert_has("select r d --candidates 'standard;pulley+", &["standard;pulley+elastic"]);
    assert_has("select r d --candidates standard:length-offset,", &["standard:length-offset,frame-anchor"]);
}

#[test]
fn names_of_short_lists_come_from_their_tables() {
    assert_has("tension cogiro --method ", &["closed-form", "minimum"]);
    assert_has("initial-tension study.toml --target ", &["closed-form"]);
    assert_has("tension cogiro --reference ", &["middle", "previous"]);
    assert_has("identify r d --loss ", &["huber"]);
    assert_has("identify r d --split ", &["column", "blocks:"]);
    assert_has("select r d --require position_", &["position_mean_m="]);
    assert_has("select r d --sigma ", &["length_m="]);
    assert_has("explain csv::", &["csv::ragged-row"]);
    assert_has("schema ", &["robot", "sweep"]);
    assert_has("new ", &["wall-plotter"]);
    assert_has("completions ", &["bash", "fish"]);
    assert_has("modes cogiro --winches ", &["ideal", "drums"]);
    assert_has("ik cogiro --format ", &["json"]);
}

#[test]
fn files_are_of_the_kind_that_is_read() {
    for (line, first) in [
        ("study ", ".toml space"),
        ("identify r ", ".csv space"),
        ("identify r d --free frame-anchor --out ", "any space"),
        ("study s.toml --out ", "folders space"),
        ("import caspr ", ".xml space"),
        ("fk cogiro --lengths ", "none space"),
    ] {
        assert_eq!(told(line).0, first, "{line}");
    }
}

/// A list of another name or type than those known would be proposed nothing.
#[test]
fn every_argument_has_values_unless_nobody_can_know_them() {
    const FREE: [&str; 13] =
        ["COLUMN", "NAME", "NAME=COLUMN,…", "NAME=1,3,…", "i/n", "BOX", "N", "K", "SEED", "COUNT", "RADIUS", "S", "P"];
    fn check(command: &Command, missing: &mut Vec<String>) {
        for argument in command.get_arguments().filter(|one| one.get_action().takes_values()) {
            let of_text = argument.get_value_parser().type_id() == std::any::TypeId::of::<String>();
            let name = argument.get_value_names().map_or("", |names| names[0].as_str());
            let proposals = values::of(command.get_name(), argument, 0, "");
            let has_none = proposals.words.is_empty() && proposals.files == Files::None;
            if has_none && of_text && !FREE.contains(&name) {
                missing.push(format!("{} {}", command.get_name(), argument));
            }
        }
        command.get_subcommands().for_each(|inner| check(inner, missing));
    }
    let (mut root, mut missing) = (CommandLine::command(), Vec::new());
    root.build();
    root.get_subcommands().filter(|inner| inner.get_name() != "help").for_each(|inner| check(inner, &mut missing));
    assert!(missing.is_empty(), "{missing:?}");
}

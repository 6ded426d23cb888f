//! Values of an argument: by its choices, by the type that it is read into, else by the name of its value in the help.

use std::any::TypeId;
use std::path::PathBuf;

use cdpr_calibration::fit::{Prior, RowWeights};
use cdpr_calibration::selection::Requirement;
use cdpr_model::measurement::{Known, Split};
use cdpr_model::model::{Composition, FreeParameters};
use cdpr_model::reading::Keyword;
use cdpr_model::robot::{ParameterKind, builtin};
use cdpr_model::tension::Method;
use cdpr_reports::explanations;
use clap::Arg;

use super::lists::{candidates, composition, criterion, listed, parameters};
use super::proposals::{Files, Proposal, Proposals, first_sentence, plain};
use crate::commands;
use crate::measurements::SigmaOption;
use crate::selecting::CandidateList;
use crate::tension_method::ReferenceArgument;

/// A type.
type Type = fn() -> TypeId;

/// Values of a type, by what is typed of one.
type Values = fn(&str) -> Proposals;

/// Types of values that have names, wherever they are asked for.
const BY_TYPE: &[(Type, Values)] = &[
    (TypeId::of::<Composition>, composition),
    (TypeId::of::<FreeParameters>, |typed| parameters(typed, "")),
    (TypeId::of::<Prior>, |typed| parameters(typed, "=")),
    (TypeId::of::<CandidateList>, candidates),
    (TypeId::of::<Method>, |_| methods()),
    (TypeId::of::<commands::initial_tension::TargetArgument>, |_| methods()),
    (TypeId::of::<ReferenceArgument>, |_| Proposals::of(ReferenceArgument::WORDS.map(plain))),
    (TypeId::of::<Split>, |_| splits()),
    (TypeId::of::<Known>, |_| Proposals::of(Known::NAMES.map(|name| plain(format!("{name}["))))),
    (TypeId::of::<SigmaOption>, |typed| listed(typed, SigmaOption::names().map(plain), "=")),
    (TypeId::of::<Requirement>, |typed| listed(typed, Requirement::figures().map(plain), "=")),
    (TypeId::of::<RowWeights>, |typed| listed(typed, RowWeights::NAMES.map(plain), "=")),
];

/// Values that a command's argument may have, of which this is typed.
pub(super) fn of(command: &str, argument: &Arg, index: usize, typed: &str) -> Proposals {
    let choices = argument.get_possible_values();
    if !choices.is_empty() {
        let shown = choices.iter().filter(|choice| !choice.is_hide_set());
        let help = |choice: &clap::builder::PossibleValue| choice.get_help().map(first_sentence).unwrap_or_default();
        return Proposals::of(shown.map(|choice| Proposal::new(choice.get_name(), help(choice))));
    }
    let read_into = argument.get_value_parser().type_id();
    if let Some((_, values)) = BY_TYPE.iter().find(|(of_type, _)| read_into == of_type()) {
        return values(typed);
    }
    let name = argument.get_value_names().and_then(|names| names.get(index)).map_or("", |name| name.as_str());
    by_name(command, name, typed).unwrap_or_else(|| match read_into == TypeId::of::<PathBuf>() {
        true => Proposals::files(files(name)),
        false => Proposals::default(),
    })
}

/// Values by their name in the help, which stands for the same wherever a text is asked for.
fn by_name(command: &str, name: &str, typed: &str) -> Option<Proposals> {
    let robots = || builtin::names().map(plain);
    Some(match (command, name) {
        (_, "ROBOT") => Proposals::of(robots()).with_files(Files::Ending(".toml")),
        (_, "ROBOT,…") => listed(typed, robots(), "").with_files(Files::Ending(".toml")),
        // figures of a result, or firmware of a robot
        (_, "RESULT") => Proposals::of(robots()).with_files(Files::Any),
        ("robots", "NAME") => Proposals::of(robots()),
        ("new", "NAME") => Proposals::of(commands::new::names().map(plain)),
        ("plan", "COMMAND") => Proposals::of(["benchmark", "campaign", "sensitivity"].map(plain)),
        (_, "CODE") => {
            Proposals::of(explanations::all().map(|one| Proposal::new(one.code, first_sentence(one.summary()))))
        }
        (_, "CRITERION") => criterion(typed),
        (_, "NAME,…" | "A,B") => parameters(typed, ""),
        (_, "NAME=UNIT,…|auto") => {
            let mut kinds = parameters(typed, "=");
            kinds.words.extend(listed(typed, [plain(ParameterKind::AxialStiffness.name())], "=").words);
            kinds.words.push(plain("auto"));
            kinds
        }
        // the second value of an option with two
        ("identify", "FILE") => Proposals::files(Files::Any),
        _ => return None,
    })
}

/// Files by the name of the value: a kind of file of ours, or an ending.
fn files(name: &str) -> Files {
    match name {
        "STUDY" | "SWEEP" | "SCENARIO" | "ROBOT.toml" => Files::Ending(".toml"),
        "DATA" | "RECORD" | "POSES.csv" => Files::Ending(".csv"),
        "BODIES.xml" | "CABLES.xml" => Files::Ending(".xml"),
        "DIR" => Files::Folders,
        _ => Files::Any,
    }
}

fn methods() -> Proposals {
    Proposals::of(Method::ALL.iter().map(|method| Proposal::new(method.name(), method.summary())))
}

fn splits() -> Proposals {
    let is_whole = |kind: &str| kind.parse::<Split>().is_ok();
    Proposals::of(Split::KINDS.map(|kind| plain(if is_whole(kind) { kind.to_owned() } else { format!("{kind}:") })))
}

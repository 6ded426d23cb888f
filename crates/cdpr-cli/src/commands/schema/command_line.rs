//! The command line as data: what other languages make their functions of.

use std::any::TypeId;
use std::path::PathBuf;

use clap::{Arg, ArgAction, Command};
use serde_json::{Value, json};

/// All commands with their arguments: names, help, kinds of values.
pub(super) fn described(root: &Command) -> Value {
    let shared: Vec<Value> = root.get_arguments().filter(|argument| is_shown(argument)).map(argument).collect();
    json!({ "commands": commands(root, ""), "options": shared })
}

fn commands(root: &Command, before: &str) -> Vec<Value> {
    let own = root.get_subcommands().filter(|command| command.get_name() != "help" && !command.is_hide_set());
    own.flat_map(|command| {
        let name = format!("{before}{}", command.get_name());
        let inner = commands(command, &format!("{name} "));
        if !inner.is_empty() {
            return inner;
        }
        let is_own = |argument: &&Arg| is_shown(argument) && !argument.is_global_set();
        let arguments: Vec<Value> = command.get_arguments().filter(is_own).map(argument).collect();
        vec![json!({
            "name": name,
            "about": text(command.get_about()),
            "more": text(command.get_long_about()),
            "arguments": arguments,
        })]
    })
    .collect()
}

fn is_shown(argument: &Arg) -> bool {
    !argument.is_hide_set() && !matches!(argument.get_id().as_str(), "help" | "version")
}

fn argument(argument: &Arg) -> Value {
    let is_flag = matches!(argument.get_action(), ArgAction::SetTrue | ArgAction::Count);
    let is_list = argument.get_value_delimiter().is_some();
    let repeats = matches!(argument.get_action(), ArgAction::Append) && !is_list;
    let parser = argument.get_value_parser().type_id();
    let is_of = |kind: TypeId| parser == kind;
    let whole = [TypeId::of::<usize>(), TypeId::of::<u64>(), TypeId::of::<u32>(), TypeId::of::<u16>()];
    let kind = match () {
        () if is_flag => "flag",
        () if is_list => "list",
        () if is_of(TypeId::of::<PathBuf>()) => "path",
        () if is_of(TypeId::of::<f64>()) => "number",
        () if whole.into_iter().any(is_of) => "integer",
        () => "text",
    };
    let choices = argument.get_possible_values().into_iter().map(|value| value.get_name().to_owned());
    let defaults = argument.get_default_values().iter().map(|value| value.to_string_lossy().into_owned());
    json!({
        "name": argument.get_id().as_str(),
        "option": argument.get_long(),
        "value": argument.get_value_names().and_then(|names| names.first()).map(ToString::to_string),
        "kind": kind,
        "required": argument.is_required_set(),
        "repeats": repeats,
        "default": defaults.collect::<Vec<_>>().first(),
        "choices": if is_flag { Vec::new() } else { choices.collect::<Vec<_>>() },
        "help": text(argument.get_long_help().or(argument.get_help())),
    })
}

fn text(styled: Option<&clap::builder::StyledStr>) -> Option<String> {
    styled.map(ToString::to_string)
}

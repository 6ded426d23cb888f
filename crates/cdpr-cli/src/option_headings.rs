//! Headings under which `cdpr COMMAND --help` lists the options, one table for all commands.

use clap::{Arg, Command};

/// Options that every command takes, the help among them.
pub(crate) const GENERAL: &str = "General";

/// A command with fewer options of its own has them in one list.
const MANY: usize = 6;

/// Headings and the options under them, in the order of the help: an option stands under the same heading wherever it
/// is taken. One that has another meaning in some command is named with that command, `command option`.
const HEADINGS: &[(&str, &[&str])] = &[
    ("Robot and model", &["model", "compensation"]),
    ("Candidates", &["candidates", "criterion", "require"]),
    ("Criteria and orientations", &["workspace criterion", "rotation", "archetype", "angles", "orientations"]),
    (
        "Pose and load",
        &[
            "pose",
            "position",
            "guess",
            "twist",
            "acceleration",
            "lengths",
            "motor-angles",
            "tensions",
            "recorded",
            "wrench",
            "box",
            "payload-place",
        ],
    ),
    (
        "Tensions",
        &[
            "min",
            "max",
            "method",
            "tension-method",
            "p",
            "smoothing",
            "moment-length",
            "reference",
            "previous",
            "rate",
            "time-step",
        ],
    ),
    ("Parameters", &["free", "hold", "prior", "known", "gauge"]),
    (
        "Poses to choose",
        &["count", "plan criterion", "plan candidates", "study", "given", "tension-levels", "tension-tests", "repeats"],
    ),
    ("Data", &["sigma", "columns", "skip-invalid", "merge", "merge-gap", "static"]),
    ("Record", &["input", "output", "frequency-response method", "window", "coherence", "max-poles", "orders"]),
    ("Validation", &["validation", "split", "regions"]),
    ("Objective", &["objective", "minimize", "loss", "rotation-length", "task", "row-weight"]),
    ("Penalties", &["path", "towards", "shrink"]),
    ("Accuracy", &["accuracy", "offsets", "linear", "vary", "change"]),
    (
        "Calculation",
        &[
            "workspace method",
            "reachable method",
            "bounds",
            "center",
            "step",
            "rays",
            "gap",
            "capability poses",
            "tolerance",
            "minimizer",
            "engine",
            "starts",
            "robots",
            "seed",
            "resume",
        ],
    ),
    (
        "Trust",
        &[
            "profile",
            "bootstrap",
            "uncertainty",
            "scale",
            "condition-map",
            "compare-objectives",
            "compare",
            "drive",
            "accept-untrusted",
        ],
    ),
    (
        "Output",
        &[
            "jacobians",
            "top",
            "out",
            "out-reduced",
            "out-poses",
            "out-errors",
            "report",
            "page",
            "overlay",
            "mesh",
            "emerging-mesh",
            "csv",
            "poses-csv",
            "map",
            "svg",
            "out-path",
            "path-figure",
            "course",
            "course-table",
            "course-figure",
        ],
    ),
];

/// The command whose subcommands, at any depth, have their options under headings, in the order of the table.
pub(crate) fn under_headings(command: Command) -> Command {
    command.mut_subcommands(|inner| {
        let inner = under_headings(inner);
        let name = inner.get_name().to_owned();
        let has_many = own_options(&inner).count() >= MANY;
        let place = |option: &Arg| if has_many { place(&name, option) } else { None };
        // headings come in the order of the arguments, of which `mut_args` hands out one after the other
        let mut arguments: Vec<Arg> = inner.get_arguments().cloned().collect();
        arguments.sort_by_key(|argument| place(argument).map_or(0, |(heading, _)| heading + 1));
        let mut arguments = arguments.into_iter();
        let placed = inner.mut_args(|one| {
            let argument = arguments.next().unwrap_or(one);
            match place(&argument) {
                Some((heading, order)) => argument.help_heading(HEADINGS[heading].0).display_order(order),
                None => argument,
            }
        });
        with_help_under_general(placed)
    })
}

/// Number of the heading of a command's option, and the option's under it; `None` if the option stands under none.
fn place(command: &str, option: &Arg) -> Option<(usize, usize)> {
    let name = option.get_long()?;
    let of = |name: &str| {
        let mut rows = HEADINGS.iter().enumerate();
        rows.find_map(|(heading, (_, options))| Some((heading, options.iter().position(|option| *option == name)?)))
    };
    of(&format!("{command} {name}")).or_else(|| of(name))
}

/// The command with the parser's own `--help` under the heading of the options that every command takes.
fn with_help_under_general(command: Command) -> Command {
    let mut probe = command.clone();
    probe.build();
    let help = probe.get_arguments().find(|argument| argument.get_id() == "help").cloned();
    match help {
        // the place that the parser gives it: the last
        Some(help) => command.disable_help_flag(true).arg(help.help_heading(GENERAL).display_order(999)),
        None => command,
    }
}

/// Options that the command takes beside those of every command.
fn own_options(command: &Command) -> impl Iterator<Item = &Arg> {
    command.get_arguments().filter(|argument| !argument.is_positional())
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use clap::CommandFactory;

    use super::*;
    use crate::CommandLine;

    /// Every subcommand at any depth, without the parser's own `help`.
    fn all(command: &Command) -> Vec<&Command> {
        let own = command.get_subcommands().filter(|inner| inner.get_name() != "help");
        own.flat_map(|inner| [vec![inner], all(inner)].concat()).collect()
    }

    #[test]
    fn every_option_of_a_long_help_has_a_heading_and_every_heading_has_options() {
        let root = CommandLine::command();
        let mut found = BTreeSet::new();
        for command in all(&root).into_iter().filter(|command| own_options(command).count() >= MANY) {
            for option in own_options(command) {
                let name = option.get_long().unwrap();
                let place = place(command.get_name(), option);
                assert!(place.is_some(), "no heading for `{} --{name}`", command.get_name());
                let exact = format!("{} {name}", command.get_name());
                let is_exact = HEADINGS.iter().any(|(_, options)| options.contains(&exact.as_str()));
                found.insert(if is_exact { exact } else { name.to_owned() });
            }
        }
        for (heading, options) in HEADINGS {
            options.iter().for_each(|option| assert!(found.contains(*option), "{heading}: nobody takes `{option}`"));
        }
    }

    #[test]
    fn headings_come_in_the_order_of_the_table_and_general_options_last() {
        let mut root = under_headings(CommandLine::command());
        root.build();
        for command in all(&root) {
            let mut headings: Vec<&str> = command.get_arguments().filter_map(Arg::get_help_heading).collect();
            headings.dedup();
            assert_eq!(headings.last(), Some(&GENERAL), "{}", command.get_name());
            let distinct: BTreeSet<&str> = headings.iter().copied().collect();
            assert_eq!(distinct.len(), headings.len(), "{}: {headings:?}", command.get_name());
        }
    }
}

//! The calls, by theme.

mod fits;
mod geometry;
mod laws;
mod machines;
mod measured;
mod motion;
mod outside;
mod statics;
mod studies;
mod workspaces;

use crate::group::Group;

/// A robot with the keys of every effect.
const LAB: &str = include_str!("../inputs/lab.toml");

/// All groups; those that take long first, so that two threads end together.
pub(crate) fn groups() -> Vec<Group> {
    let themes = [
        fits::groups(),
        studies::groups(),
        measured::groups(),
        machines::groups(),
        motion::groups(),
        workspaces::groups(),
        laws::groups(),
        statics::groups(),
        geometry::groups(),
        outside::groups(),
    ];
    themes.into_iter().flatten().collect()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::group::Step;

    fn subcommands(groups: &[Group]) -> BTreeSet<String> {
        let steps = groups.iter().flat_map(|group| &group.steps);
        let calls = steps.filter_map(|step| match step {
            Step::Call(call) => call.words.split(' ').next().map(str::to_owned),
            _ => None,
        });
        calls.collect()
    }

    /// A command of its own is a file in the folder of the commands.
    #[test]
    fn every_command_is_called_in_the_part_that_the_test_runs() {
        let folder = crate::root().join("crates/cdpr-cli/src/commands");
        let mut groups = groups();
        groups.retain(|group| group.in_part);
        let called = subcommands(&groups);
        let mut commands = 0;
        for file in std::fs::read_dir(folder).into_iter().flatten().flatten() {
            let path = file.path();
            let Some(name) = path.file_stem().and_then(|name| name.to_str()) else { continue };
            if path.extension().is_some_and(|ending| ending == "rs") && name != "mod" {
                commands += 1;
                assert!(called.contains(&name.replace('_', "-")), "no call of {name}");
            }
        }
        assert!(commands > 30, "{commands}");
    }

    #[test]
    fn names_of_calls_are_unique_and_there_are_six_hundred_at_least() {
        let names: Vec<String> = groups().iter().flat_map(|group| group.names().collect::<Vec<_>>()).collect();
        let mut unique = BTreeSet::new();
        names.iter().for_each(|name| assert!(unique.insert(name), "twice: {name}"));
        assert!(names.len() >= 600, "{}", names.len());
    }

    #[test]
    fn groups_have_folders_of_their_own() {
        let mut unique = BTreeSet::new();
        groups().iter().for_each(|group| assert!(unique.insert(group.name.clone()), "twice: {}", group.name));
    }
}

//! Words after `cargo xtask golden`.

use std::path::PathBuf;

use crate::group::Group;

/// What is asked for.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Options {
    /// The command whose answers are compared.
    pub(crate) command: PathBuf,
    /// The part that `cargo xtask test` runs.
    part: bool,
    /// Groups whose names have this in them.
    only: Option<String>,
    /// Makes the answers the committed ones.
    pub(crate) accept: bool,
    /// Leaves the folders of the groups.
    pub(crate) keep: bool,
    /// Tells the times of the slowest calls.
    pub(crate) times: bool,
}

impl Options {
    pub(crate) fn of(words: &[String]) -> Result<Self, String> {
        let mut options = Self::default();
        let mut words = words.iter().map(String::as_str);
        while let Some(word) = words.next() {
            match word {
                "--part" => options.part = true,
                "--accept" => options.accept = true,
                "--keep" => options.keep = true,
                "--times" => options.times = true,
                "--command" => options.command = words.next().ok_or("--command takes a path")?.into(),
                "--only" => {
                    options.only = Some(words.next().ok_or("--only takes a part of a group's name")?.to_owned())
                }
                other => {
                    return Err(format!(
                        "golden takes --part, --only GROUP, --accept, --command PATH, --times and --keep, not `{other}`"
                    ));
                }
            }
        }
        if options.accept && !options.is_whole() {
            return Err("the corpus is accepted as a whole: leave out --part and --only".to_owned());
        }
        if options.command.as_os_str().is_empty() {
            return Err("--command PATH says which `cdpr` answers".to_owned());
        }
        Ok(options)
    }

    /// Whether all groups are asked for.
    pub(crate) fn is_whole(&self) -> bool {
        !self.part && self.only.is_none()
    }

    pub(crate) fn wants(&self, group: &Group) -> bool {
        (group.in_part || !self.part) && self.only.as_ref().is_none_or(|name| group.name.contains(name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(words: &str) -> Result<Options, String> {
        Options::of(&words.split(' ').map(str::to_owned).collect::<Vec<_>>())
    }

    #[test]
    fn a_part_is_never_accepted() {
        assert!(of("--command cdpr --accept --part").is_err() && of("--command cdpr --accept --only fit").is_err());
        assert!(of("--command cdpr --accept").is_ok_and(|options| options.accept && options.is_whole()));
        assert!(of("--part").is_err() && of("--command cdpr --all").is_err());
    }
}

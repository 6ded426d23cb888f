//! Words after `cargo xtask soak --dirty`.

use std::path::PathBuf;

/// Options of the program.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Options {
    /// The command that answers.
    pub(crate) command: PathBuf,
    /// Number of seeds.
    pub(crate) seeds: u64,
    /// The first seed.
    pub(crate) first: u64,
    /// Counts of choices alone.
    pub(crate) choices: bool,
    /// The fixed cells of the test alone.
    pub(crate) fixed: bool,
    /// Leaves out the kept kinds: for those who choose limits.
    pub(crate) without_kept: bool,
    /// Cells whose names have this in them.
    pub(crate) only: Option<String>,
    /// Leaves the files of the cells.
    pub(crate) keep: bool,
    /// Tells every dirty cell that is not named.
    pub(crate) unnamed: bool,
}

impl Options {
    pub(crate) fn of(words: &[String]) -> Result<Self, String> {
        let mut options = Self { seeds: 1, ..Self::default() };
        let mut words = words.iter().map(String::as_str);
        while let Some(word) = words.next() {
            let mut next = || words.next().ok_or_else(|| format!("{word} takes a value"));
            let number = |text: &str| text.parse().map_err(|_| format!("{word}: `{text}` is no whole number"));
            match word {
                "--command" => options.command = next()?.into(),
                "--dirty" => options.seeds = number(next()?)?,
                "--seed" => options.first = number(next()?)?,
                "--only" => options.only = Some(next()?.to_owned()),
                "--choices" => options.choices = true,
                "--fixed" => options.fixed = true,
                "--without-kept" => options.without_kept = true,
                "--keep" => options.keep = true,
                "--unnamed" => options.unnamed = true,
                other => {
                    return Err(format!(
                        "dirty takes --dirty SEEDS, --choices, --seed FIRST, --fixed, --without-kept, --only TEXT, --unnamed, --keep and --command PATH, not `{other}`"
                    ));
                }
            }
        }
        if options.command.as_os_str().is_empty() {
            return Err("--command PATH says which `cdpr` answers".to_owned());
        }
        Ok(options)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(words: &str) -> Result<Options, String> {
        Options::of(&words.split(' ').map(str::to_owned).collect::<Vec<_>>())
    }

    #[test]
    fn words_are_read_or_refused() {
        let options = of("--command cdpr --dirty 20 --seed 5 --only drift/box").unwrap();
        assert_eq!((options.seeds, options.first, options.only.as_deref()), (20, 5, Some("drift/box")));
        assert!(of("--command cdpr --choices --seed 7").is_ok_and(|options| options.choices && options.first == 7));
        assert!(of("--dirty 3").is_err() && of("--command cdpr --dirty x").is_err() && of("--command").is_err());
    }
}

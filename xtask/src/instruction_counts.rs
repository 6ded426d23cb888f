//! Instruction counts of named work, their file, and how far two of them may differ.

use crate::outcome::Outcome;

/// Growth that is let pass: a change elsewhere can move what the compiler inlines (2.4 % was seen), and the C library's own
/// functions (copying, sines) differ between releases. The same program counts the same on every run.
const TOLERANCE: f64 = 0.1;

/// The same after a change of compiler, which moves all counts a little, some up, some down.
const OTHER_COMPILER: f64 = 0.25;

const HEAD: &str = "\
# Instructions of the work in instructions.rs as callgrind counts them. `cargo xtask instructions` compares,
# `cargo xtask instructions --accept` writes this file anew.
";

/// What was counted, and what the counts depend on.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Counts {
    /// `rustc --version`.
    pub(crate) compiler: String,
    /// The vector unit that valgrind offers the program.
    pub(crate) unit: String,
    /// Names and instructions, in the order of the program.
    pub(crate) works: Vec<(String, u64)>,
}

impl Counts {
    /// Reads what [`Counts::to_toml`] writes; no other TOML.
    pub(crate) fn from_toml(text: &str) -> Result<Self, String> {
        let mut counts = Self::default();
        for (number, line) in (1..).zip(text.lines()) {
            let refused = || format!("instructions.toml:{number}: cannot read `{line}`: renew it with --accept");
            match line.split_once(" = ") {
                _ if line.is_empty() || line.starts_with(['#', '[']) => {}
                Some(("compiler", value)) => value.trim_matches('"').clone_into(&mut counts.compiler),
                Some(("unit", value)) => value.trim_matches('"').clone_into(&mut counts.unit),
                Some((name, value)) => {
                    let count = value.parse().map_err(|_| refused())?;
                    counts.works.push((name.trim_matches('"').to_owned(), count));
                }
                None => return Err(refused()),
            }
        }
        Ok(counts)
    }

    pub(crate) fn to_toml(&self) -> String {
        let works = self.works.iter().map(|(name, count)| format!("\"{name}\" = {count}\n"));
        let Self { compiler, unit, .. } = self;
        format!("{HEAD}compiler = \"{compiler}\"\nunit = \"{unit}\"\n\n[instructions]\n{}", works.collect::<String>())
    }

    /// Prints both, work by work, and complains where `self`, the reference, is exceeded by too much.
    pub(crate) fn compare(&self, now: &Self) -> Outcome {
        let same = self.compiler == now.compiler;
        let tolerance = if same { TOLERANCE } else { OTHER_COMPILER };
        if !same {
            println!(
                "the reference is of {}, this is {}: {:.0} % are allowed",
                self.compiler,
                now.compiler,
                100.0 * tolerance
            );
        }
        let mut outcome = Outcome::default();
        for (name, count) in &now.works {
            let Some((_, reference)) = self.works.iter().find(|(known, _)| known == name) else {
                outcome.complaints.push(format!("{name}: has no reference yet"));
                continue;
            };
            let growth = *count as f64 / *reference as f64 - 1.0;
            println!("{name:32} {count:>12} {:>+7.1} %", 100.0 * growth);
            if growth > tolerance {
                outcome.complaints.push(format!(
                    "{name}: {count} instructions, {:.1} % more than the {reference} of the reference",
                    100.0 * growth
                ));
            } else {
                outcome.passed += 1;
                if growth < -tolerance {
                    println!("    fewer than before: keep it so with `cargo xtask instructions --accept`");
                }
            }
        }
        let gone = self.works.iter().filter(|(name, _)| now.works.iter().all(|(other, _)| other != name));
        outcome.complaints.extend(gone.map(|(name, _)| format!("{name}: is in the reference, but was not counted")));
        outcome.failed = outcome.complaints.len();
        outcome
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(count: u64, compiler: &str) -> Counts {
        let works = vec![("inverse kinematics, pulley".to_owned(), count)];
        Counts { compiler: compiler.to_owned(), unit: "Avx2".to_owned(), works }
    }

    #[test]
    fn counts_are_read_as_they_were_written() {
        let counts = counts(12_345, "rustc 1.95.0 (59807616e 2026-04-14)");
        assert_eq!(Counts::from_toml(&counts.to_toml()), Ok(counts));
    }

    #[test]
    fn growth_beyond_the_tolerance_fails_and_less_work_passes() {
        let reference = counts(1000, "a");
        for (count, compiler, failed) in [(1099, "a", 0), (1101, "a", 1), (1249, "b", 0), (1251, "b", 1), (10, "a", 0)]
        {
            assert_eq!(reference.compare(&counts(count, compiler)).failed, failed, "{count} by {compiler}");
        }
    }

    #[test]
    fn work_that_only_one_side_knows_fails() {
        let none = Counts { works: Vec::new(), ..counts(0, "a") };
        assert_eq!(none.compare(&counts(1, "a")).failed, 1);
        assert_eq!(counts(1, "a").compare(&none).failed, 1);
    }
}

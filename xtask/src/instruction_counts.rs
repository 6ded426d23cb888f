//! Instruction counts of named work, their file, and how far two of them may differ.

use crate::outcome::Outcome;

/// Growth that is let pass: a change elsewhere can move what the compiler inlines (2.4 % was seen), and the C library's own
/// functions (copying, sines) differ between releases. The same program counts the same on every run.
const TOLERANCE: f64 = 0.1;

/// The same after a change of compiler, which moves all counts a little, some up, some down.
const OTHER_COMPILER: f64 = 0.25;

const HEAD: &str = "\
# Instructions of the work in src, for each vector unit: as callgrind counts them, batches on AVX-512 by steps. `cargo xtask instructions`
# compares, `cargo xtask instructions --accept` writes this file anew.
";

/// Counts for the vector units that a program was built for and valgrind has, and the compiler that they depend on.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Reference {
    /// `rustc --version`.
    pub(crate) compiler: String,
    /// One entry for each unit.
    pub(crate) units: Vec<Counts>,
}

/// Counts on one vector unit.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Counts {
    /// The vector unit that valgrind offers the program.
    pub(crate) unit: String,
    /// Names and instructions, in the order of the program.
    pub(crate) works: Vec<(String, u64)>,
}

impl Reference {
    /// Reads what [`Reference::to_toml`] writes; no other TOML.
    pub(crate) fn from_toml(text: &str) -> Result<Self, String> {
        let mut reference = Self::default();
        for (number, line) in (1..).zip(text.lines()) {
            let refused = || format!("counts.toml:{number}: cannot read `{line}`: renew it with --accept");
            if line.is_empty() || line.starts_with('#') {
                continue;
            }
            if let Some(unit) = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
                reference.units.push(Counts { unit: unit.to_owned(), works: Vec::new() });
                continue;
            }
            match (line.split_once(" = "), reference.units.last_mut()) {
                (Some(("compiler", value)), None) => value.trim_matches('"').clone_into(&mut reference.compiler),
                (Some((name, value)), Some(counts)) => {
                    let count = value.parse().map_err(|_| refused())?;
                    counts.works.push((name.trim_matches('"').to_owned(), count));
                }
                _ => return Err(refused()),
            }
        }
        Ok(reference)
    }

    pub(crate) fn to_toml(&self) -> String {
        let unit = |counts: &Counts| {
            let works = counts.works.iter().map(|(name, count)| format!("\"{name}\" = {count}\n"));
            format!("\n[{}]\n{}", counts.unit, works.collect::<String>())
        };
        format!("{HEAD}compiler = \"{}\"\n{}", self.compiler, self.units.iter().map(unit).collect::<String>())
    }

    /// The counts on a unit.
    pub(crate) fn unit(&self, name: &str) -> Option<&Counts> {
        self.units.iter().find(|counts| counts.unit == name)
    }

    /// Adds the counts on a unit that has none yet: a machine without wider vectors counts the same twice.
    pub(crate) fn add(&mut self, counts: Counts) {
        if !counts.works.is_empty() && self.unit(&counts.unit).is_none() {
            self.units.push(counts);
        }
    }

    /// Takes the units that another reference of the same compiler has beyond these.
    pub(crate) fn keep_units_of(&mut self, other: Self) {
        for counts in other.units {
            if self.unit(&counts.unit).is_some() {
                continue;
            }
            if self.compiler == other.compiler {
                println!("{}: kept as it was, this machine or its valgrind has no such unit", counts.unit);
                self.add(counts);
            } else {
                println!("{}: left out, it was counted with {}", counts.unit, other.compiler);
            }
        }
    }

    /// Prints both, unit by unit, and complains where `self` is exceeded by too much. A unit that only one side has cannot be compared.
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
        for counts in &now.units {
            match self.unit(&counts.unit) {
                Some(reference) => reference.compare(counts, tolerance, &mut outcome),
                None => println!("{}: no reference; `--accept` on this machine writes one", counts.unit),
            }
        }
        let absent = self.units.iter().filter(|counts| now.unit(&counts.unit).is_none());
        absent
            .for_each(|counts| println!("{}: not counted, this machine or its valgrind has no such unit", counts.unit));
        outcome.failed = outcome.complaints.len();
        outcome
    }
}

impl Counts {
    fn compare(&self, now: &Self, tolerance: f64, outcome: &mut Outcome) {
        println!("{}:", now.unit);
        for (name, count) in &now.works {
            let Some((_, reference)) = self.works.iter().find(|(known, _)| known == name) else {
                outcome.complaints.push(format!("{}, {name}: has no reference yet", now.unit));
                continue;
            };
            let growth = *count as f64 / *reference as f64 - 1.0;
            println!("{name:32} {count:>12} {:>+7.1} %", 100.0 * growth);
            if growth > tolerance {
                outcome.complaints.push(format!(
                    "{}, {name}: {count} instructions, {:.1} % more than the {reference} of the reference",
                    now.unit,
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
        outcome
            .complaints
            .extend(gone.map(|(name, _)| format!("{}, {name}: is in the reference, but was not counted", now.unit)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(count: u64, compiler: &str) -> Reference {
        let works = vec![("inverse kinematics, pulley".to_owned(), count)];
        let units = ["Portable", "Avx2"].map(|unit| Counts { unit: unit.to_owned(), works: works.clone() });
        Reference { compiler: compiler.to_owned(), units: units.into() }
    }

    #[test]
    fn counts_are_read_as_they_were_written() {
        let counts = counts(12_345, "rustc 1.95.0 (59807616e 2026-04-14)");
        assert_eq!(Reference::from_toml(&counts.to_toml()), Ok(counts));
    }

    #[test]
    fn growth_beyond_the_tolerance_fails_on_every_unit_and_less_work_passes() {
        let reference = counts(1000, "a");
        for (count, compiler, failed) in [(1099, "a", 0), (1101, "a", 2), (1249, "b", 0), (1251, "b", 2), (10, "a", 0)]
        {
            assert_eq!(reference.compare(&counts(count, compiler)).failed, failed, "{count} by {compiler}");
        }
    }

    /// A machine without AVX-512 renews the other counts and leaves these alone.
    #[test]
    fn units_of_other_machines_are_kept_until_the_compiler_changes() {
        let works = vec![("batch, lengths, pulley".to_owned(), 7)];
        let mut before = counts(1000, "a");
        before.units.push(Counts { unit: "Avx512".to_owned(), works: works.clone() });
        let mut now = counts(900, "a");
        now.keep_units_of(before.clone());
        assert_eq!(now.unit("Avx512").map(|counts| &counts.works), Some(&works));
        assert_eq!((now.units.len(), now.unit("Avx2")), (3, counts(900, "a").unit("Avx2")));
        assert_eq!(now.compare(&counts(900, "a")).failed, 0);
        let mut later = counts(900, "b");
        later.keep_units_of(before);
        assert_eq!(later, counts(900, "b"));
    }

    #[test]
    fn work_that_only_one_side_knows_fails() {
        let mut none = counts(0, "a");
        none.units.iter_mut().for_each(|unit| unit.works.clear());
        assert_eq!(none.compare(&counts(1, "a")).failed, 2);
        assert_eq!(counts(1, "a").compare(&none).failed, 2);
    }
}

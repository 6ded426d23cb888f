//! The table of all cells, and what is asked of them.

use std::collections::BTreeMap;

use crate::kinds::KINDS;
use crate::trial::Outcome;

/// Part of the dirty cells with stated accuracies that has to be named.
const NAMED: f64 = 0.8;
/// Part of clean cells that may have a caution.
const CAUTIONED: f64 = 0.02;

/// Counts over some cells.
#[derive(Clone, Copy, Default)]
struct Count {
    cells: usize,
    stated: usize,
    silent_wrong: usize,
    /// Of those that state accuracies.
    named: usize,
    cautioned: usize,
    not_trusted: usize,
}

impl Count {
    fn of<'a>(outcomes: impl Iterator<Item = &'a Outcome>) -> Self {
        outcomes.fold(Self::default(), |sum, outcome| {
            let (verdict, stated) = (outcome.verdict, outcome.cell.states_accuracies());
            Self {
                cells: sum.cells + 1,
                stated: sum.stated + usize::from(stated),
                silent_wrong: sum.silent_wrong + usize::from(verdict.silent_wrong),
                named: sum.named + usize::from(stated && verdict.named),
                cautioned: sum.cautioned + usize::from(verdict.cautioned),
                not_trusted: sum.not_trusted + usize::from(verdict.not_trusted),
            }
        })
    }

    fn line(&self, name: &str, kept: bool, firsts: &str) -> String {
        let Self { cells, stated, silent_wrong, named, cautioned, not_trusted } = *self;
        let kept = if kept { "kept" } else { "" };
        let named = format!("{named}/{stated}");
        format!("{name:<24}{kept:<6}{cells:>6}{silent_wrong:>8}{named:>10}{cautioned:>10}{not_trusted:>12}  {firsts}")
            .trim_end()
            .to_owned()
    }
}

/// The table: a line for each kind, sums, and single cells that somebody has to look at.
pub(crate) fn text(outcomes: &[Outcome]) -> String {
    let mut lines = vec![format!(
        "{:<24}{:<6}{:>6}{:>8}{:>10}{:>10}{:>12}  first findings",
        "kind", "", "cells", "silent", "named", "cautions", "not trusted"
    )];
    for kind in KINDS {
        let of_kind: Vec<&Outcome> = outcomes.iter().filter(|outcome| outcome.cell.kind.name == kind.name).collect();
        if !of_kind.is_empty() {
            lines.push(Count::of(of_kind.iter().copied()).line(kind.name, kind.kept, &firsts(&of_kind)));
        }
    }
    let dirty = || outcomes.iter().filter(|outcome| !outcome.cell.kind.is_clean());
    let clean = outcomes.iter().filter(|outcome| outcome.cell.kind.is_clean());
    lines.push(Count::of(dirty().filter(|outcome| !outcome.cell.kind.kept)).line("all dirty, not kept", false, ""));
    lines.push(Count::of(dirty().filter(|outcome| outcome.cell.kind.kept)).line("all dirty, kept", true, ""));
    lines.push(Count::of(clean).line("all clean", false, ""));
    lines.join("\n")
}

/// Kinds of the first findings with their numbers of cells, the most frequent first.
fn firsts(outcomes: &[&Outcome]) -> String {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for outcome in outcomes {
        let first = outcome.first();
        *counts.entry(first.split(' ').next().unwrap_or_default().to_owned()).or_default() += 1;
    }
    let mut counts: Vec<(String, usize)> = counts.into_iter().collect();
    counts.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    counts.iter().take(4).map(|(word, count)| format!("{word} {count}")).collect::<Vec<_>>().join(", ")
}

/// Cells that somebody has to look at: clean ones that are doubted, and wrong ones without a word; with `unnamed`, dirty ones that are not
/// named, too.
pub(crate) fn single_cells(outcomes: &[Outcome], unnamed: bool) -> Vec<String> {
    let told = |outcome: &&Outcome| {
        let verdict = outcome.verdict;
        let clean = outcome.cell.kind.is_clean();
        verdict.silent_wrong || (clean && verdict.cautioned) || (unnamed && !clean && !verdict.named)
    };
    let word = |outcome: &Outcome| match (outcome.verdict.silent_wrong, outcome.cell.kind.is_clean()) {
        (true, _) => "SILENT WRONG",
        (false, true) => "clean, doubted",
        (false, false) => "not named",
    };
    outcomes.iter().filter(told).map(|outcome| format!("{}  {}", word(outcome), outcome.words())).collect()
}

/// Limits that are not kept.
pub(crate) fn complaints(outcomes: &[Outcome]) -> Vec<String> {
    let dirty = Count::of(outcomes.iter().filter(|outcome| !outcome.cell.kind.is_clean()));
    let clean = Count::of(outcomes.iter().filter(|outcome| outcome.cell.kind.is_clean()));
    let silent = dirty.silent_wrong + clean.silent_wrong;
    let mut complaints = Vec::new();
    if silent > 0 {
        complaints.push(format!("{silent} cells are wrong without a word, none may be"));
    }
    if (dirty.named as f64) < NAMED * dirty.stated as f64 {
        complaints.push(format!(
            "{} of {} dirty cells with stated accuracies are named, {:.0} % shall be",
            dirty.named,
            dirty.stated,
            100.0 * NAMED
        ));
    }
    if clean.cautioned as f64 > CAUTIONED * clean.cells as f64 {
        let (cautioned, cells) = (clean.cautioned, clean.cells);
        complaints.push(format!("{cautioned} of {cells} clean cells have a caution, {:.0} % may", 100.0 * CAUTIONED));
    }
    if clean.not_trusted > 0 {
        complaints.push(format!("{} of {} clean cells are not trusted, none may be", clean.not_trusted, clean.cells));
    }
    complaints
}

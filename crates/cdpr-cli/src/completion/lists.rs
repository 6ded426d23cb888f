//! Values made of several words: lists with commas, compositions, criteria with their numbers, candidates.

use cdpr_model::model::{Composition, FreeParameters};
use cdpr_model::robot::LAWS;
use cdpr_workspace::criterion::registry;

use super::proposals::{Proposal, Proposals, plain};

/// Words of a list with commas that are not in it yet; `mark` follows each of them.
pub(super) fn listed(typed: &str, words: impl IntoIterator<Item = Proposal>, mark: &str) -> Proposals {
    let items = items(typed);
    let (last, named) = items.split_last().map_or(("", &[][..]), |(last, named)| (*last, named));
    let before = &typed[..typed.len() - last.len()];
    let is_named = |word: &str| named.iter().any(|item| item.split(['[', '=']).next().map(str::trim) == Some(word));
    let missing = words.into_iter().filter(|proposal| !is_named(&proposal.word));
    let whole = missing.map(|Proposal { word, help }| Proposal { word: format!("{before}{word}{mark}"), help });
    Proposals { is_open: true, ..Proposals::of(whole) }
}

/// Kinds of parameters in a list with commas; `mark` follows each of them.
pub(super) fn parameters(typed: &str, mark: &str) -> Proposals {
    listed(typed, FreeParameters::known_names().map(plain), mark)
}

/// A composition, or the last one of a list with commas.
pub(super) fn composition(typed: &str) -> Proposals {
    let (before, last) = typed.split_at(typed.rfind(',').map_or(0, |end| end + 1));
    with_prefix(before, effects(last))
}

/// Effects of a composition that fit those before the last `+`.
fn effects(typed: &str) -> Proposals {
    let before = &typed[..typed.rfind('+').map_or(0, |plus| plus + 1)];
    let single = Composition::all().filter(|composition| composition.effect_count() <= 1);
    let whole = single.map(|effect| effect.to_string()).filter_map(|word| {
        let whole = format!("{before}{word}");
        let law = LAWS.iter().find(|law| law.word == word);
        whole.parse::<Composition>().is_ok().then(|| Proposal::new(whole, law.map_or("", |law| law.summary)))
    });
    Proposals { is_open: true, ..Proposals::of(whole) }
}

/// Criteria of a workspace, or the numbers of the one that is named.
pub(super) fn criterion(typed: &str) -> Proposals {
    let Some((name, numbers)) = typed.split_once(':') else {
        let needed = |entry: &registry::Entry| entry.numbers.iter().any(|number| number.is_required);
        let written = |entry: &registry::Entry| format!("{}{}", entry.name, if needed(entry) { ":" } else { "" });
        let entries = registry::ENTRIES.iter().map(|entry| Proposal::new(written(entry), entry.summary));
        return Proposals { is_open: true, ..Proposals::of(entries) };
    };
    let entry = registry::ENTRIES.iter().find(|entry| entry.name == name);
    let known = entry.into_iter().flat_map(|entry| entry.numbers);
    with_prefix(&format!("{name}:"), listed(numbers, known.map(|number| Proposal::new(number.name, number.unit)), "="))
}

/// Candidates `MODEL[:FREE];…`: the effects of the last one, or its free parameters.
pub(super) fn candidates(typed: &str) -> Proposals {
    let (before, last) = typed.split_at(typed.rfind(';').map_or(0, |end| end + 1));
    match last.split_once(':') {
        Some((model, free)) => with_prefix(&format!("{before}{model}:"), parameters(free, "")),
        None => with_prefix(before, effects(last)),
    }
}

fn with_prefix(prefix: &str, mut proposals: Proposals) -> Proposals {
    proposals.words.iter_mut().for_each(|proposal| proposal.word.insert_str(0, prefix));
    proposals
}

/// Items of a list with commas; commas in brackets part none.
fn items(list: &str) -> Vec<&str> {
    let mut depth = 0;
    let parts = |letter: char| {
        depth += i32::from(letter == '[') - i32::from(letter == ']');
        letter == ',' && depth <= 0
    };
    list.split(parts).collect()
}

//! Names of candidates in several lines.

/// Longer names are cut.
const MOST_LINES: usize = 4;

/// A name in lines of at most so many letters, broken after its separators; what four lines cannot hold is cut.
pub(super) fn wrapped(name: &str, letters: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for piece in name.split_inclusive([':', ',', '+']) {
        let last = lines.len() - 1;
        let length = lines[last].chars().count();
        match length > 0 && length + piece.chars().count() > letters {
            true => lines.push(piece.to_owned()),
            false => lines[last].push_str(piece),
        }
    }
    if lines.len() > MOST_LINES {
        lines.truncate(MOST_LINES);
        lines[MOST_LINES - 1].push('…');
    }
    lines.into_iter().map(|line| shortened(line, letters)).collect()
}

fn shortened(line: String, letters: usize) -> String {
    match line.chars().count() > letters {
        true => line.chars().take(letters - 1).chain(['…']).collect(),
        false => line,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_break_after_separators_and_lose_nothing() {
        let name = "elastic:frame-anchor,platform-anchor,length-offset,compliance,wrench";
        let lines = wrapped(name, 38);
        assert_eq!(lines, ["elastic:frame-anchor,platform-anchor,", "length-offset,compliance,wrench"]);
        assert_eq!(lines.concat(), name);
        let long = wrapped(&"a-long-parameter,".repeat(20), 20);
        assert!(long.len() == MOST_LINES && long[MOST_LINES - 1].ends_with('…'), "{long:?}");
    }
}

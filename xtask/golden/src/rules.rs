//! Rules by which numbers and words of answers are compared, by their keys.

/// Largest difference of two numbers, relative to the expected one.
pub(crate) const RELATIVE: f64 = 1e-9;
/// Largest relative difference of condition numbers.
const RELATIVE_CONDITION: f64 = 1e-6;
/// Condition number from which on its digits are rounding.
pub(crate) const LARGEST_CONDITION: f64 = 1e8;

/// How the value of a key is compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Rule {
    /// Not compared, nor anything below it; not stored.
    Ignored,
    /// Strings of any kind by every letter, numbers by every digit that is stored.
    Exact,
    /// Numbers within [`RELATIVE`], or this if it is more.
    Within(f64),
    /// Numbers within 1e-6 of the expected one, if that is below 1e8; beyond, both must be.
    Condition,
    /// No row names the key. Whole numbers, booleans and words without a blank exactly; other numbers as [`Rule::Within`] with the floor
    /// of the unit at the end of the key, [`floor`]; of sentences only that there is one.
    Default,
}

/// Keys and their rule.
struct Row {
    /// A key, or keys along a path with dots between them, from anywhere down; a star at the end of a key stands for any letters.
    keys: &'static [&'static str],
    rule: Rule,
}

/// The first row that fits counts. Lists have the key of what holds them.
const ROWS: &[Row] = &[
    // how an answer was found, when and by which program: not the answer
    Row { keys: &["timing", "program", "version", "layout_version", "iterations", "restarts"], rule: Rule::Ignored },
    Row { keys: &["history", "course", "stopped_by", "plan", "row_files"], rule: Rule::Ignored },
    // text of its own tests
    Row { keys: &["title", "feasible_note", "help", "try", "untried"], rule: Rule::Ignored },
    // parameters and their deviations count by what they predict: lengths at ten poses, bands of poses
    Row { keys: &["parameters.value", "parameters.change", "parameters.sigma"], rule: Rule::Ignored },
    Row {
        keys: &["bootstrap.parameters", "profiles.value", "profiles.sigma", "profiles.interval"],
        rule: Rule::Ignored,
    },
    Row { keys: &["path.values", "path.changes_m"], rule: Rule::Ignored },
    // directions have no sign, and turn where two singular values are close; how far one is open is a quotient of rounding
    Row { keys: &["weak_directions", "correlations", "weak_direction_deviation_m"], rule: Rule::Ignored },
    // what a search left: distances between optima of one valley, gaps of a proof
    Row {
        keys: &["optima.spread_m", "optima.distance_m", "certificate.gap", "certificate.subgradient"],
        rule: Rule::Ignored,
    },
    // choices and names, though they have blanks
    Row {
        keys: &["recommended", "best", "candidate", "name", "label", "parameter", "free", "model"],
        rule: Rule::Exact,
    },
    Row { keys: &["status", "code", "kind"], rule: Rule::Exact },
    Row { keys: &["condition", "condition_*"], rule: Rule::Condition },
    // what rounding leaves of sums of forces of thousands of newtons
    Row { keys: &["wrench_residual", "wrench_residual_*"], rule: Rule::Within(1e-6) },
    // metres, radians and newtons of what decides between candidates
    Row { keys: &["compared.mean", "compared.difference*", "compared.as_good_within"], rule: Rule::Within(1e-12) },
    // squares of what rounding leaves where data are exact
    Row { keys: &["optima.cost", "cost_m2"], rule: Rule::Within(1e-18) },
];

/// Floors of differences by the end of a key, in its unit.
const FLOORS: &[(&str, f64)] =
    &[("_m", 1e-12), ("_m2", 1e-12), ("_m3", 1e-12), ("_rad", 1e-12), ("_N", 1e-9), ("_Nm", 1e-9)];

/// Rule of the value at the end of a path of keys.
pub(crate) fn rule(path: &[String]) -> Rule {
    let fitting = |row: &&Row| row.keys.iter().any(|keys| fits(keys, path));
    ROWS.iter().find(fitting).map_or(Rule::Default, |row| row.rule)
}

/// Whether the last keys of the path are these.
fn fits(keys: &str, path: &[String]) -> bool {
    let count = keys.split('.').count();
    let Some(first) = path.len().checked_sub(count) else { return false };
    keys.split('.').zip(&path[first..]).all(|(pattern, key)| fits_key(pattern, key))
}

fn fits_key(pattern: &str, key: &str) -> bool {
    pattern.strip_suffix('*').map_or(key == pattern, |start| key.starts_with(start))
}

/// Largest tolerated difference of a small number: that of its unit, which stands at the end of its key or of one above it.
pub(crate) fn floor(path: &[String]) -> f64 {
    let of_key = |key: &String| {
        let bare = key.trim_end_matches(|letter: char| letter.is_ascii_digit());
        let key = if bare.ends_with('_') { bare.trim_end_matches('_') } else { key };
        FLOORS.iter().find(|(unit, _)| key.ends_with(unit)).map(|(_, floor)| *floor)
    };
    path.iter().rev().find_map(of_key).unwrap_or(0.0)
}

/// Largest difference that a rule tolerates at an expected number, in a list whose largest magnitude is `largest`; `None` where no number
/// is expected but any beyond 1e8.
pub(crate) fn tolerance(path: &[String], expected: f64, largest: f64) -> Option<f64> {
    // zeros of a matrix are what rounding of its other entries leaves
    let rounding = 1e-12 * largest;
    match rule(path) {
        Rule::Ignored => Some(f64::INFINITY),
        Rule::Exact => Some(0.0),
        Rule::Within(floor) => Some((RELATIVE * expected.abs()).max(floor)),
        Rule::Condition if expected.abs() < LARGEST_CONDITION => Some(RELATIVE_CONDITION * expected.abs()),
        Rule::Condition => None,
        Rule::Default => Some((RELATIVE * expected.abs()).max(floor(path)).max(rounding)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn path(keys: &str) -> Vec<String> {
        keys.split('.').map(str::to_owned).collect()
    }

    #[test]
    fn rows_fit_the_end_of_a_path() {
        assert_eq!(rule(&path("timing")), Rule::Ignored);
        assert_eq!(rule(&path("candidates.fit.iterations")), Rule::Ignored);
        assert_eq!(rule(&path("parameters.sigma")), Rule::Ignored);
        assert_eq!(rule(&path("noise.sigma")), Rule::Default);
        assert_eq!(rule(&path("home.condition")), Rule::Condition);
        assert_eq!(rule(&path("condition_scaled")), Rule::Condition);
        assert_eq!(rule(&path("candidates.name")), Rule::Exact);
        assert_eq!(rule(&path("parameters.unit")), Rule::Default);
    }

    #[test]
    fn the_floor_is_that_of_the_nearest_unit() {
        assert_eq!(floor(&path("train.position_error_m.mean")), 1e-12);
        assert_eq!(floor(&path("tension_N_12")), 1e-9);
        assert_eq!(floor(&path("rank")), 0.0);
    }

    #[test]
    fn conditions_count_six_digits_and_beyond_1e8_none() {
        assert_eq!(tolerance(&path("condition"), 1e3, 0.0), Some(1e-3));
        assert_eq!(tolerance(&path("condition"), 1e9, 0.0), None);
    }
}

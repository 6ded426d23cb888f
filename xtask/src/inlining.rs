//! `inline(always)` only where counts prove it: each place that has it stands in a table, with its reason (decision 0049).

/// A file or, with a slash at its end, a folder whose functions may be `inline(always)`.
struct Place {
    path: &'static str,
    reason: &'static str,
}

/// A function over lanes that is not inlined is compiled without the vector unit of its kernel, and its lanes go through memory.
const LANES: &str = "functions over lanes, which kernels of every vector unit inline";
/// A function over `Real` or `Select`, which serves lanes and single numbers.
const NUMBERS: &str = "formulas that serve lanes and single numbers";
const COUNTED: &str =
    "lanes, and functions of single numbers whose calls were counted: see docs/decisions/0049-inlining-by-counts.md";

const PLACES: &[Place] = &[
    Place { path: "crates/cdpr-core/src/scalar/", reason: "the lanes themselves, and formulas over them" },
    Place { path: "crates/cdpr-core/src/solve/", reason: "the loop of all searches, for lanes and single numbers" },
    Place { path: "crates/cdpr-core/src/cable/elasticity.rs", reason: NUMBERS },
    Place { path: "crates/cdpr-core/src/cable/outlet/", reason: NUMBERS },
    Place { path: "crates/cdpr-core/src/cable/path.rs", reason: NUMBERS },
    Place { path: "crates/cdpr-core/src/cable/wrench.rs", reason: NUMBERS },
    Place { path: "crates/cdpr-core/src/structure/", reason: LANES },
    Place { path: "crates/cdpr-model/src/equilibrium/closed_form.rs", reason: LANES },
    Place { path: "crates/cdpr-model/src/equilibrium/closed_form/", reason: NUMBERS },
    Place { path: "crates/cdpr-model/src/equilibrium/elastostatics/", reason: NUMBERS },
    Place { path: "crates/cdpr-model/src/equilibrium/feasibility/", reason: LANES },
    Place { path: "crates/cdpr-model/src/equilibrium/forward_kinematics/", reason: NUMBERS },
    Place { path: "crates/cdpr-model/src/equilibrium/pose_step.rs", reason: NUMBERS },
    Place { path: "crates/cdpr-model/src/geometry/pose_batch.rs", reason: LANES },
    Place { path: "crates/cdpr-model/src/geometry/pose_rows.rs", reason: LANES },
    Place { path: "crates/cdpr-model/src/model/batch/", reason: LANES },
    Place { path: "crates/cdpr-model/src/model/kinematics.rs", reason: COUNTED },
    Place { path: "crates/cdpr-model/src/scalar/", reason: LANES },
    Place { path: "crates/cdpr-model/src/tension/quadratic/fixed.rs", reason: LANES },
    Place { path: "crates/cdpr-model/src/tension/quadratic/plane.rs", reason: COUNTED },
    Place { path: "crates/cdpr-calibration/src/residual/lengths/blocks.rs", reason: LANES },
    Place { path: "crates/cdpr-calibration/src/residual/balance/", reason: LANES },
    Place { path: "crates/cdpr-calibration/src/residual/lengths/further_columns.rs", reason: LANES },
    Place { path: "crates/cdpr-calibration/src/residual/lengths/normal_equations.rs", reason: LANES },
    Place { path: "crates/cdpr-calibration/src/residual/poses/squares/", reason: LANES },
    Place { path: "crates/cdpr-calibration/src/residual/lengths/pose_lanes.rs", reason: LANES },
    Place { path: "crates/cdpr-calibration/src/residual/lengths/weights.rs", reason: LANES },
];

impl Place {
    fn holds(&self, name: &str) -> bool {
        name == self.path || self.path.ends_with('/') && name.starts_with(self.path)
    }
}

/// Lines with the attribute, counted from 1.
fn lines(text: &str) -> impl Iterator<Item = usize> {
    (1..).zip(text.lines()).filter(|(_, line)| line.trim_start().starts_with("#[inline(always)]")).map(|(line, _)| line)
}

/// The places of the table that files were seen in.
#[derive(Default)]
pub(crate) struct Seen(Vec<&'static str>);

impl Seen {
    /// Complains of `inline(always)` in a file that no place holds. `name` is the file's place in the workspace.
    pub(crate) fn complaints(&mut self, name: &str, text: &str) -> Vec<String> {
        let mut lines = lines(text).peekable();
        if lines.peek().is_none() {
            return Vec::new();
        }
        if let Some(place) = PLACES.iter().find(|place| place.holds(name)) {
            self.0.push(place.path);
            return Vec::new();
        }
        let told = |line: usize| {
            format!(
                "{name}:{line}: `inline(always)` only where counts prove it: write `inline`, or show by `cargo xtask instructions` that \
                 it is needed and list the file in xtask/src/inlining.rs (docs/decisions/0049-inlining-by-counts.md)"
            )
        };
        lines.map(told).collect()
    }

    /// Complains of places that have no `inline(always)` any more, once all files were seen.
    pub(crate) fn unused(&self) -> Vec<String> {
        let unused = PLACES.iter().filter(|place| !self.0.contains(&place.path));
        let told = |place: &Place| {
            format!("{}: has no `inline(always)` ({}); take it from xtask/src/inlining.rs", place.path, place.reason)
        };
        unused.map(told).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_listed_places_may_force_inlining() {
        let mut seen = Seen::default();
        let forced = "/// `#[inline(always)]`\n\n    #[inline(always)]\n    fn f() {}\n";
        assert!(seen.complaints("crates/cdpr-core/src/scalar/avx2.rs", forced).is_empty());
        assert!(seen.complaints("crates/cdpr-plant/src/drums.rs", "#[inline]\nfn f() {}\n").is_empty());
        let refused = seen.complaints("crates/cdpr-plant/src/drums.rs", forced);
        assert_eq!(refused.len(), 1, "{refused:?}");
        assert!(
            refused[0].starts_with("crates/cdpr-plant/src/drums.rs:3: `inline(always)` only where counts prove it")
        );
    }

    #[test]
    fn a_place_without_the_attribute_is_told() {
        let mut seen = Seen::default();
        assert_eq!(seen.unused().len(), PLACES.len());
        seen.complaints("crates/cdpr-calibration/src/residual/lengths/weights.rs", "#[inline(always)]\n");
        assert_eq!(seen.unused().len(), PLACES.len() - 1);
    }
}

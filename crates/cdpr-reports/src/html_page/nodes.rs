//! The nodes of a grid in a page along each of its axes.

use schemars::JsonSchema;
use serde::Serialize;

/// Evenly spaced nodes along an axis (m).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub(crate) struct Nodes {
    #[serde(rename = "start_m")]
    pub(crate) start: f64,
    #[serde(rename = "step_m")]
    pub(crate) step: f64,
    pub(crate) count: usize,
}

impl Nodes {
    /// Coordinate of a node, or of a share of a step beyond it (m).
    pub(crate) fn at(&self, index: f64) -> f64 {
        self.start + index * self.step
    }
}

/// Nodes that fill a box (m), `most` together at most.
pub(crate) fn nodes(ends: &[[f64; 2]], most: usize) -> Vec<Nodes> {
    let extents: Vec<f64> = ends.iter().map(|[low, high]| high - low).collect();
    let along = |(extent, (&[start, _], count)): (&f64, (&[f64; 2], usize))| Nodes {
        start,
        step: extent / (count - 1).max(1) as f64,
        count,
    };
    extents.iter().zip(ends.iter().zip(counts(&extents, most))).map(along).collect()
}

/// Nodes along axes of these lengths, `most` together at most: cells as near to cubes as that allows.
fn counts(extents: &[f64], most: usize) -> Vec<usize> {
    let longest = extents.iter().copied().fold(0.0, f64::max);
    // a box without extent along an axis has one layer there
    let for_longest = |count: usize| -> Vec<usize> {
        let along = |extent: &f64| match extent / longest {
            share if share > 0.0 => ((count - 1) as f64 * share).round().max(1.0) as usize + 1,
            _ => 1,
        };
        extents.iter().map(along).collect()
    };
    let fits = |count: &usize| for_longest(*count).iter().product::<usize>() <= most;
    (2..=most).take_while(fits).last().map_or_else(|| vec![1; extents.len()], for_longest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_nearly_cubes_and_nodes_no_more_than_asked() {
        for (extents, most) in [([4.0, 5.0, 5.0], 8000), ([10.0, 0.1, 3.0], 8000), ([1.0, 1.0, 1.0], 8)] {
            let counts = counts(&extents, most);
            assert!(counts.iter().product::<usize>() <= most, "{counts:?}");
            let steps: Vec<f64> = extents.iter().zip(&counts).map(|(e, n)| e / (n - 1) as f64).collect();
            let longest = steps.iter().copied().fold(0.0, f64::max);
            // a thin box keeps two layers; elsewhere rounding changes a step by less than a third
            assert!(steps.iter().zip(&counts).all(|(step, &n)| n == 2 || *step > 0.66 * longest), "{steps:?}");
        }
        assert_eq!(counts(&[3.0, 0.0], 100)[1], 1);
        assert_eq!(counts(&[0.0, 0.0], 100), [1, 1]);
    }
}

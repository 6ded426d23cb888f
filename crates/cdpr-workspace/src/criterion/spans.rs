//! Parts of a straight line, as intervals.

/// Parts of a line from 0 to its length (m): closed intervals, in order and disjoint.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spans {
    parts: Vec<[f64; 2]>,
}

impl Spans {
    /// The whole line of this length (m).
    pub(crate) fn whole(length: f64) -> Self {
        Self { parts: vec![[0.0, length]] }
    }

    /// Union of these intervals (m).
    pub(crate) fn of(parts: impl IntoIterator<Item = [f64; 2]>) -> Self {
        let mut all: Vec<[f64; 2]> = parts.into_iter().collect();
        all.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut parts: Vec<[f64; 2]> = Vec::new();
        for [from, to] in all {
            match parts.last_mut() {
                Some(last) if from <= last[1] => last[1] = last[1].max(to),
                _ => parts.push([from, to]),
            }
        }
        Self { parts }
    }

    /// The intervals, in order.
    pub(crate) fn parts(&self) -> &[[f64; 2]] {
        &self.parts
    }

    /// Intersection with the interval.
    #[must_use]
    pub(crate) fn within(&self, [from, to]: [f64; 2]) -> Self {
        self.and(&Self { parts: vec![[from, to]] })
    }

    /// Difference: the parts outside the interval, whose end points stay. NaN removes nothing.
    #[must_use]
    pub(crate) fn without(&self, [from, to]: [f64; 2]) -> Self {
        if !(from < to) {
            return self.clone();
        }
        self.and(&Self { parts: vec![[f64::NEG_INFINITY, from], [to, f64::INFINITY]] })
    }

    /// Intersection of both.
    #[must_use]
    pub(crate) fn and(&self, other: &Self) -> Self {
        let pairs = self.parts.iter().flat_map(|a| other.parts.iter().map(move |b| [a[0].max(b[0]), a[1].min(b[1])]));
        Self { parts: pairs.filter(|[from, to]| from <= to).collect() }
    }

    /// Union of both.
    #[must_use]
    pub(crate) fn or(&self, other: &Self) -> Self {
        Self::of(self.parts.iter().chain(&other.parts).copied())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spans_are_cut_and_joined_as_sets() {
        let whole = Spans::whole(10.0);
        let holed = whole.without([2.0, 3.0]).without([5.0, 11.0]);
        assert_eq!(holed.parts(), [[0.0, 2.0], [3.0, 5.0]]);
        assert_eq!(holed.within([1.0, 4.0]).parts(), [[1.0, 2.0], [3.0, 4.0]]);
        assert_eq!(holed.or(&whole.within([1.5, 3.5])).parts(), [[0.0, 5.0]]);
        assert_eq!(whole.without([f64::NAN, 1.0]), whole);
        assert!(whole.within([11.0, 12.0]).parts().is_empty());
    }
}

//! Polynomials Σ cₖ xᵏ, by their coefficients from c₀ on.

/// Value at x.
pub(crate) fn horner(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

/// Coefficients of the derivative.
pub(crate) fn derivative(coefficients: &[f64]) -> Vec<f64> {
    coefficients.iter().enumerate().skip(1).map(|(k, c)| c * k as f64).collect()
}

/// Roots at which the sign changes, in 0..`end`, in rising order: between two sign changes of the derivative there is
/// at most one.
pub fn sign_changes(coefficients: &[f64], end: f64) -> Vec<f64> {
    if coefficients.len() < 2 {
        return Vec::new();
    }
    let mut marks = sign_changes(&derivative(coefficients), end);
    marks.push(end);
    let mut before = 0.0;
    let mut found = Vec::new();
    for mark in marks {
        let is_negative = horner(coefficients, before) < 0.0;
        if is_negative != (horner(coefficients, mark) < 0.0) {
            found.push(bisect(before, mark, |x| (horner(coefficients, x) < 0.0) == is_negative));
        }
        before = mark;
    }
    found
}

/// Number at which a condition that holds at `from` and not at `to` ceases to hold, to the last digit.
pub(crate) fn bisect(mut from: f64, mut to: f64, holds: impl Fn(f64) -> bool) -> f64 {
    loop {
        let middle = 0.5 * (from + to);
        // neighbouring numbers have no number between them
        if !(from < middle && middle < to) {
            return from;
        }
        match holds(middle) {
            true => from = middle,
            false => to = middle,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// (x − 1)(x − 2)(x − 3) and (x − 1)²(x − 2), of which the latter changes its sign only once.
    #[test]
    fn sign_changes_are_the_roots_of_odd_order() {
        let found = sign_changes(&[-6.0, 11.0, -6.0, 1.0], 2.5);
        assert_eq!(found.len(), 2);
        assert!((found[0] - 1.0).abs() < 1e-14 && (found[1] - 2.0).abs() < 1e-14, "{found:?}");
        let double = sign_changes(&[-2.0, 5.0, -4.0, 1.0], 10.0);
        let odd: Vec<f64> = double.iter().copied().filter(|root| (root - 1.0).abs() > 1e-6).collect();
        assert!(odd.len() == 1 && (odd[0] - 2.0).abs() < 1e-14, "{double:?}");
        assert!(sign_changes(&[1.0], 1.0).is_empty());
    }
}

//! Settings that searches accept.

/// The first of these settings (name and value) that is no positive number.
pub fn not_positive<const N: usize>(settings: [(&'static str, f64); N]) -> Option<(&'static str, f64)> {
    settings.into_iter().find(|(_, value)| !(*value > 0.0 && value.is_finite()))
}

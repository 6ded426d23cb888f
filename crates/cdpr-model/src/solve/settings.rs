//! Checks of settings of searches.

/// The first of these settings (name and value) that is not a positive finite number; `None` if all are.
pub fn not_positive<const N: usize>(settings: [(&'static str, f64); N]) -> Option<(&'static str, f64)> {
    settings.into_iter().find(|(_, value)| !(*value > 0.0 && value.is_finite()))
}

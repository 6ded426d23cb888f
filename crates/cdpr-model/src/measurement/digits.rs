//! Digits of numbers in messages.

/// A number with three digits, for a message about a misfit.
pub fn three_digits(number: f64) -> String {
    let text = match number.abs() {
        size if (1e-4..1e6).contains(&size) => format!("{number:.*}", decimals(2.0, number)),
        0.0 => "0".to_owned(),
        _ => format!("{number:.2e}"),
    };
    text.strip_prefix('-').map_or(text.clone(), |size| format!("−{size}"))
}

/// Decimals that show a number's leading digit and this many more.
pub fn decimals(more: f64, number: f64) -> usize {
    let leading = number.abs().log10().floor();
    if leading.is_finite() { (more - leading).clamp(0.0, 9.0) as usize } else { more as usize }
}

//! Numbers for people: sensible digits, "–" for none, "∞" for infinite, a true minus sign.

/// Sign for a number that is not there.
pub const NONE: &str = "–";

/// A number with so many significant digits, in powers of ten where plain digits would be long.
pub fn significant(value: f64, digits: i32) -> String {
    if let Some(word) = special(value) {
        return word;
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    let mut exponent = value.abs().log10().floor() as i32;
    // 9.9996 has five digits once it is rounded to four
    if rounds_up(value, exponent, digits) {
        exponent += 1;
    }
    if !(-4..7).contains(&exponent) {
        let mantissa = value / 10_f64.powi(exponent);
        return format!("{} × 10{}", fixed(mantissa, (digits - 1).max(0)), superscript(exponent));
    }
    fixed(value, (digits - 1 - exponent).max(0))
}

fn rounds_up(value: f64, exponent: i32, digits: i32) -> bool {
    let scaled = value.abs() / 10_f64.powi(exponent - digits + 1);
    scaled.round() >= 10_f64.powi(digits)
}

/// A condition number, of which the first digits matter: powers of ten from 10 000.
pub fn condition(number: f64) -> String {
    match number >= 1e4 && number.is_finite() {
        true => {
            let exponent = (number.log10() + 0.002).floor() as i32;
            format!("{} × 10{}", fixed(number / 10_f64.powi(exponent), 1), superscript(exponent))
        }
        false => significant(number, 3),
    }
}

/// A number with this many decimals; a dash for none.
pub fn cell(number: Option<f64>, decimals: usize) -> String {
    match number {
        Some(number) if number.is_finite() => {
            let text = format!("{number:.decimals$}");
            // rounded to zero, a number has no sign
            let is_zero = text.bytes().all(|byte| matches!(byte, b'-' | b'0' | b'.'));
            if is_zero { text.trim_start_matches('-').to_owned() } else { text }
        }
        Some(number) if number.is_infinite() => "∞".to_owned(),
        _ => "–".to_owned(),
    }
}

/// A number that someone chose: as few digits as it has, six at most.
pub fn short(value: f64) -> String {
    let text = significant(value, 6);
    match text.contains('.') && !text.contains('×') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

/// A number with so many digits after the point.
pub fn fixed(value: f64, decimals: i32) -> String {
    if let Some(word) = special(value) {
        return word;
    }
    let text = format!("{:.*}", decimals.clamp(0, 12) as usize, value.abs());
    let is_zero = text.bytes().all(|byte| matches!(byte, b'0' | b'.'));
    if value < 0.0 && !is_zero { format!("−{text}") } else { text }
}

/// Like [`fixed`] with a sign also for positive numbers.
pub fn signed(value: f64, decimals: i32) -> String {
    let text = fixed(value, decimals);
    if value > 0.0 && value.is_finite() { format!("+{text}") } else { text }
}

/// A length in metres as millimetres, without the unit.
pub fn millimetres(value: f64) -> String {
    significant(1e3 * value, 4)
}

/// A force in newtons, without the unit.
pub fn newtons(value: f64) -> String {
    significant(value, 4)
}

/// An angle in radians as degrees, without the unit.
pub fn degrees(value: f64) -> String {
    significant(value.to_degrees(), 4)
}

/// Digits after the point that show a standard deviation with two digits; 3 without one.
pub fn decimals_for(sigma: Option<f64>) -> i32 {
    match sigma {
        Some(sigma) if sigma > 0.0 && sigma.is_finite() => (1 - sigma.log10().floor() as i32).clamp(0, 9),
        _ => 3,
    }
}

fn superscript(exponent: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let digit = |c: char| c.to_digit(10).map_or('⁻', |value| DIGITS[value as usize]);
    exponent.to_string().chars().map(digit).collect()
}

fn special(value: f64) -> Option<String> {
    match value {
        _ if value.is_nan() => Some(NONE.to_owned()),
        f64::INFINITY => Some("∞".to_owned()),
        f64::NEG_INFINITY => Some("−∞".to_owned()),
        _ => None,
    }
}

/// A power of ten, e.g. 10⁻³.
pub fn power_of_ten(exponent: i32) -> String {
    match exponent {
        -2..=3 => significant(10_f64.powi(exponent), 1),
        _ => format!("10{}", superscript(exponent)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_their_significant_digits() {
        for (value, text) in [
            (52.4812, "52.48"),
            (1.84567, "1.846"),
            (9.99996, "10.00"),
            (123456.7, "123457"),
            (-0.012346, "−0.01235"),
            (1.5e-7, "1.500 × 10⁻⁷"),
            (3e12, "3.000 × 10¹²"),
            (0.0, "0"),
        ] {
            assert_eq!(significant(value, 4), text);
        }
    }

    #[test]
    fn chosen_numbers_are_written_as_short_as_they_are() {
        let texts = [5.0, 0.25, 1000.0, 0.1 + 0.2].map(short);
        assert_eq!(texts, ["5", "0.25", "1000", "0.3"]);
    }

    #[test]
    fn condition_numbers_show_what_can_be_relied_on() {
        let texts = [1.0, 353.8, 3_153_203.8, f64::INFINITY].map(condition);
        assert_eq!(texts, ["1.00", "354", "3.2 × 10⁶", "∞"]);
    }

    #[test]
    fn what_is_no_number_is_a_sign() {
        assert_eq!((significant(f64::NAN, 3), fixed(f64::INFINITY, 1)), ("–".to_owned(), "∞".to_owned()));
        assert_eq!(signed(f64::NEG_INFINITY, 2), "−∞");
    }

    #[test]
    fn rounding_to_zero_leaves_no_sign() {
        assert_eq!((fixed(-0.0001, 2), signed(0.0, 1)), ("0.00".to_owned(), "0.0".to_owned()));
    }
}

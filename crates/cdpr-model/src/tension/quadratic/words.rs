//! A certificate in words.

use std::fmt;

use super::certificate::{Certificate, ROUNDING};

impl fmt::Display for Certificate {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.sentence())
    }
}

impl Certificate {
    /// Tensions that balance requires of cables and those that their limits allow (N); part of a sentence, without a
    /// full stop.
    ///
    /// In Σ cᵢ fᵢ = required the cables with c < 0 stand at their least tension, so that the others need the least.
    fn sentence(&self) -> String {
        if self.is_unresisted {
            return self.words_without_cables();
        }
        let weigh = |sign: f64| -> Vec<usize> {
            (0..self.weights.len()).filter(|&cable| sign * self.weights[cable] > ROUNDING).collect()
        };
        let (givers, takers) = (weigh(1.0), weigh(-1.0));
        let least: f64 = takers.iter().map(|&cable| -self.weights[cable] * self.best[cable]).sum();
        if givers.is_empty() {
            return self.words_of_takers(&takers, least);
        }
        let most: f64 = givers.iter().map(|&cable| self.weights[cable] * self.best[cable]).sum();
        let heaviest = self.heaviest(&givers);
        let [needed, most] = told_apart((self.required + least) / heaviest, most / heaviest);
        let given = match takers.is_empty() {
            true => String::new(),
            false => format!("even with {} at the least tension, ", cables(&takers)),
        };
        let names = cables(&givers);
        match givers.len() {
            1 => format!("{given}{names} would need {needed}, its limit allows {most}"),
            _ => {
                let counted = self.counted(&givers);
                format!("{given}{names} would need {needed} together{counted}, their limits allow {most}")
            }
        }
    }

    /// States that cables would have to pull less than their least tension.
    fn words_of_takers(&self, takers: &[usize], least: f64) -> String {
        let heaviest = self.heaviest(takers);
        let most = -self.required / heaviest;
        let [allowed, asked] = told_apart(most.abs(), least / heaviest);
        let names = cables(takers);
        let (together, limits) = match takers.len() {
            1 => (String::new(), "its limit asks"),
            _ => (format!(" together{}", self.counted(takers)), "their limits ask"),
        };
        match most < 0.0 {
            true => format!("{names} would have to push with {allowed}{together}, {limits} for a pull of {asked}"),
            false => format!("{names} may pull with {allowed}{together} at most, {limits} for {asked}"),
        }
    }

    fn heaviest(&self, cables: &[usize]) -> f64 {
        cables.iter().fold(0.0, |most, &cable| most.max(self.weights[cable].abs()))
    }

    /// Weights of the cables in a sum, in words; empty if all are equal.
    fn counted(&self, summed: &[usize]) -> String {
        let heaviest = self.heaviest(summed);
        let weight = |cable: usize| self.weights[cable].abs() / heaviest;
        if summed.iter().all(|&cable| weight(cable) > 0.995) {
            return String::new();
        }
        let counts: Vec<String> = summed.iter().map(|&cable| format!("{:.2} f{}", weight(cable), cable + 1)).collect();
        format!(" (counted as {})", counts.join(" + "))
    }

    fn words_without_cables(&self) -> String {
        let entries: Vec<String> = self.direction.iter().map(|y| format!("{:.3}", y + 0.0)).collect();
        format!(
            "no cable acts against the load in the direction [{}], where {} are left: the structure matrix has lost rank",
            entries.join(", "),
            newtons(self.required, 3)
        )
    }
}

/// "cable 3", "cables 2 and 4", "cables 1, 2 and 5".
fn cables(indices: &[usize]) -> String {
    let numbers: Vec<String> = indices.iter().map(|cable| (cable + 1).to_string()).collect();
    match numbers.split_last() {
        None => "no cable".to_owned(),
        Some((last, [])) => format!("cable {last}"),
        Some((last, before)) => format!("cables {} and {last}", before.join(", ")),
    }
}

/// Two forces with as many digits as needed to tell them apart.
fn told_apart(a: f64, b: f64) -> [String; 2] {
    let digits = (3..=12).find(|&digits| newtons(a, digits) != newtons(b, digits)).unwrap_or(12);
    [newtons(a, digits), newtons(b, digits)]
}

/// A force with this many significant digits: in kilonewtons from 1000 N on, as a power of ten from 10¹⁵ N on.
fn newtons(force: f64, digits: usize) -> String {
    let (value, unit) = if force.abs() >= 999.5 { (force / 1e3, "kN") } else { (force, "N") };
    if !(value.abs() < 1e12) {
        return format!("{value:.*e} {unit}", digits.saturating_sub(1));
    }
    let before_point = if value.abs() >= 1.0 { value.abs().log10().floor() as usize + 1 } else { 1 };
    format!("{value:.*} {unit}", digits.saturating_sub(before_point))
}

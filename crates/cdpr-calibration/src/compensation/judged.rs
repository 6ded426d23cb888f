//! Errors with a map and without it, and the rules that decide whether it helps.

use crate::evaluation::ErrorBlocks;
use cdpr_model::compensation::Beyond;

/// Gain of the mean square length error in standard errors that is no chance.
const SURE: f64 = 2.0;

/// Root mean square length error with the map, as a share of that without, that is worth a map.
const WORTH: f64 = 0.95;

/// Errors on samples held out in turn, without the map and with maps of the others.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    /// Samples.
    pub samples: usize,
    /// Samples beyond the others, where their map is zero, and in the margin around the others, where it fades.
    pub beyond: Beyond,
    /// Errors of the model alone.
    pub without: ErrorBlocks,
    /// Errors with the map.
    pub with: ErrorBlocks,
    /// Fall of the mean square length error (m²).
    pub gain_m2: f64,
    /// Its standard error (m²).
    pub gain_standard_error_m2: f64,
}

/// A rule that a map keeps or breaks on samples held out.
struct Rule {
    /// True where the map keeps it.
    holds: bool,
    /// The rule in words, with numbers.
    words: String,
}

impl Judged {
    /// True where a map keeps all rules and helps, and the verdict with its rules in words.
    pub(super) fn verdict(&self) -> (bool, String) {
        let rules = [self.sure(), self.gain(), self.poses()];
        let words = |holds: bool| -> String {
            let own = rules.iter().filter(|rule| rule.holds == holds).map(|rule| rule.words.as_str());
            own.collect::<Vec<_>>().join("; ")
        };
        let (kept, broken) = (words(true), words(false));
        if broken.is_empty() {
            return (true, format!("on samples held out the map helps, by every rule: {kept}"));
        }
        let [sure, gain, _] = &rules;
        let cause = match sure.holds && gain.holds {
            true => "lengths are better with it, but poses are not",
            false => "what the model leaves is noise, or changes too fast over the workspace for these samples",
        };
        let kept = if kept.is_empty() { kept } else { format!("; kept is: {kept}") };
        (false, format!("on samples held out the map does not help: {cause}. Broken is: {broken}{kept}"))
    }

    /// A gain that is no chance.
    fn sure(&self) -> Rule {
        let found = self.gain_m2 / self.gain_standard_error_m2;
        // a gain that is no number is not sure
        let holds = self.gain_m2 > SURE * self.gain_standard_error_m2;
        let way = if found < 0.0 { "rises" } else { "falls" };
        let words = match found.is_finite() {
            true => format!(
                "the mean square of the length errors {way} by {:.1} of its standard errors (a fall of more than {SURE:.0} is asked)",
                found.abs()
            ),
            // nothing changes, or all samples change alike
            false => {
                let way = if holds { "falls at every sample alike" } else { "does not fall" };
                format!(
                    "the mean square of the length errors {way} (more than {SURE:.0} of its standard errors are asked)"
                )
            }
        };
        Rule { holds, words }
    }

    /// A gain that is worth a map.
    fn gain(&self) -> Rule {
        let [before, after] = [self.without, self.with].map(|errors| errors.length_error_m.rms);
        let (words, fraction) = (mm("length errors are", "rms", [before, after]), 1e2 * WORTH);
        let words = format!("{words} (less than {fraction:.0} % of that are asked)");
        Rule { holds: after < WORTH * before, words }
    }

    /// Poses that are no worse.
    fn poses(&self) -> Rule {
        let [before, after] = [self.without, self.with].map(|errors| errors.position_error_m.mean);
        let words = match before.is_finite() && after.is_finite() {
            true => mm("position errors are", "in the mean", [before, after]) + " (no more are asked)",
            false => "no poses are predicted, so that lengths alone judge".to_owned(),
        };
        // poses that nobody can predict are no worse
        let is_worse = after > before;
        Rule { holds: !is_worse, words }
    }
}

fn mm(errors: &str, kind: &str, [before, after]: [f64; 2]) -> String {
    format!("{errors} {:.3} mm {kind} with it and {:.3} mm without", 1e3 * after, 1e3 * before)
}

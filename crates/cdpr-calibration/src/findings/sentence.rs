//! Explanations of residuals as findings: the sentence, its place, and how much it weighs.

use super::cause::{Cause, Explanation};
use super::scan::Search;
use crate::screening::place;
use cdpr_model::finding::{Finding, Severity};
use cdpr_model::measurement::three_digits;

/// Size of an explained part beside the noise that is left from which on the answer is not to be trusted.
const GROSS: f64 = 5.0;

impl Search<'_> {
    pub(super) fn told(&self, best: &Explanation, rivals: &[&Explanation]) -> Finding {
        let explained = format!(" (explains {:.0} %)", 100.0 * best.explained);
        let text = match rivals.first() {
            None => format!("{}{explained}{}{}", self.words(best), best.cause.question(), self.remedy(best)),
            Some(_) => {
                let others: Vec<String> = rivals.iter().take(2).map(|other| self.words(other)).collect();
                format!("one of these explains the residuals{explained}: {}; {}", self.words(best), others.join("; "))
            }
        };
        let size = if best.cause.unit() == "m" { best.size.abs().max(best.part) } else { best.part };
        let is_gross = size > GROSS * best.left;
        let (severity, text) = match is_gross {
            true => (Severity::Distrust, format!("not to be trusted: {text}")),
            false => (Severity::Caution, text),
        };
        let mut finding = Finding::new(best.cause.kind(self.is_redundant()), severity, text)
            .of_size(best.size, best.cause.unit())
            .explaining(best.explained);
        if let Some(cable) = best.cable {
            finding = finding.of_cable(cable);
        }
        match best.first.and_then(|first| self.line(first)) {
            Some(line) => finding.at_line(line),
            None => finding,
        }
    }

    /// Name of what can be freed to take an explanation up, behind its question.
    fn remedy(&self, one: &Explanation) -> String {
        let cable = one.cable.map_or_else(String::new, |cable| format!("[{}]", cable + 1));
        let line = one.first.and_then(|first| self.line(first));
        match (one.cause, line) {
            (Cause::Step | Cause::Offsets, Some(line)) => format!(" `length-offset{cable}@{line}` free takes it up"),
            (Cause::Drift | Cause::Drifts, _) => format!(" `length-drift{cable}` free takes it up"),
            _ => String::new(),
        }
    }

    pub(super) fn is_redundant(&self) -> bool {
        let robot = self.examined.given;
        robot.cables.len() > robot.motion_pattern.dof()
    }

    fn line(&self, first: usize) -> Option<usize> {
        Some(self.examined.samples.lines.as_ref()?[self.table.rows[first]])
    }

    fn words(&self, one: &Explanation) -> String {
        let cable = one.cable.map_or_else(|| "all cables".to_owned(), |cable| format!("cable {}", cable + 1));
        let from = one.first.map_or_else(String::new, |first| place(self.examined.samples, self.table.rows[first]));
        let mm = 1e3 * one.size;
        match one.cause {
            Cause::Step => format!("{cable}: {mm:+.1} mm from {from} on"),
            Cause::Offsets => format!("{cable}: a constant each, {mm:.1} mm rms, from {from} on"),
            Cause::HeldOut => format!("{cable}: a constant each, {mm:.1} mm rms, in the validation data"),
            Cause::Tracker => format!("the poses move by {mm:.1} mm (rms along the cables) from {from} on"),
            Cause::Drift | Cause::Drifts => {
                let all = one.size * self.duration();
                format!("{cable}: the lengths drift, by {:+.1} mm over the record", 1e3 * all)
            }
            Cause::Backlash | Cause::Backlashes => {
                format!("{cable}: lengths differ by {:.1} mm with the direction of travel", (2.0 * mm).abs())
            }
            Cause::DeadBand => {
                format!("{cable}: lengths stay behind by {:.1} mm after every reversal", (2.0 * mm).abs())
            }
            Cause::Clock => format!(
                "poses are recorded {:.0} ms {}",
                1e3 * one.size.abs(),
                if one.size > 0.0 { "late" } else { "early" }
            ),
            Cause::Loud => {
                let rest = self.rms_of_others(one.cable);
                format!("{cable}: residuals of {mm:.1} mm rms, {} mm for the others", three_digits(1e3 * rest))
            }
        }
    }

    fn rms_of_others(&self, cable: Option<usize>) -> f64 {
        let others =
            || self.table.cables.iter().enumerate().filter(|(other, _)| Some(*other) != cable).map(|(_, own)| own);
        let (squares, freedom) =
            others().fold((0.0, 0.0), |(squares, freedom), own| (squares + own.squares, freedom + own.freedom));
        (squares / f64::max(freedom, 1.0)).sqrt()
    }
}

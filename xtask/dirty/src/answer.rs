//! Answer of the command to a cell.

use serde_json::Value;

use crate::written::Errors;

/// A finding as JSON has it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Found {
    pub(crate) kind: String,
    /// Counted from 1.
    pub(crate) cable: Option<usize>,
    pub(crate) line: Option<usize>,
    pub(crate) severity: String,
    pub(crate) text: String,
}

/// Answer of `cdpr select`.
#[derive(Clone, Debug, Default)]
pub(crate) struct Answer {
    pub(crate) exit: i32,
    pub(crate) status: String,
    /// Name of the recommended candidate.
    pub(crate) recommended: Option<String>,
    /// Code of a refusal, and its words.
    pub(crate) code: String,
    pub(crate) reason: String,
    /// The worst first.
    pub(crate) findings: Vec<Found>,
    /// All warnings in words, those without a kind, too.
    pub(crate) warnings: Vec<String>,
    /// Whether the cables of the model that was chosen stretch.
    pub(crate) elastic: bool,
    pub(crate) told: Option<Errors>,
}

impl Answer {
    /// From the exit code and the text on stdout; an error where the text is no answer.
    pub(crate) fn of(exit: i32, text: &str) -> Result<Self, String> {
        let answer: Value = serde_json::from_str(text).map_err(|error| format!("no JSON ({error}): {text:.200}"))?;
        let word = |key: &str| answer[key].as_str().unwrap_or_default().to_owned();
        let findings = answer["findings"].as_array().map(|list| list.iter().map(found).collect());
        let warnings = answer["warnings"].as_array().into_iter().flatten().filter_map(Value::as_str);
        let chosen = answer["recommended"].as_str().or_else(|| answer["best"].as_str());
        let candidates = answer["candidates"].as_array().into_iter().flatten();
        let candidate = candidates.clone().find(|candidate| candidate["name"].as_str() == chosen);
        Ok(Self {
            exit,
            status: word("status"),
            recommended: answer["recommended"].as_str().map(str::to_owned),
            code: word("code"),
            reason: format!("{} {}", word("reason"), word("help")),
            findings: findings.unwrap_or_default(),
            warnings: warnings.map(str::to_owned).collect(),
            elastic: candidate.is_some_and(|it| it["model"].as_str().is_some_and(|model| model.contains("elastic"))),
            told: candidate.and_then(told),
        })
    }

    pub(crate) fn is_refusal(&self) -> bool {
        self.exit == 2
    }

    pub(crate) fn is_trusted(&self) -> bool {
        self.exit == 0
    }

    /// Whether a finding is a caution or worse.
    pub(crate) fn cautions(&self) -> bool {
        self.findings.iter().any(|found| found.severity != "remark")
    }
}

fn found(finding: &Value) -> Found {
    let word = |key: &str| finding[key].as_str().unwrap_or_default().to_owned();
    let number = |key: &str| finding[key].as_u64().and_then(|number| usize::try_from(number).ok());
    Found {
        kind: word("kind"),
        cable: number("cable"),
        line: number("line"),
        severity: word("severity"),
        text: word("text"),
    }
}

/// Upper ends of the told 95 % bands: the mean errors on validation data, and 1.96 of their standard errors above. A standard error is told of
/// the criterion alone; that of orientations is taken to be as large a part of its mean. Without poses the criterion is the length.
fn told(candidate: &Value) -> Option<Errors> {
    let mean = |key: &str| candidate["validation"][key]["mean"].as_f64();
    let criterion = candidate["criterion"].as_f64()?;
    let position = mean("position_error_m").unwrap_or(criterion);
    let part = candidate["standard_error"].as_f64().unwrap_or(0.0) / criterion.max(1e-12);
    let rotation = mean("rotation_error_rad").unwrap_or(0.0);
    let upper = 1.0 + 1.96 * part;
    Some(Errors { position: position * upper, rotation: rotation * upper })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_are_read_with_their_findings_and_bands() {
        let text = r#"{"status": "recommended-with-caution", "recommended": "elastic:wrench", "best": "standard",
            "candidates": [{"name": "standard"}, {"name": "elastic:wrench", "model": "elastic", "criterion": 0.002,
                "standard_error": 0.0005, "validation": {"position_error_m": {"mean": 0.002}}}],
            "findings": [{"kind": "step", "cable": 3, "line": 52, "severity": "caution", "text": "it jumps"}]}"#;
        let answer = Answer::of(0, text).unwrap();
        assert!(answer.elastic && answer.cautions() && answer.is_trusted() && !answer.is_refusal());
        assert_eq!((answer.findings[0].cable, answer.findings[0].line), (Some(3), Some(52)));
        assert!((answer.told.unwrap().position - 0.00298).abs() < 1e-12);
        assert!(Answer::of(101, "thread panicked").is_err());
    }
}

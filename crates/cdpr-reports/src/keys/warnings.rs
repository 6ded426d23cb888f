//! Warnings and findings, which a reader has to know before using an answer.

use cdpr_calibration::Doubt;
use cdpr_calibration::selection::Warnings;
use cdpr_model::finding::Finding;
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

/// All warnings in words, and those with a kind, a place and a size once more as findings.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Warnings")]
pub(crate) struct WarningKeys {
    /// Warnings for the reader, doubts about the outcome first.
    warnings: Vec<String>,
    /// Findings, the worst first.
    findings: Vec<FoundKeys>,
}

/// Reason to doubt the answer; `cdpr explain finding::KIND` says what the kind means.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Finding")]
pub(crate) struct FoundKeys {
    /// Kind of the finding.
    kind: &'static str,
    /// Cable, counted from 1; null if it is about several or none.
    cable: Option<usize>,
    /// Line of the data file where it begins, the header being line 1; null without a place.
    line: Option<usize>,
    /// Size in `unit`; null without one.
    value: Option<f64>,
    /// Unit of the size; empty for a ratio.
    unit: &'static str,
    /// Fraction of the residuals' squares that it explains; null where it explains none.
    explains: Option<f64>,
    /// remark, caution or distrust.
    severity: &'static str,
    /// The finding in a sentence.
    text: String,
}

impl WarningKeys {
    pub(crate) fn serialize<S: Serializer>(warnings: &Warnings, serializer: S) -> Result<S::Ok, S::Error> {
        let mut findings: Vec<&Doubt> = warnings.doubts.iter().collect();
        findings.sort_by_key(|doubt| std::cmp::Reverse(doubt.finding.severity));
        let told = Self {
            warnings: warnings.list(),
            findings: findings.into_iter().map(|doubt| FoundKeys::of(&doubt.finding)).collect(),
        };
        Serialize::serialize(&told, serializer)
    }
}

impl FoundKeys {
    pub(crate) fn of(finding: &Finding) -> Self {
        Self {
            kind: finding.kind.word(),
            cable: finding.cable.map(|cable| cable + 1),
            line: finding.line,
            value: finding.value.filter(|value| value.is_finite()),
            unit: finding.unit,
            explains: finding.explains,
            severity: finding.severity.word(),
            text: finding.text.clone(),
        }
    }
}

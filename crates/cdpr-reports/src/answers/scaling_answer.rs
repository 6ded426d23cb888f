//! Condition of a Jacobian, its scales and influences: JSON, words and map.

use cdpr_calibration::{ConditionMap, Conditioning};
use cdpr_model::robot::ParameterKind;
use schemars::JsonSchema;
use serde::Serialize;

use crate::figures::{ConditionCells, Figure};
use crate::keys::ConditioningKeys;
use crate::number_format::{condition, significant};
use crate::report::Addition;
use crate::table::Table;

/// Condition with scales as given or found.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Scaling")]
pub struct ScalingAnswer {
    #[serde(flatten, with = "ConditioningKeys")]
    found: Conditioning,
    #[serde(skip)]
    is_auto: bool,
}

impl ScalingAnswer {
    /// Of a condition whose scales are those of the least one, or given.
    pub fn new(found: Conditioning, is_auto: bool) -> Self {
        Self { found, is_auto }
    }

    /// Part of a page.
    pub(super) fn addition(&self) -> Addition {
        let influences = &self.found.influences;
        let factors: Vec<String> =
            influences.iter().map(|one| format!("{} {}", one.name, condition(one.factor))).collect();
        Addition {
            id: "scaling",
            title: "What makes the condition",
            gist: format!("{} is {}", condition(self.found.condition), factors.join(" × ")),
            sentences: influences.iter().map(|one| format!("{}: {}", one.name, one.words)).collect(),
            figure: None,
        }
    }

    pub(super) fn words(&self, width: Option<usize>) -> String {
        let Conditioning { row_weights, rank, parameter_count, .. } = &self.found;
        let Conditioning { condition: plain, condition_unit_columns, condition_scaled, .. } = &self.found;
        let source = if self.is_auto { "found scales" } else { "the given scales" };
        let mut text = format!(
            "\ncondition: {} in SI units, {} with columns of one length, {} under {source}; rank {rank} of {parameter_count}; rows of lengths by {} 1/m, of wrenches by {} 1/N\n\n",
            condition(*plain),
            condition(*condition_unit_columns),
            condition(*condition_scaled),
            significant(row_weights.length, 3),
            significant(row_weights.wrench, 3),
        );
        text.push_str(&self.table(width));
        let addition = self.addition();
        text.push_str(&format!("{}\n", addition.gist));
        addition.sentences.iter().for_each(|words| text.push_str(&format!("  {words}\n")));
        text
    }

    fn table(&self, width: Option<usize>) -> String {
        let mut table = Table::new(["parameters", "number", "condition alone", "scale", "unit"]).left_column(4);
        for kind in &self.found.kinds {
            let is_of = |scaled: ParameterKind| {
                scaled == kind.kind || (scaled, kind.kind) == (ParameterKind::AxialStiffness, ParameterKind::Compliance)
            };
            let scale = self.found.scales.iter().find(|scale| is_of(scale.kind));
            table.row(vec![
                kind.kind.to_string(),
                kind.parameter_count.to_string(),
                condition(kind.condition),
                scale.map_or_else(|| "1".to_owned(), |scale| significant(scale.factor, 3)),
                scale.map_or(kind.kind, |scale| scale.kind).unit().to_owned(),
            ]);
        }
        table.text(width)
    }

    /// Map of κ over the scales of two kinds.
    pub fn map(&self, map: &ConditionMap) -> Option<Figure> {
        let label = |kind: ParameterKind| format!("scale of {kind} in {}", kind.unit());
        let given = map.kinds.map(|kind| self.found.scales.iter().find(|scale| scale.kind == kind));
        ConditionCells {
            labels: map.kinds.map(label),
            cells: map.points.clone(),
            marked: match given {
                [Some(first), Some(second)] => Some([first.factor, second.factor]),
                _ => None,
            },
            words: if self.is_auto { "least condition of all scales" } else { "given scales" },
        }
        .svg()
    }
}

//! Changes by each effect that a robot supports, at a pose.

use cdpr_model::geometry::Pose;
use cdpr_model::model::{Model, Supported};
use cdpr_model::robot::Robot;
use cdpr_study::effects::{Contribution, Displacement, DisplacementMethod, cost, largest, parameter_count};
use schemars::JsonSchema;
use serde::Serialize;

use super::missing_effects::{self, MissingEffect, missing_effects};
use super::{Answer, PoseAnswer};
use crate::keys::{DisplacementKeys, Maybe};
use crate::number_format::cell;
use crate::table::Table;

/// Effects of a model at a pose.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "ModelEffects")]
pub struct EffectsAnswer {
    robot: String,
    /// Every effect at once that the file supports.
    model: String,
    /// `compared`; `infeasible`, `not-converged` without tensions, `singular` without paths.
    status: &'static str,
    reason: Option<String>,
    pose: PoseAnswer,
    #[serde(rename = "tensions_N")]
    tensions: Option<Vec<f64>>,
    /// Effects of the model, one by one.
    effects: Vec<EffectAnswer>,
    /// Effects that the file does not support.
    missing: Vec<MissingEffect>,
}

/// One effect; what cannot be told is null, with its reason among the `reasons`.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "ModelEffect")]
struct EffectAnswer {
    /// Name of the effect.
    effect: &'static str,
    /// The effect that the control model has instead; null where it has none.
    replaced_by: Option<&'static str>,
    /// Model without the effect, by which the lengths are commanded.
    control_model: String,
    /// Controlled lengths of the control model minus those of the machine (m).
    length_change_m: Option<LengthChange>,
    /// Largest change of the tensions that balance the load and are nearest to the middle of the limits (N).
    #[serde(rename = "tension_change_N")]
    tension_change: Option<f64>,
    /// Displacement of the machine's platform under the control model's lengths.
    #[serde(with = "Maybe::<DisplacementKeys>")]
    platform: Option<Displacement>,
    /// The lengths minus those at the home pose (m): the part that winch offsets set there do not compensate.
    length_change_beyond_home_m: Option<LengthChange>,
    /// Displacement of the platform under these lengths.
    #[serde(with = "Maybe::<DisplacementKeys>")]
    platform_beyond_home: Option<Displacement>,
    /// Number of parameters that the effect adds.
    parameter_count: usize,
    /// Cost of modelling the effect, in words.
    cost: &'static str,
    /// Reasons why something cannot be told.
    reasons: Vec<String>,
}

/// Change of cable lengths (m).
#[derive(Serialize, JsonSchema)]
struct LengthChange {
    /// Largest magnitude (m).
    max: f64,
    /// Root mean square (m).
    rms: f64,
    /// Change of each cable (m).
    cables: Vec<f64>,
}

impl EffectsAnswer {
    /// The answer before anything is compared.
    pub fn new(model: &Model, supported: &Supported, pose: &Pose) -> Self {
        Self {
            robot: model.robot().name.clone(),
            model: model.composition().to_string(),
            status: "compared",
            reason: None,
            pose: PoseAnswer::new(model.robot(), pose),
            tensions: None,
            effects: Vec::new(),
            missing: missing_effects(supported),
        }
    }

    /// The same without a comparison: the status in a word, and the reason.
    pub fn refused(self, status: &'static str, reason: String) -> Self {
        Self { status, reason: Some(reason), ..self }
    }

    /// The same with contributions of effects at tensions, where lengths depend on these.
    pub fn compared(self, found: &[Contribution], robot: &Robot, tensions: Option<Vec<f64>>) -> Self {
        Self {
            effects: found.iter().map(|contribution| EffectAnswer::new(contribution, robot)).collect(),
            tensions,
            ..self
        }
    }
}

impl EffectAnswer {
    fn new(contribution: &Contribution, robot: &Robot) -> Self {
        let Contribution { lengths, distribution, platform, lengths_beyond_home, platform_beyond_home, .. } =
            contribution;
        let reasons = [
            lengths.as_ref().err(),
            distribution.as_ref().err(),
            platform.as_ref().err(),
            lengths_beyond_home.as_ref().err(),
            platform_beyond_home.as_ref().err(),
        ];
        let mut told: Vec<String> = Vec::new();
        for reason in reasons.into_iter().flatten() {
            let reason = reason.to_string();
            if !told.contains(&reason) {
                told.push(reason);
            }
        }
        let effect = contribution.effect;
        Self {
            effect,
            replaced_by: contribution.replaced_by,
            control_model: contribution.control.to_string(),
            length_change_m: lengths.as_deref().ok().map(LengthChange::new),
            tension_change: distribution.as_ref().ok().copied(),
            platform: platform.as_ref().ok().copied(),
            length_change_beyond_home_m: lengths_beyond_home.as_deref().ok().map(LengthChange::new),
            platform_beyond_home: platform_beyond_home.as_ref().ok().copied(),
            parameter_count: parameter_count(effect, robot),
            cost: cost(effect),
            reasons: told,
        }
    }

    /// The effect, with what stands in its place.
    fn title(&self) -> String {
        self.replaced_by.map_or_else(|| self.effect.to_owned(), |other| format!("{} → {other}", self.effect))
    }

    fn cells(&self) -> Vec<String> {
        let millimetres = |length: Option<f64>| cell(length.map(|metres| 1e3 * metres), 3);
        let of_platform = |platform: &Option<Displacement>| {
            let first_order =
                platform.as_ref().is_some_and(|platform| platform.method == DisplacementMethod::FirstOrder);
            let distance = millimetres(platform.as_ref().map(|platform| platform.translation));
            let angle = cell(platform.as_ref().map(|platform| platform.rotation.to_degrees()), 3);
            [if first_order { format!("≈{distance}") } else { distance }, angle]
        };
        let lengths = self.length_change_m.as_ref();
        let mut cells = vec![self.title(), millimetres(lengths.map(|change| change.max))];
        cells.push(millimetres(lengths.map(|change| change.rms)));
        cells.push(cell(self.tension_change, 2));
        cells.extend(of_platform(&self.platform));
        cells.push(millimetres(self.length_change_beyond_home_m.as_ref().map(|change| change.max)));
        cells.extend(of_platform(&self.platform_beyond_home));
        cells
    }
}

impl LengthChange {
    fn new(cables: &[f64]) -> Self {
        let rms = (cables.iter().map(|x| x * x).sum::<f64>() / cables.len().max(1) as f64).sqrt();
        Self { max: largest(cables.iter().copied()), rms, cables: cables.iter().map(|x| x + 0.0).collect() }
    }
}

/// Legend of the columns.
const LEGEND: &str = "\
cable: controlled length of the model without the effect minus that with it, at the same tensions; tension: change of the
tensions that balance the load nearest to the middle of the limits; platform: what the lengths of the model without the
effect do to the machine that has it (≈: to first order). Winch offsets set at the home pose take up the difference there:
“beyond home” is what they leave.
";

impl Answer for EffectsAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, width: Option<usize>) -> String {
        let mut text =
            format!("{} at {}\neffects that the file supports: {}\n", self.robot, self.pose.words(), self.model);
        self.reason.iter().for_each(|reason| text.push_str(&format!("{}: {reason}\n", self.status)));
        if !self.effects.is_empty() {
            let mut table = Table::new([
                "effect left out",
                "cable max mm",
                "cable rms mm",
                "tension N",
                "platform mm",
                "platform °",
                "beyond home: cable mm",
                "platform mm",
                "platform °",
            ]);
            self.effects.iter().for_each(|effect| table.row(effect.cells()));
            text.push_str(&format!("\n{}\n{LEGEND}", table.text(width)));
            text.push_str(&self.remarks());
        } else if self.reason.is_none() {
            text.push_str("without any, there is nothing to leave out: the model is `standard`\n");
        }
        text + &missing_effects::section(&self.missing)
    }
}

impl EffectsAnswer {
    /// Slack cables, what could not be told, and what each effect costs.
    fn remarks(&self) -> String {
        let mut text = String::new();
        let mut told: Vec<&str> = Vec::new();
        for effect in &self.effects {
            for (platform, when) in
                [(&effect.platform, ""), (&effect.platform_beyond_home, ", with offsets set at home")]
            {
                if let Some(count) = platform.as_ref().map(|platform| platform.slack).filter(|&count| count > 0) {
                    let cables = if count == 1 { "cable goes" } else { "cables go" };
                    text.push_str(&format!("without {}{when}, {count} {cables} slack\n", effect.title()));
                }
            }
            for reason in effect.reasons.iter().filter(|reason| !told.contains(&reason.as_str())).collect::<Vec<_>>() {
                text.push_str(&format!("not told ({}): {reason}\n", effect.title()));
                told.push(reason);
            }
        }
        text.push_str("\nwhat an effect costs\n");
        for effect in self.effects.iter().filter(|effect| effect.replaced_by.is_none()) {
            let count = match effect.parameter_count {
                0 => String::new(),
                count => format!("{count} parameters, "),
            };
            text.push_str(&format!("  {}: {count}{}\n", effect.effect, effect.cost));
        }
        text
    }
}

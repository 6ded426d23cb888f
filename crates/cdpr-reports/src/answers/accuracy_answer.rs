//! Errors of a control model that drives a machine.

use cdpr_calibration::ErrorBlocks;
use cdpr_model::control::Status;
use cdpr_model::control::{History, Reach};
use cdpr_model::geometry::MotionPattern;
use cdpr_study::Experiment;
use cdpr_study::accuracy::{Accuracy, Assessment};
use cdpr_study::branches::Branches;
use cdpr_study::force_tracking::ForceTracking;
use schemars::JsonSchema;
use serde::Serialize;

use super::error_table::{
    Source, convergence_remark, error_table, named, of_lengths, of_poses, of_tensions, quantities,
};
use super::tracking_answer::TrackingAnswer;
use super::{Answer, DifferenceAnswer, beyond_map, control_title, gain_words, title};
use crate::keys::{AccuracyKeys, BranchesKeys, ErrorBlockKeys, HistoryKeys, Maybe};
use crate::number_format::cell;
use crate::table::Table;

/// Errors of a control model on a machine.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Accuracy")]
pub struct AccuracyAnswer {
    status: &'static str,
    reason: Option<String>,
    control: String,
    machine: String,
    #[serde(flatten, with = "AccuracyKeys")]
    accuracy: Accuracy,
    winch_offsets_m: Vec<f64>,
    /// Initial tensions by which the winches are set (N); null where they are set by lengths.
    #[serde(rename = "initial_tensions_N")]
    initial_tensions: Option<Vec<f64>>,
    /// How well a model tells what emerged from the lengths that were sent, where one was named.
    #[serde(skip_serializing_if = "Option::is_none")]
    prediction: Option<Prediction>,
    /// Path on which a machine with hysteresis comes to the poses.
    #[serde(with = "Maybe::<HistoryKeys>", skip_serializing_if = "Option::is_none")]
    history: Option<History>,
    /// Distances between the ends of several ways to each pose, where they were asked for.
    #[serde(with = "Maybe::<BranchesKeys>", skip_serializing_if = "Option::is_none")]
    branches: Option<Branches>,
    seed: u64,
    /// Errors beside those of the controller of another study.
    #[serde(skip_serializing_if = "Option::is_none")]
    difference: Option<DifferenceAnswer>,
    /// Comparison with the control model by which the winches were set, or with that of the other study.
    #[serde(skip_serializing_if = "Option::is_none")]
    force_tracking: Option<TrackingAnswer>,
    /// The caution about force tracking; remarks follow it.
    warnings: Vec<String>,
    #[serde(skip)]
    pattern: MotionPattern,
}

/// How well a model told from the lengths that were sent what emerged.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "LengthPrediction")]
struct Prediction {
    /// Effects of the model that predicts.
    model: String,
    #[serde(flatten, with = "ErrorBlockKeys")]
    blocks: ErrorBlocks,
}

/// Why poses have no answer, by the first of them.
fn reason(assessment: &Assessment) -> Option<String> {
    let outcomes = &assessment.outcomes;
    let failed = outcomes.iter().filter(|outcome| outcome.status != Status::Converged).count();
    let (pose, first) = outcomes.iter().enumerate().find(|(_, outcome)| outcome.status != Status::Converged)?;
    let why = first.reason.as_deref().unwrap_or("no reason is known");
    let all = outcomes.len();
    Some(format!("{failed} of {all} poses have no answer, first pose {} ({}): {why}", pose + 1, first.status.name()))
}

/// Findings of an experiment.
pub struct Assessed {
    /// Errors at its poses.
    pub assessment: Assessment,
    /// Errors of a prediction from the lengths sent.
    pub prediction: Option<ErrorBlocks>,
    /// Spread of the ways to each pose.
    pub branches: Option<Branches>,
    /// Initial tensions of the machine (N).
    pub initial_tensions: Option<Vec<f64>>,
    /// Comparison with the controller by which the winches were set.
    pub force_tracking: Option<ForceTracking>,
    /// Seed of random poses.
    pub seed: u64,
}

impl AccuracyAnswer {
    /// The answer of an experiment.
    pub fn new(experiment: &Experiment, found: Assessed) -> Self {
        let Assessed { assessment, prediction, branches, initial_tensions, force_tracking, seed } = found;
        let reason = reason(&assessment);
        let prediction = prediction.zip(experiment.prediction.as_ref());
        let former = experiment.former.as_ref().zip(force_tracking);
        let answer = Self {
            status: if reason.is_none() { "converged" } else { "not-converged" },
            reason,
            control: control_title(experiment),
            machine: title(&experiment.machine),
            pattern: experiment.machine.robot().motion_pattern,
            accuracy: assessment.accuracy,
            prediction: prediction.map(|(blocks, model)| Prediction { model: title(model), blocks }),
            history: experiment.history(),
            branches,
            initial_tensions,
            winch_offsets_m: experiment.offsets.clone(),
            seed,
            difference: None,
            force_tracking: None,
            warnings: Vec::new(),
        };
        answer.tracking(former.map(|(model, found)| TrackingAnswer::new(title(model), found)))
    }

    /// The same with the difference to another controller, with which force tracking is compared instead of that by which
    /// the winches were set.
    #[must_use]
    pub fn against(mut self, difference: Option<DifferenceAnswer>) -> Self {
        if let Some(tracking) = difference.as_ref().and_then(DifferenceAnswer::force_tracking) {
            self = self.tracking(Some(tracking));
        }
        Self { difference, ..self }
    }

    /// The same with a comparison of force tracking; a worse one is a caution.
    fn tracking(mut self, found: Option<TrackingAnswer>) -> Self {
        self.warnings = found.as_ref().and_then(TrackingAnswer::caution).into_iter().collect();
        if self.reason.is_none() {
            self.status = if self.warnings.is_empty() { "converged" } else { "converged-with-caution" };
        }
        Self { force_tracking: found, ..self }
    }

    /// Remarks on what the numbers leave out.
    pub fn remarks(&self) -> Vec<String> {
        let unsettled = self.prediction.as_ref().and_then(|found| convergence_remark(&found.blocks, "predictions"));
        let places = format!("{} poses", self.accuracy.samples);
        let beyond = self.accuracy.compensation.as_ref().map(|map| map.beyond).unwrap_or_default();
        let beyond = beyond_map(beyond, &places);
        self.accuracy.remark().into_iter().chain(unsettled).chain(beyond).collect()
    }
}

impl Answer for AccuracyAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, width: Option<usize>) -> String {
        let Self { control, machine, accuracy, .. } = self;
        let mut text: String = self.warnings.iter().map(|caution| format!("Caution: {caution}.\n\n")).collect();
        text.push_str(&format!("{control} drives {machine} to {} poses\n", accuracy.samples));
        if let Some(reason) = &self.reason {
            text.push_str(&format!("{reason}; the others count\n"));
        }
        text.push_str(&format!("\n{}", self.errors(width)));
        if let Some(map) = &accuracy.compensation {
            text.push_str(&gain_words(&accuracy.position_error_m, &map.without.position_error_m));
        }
        text.push_str(&self.tensions());
        if let Some(difference) = &self.difference {
            text.push_str(&difference.words(width));
        }
        if let Some(Prediction { model, blocks }) = &self.prediction {
            let table = error_table(self.pattern, &[("value", blocks)], Source::Model, width);
            text.push_str(&format!("\n{model} predicts from the lengths sent what emerges, with errors of\n\n{table}"));
        }
        let offsets: Vec<String> = self.winch_offsets_m.iter().map(|offset| cell(Some(1e3 * offset), 2)).collect();
        text.push_str(&format!("\nwinch offsets  {} mm", offsets.join(", ")));
        if let Some(tensions) = &self.initial_tensions {
            let tensions: Vec<String> = tensions.iter().map(|tension| format!("{tension:.0}")).collect();
            text.push_str(&format!(", for initial tensions of {} N", tensions.join(", ")));
        }
        text.push('\n');
        if let Some(history) = self.history {
            let from = match history.reach {
                Reach::FromInitial => "the initial pose",
                Reach::InOrder => "the pose before",
            };
            text.push_str(&format!("each pose reached from {from} in {} steps\n", history.sub_steps));
        }
        let compared = self.branches.as_ref().filter(|branches| branches.samples > 0);
        if self.branches.is_some() && compared.is_none() {
            text.push_str(
                "\nbranches: no pose is reached on every way, so that there is no spread between them to tell\n",
            );
        }
        if let Some(Branches { stroke_m, samples, ways, position_spread_m, rotation_spread_rad, tension_spread_N }) =
            compared
        {
            text.push_str(&format!(
                "\nbranches: {ways} ways to each of {samples} poses, straight and from {:.0} mm to either side, end apart by\n{:.3} mm in the mean, \
                 {:.3} mm at most; {:.4}° in the mean, {:.4}° at most; {:.1} N in the mean, {:.1} N at most\n",
                1e3 * stroke_m,
                1e3 * position_spread_m.mean,
                1e3 * position_spread_m.max,
                rotation_spread_rad.mean.to_degrees(),
                rotation_spread_rad.max.to_degrees(),
                tension_spread_N.mean,
                tension_spread_N.max
            ));
        }
        text
    }
}

impl AccuracyAnswer {
    fn errors(&self, width: Option<usize>) -> String {
        const STATISTICS: [&str; 5] = ["mean", "rms", "median", "p95", "max"];
        let Accuracy { position_error_m, rotation_error_rad, length_error_m, tension_error_N, .. } = &self.accuracy;
        let heading = ["error", "unit"].into_iter().chain(STATISTICS);
        let mut table = Table::with_heading(heading.map(str::to_owned).collect()).left_column(1);
        let errors = [
            Some(of_poses(position_error_m)),
            self.pattern.has_rotation().then(|| of_poses(rotation_error_rad)),
            Some(of_lengths(length_error_m)),
            tension_error_N.as_ref().map(of_tensions),
        ];
        for (quantity, errors) in quantities().iter().zip(errors) {
            let Some(errors) = errors else { continue };
            let words = [quantity.name, quantity.unit].map(str::to_owned);
            table.row(words.into_iter().chain(STATISTICS.map(|name| quantity.cell(named(&errors, name)))).collect());
        }
        table.text(width)
    }

    /// One paragraph; empty for a rigid machine.
    fn tensions(&self) -> String {
        let (Some(min), Some(max)) = (self.accuracy.tension_min_N, self.accuracy.tension_max_N) else {
            return String::new();
        };
        let mut text = format!("\ntensions  {min:.0} N to {max:.0} N");
        if let Some(share) = self.accuracy.outside_limits_share {
            text.push_str(&format!(", outside the limits at {:.0} % of the poses", 100.0 * share));
        }
        if self.accuracy.slack_samples > 0 {
            text.push_str(&format!(", with slack cables at {} of them", self.accuracy.slack_samples));
        }
        if let Some(error) = self.accuracy.tension_error_N {
            text.push_str(&format!(
                "; they miss the commanded ones by {:.1} N, the mean norm over the cables",
                error.mean_norm
            ));
        }
        text.push('\n');
        text
    }
}

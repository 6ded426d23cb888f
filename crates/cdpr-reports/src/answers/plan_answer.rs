//! Planned measurements: the poses, and what they will tell.

use cdpr_calibration::{Candidates, DesignCriterion, Plan, Predicted};
use cdpr_model::control::Shortening;
use cdpr_model::geometry::MotionPattern;
use cdpr_model::model::Model;
use cdpr_model::reading::Keyword;
use schemars::JsonSchema;
use serde::Serialize;

use super::Answer;
use crate::keys::adapters::keys;
use crate::keys::{Each, FromOne, Maybe, PlanKeys, PredictedKeys};
use crate::number_format::{NONE, condition, significant};
use crate::table::Table;

/// Parameters of the table in words; the JSON has all.
const SHOWN: usize = 12;

/// A plan with what it was asked of.
pub struct Planned<'a> {
    /// Model whose parameters are free.
    pub model: &'a Model,
    /// Free parameters, as asked.
    pub free: String,
    /// Measure that was asked for.
    pub criterion: DesignCriterion,
    /// Poses that could be measured.
    pub candidates: &'a Candidates,
    /// Samples measured already.
    pub given: usize,
    /// Poses chosen.
    pub plan: Plan,
    /// Deviations to expect; `None` where no fit can be made of so few poses.
    pub predicted: Option<Predicted>,
    /// Deviations when every candidate is measured.
    pub most: Option<Predicted>,
    /// File with the poses.
    pub out: String,
}

/// Planned measurements in short.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Plan")]
pub struct PlanAnswer {
    robot: String,
    model: String,
    free: String,
    /// Criterion that the plan is best by.
    criterion: &'static str,
    status: &'static str,
    reason: Option<String>,
    /// Number of planned poses.
    count: usize,
    /// Number of candidates.
    candidates: usize,
    /// Poses of the list that cannot be measured.
    left_out: Vec<LeftOut>,
    /// Number of poses that were measured already.
    given: usize,
    /// Rows of the list of candidates, from 1, in the order of the path.
    poses: Vec<usize>,
    /// The same poses by their components.
    pose_components: Vec<Vec<f64>>,
    #[serde(flatten, with = "PlanKeys")]
    plan: Plan,
    /// Cable that is shortened at each of the poses for a tension test; null elsewhere.
    #[serde(with = "Maybe::<Each<Maybe<TensionTestKeys>>>", skip_serializing_if = "Option::is_none")]
    tension_tests: Option<Vec<Option<Shortening>>>,
    /// Deviations to expect.
    #[serde(with = "Maybe::<PredictedKeys>")]
    predicted: Option<Predicted>,
    /// Weak directions that stay when every candidate is measured.
    weak_whatever_is_measured: Vec<String>,
    /// Unit directions in which the platform comes to each pose, where cables remember.
    #[serde(skip_serializing_if = "Option::is_none")]
    approach: Option<Vec<[f64; 3]>>,
    out: String,
    warnings: Vec<String>,
    #[serde(skip)]
    pattern: MotionPattern,
}

keys! {
    /// One cable shortened.
    TensionTestKeys of Shortening {
        /// The cable, from 1.
        cable by FromOne,
        /// Length by which it is shortened (m).
        by = "shorten_m",
    }
}

/// Candidate that cannot be measured.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "LeftOutPose")]
struct LeftOut {
    /// Row of the list, from 1.
    pose: usize,
    /// Reason why it cannot be measured.
    reason: String,
}

impl PlanAnswer {
    /// The answer.
    pub fn new(planned: Planned<'_>) -> Self {
        let Planned { model, free, criterion, candidates, given, plan, predicted, most, out } = planned;
        let robot = model.robot();
        let is_known = plan.log_det.is_some();
        let reason = (!is_known).then(|| {
            format!(
                "the poses determine {} of {} parameters: measure more poses, in more orientations, or hold parameters",
                plan.rank, plan.parameter_count
            )
        });
        let pattern = robot.motion_pattern;
        let pose = |&place: &usize| -> Vec<f64> {
            pattern
                .pose_to_components(robot.plane, &candidates.samples.poses[place])
                .into_iter()
                .map(|own| own + 0.0)
                .collect()
        };
        let remembers = model.composition().stretch.remembers();
        let mut answer = Self {
            robot: robot.name.clone(),
            model: model.composition().to_string(),
            free,
            criterion: criterion.name(),
            status: if is_known { "planned" } else { "not-determined" },
            reason,
            count: plan.chosen.len(),
            candidates: candidates.pose_count(),
            left_out: candidates
                .left_out
                .iter()
                .map(|(pose, reason)| LeftOut { pose: pose + 1, reason: reason.clone() })
                .collect(),
            given,
            poses: plan.chosen.iter().map(|&place| candidates.places[place] + 1).collect(),
            pose_components: plan.chosen.iter().map(pose).collect(),
            tension_tests: candidates
                .tests
                .iter()
                .any(Option::is_some)
                .then(|| plan.chosen.iter().map(|&place| candidates.tests[place]).collect()),
            approach: remembers.then(|| approach(model, candidates, &plan.chosen)),
            weak_whatever_is_measured: most.map(|most| most.weak_directions).unwrap_or_default(),
            predicted,
            plan,
            out,
            warnings: Vec::new(),
            pattern: robot.motion_pattern,
        };
        answer.warnings = answer.found_warnings(remembers);
        answer
    }

    fn found_warnings(&self, remembers: bool) -> Vec<String> {
        let mut warnings = Vec::new();
        if let Some(first) = self.left_out.first() {
            warnings.push(format!(
                "{} of {} candidate poses cannot be measured and are left out, first pose {}: {}",
                self.left_out.len(),
                self.left_out.len() + self.candidates,
                first.pose,
                first.reason
            ));
        }
        if let Some(assumed) = self.predicted.as_ref().and_then(|predicted| predicted.assumed) {
            warnings.push(format!(
                "no accuracy of the sensors is stated (--sigma): rows weigh the same, and deviations are those of {} mm for lengths and exact poses",
                significant(1e3 * assumed, 3)
            ));
        }
        let weak = self.predicted.as_ref().map(|predicted| &predicted.weak_directions[..]).unwrap_or(&[]);
        warnings.extend(weak.iter().map(|direction| format!("weak after these measurements: {direction}")));
        if remembers {
            warnings.push(
                "the cables remember: come to every pose from the one before it as listed, or always from the same side, so that branches of the \
                 hysteresis do not look like errors of the geometry"
                    .to_owned(),
            );
        }
        warnings
    }

    fn numbers(&self) -> String {
        let number = |value: Option<f64>| value.map_or(NONE.to_owned(), |value| significant(value, 6));
        let Plan { log_det, condition: kappa, sigma_min, i_value, grid, starts, fraction, .. } = &self.plan;
        let mut text = format!(
            "log det {}, condition {}, smallest singular value {}, mean variance of lengths {}\n",
            number(*log_det),
            kappa.map_or(NONE.to_owned(), condition),
            significant(*sigma_min, 4),
            number(*i_value)
        );
        text.push_str(&match grid.efficiency {
            Some(efficiency) if efficiency > 0.0 => format!(
                "a plain grid of as many poses tells {} % as much (log det {})\n",
                significant(1e2 * efficiency, 3),
                number(grid.log_det)
            ),
            Some(_) => "a plain grid of as many poses does not determine all parameters\n".to_owned(),
            None => String::new(),
        });
        if self.criterion != DesignCriterion::Factorial.name() {
            text.push_str(&format!(
                "{} of {starts} starts of the exchanges led here\n",
                (fraction * f64::from(*starts)).round()
            ));
        }
        text
    }

    fn curve(&self, width: Option<usize>) -> String {
        let mut table = Table::new(["poses", "log det", "deviations"]);
        let parameters = self.plan.parameter_count as f64;
        for point in &self.plan.curve {
            let own = point.log_det.map_or(NONE.to_owned(), |value| significant(value, 5));
            let ratio =
                point.log_det.zip(self.plan.log_det).map(|(own, plan)| ((plan - own) / (2.0 * parameters)).exp());
            let ratio = ratio.map_or(NONE.to_owned(), |ratio| format!("{} ×", significant(ratio, 3)));
            table.row(vec![point.count.to_string(), own, ratio]);
        }
        table.text(width)
    }

    fn deviations(&self, width: Option<usize>) -> String {
        let Some(predicted) = &self.predicted else { return String::new() };
        let mut largest: Vec<_> = predicted.deviations.iter().collect();
        largest.sort_by(|a, b| b.sigma.unwrap_or(f64::INFINITY).total_cmp(&a.sigma.unwrap_or(f64::INFINITY)));
        let mut table = Table::new(["parameter", "deviation", "unit"]);
        for one in largest.iter().take(SHOWN) {
            let sigma = one.sigma.map_or("not determined".to_owned(), |sigma| significant(sigma, 3));
            table.row(vec![one.parameter.clone(), sigma, one.unit.to_owned()]);
        }
        let rest = predicted.deviations.len().saturating_sub(SHOWN);
        let more = if rest > 0 { format!("and {rest} smaller ones\n") } else { String::new() };
        let pose = predicted.pose.map_or(String::new(), |pose| {
            let turned = if self.pattern.has_rotation() {
                format!(", {}°", significant(pose.rotation_rad.to_degrees(), 3))
            } else {
                String::new()
            };
            format!(
                "\na controller with the identified parameters will deviate by {} mm{turned} rms over {} candidates, {} mm at most (1 σ)\n",
                significant(1e3 * pose.position_m, 3),
                pose.poses,
                significant(1e3 * pose.position_max_m, 3)
            )
        });
        format!("\nlargest deviations to expect\n\n{}{more}{pose}", table.text(width))
    }
}

/// Unit directions from each pose's predecessor to it; zero without a way.
fn approach(model: &Model, candidates: &Candidates, chosen: &[usize]) -> Vec<[f64; 3]> {
    let mut last = model.robot().home_or_middle().position;
    let way = |&place: &usize| {
        let position = candidates.samples.poses[place].position;
        let way = position - last;
        last = position;
        way.try_normalize(1e-9).map_or([0.0; 3], Into::into)
    };
    chosen.iter().map(way).collect()
}

impl Answer for PlanAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, width: Option<usize>) -> String {
        let Self { robot, model, free, count, candidates, criterion, given, .. } = self;
        let beside = if *given > 0 { format!(" beside {given} measured ones") } else { String::new() };
        let mut text = format!(
            "{robot}, model {model}, {free}: {count} poses of {candidates} candidates{beside}, by criterion {criterion}\n"
        );
        self.warnings.iter().for_each(|warning| text.push_str(&format!("caution: {warning}\n")));
        self.reason.iter().for_each(|reason| text.push_str(&format!("{reason}\n")));
        if let Some(tests) = &self.tension_tests {
            let tests = tests.iter().flatten().count();
            text.push_str(&format!("{tests} of them are tension tests, each with one cable shortened\n"));
        }
        text.push_str(&self.numbers());
        if !self.weak_whatever_is_measured.is_empty() {
            text.push_str(&format!("weak whatever is measured: {}\n", self.weak_whatever_is_measured.join("; ")));
        }
        text.push_str(&format!("\n{}", self.curve(width)));
        text.push_str(&self.deviations(width));
        text.push_str(&format!("\nposes written to {}, in the order of a short path\n", self.out));
        text
    }
}

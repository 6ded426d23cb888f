//! Campaigns: poses are planned, measured, used for identification and planned again (sec. 4.1, 6.2), so that a better
//! model reaches more informative poses.

mod repetitions;
#[cfg(test)]
mod tests;

pub use repetitions::{RepeatedRound, Repetition};

use thiserror::Error;

use crate::Experiment;
use crate::accuracy::Accuracy;
use crate::reachable::Requirements;
use crate::study::CampaignTable;
use cdpr_calibration::evaluation::{ErrorBlocks, Evaluation, EvaluationError, evaluate_fitted};
use cdpr_calibration::fit::{self, Fit, Prior, Status, fit};
use cdpr_calibration::{Candidates, DesignCriterion, PlanError, PlanSettings, plan};
use cdpr_model::control::CommandedPose;
use cdpr_model::control::{InputError, Outcome, Status as Rest};
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Samples, Split};
use cdpr_model::model::{FreeParameters, Model, ParameterError};
use cdpr_model::reading::{Keyword, keywords};

/// Number of parts of the record, each held out once.
const PARTS: usize = 5;

/// Number of starts of the exchange algorithm in a round.
const STARTS: u32 = 20;

/// Error that ends a campaign.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum CampaignError {
    /// A study without the table `[campaign]`.
    #[error("the study has no table [campaign]: it says what is free, how many poses a round has and when it ends")]
    NoTable,
    /// A measure of designs that does not exist.
    #[error("`{name}` is no criterion of designs: write d, a, e, i, condition or factorial")]
    Criterion {
        /// Name in the study.
        name: String,
    },
    /// Parameters that the robot does not have.
    #[error(transparent)]
    Parameters(#[from] ParameterError),
    /// A fit that cannot be made, or a prior that cannot be read.
    #[error(transparent)]
    Fit(#[from] fit::InputError),
    /// Poses that could not be planned.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// A machine that cannot be driven.
    #[error(transparent)]
    Machine(#[from] InputError),
    /// Samples that cannot be evaluated.
    #[error(transparent)]
    Evaluation(#[from] EvaluationError),
}

/// One round.
#[derive(Clone, Debug, PartialEq)]
pub struct Round {
    /// Number of the round, from 1.
    pub round: usize,
    /// Samples measured so far.
    pub poses: usize,
    /// Samples of this round.
    pub new_poses: usize,
    /// Candidates that the controller of the round before reached and that were not yet measured.
    pub candidates: usize,
    /// Errors on held-out samples; `None` if there are too few samples to hold some out.
    pub validation: Option<ErrorBlocks>,
    /// Errors of the model of the round before on this round's samples, to which it was not fitted.
    pub predicted: ErrorBlocks,
    /// Errors with which the identified controller drives the study's machine over all its poses; `None` if records
    /// come from files.
    pub driven: Option<Accuracy>,
    /// Fraction of the study's poses that the identified controller reaches on the study's machine.
    pub reach_share: f64,
    /// Root mean square over the study's poses of the driven position's deviation due to the parameters' uncertainty
    /// (m); `None` if a parameter is not determined.
    pub deviation_m: Option<f64>,
    /// Count of free parameters.
    pub parameter_count: usize,
    /// Rank of the Jacobian.
    pub rank: usize,
    /// Status of the fit.
    pub fit: Status,
}

/// End of a campaign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CampaignStatus {
    /// The error on held-out samples has reached the required accuracy.
    AccuracyReached,
    /// All poses of the budget are measured; no accuracy was required, or it was not reached.
    BudgetSpent,
    /// The largest number of rounds was reached.
    RoundsOver,
    /// The controller reaches no pose that was not yet measured.
    NothingLeft,
    /// The record of a round is missing.
    Waiting,
}

keywords!(
    CampaignStatus: AccuracyReached = "accuracy-reached", BudgetSpent = "budget-spent", RoundsOver = "rounds-over",
    NothingLeft = "nothing-left", Waiting = "waiting"
);

/// All rounds up to now.
#[derive(Clone, Debug)]
pub struct Campaign {
    /// Reason for which the campaign ended.
    pub status: CampaignStatus,
    /// Required mean position error (m); `None` if none is required.
    pub accuracy_m: Option<f64>,
    /// Rounds, in order.
    pub rounds: Vec<Round>,
    /// Fraction of the study's poses that the first controller reaches.
    pub reach_at_first: f64,
    /// Errors with which the first controller drives; `None` if records come from files.
    pub driven_at_first: Option<Accuracy>,
    /// The calibrated controller of the last round, or the first controller if there is none.
    pub model: Model,
    /// Poses whose record is missing.
    pub waits_for: Vec<Pose>,
}

/// A round to be recorded.
pub struct Order<'a> {
    /// Number of the round, from 1.
    pub round: usize,
    /// The experiment with the controller of the round before.
    pub experiment: &'a Experiment,
    /// Poses to command, in order.
    pub poses: &'a [CommandedPose],
    /// Lengths (and tensions) that the controller's model predicts there.
    pub expected: &'a Samples,
}

/// Settings of a campaign, read from its table.
struct Wishes {
    free: FreeParameters,
    fit: fit::Settings,
    criterion: DesignCriterion,
}

impl Wishes {
    fn of(table: &CampaignTable) -> Result<Self, CampaignError> {
        let name = table.criterion.as_deref().unwrap_or(DesignCriterion::default().name());
        let criterion = DesignCriterion::named(name);
        let criterion = criterion.ok_or_else(|| CampaignError::Criterion { name: name.to_owned() })?;
        let priors = table.prior.iter().map(|text| text.parse()).collect::<Result<Vec<Prior>, _>>()?;
        let fit = fit::Settings { hold: table.hold.parse()?, priors, ..fit::Settings::default() };
        Ok(Self { free: table.free.parse()?, fit, criterion })
    }
}

impl Experiment {
    /// Runs the rounds of the study's `[campaign]` over these poses, including tension tests if the control model is
    /// elastic.
    ///
    /// `record` returns the samples of a round, or `None` if they are not there yet: the campaign then waits. Called
    /// again with the same records, it plans the same poses and continues. `seed` is the seed of the exchange
    /// algorithm.
    pub fn campaign<E: From<CampaignError>>(
        &self,
        poses: &[CommandedPose],
        seed: u64,
        record: &mut dyn FnMut(&Order<'_>) -> Result<Option<Samples>, E>,
    ) -> Result<Campaign, E> {
        let table = self.study.campaign.as_ref().ok_or(CampaignError::NoTable)?;
        let wishes = Wishes::of(table)?;
        self.refuse_map("a campaign").map_err(CampaignError::from)?;
        let mut current = self.clone();
        let mut standing = current.standing(poses).map_err(CampaignError::from)?;
        let mut campaign = Campaign {
            status: CampaignStatus::RoundsOver,
            accuracy_m: table.accuracy_m,
            rounds: Vec::new(),
            reach_at_first: standing.reach_share,
            driven_at_first: current.is_virtual().then(|| standing.accuracy.clone()),
            model: self.control.clone(),
            waits_for: Vec::new(),
        };
        let (mut measured, mut all): (Vec<usize>, Option<Samples>) = (vec![0; poses.len()], None);
        let levels = table.tension_levels;
        let times = |command: &CommandedPose| if command.shortened.is_some() { 1 } else { levels };
        for round in 1..=table.rounds as usize {
            let is_open = |k: &usize| standing.measurable[*k] && measured[*k] < times(&poses[*k]);
            let open: Vec<usize> = (0..poses.len()).filter(is_open).collect();
            let room =
                table.budget.map_or(usize::MAX, |budget| budget - all.as_ref().map_or(0, Samples::len).min(budget));
            let count = table.poses_per_round.min(room).min(open.len() * levels.max(1));
            if count == 0 {
                campaign.status = if room == 0 { CampaignStatus::BudgetSpent } else { CampaignStatus::NothingLeft };
                break;
            }
            let (chosen, expected) = current.planned((poses, &open, levels), all.as_ref(), (&wishes, count, seed))?;
            let commands = current.commands_at_levels((poses, &chosen), &expected, levels);
            let order = Order { round, experiment: &current, poses: &commands, expected: &expected };
            let Some(samples) = record(&order)? else {
                campaign.status = CampaignStatus::Waiting;
                campaign.waits_for = commands.iter().map(|command| command.pose).collect();
                break;
            };
            chosen.iter().for_each(|&place| measured[place] += 1);
            let predicted = evaluate_fitted(&current.control, &samples).map_err(CampaignError::from)?.blocks();
            let new_poses = samples.len();
            let together = match all.take() {
                Some(before) => {
                    before.followed_by(&samples).map_err(|_| CampaignError::from(fit::InputError::NoSamples))?
                }
                None => samples,
            };
            let fit = fit(&self.control, &together, &wishes.free, &wishes.fit).map_err(CampaignError::from)?;
            let validation = held_out(&self.control, &together, &wishes, seed);
            current = self.with_control(fit.model.clone());
            standing = current.standing(poses).map_err(CampaignError::from)?;
            campaign.rounds.push(Round {
                round,
                poses: together.len(),
                new_poses,
                candidates: open.len(),
                validation,
                predicted,
                driven: current.is_virtual().then(|| standing.accuracy.clone()),
                reach_share: standing.reach_share,
                deviation_m: deviation(&fit, &without_tests(poses)),
                parameter_count: fit.parameters.len(),
                rank: fit.analysis.rank,
                fit: fit.status,
            });
            campaign.model = fit.model;
            all = Some(together);
            let is_accurate =
                validation.zip(table.accuracy_m).is_some_and(|(found, asked)| found.position_error_m.mean <= asked);
            if is_accurate {
                campaign.status = CampaignStatus::AccuracyReached;
                break;
            }
        }
        Ok(campaign)
    }

    /// True if the study's machine makes the records.
    fn is_virtual(&self) -> bool {
        use crate::study::CampaignRecord;
        self.study.campaign.as_ref().is_none_or(|table| table.record == CampaignRecord::Virtual)
    }

    /// Commands that the controller can measure now, and the fraction of the poses that it reaches; tension tests do
    /// not count, since they leave their pose on purpose.
    fn standing(&self, poses: &[CommandedPose]) -> Result<Standing, InputError> {
        let assessment = self.assess(poses)?;
        let plain = without_tests(poses);
        let accuracy = match plain.len() == poses.len() {
            true => assessment.accuracy,
            false => self.assess(&plain)?.accuracy,
        };
        let judged = |requirements: Requirements| -> Result<Vec<bool>, InputError> {
            let Requirements { tensions, position_error_max, rotation_error_max, tension_error_max } = &requirements;
            let asks = tensions.is_some()
                || tension_error_max.is_some()
                || position_error_max.is_some()
                || rotation_error_max.is_some();
            let reachable = asks.then(|| self.reachable_with(requirements)).transpose()?;
            let holds = |(command, outcome): (&CommandedPose, &Outcome)| match &reachable {
                Some(reachable) => reachable.verdict(&command.pose, outcome).reason.is_none(),
                None => outcome.status == Rest::Converged,
            };
            Ok(poses.iter().zip(&assessment.outcomes).map(holds).collect())
        };
        // a pose missed by centimetres can still be measured
        let measurable = judged(Requirements { tensions: self.requirements().tensions, ..Requirements::default() })?;
        let reached = judged(self.requirements())?;
        let reached = reached.iter().zip(poses).filter(|(reached, pose)| **reached && pose.shortened.is_none()).count();
        Ok(Standing { measurable, reach_share: reached as f64 / plain.len().max(1) as f64, accuracy })
    }

    /// The next best poses among open ones, as indices in the order of a path, with the records that the controller's
    /// model predicts.
    fn planned(
        &self,
        (poses, open, levels): (&[CommandedPose], &[usize], usize),
        measured: Option<&Samples>,
        (wishes, count, seed): (&Wishes, usize, u64),
    ) -> Result<(Vec<usize>, Samples), CampaignError> {
        let candidates: Vec<CommandedPose> = open.iter().map(|&place| poses[place].clone()).collect();
        let sigmas = self.study.noise.unwrap_or_default();
        let candidates = Candidates::of_commands(&self.control, &candidates, levels, sigmas)?;
        let count = count.min(candidates.samples.len());
        let (criterion, fit) = (wishes.criterion, wishes.fit.clone());
        let settings = PlanSettings { count, criterion, repeats: false, starts: STARTS, seed, fit };
        let found = plan(&self.control, &candidates, measured, &wishes.free, &settings)?;
        let places = found.chosen.iter().map(|&chosen| open[candidates.places[chosen]]).collect();
        Ok((places, candidates.samples.subset(&found.chosen)))
    }
}

impl Experiment {
    /// Commands of chosen poses, with the tensions of their levels if there are several.
    fn commands_at_levels(
        &self,
        (poses, chosen): (&[CommandedPose], &[usize]),
        expected: &Samples,
        levels: usize,
    ) -> Vec<CommandedPose> {
        let m = expected.cable_count;
        let real = |sample: usize, recorded: &[f64]| -> Vec<f64> {
            (0..m).map(|cable| self.control.real_tension(cable, recorded[sample * m + cable])).collect()
        };
        let command = |(sample, &place): (usize, &usize)| {
            let command = poses[place].clone();
            let has_levels = levels > 1 && command.shortened.is_none();
            let tensions = expected.tensions.as_ref().filter(|_| has_levels).map(|all| real(sample, all));
            CommandedPose { tensions, ..command }
        };
        chosen.iter().enumerate().map(command).collect()
    }
}

/// The poses that count for accuracy, without tension tests.
fn without_tests(commands: &[CommandedPose]) -> Vec<CommandedPose> {
    commands.iter().filter(|command| command.shortened.is_none()).cloned().collect()
}

/// State of a controller on the machine over the poses of a study.
struct Standing {
    /// True for each pose at which the machine comes to rest within its tension limits.
    measurable: Vec<bool>,
    /// Fraction of the poses that keep all requirements.
    reach_share: f64,
    accuracy: Accuracy,
}

/// Errors on parts that are held out in turn; `None` if the remaining samples are too few for a fit.
fn held_out(model: &Model, samples: &Samples, wishes: &Wishes, seed: u64) -> Option<ErrorBlocks> {
    let mut errors = Evaluation::default();
    for fold in Split::KFold(PARTS).folds(samples, seed).ok()? {
        let fit = fit(model, &samples.subset(&fold.train), &wishes.free, &wishes.fit).ok()?;
        errors.extend(&evaluate_fitted(&fit.model, &samples.subset(&fold.validation)).ok()?);
    }
    Some(errors.blocks())
}

/// Root mean square of the position's deviation over the poses (m); `None` if a parameter is not determined.
fn deviation(fit: &Fit, poses: &[CommandedPose]) -> Option<f64> {
    if fit.without_deviation() > 0 {
        return None;
    }
    let poses: Vec<Pose> = poses.iter().map(|command| command.pose).collect();
    let bands: Vec<f64> = fit.pose_bands(&poses).ok()?.into_iter().flatten().map(|band| band.position).collect();
    let mean = bands.iter().map(|band| band * band).sum::<f64>() / bands.len() as f64;
    (!bands.is_empty()).then(|| mean.sqrt())
}

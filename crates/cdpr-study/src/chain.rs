//! The chain of chapter 6: from the nominal controller to force control, every stage on one machine.
//!
//! Nominal → identified → driven → identified again (the four steps of sec. 6.2) → constant orientation (6.3) →
//! elastostatic prediction and identification (6.4, 6.5) → force control on the edges of a larger region.

#[cfg(test)]
pub(super) mod tests;

use thiserror::Error;

use crate::Experiment;
use crate::accuracy::Accuracy;
use crate::force_tracking::ForceTracking;
use cdpr_calibration::Loss;
use cdpr_calibration::evaluation::{ErrorBlocks, EvaluationError, evaluate, evaluate_fitted};
use cdpr_calibration::fit::{self, Fit, Prior, fit};
use cdpr_calibration::propose_reduction;
use cdpr_calibration::{point_pattern, without_rotation};
use cdpr_model::control::CommandedPose;
use cdpr_model::control::InputError;
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Samples, Split};
use cdpr_model::model::{FreeParameters, Model, ModelError, ParameterError};
use cdpr_model::robot::{Cable, ParameterKind};

/// Standard deviation of platform anchors according to drawings, the ridge of sec. 6.5 (m).
const PLATFORM_ANCHORS: f64 = 0.02;

/// Number of parts of a record, each held out once.
const PARTS: usize = 5;

/// Number of poses along every edge of the larger region, its corners included.
const ON_EDGE: usize = 11;

/// Error that ends the chain.
#[derive(Clone, Debug, PartialEq, Error)]
#[error(transparent)]
pub enum ChainError {
    /// The experiment cannot be run.
    Experiment(#[from] InputError),
    /// A fit cannot be made.
    Fit(#[from] fit::InputError),
    /// A model cannot be evaluated.
    Evaluation(#[from] EvaluationError),
    /// A robot lacks what its model needs.
    Model(#[from] ModelError),
    /// Parameters that a robot does not have.
    Parameters(#[from] ParameterError),
}

/// One stage with its errors.
#[derive(Clone, Debug, PartialEq)]
pub struct ChainStep {
    /// Name of the stage.
    pub name: &'static str,
    /// Description of the stage.
    pub words: &'static str,
    /// Section of the dissertation.
    pub section: &'static str,
    /// Number of samples or poses.
    pub samples: usize,
    /// Mean position error (m).
    pub position_mean_m: f64,
    /// Mean rotation error (rad).
    pub rotation_mean_rad: f64,
    /// True if the platform of the model turns.
    pub turns: bool,
    /// Mean magnitude of the length errors (m).
    pub length_mean_abs_m: f64,
    /// Mean over poses of the 2-norm of the tension errors (N).
    pub tension_mean_norm: Option<f64>,
    /// Smallest and largest tension of the machine (N).
    pub tension_range: Option<[f64; 2]>,
    /// Poses at which a cable is slack.
    pub slack_samples: Option<usize>,
    /// Size of the identification; `None` for a stage without one.
    pub identified: Option<Identified>,
}

/// Size and condition of an identification.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Identified {
    /// Count of free parameters.
    pub parameter_count: usize,
    /// Number of directions that the data determine: the rank of the Jacobian.
    pub rank: usize,
    /// Condition number of the Jacobian.
    pub condition: f64,
    /// Condition number of the Jacobian with columns of length one.
    pub condition_scaled: f64,
    /// Steps of the fit.
    pub iterations: u32,
}

/// All stages.
#[derive(Clone, Debug)]
pub struct Chain {
    /// Stages in their order.
    pub steps: Vec<ChainStep>,
    /// Smallest and largest change of a frame anchor's component by the first identification, as magnitudes (m).
    pub first_change_m: [f64; 2],
    /// The same between the first and the second identification (eq. 6.10).
    pub second_change_m: [f64; 2],
    /// Force control by the identified elastostatic model compared with that by the nominal one, at the same poses;
    /// `None` without these stages.
    pub force_tracking: Option<ForceTracking>,
    /// Stages that were left out, with the reason.
    pub left_out: Vec<String>,
    /// The calibrated models: the kinematic one from the first record, and the elastostatic one if the study names one.
    pub calibrated: Vec<Model>,
}

impl Experiment {
    /// Runs the chain on this experiment: its control model is the nominal one, its `[prediction]` the nominal
    /// elastostatic one.
    ///
    /// `commands` are those of the study with its tension tests, for the first and the second record; `region` has the
    /// corners of the larger box in the directions of the motion pattern (m); `seeds` are the seeds of the sensors'
    /// noise in both records.
    pub fn chain(
        &self,
        [commands, second_commands]: [&[CommandedPose]; 2],
        region: &[[f64; 2]],
        [seed, second_seed]: [u64; 2],
    ) -> Result<Chain, ChainError> {
        self.refuse_map("the chain")?;
        let mut chain = Chain::before_all_stages();
        let without_tests = |commands: &[CommandedPose]| -> Vec<CommandedPose> {
            commands.iter().filter(|one| one.shortened.is_none()).cloned().collect()
        };
        let (poses, other_poses) = (without_tests(commands), without_tests(second_commands));
        let is_level = |one: &&CommandedPose| one.pose.angle_to(&self.start) < SAME;
        let level: Vec<CommandedPose> = poses.iter().filter(is_level).cloned().collect();
        let record = self.record(&poses, seed)?.samples;
        chain.predicted(["reference", "nominal controller", "6.1"], &self.control, &record, None)?;
        let first = identified(&self.control, "frame-anchor", &record, Vec::new())?;
        chain.predicted(
            ["identified", "frame anchors identified, predicted", "6.2"],
            &first.model,
            &record,
            Some(&first),
        )?;
        chain.first_change_m = changes(&self.control, &first.model);
        let driven = self.with_control(first.model.clone());
        chain.driven(["driven", "the same, driven", "6.2"], &driven, &poses)?;
        let again = driven.record(&other_poses, second_seed)?.samples;
        let second = identified(&first.model, "frame-anchor", &again, Vec::new())?;
        chain.predicted(
            ["identified-again", "identified again from that record", "6.2"],
            &second.model,
            &again,
            Some(&second),
        )?;
        chain.second_change_m = changes(&first.model, &second.model);
        chain.constant_orientation(self, &level, seed)?;
        chain.calibrated.push(first.model);
        chain.elastostatic((self, &driven), (commands, &level), region, seed)?;
        Ok(chain)
    }
}

/// Angle below which orientations count as equal (rad).
const SAME: f64 = 1e-9;

/// Name, description and section of a stage.
type Title = [&'static str; 3];

impl Chain {
    fn before_all_stages() -> Self {
        Self {
            steps: Vec::new(),
            first_change_m: [f64::NAN; 2],
            second_change_m: [f64::NAN; 2],
            force_tracking: None,
            left_out: Vec::new(),
            calibrated: Vec::new(),
        }
    }

    /// Adds a stage: errors with which a model predicts the poses of a record from its lengths.
    fn predicted(
        &mut self,
        title: Title,
        model: &Model,
        record: &Samples,
        fit: Option<&Fit>,
    ) -> Result<(), ChainError> {
        let blocks = evaluate_fitted(model, record)?.blocks();
        let turns = model.robot().motion_pattern.has_rotation();
        self.steps.push(ChainStep { turns, tension_range: range(record), ..step(title, &blocks, fit) });
        Ok(())
    }

    /// Adds a stage: errors with which a controller drives the machine.
    fn driven(
        &mut self,
        [name, words, section]: Title,
        experiment: &Experiment,
        poses: &[CommandedPose],
    ) -> Result<(), ChainError> {
        let accuracy = experiment.assess(poses)?.accuracy;
        let Accuracy { position_error_m, rotation_error_rad, length_error_m, tension_error_N, .. } = &accuracy;
        self.steps.push(ChainStep {
            name,
            words,
            section,
            samples: poses.len(),
            position_mean_m: position_error_m.mean,
            rotation_mean_rad: rotation_error_rad.mean,
            turns: experiment.machine.robot().motion_pattern.has_rotation(),
            length_mean_abs_m: length_error_m.mean_abs,
            tension_mean_norm: tension_error_N.map(|error| error.mean_norm),
            tension_range: accuracy.tension_min_N.zip(accuracy.tension_max_N).map(|(low, high)| [low, high]),
            slack_samples: Some(accuracy.slack_samples),
            identified: None,
        });
        Ok(())
    }

    /// Sec. 6.3: poses of one orientation determine frame and platform anchors only together; the robot without
    /// platform anchors has the determined remainder.
    fn constant_orientation(
        &mut self,
        experiment: &Experiment,
        level: &[CommandedPose],
        seed: u64,
    ) -> Result<(), ChainError> {
        let control = &experiment.control;
        if point_pattern(control.robot().motion_pattern).is_none() {
            self.left_out.push("constant orientation: the platform of this robot does not turn".to_owned());
            return Ok(());
        }
        let Some(first) = level.first() else {
            self.left_out.push("constant orientation: no pose of the study has that of the initial pose".to_owned());
            return Ok(());
        };
        let turn = first.pose.rotation;
        let mut record = experiment.record(level, seed)?.samples;
        record.poses.iter_mut().for_each(|pose| pose.rotation = turn);
        let both = "frame-anchor,platform-anchor";
        let full = identified(control, both, &record, Vec::new())?;
        let blocks = evaluate_fitted(&full.model, &record)?.blocks();
        let title = ["constant-orientation", "one orientation: frame and platform anchors", "6.3"];
        self.steps.push(step(title, &blocks, Some(&full)));
        let folds = Split::Blocks(PARTS).folds(&record, seed).unwrap_or_default();
        let settings = fit::Settings { loss: Loss::Squared, ..fit::Settings::default() };
        let Some(smaller) = propose_reduction(control, &record, &full, &settings, &both.parse()?, None, &folds)? else {
            self.left_out.push("constant orientation: no smaller model predicts as well".to_owned());
            return Ok(());
        };
        let (record, nominal) = (without_rotation(&record), smaller.nominal);
        self.predicted(["reduced-nominal", "the same, anchors a − b, nominal", "6.3"], &nominal, &record, None)?;
        let fit = identified(&nominal, "frame-anchor", &record, Vec::new())?;
        self.predicted(["reduced-identified", "anchors a − b identified", "6.3"], &fit.model, &record, Some(&fit))
    }

    /// Sec. 6.4 and 6.5: prediction, identification, and force control on the grid and on the edges of a larger region.
    fn elastostatic(
        &mut self,
        (nominal, driven): (&Experiment, &Experiment),
        (commands, level): (&[CommandedPose], &[CommandedPose]),
        region: &[[f64; 2]],
        seed: u64,
    ) -> Result<(), ChainError> {
        let Some(model) = &nominal.prediction else {
            let why = "elastostatic model and force control: the study names no nominal elastostatic model under [prediction]";
            self.left_out.push(why.to_owned());
            return Ok(());
        };
        let record = driven.record(commands, seed)?.samples;
        let blocks = evaluate(model, &record)?.blocks();
        let title = ["elastostatic-nominal", "nominal elastostatic model, predicted", "6.4"];
        self.steps.push(step(title, &blocks, None));
        let prior = Prior { kind: ParameterKind::PlatformAnchor, sigma: PLATFORM_ANCHORS };
        let fit = identified(model, "frame-anchor,platform-anchor,compliance,wrench", &record, vec![prior])?;
        let title = ["elastostatic-identified", "elastostatic model identified, predicted", "6.5"];
        self.predicted(title, &fit.model, &record, Some(&fit))?;
        let before = nominal.with_control(model.clone());
        let title = ["force-control-nominal", "force control by the nominal elastostatic model, driven", "6.5"];
        self.driven(title, &before, level)?;
        let controlled = nominal.with_control(fit.model.clone());
        self.driven(["force-control", "force control by the identified one, driven", "6.5"], &controlled, level)?;
        self.force_tracking = self.compared("force-control-nominal", "force-control");
        let edges = edges(&nominal.machine, &nominal.start, region);
        self.driven(
            ["force-control-edges", "force control on the edges of the larger region", "6.5"],
            &controlled,
            &edges,
        )?;
        self.driven(["kinematic-edges", "identified kinematic controller there", "6.5"], driven, &edges)?;
        self.calibrated.push(fit.model);
        Ok(())
    }

    /// The errors of the tensions at two stages.
    fn compared(&self, before: &str, after: &str) -> Option<ForceTracking> {
        let error = |name: &str| self.steps.iter().find(|step| step.name == name)?.tension_mean_norm;
        ForceTracking::of(error(before)?, error(after)?)
    }
}

fn step([name, words, section]: Title, blocks: &ErrorBlocks, fit: Option<&Fit>) -> ChainStep {
    ChainStep {
        name,
        words,
        section,
        samples: blocks.samples,
        position_mean_m: blocks.position_error_m.mean,
        rotation_mean_rad: blocks.rotation_error_rad.mean,
        turns: true,
        length_mean_abs_m: blocks.length_error_m.mean_abs,
        tension_mean_norm: blocks.tension_error.map(|error| error.mean_norm),
        tension_range: None,
        slack_samples: None,
        identified: fit.map(|fit| Identified {
            parameter_count: fit.parameters.len(),
            rank: fit.analysis.rank,
            condition: fit.analysis.condition,
            condition_scaled: fit.analysis.condition_scaled,
            iterations: fit.iterations,
        }),
    }
}

/// Least-squares identification, as in the dissertation.
fn identified(model: &Model, free: &str, record: &Samples, priors: Vec<Prior>) -> Result<Fit, ChainError> {
    let free: FreeParameters = free.parse()?;
    let settings = fit::Settings { loss: Loss::Squared, priors, ..fit::Settings::default() };
    Ok(fit(model, record, &free, &settings)?)
}

/// Smallest and largest recorded tension (N).
fn range(record: &Samples) -> Option<[f64; 2]> {
    let tensions = record.tensions.as_ref()?;
    let low = tensions.iter().copied().fold(f64::INFINITY, f64::min);
    Some([low, tensions.iter().copied().fold(f64::NEG_INFINITY, f64::max)])
}

/// Smallest and largest magnitude of the changes of all anchor components (m).
fn changes(before: &Model, after: &Model) -> [f64; 2] {
    let cables = before.robot().cables.iter().zip(&after.robot().cables);
    let along = |(before, after): (&Cable, &Cable)| <[f64; 3]>::from((after.frame_anchor - before.frame_anchor).abs());
    // components outside the motion pattern do not change at all
    let all: Vec<f64> = cables.flat_map(along).filter(|change| *change > 0.0).collect();
    [all.iter().copied().fold(f64::INFINITY, f64::min), all.iter().copied().fold(0.0, f64::max)]
}

/// Poses along the edges of a box, in the orientation of the start; corners count once for each of their edges.
fn edges(model: &Model, start: &Pose, region: &[[f64; 2]]) -> Vec<CommandedPose> {
    let axes = model.axes();
    let count = axes.len().min(region.len());
    let mut poses = Vec::new();
    for along in 0..count {
        let others: Vec<usize> = (0..count).filter(|&axis| axis != along).collect();
        for corner in 0..1_usize << others.len() {
            for place in 0..ON_EDGE {
                let mut position = start.position;
                let mut put = |axis: usize, value: f64| {
                    let own = axes[axis].dot(&position);
                    position += axes[axis] * (value - own);
                };
                let [low, high] = region[along];
                put(along, low + (high - low) * place as f64 / (ON_EDGE - 1) as f64);
                for (bit, &axis) in others.iter().enumerate() {
                    put(axis, region[axis][corner >> bit & 1]);
                }
                poses.push(CommandedPose::at(Pose { position, ..*start }));
            }
        }
    }
    poses
}

//! `cdpr plan`: the poses at which measurements tell most.

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr_calibration::fit::{Prior, Settings};
use cdpr_calibration::{Candidates, DesignCriterion, PlanSettings, Predicted, plan};
use cdpr_model::measurement::{Samples, SensorSigmas};
use cdpr_model::model::{FreeParameters, Model};
use cdpr_model::reading::Keyword;
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::files;
use crate::inputs::{ModelArguments, read_poses};
use crate::keyword::keyword;
use crate::measurements::{SigmaOption, read_measured};
use crate::numbers::number_from_zero;
use crate::progress::Progress;
use crate::study_file::StudyFile;
use cdpr_reports::answers::{PlanAnswer, Planned};

const EXAMPLES: &str = "\
Examples:
  cdpr plan robot.toml --free frame-anchor --count 25 --study study.toml --out poses.csv
  cdpr plan robot.toml --free frame-anchor,platform-anchor --count 20 --candidates grid.csv \\
      --sigma position_m=0.001,rotation_rad=0.001,length_m=0.0002 --out poses.csv
  cdpr plan robot.toml --free frame-anchor --count 5 --candidates grid.csv --given measured.csv --out next.csv
  cdpr plan robot.toml --model elastic --free frame-anchor,compliance --count 20 \\
      --study study.toml --tension-levels 3 --out poses.csv
  cdpr plan robot.toml --model elastic --free frame-anchor,compliance --count 20 \\
      --candidates grid.csv --tension-tests 0.03 --out poses.csv";

/// Choose the poses at which measurements tell most of the free parameters, before anything is measured.
///
/// Poses are chosen among candidates by exchanges: those of a file as they are, or those of a study that its controller reaches within
/// its limits. The file that is written has the poses in the order of a short path, with the lengths (and tensions) that the model
/// expects there. The exit code is 1 when the poses do not determine all free parameters.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    model: ModelArguments,

    /// Parameters to identify, by the names of `cdpr identify --free`.
    #[arg(long, value_name = "LIST")]
    free: FreeParameters,

    /// Parameters that stay as they are although --free names them.
    #[arg(long, value_name = "LIST", default_value = "", hide_default_value = true)]
    hold: FreeParameters,

    /// Ridges towards the file's values with these standard deviations, e.g. platform-anchor=0.02: what is known besides.
    #[arg(long, value_name = "NAME=SIGMA,…", value_delimiter = ',', allow_hyphen_values = true)]
    prior: Vec<Prior>,

    /// Number of poses to choose.
    #[arg(long, value_name = "N")]
    count: usize,

    /// Measure of a set of poses: the determinant of the information (d), the mean variance of parameters (a), the direction known least (e), the
    /// mean variance of lengths over the candidates (i), the condition of the Jacobian, or a plain grid whatever it tells (factorial).
    #[arg(long, value_name = "NAME", default_value = DesignCriterion::default().name(), value_parser = keyword::<DesignCriterion>())]
    criterion: DesignCriterion,

    /// Poses to choose among, as they are (CSV with the pose columns of measurements).
    #[arg(long, value_name = "POSES.csv", conflicts_with = "study", required_unless_present = "study")]
    candidates: Option<PathBuf>,

    /// Study whose poses to choose among: those that its controller reaches on its machine within the limits.
    #[arg(long, value_name = "STUDY")]
    study: Option<PathBuf>,

    /// Measurements taken already (CSV): they count, and the next best poses are chosen.
    #[arg(long, value_name = "DATA")]
    given: Option<PathBuf>,

    /// Levels of tension at every pose, of elastic models: the middle, and two along every direction of the null space.
    #[arg(long, value_name = "K", default_value_t = 1)]
    tension_levels: usize,

    /// Every cable in turn shortened by this at every pose (m), as further candidates of elastic models; those of a study are its tension tests.
    #[arg(long, value_name = "METRES", conflicts_with = "study", value_parser = number_from_zero)]
    tension_tests: Option<f64>,

    /// Standard deviations of the sensors per axis: position_m, rotation_rad, length_m, tension_N. Without them all rows weigh the same.
    #[arg(long, value_name = "NAME=SIGMA,…", value_delimiter = ',', allow_hyphen_values = true)]
    sigma: Vec<SigmaOption>,

    /// A pose may be chosen more than once.
    #[arg(long)]
    repeats: bool,

    /// Starts of the exchanges: a set that grows pose by pose, and random ones; fewer where they would take long.
    #[arg(long, value_name = "N", default_value_t = 40, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    starts: u32,

    /// Seed of the random starts, and of random poses of the study.
    #[arg(long, value_name = "SEED", default_value_t = 0)]
    seed: u64,

    /// Poses to write, for the controller and for a study (CSV).
    #[arg(long, value_name = "POSES.csv")]
    out: PathBuf,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.model.read()?;
    output.about(&model.robot().name);
    let refused = |error: &cdpr_calibration::PlanError| Failure::refused("cdpr plan", error);
    let mut sigmas = SensorSigmas::default();
    arguments.sigma.iter().for_each(|option| option.apply(&mut sigmas));
    let given = arguments.given.as_ref().map(|path| read_measured(path, &model, output)).transpose()?;
    let progress = Progress::spinner("planning");
    let candidates = arguments.candidates(&model, sigmas)?;
    let settings = arguments.settings();
    let found =
        plan(&model, &candidates, given.as_ref(), &arguments.free, &settings).map_err(|error| refused(&error))?;
    let predict = |chosen: &[usize], given: Option<&Samples>| {
        Predicted::of(&model, &candidates, chosen, given, &arguments.free, &settings.fit)
    };
    // what no fit can be made of is told by the rank of the plan
    let predicted = predict(&found.chosen, given.as_ref()).ok();
    let everything: Vec<usize> = (0..candidates.samples.len()).collect();
    let most = predict(&everything, given.as_ref()).ok();
    drop(progress);
    let table = Samples {
        sigmas: SensorSigmas::default(),
        set: sets(&candidates, &found.chosen),
        ..candidates.samples.subset(&found.chosen)
    };
    files::write(&arguments.out, table.to_csv(model.robot()).as_bytes())?;
    output.answer(&PlanAnswer::new(Planned {
        model: &model,
        free: arguments.free.to_string(),
        criterion: settings.criterion,
        candidates: &candidates,
        given: given.map_or(0, |given| given.len()),
        plan: found,
        predicted,
        most,
        out: arguments.out.display().to_string(),
    }))
}

/// Names of tension tests and other poses, where there are such tests.
fn sets(candidates: &Candidates, chosen: &[usize]) -> Option<Vec<String>> {
    let name = |&place: &usize| match candidates.tests[place] {
        Some(test) => format!("tension-test-{}", test.cable + 1),
        None => "pose".to_owned(),
    };
    candidates.tests.iter().any(Option::is_some).then(|| chosen.iter().map(name).collect())
}

impl Arguments {
    fn settings(&self) -> PlanSettings {
        PlanSettings {
            count: self.count,
            criterion: self.criterion,
            repeats: self.repeats,
            starts: self.starts,
            seed: self.seed,
            fit: Settings { hold: self.hold.clone(), priors: self.prior.clone(), ..Settings::default() },
        }
    }

    fn candidates(&self, model: &Model, sigmas: SensorSigmas) -> Result<Candidates, Failure> {
        if let Some(path) = &self.candidates {
            let name = path.display().to_string();
            let poses = read_poses(path, model.robot())?;
            let mut candidates = Candidates::new(model, &poses, self.tension_levels, sigmas)
                .map_err(|error| Failure::refused(&name, &error))?;
            if let Some(by) = self.tension_tests {
                candidates
                    .add_tension_tests(model, &poses, by)
                    .map_err(|error| Failure::refused("--tension-tests", &error))?;
            }
            return Ok(candidates);
        }
        let path = self.study.clone().unwrap_or_default();
        let study = StudyFile::read(&path)?;
        // tension tests tell nothing of rigid cables
        let poses = if model.needs_tensions() { study.commands(self.seed)? } else { study.poses(self.seed)? };
        let reached = study.reachable_candidates(model, &poses, self.tension_levels, sigmas);
        reached.map_err(|error| study.refused(&error))
    }
}

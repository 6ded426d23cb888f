//! `cdpr sensitivity`: which numbers matter, what their tolerances do, and which tolerances an accuracy allows.

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr_model::reading::Keyword;
use cdpr_reports::sensitivity::{SensitivityAnswer, tables};
use cdpr_study::sensitivity::Offsets;
use cdpr_study::tolerance::{DeviationSettings, Engine};
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::files;
use crate::keyword::keyword;
use crate::numbers::positive_length;
use crate::parts::computed;
use crate::progress::Progress;
use crate::sensitivities;
use crate::study_file::StudyFile;
use crate::tension_method::TensionMethodArgument;

const EXAMPLES: &str = "\
Examples:
  cdpr sensitivity study.toml
  cdpr sensitivity study.toml --accuracy 0.005 --csv maps.csv
  cdpr sensitivity study.toml --robots 0 --map \"machine frame-anchor[1].x\" --svg anchor.svg
  cdpr sensitivity studies/twin-tolerances.toml --engine linear --format json";

/// Tell how the emerging pose and its tensions follow every number of the control model, of the machine, and of how the
/// winches were set.
///
/// The derivatives are analytic, at the emerging poses and along the path of cables that remember. With standard deviations in
/// [tolerances] of the study robots are drawn that deviate, and their accuracy is told; with a required accuracy, the tolerances
/// that it allows. The answer is negative (exit code 1) when a pose has no answer, and when the accuracy is missed without any
/// deviation.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Study file (TOML); `cdpr schema study` describes it.
    #[arg(value_name = "STUDY")]
    study: PathBuf,

    #[command(flatten)]
    choice: TensionMethodArgument,

    /// Effect of deviations on the winch offsets: they stay as they were set, or the winches are set anew after everything has deviated
    /// [default: that of the study, else kept].
    #[arg(long, value_name = "RULE", value_parser = keyword::<Offsets>())]
    offsets: Option<Offsets>,

    /// How the drawn robots answer: by the exact forward problem, or at once, by the derivatives.
    #[arg(long, value_name = "ENGINE", default_value = Engine::default().name(), value_parser = keyword::<Engine>())]
    engine: Engine,

    /// Robots drawn; 0 draws none [default: those of the study, else 10000].
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u32).range(0..=1_000_000))]
    robots: Option<u32>,

    /// Required accuracy of the position in metres [default: that of the study].
    #[arg(long, value_name = "METRES", value_parser = positive_length)]
    accuracy: Option<f64>,

    /// Parameters shown in the table; `--format json` has all.
    #[arg(long, value_name = "COUNT", default_value_t = 12)]
    top: usize,

    /// Write the derivatives at every pose, a row per pose and parameter (CSV).
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,

    /// Draw how this number moves the platform at every pose, named as in the table: "machine frame-anchor[1].x"; needs --svg.
    #[arg(long, value_name = "NAME", requires = "svg")]
    map: Option<String>,

    /// Write the picture of --map (SVG).
    #[arg(long, value_name = "FILE", requires = "map")]
    svg: Option<PathBuf>,

    /// Write error, spread and quantiles at every pose, a row per pose (CSV).
    #[arg(long, value_name = "FILE")]
    poses_csv: Option<PathBuf>,

    /// Seed of random poses and of the robots drawn.
    #[arg(long, value_name = "SEED", default_value_t = 0)]
    seed: u64,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let study_file = StudyFile::read(&arguments.study)?.with_tension_method(arguments.choice.tension_method);
    study_file.introduce(output);
    let tolerances = study_file.study.tolerances.clone().unwrap_or_default();
    let limit = study_file.study.limits.as_ref().and_then(|limits| limits.position_error_max_m);
    let settings = DeviationSettings {
        offsets: arguments.offsets.unwrap_or(tolerances.offsets),
        engine: arguments.engine,
        robots: arguments.robots.map_or(tolerances.robots, |robots| robots as usize),
        accuracy: arguments.accuracy.or(tolerances.accuracy_m).or(limit),
        seed: arguments.seed,
    };
    let progress = Progress::spinner("drawing robots");
    let poses = study_file.poses(arguments.seed)?;
    let found = study_file.accepted(study_file.deviations_in_parts(poses, &tolerances, &settings, &computed))?;
    drop(progress);
    found.without_effect(&tolerances).iter().for_each(|remark| output.remark(remark));
    let maps = arguments.csv.as_ref().map(|path| (path, tables::derivatives(&found, &study_file)));
    let poses = arguments.poses_csv.as_ref().map(|path| (path, tables::poses(&found)));
    let picture = match arguments.svg.as_ref().zip(arguments.map.as_ref()) {
        Some((path, name)) => Some((path, sensitivities::map(&found, &study_file, name)?)),
        None => None,
    };
    let written: Vec<_> =
        maps.iter().chain(&poses).chain(&picture).map(|(path, text)| (path.as_path(), text.as_bytes())).collect();
    files::write_all(&written)?;
    let answer = SensitivityAnswer::new(&found, &study_file, &tolerances, &settings);
    output.answer(&SensitivityAnswer { told: arguments.top, ..answer })
}

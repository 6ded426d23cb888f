//! `cdpr benchmark`: built-in robots under their control models, by the same rules.

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr_model::model::Composition;
use cdpr_model::robot::{Robot, builtin};
use cdpr_study::benchmark::{BenchmarkRules, benchmark_in_parts};
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::files;
use crate::inputs::read_robot;
use crate::parts::computed;
use crate::progress::Progress;
use cdpr_reports::answers::BenchmarkAnswer;

const EXAMPLES: &str = "\
Examples:
  cdpr benchmark
  cdpr benchmark --out benchmark
  cdpr benchmark --robots planar-example,my-robot.toml --models standard,elastic --seed 3";

/// Compare robots and control models under the same rules: every built-in robot with every model that its file supports.
///
/// Each robot is driven as its own machine, whose anchors and stiffnesses are off as those of built robots are, with the numbers of its file and
/// after an identification. Errors are told in metres and by the diagonal of the poses, beside those that the robots'
/// sources print of real machines.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Robots: built-in names or files. Default: all built-in ones.
    #[arg(long, value_name = "ROBOT,…", value_delimiter = ',')]
    robots: Vec<String>,

    /// Control models, of those that the files support. Default: all.
    #[arg(long, value_name = "MODEL,…", value_delimiter = ',')]
    models: Vec<Composition>,

    /// Folder for result.json, result.csv and report.html.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Seed of deviations, poses and noise.
    #[arg(long, value_name = "SEED", default_value_t = 0)]
    seed: u64,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let robots: Vec<Robot> = match arguments.robots.is_empty() {
        true => builtin::names().filter_map(Robot::builtin).collect(),
        false => arguments.robots.iter().map(|name| read_robot(name)).collect::<Result<_, _>>()?,
    };
    let models = Some(&arguments.models[..]).filter(|models| !models.is_empty());
    let progress = Progress::spinner("driving robots");
    let rules = BenchmarkRules { seed: arguments.seed, ..BenchmarkRules::default() };
    let found = benchmark_in_parts(&robots, models, &rules, &computed);
    drop(progress);
    let Some(out) = &arguments.out else { return output.answer(&BenchmarkAnswer::new(&robots, found, Vec::new())) };
    let _own = files::OwnFolder::make(out)?;
    let names = ["result.json", "result.csv", "report.html"];
    let answer = BenchmarkAnswer::new(&robots, found, names.map(str::to_owned).to_vec());
    let page = answer.page(&crate::session::command_line(), env!("CARGO_PKG_VERSION"));
    let page = page.map_err(|error| Failure::unwritable("the page of the benchmark", &error))?;
    let (json, csv) = (output.file(&answer, "result.json")?, answer.csv());
    let at = |name: &str| out.join(name);
    files::write_all(&[
        (&at(names[0]), json.as_bytes()),
        (&at(names[1]), csv.as_bytes()),
        (&at(names[2]), page.as_bytes()),
    ])?;
    output.answer(&answer)
}

//! The `cdpr` command as a library: [`run`] takes the words of a command line and writes to streams of the caller.
//!
//! Several runs may go on side by side in one process, each with streams of its own. Files are read and written as their paths say,
//! from the working folder of the process. [`run_in`] keeps files in memory, reports progress, and can be stopped.

mod answer;
mod commands;
mod compensation_option;
mod completion;
mod console;
mod diagnostics;

mod failure;
mod file_kind;
mod files;
mod hanging;
mod inputs;
mod interruption;
mod keyword;
mod measurements;
mod meshes;
mod numbers;
mod option_headings;
mod options;
mod pace;
mod parts;
mod progress;
mod scenario_file;
mod selecting;
mod sensitivities;
mod session;
mod statics_failure;
mod stream;
mod study_file;
mod surroundings;
mod tension_choice;
mod tension_method;
mod usage;

use std::ffi::OsString;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::process::ExitCode;

use answer::Output;
use clap::{ArgMatches, CommandFactory, FromArgMatches, Parser};
use commands::Command;
use console::Console;
use options::GlobalOptions;
use session::Session;
use surroundings::{SharedFiles, Stopped, Surroundings};

pub use commands::{PlanRefused, PreparedPlan};
pub use interruption::watch as watch_for_interruptions;
pub use stream::Stream;
pub use surroundings::{Files, Host, Observer, WorkDone};

/// Calibration and model selection for cable-driven parallel robots.
///
/// Numbers go in and out in SI units (m, rad, N). Answers go to stdout, everything else to stderr. Exit codes: 0 done,
/// 1 the answer is negative, 2 wrong usage or input, 3 numerical failure, 4 a file cannot be read or written,
/// 130 interrupted (Ctrl-C; no file is left half-written).
#[derive(Debug, Parser)]
#[command(name = "cdpr", version, propagate_version = false, after_help = EXAMPLES)]
struct CommandLine {
    #[command(subcommand)]
    command: Command,

    #[command(flatten)]
    options: GlobalOptions,
}

/// Exit code of a run that its observer stopped, as a shell gives it to commands that SIGINT ended.
const INTERRUPTED: u8 = 130;

/// Characters in a line of help at most, as the parser has them.
const HELP_WIDTH: usize = 100;

const EXAMPLES: &str = "\
Examples:
  cdpr robots
  cdpr new suspended-camera --out my-robot
  cdpr ik planar-example --pose 0.5,4
  cdpr identify robot.toml samples.csv --free length-offset --out calibrated.toml
  cdpr identify --help";

/// Runs a command line, of which the first word is the name of the program. The answer goes to `out`, remarks and failures to `err`.
///
/// Returns the exit code: 0 if the answer is positive, 1 if it is negative, 2 for wrong usage or input, 3 for a numerical failure, 4
/// for a file that cannot be read or written.
///
/// ```
/// # use std::process::ExitCode;
/// let (mut out, mut err) = (Vec::new(), Vec::new());
/// let words = ["cdpr", "ik", "planar-example", "--pose", "0.5,4", "--format", "json"];
/// let exit = cdpr_cli::run(words.map(Into::into), &mut out, &mut err);
/// assert_eq!(exit, ExitCode::SUCCESS);
/// assert!(String::from_utf8(out).unwrap().contains("\"cable_lengths_m\""));
/// ```
pub fn run(arguments: impl IntoIterator<Item = OsString>, out: &mut dyn Stream, err: &mut dyn Stream) -> ExitCode {
    run_within(arguments, Surroundings::default(), out, err)
}

/// Runs a command line as [`run`] does, within another program, which brings files in memory and takes progress.
///
/// Files that the run writes are put into `host.files`, not on the disk. If the host's observer returns `Break`, the run ends at the next
/// step of its work with the exit code 130; files that it wrote until then are unspecified.
///
/// ```
/// # use std::process::ExitCode;
/// use cdpr_cli::{Files, Host};
///
/// let mut host = Host::with_files(Files::from([("robot.toml".into(), b"layout_version = 99\n".to_vec())]));
/// let (mut out, mut err) = (Vec::new(), Vec::new());
/// let words = ["cdpr", "check", "robot.toml"].map(Into::into);
/// let exit = cdpr_cli::run_in(words, &mut host, &mut out, &mut err);
/// assert_eq!(exit, ExitCode::from(2));
/// assert!(String::from_utf8(err).unwrap().contains("robot.toml:1:"));
/// ```
pub fn run_in(
    arguments: impl IntoIterator<Item = OsString>,
    host: &mut Host,
    out: &mut dyn Stream,
    err: &mut dyn Stream,
) -> ExitCode {
    let files = SharedFiles::new(std::mem::take(&mut host.files));
    let Host { observe, controller, .. } = host.clone();
    let surroundings = Surroundings { files: Some(files.clone()), observe, controller, ..Surroundings::default() };
    // the caller's streams hold what was written; files are put in whole
    let exit = catch_unwind(AssertUnwindSafe(|| run_within(arguments, surroundings, out, err)));
    host.files = std::mem::take(&mut *files.lock());
    exit.unwrap_or_else(|thrown| match thrown.is::<Stopped>() {
        true => ExitCode::from(INTERRUPTED),
        false => resume_unwind(thrown),
    })
}

/// [`run`], within another program.
pub(crate) fn run_within(
    arguments: impl IntoIterator<Item = OsString>,
    surroundings: Surroundings,
    out: &mut dyn Stream,
    err: &mut dyn Stream,
) -> ExitCode {
    // files of options are read as words are parsed
    session::enter(Session { surroundings: surroundings.clone(), ..Session::default() });
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    if let Some(words) = completion::asked(&arguments) {
        // a shell that does not listen any more needs no answer
        let _ = out.write_all(completion::answer(CommandLine::command(), &words).as_bytes());
        return ExitCode::SUCCESS;
    }
    let words: Vec<String> = arguments.iter().skip(1).map(|word| word.to_string_lossy().into_owned()).collect();
    let matches = grouped(out.width().unwrap_or_else(|| Console::width(out))).try_get_matches_from(&arguments);
    let parsed = matches.and_then(|matches| Ok((CommandLine::from_arg_matches(&matches)?, matches)));
    let (CommandLine { command, options }, matches) = match parsed {
        Ok(parsed) => parsed,
        Err(error) => return usage::exit(&error, &words, out, err),
    };
    let mut output = Output::new(options.format, options.console(), out, err);
    let session = Session { surroundings, words, signs: output.signs() };
    let exit = options.pool(&output).and_then(|pool| {
        let work = || {
            session::enter(session);
            command.run(&mut output)
        };
        match pool {
            Some(pool) => pool.install(work),
            None => work(),
        }
    });
    exit.unwrap_or_else(|failure| match robot_argument(&matches) {
        Some(argument) => {
            if let Ok(robot) = inputs::read_robot(argument) {
                output.about(&robot.name);
            }
            output.fail(&failure.with_value("ROBOT", argument))
        }
        None => output.fail(&failure),
    })
}

/// The command line whose help lists its subcommands in groups, for a terminal of this width.
fn grouped(width: usize) -> clap::Command {
    let command = CommandLine::command();
    let header = command.get_styles().get_header();
    let subcommands = commands::listed(&command, width.min(HELP_WIDTH));
    let template = format!(
        "{{about-with-newline}}\n{{usage-heading}} {{usage}}\n\n{subcommands}{header}Options:{header:#}\n{{options}}{{after-help}}"
    );
    option_headings::under_headings(command.help_template(template))
}

/// `ROBOT` as it was given, a file or a name, of a command that takes one.
fn robot_argument(matches: &ArgMatches) -> Option<&String> {
    matches.subcommand().and_then(|(_, own)| own.try_get_one::<String>("robot").ok().flatten())
}

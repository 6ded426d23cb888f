//! The subcommands, one file each: arguments, run, answer.

use std::process::ExitCode;

use crate::answer::Output;
use crate::failure::Failure;

/// One line per subcommand: its file and its name; the arguments and the help are in the file.
macro_rules! commands {
    ($($module:ident: $name:ident,)*) => {
        $(mod $module;)*

        #[derive(Debug, clap::Subcommand)]
        pub(crate) enum Command {
            $($name($module::Arguments),)*
        }

        impl Command {
            /// Runs the subcommand; the answer goes to `output`.
            pub(crate) fn run(self, output: &mut Output) -> Result<ExitCode, Failure> {
                match self {
                    $(Self::$name(arguments) => $module::run(arguments, output),)*
                }
            }
        }
    };
}

commands! {
    robots: Robots,
    check: Check,
    ik: Ik,
    fk: Fk,
    tension: Tension,
    load: Load,
    stiffness: Stiffness,
    workspace: Workspace,
    model: Model,
    advise: Advise,
    place_pulleys: PlacePulleys,
    select: Select,
    accuracy: Accuracy,
    study: Study,
    reachable: Reachable,
    initial_tension: InitialTension,
    sweep: Sweep,
    sensitivity: Sensitivity,
    simulate: Simulate,
    demo: Demo,
    identify: Identify,
    evaluate: Evaluate,
    test_bench: TestBench,
    import: Import,
    export: Export,
    schema: Schema,
    explain: Explain,
    completions: Completions,
    man: Man,
}

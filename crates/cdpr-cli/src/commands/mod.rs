//! The subcommands, one file each: arguments, run, answer.

use std::process::ExitCode;

use crate::answer::Output;
use crate::failure::Failure;

// Declared outside the macro, so that `cargo fmt` finds them.
mod accuracy;
mod advise;
mod benchmark;
mod campaign;
mod chain;
mod check;
mod compensate;
mod completions;
mod demo;
mod dynamics;
mod evaluate;
mod explain;
mod export;
mod fk;
mod identify;
mod ik;
mod import;
mod initial_tension;
mod load;
mod man;
mod model;
mod modes;
mod new;
mod place_pulleys;
mod plan;
mod reachable;
mod robots;
mod run;
mod schema;
mod select;
mod sensitivity;
mod simulate;
mod stiffness;
mod study;
mod sweep;
mod tension;
mod test_bench;
mod workspace;

/// One line per subcommand: its file and its name; the arguments and the help are in the file.
macro_rules! commands {
    ($($module:ident: $name:ident,)*) => {
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
    new: New,
    check: Check,
    ik: Ik,
    fk: Fk,
    tension: Tension,
    load: Load,
    stiffness: Stiffness,
    dynamics: Dynamics,
    modes: Modes,
    workspace: Workspace,
    model: Model,
    advise: Advise,
    place_pulleys: PlacePulleys,
    select: Select,
    plan: Plan,
    accuracy: Accuracy,
    study: Study,
    chain: Chain,
    benchmark: Benchmark,
    campaign: Campaign,
    reachable: Reachable,
    initial_tension: InitialTension,
    sweep: Sweep,
    sensitivity: Sensitivity,
    simulate: Simulate,
    run: Run,
    demo: Demo,
    identify: Identify,
    evaluate: Evaluate,
    compensate: Compensate,
    test_bench: TestBench,
    import: Import,
    export: Export,
    schema: Schema,
    explain: Explain,
    completions: Completions,
    man: Man,
}

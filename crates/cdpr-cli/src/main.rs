//! The `cdpr` command.

use std::process::ExitCode;

fn main() -> ExitCode {
    cdpr_cli::watch_for_interruptions();
    cdpr_cli::run(std::env::args_os(), &mut std::io::stdout(), &mut std::io::stderr())
}

//! `cdpr identify`: optimal parameters of one model from measurements.
//!
//! The command has two modes, which the data decide: [`with_poses`] and [`without_poses`].

mod arguments;
mod course;
mod driving;
mod options;
mod path;
mod report;
mod scaling;
mod task;
mod uncertainty;
mod with_poses;
mod without_poses;

use std::process::ExitCode;

use crate::answer::Output;
use crate::failure::Failure;
pub(crate) use arguments::Arguments;

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.model.read()?;
    match arguments.data.lacks_poses(&model)? {
        true => without_poses::run(&arguments, &model, output),
        false => with_poses::run(&arguments, &model, output),
    }
}

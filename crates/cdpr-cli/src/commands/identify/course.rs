//! Course of the fit.

use std::path::PathBuf;

use cdpr_calibration::CourseStep;
use cdpr_calibration::fit::Fit;
use cdpr_reports::answers::CourseAnswer;
use clap::Args;

/// Options of the course.
#[derive(Clone, Debug, Args)]
pub(super) struct CourseArguments {
    /// Tell the course of the fit: step, residuals of lengths, forces and moments, and condition after every step, with the parameters in JSON,
    /// table and figure.
    #[arg(long)]
    course: bool,

    /// Table of the course to write (CSV, SI units).
    #[arg(long, value_name = "FILE", requires = "course")]
    course_table: Option<PathBuf>,

    /// Figure of the course to write (SVG): changes of the parameters, residuals and condition over the steps.
    #[arg(long, value_name = "FILE", requires = "course")]
    course_figure: Option<PathBuf>,
}

impl CourseArguments {
    pub(super) fn is_asked(&self) -> bool {
        self.course
    }

    /// Answer and files of what the options ask for.
    pub(super) fn answer(&self, course: Vec<CourseStep>, fit: &Fit) -> (Option<CourseAnswer>, Vec<(PathBuf, Vec<u8>)>) {
        let Some(answer) = CourseAnswer::new(course, fit.parameters.clone()) else {
            return (None, Vec::new());
        };
        let table = self.course_table.iter().map(|path| (path.clone(), answer.csv().into_bytes()));
        let figure =
            self.course_figure.iter().filter_map(|path| Some((path.clone(), answer.figure()?.file().into_bytes())));
        let files = table.chain(figure).collect();
        (Some(answer), files)
    }
}

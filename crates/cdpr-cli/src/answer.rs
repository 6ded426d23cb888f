//! Answers of commands, and how they are written.

use std::cell::RefCell;
use std::io;
use std::process::ExitCode;

use cdpr_calibration::Doubt;
use cdpr_calibration::selection::Warnings;
use cdpr_model::finding::Finding;
use clap::{Args, ValueEnum};
use serde::Serialize;

use crate::console::{self, Console, Signs};
use crate::diagnostics::{self, Looks};
use crate::failure::Failure;
use crate::stream::Stream;
use cdpr_reports::answers::Envelope;
use cdpr_reports::paragraphs::Paragraphs;

pub(crate) use cdpr_reports::answers::Answer;

/// How an answer is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Tables and sentences for people.
    Text,
    /// One JSON object for scripts; numbers that are not finite are null.
    Json,
}

impl Format {
    /// The format that a command line asks for which could not be parsed.
    pub(crate) fn asked_for(words: &[String]) -> Self {
        let json = words.iter().any(|word| word == "--format=json")
            || words.windows(2).any(|pair| pair[0] == "--format" && pair[1] == "json");
        if json { Self::Json } else { Self::Text }
    }
}

/// Consequence of an answer that is not to be trusted.
#[derive(Clone, Copy, Debug, Default, Args)]
pub(crate) struct TrustArguments {
    /// Exit with 0 although the answer is not to be trusted or its fit did not converge; status and warnings say so all the same.
    #[arg(long)]
    accept_untrusted: bool,
}

/// Output of a command: its answer and remarks.
pub(crate) struct Output<'a> {
    format: Format,
    console: Console,
    out: RefCell<&'a mut dyn Stream>,
    err: RefCell<&'a mut dyn Stream>,
    /// Name of the robot that is asked about.
    robot: RefCell<Option<String>>,
    /// Remarks told so far that are not part of the answer.
    remarks: RefCell<Vec<String>>,
    /// Those of them that doubt whatever the answer will be.
    doubts: RefCell<Vec<Doubt>>,
}

impl<'a> Output<'a> {
    /// Output to streams: `out` for answers, `err` for all else.
    pub(crate) fn new(format: Format, console: Console, out: &'a mut dyn Stream, err: &'a mut dyn Stream) -> Self {
        Self {
            format,
            console,
            out: RefCell::new(out),
            err: RefCell::new(err),
            robot: RefCell::default(),
            remarks: RefCell::default(),
            doubts: RefCell::default(),
        }
    }

    /// Signs of life that are wanted.
    pub(crate) fn signs(&self) -> Signs {
        let err = self.err.borrow();
        match (self.console.quiet, err.is_terminal(), err.is_of_process()) {
            (false, true, _) => Signs::Line,
            (false, false, true) => Signs::Lines,
            _ => Signs::Nothing,
        }
    }

    /// The word of `--format`.
    pub(crate) fn format_word(&self) -> &'static str {
        match self.format {
            Format::Text => "text",
            Format::Json => "json",
        }
    }

    /// Passes on what another run wrote: its answer, and its remarks.
    pub(crate) fn pass_on(&self, out: &[u8], err: &[u8]) -> Result<(), Failure> {
        if !self.console.quiet {
            self.complain(|_| String::from_utf8_lossy(err).into_owned());
        }
        self.write(&String::from_utf8_lossy(out))
    }

    /// Names the robot that the command asks about, for answers without a key `robot`.
    pub(crate) fn about(&self, robot: &str) {
        *self.robot.borrow_mut() = Some(robot.to_owned());
    }

    /// Writes the answer and tells the exit code.
    pub(crate) fn answer(&self, answer: &impl Answer) -> Result<ExitCode, Failure> {
        self.answer_accepting(answer, TrustArguments::default())
    }

    /// The same where a user may overrule an answer that is not to be trusted.
    pub(crate) fn answer_accepting(&self, answer: &impl Answer, trust: TrustArguments) -> Result<ExitCode, Failure> {
        let text = match self.format {
            Format::Text => self.text(answer),
            Format::Json => self.json(answer, status(answer))?,
        };
        self.write(&text)?;
        let is_accepted = trust.accept_untrusted && answer.may_be_accepted();
        Ok(ExitCode::from(u8::from(answer.is_negative() && !is_accepted)))
    }

    /// The answer for people in lines of the terminal: on one screen, where nothing more is asked for.
    fn text(&self, answer: &impl Answer) -> String {
        let out = self.out.borrow();
        let width = Console::width(&**out);
        if answer.is_verbatim() {
            return answer.words(Some(width));
        }
        let summary = if self.console.verbose { None } else { answer.summary(width) };
        let paragraphs = summary.unwrap_or_else(|| Paragraphs::of(&answer.words(Some(width))));
        paragraphs.text(width, self.console.has_colour(&**out))
    }

    /// Tells something that is not part of the answer, on stderr and among the warnings of a JSON answer.
    pub(crate) fn remark(&self, text: &str) {
        self.tell(text);
        self.remarks.borrow_mut().push(text.to_owned());
    }

    /// Tells something on stderr alone, unless quiet is asked for.
    pub(crate) fn tell(&self, text: &str) {
        if !self.console.quiet {
            self.complain(|looks| diagnostics::remark(text, looks));
        }
    }

    /// Tells a reason to doubt the answer, which the answer repeats before all else.
    pub(crate) fn doubt(&self, finding: &Finding) {
        self.remark(&finding.text);
        self.doubts.borrow_mut().push(finding.clone().into());
    }

    /// The doubts told so far.
    pub(crate) fn doubts(&self) -> Warnings {
        Warnings { doubts: self.doubts.borrow().clone(), remarks: Vec::new() }
    }

    /// The doubts and then the remarks told so far.
    pub(crate) fn warnings(&self) -> Warnings {
        let mut remarks = self.remarks();
        remarks.retain(|remark| self.doubts.borrow().iter().all(|doubt| doubt.words() != remark));
        Warnings { remarks, ..self.doubts() }
    }

    /// Remarks so far besides the answer, for pages and files.
    pub(crate) fn remarks(&self) -> Vec<String> {
        self.remarks.borrow().clone()
    }

    /// Tells the failure on stderr, and as an object on stdout when JSON was asked for.
    pub(crate) fn fail(&self, failure: &Failure) -> ExitCode {
        self.complain(|looks| diagnostics::failure(failure, looks));
        self.mirror(failure)
    }

    /// The failure as an object on stdout when JSON was asked for.
    pub(crate) fn mirror(&self, failure: &Failure) -> ExitCode {
        if self.format == Format::Json
            && let Ok(text) = self.json(&failure.object(), "error")
        {
            // the exit code already tells that something failed
            let _ = self.write(&text);
        }
        ExitCode::from(failure.exit_code())
    }

    /// The answer as a file keeps it, with all that was told so far besides it.
    pub(crate) fn file(&self, answer: &impl Answer, name: &str) -> Result<String, Failure> {
        let (robot, remarks) = (self.robot.borrow(), self.remarks.borrow());
        let envelope = Envelope { robot: robot.as_deref(), remarks: &remarks, status: status(answer) };
        envelope.file(answer).map_err(|error| Failure::unwritable(name, &error))
    }

    fn write(&self, text: &str) -> Result<(), Failure> {
        let mut out = self.out.borrow_mut();
        let end = if text.ends_with('\n') { "" } else { "\n" };
        match write!(out, "{text}{end}").and_then(|()| out.flush()) {
            // the reader, `head` for one, has seen enough
            Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
            Err(error) => Err(Failure::io("write to", "stdout", &error)),
            Ok(()) => Ok(()),
        }
    }

    fn complain(&self, text: impl FnOnce(Looks) -> String) {
        let mut err = self.err.borrow_mut();
        let looks = Looks { has_colour: self.console.has_colour(&**err), width: console::message_width(&**err) };
        let text = text(looks);
        // when stderr is gone there is nobody to tell
        let _ = err.write_all(text.as_bytes()).and_then(|()| err.flush());
    }

    fn json(&self, value: &impl Serialize, status: &str) -> Result<String, Failure> {
        let (robot, remarks) = (self.robot.borrow(), self.remarks.borrow());
        let envelope = Envelope { robot: robot.as_deref(), remarks: &remarks, status };
        envelope.line(value).map_err(|error| Failure::unwritable("the answer", &error))
    }
}

/// The status of an answer that has no words of its own for it.
fn status(answer: &impl Answer) -> &'static str {
    if answer.is_negative() { "negative" } else { "done" }
}

//! How tensions are chosen: `--method` and what it may be asked for.

use std::str::FromStr;

use cdpr_model::model::Model;
use cdpr_model::reading::Keyword;
use cdpr_model::tension::{InputError, Method, Options, Reference};
use cdpr_reports::answers::is_turn;
use clap::Args;

use crate::failure::Failure;
use crate::numbers::{NumberList, Unreadable, finite_number, number_from_zero};

/// `--method` and the wishes that go with it.
#[derive(Debug, Args)]
pub(crate) struct MethodArguments {
    #[arg(long, value_name = "METHOD", default_value_t = Method::Qp, help = method_help())]
    pub(crate) method: Method,

    #[arg(long, value_name = "REFERENCE", default_value = "middle", allow_hyphen_values = true)]
    #[arg(help = reference_help())]
    reference: ReferenceArgument,

    /// Tensions of the step before, one per cable (N).
    #[arg(long, value_name = "TENSIONS", allow_hyphen_values = true)]
    previous: Option<NumberList>,

    /// How fast tensions may change from the previous ones (N/s): one number, or one per cable.
    #[arg(long, value_name = "RATE", allow_hyphen_values = true)]
    rate: Option<NumberList>,

    /// Time since the previous tensions (s), for --rate.
    #[arg(long, value_name = "S", default_value_t = 1.0, value_parser = number_from_zero, allow_hyphen_values = true)]
    time_step: f64,

    #[arg(long, value_name = "P", default_value_t = 2.0, value_parser = finite_number, allow_hyphen_values = true)]
    #[arg(help = p_help())]
    p: f64,

    /// Smoothing width of smooth: part of half the largest range by which tensions keep away from limits that they would just reach.
    #[arg(long, value_name = "WIDTH", default_value_t = 0.1, value_parser = finite_number, allow_hyphen_values = true)]
    smoothing: f64,

    /// Length by which nearest-wrench divides moments to weigh them against forces (m); by default the root mean square
    /// distance of the platform anchors from the platform origin.
    #[arg(long, value_name = "M", value_parser = finite_number, allow_hyphen_values = true)]
    moment_length: Option<f64>,
}

/// `--tension-method`: how the control model chooses the tensions that it commands.
#[derive(Debug, Args)]
pub(crate) struct TensionMethodArgument {
    #[arg(long, value_name = "METHOD", help = tension_method_help())]
    pub(crate) tension_method: Option<Method>,
}

/// Names of the methods for which something holds.
fn names(holds: impl Fn(Method) -> bool, between: &str) -> String {
    let methods = Method::ALL.iter().copied().filter(|method| holds(*method));
    methods.map(Method::name).collect::<Vec<_>>().join(between)
}

/// "a, b and c"
fn list(holds: impl Fn(Method) -> bool) -> String {
    let names = names(holds, ", ");
    match names.rsplit_once(", ") {
        Some((others, last)) => format!("{others} and {last}"),
        None => names,
    }
}

/// "minimum from 1, maximum from 1"
fn least_p() -> String {
    let methods = Method::ALL.iter().filter_map(|method| Some(format!("{method} from {}", method.least_p()?)));
    methods.collect::<Vec<_>>().join(", ")
}

fn method_help() -> String {
    format!("How the tensions are chosen: {}.", names(|_| true, " | "))
}

fn reference_help() -> String {
    let methods = list(Method::stays_near_reference);
    format!("Tensions that {methods} stay near to: middle (of the limits) | previous | one tension per cable (N).")
}

fn p_help() -> String {
    format!("p of the p-norm that a method minimizes, 8 at most: {}. With 1 it is the sum.", least_p())
}

fn tension_method_help() -> String {
    let methods = names(|_| true, " | ");
    format!(
        "How a control model that commands tensions chooses them, within its limits: {methods} (default {}); in place of \
         tension_method in [control] of the study.",
        Method::default()
    )
}

/// The methods with the tensions that each chooses, a line each.
pub(crate) fn methods_in_words() -> String {
    let lines = Method::ALL.iter().map(|method| format!("{method}: {}", method.summary()));
    lines.collect::<Vec<_>>().join("\n")
}

/// `--reference`.
#[derive(Clone, Debug)]
pub(crate) enum ReferenceArgument {
    Middle,
    Previous,
    Given(NumberList),
}

impl ReferenceArgument {
    /// Words that stand for tensions.
    pub(crate) const WORDS: [&'static str; 2] = ["middle", "previous"];
}

impl FromStr for ReferenceArgument {
    type Err = Unreadable;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let [middle, previous] = Self::WORDS;
        match text {
            word if word == middle => Ok(Self::Middle),
            word if word == previous => Ok(Self::Previous),
            _ => {
                let given = text.parse().map(Self::Given);
                given.map_err(|why| format!("middle, previous or tensions expected; {why}").into())
            }
        }
    }
}

/// The wishes for one robot.
pub(crate) struct Wishes {
    reference: ReferenceArgument,
    previous: Option<Vec<f64>>,
    rates: Option<Vec<f64>>,
    time_step: f64,
    p: f64,
    smoothing: f64,
    /// 1 for forces, the moment length for moments (m).
    lengths: Vec<f64>,
}

impl MethodArguments {
    /// The wishes, one number per cable or wrench component where they are lists.
    pub(crate) fn wishes(&self, model: &Model) -> Wishes {
        let moment_length = self.moment_length.unwrap_or_else(|| moment_length(model));
        let rates = self.rate.as_ref().map(|rate| match rate.0.as_slice() {
            [rate] => vec![*rate; model.cable_count()],
            rates => rates.to_vec(),
        });
        Wishes {
            reference: self.reference.clone(),
            previous: self.previous.as_ref().map(|previous| previous.0.clone()),
            rates,
            time_step: self.time_step,
            p: self.p,
            smoothing: self.smoothing,
            lengths: model.twist_basis().iter().map(|twist| if is_turn(twist) { moment_length } else { 1.0 }).collect(),
        }
    }
}

impl Wishes {
    pub(crate) fn options(&self) -> Options<'_> {
        Options {
            reference: match &self.reference {
                ReferenceArgument::Middle => Reference::Middle,
                ReferenceArgument::Previous => Reference::Previous,
                ReferenceArgument::Given(tensions) => Reference::Given(&tensions.0),
            },
            previous: self.previous.as_deref(),
            rates: self.rates.as_deref(),
            time_step: self.time_step,
            p: self.p,
            smoothing: self.smoothing,
            lengths: Some(&self.lengths),
        }
    }

    /// Length by which moments are divided (m); `None` if the robot has none.
    pub(crate) fn moment_length(&self, model: &Model) -> Option<f64> {
        let mut rows = model.twist_basis().iter().zip(&self.lengths);
        rows.find(|(twist, _)| is_turn(twist)).map(|(_, length)| *length)
    }
}

/// Root mean square distance of the platform anchors from the origin of the platform; 1 m where all lie there.
fn moment_length(model: &Model) -> f64 {
    let cables = &model.robot().cables;
    let squares: f64 = cables.iter().map(|cable| cable.platform_anchor.norm_squared()).sum();
    let length = (squares / cables.len() as f64).sqrt();
    if length > 0.0 && length.is_finite() { length } else { 1.0 }
}

/// Refusal of a distribution, with the option that it came from.
pub(crate) fn refused(error: &InputError) -> Failure {
    match error {
        InputError::NotFinite { .. } => Failure::numerical(error.to_string()),
        InputError::ReferenceLength { .. } => Failure::refused("--reference", error),
        InputError::NoPrevious => Failure::refused("--reference, --rate without --previous", error),
        InputError::OptionCount { what, .. } | InputError::OptionValue { what, .. } => {
            Failure::refused(option_of(what), error)
        }
        _ => Failure::refused("--wrench", error),
    }
}

fn option_of(what: &str) -> &'static str {
    let options = [
        ("previous", "--previous"),
        ("rate", "--rate"),
        ("p of", "--p"),
        ("smoothing", "--smoothing"),
        ("time", "--time-step"),
    ];
    let known = options.into_iter().find(|(start, _)| what.starts_with(start));
    known.map_or("--moment-length", |(_, option)| option)
}

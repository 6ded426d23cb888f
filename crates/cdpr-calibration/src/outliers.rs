//! Samples that lie beyond 8 robust standard deviations, named.

use super::loss::Loss;
use super::norms::{Extent, Norms, OUTLIER_DEVIATIONS};
use cdpr_model::measurement::Samples;
use cdpr_model::reading::Keyword;

/// Share of a sample's squared length residuals above which one cable is blamed alone.
const ALONE: f64 = 0.9;
/// Outliers that a sentence names before it only counts the rest.
const NAMED: usize = 5;
/// Share of outliers that are no accidents any more.
const MANY: f64 = 0.1;

/// A sample that lies beyond 8 robust standard deviations.
#[derive(Clone, Debug, PartialEq)]
pub struct Outlier {
    /// Number of the sample in the data, from 1.
    pub sample: usize,
    /// Line of the file on which it stands, from 1.
    pub line: Option<usize>,
    /// 2-norm over the cables of modelled minus recorded lengths at the measured pose (m).
    pub residual_m: f64,
    /// Weight that the loss leaves to the sample; 1 with least squares.
    pub weight: f64,
    /// The deviation in words, and the cables concerned.
    pub reason: String,
}

/// The outliers of a fit; `residuals` gives the modelled minus recorded lengths of a sample (from 0) at its measured pose (m).
pub(super) fn named(norms: &Norms, samples: &Samples, residuals: impl Fn(usize) -> Vec<f64>) -> Vec<Outlier> {
    let name = |sample: usize| {
        let residuals = residuals(sample);
        Outlier {
            sample: sample + 1,
            line: samples.lines.as_ref().map(|lines| lines[sample]),
            residual_m: residuals.iter().map(|x| x * x).sum::<f64>().sqrt(),
            weight: norms.weight(sample),
            reason: reason(norms.deviations(sample), &residuals),
        }
    };
    norms.outliers().map(name).collect()
}

fn reason(deviations: f64, residuals: &[f64]) -> String {
    let all: f64 = residuals.iter().map(|x| x * x).sum();
    let largest = residuals.iter().enumerate().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    let Some((cable, residual)) = largest else { return format!("{deviations:.0} robust standard deviations") };
    let (cable, size) = (cable + 1, 1e3 * residual);
    let who = match residual * residual > ALONE * all && residuals.len() > 1 {
        true => format!("cable {cable} alone is off, by {size:.1} mm: its length is suspicious"),
        false => format!(
            "several cables are off, cable {cable} most, by {size:.1} mm: the pose is suspicious, or several lengths are"
        ),
    };
    format!("{deviations:.0} robust standard deviations; {who}")
}

/// Place of a sample (from 1) in words: its line where that is known.
fn place(line: Option<usize>, sample: usize) -> String {
    line.map_or_else(|| format!("sample {sample}"), |line| format!("line {line}"))
}

/// The first places, and how many more there are.
fn listed(places: impl ExactSizeIterator<Item = String>) -> String {
    let more = match places.len().saturating_sub(NAMED) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    let first: Vec<String> = places.take(NAMED).collect();
    first.join(", ") + &more
}

/// Warning about the outliers of a fit to so many samples, which stands before anything else; `None` without any.
pub(super) fn warning(outliers: &[Outlier], samples: usize, loss: Loss) -> Option<String> {
    let largest = outliers.iter().max_by(|a, b| a.residual_m.total_cmp(&b.residual_m))?;
    let name = |outlier: &Outlier| place(outlier.line, outlier.sample);
    let listed = listed(outliers.iter().map(name));
    let (count, fraction) = (outliers.len(), outliers.len() as f64 / samples as f64);
    let (lie, them) = if count == 1 { ("lies", "it") } else { ("lie", "them") };
    let treated = match loss {
        Loss::Squared => {
            format!(
                "the squared loss counts {them} fully, so that parameters and errors are not to be trusted: take `auto` or `huber`, or mend the rows"
            )
        }
        loss => format!("the fit counts {them} less ({} loss), and the errors told leave {them} out", loss.name()),
    };
    let many = match fraction > MANY {
        true => "; so many are no accidents: check units, columns, clocks and the robot's file",
        false => "",
    };
    Some(format!(
        "outliers: {count} of {samples} samples {lie} beyond {OUTLIER_DEVIATIONS:.0} robust standard deviations ({listed}), by up to \
         {:.1} mm of length ({}); {treated}{many}",
        1e3 * largest.residual_m,
        name(largest)
    ))
}

/// Samples whose least error over all models lies beyond 8 robust standard deviations of these errors; NaN is no error.
///
/// One model that explains a sample keeps it in for all, so that no model gains by calling samples outliers.
pub(super) fn unexplained(least: impl IntoIterator<Item = f64>) -> Vec<usize> {
    let (places, squares): (Vec<usize>, Vec<f64>) = least
        .into_iter()
        .enumerate()
        .filter(|(_, error)| error.is_finite())
        // mm, mrad and mN, of which a thousandth is nothing
        .map(|(place, error)| (place, (1e3 * error).powi(2)))
        .unzip();
    let extent = Extent { rows: squares.len(), parameters: 0, absolute: false };
    Norms::new(squares, None, extent).outliers().map(|index| places[index]).collect()
}

/// Validation samples, some of which (numbers from 0 in the data) no model explains; `None` without any.
pub(super) fn set_aside_warning(places: &[usize], of: usize, samples: &Samples) -> Option<String> {
    let name = |&sample: &usize| place(samples.lines.as_ref().map(|lines| lines[sample]), sample + 1);
    let listed = listed(places.iter().map(name));
    let (count, verb, them) = match places.len() {
        0 => return None,
        1 => (1, "is", "it"),
        count => (count, "are", "them"),
    };
    Some(format!(
        "outliers: {count} of {of} validation samples {verb} set aside for every model, since none explains {them} ({listed})"
    ))
}

//! From a record of input and output to a frequency response, and to a low-order transfer function with its uncertainty.
//!
//! A [`Record`] is plain series (times, input, output), measured or simulated. Its response is estimated
//!
//! * by windows (H1: cross spectrum by the input's spectrum, over Hann's windows that overlap by half), for sweeps, noise and sums of sines, or
//! * by sines fitted to each step of a stepped sine.
//!
//! Each [`Point`] has its coherence γ² and the standard deviation |H| √((1 − γ²)/(2 n γ²)) of its n averages (Bendat and Piersol 2010, ch. 9), noise being smoothed over neighbouring frequencies. To the
//! points a rational function with a delay is fitted by weighted complex least squares, from a start by Sanathanan's and Koerner's linear equations; its orders
//! are chosen by Schwarz's criterion. Cut-off, peak and poles follow from the function, with 95 % bands by its covariance.

mod answered;
mod bands;
mod curve;
mod doubts;
mod error;
mod orders;
mod points;
mod record;
#[cfg(feature = "files")]
mod record_file;
mod refine;
mod sampling;
mod start;
mod stepped;
#[cfg(test)]
mod tests;
mod transfer;
mod windowed;

use crate::verdict::{Doubt, Verdict};
use bands::Covariance;
pub use bands::{Banded, CurvePoint, Root};
use cdpr_model::reading::keywords;
use curve::Curve;
pub use error::InputError;
use orders::Chosen;
pub use orders::{Alternative, OrderChoice};
pub use points::Point;
use points::{LEAST_SIGMA, Points};
pub use record::Record;
#[cfg(feature = "files")]
pub use record_file::{Columns, RecordReading};
use sampling::Even;
use stepped::Dwells;
pub use transfer::{Orders, Transfer};
use windowed::Windows;

/// Trusted points that a model needs at least.
const FEWEST_POINTS: usize = 8;

/// Fits with the blur of windows taken off, the second one from the first: what is left of the blur is a product of two small numbers.
const SHARPENED: usize = 2;

/// Way to estimate the points of a response.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Averaged windows.
    H1,
    /// Sines fitted to the steps of a stepped sine.
    Sine,
}

keywords!(Method: H1 = "h1", Sine = "sine");

/// How a record is estimated and fitted.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Method; `None` takes [`Method::Sine`] for a stepped sine and [`Method::H1`] for all else.
    pub method: Option<Method>,
    /// Length of a window (s); `None` for an eighth of the record.
    pub window: Option<f64>,
    /// Least coherence of a trusted point, 0 to 1.
    pub coherence: f64,
    /// Numbers of poles and zeros of the model.
    pub orders: OrderChoice,
}

impl Default for Settings {
    fn default() -> Self {
        Self { method: None, window: None, coherence: 0.6, orders: OrderChoice::UpTo(4) }
    }
}

/// Transfer function with its uncertainty.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// The function.
    pub transfer: Transfer,
    /// Its gain at zero frequency, extrapolated below the band.
    pub gain: Banded,
    /// Its delay (s); `None` for a model without one.
    pub delay: Option<Banded>,
    /// Its poles, slowest first.
    pub poles: Vec<Root>,
    /// Its zeros, slowest first.
    pub zeros: Vec<Root>,
    /// Mean square of the residuals in standard deviations; about 1 where the model explains the points.
    pub misfit: f64,
    /// Other orders that the record does not tell from these.
    pub alternatives: Vec<Alternative>,
    /// Its response over the points' frequencies, evenly on a logarithmic scale, for drawings.
    pub curve: Vec<CurvePoint>,
    /// False where the search ended before the optimum.
    pub converged: bool,
}

/// Largest gain of the model in the band.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// Its frequency (Hz); `None` where the gain does not fall to both sides of it within the band.
    pub frequency: Option<Banded>,
    /// The gain (output's unit per input's unit).
    pub gain: Banded,
}

/// Frequency response of a record.
#[derive(Clone, Debug, PartialEq)]
#[must_use = "check `doubts` before using the figures"]
pub struct Solution {
    /// Method of the points.
    pub method: Method,
    /// Response at the frequencies that the input excites, ascending.
    pub points: Vec<Point>,
    /// Windows averaged; 0 for a stepped sine.
    pub windows: usize,
    /// Resolution of frequencies (Hz).
    pub resolution: f64,
    /// Length of the record (s).
    pub duration: f64,
    /// Distance of samples (s).
    pub step: f64,
    /// Largest distance of a row from an even grid (s), where series were interpolated onto it.
    pub jitter: Option<f64>,
    /// Lowest and highest trusted frequency (Hz); `None` without trusted points.
    pub band: Option<[f64; 2]>,
    /// Least coherence of a trusted point.
    pub coherence_limit: f64,
    /// Part of the excited frequencies, on a logarithmic scale, that are trusted.
    pub trusted_share: f64,
    /// Fitted function; `None` where points are too few.
    pub model: Option<Model>,
    /// Gain of the model at the lowest trusted frequency: the reference of cut-off and peak.
    pub reference_gain: Option<Banded>,
    /// First frequency (Hz) of a gain 3 dB below that; `None` outside the band and in an answer that is not to be trusted.
    pub cutoff: Option<Banded>,
    /// Largest gain; `None` as for the cut-off.
    pub peak: Option<Peak>,
    /// Largest difference between the points and the response that the windows blur, relative to the gain, at a trusted point; 0 for a stepped sine.
    pub blur: f64,
    /// Reasons to doubt the answer, the worst first.
    pub doubts: Vec<Doubt>,
    /// Remarks besides.
    pub remarks: Vec<String>,
}

impl Solution {
    /// How far the answer may be relied on.
    pub fn verdict(&self) -> Verdict {
        Verdict::of_fit(&self.doubts)
    }
}

/// Estimates the response of a record and fits a transfer function to it.
pub fn identify(record: &Record, settings: &Settings) -> Result<Solution, InputError> {
    settings.check()?;
    let even = Even::of(record)?;
    let dwells = Dwells::of(&even);
    let is_stepped = dwells.are_a_stepped_sine();
    let method = settings.method.unwrap_or(if is_stepped { Method::Sine } else { Method::H1 });
    let response = match method {
        Method::Sine => {
            let points = dwells.points(&even)?.trusted_from(settings.coherence);
            let fit = fitted(&points, settings, None);
            Estimate { sharp: points.clone(), points, fit, windows: 0 }
        }
        Method::H1 => windowed_estimate(&even, settings)?,
    };
    let mut solution = Solution::of(method, &even, &response, settings);
    if let Some(fit) = &response.fit {
        solution.add_model(fit, &response.sharp);
    }
    solution.judge();
    Ok(solution)
}

/// Points of a method, and a fit to them.
struct Estimate {
    points: Points,
    /// The same without the windows' blur, as they are fitted.
    sharp: Points,
    /// `None` where too few points are trusted.
    fit: Option<Chosen>,
    /// Number of windows; 0 for a stepped sine.
    windows: usize,
}

/// The estimate by windows, their blur taken off.
///
/// A window sees answers to what happened before it, and averages the response over its resolution: near a light resonance that is more than noise leaves, and counts
/// as noise besides. So the fitted function answers the recorded input; what it leaves of the output is estimated as the output was, and added to its response.
fn windowed_estimate(even: &Even, settings: &Settings) -> Result<Estimate, InputError> {
    let windows = Windows::new(even, settings.window)?;
    let input = windows.spectra(&even.input);
    let points = windowed::points(even.step, &windows, &input, &even.output);
    let points = points.trusted_from(settings.coherence);
    let mut estimate =
        Estimate { fit: fitted(&points, settings, None), sharp: points.clone(), points, windows: windows.count };
    for round in 0..SHARPENED {
        let Some(fit) = &estimate.fit else { break };
        let transfer = &fit.fit.transfer;
        let mut sharp = windowed::points(even.step, &windows, &input, &answered::remainder(even, transfer));
        for (sharp, point) in sharp.all.iter_mut().zip(&estimate.points.all) {
            sharp.response += transfer.response(point.frequency);
            sharp.is_trusted = point.is_trusted;
            sharp.sigma = sharp.sigma.max(LEAST_SIGMA * sharp.gain());
        }
        let start = (round > 0).then(|| transfer.clone());
        let Some(fit) = fitted(&sharp, settings, start) else { break };
        estimate = Estimate { sharp, fit: Some(fit), ..estimate };
    }
    Ok(estimate)
}

/// Fit to points, of the orders of a function near by where there is one; `None` where too few points are trusted.
fn fitted(points: &Points, settings: &Settings, near: Option<Transfer>) -> Option<Chosen> {
    let trusted = points.fitted.iter().filter(|&&k| points.all[k].is_trusted).count();
    if trusted < FEWEST_POINTS { None } else { orders::chosen(points, settings.orders, near) }
}

impl Settings {
    fn check(&self) -> Result<(), InputError> {
        let wrong = |what, value, range| Err(InputError::Setting { what, value, range });
        match (self.window, self.orders) {
            (Some(window), _) if !(window > 0.0 && window.is_finite()) => {
                wrong("the length of a window", window, "above 0 s")
            }
            (_, OrderChoice::UpTo(most)) if most > 6 => wrong("the number of poles", most as f64, "at most 6"),
            (_, OrderChoice::Given(orders)) if orders.poles > 6 => {
                wrong("the number of poles", orders.poles as f64, "at most 6")
            }
            (_, OrderChoice::Given(orders)) if orders.zeros > orders.poles => {
                wrong("the number of zeros", orders.zeros as f64, "at most that of poles")
            }
            _ if !(0.0..=1.0).contains(&self.coherence) => wrong("the least coherence", self.coherence, "0 to 1"),
            _ => Ok(()),
        }
    }
}

impl Estimate {
    /// Largest difference that sharpening made at a trusted point, relative to the gain.
    fn blur(&self) -> f64 {
        let pairs = self.points.all.iter().zip(&self.sharp.all).filter(|(point, _)| point.is_trusted);
        pairs.map(|(point, sharp)| (point.response - sharp.response).norm() / sharp.gain()).fold(0.0, f64::max)
    }
}

impl Solution {
    fn of(method: Method, even: &Even, estimate: &Estimate, settings: &Settings) -> Self {
        let points = &estimate.points;
        let trusted: Vec<&Point> = points.all.iter().filter(|point| point.is_trusted).collect();
        let band = trusted.first().zip(trusted.last()).map(|(first, last)| [first.frequency, last.frequency]);
        Self {
            method,
            points: points.all.clone(),
            windows: estimate.windows,
            resolution: points.resolution,
            duration: even.duration(),
            step: even.step,
            jitter: even.jitter,
            band,
            coherence_limit: settings.coherence,
            trusted_share: points.trusted_share(),
            model: None,
            reference_gain: None,
            cutoff: None,
            peak: None,
            blur: estimate.blur(),
            doubts: Vec::new(),
            remarks: Vec::new(),
        }
    }

    /// Adds the model and what follows from it.
    fn add_model(&mut self, chosen: &Chosen, points: &Points) {
        let misfit = chosen.misfit;
        let (fit, Some(band)) = (&chosen.fit, self.band) else { return };
        let Some(covariance) = Covariance::of(fit, points, misfit) else { return };
        let curve = Curve::of(&fit.transfer, band);
        self.reference_gain = Some(covariance.gain_at(band[0]));
        self.cutoff = curve.cutoff.map(|cutoff| covariance.crossing(cutoff, band[0]));
        let frequency = curve.has_peak.then(|| covariance.peak(curve.peak));
        self.peak = Some(Peak { frequency, gain: covariance.gain_at(curve.peak) });
        self.model = Some(Model {
            gain: covariance.gain(),
            delay: covariance.delay(),
            poles: covariance.poles(),
            zeros: covariance.zeros(),
            misfit,
            alternatives: chosen.alternatives.clone(),
            curve: covariance.curve(points.all[0].frequency, points.all[points.all.len() - 1].frequency),
            converged: fit.converged,
            transfer: fit.transfer.clone(),
        });
    }
}

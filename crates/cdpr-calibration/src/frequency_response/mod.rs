//! From a record of input and output to a frequency response, and to a low-order transfer function with its uncertainty.
//!
//! A [`Record`] is plain series (times, input, output), measured or simulated. Its response is estimated
//!
//! * by windows (H1: cross spectrum by the input's spectrum, over Hann's windows that overlap by half), for sweeps, noise and sums of sines, or
//! * by sines fitted to each step of a stepped sine.
//!
//! Each [`Point`] has its coherence γ² and the standard deviation |H| √((1 − γ²)/(2 n γ²)) of its n averages (Bendat and Piersol 2010, ch. 9). To the
//! points a rational function with a delay is fitted by weighted complex least squares, from a start by Sanathanan's and Koerner's linear equations; its orders
//! are chosen by Schwarz's criterion. Cut-off, peak and poles follow from the function, with 95 % bands by its covariance.

mod bands;
mod blur;
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

use nalgebra::Complex;

use crate::verdict::{Doubt, Verdict};
use bands::Covariance;
pub use bands::{Banded, Root};
use cdpr_model::reading::keywords;
use curve::Curve;
pub use error::InputError;
use orders::Chosen;
pub use orders::{Alternative, OrderChoice};
pub use points::Point;
use points::Points;
pub use record::Record;
#[cfg(feature = "files")]
pub use record_file::{Columns, RecordReading};
use sampling::Even;
use stepped::Dwells;
pub use transfer::{Orders, Transfer};
use windowed::Windows;

/// Trusted points that a model needs at least.
const FEWEST_POINTS: usize = 8;

/// Fits with the windows' blur taken off; the second one changes the blur by its square.
const ROUNDS: usize = 3;

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
    /// Its delay (s); `None` where none is told.
    pub delay: Option<Banded>,
    /// Its poles, slowest first.
    pub poles: Vec<Root>,
    /// Its zeros, slowest first.
    pub zeros: Vec<Root>,
    /// Mean square of the residuals in standard deviations; about 1 where the model explains the points.
    pub misfit: f64,
    /// Other orders that the record does not tell from these.
    pub alternatives: Vec<Alternative>,
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
    /// Distance of frequencies that are told apart (Hz).
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
    /// Gain of the model at the lowest trusted frequency, which cut-off and peak are told against.
    pub reference_gain: Option<Banded>,
    /// First frequency (Hz) of a gain 3 dB below that; `None` outside the band and in an answer that is not to be trusted.
    pub cutoff: Option<Banded>,
    /// Largest gain; `None` as for the cut-off.
    pub peak: Option<Peak>,
    /// Largest difference between the points and the response that the windows blur, relative to the gain, at a trusted point; 0 for a stepped sine.
    pub blur: f64,
    /// Reasons to doubt the answer, the worst first.
    pub doubts: Vec<Doubt>,
    /// What else a reader has to know.
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
    let (points, fit, blur, windows) = match method {
        Method::Sine => {
            let points = dwells.points(&even, settings)?;
            let fit = fitted(&points, &points.all, settings);
            (points, fit, 0.0, 0)
        }
        Method::H1 => windowed_fit(&even, settings)?,
    };
    let mut solution = Solution::of_points(method, &even, &points, settings);
    (solution.windows, solution.blur) = (windows, blur);
    if let Some((chosen, misfit)) = fit {
        solution.add_model(&chosen, &points, misfit);
    }
    solution.judge();
    Ok(solution)
}

/// Chosen orders with their fit, and its misfit.
type Fitted = Option<(Chosen, f64)>;

/// Points by windows; a fit to them with the windows' blur taken off; the largest blur, and the number of windows.
fn windowed_fit(even: &Even, settings: &Settings) -> Result<(Points, Fitted, f64, usize), InputError> {
    let windows = Windows::new(even, settings)?;
    let input = windows.spectra(&even.input);
    let points = windowed::points(even, &windows, &input, settings);
    let mut sharp = points.all.clone();
    let mut fit = fitted(&points, &sharp, settings);
    let mut largest = 0.0;
    for _ in 1..ROUNDS {
        let Some((chosen, _)) = &fit else { break };
        let blur = blur::blur(even, &windows, &input, &points.all, &chosen.fit.transfer);
        let relative = |(point, blur): (&Point, &Complex<f64>)| if point.is_trusted { blur.norm() / point.gain() } else { 0.0 };
        largest = points.all.iter().zip(&blur).map(relative).fold(0.0, f64::max);
        if !(largest < 1.0) {
            break;
        }
        for (sharp, (point, blur)) in sharp.iter_mut().zip(points.all.iter().zip(&blur)) {
            sharp.response = point.response - blur;
        }
        fit = fitted(&points, &sharp, settings);
    }
    Ok((points, fit, largest, windows.count))
}

/// Fit to points that may have been sharpened; `None` where too few are trusted.
fn fitted(points: &Points, sharp: &[Point], settings: &Settings) -> Fitted {
    let used: Vec<Point> = points.fitted.iter().map(|&k| sharp[k]).collect();
    if used.iter().filter(|point| point.is_trusted).count() < FEWEST_POINTS {
        return None;
    }
    let chosen = orders::chosen(&used, settings.orders, points.dependence())?;
    let freedom = 2.0 * used.len() as f64 - chosen.fit.equations.gradient.len() as f64;
    let misfit = chosen.fit.cost / freedom.max(1.0);
    Some((chosen, misfit))
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

impl Solution {
    fn of_points(method: Method, even: &Even, points: &Points, settings: &Settings) -> Self {
        let trusted: Vec<&Point> = points.all.iter().filter(|point| point.is_trusted).collect();
        let band = trusted.first().zip(trusted.last()).map(|(first, last)| [first.frequency, last.frequency]);
        Self {
            method,
            points: points.all.clone(),
            windows: 0,
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
            blur: 0.0,
            doubts: Vec::new(),
            remarks: Vec::new(),
        }
    }

    /// Adds the model and what follows from it.
    fn add_model(&mut self, chosen: &Chosen, points: &Points, misfit: f64) {
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
            converged: fit.converged,
            transfer: fit.transfer.clone(),
        });
    }
}

//! Choice of the numbers of poles and zeros by Schwarz's criterion (BIC; Schwarz 1978).

use nalgebra::Complex;
use std::f64::consts::{PI, TAU};

use super::points::{Point, Points};
use super::refine::{Refined, refined};
use super::start::start;
use super::transfer::{Orders, Transfer};

/// Delays from which fits start, as parts of the longest that the phase allows.
const STARTS: [f64; 4] = [0.0, 0.3, 0.6, 0.9];

/// Points by which orders are chosen, at most.
const MOST_POINTS: usize = 300;

/// Advantage below which the criterion does not tell two choices apart.
const UNDECIDED: f64 = 2.0;

/// Choices of orders to try.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OrderChoice {
    /// Those that Schwarz's criterion prefers, with so many poles at most.
    UpTo(usize),
    /// These alone.
    Given(Orders),
}

/// Other orders that the record does not tell from the chosen ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Alternative {
    /// Numbers of poles and zeros.
    pub orders: Orders,
    /// Their criterion less that of the chosen ones.
    pub difference: f64,
}

/// Chosen orders with their fit.
pub(super) struct Chosen {
    pub(super) fit: Refined,
    /// Mean square of its residuals in standard deviations.
    pub(super) misfit: f64,
    /// Others within [`UNDECIDED`].
    pub(super) alternatives: Vec<Alternative>,
}

/// Fits all orders to points and keeps the best; only the orders of a function near by where there is one. `None`
/// where no fit succeeds.
pub(super) fn chosen(points: &Points, choice: OrderChoice, near: Option<Transfer>) -> Option<Chosen> {
    let dependence = points.dependence();
    let resolution = points.resolution;
    let points: Vec<Point> = points.fitted.iter().map(|&k| points.all[k]).collect();
    let points = points.as_slice();
    let unit = TAU * (points.first()?.frequency * points.last()?.frequency).sqrt();
    let most = match (choice, near) {
        (_, Some(near)) => return Some(Chosen::of(refined(points, near)?, points, Vec::new())),
        (OrderChoice::Given(orders), None) => return Some(Chosen::of(best(points, orders, unit)?, points, Vec::new())),
        (OrderChoice::UpTo(most), None) => most,
    };
    let thinned: Vec<Point> = points.iter().step_by(points.len().div_ceil(MOST_POINTS)).copied().collect();
    let count = thinned.len();
    let mut fits: Vec<(Orders, Refined)> =
        all_orders(most).filter_map(|orders| Some((orders, best(&thinned, orders, unit)?))).collect();
    fits.retain(|(_, fit)| !has_hidden_pair(&fit.transfer, resolution));
    if fits.iter().any(|(_, fit)| fit.converged) {
        fits.retain(|(_, fit)| fit.converged);
    }
    // what no order explains counts as noise
    let noise = fits.iter().map(|(_, fit)| fit.mean_square(count)).fold(f64::INFINITY, f64::min).max(1.0);
    let mut ranked: Vec<(f64, Orders)> =
        fits.iter().map(|(orders, fit)| (criterion(fit, count, dependence, noise), *orders)).collect();
    ranked.sort_by(|a, b| a.0.total_cmp(&b.0));
    let least = ranked.first()?.0;
    let size = |orders: &Orders| orders.poles + orders.zeros + usize::from(orders.has_delay);
    let near = ranked.iter().filter(|(value, _)| *value < least + UNDECIDED);
    let &(value, orders) = near.min_by_key(|(_, orders)| (size(orders), usize::from(orders.has_delay)))?;
    let (_, coarse) = fits.into_iter().find(|(other, _)| *other == orders)?;
    let fit = if count == points.len() { coarse } else { refined(points, coarse.transfer)? };
    let others = ranked.iter().filter(|(other, own)| *own != orders && *other < value + UNDECIDED);
    let alternatives = others.map(|&(other, orders)| Alternative { orders, difference: other - value }).collect();
    Some(Chosen::of(fit, points, alternatives))
}

impl Chosen {
    fn of(fit: Refined, points: &[Point], alternatives: Vec<Alternative>) -> Self {
        Self { misfit: fit.mean_square(points.len()), fit, alternatives }
    }
}

fn criterion(fit: &Refined, points: usize, dependence: f64, noise: f64) -> f64 {
    let rows = 2.0 * points as f64 / dependence;
    fit.cost / (dependence * noise) + fit.equations.gradient.len() as f64 * rows.ln()
}

/// True of a function with a pole so near the imaginary axis and a zero that no point shows them: both within the resolution (Hz).
fn has_hidden_pair(transfer: &Transfer, resolution: f64) -> bool {
    let (zeros, width) = (transfer.zeros(), TAU * resolution);
    let is_hidden = |pole: Complex<f64>| zeros.iter().any(|zero| (pole - zero).norm() < width);
    transfer.poles().into_iter().any(|pole| pole.im > 0.0 && 2.0 * pole.re.abs() < width && is_hidden(pole))
}

fn all_orders(most: usize) -> impl Iterator<Item = Orders> {
    (0..=most).flat_map(|poles| {
        (0..=poles).flat_map(move |zeros| [false, true].map(|has_delay| Orders { poles, zeros, has_delay }))
    })
}

/// The best fit of these orders, from several delays.
fn best(points: &[Point], orders: Orders, unit: f64) -> Option<Refined> {
    if 2 * points.len() <= 1 + orders.poles + orders.zeros + usize::from(orders.has_delay) {
        return None;
    }
    let longest = longest_delay(points);
    let starts = if orders.has_delay && longest > 0.0 { &STARTS[..] } else { &STARTS[..1] };
    let fits = starts.iter().filter_map(|part| refined(points, start(points, orders, part * longest, unit)?));
    fits.min_by(|a, b| b.converged.cmp(&a.converged).then(a.cost.total_cmp(&b.cost)))
}

/// Delay that the phase of the trusted points has, if all of it is delay (s).
fn longest_delay(points: &[Point]) -> f64 {
    let (mut turned, mut before, mut delay) = (0.0, None, 0.0);
    for point in points.iter().filter(|point| point.is_trusted) {
        let phase = point.phase();
        let step = phase - before.unwrap_or(phase);
        turned += if before.is_none() { phase } else { step - TAU * ((step + PI) / TAU).floor() };
        before = Some(phase);
        delay = -turned / (TAU * point.frequency);
    }
    delay.max(0.0)
}

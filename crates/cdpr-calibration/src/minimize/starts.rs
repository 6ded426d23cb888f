//! Search from several starts, and the optima that they lead to.

mod drawing;
#[cfg(test)]
mod tests;

use crate::progress::{Progress, Stopped, report};

use crate::fit::Settings;
use drawing::Drawing;
pub(crate) use drawing::Part;

/// Ends of descents that differ by less than this share of their cost, or of one per sample, have the same cost.
const SAME_COST: f64 = 1e-6;
/// Ends that are this near to each other are the same optimum (m).
const SAME_PLACE: f64 = 1e-4;
/// The 95 % quantile of χ² with one degree of freedom: what costs may differ by noise alone.
const WITHIN_NOISE: f64 = 3.841_459;

/// Optima of least squares that the starts of a fit led to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Starts {
    /// Starts: the file's values and points of a scrambled Sobol sequence.
    pub count: usize,
    /// Starts whose descent did not converge, or that had no residuals.
    pub unconverged: usize,
    /// How far the other starts are from the file's values, kind by kind.
    pub ranges: Vec<String>,
    /// Optima, best first.
    pub optima: Vec<StartOptimum>,
}

/// An optimum that some of the starts led to.
#[derive(Clone, Debug, PartialEq)]
pub struct StartOptimum {
    /// Weighted sum of squared residuals and priors.
    pub cost: f64,
    /// Starts that ended here; 0 for one that joins the best ends of cables that were identified apart.
    pub starts: usize,
    /// The same as a fraction of all starts.
    pub fraction: f64,
    /// Largest difference of a parameter between two starts that ended here (m; others than lengths by their effect on cable lengths).
    pub spread_m: f64,
    /// Largest difference of a parameter from the best optimum (m).
    pub distance_m: f64,
}

/// End of a descent.
pub(crate) trait Ending {
    fn cost(&self) -> f64;

    fn converged(&self) -> bool;

    /// Parameters where it ended, counted from an origin that all ends share.
    fn place(&self) -> &[f64];
}

/// Costs of all parts.
pub(crate) trait Landscape {
    type End: Ending + Clone;

    /// Descends from this change of the file's values.
    fn descend(&mut self, part: usize, change: &[f64]) -> Self::End;

    /// Cost at a place that lies between two ends, of which this is one.
    fn cost(&mut self, part: usize, place: &[f64], near: &Self::End) -> f64;
}

/// Descents from many starts.
pub(crate) struct Search<'a> {
    pub(crate) parts: &'a [Part],
    pub(crate) settings: &'a Settings,
    pub(crate) samples: usize,
    /// Mean recorded tension, 0 without (N).
    pub(crate) tension: f64,
}

/// An optimum with the end of the first start that led there.
struct Found<E> {
    ends: Vec<E>,
    told: StartOptimum,
}

impl Search<'_> {
    /// Descends from other starts too; each part of `best`, the ends of the file's values, becomes its lowest end. `progress` is called after
    /// each start and may stop the search.
    pub(crate) fn run<L: Landscape>(
        &self,
        landscape: &mut L,
        best: &mut [L::End],
        progress: &Progress<'_>,
    ) -> Result<Starts, Stopped> {
        report(progress)?;
        let mut told = Starts::of_file(best);
        if self.settings.starts <= 1 {
            return Ok(told);
        }
        let mut found: Vec<_> = told.optima.drain(..).map(|told| Found { ends: best.to_vec(), told }).collect();
        let drawing = Drawing::new(self.settings, self.tension);
        for start in 1..self.settings.starts {
            let mut dimension = 0;
            let mut descend = |(index, part): (usize, &Part)| {
                let change = drawing.change(start, part, dimension);
                dimension += part.parameters.len();
                landscape.descend(index, &change)
            };
            let ends: Vec<L::End> = self.parts.iter().enumerate().map(&mut descend).collect();
            report(progress)?;
            for (best, end) in best.iter_mut().zip(&ends) {
                let is_better = end.cost() < best.cost() - same_cost(end.cost(), self.samples);
                if is_better || (end.cost().is_finite() && !best.cost().is_finite()) {
                    *best = end.clone();
                }
            }
            self.count(landscape, (&mut told, &mut found), ends);
        }
        told.ranges = drawing.words(self.parts);
        self.add_joined(landscape, &mut found, best);
        found.sort_by(|a, b| a.told.cost.total_cmp(&b.told.cost));
        // among ends of the same cost, as mirror images are, the one that is taken stands first
        let is_taken = |one: &Found<L::End>| self.distance(&one.ends, best) <= SAME_PLACE;
        if let Some(place) = found.iter().position(is_taken) {
            let (own, least) = (found[place].told.cost, found[0].told.cost);
            if own - least <= same_cost(least, self.samples) {
                found[..=place].rotate_right(1);
            }
        }
        let distance = |found: &Found<L::End>| self.distance(&found.ends, best);
        let tell = |found: &Found<L::End>| StartOptimum { distance_m: distance(found), ..found.told.clone() };
        told.optima = found.iter().map(tell).collect();
        let count = told.count as f64;
        told.optima.iter_mut().for_each(|optimum| optimum.fraction = optimum.starts as f64 / count);
        Ok(told)
    }

    /// Counts the ends of a start among the optima found before.
    fn count<L: Landscape>(
        &self,
        landscape: &mut L,
        (told, found): (&mut Starts, &mut Vec<Found<L::End>>),
        ends: Vec<L::End>,
    ) {
        told.count += 1;
        if !is_optimum(&ends) {
            told.unconverged += 1;
            return;
        }
        match found.iter().position(|known| self.is_same(landscape, &known.ends, &ends)) {
            Some(place) => {
                let spread_m = self.distance(&found[place].ends, &ends);
                let known = &mut found[place].told;
                known.starts += 1;
                known.spread_m = known.spread_m.max(spread_m);
            }
            None => found.push(Found { told: StartOptimum::new(&ends, 1), ends }),
        }
    }

    /// The best ends of all parts together may be an optimum that no start led all parts to.
    fn add_joined<L: Landscape>(&self, landscape: &mut L, found: &mut Vec<Found<L::End>>, best: &[L::End]) {
        let is_new = !found.iter().any(|known| self.is_same(landscape, &known.ends, best));
        if is_new && is_optimum(best) {
            found.push(Found { told: StartOptimum::new(best, 0), ends: best.to_vec() });
        }
    }

    /// True for ends of the same cost that are near each other, or that have this cost half-way between them: a direction that the data leave
    /// open.
    fn is_same<L: Landscape>(&self, landscape: &mut L, known: &[L::End], ends: &[L::End]) -> bool {
        let (first, second) = (cost(known), cost(ends));
        let same = same_cost(first, self.samples);
        if (first - second).abs() > same {
            return false;
        }
        let mut middle = |part: usize| {
            let pairs = known[part].place().iter().zip(ends[part].place());
            landscape.cost(part, &pairs.map(|(a, b)| 0.5 * (a + b)).collect::<Vec<_>>(), &known[part])
        };
        self.distance(known, ends) <= SAME_PLACE || (0..ends.len()).map(&mut middle).sum::<f64>() <= first + same
    }

    /// Largest difference of a parameter (m).
    fn distance<E: Ending>(&self, first: &[E], second: &[E]) -> f64 {
        let ends = first.iter().zip(second).zip(self.parts);
        let of_part = |((a, b), part): ((&E, &E), &Part)| {
            let pairs = a.place().iter().zip(b.place()).zip(&part.scale);
            pairs.map(|((a, b), scale)| ((a - b) * scale).abs()).fold(0.0, f64::max)
        };
        ends.map(of_part).fold(0.0, f64::max)
    }
}

impl StartOptimum {
    fn new<E: Ending>(ends: &[E], starts: usize) -> Self {
        Self { cost: cost(ends), starts, fraction: starts as f64, spread_m: 0.0, distance_m: 0.0 }
    }
}

/// True where all parts converged.
fn is_optimum<E: Ending>(ends: &[E]) -> bool {
    cost(ends).is_finite() && ends.iter().all(Ending::converged)
}

fn cost<E: Ending>(ends: &[E]) -> f64 {
    ends.iter().map(Ending::cost).sum()
}

/// Difference of costs that is none, for an end of a fit to so many samples.
fn same_cost(cost: f64, samples: usize) -> f64 {
    SAME_COST * (cost + samples as f64)
}

impl Starts {
    /// The only start: the file's values.
    pub(crate) fn of_file<E: Ending>(ends: &[E]) -> Self {
        // as much memory for a descent that fails
        let mut optima = Vec::with_capacity(1);
        optima.extend(is_optimum(ends).then(|| StartOptimum::new(ends, 1)));
        Self { count: 1, unconverged: 1 - optima.len(), ranges: Vec::new(), optima }
    }

    /// Reasons to doubt that the best optimum is the right one, for residuals with this noise in units of the accuracies.
    pub(crate) fn doubts(&self, noise: f64) -> Vec<String> {
        let [best, others @ ..] = &self.optima[..] else { return Vec::new() };
        let count = self.count;
        let most = others.iter().max_by_key(|optimum| optimum.starts).filter(|other| other.starts > best.starts);
        let rare = most.map(|most| {
            format!(
                "the optimum with the lowest cost ({:.5e}) was reached by {} of {count} starts, one with {:.5e} by {}: more starts may find a \
                 better one",
                best.cost, best.starts, most.cost, most.starts
            )
        });
        let noise = if noise.is_finite() { noise } else { 1.0 };
        let is_as_good = |other: &&StartOptimum| other.cost - best.cost <= WITHIN_NOISE * noise * noise;
        let close: Vec<&StartOptimum> = others.iter().filter(is_as_good).collect();
        let farthest = close.iter().map(|other| other.distance_m).fold(0.0, f64::max);
        let close = (!close.is_empty()).then(|| {
            let (subject, verb) = if close.len() == 1 { ("another optimum", "fits") } else { ("other optima", "fit") };
            format!(
                "{subject}, parameters up to {farthest:.3} m from this one, {verb} the data as well within their noise (cost {:.5e} beside \
                 {:.5e}): these data do not tell which is right",
                close[0].cost, best.cost
            )
        });
        rare.into_iter().chain(close).collect()
    }
}

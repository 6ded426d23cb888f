//! The optimum of residuals: from several starts, block by block, with weights that agree with it, under any cost.

mod bends;
pub(crate) mod certificate;
pub(crate) mod cost;
pub(crate) mod dense;
pub(crate) mod descent;
pub(crate) mod minimax;
mod robust;
pub(crate) mod starts;
pub(crate) mod trail;
pub(crate) mod unknowns;

use std::ops::Range;

use crate::fit::InputError;
use crate::misfit::Misfit;
use crate::norms::Norms;
use crate::objective::Minimize;
use crate::progress::Progress;
use crate::residual::rows::Rows;
use crate::residual::{Latent, Residual};
use crate::stopping::{StoppedBy, StoppingRule};
use certificate::Certificate;
use cost::{Cost, descend_in};
use dense::DenseEquations;
use descent::{End, System};
use starts::{Ending, Landscape, Part, Starts};
use trail::Trail;
use unknowns::{Pace, Shape, Unknowns};

/// Times that norms are smoothed less: the last sum of norms is the least to a billionth.
const SMOOTHINGS: u32 = 9;
/// Most repetitions with the noise that residuals tell; near the end each doubles the digits.
const RESCALINGS: u32 = 30;

/// The optimum of residuals, which are left with the weights that belong to it.
#[derive(Clone, Debug)]
pub(crate) struct Optimum {
    pub(crate) end: End,
    /// Optima that the starts led to.
    pub(crate) starts: Starts,
    /// Norms of the samples' rows, with the loss.
    pub(crate) norms: Norms,
    pub(crate) certificate: Option<Certificate>,
}

/// Finds the optimum from the start values, with a first descent `from` others where these are known to lead there; `progress` is called after
/// each start.
pub(crate) fn minimize(
    residual: &mut dyn Residual,
    unknowns: &Unknowns<'_>,
    from: Option<&[f64]>,
    progress: &Progress<'_>,
) -> Result<Optimum, InputError> {
    let blocks = residual.blocks(unknowns.len());
    let mut search =
        Search { own: blocks.iter().map(|block| unknowns.within(block.clone())).collect(), blocks, residual };
    let (end, starts) = search.run(unknowns, from.unwrap_or(&unknowns.start), progress)?;
    let Search { residual, .. } = search;
    let found = Optimum { end, starts, norms: Norms::default(), certificate: None };
    let mut found = match unknowns.settings.minimize {
        Minimize::Squares => squares(residual, unknowns, found)?,
        Minimize::Mean => found,
        Minimize::Max => largest(residual, unknowns, found)?,
    };
    unknowns.take_to_bounds(&mut found.end.values);
    Ok(found)
}

/// Misfit where a descent ended, in units of the weights.
pub(crate) fn misfit(residual: &dyn Residual, unknowns: &Unknowns<'_>, end: &End) -> Misfit {
    let rows = residual.informative_rows() + unknowns.ridges().count();
    let freedom = rows.saturating_sub(unknowns.len());
    Misfit { cost: end.cost, prior_cost: unknowns.prior_cost(&end.values), freedom }
}

/// Weights that agree with the optimum, with the noise that priors ask for, and with a robust loss.
fn squares(residual: &mut dyn Residual, unknowns: &Unknowns<'_>, mut found: Optimum) -> Result<Optimum, InputError> {
    if unknowns.len() > 0 && residual.weighing().is_some() {
        let is_absolute = residual.is_absolute();
        if let Some(weighing) = residual.weighing() {
            weighing.settle(&mut found.end, unknowns)?;
        }
        // without priors the scale of the noise moves no parameter
        if !is_absolute && unknowns.has_priors() {
            agree_with_noise(residual, unknowns, &mut found.end)?;
        }
    }
    (found.end, found.norms) = robust::under_loss(residual, unknowns, found.end)?;
    Ok(found)
}

/// A prior needs the scale of the noise, which the residuals tell: weighs by it and repeats.
fn agree_with_noise(residual: &mut dyn Residual, unknowns: &Unknowns<'_>, end: &mut End) -> Result<(), InputError> {
    for _ in 0..RESCALINGS {
        let noise = misfit(residual, unknowns, end).noise();
        let Some(weighing) = residual.weighing() else { break };
        if weighing.same_noise().is_none_or(|same| (noise - 1.0).abs() < same) {
            break;
        }
        weighing.scale_noise(noise);
        weighing.settle_again(end, unknowns)?;
    }
    Ok(())
}

/// The least largest norm, from an optimum of least squares.
fn largest(residual: &mut dyn Residual, unknowns: &Unknowns<'_>, found: Optimum) -> Result<Optimum, InputError> {
    let squares = found.end;
    // Newton steps of all centres
    let limit = 10 * unknowns.settings.max_iterations;
    let least = minimax::minimise(residual, unknowns.parameters, &unknowns.scale, &squares.values, limit);
    let least = least.ok_or(InputError::NotFinite)?;
    let stopped = match least.converged {
        true => StoppedBy { rule: StoppingRule::Gap, value: least.certificate.gap, limit: minimax::GAP },
        false => StoppedBy {
            rule: StoppingRule::IterationLimit,
            value: f64::from(least.iterations),
            limit: f64::from(limit),
        },
    };
    let end = End {
        cost: least.certificate.largest,
        values: least.values,
        iterations: squares.iterations + least.iterations,
        trail: squares.trail.then(Trail { costs: least.history, ..Trail::default() }),
        stopped,
    };
    Ok(Optimum { end, certificate: Some(least.certificate), ..found })
}

/// Σ ‖r‖ at these values; not a number where there are no rows.
fn sum_of_norms(residual: &mut dyn Residual, values: &[f64]) -> f64 {
    let mut rows = Rows::new(residual.layout(), values.len());
    match residual.write(values, &mut rows) {
        true => rows.squares().into_iter().map(f64::sqrt).sum(),
        false => f64::NAN,
    }
}

/// End of a descent, with what was eliminated from the samples' rows there.
#[derive(Clone)]
struct Settled {
    end: End,
    latents: Vec<Latent>,
}

impl Ending for Settled {
    fn cost(&self) -> f64 {
        self.end.cost
    }

    fn converged(&self) -> bool {
        self.end.converged()
    }

    fn place(&self) -> &[f64] {
        &self.end.values
    }
}

/// Blocks of parameters, each with a cost of its own.
struct Search<'a, 'u> {
    residual: &'a mut dyn Residual,
    blocks: Vec<Range<usize>>,
    /// Unknowns of each block.
    own: Vec<Unknowns<'u>>,
}

impl Landscape for Search<'_, '_> {
    type End = Settled;

    fn descend(&mut self, part: usize, change: &[f64]) -> Settled {
        let from: Vec<f64> = self.own[part].start.iter().zip(change).map(|(start, change)| start + change).collect();
        let patience = self.residual.patience();
        self.settle(part, &from, patience)
    }

    fn cost(&mut self, part: usize, place: &[f64], near: &Settled) -> f64 {
        self.residual.go_on_from(&near.latents);
        let own = &self.own[part];
        if own.settings.minimize == Minimize::Mean {
            return sum_of_norms(self.residual, place);
        }
        let mut equations = DenseEquations::new(place.len());
        let mut cost = Cost { residual: self.residual, block: part, unknowns: own, shape: Shape::Square, rows: None };
        if cost.write(place, &mut equations) { equations.cost } else { f64::NAN }
    }
}

impl Search<'_, '_> {
    /// Descends from the file's values and from other starts; each block takes its lowest end. The largest norm starts from least squares.
    fn run(
        &mut self,
        unknowns: &Unknowns<'_>,
        from: &[f64],
        progress: &Progress<'_>,
    ) -> Result<(End, Starts), InputError> {
        let of_block = |own: &Unknowns<'_>| Part {
            parameters: own.parameters.to_vec(),
            start: own.start.to_vec(),
            scale: own.scale.to_vec(),
        };
        // the file's values alone ask for no drawing of others
        let drawn = if unknowns.settings.starts > 1 { &self.own[..] } else { &[] };
        let parts: Vec<Part> = drawn.iter().map(of_block).collect();
        let count = self.blocks.len();
        let mut best: Vec<Settled> =
            (0..count).map(|part| self.settle(part, &from[self.blocks[part].clone()], None)).collect();
        if !best.iter().all(|end| end.cost().is_finite()) {
            return Err(InputError::NotFinite);
        }
        let samples = self.residual.layout().samples;
        let tension = unknowns.mean_tension;
        let search = starts::Search { parts: &parts, settings: unknowns.settings, samples, tension };
        let starts = search.run(self, &mut best, progress)?;
        if let [only] = &best[..] {
            // the answer is told where it was found, whatever other starts led to
            self.residual.go_on_from(&only.latents);
        }
        Ok((End::joined(best.into_iter().map(|settled| settled.end).collect()), starts))
    }

    fn settle(&mut self, part: usize, from: &[f64], patience: Option<u32>) -> Settled {
        let end = self.descend_from(part, from, patience);
        Settled { end, latents: self.residual.latents() }
    }

    fn descend_from(&mut self, part: usize, from: &[f64], patience: Option<u32>) -> End {
        let Self { residual, own, .. } = self;
        let own = &own[part];
        let least_gain = residual.least_gain(own.settings.starts);
        let pace = Pace { shape: Shape::Square, least_gain, patience };
        let squares = descend_in(*residual, part, own, from, &pace);
        match own.settings.minimize {
            Minimize::Mean => follow_norms(*residual, part, own, squares),
            _ => squares,
        }
    }
}

/// The least sum of norms, from an optimum of least squares by ever less smoothing.
fn follow_norms(residual: &mut dyn Residual, block: usize, own: &Unknowns<'_>, squares: End) -> End {
    let start = sum_of_norms(residual, &squares.values);
    let mut smoothing = start / residual.layout().samples as f64;
    let mut end = End { cost: start, ..squares };
    end.trail.costs = vec![start];
    for _ in 0..SMOOTHINGS {
        if !end.converged() || !(smoothing > 0.0) {
            break;
        }
        smoothing *= 0.1;
        let least_gain = residual.least_gain(1);
        let pace = Pace { shape: Shape::Norm(smoothing), least_gain, patience: None };
        let next = descend_in(residual, block, own, &end.values, &pace);
        let cost = sum_of_norms(residual, &next.values);
        let trail = end.trail.joined(Trail { costs: vec![cost], ..next.trail });
        end = End { cost, iterations: end.iterations + next.iterations, trail, ..next };
    }
    end
}

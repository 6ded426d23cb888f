//! Standard deviations of parameters by a bootstrap of blocks of consecutive samples, beside the linear ones.

#[cfg(test)]
mod coverage;
#[cfg(test)]
mod tests;

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

use super::autocorrelation::correlation_time;
use super::bootstrap::block_length;
use super::evaluation::evaluate_fitted;
use super::fit::{Course, Fit, InputError, Settings};
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::scalar::map_all;

/// Ratio of two deviations beyond which they contradict each other.
const DIFFERENT: f64 = 1.5;

/// Number of blocks below which the linear deviations are advised: with 8 blocks of autoregressive noise intervals by the bootstrap held 84 to 91 %, linear
/// ones 91 to 92 %; with 30 blocks 94 and 96 %.
const LEAST_BLOCKS: usize = 20;

/// Parameters that a warning names before it only counts the rest.
const NAMED: usize = 4;

/// Parameters of data drawn anew, block by block.
#[derive(Clone, Debug, PartialEq)]
pub struct Resampled {
    /// Replicates whose fit converged.
    pub replicates: usize,
    /// Replicates without a fit.
    pub failed: usize,
    /// Consecutive samples in a block.
    pub block_length: usize,
    /// Every free parameter.
    pub parameters: Vec<ResampledDeviation>,
    /// Doubt in words: both deviations of some parameters differ by more than a factor 1.5; and which of them to take.
    pub warning: Option<String>,
}

/// Standard deviations of one parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct ResampledDeviation {
    /// Name.
    pub parameter: String,
    /// Unit.
    pub unit: &'static str,
    /// By the Jacobian at the optimum; `None` where the data do not determine it.
    pub linear: Option<f64>,
    /// Of the replicates.
    pub bootstrap: f64,
    /// Mean of the replicates minus the optimum.
    pub bias: f64,
    /// Bootstrap through linear.
    pub ratio: Option<f64>,
}

/// Fits so many data sets of blocks drawn with replacement (circular block bootstrap, Politis and Romano 1992).
///
/// The block length is that of the length residuals' own correlation, the largest over the cables. A prior is drawn anew too, around its
/// centre: it is a measurement of its parameter. The same seed gives the same numbers on any number of threads.
pub fn resampled(
    given: &Model,
    samples: &Samples,
    fit: &Fit,
    settings: &Settings,
    replicates: usize,
    seed: u64,
) -> Result<Resampled, InputError> {
    let samples = fit.as_fitted(samples).subset(&fit.trusted_samples(samples.len()));
    let course = Course::new(given, samples, fit, settings)?;
    let block = block_of(&fit.model, &course.samples);
    let draw = |replicate: usize| {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(replicate as u64);
        one(&course, fit, block, &mut random)
    };
    let found: Vec<Vec<f64>> = map_all(replicates, draw).into_iter().flatten().collect();
    let parameters: Vec<ResampledDeviation> =
        (0..fit.parameters.len()).map(|place| deviation(fit, &found, place)).collect();
    let warning = warning(&parameters, &Blocks { rows: course.samples.len(), length: block });
    Ok(Resampled {
        replicates: found.len(),
        failed: replicates - found.len(),
        block_length: block,
        parameters,
        warning,
    })
}

fn block_of(model: &Model, samples: &Samples) -> usize {
    let Ok(errors) = evaluate_fitted(model, samples) else { return 1 };
    let cables = samples.cable_count;
    let series = |cable: usize| errors.length.iter().skip(cable).step_by(cables).copied().collect::<Vec<f64>>();
    let finite = (0..cables).map(series).filter(|series| series.iter().all(|value| value.is_finite()));
    // chance correlates independent residuals a little
    let length = |series: Vec<f64>| if correlation_time(&series) > 1.0 { block_length(&series) } else { 1 };
    finite.map(length).max().unwrap_or(1)
}

/// Changes of the parameters from their optimum on one replicate; `None` where its fit fails.
fn one(course: &Course<'_>, fit: &Fit, block: usize, random: &mut ChaCha8Rng) -> Option<Vec<f64>> {
    let count = course.samples.len();
    let mut drawn = Vec::with_capacity(count + block);
    while drawn.len() < count {
        let start = random.random_range(0..count);
        drawn.extend((start..start + block).map(|sample| sample % count));
    }
    drawn.truncate(count);
    let mut robot = course.base.robot().clone();
    for estimate in &fit.parameters {
        let Some(sigma) = estimate.prior_sigma else { continue };
        let amount: f64 = StandardNormal.sample(random);
        let (low, high) = estimate.parameter.bounds();
        estimate.parameter.set(&mut robot, (estimate.start + sigma * amount).clamp(low, high));
    }
    let base = Model::new(robot, course.base.composition()).ok()?;
    let model = course.again(&base, &course.samples.subset(&drawn))?;
    let change = |place: usize| course.parameters[place].value(model.robot()) - fit.parameters[place].value;
    Some((0..fit.parameters.len()).map(change).collect())
}

fn deviation(fit: &Fit, found: &[Vec<f64>], place: usize) -> ResampledDeviation {
    let estimate = &fit.parameters[place];
    let count = found.len() as f64;
    let bias = found.iter().map(|changes| changes[place]).sum::<f64>() / count;
    let squares: f64 = found.iter().map(|changes| (changes[place] - bias).powi(2)).sum();
    let bootstrap = (squares / (count - 1.0)).sqrt();
    let ratio = estimate.sigma.filter(|sigma| *sigma > 0.0).map(|sigma| bootstrap / sigma);
    ResampledDeviation {
        parameter: estimate.name.clone(),
        unit: estimate.unit,
        linear: estimate.sigma,
        bootstrap,
        bias,
        ratio: ratio.filter(|ratio| ratio.is_finite()),
    }
}

/// Blocks that data sets are drawn from.
struct Blocks {
    /// Samples.
    rows: usize,
    /// Consecutive samples in a block.
    length: usize,
}

impl Blocks {
    fn count(&self) -> usize {
        self.rows / self.length.max(1)
    }

    /// `8 blocks of 36 rows`, or rows alone.
    fn words(&self) -> String {
        match self.length {
            1 => format!("{} rows", self.rows),
            length => format!("{} blocks of {length} rows", self.count()),
        }
    }

    /// Advice for parameters whose deviations differ, of which some are larger and some smaller by the bootstrap.
    ///
    /// Measured with records of known truth (`coverage`; the table is in the book, "How certain"): where the bootstrap's are smaller they are so by chance; where they are larger, they are
    /// right for noise that is larger at some poses, but few blocks make them larger by chance, too. A lack of the model that varies with the pose shifts the values, which neither tells.
    fn advice(&self, has_larger: bool, has_smaller: bool) -> String {
        if self.count() < LEAST_BLOCKS {
            return format!(
                "only {} tell them, fewer than {LEAST_BLOCKS}, so that their own scatter is as large; keep the linear ones, which account for correlated rows",
                self.words()
            );
        }
        let larger = match self.length {
            1 => {
                "the noise is not what weights and model say, for instance larger at some poses: take those of the bootstrap where they are larger"
            }
            _ => {
                "where those of the bootstrap are larger, either the noise is larger at some poses, and they hold, or the model lacks something that varies with the pose, and \
                 neither of both holds: compare a richer model first"
            }
        };
        let smaller = "where those of the bootstrap are smaller, keep the linear ones: that is chance of the draws";
        [has_larger.then_some(larger), has_smaller.then_some(smaller)]
            .into_iter()
            .flatten()
            .collect::<Vec<_>>()
            .join("; ")
    }
}

fn warning(parameters: &[ResampledDeviation], blocks: &Blocks) -> Option<String> {
    let is_different = |ratio: f64| !(1.0 / DIFFERENT..=DIFFERENT).contains(&ratio);
    let mut different: Vec<(&str, f64)> = parameters
        .iter()
        .filter_map(|one| Some((one.parameter.as_str(), one.ratio.filter(|ratio| is_different(*ratio))?)))
        .collect();
    different.sort_by(|a, b| b.1.ln().abs().total_cmp(&a.1.ln().abs()));
    let names: Vec<String> =
        different.iter().take(NAMED).map(|(name, ratio)| format!("{name} {ratio:.2} times")).collect();
    let more = different.len().saturating_sub(NAMED);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    let has = |is_such: fn(f64) -> bool| different.iter().any(|(_, ratio)| is_such(*ratio));
    (!different.is_empty()).then(|| {
        format!(
            "bootstrap deviations of {} of {} parameters differ from the linear ones by more than a factor {DIFFERENT} ({}{more}): {}",
            different.len(),
            parameters.len(),
            names.join(", "),
            blocks.advice(has(|ratio| ratio > 1.0), has(|ratio| ratio < 1.0))
        )
    })
}

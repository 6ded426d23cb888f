//! Search for a set of poses by exchanges, from many starts.

use nalgebra::DMatrix;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::criterion::DesignCriterion;
use super::factorial;
use super::information::Information;
use super::settings::PlanSettings;
use cdpr_model::measurement::Samples;
use cdpr_model::scalar::map_all;

/// Relative gain that an exchange must bring.
const GAIN: f64 = 1e-10;

/// Steps of a processor that all starts together may take: some seconds.
const EFFORT: f64 = 4e9;

/// Passes over the set, far more than exchanges need.
const PASSES: usize = 100;

/// Best set of all starts.
pub(super) struct Found {
    pub(super) chosen: Vec<usize>,
    /// Starts, fewer than asked for where they would take long.
    pub(super) starts: u32,
    /// Share of the starts that ended at the same score.
    pub(super) fraction: f64,
}

/// Looks for the best set: one that grows pose by pose and random ones are improved by exchanges until none helps.
pub(super) fn search(information: &Information, samples: &Samples, settings: &PlanSettings) -> Found {
    if settings.criterion == DesignCriterion::Factorial {
        return Found { chosen: factorial::design(samples, settings.count), starts: 1, fraction: 1.0 };
    }
    // exchanges take some five passes
    let of_start = 5.0 * settings.count as f64 * information.candidates() as f64 * information.effort();
    let starts = f64::from(settings.starts).min(EFFORT / of_start).max(1.0) as u32;
    let ends = map_all(starts as usize, |start| {
        let first = match start {
            0 => grown(information, settings),
            _ => random(information.candidates(), settings, start as u64),
        };
        let smooth = by_way_of(settings.criterion, start);
        let first = match smooth == settings.criterion {
            true => first,
            false => improved(information, &PlanSettings { criterion: smooth, ..settings.clone() }, first).1,
        };
        improved(information, settings, first)
    });
    let best = ends.iter().map(|(score, _)| *score).fold(f64::INFINITY, f64::min);
    let is_best = |score: f64| score <= best + 1e-9 * best.abs().max(1.0);
    let fraction = ends.iter().filter(|(score, _)| is_best(*score)).count() as f64 / ends.len() as f64;
    let mut chosen = ends.into_iter().find(|(score, _)| is_best(*score)).map(|(_, chosen)| chosen).unwrap_or_default();
    chosen.sort_unstable();
    Found { chosen, starts, fraction }
}

/// Criterion that a start is improved by before its own. The least of many eigenvalues hardly ever grows by one exchange, so that smooth measures lead the
/// way.
fn by_way_of(criterion: DesignCriterion, start: usize) -> DesignCriterion {
    match criterion {
        DesignCriterion::E | DesignCriterion::Condition => {
            [DesignCriterion::A, DesignCriterion::D, DesignCriterion::I, criterion][start % 4]
        }
        smooth => smooth,
    }
}

/// A set that grows by the candidate that tells most.
fn grown(information: &Information, settings: &PlanSettings) -> Vec<usize> {
    let mut sum = information.nothing();
    let mut scratch = sum.clone();
    let mut chosen = Vec::with_capacity(settings.count);
    while chosen.len() < settings.count {
        let Some((_, next)) = best(information, settings, (&chosen, &sum), &mut scratch) else { break };
        information.add(&mut sum, next);
        chosen.push(next);
    }
    chosen
}

fn random(candidates: usize, settings: &PlanSettings, stream: u64) -> Vec<usize> {
    let mut rng = ChaCha8Rng::seed_from_u64(settings.seed);
    rng.set_stream(stream);
    if settings.repeats {
        return (0..settings.count).map(|_| rng.random_range(0..candidates)).collect();
    }
    let mut all: Vec<usize> = (0..candidates).collect();
    (0..settings.count).for_each(|place| all.swap(place, rng.random_range(place..candidates)));
    all.truncate(settings.count);
    all
}

/// The candidate that makes the best score beside a set, the first of equal ones.
fn best(
    information: &Information,
    settings: &PlanSettings,
    (chosen, sum): (&[usize], &[DMatrix<f64>]),
    scratch: &mut [DMatrix<f64>],
) -> Option<(f64, usize)> {
    let mut found: Option<(f64, usize)> = None;
    for candidate in 0..information.candidates() {
        if !settings.repeats && chosen.contains(&candidate) {
            continue;
        }
        let score = information.score_with(settings.criterion, sum, scratch, candidate);
        if found.is_none_or(|(least, _)| score < least) {
            found = Some((score, candidate));
        }
    }
    found
}

/// A set after exchanges of single poses for the best others, until none helps.
fn improved(information: &Information, settings: &PlanSettings, mut chosen: Vec<usize>) -> (f64, Vec<usize>) {
    let mut score = information.score(settings.criterion, &information.regular(&chosen));
    let mut scratch = information.nothing();
    for _ in 0..PASSES {
        let mut is_better = false;
        // sums and differences gather rounding
        let mut sum = information.regular(&chosen);
        for place in 0..chosen.len() {
            let own = chosen.swap_remove(place);
            information.take(&mut sum, own);
            let found = best(information, settings, (&chosen, &sum), &mut scratch);
            let next = match found {
                Some((new, candidate)) if new < score - GAIN * score.abs().max(1.0) => {
                    (score, is_better) = (new, true);
                    candidate
                }
                _ => own,
            };
            information.add(&mut sum, next);
            chosen.push(next);
            let last = chosen.len() - 1;
            chosen.swap(place, last);
        }
        if !is_better {
            break;
        }
    }
    (information.score(settings.criterion, &information.regular(&chosen)), chosen)
}

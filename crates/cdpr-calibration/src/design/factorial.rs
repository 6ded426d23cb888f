//! The plain grid: a full factorial design of candidates.

use cdpr_model::geometry::Pose;
use cdpr_model::measurement::Samples;

/// Coordinates of candidates, each scaled to the box of all of them.
fn scaled(samples: &Samples) -> Vec<Vec<f64>> {
    let middle = samples.poses.first().copied().unwrap_or_else(Pose::identity);
    let coordinates: Vec<[f64; 6]> = samples.poses.iter().map(|pose| middle.displacement_to(pose).into()).collect();
    let range = |axis: usize| {
        let along = || coordinates.iter().map(|point| point[axis]);
        (along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max))
    };
    let ranges: Vec<(usize, (f64, f64))> =
        (0..6).map(|axis| (axis, range(axis))).filter(|(_, (low, high))| high - low > 1e-9).collect();
    let point =
        |point: &[f64; 6]| ranges.iter().map(|&(axis, (low, high))| (point[axis] - low) / (high - low)).collect();
    coordinates.iter().map(point).collect()
}

/// So many candidates on a grid over their box, as even along all directions as their number allows; the rest as far from these as there are.
pub(super) fn design(samples: &Samples, count: usize) -> Vec<usize> {
    let points = scaled(samples);
    let levels = levels(points.first().map_or(0, Vec::len), count);
    let square = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
    let mut chosen: Vec<usize> = Vec::with_capacity(count);
    for place in 0..levels.iter().product::<usize>() {
        let mut rest = place;
        let wanted: Vec<f64> = levels
            .iter()
            .map(|&levels| {
                let level = rest % levels;
                rest /= levels;
                if levels == 1 { 0.5 } else { level as f64 / (levels - 1) as f64 }
            })
            .collect();
        let free = (0..points.len()).filter(|candidate| !chosen.contains(candidate));
        let near = |a: &usize, b: &usize| square(&points[*a], &wanted).total_cmp(&square(&points[*b], &wanted));
        chosen.extend(free.min_by(near));
    }
    while chosen.len() < count.min(points.len()) {
        let distance = |candidate: &usize| {
            chosen.iter().map(|own| square(&points[*own], &points[*candidate])).fold(f64::INFINITY, f64::min)
        };
        let free = (0..points.len()).filter(|candidate| !chosen.contains(candidate));
        // the first of equal ones
        let Some(next) = free.rev().max_by(|a, b| distance(a).total_cmp(&distance(b))) else { break };
        chosen.push(next);
    }
    // more poses than candidates repeat them in turn
    let once = chosen.len();
    (once..count).for_each(|place| chosen.push(chosen[place % once]));
    chosen.sort_unstable();
    chosen
}

/// Levels along every direction whose product comes next to a count from below, raised in turn.
fn levels(directions: usize, count: usize) -> Vec<usize> {
    let mut levels = vec![1; directions];
    let mut is_raised = true;
    while is_raised {
        is_raised = false;
        for direction in 0..directions {
            let others: usize =
                (0..directions).filter(|other| *other != direction).map(|other| levels[other]).product();
            let is_least = levels.iter().all(|other| levels[direction] <= *other);
            if is_least && others * (levels[direction] + 1) <= count {
                levels[direction] += 1;
                is_raised = true;
            }
        }
    }
    levels
}

//! Clocks of winches and tracker: how late poses were recorded, found by fitting.
//!
//! The cost of the best fit is a function of the offset, whose minimum Newton steps find. Poses are moved along their velocities from the nearest one:
//! straight interpolation would average their noise away, and with it what an offset is compared with.

use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;

/// Longer intervals part recordings (typical intervals).
const LONGEST_INTERVAL: f64 = 3.0;
/// Poses are not moved farther than this beyond the end of a recording (typical intervals).
const FARTHEST: f64 = 10.0;
/// Steps of the search, how far one goes (typical intervals), and the step that ends it.
const STEPS: usize = 15;
const LONGEST_STEP: f64 = 10.0;
const STEP_END: f64 = 1e-4;
/// Fewest samples that tell a clock.
const FEWEST: usize = 30;

/// Offset of the clocks, as fitted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClockOffset {
    /// Positive: poses are recorded late (s).
    pub seconds: f64,
    /// Standard deviation (s).
    pub sigma: f64,
    /// Share of the residuals' variance that the offset explains.
    pub explained: f64,
}

/// Cost of the best fit to samples.
pub(super) type Cost<'a> = &'a dyn Fn(&Samples) -> Option<f64>;

/// The offset of least cost; `None` if there are no times or too few samples, no minimum is found, or the first step promises to explain less than
/// a share of the variance. The model gives the size of the residuals; `parameters` are fitted for every cost.
pub(super) fn best_offset(
    model: &Model,
    samples: &Samples,
    parameters: usize,
    sought: f64,
    cost: Cost<'_>,
) -> Option<ClockOffset> {
    Search::of(model, samples, parameters, cost)?.run(sought)
}

/// Samples whose poses are those recorded later by an offset (s).
pub(super) fn synchronised(samples: &Samples, offset: f64) -> Samples {
    let Some(track) = Track::of(samples) else { return samples.clone() };
    let poses = (0..samples.len()).map(|sample| track.moved(sample, offset).0).collect();
    Samples { poses, ..samples.clone() }
}

/// The same without samples whose pose would lie beyond what was recorded: for fits, which such poses would draw aside. The numbers of those
/// kept (from 0) stand with them.
pub(super) fn synchronised_within(samples: &Samples, offset: f64) -> (Samples, Vec<usize>) {
    let Some(track) = Track::of(samples) else { return (samples.clone(), (0..samples.len()).collect()) };
    let kept: Vec<usize> = (0..samples.len()).filter(|&sample| track.moved(sample, offset).1).collect();
    let poses = kept.iter().map(|&sample| track.moved(sample, offset).0).collect();
    (Samples { poses, ..samples.subset(&kept) }, kept)
}

/// Samples over time, parted where an interval is long or time goes back.
struct Track<'a> {
    samples: &'a Samples,
    time: &'a [f64],
    /// Typical interval (s).
    interval: f64,
    /// First sample of the recording that a sample belongs to, and one past its last.
    parts: Vec<(usize, usize)>,
}

impl<'a> Track<'a> {
    fn of(samples: &'a Samples) -> Option<Self> {
        let time = samples.time.as_deref()?;
        let mut intervals: Vec<f64> =
            time.windows(2).map(|pair| pair[1] - pair[0]).filter(|step| *step > 0.0).collect();
        intervals.sort_by(f64::total_cmp);
        let interval = *intervals.get(intervals.len() / 2)?;
        let (mut parts, mut start) = (Vec::with_capacity(time.len()), 0);
        for sample in 1..=time.len() {
            let goes_on = sample < time.len() && {
                let step = time[sample] - time[sample - 1];
                step > 0.0 && step <= LONGEST_INTERVAL * interval
            };
            if !goes_on {
                parts.resize(sample, (start, sample));
                start = sample;
            }
        }
        Some(Self { samples, time, interval, parts })
    }

    /// The pose recorded later by an offset than a sample, and whether the recording has one there.
    fn moved(&self, sample: usize, offset: f64) -> (Pose, bool) {
        let (start, end) = self.parts[sample];
        let wanted = self.time[sample] + offset;
        let after = start + self.time[start..end].partition_point(|time| *time < wanted);
        let is_nearer = |a: usize, b: usize| (self.time[a] - wanted).abs() < (self.time[b] - wanted).abs();
        let last = after.min(end - 1);
        let near = if last > start && is_nearer(last - 1, last) { last - 1 } else { last };
        let ahead = wanted - self.time[near];
        if ahead == 0.0 {
            return (self.samples.poses[near], true);
        }
        let farthest = FARTHEST * self.interval;
        let step = self.velocity(near) * ahead.clamp(-farthest, farthest);
        (
            self.samples.poses[near].displaced(&step),
            end - start > 2 && ahead.abs() <= LONGEST_INTERVAL * self.interval / 2.0,
        )
    }

    /// Velocity at a sample by its neighbours (m/s, rad/s).
    fn velocity(&self, sample: usize) -> Twist {
        let (start, end) = self.parts[sample];
        let (before, after) = (sample.saturating_sub(1).max(start), (sample + 1).min(end - 1));
        if after == before {
            return Twist::zeros();
        }
        self.samples.poses[before].displacement_to(&self.samples.poses[after]) / (self.time[after] - self.time[before])
    }
}

/// The search for the offset of least cost.
struct Search<'a> {
    track: Track<'a>,
    /// Number of parameters that are fitted besides.
    parameters: usize,
    cost: Cost<'a>,
    /// Offset by which the cost is differentiated (s).
    width: f64,
}

/// Cost of a sample at three offsets, and how many samples have a pose at all of them.
struct Costs {
    before: f64,
    at: f64,
    after: f64,
    samples: usize,
}

impl<'a> Search<'a> {
    fn of(model: &Model, samples: &'a Samples, parameters: usize, cost: Cost<'a>) -> Option<Self> {
        let track = Track::of(samples).filter(|_| samples.len() >= FEWEST)?;
        let speeds = (0..samples.len()).map(|sample| track.velocity(sample).fixed_rows::<3>(0).norm_squared());
        let speed = (speeds.sum::<f64>() / samples.len() as f64).sqrt();
        // so short that lengths change no more than the residuals are large
        let width = (0.25 * track.interval).min(0.5 * residual(model, samples) / speed);
        (width > 0.0 && width.is_finite()).then_some(Self { track, parameters, cost, width })
    }

    /// Newton steps from offset 0, unless the first promises less than a share of the variance.
    fn run(&self, sought: f64) -> Option<ClockOffset> {
        let mut offset = 0.0;
        let mut first = None;
        for _ in 0..STEPS {
            let costs = self.costs(offset)?;
            let slope = (costs.after - costs.before) / (2.0 * self.width);
            let curvature = (costs.after + costs.before - 2.0 * costs.at) / (self.width * self.width);
            if !(curvature > 0.0) {
                return None;
            }
            let start = *first.get_or_insert(costs.at);
            if offset == 0.0 && slope * slope / (2.0 * curvature * start) < sought {
                return None;
            }
            let longest = LONGEST_STEP * self.track.interval;
            let step = (-slope / curvature).clamp(-longest, longest);
            if step.abs() <= STEP_END * self.track.interval {
                return Some(self.found(offset, 1.0 - costs.at / start, &costs, curvature));
            }
            offset += step;
        }
        None
    }

    fn found(&self, seconds: f64, explained: f64, costs: &Costs, curvature: f64) -> ClockOffset {
        let rows = costs.samples * self.track.samples.cable_count;
        let told = costs.at * costs.samples as f64 / rows.saturating_sub(self.parameters + 1).max(1) as f64;
        let sigmas = &self.track.samples.sigmas;
        let is_stated = [sigmas.length, sigmas.position].into_iter().flatten().any(|sigma| sigma > 0.0);
        // residuals that are smaller than stated accuracies are luck
        let noise = if is_stated { told.max(1.0) } else { told };
        ClockOffset { seconds, sigma: (2.0 * noise / (curvature * costs.samples as f64)).sqrt(), explained }
    }

    /// Least costs near an offset, all of the same samples.
    fn costs(&self, offset: f64) -> Option<Costs> {
        let samples = self.track.samples;
        let offsets = [offset - self.width, offset, offset + self.width];
        let is_there = |sample: &usize| offsets.iter().all(|offset| self.track.moved(*sample, *offset).1);
        let kept: Vec<usize> = (0..samples.len()).filter(is_there).collect();
        if kept.len() < FEWEST {
            return None;
        }
        let part = samples.subset(&kept);
        let cost = |offset: f64| {
            let poses = kept.iter().map(|&sample| self.track.moved(sample, offset).0).collect();
            Some((self.cost)(&Samples { poses, ..part.clone() })? / kept.len() as f64)
        };
        let [before, at, after] = offsets.map(cost);
        Some(Costs { before: before?, at: at?, after: after?, samples: kept.len() })
    }
}

/// Root of the mean square of modelled minus recorded lengths (m).
fn residual(model: &Model, samples: &Samples) -> f64 {
    let m = samples.cable_count;
    let square = |sample: usize| -> f64 {
        let recorded = samples.lengths_of(sample);
        let of_cable = |cable: usize| {
            let (path, _) = model.path(cable, &samples.poses[sample]).ok()?;
            Some((model.recorded_length(cable, path.length) - recorded[cable]).powi(2))
        };
        (0..m).filter_map(of_cable).sum()
    };
    ((0..samples.len()).map(square).sum::<f64>() / (samples.len() * m).max(1) as f64).sqrt()
}

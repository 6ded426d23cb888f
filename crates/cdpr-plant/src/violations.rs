//! Limits of tensions, judged at every step of a run.

use super::state::PlantState;
use cdpr_model::robot::Robot;

/// Fraction of a limit below which missing it does not count: the rounding of a start at the limit.
const ROUNDING: f64 = 1e-6;

/// Interval of time in which a cable breaks a limit of its tension, or is slack if none is stated; a broken cable does
/// neither.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Violation {
    /// Cable (0-based).
    pub cable: usize,
    /// Key of the robot file that states the limit; `None` for a slack cable whose file states no least tension above
    /// zero, so that no limit is broken.
    pub limit: Option<&'static str>,
    /// Limit (N); 0 for a slack cable.
    pub bound: f64,
    /// Time of the first step that shows it (s).
    pub from: f64,
    /// Time of the last one (s).
    pub to: f64,
    /// Total length of the steps whose ends break the limit (s).
    pub duration: f64,
    /// Tension farthest from the limit (N).
    pub worst: f64,
}

/// Judge of a run, which checks the state after every step.
#[derive(Clone, Debug)]
pub(super) struct Judge {
    /// Limits of each cable.
    watched: Vec<Vec<Watched>>,
    /// Time between records (s).
    record: f64,
    /// Time of the last check (s).
    last: f64,
}

/// A limit of one cable, with the intervals of time that break it; intervals less than a record apart are merged.
#[derive(Clone, Debug)]
struct Watched {
    limit: Option<&'static str>,
    bound: f64,
    is_largest: bool,
    found: Vec<Violation>,
}

impl Judge {
    /// A judge with the limits of a robot file, before the first check.
    pub(super) fn new(robot: &Robot, record: f64) -> Self {
        let watch = |limit: Option<&'static str>, bound: f64, is_largest: bool| Watched {
            limit,
            bound,
            is_largest,
            found: Vec::new(),
        };
        let of_cable = |cable: &cdpr_model::robot::Cable| {
            let low = match cable.tension_min.filter(|least| *least > 0.0) {
                Some(least) => watch(Some("tension_min_N"), least, false),
                None => watch(None, 0.0, false),
            };
            let high = cable.tension_max.map(|largest| watch(Some("tension_max_N"), largest, true));
            [low].into_iter().chain(high).collect()
        };
        Self { watched: robot.cables.iter().map(of_cable).collect(), record, last: 0.0 }
    }

    /// Checks the state after a step, for which tensions must be observed.
    pub(super) fn look(&mut self, state: &PlantState) {
        let step = state.time - self.last;
        self.last = state.time;
        for (index, (cable, watched)) in state.cables.iter().zip(&mut self.watched).enumerate() {
            for limit in watched.iter_mut().filter(|limit| !cable.is_broken && limit.is_broken_by(cable.tension)) {
                limit.note((index, cable.tension), (state.time, step), self.record);
            }
        }
    }

    /// Violations sorted by time, then cable.
    pub(super) fn found(self) -> Vec<Violation> {
        let mut all: Vec<Violation> = self.watched.into_iter().flatten().flat_map(|limit| limit.found).collect();
        all.sort_by(|a, b| a.from.total_cmp(&b.from).then(a.cable.cmp(&b.cable)));
        all
    }
}

impl Watched {
    fn is_broken_by(&self, tension: f64) -> bool {
        match (self.limit, self.is_largest) {
            (None, _) => !(tension > 0.0),
            (_, false) => !(tension >= self.bound * (1.0 - ROUNDING)),
            (_, true) => !(tension <= self.bound * (1.0 + ROUNDING)),
        }
    }

    /// Records a step that ends in violation of the limit.
    fn note(&mut self, (cable, tension): (usize, f64), (time, step): (f64, f64), record: f64) {
        match self.found.last_mut() {
            Some(last) if time - last.to <= record.max(step) => {
                last.to = time;
                last.duration += step;
                last.worst = if self.is_largest { last.worst.max(tension) } else { last.worst.min(tension) };
            }
            _ => {
                let (limit, bound) = (self.limit, self.bound);
                self.found.push(Violation {
                    cable,
                    limit,
                    bound,
                    from: time,
                    to: time,
                    duration: step,
                    worst: tension,
                });
            }
        }
    }
}

//! Moments of a machine's run, as pages, figures and files show them.

#[cfg(feature = "recording")]
mod mcap_file;
#[cfg(feature = "recording")]
mod messages;
mod violation;

use cdpr_model::geometry::Pose;
use cdpr_model::robot::Robot;
use cdpr_model::tension::Limits;
use cdpr_plant::{Event, PlantState};
use schemars::JsonSchema;
use serde::Serialize;

use crate::number_format::significant;
#[cfg(feature = "recording")]
pub use mcap_file::McapError;
pub(crate) use violation::{OTHERS, sentence, stretches_of_limits};
pub use violation::{Stretch, Violation};

/// Pictures of the scene in a second, at most: a reader sees no more, and they are the largest messages.
const SCENES_PER_SECOND: f64 = 30.0;

/// Bytes of the messages of a moment without a scene, and for each cable; of a scene, and for each cable: those of runs of a planar robot with four cables and a spatial one with
/// eight, whose numbers have all their digits.
const MOMENT: [f64; 2] = [556.0, 47.0];
const SCENE: [f64; 2] = [361.0, 291.0];

/// Bytes of the file of a record of so many moments that takes a time (s), about.
pub fn mcap_bytes(cables: usize, moments: u64, duration: f64) -> u64 {
    let every = (moments as f64 / (SCENES_PER_SECOND * duration)).ceil().max(1.0);
    let scenes = (moments as f64 / every).ceil();
    let of = |[fixed, each]: [f64; 2]| fixed + each * cables as f64;
    (moments as f64 * of(MOMENT) + scenes * of(SCENE)) as u64
}

/// State of the machine at a time.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// Time since the start (s).
    pub time: f64,
    /// Platform pose.
    pub pose: Pose,
    /// Tensions (N), pull positive, one per cable.
    pub tensions: Vec<f64>,
}

/// Event of a run in words.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Occurrence {
    /// Time since the start (s).
    #[serde(rename = "time_s")]
    pub time: f64,
    /// Words, as `cable 3 breaks`.
    pub words: String,
    /// Cable that it is about, from 0.
    pub cable: Option<usize>,
    /// True where the cable is no longer there afterwards.
    pub breaks: bool,
}

impl Occurrence {
    fn of(event: &Event, robot: &Robot) -> Self {
        let cable = event.happening.cable();
        let name = cable.map(|cable| format!("cable {}", robot.cables[cable].name)).unwrap_or_default();
        let words = event.happening.words(&name, &significant);
        Self { time: event.time, words, cable, breaks: event.happening.takes_cable() }
    }
}

/// Record of a run: moments in order of time, and what happened.
#[derive(Clone, Debug)]
pub struct Recording<'a> {
    /// Robot that moved.
    pub robot: &'a Robot,
    /// Moments, in order of time.
    pub moments: Vec<Moment>,
    /// Events that happened, in order of time.
    pub events: Vec<Occurrence>,
    /// Least and largest tension of each cable (N); empty where the limits are unknown.
    pub limits: Vec<(f64, f64)>,
}

impl<'a> Recording<'a> {
    /// An empty record of a robot with the limits of its file.
    pub fn new(robot: &'a Robot) -> Self {
        let limits = Limits::of(robot, None, None).ok();
        let pairs = |limits: Limits| limits.minimum().iter().copied().zip(limits.maximum().iter().copied()).collect();
        Self { robot, moments: Vec::new(), events: Vec::new(), limits: limits.map(pairs).unwrap_or_default() }
    }

    /// Adds the state of the machine.
    pub fn note(&mut self, state: &PlantState) {
        self.moments.push(Moment {
            time: state.time,
            pose: state.pose,
            tensions: state.cables.iter().map(|cable| cable.tension).collect(),
        });
    }

    /// Adds events that happened.
    pub fn happened(&mut self, events: &[Event]) {
        let robot = self.robot;
        self.events.extend(events.iter().map(|event| Occurrence::of(event, robot)));
    }
}

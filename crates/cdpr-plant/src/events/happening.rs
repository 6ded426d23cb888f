//! Happenings and their time.

use std::fmt::Debug;
use std::sync::Arc;

use nalgebra::Vector3;

use crate::plant::Plant;
use crate::state::PlantState;

/// Happening at a time.
#[derive(Clone, Debug)]
pub struct Event {
    /// Time since the start (s).
    pub time: f64,
    /// Happening.
    pub happening: Arc<dyn Happening>,
}

impl Event {
    /// A happening at a time (s).
    pub fn new(time: f64, happening: impl Happening + 'static) -> Self {
        Self { time, happening: Arc::new(happening) }
    }
}

/// Change of a machine within no time. Cables count from 0.
pub trait Happening: Debug + Send + Sync {
    /// Word of scenario files.
    fn kind(&self) -> &'static str;

    /// Changes a state.
    fn apply(&self, plant: &Plant, state: &mut PlantState);

    /// Sentence without a full stop, as "cable 3 breaks". `cable` names the cable that it is about, `number` writes a number with so many digits.
    fn words(&self, cable: &str, number: &dyn Fn(f64, i32) -> String) -> String;

    /// Cable that it is about (0-based); `None` if it is about none.
    fn cable(&self) -> Option<usize> {
        None
    }

    /// True if its cable is no longer there afterwards.
    fn takes_cable(&self) -> bool {
        false
    }

    /// Load that the platform takes up or loses by it.
    fn load_change(&self) -> Option<&LoadChange> {
        None
    }
}

/// A mass that moves as the platform does is fixed to it, or taken off (negative). One that leaves no body changes nothing: scenarios refuse it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadChange {
    /// Mass (kg).
    pub mass: f64,
    /// Place (platform frame, m).
    pub place: Vector3<f64>,
}

impl Plant {
    /// Lets something happen to a state; the twist of the platform stays.
    pub fn apply(&self, state: &mut PlantState, happening: &dyn Happening) {
        happening.apply(self, state);
    }
}

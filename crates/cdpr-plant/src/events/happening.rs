//! Changes of a machine at an instant, and their times.

use std::fmt::Debug;
use std::sync::Arc;

use nalgebra::Vector3;

use crate::plant::Plant;
use crate::state::PlantState;

/// A change of the machine at a time.
#[derive(Clone, Debug)]
pub struct Event {
    /// Time since the start (s).
    pub time: f64,
    /// The change.
    pub happening: Arc<dyn Happening>,
}

impl Event {
    /// An event at a time (s).
    pub fn new(time: f64, happening: impl Happening + 'static) -> Self {
        Self { time, happening: Arc::new(happening) }
    }
}

/// Instantaneous change of a machine. Cables count from 0.
pub trait Happening: Debug + Send + Sync {
    /// Word in scenario files.
    fn kind(&self) -> &'static str;

    /// Changes a state.
    fn apply(&self, plant: &Plant, state: &mut PlantState);

    /// Sentence without a full stop, such as "cable 3 breaks". `cable` is the name of the cable that it concerns;
    /// `number` formats a number with a given count of digits.
    fn words(&self, cable: &str, number: &dyn Fn(f64, i32) -> String) -> String;

    /// Cable that it concerns (0-based); `None` if it concerns none.
    fn cable(&self) -> Option<usize> {
        None
    }

    /// True if the cable is broken afterwards.
    fn takes_cable(&self) -> bool {
        false
    }

    /// Load that the platform takes up or loses; `None` for other events.
    fn load_change(&self) -> Option<&LoadChange> {
        None
    }
}

/// A mass that moves with the platform is attached to it, or removed (negative mass). A change that leaves no positive
/// mass has no effect: scenarios refuse it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadChange {
    /// Mass (kg).
    pub mass: f64,
    /// Position of the mass (platform frame, m).
    pub place: Vector3<f64>,
}

impl Plant {
    /// Applies an event to a state; the twist of the platform is unchanged.
    pub fn apply(&self, state: &mut PlantState, happening: &dyn Happening) {
        happening.apply(self, state);
    }
}

//! Events: what happens to a machine at an instant.

use nalgebra::Vector3;

use super::momentum::Inertia;
use super::plant::Plant;
use super::state::State;
use crate::geometry::Wrench;
use crate::robot::Body;

/// Happening at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// Time since the start (s).
    pub time: f64,
    /// Happening.
    pub happening: Happening,
}

/// Change of a machine within no time. Cables count from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Happening {
    /// A cable breaks: its tension is 0 from then on.
    CableBreak {
        /// Cable (0-based).
        cable: usize,
    },
    /// A winch stands still whatever it is told.
    WinchStop {
        /// Cable (0-based).
        cable: usize,
    },
    /// A cable slips through what holds it and is longer by this.
    Slip {
        /// Cable (0-based).
        cable: usize,
        /// Length (m), positive where the cable grows longer.
        length: f64,
    },
    /// A mass that moves as the platform does is fixed to it, or taken off (negative).
    Load {
        /// Mass (kg).
        mass: f64,
        /// Place (platform frame, m).
        place: Vector3<f64>,
    },
    /// A wrench acts besides load and weight, in place of the one of an earlier event (world axes, moment about the platform origin; N, N·m).
    Wrench(Wrench),
}

impl Happening {
    /// Cable that it is about (0-based).
    pub fn cable(&self) -> Option<usize> {
        match self {
            Self::CableBreak { cable } | Self::WinchStop { cable } | Self::Slip { cable, .. } => Some(*cable),
            Self::Load { .. } | Self::Wrench(_) => None,
        }
    }

    /// Word of scenario files.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::CableBreak { .. } => "cable-break",
            Self::WinchStop { .. } => "winch-stop",
            Self::Slip { .. } => "slip",
            Self::Load { .. } => "load",
            Self::Wrench(_) => "wrench",
        }
    }
}

impl Plant {
    /// Lets it happen to a state; the twist of the platform stays. A load that leaves no mass changes nothing: scenarios refuse it.
    pub fn apply(&self, state: &mut State, happening: &Happening) {
        match *happening {
            Happening::CableBreak { cable } => {
                state.cables[cable].is_broken = true;
                state.cables[cable].tension = 0.0;
            }
            Happening::WinchStop { cable } => {
                let cable = &mut state.cables[cable];
                (cable.is_stopped, cable.controlled_length_rate, cable.drum_speed) = (true, 0.0, 0.0);
            }
            Happening::Slip { cable, length } => state.cables[cable].slip += length,
            Happening::Load { mass, place } => self.take_up(state, mass, &place),
            Happening::Wrench(wrench) => state.external = wrench,
        }
    }

    fn take_up(&self, state: &mut State, mass: f64, place: &Vector3<f64>) {
        let Some(body) = state.inertia.body.with_point_mass(mass, place) else { return };
        let twist = state.twist();
        state.inertia = Inertia::new(&self.model, self.held(body));
        state.added.mass += mass;
        state.added.moment += place * mass;
        state.set_twist(&twist);
    }

    /// The body as the pattern sees it: without turns a point.
    fn held(&self, body: Body) -> Body {
        match self.model.robot().motion_pattern.has_rotation() {
            true => body,
            false => Body { center_of_mass: Vector3::zeros(), inertia: nalgebra::Matrix3::zeros(), ..body },
        }
    }
}

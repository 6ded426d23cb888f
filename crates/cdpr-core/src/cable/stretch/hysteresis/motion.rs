//! Linearization of a monotone motion by the memory before it: the strain at a tension, and the memory after it.
//!
//! A stop that follows the strain ends at Sⱼ + (ε − ε₀)/rⱼ; a stop that slides ends at ±1, independent of its start.
//! With the change oⱼ = dSⱼ − dε₀/rⱼ of the following stops the law f(ε, memory) gives
//!
//! dε = ∂ε/∂f (df − ½(up − down) Σ wⱼ oⱼ),  dSⱼ ← oⱼ + dε/rⱼ, and 0 for stops that slide.
//!
//! Both are smooth except where a stop begins to slide or to follow; there too, they have a derivative along changes
//! that leave the stop there. The law itself has continuous slopes at its knots.

use super::{Hysteresis, Memory, TRANSITION_LIMIT};

/// Change of a [`Memory`] per unit of a deviation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MemoryChange {
    /// Change of the strain.
    pub strain: f64,
    /// Changes of the stops.
    pub stops: [f64; TRANSITION_LIMIT],
}

/// A monotone motion from a memory to a tension, linearized.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// ε at the end of the motion.
    pub strain: f64,
    /// ∂ε/∂f at fixed memory (1/N).
    pub by_tension: f64,
    /// The stops in use; others as if they slid at any strain.
    stops: [Stop; TRANSITION_LIMIT],
}

/// A stop at the end of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Stop {
    /// State of the stop if it followed the strain without limit instead of sliding at ±1.
    free: f64,
    /// 1/rⱼ.
    rate: f64,
    /// ∂ε/∂Sⱼ at fixed tension if the stop follows.
    effect: f64,
}

impl Hysteresis {
    /// The motion from a memory to a tension (N).
    pub fn motion(&self, tension: f64, memory: &Memory) -> Motion {
        let (strain, by_tension) = self.strain(tension, memory);
        let half = self.branches(strain).half;
        let mut stops = [Stop { free: f64::INFINITY, rate: 1.0, effect: 0.0 }; TRANSITION_LIMIT];
        for ((stop, operator), &before) in stops.iter_mut().zip(self.stops.iter()).zip(&memory.stops) {
            let free = before + (strain - memory.strain) * operator.rate;
            *stop = Stop { free, rate: operator.rate, effect: -half * operator.weight * by_tension };
        }
        Motion { strain, by_tension, stops }
    }
}

impl Stop {
    fn follows(&self) -> bool {
        self.free.abs() < 1.0
    }

    /// Strain to the point where the stop would begin to slide, or to follow.
    fn margin(&self) -> f64 {
        (self.free.abs() - 1.0).abs() / self.rate
    }

    /// Change oⱼ of the stop's state at fixed strain.
    fn change(&self, stop: f64, before: &MemoryChange) -> f64 {
        stop - self.rate * before.strain
    }
}

impl Motion {
    /// Least strain by which the motion can change before another stop begins to slide or to follow.
    pub fn margin(&self) -> f64 {
        self.stops.iter().map(Stop::margin).fold(f64::INFINITY, f64::min)
    }

    /// The memory in which the stops that lie within the strain `near` of beginning to slide or to follow are moved on,
    /// so that they clearly slide.
    pub fn pushed_on(&self, near: f64, memory: &Memory) -> Memory {
        let pushed = |j: usize| match self.stops[j] {
            stop if stop.margin() < near => memory.stops[j] + (2.0 * near * stop.rate).copysign(stop.free),
            _ => memory.stops[j],
        };
        Memory { strain: memory.strain, stops: core::array::from_fn(pushed) }
    }

    /// True if all stops slide: the memory before the motion has no effect any more.
    pub fn forgets(&self) -> bool {
        self.stops.iter().all(|stop| !stop.follows())
    }

    /// Change of the strain at the end of the motion with the tension (N) and the memory before.
    pub fn strain_change(&self, tension: f64, before: &MemoryChange) -> f64 {
        let following = self.stops.iter().zip(before.stops).filter(|(stop, _)| stop.follows());
        let by_memory: f64 = following.map(|(stop, change)| stop.effect * stop.change(change, before)).sum();
        self.by_tension * tension + by_memory
    }

    /// Change of the memory after the motion, for a change `strain` of the strain at its end.
    pub fn memory_change(&self, strain: f64, before: &MemoryChange) -> MemoryChange {
        let after = |j: usize| match self.stops[j].follows() {
            true => self.stops[j].change(before.stops[j], before) + self.stops[j].rate * strain,
            false => 0.0,
        };
        MemoryChange { strain, stops: core::array::from_fn(after) }
    }

    /// Largest strain by which the stops within `near` of beginning to slide or to follow move relative to that point.
    /// Zero if the change leaves them there, so that it has a derivative nevertheless.
    pub fn crossing(&self, near: f64, strain: f64, before: &MemoryChange) -> f64 {
        let meeting = self.stops.iter().zip(before.stops).filter(|(stop, _)| stop.margin() < near);
        meeting.map(|(stop, change)| (stop.change(change, before) / stop.rate + strain).abs()).fold(0.0, f64::max)
    }
}

//! How a monotone motion follows what the cable remembered: its strain at a tension, and the memory after it.
//!
//! A stop that follows the strain ends at Sⱼ + (ε − ε₀)/rⱼ, one that slides at ±1 whatever it was. With the change
//! oⱼ = dSⱼ − dε₀/rⱼ of the following ones the law f(ε, memory) gives
//!
//! dε = ∂ε/∂f (df − ½(up − down) Σ wⱼ oⱼ),  dSⱼ ← oⱼ + dε/rⱼ, and 0 for stops that slide.
//!
//! Both are smooth but where a stop begins to slide or to follow, and there too in a direction in which it stays there; the law itself
//! has continuous slopes at its knots.

use super::{Hysteresis, Memory, TRANSITION_LIMIT};

/// Change of a [`Memory`] along a deviation, per unit of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MemoryChange {
    /// Of the strain.
    pub strain: f64,
    /// Of the stops.
    pub stops: [f64; TRANSITION_LIMIT],
}

/// A monotone motion from a memory to a tension, linearized.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// ε at its end.
    pub strain: f64,
    /// ∂ε/∂f at fixed memory (1/N).
    pub by_tension: f64,
    /// The stops in use, others as if they slid for ever.
    stops: [Stop; TRANSITION_LIMIT],
}

/// A stop at the end of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Stop {
    /// Its state if it followed the strain however far, and did not slide at ±1.
    free: f64,
    /// 1/rⱼ.
    rate: f64,
    /// ∂ε/∂Sⱼ at fixed tension where it follows.
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

    /// Strain to where it would begin to slide, or to follow.
    fn margin(&self) -> f64 {
        (self.free.abs() - 1.0).abs() / self.rate
    }

    /// Change oⱼ of its state at fixed strain.
    fn change(&self, stop: f64, before: &MemoryChange) -> f64 {
        stop - self.rate * before.strain
    }
}

impl Motion {
    /// Least strain to a motion on which another stop slides, or another one follows.
    pub fn margin(&self) -> f64 {
        self.stops.iter().map(Stop::margin).fold(f64::INFINITY, f64::min)
    }

    /// The memory from which stops nearer than this strain to where they begin to slide or to follow slide beyond doubt.
    pub fn pushed_on(&self, near: f64, memory: &Memory) -> Memory {
        let pushed = |j: usize| match self.stops[j] {
            stop if stop.margin() < near => memory.stops[j] + (2.0 * near * stop.rate).copysign(stop.free),
            _ => memory.stops[j],
        };
        Memory { strain: memory.strain, stops: core::array::from_fn(pushed) }
    }

    /// True where all stops slide: nothing is left of what the cable remembered before.
    pub fn forgets(&self) -> bool {
        self.stops.iter().all(|stop| !stop.follows())
    }

    /// Change of the strain at its end with the tension (N) and the memory before.
    pub fn strain_change(&self, tension: f64, before: &MemoryChange) -> f64 {
        let following = self.stops.iter().zip(before.stops).filter(|(stop, _)| stop.follows());
        let by_memory: f64 = following.map(|(stop, change)| stop.effect * stop.change(change, before)).sum();
        self.by_tension * tension + by_memory
    }

    /// Change of the memory after the motion, for this change of the strain at its end.
    pub fn memory_change(&self, strain: f64, before: &MemoryChange) -> MemoryChange {
        let after = |j: usize| match self.stops[j].follows() {
            true => self.stops[j].change(before.stops[j], before) + self.stops[j].rate * strain,
            false => 0.0,
        };
        MemoryChange { strain, stops: core::array::from_fn(after) }
    }

    /// Strain by which stops that are nearer than `near` to where they begin to slide or to follow move against that place, the largest:
    /// zero where a change leaves them there, so that it has a derivative all the same.
    pub fn crossing(&self, near: f64, strain: f64, before: &MemoryChange) -> f64 {
        let meeting = self.stops.iter().zip(before.stops).filter(|(stop, _)| stop.margin() < near);
        meeting.map(|(stop, change)| (stop.change(change, before) / stop.rate + strain).abs()).fold(0.0, f64::max)
    }
}

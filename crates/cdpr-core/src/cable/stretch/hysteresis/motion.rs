//! How a monotone motion follows what the cable remembered: its strain at a tension, and the memory after it.
//!
//! A stop that follows the strain ends at Sⱼ + (ε − ε₀)/rⱼ, one that slides at ±1 whatever it was. With the change
//! oⱼ = dSⱼ − dε₀/rⱼ of the following ones the law f(ε, memory) gives
//!
//! dε = ∂ε/∂f (df − ½(up − down) Σ wⱼ oⱼ),  dSⱼ ← oⱼ + dε/rⱼ, and 0 for stops that slide.
//!
//! Both are smooth but where a stop begins to slide or to follow; the law itself has continuous slopes at its knots.

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
    /// Least strain to a motion on which another stop slides, or another one follows.
    pub margin: f64,
    /// ∂ε/∂Sⱼ at fixed tension; zero for stops that slide.
    by_stops: [f64; TRANSITION_LIMIT],
    /// 1/rⱼ of the stops that follow the strain; zero for others.
    rates: [f64; TRANSITION_LIMIT],
}

impl Hysteresis {
    /// The motion from a memory to a tension (N).
    pub fn motion(&self, tension: f64, memory: &Memory) -> Motion {
        let (strain, by_tension) = self.strain(tension, memory);
        let half = self.branches(strain).half;
        let mut motion = Motion {
            strain,
            by_tension,
            margin: f64::INFINITY,
            by_stops: [0.0; TRANSITION_LIMIT],
            rates: [0.0; TRANSITION_LIMIT],
        };
        for (j, (operator, &before)) in self.stops.iter().zip(&memory.stops).enumerate() {
            let beyond = (before + (strain - memory.strain) * operator.rate).abs() - 1.0;
            motion.margin = motion.margin.min(beyond.abs() / operator.rate);
            if beyond < 0.0 {
                motion.by_stops[j] = -half * operator.weight * by_tension;
                motion.rates[j] = operator.rate;
            }
        }
        motion
    }
}

impl Motion {
    /// True where all stops slide: nothing is left of what the cable remembered before.
    pub fn forgets(&self) -> bool {
        self.rates.iter().all(|&rate| rate == 0.0)
    }

    /// Change of the strain at its end with the tension (N) and the memory before.
    pub fn strain_change(&self, tension: f64, before: &MemoryChange) -> f64 {
        let stops = self.by_stops.iter().zip(self.rates).zip(before.stops);
        let by_memory: f64 = stops.map(|((by, rate), stop)| by * (stop - rate * before.strain)).sum();
        self.by_tension * tension + by_memory
    }

    /// Change of the memory after the motion, for this change of the strain at its end.
    pub fn memory_change(&self, strain: f64, before: &MemoryChange) -> MemoryChange {
        let follow = |j: usize| match self.rates[j] > 0.0 {
            true => before.stops[j] + (strain - before.strain) * self.rates[j],
            false => 0.0,
        };
        MemoryChange { strain, stops: core::array::from_fn(follow) }
    }
}

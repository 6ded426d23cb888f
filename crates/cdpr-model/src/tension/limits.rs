//! Least and largest tension of every cable.

use thiserror::Error;

use crate::robot::Robot;

/// Largest number by amount that is accepted (N): squares of tensions over small pivots still have to be finite.
pub(super) const LARGEST: f64 = 1e100;

/// Tension limits, one pair per cable, at most 1e100 N by amount and in order.
#[derive(Clone, Debug, PartialEq)]
pub struct Limits {
    minimum: Vec<f64>,
    maximum: Vec<f64>,
    /// Largest limit by amount (N), to which tolerances are relative.
    scale: f64,
    /// Norm of maximum − minimum (N): the largest possible distance between two allowed distributions.
    diameter: f64,
}

/// Limits that are out of order, not finite, or unknown.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum LimitsError {
    /// Lists of different length.
    #[error("{minimum} least and {maximum} largest tensions do not make one pair per cable")]
    Count {
        /// Number of least tensions.
        minimum: usize,
        /// Number of largest tensions.
        maximum: usize,
    },
    /// A limit that is NaN, infinite, or so large that its square overflows in sums.
    #[error(
        "cable {cable}: the tension limits {minimum:?} N to {maximum:?} N are not finite, or too large to calculate with; tensions are \
         at most 1e100 N"
    )]
    NotFinite {
        /// Number of the cable, from 1.
        cable: usize,
        /// Least tension (N).
        minimum: f64,
        /// Largest tension (N).
        maximum: f64,
    },
    /// A least tension above the largest one.
    #[error("cable {cable}: the least tension {minimum} N is above the largest {maximum} N")]
    EmptyRange {
        /// Number of the cable, from 1.
        cable: usize,
        /// Least tension (N).
        minimum: f64,
        /// Largest tension (N).
        maximum: f64,
    },
    /// The robot's file does not state a limit.
    #[error(
        "the tension limits of cable {cable} (\"{name}\") are unknown: the file of \"{robot}\" lacks {key}; add it, or give the limit for all cables"
    )]
    MissingKey {
        /// Name of the robot.
        robot: String,
        /// Number of the cable, from 1.
        cable: usize,
        /// Name of the cable.
        name: String,
        /// The key that is missing.
        key: &'static str,
    },
}

/// False for NaN, infinities, and numbers whose squares overflow in sums.
pub(super) fn can_be_calculated_with(number: f64) -> bool {
    number.abs() <= LARGEST
}

impl Limits {
    /// Limits from two lists with one entry per cable (N).
    pub fn new(minimum: Vec<f64>, maximum: Vec<f64>) -> Result<Self, LimitsError> {
        if minimum.len() != maximum.len() {
            return Err(LimitsError::Count { minimum: minimum.len(), maximum: maximum.len() });
        }
        let (mut scale, mut diameter) = (0.0_f64, 0.0);
        for (index, (&minimum, &maximum)) in minimum.iter().zip(&maximum).enumerate() {
            let cable = index + 1;
            if !(can_be_calculated_with(minimum) && can_be_calculated_with(maximum)) {
                return Err(LimitsError::NotFinite { cable, minimum, maximum });
            }
            if minimum > maximum {
                return Err(LimitsError::EmptyRange { cable, minimum, maximum });
            }
            scale = scale.max(minimum.abs()).max(maximum.abs());
            diameter += (maximum - minimum).powi(2);
        }
        Ok(Self { minimum, maximum, scale, diameter: diameter.sqrt() })
    }

    /// The same limits for all cables (N).
    pub fn uniform(cable_count: usize, minimum: f64, maximum: f64) -> Result<Self, LimitsError> {
        Self::new(vec![minimum; cable_count], vec![maximum; cable_count])
    }

    /// The limits that a robot's file states; a given minimum or maximum replaces them for all cables (N).
    pub fn of(robot: &Robot, minimum: Option<f64>, maximum: Option<f64>) -> Result<Self, LimitsError> {
        let (mut least, mut largest) = (Vec::new(), Vec::new());
        for (index, cable) in robot.cables.iter().enumerate() {
            let missing = |key| LimitsError::MissingKey {
                robot: robot.name.clone(),
                cable: index + 1,
                name: cable.name.clone(),
                key,
            };
            least.push(minimum.or(cable.tension_min).ok_or_else(|| missing("`tension_min_N`"))?);
            largest.push(maximum.or(cable.tension_max).ok_or_else(|| missing("`tension_max_N`"))?);
        }
        Self::new(least, largest)
    }

    /// Number of cables m.
    pub fn cable_count(&self) -> usize {
        self.minimum.len()
    }

    /// Least tension per cable (N).
    pub fn minimum(&self) -> &[f64] {
        &self.minimum
    }

    /// Largest tension per cable (N).
    pub fn maximum(&self) -> &[f64] {
        &self.maximum
    }

    /// f_m = ½ (f_min + f_max) of one cable (N).
    pub fn middle(&self, cable: usize) -> f64 {
        0.5 * (self.minimum[cable] + self.maximum[cable])
    }

    /// True if there is one tension per cable and every one keeps its limits, within `tolerance` (N).
    pub fn contain(&self, tensions: &[f64], tolerance: f64) -> bool {
        let within =
            |(index, &f): (usize, &f64)| f >= self.minimum[index] - tolerance && f <= self.maximum[index] + tolerance;
        tensions.len() == self.cable_count() && tensions.iter().enumerate().all(within)
    }

    /// Rounding of tensions (N), 1e-10 of the largest limit: a limit missed by less counts as kept.
    pub fn tolerance(&self) -> f64 {
        1e-10 * self.scale
    }

    /// Memory for the limits of this many cables, all zero.
    pub(super) fn zero(cable_count: usize) -> Self {
        Self { minimum: vec![0.0; cable_count], maximum: vec![0.0; cable_count], scale: 0.0, diameter: 0.0 }
    }

    /// Copies other limits of the same number of cables, without claiming memory.
    pub(super) fn copy_from(&mut self, other: &Self) {
        self.minimum.copy_from_slice(&other.minimum);
        self.maximum.copy_from_slice(&other.maximum);
        (self.scale, self.diameter) = (other.scale, other.diameter);
    }

    /// Narrows the limits to tensions that can be reached from the previous ones (N). The error is the first cable
    /// (from 0) that can reach none of its allowed tensions.
    pub(super) fn narrow_around(&mut self, previous: &[f64], rates: &[f64], time_step: f64) -> Result<(), usize> {
        for (cable, (previous, rate)) in previous.iter().zip(rates).enumerate() {
            let reach = rate * time_step;
            let least = self.minimum[cable].max(previous - reach);
            let largest = self.maximum[cable].min(previous + reach);
            // tensions on a limit to rounding are not beyond it
            if least > largest + self.tolerance() {
                return Err(cable);
            }
            (self.minimum[cable], self.maximum[cable]) = (least.min(largest), largest);
        }
        let ranges = self.minimum.iter().zip(&self.maximum);
        self.diameter = ranges.map(|(least, largest)| (largest - least).powi(2)).sum::<f64>().sqrt();
        Ok(())
    }

    /// Sets the limits to `wide`, narrowed at both ends by this fraction of each range.
    pub(super) fn narrow_from(&mut self, wide: &Self, part: f64) {
        for cable in 0..wide.cable_count() {
            let margin = part * (wide.maximum[cable] - wide.minimum[cable]);
            self.minimum[cable] = wide.minimum[cable] + margin;
            self.maximum[cable] = (wide.maximum[cable] - margin).max(self.minimum[cable]);
        }
        (self.scale, self.diameter) = (wide.scale, wide.diameter);
    }

    /// Sets the limits to other ones, multiplied by one factor per cable.
    pub(super) fn scale_from(&mut self, other: &Self, factors: &[f64]) {
        let (mut scale, mut square) = (0.0_f64, 0.0);
        for (cable, factor) in factors.iter().enumerate() {
            let (least, largest) = (factor * other.minimum[cable], factor * other.maximum[cable]);
            (self.minimum[cable], self.maximum[cable]) = (least, largest);
            scale = scale.max(least.abs()).max(largest.abs());
            square += (largest - least).powi(2);
        }
        (self.scale, self.diameter) = (scale, square.sqrt());
    }

    /// Clamps tensions to the limits, for tensions that miss them by rounding.
    pub(super) fn clamp(&self, tensions: &mut [f64]) {
        let limits = self.minimum.iter().zip(&self.maximum);
        tensions.iter_mut().zip(limits).for_each(|(f, (least, largest))| *f = f.clamp(*least, *largest));
    }

    /// Cable (from 0) and limit (N) that these tensions miss most; `None` if none is missed by more than rounding.
    pub(super) fn most_missed(&self, tensions: &[f64]) -> Option<(usize, f64)> {
        let (mut worst, mut found) = (self.tolerance(), None);
        for (cable, f) in tensions.iter().enumerate() {
            for (missed, limit) in
                [(self.minimum[cable] - f, self.minimum[cable]), (f - self.maximum[cable], self.maximum[cable])]
            {
                if missed > worst {
                    worst = missed;
                    found = Some((cable, limit));
                }
            }
        }
        found
    }

    /// Returns a sentence for each cable beyond a limit.
    pub(super) fn missed(&self, tensions: &[f64]) -> Vec<String> {
        let tolerance = self.tolerance();
        let beyond = |(index, &f): (usize, &f64)| {
            let (least, largest) = (self.minimum[index], self.maximum[index]);
            match (f < least - tolerance, f > largest + tolerance) {
                (true, _) => Some(format!("cable {} has {f:.1} N, its least tension is {least} N", index + 1)),
                (_, true) => Some(format!("cable {} has {f:.1} N, its largest tension is {largest} N", index + 1)),
                _ => None,
            }
        };
        tensions.iter().enumerate().filter_map(beyond).collect()
    }

    pub(super) fn diameter(&self) -> f64 {
        self.diameter
    }
}

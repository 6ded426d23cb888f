//! Stretches of time in which a cable is slack or its tension outside its limits.

use super::Recording;
use crate::number_format::significant;

/// A stretch of time in which a limit of one cable is broken, from the first moment of the record that shows it to the last.
#[derive(Clone, Debug, PartialEq)]
pub struct Violation {
    /// First and last moment (s).
    pub span: (f64, f64),
    /// Cable, from 0.
    pub cable: usize,
    /// Words with numbers.
    pub words: String,
}

/// Ways in which a tension is not as it should be.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Breach {
    Slack,
    Below,
    Above,
}

/// Moments of one breach that follow each other.
struct Stretch {
    breach: Breach,
    span: (f64, f64),
    /// Tension farthest from its limit (N).
    worst: f64,
}

impl Recording<'_> {
    /// All broken limits, by time and cable. A cable that broke is no violation: it is an event.
    pub fn violations(&self) -> Vec<Violation> {
        let cables = 0..self.robot.cables.len();
        let mut all: Vec<Violation> = cables.flat_map(|cable| self.of_cable(cable)).collect();
        all.sort_by(|a, b| a.span.0.total_cmp(&b.span.0).then(a.cable.cmp(&b.cable)));
        all
    }

    fn of_cable(&self, cable: usize) -> Vec<Violation> {
        let mut stretches: Vec<Stretch> = Vec::new();
        let mut last = None;
        for moment in &self.moments {
            let tension = moment.tensions[cable];
            let breach = self.breach(cable, tension).filter(|_| !self.is_broken(cable, moment.time));
            match (breach, stretches.last_mut()) {
                (Some(breach), Some(stretch)) if last == Some(breach) => {
                    stretch.span.1 = moment.time;
                    stretch.worst = match breach {
                        Breach::Above => stretch.worst.max(tension),
                        _ => stretch.worst.min(tension),
                    };
                }
                (Some(breach), _) => {
                    stretches.push(Stretch { breach, span: (moment.time, moment.time), worst: tension })
                }
                _ => {}
            }
            last = breach;
        }
        stretches.into_iter().map(|stretch| self.told(cable, &stretch)).collect()
    }

    fn breach(&self, cable: usize, tension: f64) -> Option<Breach> {
        let limits = self.limits.get(cable);
        match limits {
            _ if !(tension > 0.0) => Some(Breach::Slack),
            Some(&(least, _)) if tension < least => Some(Breach::Below),
            Some(&(_, largest)) if tension > largest => Some(Breach::Above),
            _ => None,
        }
    }

    fn told(&self, cable: usize, stretch: &Stretch) -> Violation {
        let name = &self.robot.cables[cable].name;
        let worst = significant(stretch.worst, 4);
        let limit = |pick: fn(&(f64, f64)) -> f64| significant(self.limits.get(cable).map_or(f64::NAN, pick), 4);
        let words = match stretch.breach {
            Breach::Slack => format!("cable {name} is slack"),
            Breach::Below => format!("cable {name} down to {worst} N, below its {} N", limit(|limits| limits.0)),
            Breach::Above => format!("cable {name} up to {worst} N, above its {} N", limit(|limits| limits.1)),
        };
        Violation { span: stretch.span, cable, words }
    }
}

//! Broken limits of a run in words, and cables that were slack.

use cdpr_model::robot::Robot;
use cdpr_plant as plant;
use schemars::JsonSchema;
use serde::Serialize;

use crate::number_format::{short, significant};

/// A limit that a cable broke, or a cable that was slack though no limit says that it must not be.
#[derive(Clone, Debug, PartialEq)]
pub struct Violation {
    /// Key of the robot file that states the limit; nothing of a slack cable, which breaks none.
    pub limit: Option<&'static str>,
    /// Limit (N); 0 of a slack cable.
    pub bound: f64,
    /// Cable, from 0.
    pub cable: usize,
    /// Time of the first step that shows it (s).
    pub first: f64,
    /// Tension farthest from the limit (N).
    pub worst: f64,
    /// Length of all steps that end with it (s).
    pub duration: f64,
    /// Words with numbers, as `cable 3 down to 733 N, below its 1000 N`.
    pub words: String,
    /// Stretches of time that show it, in their order.
    pub stretches: Vec<Stretch>,
}

/// Stretch of time in which a limit is broken.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Stretch {
    /// Time of the first step that shows it.
    pub from_s: f64,
    /// Time of the last step that shows it.
    pub to_s: f64,
    /// Words with its numbers.
    pub words: String,
}

impl Violation {
    /// Findings of a run in words: one for each cable and limit, by first time.
    pub fn all(found: &[plant::Violation], robot: &Robot) -> Vec<Self> {
        let mut all: Vec<Self> = Vec::new();
        for one in found {
            let words = words(one, robot);
            let stretch = Stretch { from_s: one.from, to_s: one.to, words: words.clone() };
            match all.iter_mut().find(|other| (other.cable, other.limit) == (one.cable, one.limit)) {
                Some(known) => {
                    // farther from the limit on its side
                    if (one.worst - one.bound).abs() > (known.worst - known.bound).abs() {
                        (known.worst, known.words) = (one.worst, words);
                    }
                    known.duration += one.duration;
                    known.stretches.push(stretch);
                }
                None => all.push(Self {
                    limit: one.limit,
                    bound: one.bound,
                    cable: one.cable,
                    first: one.from,
                    worst: one.worst,
                    duration: one.duration,
                    words,
                    stretches: vec![stretch],
                }),
            }
        }
        all
    }

    /// True of limits, false of cables that are slack.
    pub fn is_broken_limit(&self) -> bool {
        self.limit.is_some()
    }
}

fn words(found: &plant::Violation, robot: &Robot) -> String {
    let (name, worst) = (&robot.cables[found.cable].name, found.worst);
    let (tension, limit) = (significant(worst, 4), short(found.bound));
    match found.limit {
        None => format!("cable {name} is slack"),
        Some(_) if worst > found.bound => format!("cable {name} up to {tension} N, above its {limit} N"),
        Some(_) if worst > 0.0 => format!("cable {name} down to {tension} N, below its {limit} N"),
        Some(_) => format!("cable {name} slack, below its {limit} N"),
    }
}

/// Stretches of time in which limits are broken.
pub(crate) fn stretches_of_limits(all: &[Violation]) -> impl Iterator<Item = &Stretch> {
    all.iter().filter(|one| one.is_broken_limit()).flat_map(|one| &one.stretches)
}

/// One more broken limit, and several.
pub(crate) const OTHERS: [&str; 2] = ["limit is broken", "limits are broken"];

/// The first of several in a sentence, with the number of the others in their words; nothing of none.
pub(crate) fn sentence<'v>(mut all: impl Iterator<Item = &'v Violation>, others: [&str; 2]) -> Option<String> {
    let first = all.next()?;
    let more = match all.count() {
        0 => String::new(),
        1 => format!(", and one more {}", others[0]),
        count => format!(", and {count} more {}", others[1]),
    };
    let (from, duration) = (short(first.first), significant(first.duration, 3));
    Some(format!("{} from {from} s on, for {duration} s together{more}", first.words))
}

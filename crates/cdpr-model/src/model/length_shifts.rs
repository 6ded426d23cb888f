//! Changes of recorded lengths inside a record that identification may free: a step from a line on, and a drift.

use std::fmt;

/// Course of a change of recorded lengths over a record.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShiftCourse {
    /// A constant from this line of the data file on, the header being line 1.
    StepAt(usize),
    /// A change that grows with time, or with the line where rows have no times.
    Drift,
}

/// Change of one cable's recorded lengths (cable from 0) inside a record.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LengthShift {
    /// The cable, from 0.
    pub cable: usize,
    /// Its course.
    pub course: ShiftCourse,
}

/// Free changes of one course: of every cable, or of some.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct FreeShift {
    pub(super) course: ShiftCourse,
    /// 0-based; `None` means every cable.
    pub(super) cables: Option<Vec<usize>>,
}

/// Names in lists of parameters.
const STEP: &str = "length-offset";
const DRIFT: &str = "length-drift";

impl ShiftCourse {
    /// Names as lists of known parameters write them.
    pub(super) const NAMES: [&'static str; 2] = ["length-offset@LINE", DRIFT];

    /// Name as lists of known parameters write it.
    pub fn known_name(self) -> &'static str {
        match self {
            Self::StepAt(_) => Self::NAMES[0],
            Self::Drift => Self::NAMES[1],
        }
    }

    /// Name with the numbers of cables in brackets, or nothing.
    fn name(self, brackets: &str) -> String {
        match self {
            Self::StepAt(line) => format!("{STEP}{brackets}@{line}"),
            Self::Drift => format!("{DRIFT}{brackets}"),
        }
    }

    /// The course of a word and of what follows its brackets, with the rest of the text; `None` where it is none.
    pub(super) fn read<'t>(word: &str, after: &'t str) -> Option<(Self, &'t str)> {
        match (word, after.strip_prefix('@')) {
            (DRIFT, None) => Some((Self::Drift, after)),
            (STEP, Some(number)) => {
                let end = number.find(|letter: char| !letter.is_ascii_digit()).unwrap_or(number.len());
                // the header is line 1, so that nothing is before line 3
                let line = number[..end].parse().ok().filter(|line| *line > 2)?;
                Some((Self::StepAt(line), &number[end..]))
            }
            _ => None,
        }
    }
}

impl fmt::Display for LengthShift {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.course.name(&format!("[{}]", self.cable + 1)))
    }
}

impl fmt::Display for FreeShift {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let numbers = |cables: &Vec<usize>| {
            let numbers: Vec<String> = cables.iter().map(|cable| (cable + 1).to_string()).collect();
            format!("[{}]", numbers.join(","))
        };
        f.write_str(&self.course.name(&self.cables.as_ref().map_or_else(String::new, numbers)))
    }
}

impl FreeShift {
    /// True if the shift of a cable is one of these.
    pub(super) fn contains(&self, shift: LengthShift) -> bool {
        self.course == shift.course && self.cables.as_ref().is_none_or(|cables| cables.contains(&shift.cable))
    }
}

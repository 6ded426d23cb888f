//! Start of a search.

use crate::geometry::Pose;
use crate::reading::keywords;
use crate::robot::Robot;

/// Start of the search for a pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// The guess given by the caller.
    Guess,
    /// The home pose of the robot's file, since no guess is given.
    HomePose,
    /// The mean of the frame anchors, since there is neither guess nor home pose.
    MiddleOfAnchors,
}

keywords!(Start: Guess = "guess", HomePose = "home-pose", MiddleOfAnchors = "middle-of-anchors");

impl Start {
    /// Start of a search for a robot and an optional guess, with the pose there.
    pub fn of(robot: &Robot, guess: Option<&Pose>) -> (Self, Pose) {
        match (guess, robot.home) {
            (Some(guess), _) => (Self::Guess, *guess),
            (None, Some(home)) => (Self::HomePose, home),
            (None, None) => (Self::MiddleOfAnchors, robot.home_or_middle()),
        }
    }
}

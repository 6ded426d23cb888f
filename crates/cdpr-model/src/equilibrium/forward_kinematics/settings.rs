//! Settings of forward kinematics.

/// Settings of forward kinematics.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// The search stops once the pose is this near to the solution, judged by the last steps (m; angles times the
    /// platform radius).
    pub pose_tolerance: f64,
    /// Residual up to which a solution for m = n counts as exact: rms of the lengths (m), relative to their mean above
    /// 1 m.
    pub length_tolerance: f64,
    /// Steps allowed for each start.
    pub max_iterations: u32,
    /// Further starts allowed if the descent from the guess ends without an answer; 0 searches only from the guess.
    pub max_restarts: u32,
    /// For m > n: an rms residual, relative to the mean length, up to which errors of measurement explain it. A larger
    /// one is reason to look for an alternative; among further starts the first with a smaller one ends the search.
    pub suspicious_residual: f64,
    /// For m > n: an rms residual, relative to the mean length, above which the lengths do not belong to the robot.
    pub plausible_residual: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            pose_tolerance: 1e-10,
            length_tolerance: 1e-9,
            max_iterations: 100,
            max_restarts: 24,
            suspicious_residual: 1e-3,
            plausible_residual: 0.1,
        }
    }
}

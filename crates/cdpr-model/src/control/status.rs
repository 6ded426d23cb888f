//! Status of a machine's answer.

/// Outcome of a machine's forward problem for a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Status {
    /// The platform comes to rest at the pose.
    Converged,
    /// The control model has no lengths for the pose: a cable has no path, or no tensions within the limits balance the
    /// load.
    NotCommanded,
    /// The forward problem of the machine found no equilibrium.
    NotConverged,
    /// The machine's lengths do not determine its pose.
    Singular,
    /// The equilibrium found is unstable.
    Unstable,
}

impl Status {
    /// The status as written in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::NotCommanded => "not-commanded",
            Self::NotConverged => "not-converged",
            Self::Singular => "singular",
            Self::Unstable => "unstable",
        }
    }
}

//! Status of a machine's answer.

/// How the answer of a machine was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
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
    /// The equilibrium found would not last.
    Unstable,
}

impl Status {
    /// The word that answers use.
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

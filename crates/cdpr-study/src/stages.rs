//! Names of the chain's stages, which study files use.

/// The stages of the chain in their order.
pub(crate) const STAGES: [&str; 12] = [
    "reference",
    "identified",
    "driven",
    "identified-again",
    "constant-orientation",
    "reduced-nominal",
    "reduced-identified",
    "elastostatic-nominal",
    "elastostatic-identified",
    "force-control",
    "force-control-edges",
    "kinematic-edges",
];

//! Circles that stay for a while, each with its reason.

/// A use of a file by another one that closes a circle and is allowed for now.
pub(crate) struct Known {
    /// The crate's folder.
    pub(crate) folder: &'static str,
    /// The two files, by their places under `src`.
    pub(crate) from: &'static str,
    pub(crate) to: &'static str,
    pub(crate) reason: &'static str,
}

const ESTIMATION: &str =
    "three ways of a fit choose among each other by `if`; one problem with residuals replaces them";

/// The uses without which no file leads back to itself.
pub(crate) const KNOWN: &[Known] = &[
    Known { folder: "crates/cdpr-calibration", from: "fit.rs", to: "elastostatic/analysis.rs", reason: ESTIMATION },
    Known { folder: "crates/cdpr-calibration", from: "fit.rs", to: "objective/report.rs", reason: ESTIMATION },
    Known {
        folder: "crates/cdpr-calibration",
        from: "fit/checks.rs",
        to: "elastostatic/analysis.rs",
        reason: ESTIMATION,
    },
    Known {
        folder: "crates/cdpr-calibration",
        from: "fit/frames/rows.rs",
        to: "elastostatic/pose_rows.rs",
        reason: ESTIMATION,
    },
];

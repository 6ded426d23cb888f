//! Kinds of pages.

/// Kind of a page, which its body names. The browser test opens pages of every kind that is named here (`xtask/src/browser/pages.rs`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PageKind {
    /// Candidates and the model that is shown: `cdpr select`, `demo`, `identify`.
    Report,
    /// Workspaces: `cdpr workspace`.
    Workspace,
    /// Errors over commanded poses: `cdpr study`.
    Study,
    /// A machine in time: `cdpr run`.
    Run,
    /// Measurements in rounds: `cdpr campaign`.
    Campaign,
    /// Stages from the nominal controller to force control: `cdpr chain`.
    Chain,
    /// Robots and models under the same rules: `cdpr benchmark`.
    Benchmark,
    /// Payload, acceleration and speed in a box: `cdpr capability`.
    Capability,
    /// Gain, phase and coherence over frequency: `cdpr frequency-response`.
    Response,
}

impl PageKind {
    /// Word for it in the page.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Report => "report",
            Self::Workspace => "workspace",
            Self::Study => "study",
            Self::Run => "run",
            Self::Campaign => "campaign",
            Self::Chain => "chain",
            Self::Benchmark => "benchmark",
            Self::Capability => "capability",
            Self::Response => "response",
        }
    }
}

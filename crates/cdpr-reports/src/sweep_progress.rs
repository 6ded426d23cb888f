//! A sweep on its way: what is planned or computed of it.

use schemars::JsonSchema;
use serde::Serialize;

use crate::answers::Answer;

/// Points of a sweep that are planned, or of a shard that are computed.
#[derive(Serialize, JsonSchema)]
pub struct SweepProgress {
    status: &'static str,
    /// Folder of the sweep.
    folder: String,
    /// Number of points of the sweep.
    points: usize,
    /// Points that were computed now.
    computed: usize,
    /// Points that had been computed before.
    already_there: usize,
    /// Names of the files that the rows of all points will have, in the folder `rows` beside the plan.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    row_files: Vec<String>,
    #[serde(skip)]
    words: String,
}

impl SweepProgress {
    /// A sweep that is planned in a folder, with a file of this name for each point.
    pub fn planned(folder: String, row_files: Vec<String>) -> Self {
        let points = row_files.len();
        let words =
            format!("planned {points} points\nnext: cdpr sweep run {folder}; then: cdpr sweep merge {folder}\n");
        Self { status: "planned", folder, points, computed: 0, already_there: 0, row_files, words }
    }

    /// A shard in a folder, some of whose points were there before.
    pub fn computed(folder: String, computed: usize, already_there: usize) -> Self {
        let points = computed + already_there;
        let words = format!("{points} points: {computed} computed, {already_there} already there\n");
        Self { status: "computed", folder, points, computed, already_there, row_files: Vec::new(), words }
    }
}

impl Answer for SweepProgress {
    fn words(&self, _width: Option<usize>) -> String {
        self.words.clone()
    }
}

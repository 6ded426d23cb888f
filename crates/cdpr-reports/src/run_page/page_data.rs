//! The data that the program of the page plays back: one JSON block, which `viewer/src/data.ts` describes.

use schemars::JsonSchema;
use serde::Serialize;

use crate::answers::RunAnswer;
use crate::html_page::{PageKind, RobotPicture, data_block, digits, quaternion, vector};
use crate::recording::{Occurrence, Recording, Stretch, Violation, stretches_of_limits};

/// Numbers that a page may hold for its moments (about 9 bytes each).
const MOST_NUMBERS: usize = 120_000;

/// Data of a run: the answer, and what its pictures need besides.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "RunData")]
pub(crate) struct PageData<'a> {
    /// Kind of the page.
    #[schemars(extend("const" = "run"))]
    page: &'static str,
    result: &'a RunAnswer,
    robot: RobotPicture,
    moments: MomentData,
    /// Events that happened, in order of time.
    events: &'a [Occurrence],
    /// Stretches of time in which a limit is broken, in order of time.
    broken_limits: Vec<&'a Stretch>,
}

/// State of the machine at the moments that the page holds, in order of time.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Moments")]
#[expect(non_snake_case, reason = "the fields are the keys of the page, units included")]
struct MomentData {
    time_s: Vec<f64>,
    position_m: Vec<[f64; 3]>,
    quaternion_xyzw: Vec<[f64; 4]>,
    /// Per cable.
    tensions_N: Vec<Vec<f64>>,
}

/// The block; moments evenly thinned out to what a page may hold, the last one stays.
pub(super) fn json(answer: &RunAnswer, recording: &Recording<'_>, violations: &[Violation]) -> String {
    let mut broken_limits: Vec<&Stretch> = stretches_of_limits(violations).collect();
    broken_limits.sort_by(|a, b| a.from_s.total_cmp(&b.from_s));
    data_block(&PageData {
        page: PageKind::Run.name(),
        result: answer,
        robot: RobotPicture::of(recording.robot, &recording.limits),
        moments: moments(recording),
        events: &recording.events,
        broken_limits,
    })
}

fn moments(recording: &Recording<'_>) -> MomentData {
    let all = &recording.moments;
    let step = (all.len() * (8 + recording.robot.cables.len())).div_ceil(MOST_NUMBERS).max(1);
    let last = all.len().saturating_sub(1);
    let kept: Vec<_> =
        all.iter().enumerate().filter(|(index, _)| index % step == 0 || *index == last).map(|(_, one)| one).collect();
    let tensions = |of: &[f64]| of.iter().map(|tension| digits(*tension, 5)).collect();
    MomentData {
        time_s: kept.iter().map(|moment| digits(moment.time, 9)).collect(),
        position_m: kept.iter().map(|moment| vector(&moment.pose.position, 6)).collect(),
        quaternion_xyzw: kept.iter().map(|moment| quaternion(&moment.pose, 6)).collect(),
        tensions_N: kept.iter().map(|moment| tensions(&moment.tensions)).collect(),
    }
}

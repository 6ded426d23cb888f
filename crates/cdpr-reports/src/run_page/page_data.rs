//! The data that the program of the page plays back: one JSON block. `viewer/src/run/data.ts` is its reader.

use serde::Serialize;

use crate::html_page::{CableData, PlaneData, digits, inside_script, plain, vector};
use crate::recording::{Recording, Stretch, Violation, stretches_of_limits};

/// Numbers that a page may hold for its moments (about 9 bytes each).
const MOST_NUMBERS: usize = 120_000;

#[derive(Serialize)]
struct PageData {
    page: &'static str,
    robot: RobotData,
    moments: MomentData,
    events: Vec<EventData>,
    violations: Vec<ViolationData>,
}

#[derive(Serialize)]
struct RobotData {
    name: String,
    plane: Option<PlaneData>,
    cables: Vec<CableData>,
}

#[derive(Serialize)]
#[expect(non_snake_case, reason = "the fields are the keys of the page, units included")]
struct MomentData {
    time_s: Vec<f64>,
    position_m: Vec<[f64; 3]>,
    quaternion_xyzw: Vec<[f64; 4]>,
    tensions_N: Vec<Vec<f64>>,
}

#[derive(Serialize)]
struct EventData {
    time_s: f64,
    words: String,
    cable: Option<usize>,
    breaks: bool,
}

#[derive(Serialize)]
struct ViolationData {
    from_s: f64,
    to_s: f64,
    words: String,
}

/// The block as text that may stand inside a `script` element; moments evenly thinned out to what a page may hold, the last one stays.
pub(super) fn json(recording: &Recording<'_>, violations: &[Violation]) -> String {
    let robot = recording.robot;
    let cable = |(index, cable)| CableData::of(cable, recording.limits.get(index).copied());
    let data = PageData {
        page: "run",
        robot: RobotData {
            name: plain(&robot.name),
            plane: PlaneData::of(robot),
            cables: robot.cables.iter().enumerate().map(cable).collect(),
        },
        moments: moments(recording),
        events: recording
            .events
            .iter()
            .map(|event| EventData {
                time_s: event.time,
                words: plain(&event.words),
                cable: event.cable,
                breaks: event.breaks,
            })
            .collect(),
        violations: stretches(violations),
    };
    inside_script(&serde_json::to_string(&data).expect("strings and numbers only"))
}

/// Stretches of time in which a limit is broken, by time.
fn stretches(violations: &[Violation]) -> Vec<ViolationData> {
    let told = |one: &Stretch| ViolationData { from_s: one.span.0, to_s: one.span.1, words: plain(&one.words) };
    let mut all: Vec<ViolationData> = stretches_of_limits(violations).map(told).collect();
    all.sort_by(|a, b| a.from_s.total_cmp(&b.from_s));
    all
}

fn moments(recording: &Recording<'_>) -> MomentData {
    let all = &recording.moments;
    let step = (all.len() * (8 + recording.robot.cables.len())).div_ceil(MOST_NUMBERS).max(1);
    let last = all.len().saturating_sub(1);
    let kept: Vec<_> =
        all.iter().enumerate().filter(|(index, _)| index % step == 0 || *index == last).map(|(_, one)| one).collect();
    MomentData {
        time_s: kept.iter().map(|moment| digits(moment.time, 9)).collect(),
        position_m: kept.iter().map(|moment| vector(&moment.pose.position, 6)).collect(),
        quaternion_xyzw: kept
            .iter()
            .map(|moment| <[f64; 4]>::from(moment.pose.rotation.coords).map(|part| digits(part, 6)))
            .collect(),
        tensions_N: kept
            .iter()
            .map(|moment| moment.tensions.iter().map(|tension| digits(*tension, 5)).collect())
            .collect(),
    }
}

//! Messages of a recording in the words of Foxglove's schemas, as JSON; frames `world` and `platform`.

use cdpr_model::geometry::Pose;
use nalgebra::Vector3;
use serde::Serialize;
use serde_json::{Value, json};

use super::{Moment, Recording};
use crate::figures::colour;

/// Thickness of cables in the scene (pixels of the screen).
const CABLE: f64 = 2.5;

/// Size of the balls at anchors, as a share of the frame's diagonal.
const BALL: f64 = 0.006;

/// Kind of a line whose points are taken two by two.
const LINE_LIST: u8 = 2;

/// Kinds of messages of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Topic {
    /// Pose of the platform.
    Pose,
    /// Place of the platform's frame in the world.
    Transform,
    /// Cables, platform and anchors.
    Scene,
    /// Tensions of all cables.
    Tensions,
    /// Events in words.
    Events,
}

impl Topic {
    /// All, in the order of a file.
    pub(super) const ALL: [Self; 5] = [Self::Pose, Self::Transform, Self::Scene, Self::Tensions, Self::Events];

    /// Name of the topic and of its schema.
    pub(super) fn names(self) -> (&'static str, &'static str) {
        match self {
            Self::Pose => ("/platform", "foxglove.PoseInFrame"),
            Self::Transform => ("/tf", "foxglove.FrameTransforms"),
            Self::Scene => ("/scene", "foxglove.SceneUpdate"),
            Self::Tensions => ("/tensions", "cdpr.Tensions"),
            Self::Events => ("/events", "foxglove.Log"),
        }
    }

    /// JSON Schema of the messages: the fields that are written.
    pub(super) fn schema(self) -> Value {
        let object = |properties: Value| json!({ "type": "object", "properties": properties });
        let list = |items: Value| json!({ "type": "array", "items": items });
        let [number, whole, text] = ["number", "integer", "string"].map(|kind| json!({ "type": kind }));
        let time = object(json!({ "sec": whole, "nsec": whole }));
        let vector = object(json!({ "x": number, "y": number, "z": number }));
        let turn = object(json!({ "x": number, "y": number, "z": number, "w": number }));
        let pose = object(json!({ "position": vector, "orientation": turn }));
        let ink = object(json!({ "r": number, "g": number, "b": number, "a": number }));
        let properties = match self {
            Self::Pose => json!({ "timestamp": time, "frame_id": text, "pose": pose }),
            Self::Transform => json!({ "transforms": list(object(json!({
                "timestamp": time, "parent_frame_id": text, "child_frame_id": text, "translation": vector, "rotation": turn,
            }))) }),
            Self::Scene => {
                let line = object(json!({
                    "type": whole, "pose": pose, "thickness": number, "scale_invariant": { "type": "boolean" },
                    "points": list(vector.clone()), "color": ink, "colors": list(ink.clone()), "indices": list(whole),
                }));
                let ball = object(json!({ "pose": pose, "size": vector, "color": ink }));
                let entity = object(json!({
                    "timestamp": time, "frame_id": text, "id": text, "lifetime": time, "frame_locked": { "type": "boolean" },
                    "metadata": list(json!({})), "arrows": list(json!({})), "cubes": list(json!({})), "spheres": list(ball),
                    "cylinders": list(json!({})), "lines": list(line), "triangles": list(json!({})), "texts": list(json!({})),
                    "models": list(json!({})),
                }));
                json!({ "deletions": list(json!({})), "entities": list(entity) })
            }
            Self::Tensions => json!({ "timestamp": time, "tension_N": list(number) }),
            Self::Events => json!({ "timestamp": time, "level": whole, "message": text, "name": text }),
        };
        json!({ "title": self.names().1, "type": "object", "properties": properties })
    }
}

/// Nanoseconds of a time (s).
pub(super) fn nanoseconds(time: f64) -> u64 {
    (time.max(0.0) * 1e9).round() as u64
}

#[derive(Clone, Copy, Serialize)]
struct Timestamp {
    sec: u64,
    nsec: u64,
}

impl Timestamp {
    fn of(time: f64) -> Self {
        let all = nanoseconds(time);
        Self { sec: all / 1_000_000_000, nsec: all % 1_000_000_000 }
    }
}

/// Components of a point.
#[derive(Clone, Copy, Serialize)]
struct Point {
    x: f64,
    y: f64,
    z: f64,
}

impl From<&Vector3<f64>> for Point {
    fn from(vector: &Vector3<f64>) -> Self {
        Self { x: vector.x, y: vector.y, z: vector.z }
    }
}

fn pose(pose: &Pose) -> Value {
    let turn = pose.rotation.coords;
    json!({
        "position": Point::from(&pose.position),
        "orientation": { "x": turn.x, "y": turn.y, "z": turn.z, "w": turn.w },
    })
}

/// Pose of the platform in the world.
pub(super) fn platform(moment: &Moment) -> Value {
    json!({ "timestamp": Timestamp::of(moment.time), "frame_id": "world", "pose": pose(&moment.pose) })
}

/// The platform's frame in the world.
pub(super) fn transforms(moment: &Moment) -> Value {
    let placed = pose(&moment.pose);
    json!({ "transforms": [{
        "timestamp": Timestamp::of(moment.time), "parent_frame_id": "world", "child_frame_id": "platform",
        "translation": placed["position"], "rotation": placed["orientation"],
    }] })
}

/// Tensions of all cables (N).
pub(super) fn tensions(moment: &Moment) -> Value {
    json!({ "timestamp": Timestamp::of(moment.time), "tension_N": moment.tensions })
}

/// An event in words; level 2 is information, 3 a warning, 4 an error.
pub(super) fn event(time: f64, words: &str, level: u8) -> Value {
    json!({ "timestamp": Timestamp::of(time), "level": level, "message": words, "name": "cdpr" })
}

impl Recording<'_> {
    /// Least and largest tension of the colours of each cable (N): its limits, or nothing and the largest tension of the record.
    pub(super) fn tension_range(&self) -> Vec<(f64, f64)> {
        if !self.limits.is_empty() {
            return self.limits.clone();
        }
        let largest = self.moments.iter().flat_map(|moment| &moment.tensions).copied().fold(0.0, f64::max);
        vec![(0.0, largest); self.robot.cables.len()]
    }

    /// True after an event that took the cable away.
    fn is_broken(&self, cable: usize, time: f64) -> bool {
        self.events.iter().any(|event| event.breaks && event.cable == Some(cable) && event.time < time)
    }

    /// Frame anchors and platform, which stand still in their frames.
    pub(super) fn standing_scene(&self, time: f64) -> Value {
        let cables = &self.robot.cables;
        let frame: Vec<Vector3<f64>> = cables.iter().map(|cable| cable.frame_anchor).collect();
        let platform: Vec<Vector3<f64>> = cables.iter().map(|cable| cable.platform_anchor).collect();
        let first = frame.first().copied().unwrap_or_default();
        let size = BALL * frame.iter().map(|anchor| (anchor - first).norm()).fold(0.1, f64::max);
        let spokes: Vec<Point> =
            platform.iter().flat_map(|anchor| [Point::from(&Vector3::zeros()), Point::from(anchor)]).collect();
        json!({ "deletions": [], "entities": [
            entity(time, ("frame", "world"), json!([]), balls(&frame, size)),
            entity(time, ("body", "platform"), json!([line(&spokes, &[])]), balls(&platform, size)),
        ] })
    }

    /// Cables by tension within the range of each (N), those that are slack red.
    pub(super) fn moving_scene(&self, moment: &Moment, range: &[(f64, f64)]) -> Value {
        let (mut points, mut colours) = (Vec::new(), Vec::new());
        for (index, cable) in self.robot.cables.iter().enumerate() {
            if self.is_broken(index, moment.time) {
                continue;
            }
            let end = moment.pose.position + moment.pose.rotation * cable.platform_anchor;
            points.extend([Point::from(&cable.frame_anchor), Point::from(&end)]);
            let ink = ink(moment.tensions[index], range[index]);
            colours.extend([ink.clone(), ink]);
        }
        let cables = entity(moment.time, ("cables", "world"), json!([line(&points, &colours)]), json!([]));
        json!({ "deletions": [], "entities": [cables] })
    }
}

/// Colour of a tension between the least and the largest one (N).
fn ink(tension: f64, (least, largest): (f64, f64)) -> Value {
    match tension > 0.0 {
        true => ink_of(&colour::at(0.25 + 0.75 * (tension - least) / (largest - least).max(1e-9))),
        false => ink_of("#b3261e"),
    }
}

fn ink_of(colour: &str) -> Value {
    let channel = |at: usize| f64::from(u8::from_str_radix(&colour[at..at + 2], 16).unwrap_or(0)) / 255.0;
    json!({ "r": channel(1), "g": channel(3), "b": channel(5), "a": 1.0 })
}

fn line(points: &[Point], colours: &[Value]) -> Value {
    json!({
        "type": LINE_LIST, "pose": pose(&Pose::identity()), "thickness": CABLE, "scale_invariant": true, "points": points,
        "color": ink_of("#57606a"), "colors": colours, "indices": [],
    })
}

fn balls(centres: &[Vector3<f64>], size: f64) -> Value {
    let ball = |centre: &Vector3<f64>| {
        let placed = Pose { position: *centre, ..Pose::identity() };
        json!({ "pose": pose(&placed), "size": { "x": size, "y": size, "z": size }, "color": ink_of("#1b1f24") })
    };
    centres.iter().map(ball).collect()
}

fn entity(time: f64, (id, frame): (&str, &str), lines: Value, spheres: Value) -> Value {
    json!({
        "timestamp": Timestamp::of(time), "frame_id": frame, "id": id, "lifetime": { "sec": 0, "nsec": 0 }, "frame_locked": true,
        "metadata": [], "arrows": [], "cubes": [], "spheres": spheres, "cylinders": [], "lines": lines, "triangles": [],
        "texts": [], "models": [],
    })
}

//! The MCAP file of a recording, for Foxglove and every other reader of the format.

use std::collections::BTreeMap;
use std::io::Cursor;

use mcap::records::MessageHeader;
use mcap::write::{WriteOptions, Writer};
use serde_json::Value;
use thiserror::Error;

use super::messages::{self, Topic, nanoseconds};
use super::{Recording, SCENES_PER_SECOND, Stretch, Violation};

/// A recording that could not be written.
#[derive(Debug, Error)]
#[error("the recording cannot be written as MCAP: {0}")]
pub struct McapError(#[from] mcap::McapError);

impl Recording<'_> {
    /// Bytes of an MCAP file: pose (`/platform`), frames (`/tf`), scene (`/scene`), tensions (`/tensions`, N) and events with broken limits
    /// (`/events`), as JSON with schemas; times count from the start of the run.
    pub fn mcap(&self, violations: &[Violation]) -> Result<Vec<u8>, McapError> {
        let options = WriteOptions::new().compression(None);
        let mut file = File { writer: options.create(Cursor::new(Vec::new()))?, channels: Vec::new(), count: 0 };
        for topic in Topic::ALL {
            let (name, schema) = topic.names();
            let schema = file.writer.add_schema(schema, "jsonschema", topic.schema().to_string().as_bytes())?;
            file.channels.push(file.writer.add_channel(schema, name, "json", &BTreeMap::new())?);
        }
        let mut told = self.happenings(violations).into_iter().peekable();
        let range = self.tension_range();
        let mut next_scene = f64::NEG_INFINITY;
        for (index, moment) in self.moments.iter().enumerate() {
            while let Some((time, message)) = told.next_if(|(time, _)| *time <= moment.time) {
                file.write(Topic::Events, time, &message)?;
            }
            if index == 0 {
                file.write(Topic::Scene, moment.time, &self.standing_scene(moment.time))?;
            }
            file.write(Topic::Pose, moment.time, &messages::platform(moment))?;
            file.write(Topic::Transform, moment.time, &messages::transforms(moment))?;
            file.write(Topic::Tensions, moment.time, &messages::tensions(moment))?;
            if moment.time >= next_scene {
                file.write(Topic::Scene, moment.time, &self.moving_scene(moment, &range))?;
                next_scene = moment.time + 1.0 / SCENES_PER_SECOND;
            }
        }
        for (time, message) in told {
            file.write(Topic::Events, time, &message)?;
        }
        file.writer.finish()?;
        Ok(file.writer.into_inner().into_inner())
    }

    /// Events, and the beginnings of all stretches of time in which a limit is broken or a cable slack, by time.
    fn happenings(&self, violations: &[Violation]) -> Vec<(f64, Value)> {
        let events = self.events.iter().map(|event| (event.time, messages::event(event.time, &event.words, 2)));
        let broken = violations.iter().flat_map(|one| {
            let level = if one.is_broken_limit() { 4 } else { 3 };
            let event = move |stretch: &Stretch| messages::event(stretch.from_s, &stretch.words, level);
            one.stretches.iter().map(move |stretch| (stretch.from_s, event(stretch)))
        });
        let mut all: Vec<(f64, Value)> = events.chain(broken).collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        all
    }
}

struct File {
    writer: Writer<Cursor<Vec<u8>>>,
    channels: Vec<u16>,
    count: u32,
}

impl File {
    fn write(&mut self, topic: Topic, time: f64, message: &Value) -> Result<(), McapError> {
        let place = Topic::ALL.iter().position(|other| *other == topic).unwrap_or_default();
        let log_time = nanoseconds(time);
        let header =
            MessageHeader { channel_id: self.channels[place], sequence: self.count, log_time, publish_time: log_time };
        self.count = self.count.wrapping_add(1);
        Ok(self.writer.write_to_known_channel(&header, message.to_string().as_bytes())?)
    }
}

#[cfg(test)]
mod tests {
    use cdpr_model::geometry::Pose;
    use cdpr_model::robot::Robot;
    use cdpr_plant as plant;
    use nalgebra::Vector3;

    use super::super::{Moment, Occurrence, Recording, Violation, mcap_bytes};

    fn recording(robot: &Robot, count: u32) -> Recording<'_> {
        let cables = robot.cables.len();
        let moment = |k: u32| {
            let time = 0.01 * f64::from(k);
            let pose = Pose { position: Vector3::new(0.1 * time.sin(), 0.0, 1.5), ..robot.home.unwrap() };
            let mut tensions = vec![2000.0 + 10.0 * f64::from(k); cables];
            // slack from 0.5 s to 0.6 s, broken from 1 s on
            tensions[1] = if (50..=60).contains(&k) { 0.0 } else { 1500.0 };
            tensions[2] = if k > 100 { 0.0 } else { 1500.0 };
            Moment { time, pose, tensions }
        };
        let broken = Occurrence { time: 1.0, words: "cable 3 breaks".to_owned(), cable: Some(2), breaks: true };
        let limits = vec![(1000.0, 3000.0); cables];
        Recording { robot, moments: (0..=count).map(moment).collect(), events: vec![broken], limits }
    }

    /// A stretch of time in which a cable breaks a limit.
    fn found(
        cable: usize,
        (limit, bound): (Option<&'static str>, f64),
        (from, to, worst): (f64, f64, f64),
    ) -> plant::Violation {
        plant::Violation { cable, limit, bound, from, to, duration: to - from, worst }
    }

    /// Read back by the format's own reader: every message at its time, in the words of the schemas.
    #[test]
    fn the_file_holds_every_moment_and_the_beginning_of_every_broken_limit() {
        let robot = Robot::builtin("cablerobot-simulator-helicopter").unwrap();
        let recording = recording(&robot, 150);
        let [low, high] = [(Some("tension_min_N"), 1000.0), (Some("tension_max_N"), 3000.0)];
        let all = [
            found(1, low, (0.5, 0.6, 0.0)),
            found(1, low, (0.8, 0.8, 733.2)),
            found(4, high, (1.01, 1.5, 3500.0)),
            found(5, (None, 0.0), (1.2, 1.3, 0.0)),
        ];
        let violations = Violation::all(&all, &robot);
        assert_eq!(violations.len(), 3, "one for each cable and limit");
        assert!(violations[0].words.contains("slack, below its 1000 N"), "{:?}", violations[0]);
        let bytes = recording.mcap(&violations).unwrap();
        assert_eq!(bytes, recording.mcap(&violations).unwrap(), "the same bytes again");
        let mut counts = std::collections::BTreeMap::new();
        let (mut last, mut events) = (0, Vec::new());
        for message in mcap::MessageStream::new(&bytes).unwrap() {
            let message = message.unwrap();
            let value: serde_json::Value = serde_json::from_slice(&message.data).unwrap();
            assert!(message.log_time >= last, "in order of time");
            last = message.log_time;
            *counts.entry(message.channel.topic.clone()).or_insert(0) += 1;
            match message.channel.topic.as_str() {
                "/tensions" if message.log_time == 550_000_000 => {
                    assert_eq!(value["tension_N"][1], 0.0);
                    assert_eq!(value["timestamp"]["nsec"], 550_000_000);
                }
                "/scene" if message.log_time > 1_000_000_000 => {
                    let points = value["entities"][0]["lines"][0]["points"].as_array().unwrap();
                    assert_eq!(points.len(), 2 * (robot.cables.len() - 1), "the broken cable is gone");
                }
                "/events" => events.push((
                    message.log_time / 1_000_000,
                    value["level"].as_u64().unwrap(),
                    value["message"].to_string(),
                )),
                _ => {}
            }
        }
        assert_eq!(counts["/platform"], 151);
        assert_eq!(counts["/tf"], 151);
        assert_eq!(
            counts["/scene"],
            1 + 151_usize.div_ceil(4),
            "every fourth moment: no more than 30 pictures a second"
        );
        let times: Vec<(u64, u64)> = events.iter().map(|(time, level, _)| (*time, *level)).collect();
        assert_eq!(times, [(500, 4), (800, 4), (1000, 2), (1010, 4), (1200, 3)], "{events:?}");
        assert!(events[1].2.contains("down to 733.2 N") && events[3].2.contains("up to 3500 N"), "{events:?}");
    }

    /// Size told before a run against that of the file afterwards: numbers of this record are shorter than those of runs, which agree within 5 %.
    #[test]
    fn the_size_of_the_file_is_known_before_it() {
        for name in ["cablerobot-simulator-helicopter", "planar-example"] {
            let robot = Robot::builtin(name).unwrap();
            let bytes = recording(&robot, 3000).mcap(&[]).unwrap().len() as f64;
            let told = mcap_bytes(robot.cables.len(), 3001, 30.0) as f64;
            assert!((0.9..1.5).contains(&(told / bytes)), "{name}: {told} told, {bytes} written");
        }
    }
}

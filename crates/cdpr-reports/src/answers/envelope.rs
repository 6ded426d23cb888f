//! Keys of every JSON answer besides its own: program, layout, status, robot, warnings.

use std::fmt;

use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::value::{RawValue, to_raw_value};

/// Name and version of the program, as results keep them.
pub const PROGRAM: &str = concat!("cdpr ", env!("CARGO_PKG_VERSION"));

/// Source of virtual measurements, as their sidecars name it.
pub fn simulated_by() -> String {
    format!("simulated by {PROGRAM}")
}

/// Version of the keys of JSON answers: raised when a key goes or changes its meaning, not when one is added.
const LAYOUT_VERSION: u32 = 1;

/// Facts of a run besides the answer of its command.
#[derive(Default)]
pub struct Envelope<'a> {
    /// Name of the robot that the command asks about.
    pub robot: Option<&'a str>,
    /// Remarks told on stderr.
    pub remarks: &'a [String],
    /// The status of an answer that states none.
    pub status: &'a str,
}

impl Envelope<'_> {
    /// The answer as one JSON object in one line.
    pub fn line(&self, answer: &impl Serialize) -> Result<String, serde_json::Error> {
        serde_json::to_string(&self.around(&serde_json::to_string(answer)?)?)
    }

    /// The answer as one JSON object for a file.
    pub fn file(&self, answer: &impl Serialize) -> Result<String, serde_json::Error> {
        // raw values keep the indentation that they had at the same depth
        serde_json::to_string_pretty(&self.around(&serde_json::to_string_pretty(answer)?)?).map(|text| text + "\n")
    }

    /// The keys of the answer in their order, behind those that every answer has; its own status and robot win.
    fn around(&self, answer: &str) -> Result<Keys, serde_json::Error> {
        let Keys(own) = serde_json::from_str(answer)?;
        let mut warnings: Vec<String> = Vec::new();
        let (mut status, mut robot) = (to_raw_value(self.status)?, self.robot.map(to_raw_value).transpose()?);
        let mut own_remark: Option<String> = None;
        let mut rest = Vec::new();
        for (key, value) in own {
            match key.as_str() {
                "status" => status = value,
                "robot" => robot = Some(value),
                "warnings" => warnings = serde_json::from_str(value.get())?,
                "remark" => {
                    own_remark = serde_json::from_str(value.get())?;
                    rest.push((key, value));
                }
                _ => rest.push((key, value)),
            }
        }
        for remark in own_remark.iter().chain(self.remarks) {
            if !warnings.contains(remark) {
                warnings.push(remark.clone());
            }
        }
        let mut keys = vec![
            ("program".to_owned(), to_raw_value(PROGRAM)?),
            ("layout_version".to_owned(), to_raw_value(&LAYOUT_VERSION)?),
            ("status".to_owned(), status),
        ];
        keys.extend(robot.map(|robot| ("robot".to_owned(), robot)));
        keys.append(&mut rest);
        keys.push(("warnings".to_owned(), to_raw_value(&warnings)?));
        Ok(Keys(keys))
    }
}

/// Keys of a JSON object in their order, with their values as they are written.
struct Keys(Vec<(String, Box<RawValue>)>);

impl Serialize for Keys {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        self.0.iter().try_for_each(|(key, value)| map.serialize_entry(key, value))?;
        map.end()
    }
}

impl<'de> Deserialize<'de> for Keys {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct InOrder;

        impl<'de> Visitor<'de> for InOrder {
            type Value = Keys;

            fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
                formatter.write_str("an object")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Keys, A::Error> {
                let mut keys = Vec::new();
                while let Some(entry) = map.next_entry()? {
                    keys.push(entry);
                }
                Ok(Keys(keys))
            }
        }

        deserializer.deserialize_map(InOrder)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(serde::Serialize)]
    struct Own {
        zeta: f64,
        status: &'static str,
        warnings: [&'static str; 1],
        remark: &'static str,
        alpha: [u8; 2],
    }

    const OWN: Own = Own { zeta: f64::NAN, status: "found", warnings: ["own"], remark: "odd", alpha: [1, 2] };

    #[test]
    fn own_keys_keep_their_order_and_win_and_remarks_follow_own_warnings() {
        let remarks = ["own".to_owned(), "told".to_owned()];
        let line = Envelope { robot: Some("crane"), remarks: &remarks, status: "done" }.line(&OWN).unwrap();
        let expected = format!(
            r#"{{"program":"{PROGRAM}","layout_version":1,"status":"found","robot":"crane","zeta":null,"remark":"odd","alpha":[1,2],"warnings":["own","odd","told"]}}"#
        );
        assert_eq!(line, expected);
    }

    #[test]
    fn the_object_for_a_file_is_indented_throughout() {
        let file = Envelope::default().file(&OWN).unwrap();
        let value: serde_json::Value = serde_json::from_str(&file).unwrap();
        assert!(value.get("robot").is_none(), "{file}");
        assert!(file.contains("\n  \"alpha\": [\n    1,\n    2\n  ],\n"), "{file}");
    }
}

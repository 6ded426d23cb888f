//! Free parameters in plain words, for headlines: "frame and platform anchors, offsets, stiffness, load".

use super::{FreeParameters, RecordingParameter};
use crate::robot::ParameterKind;

impl FreeParameters {
    /// The selections in plain words, with the cables where only some are free; empty where nothing is.
    pub fn plain_words(&self) -> String {
        let mut words: Vec<String> = Vec::new();
        let mut is_of_anchors = false;
        for (kind, cables) in &self.selections {
            let places = cables.as_ref().map(|cables| {
                let numbers: Vec<String> = cables.iter().map(|cable| (cable + 1).to_string()).collect();
                format!(" [{}]", numbers.join(","))
            });
            let own = plural(*kind) + &places.clone().unwrap_or_default();
            match words.last_mut() {
                // two kinds of anchors of all cables in a row share their noun
                Some(last) if is_of_anchors && *kind == ParameterKind::PlatformAnchor && places.is_none() => {
                    *last = "frame and platform anchors".to_owned();
                }
                _ => words.push(own),
            }
            is_of_anchors = *kind == ParameterKind::FrameAnchor && places.is_none();
        }
        let recorded = self.recorded().map(|parameter| match parameter {
            RecordingParameter::ClockOffset => "clock".to_owned(),
            other => other.name().replace('-', " "),
        });
        words.extend(recorded);
        words.extend(self.shifts.iter().map(|shift| shift.to_string().replacen('-', " ", 1)));
        words.join(", ")
    }
}

/// A kind of parameters of all cables.
fn plural(kind: ParameterKind) -> String {
    match kind {
        ParameterKind::LengthOffset => "offsets".to_owned(),
        ParameterKind::LengthScale => "scales".to_owned(),
        ParameterKind::Compliance => "stiffness".to_owned(),
        ParameterKind::Wrench => "load".to_owned(),
        ParameterKind::SpoolBuildUp => "spool build-up".to_owned(),
        ParameterKind::DrumAxis => "drum axes".to_owned(),
        ParameterKind::SwivelAxis => "swivel axes".to_owned(),
        ParameterKind::DrumRadius => "drum radii".to_owned(),
        ParameterKind::PulleyRadius => "pulley radii".to_owned(),
        ParameterKind::DrumPitch => "drum pitches".to_owned(),
        ParameterKind::Stretch(_) => kind.name().replace('-', " "),
        other => format!("{}s", other.name().replace('-', " ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parameters_are_named_as_people_say_them() {
        for (list, expected) in [
            ("", ""),
            (
                "frame-anchor,platform-anchor,length-offset,compliance,wrench",
                "frame and platform anchors, offsets, stiffness, load",
            ),
            ("frame-anchor[1,3],platform-anchor", "frame anchors [1,3], platform anchors"),
            ("length-offset,pulley-radius,clock-offset,tracker-frame", "offsets, pulley radii, clock, tracker frame"),
            ("length-offset[3]@52", "length offset[3]@52"),
        ] {
            let free: FreeParameters = list.parse().unwrap();
            assert_eq!(free.plain_words(), expected, "{list}");
        }
    }

    /// No name of a parameter is left as the command line has it.
    #[test]
    fn every_kind_that_may_be_free_has_plain_words() {
        for kind in ParameterKind::IDENTIFIED {
            let words = FreeParameters::of(&[kind]).plain_words();
            assert!(
                !words.is_empty() && (kind == ParameterKind::SpoolBuildUp || !words.contains('-')),
                "{kind}: {words}"
            );
        }
    }
}

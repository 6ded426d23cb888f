//! Reader and writer of the file beside a data set.

use super::{Known, Sidecar};
use crate::reading::{ReadError, Size, Step, TomlDocument, text_from_bytes};

impl Sidecar {
    /// Reads a sidecar file.
    pub fn from_toml_bytes(bytes: &[u8], file_name: &str) -> Result<Self, ReadError> {
        let document = TomlDocument::parse(text_from_bytes(bytes, Size::Text, file_name)?, file_name)?;
        let sidecar: Self = document.deserialize()?;
        if sidecar.layout_version != 1 {
            let message = format!("layout_version {} is not known", sidecar.layout_version);
            return Err(document.error_at(&[Step::Key("layout_version")], "measurement::layout", message))
                .map_err(|error| error.with_help("this version reads layout_version = 1"));
        }
        for (index, text) in sidecar.known.iter().enumerate() {
            if let Err(error) = text.parse::<Known>() {
                let path = [Step::Key("known"), Step::Index(index)];
                return Err(document.error_at(&path, "measurement::known", error.to_string()));
            }
        }
        let sigmas = &sidecar.sigmas;
        for (key, value) in [
            ("position_m", sigmas.position),
            ("rotation_rad", sigmas.rotation),
            ("length_m", sigmas.length),
            ("tension_N", sigmas.tension),
            ("swivel_rad", sigmas.swivel),
            ("length_scale", sigmas.length_scale),
            ("balance_N", sigmas.balance_force),
            ("balance_Nm", sigmas.balance_moment),
        ] {
            if let Some(value) = value.filter(|value| !(*value >= 0.0)) {
                let message = format!("a standard deviation is 0 or more, found {value}");
                let path = [Step::Key("sigmas"), Step::Key(key)];
                return Err(document
                    .error_at(&path, "measurement::sigma", message)
                    .with_help("leave the key out when the accuracy is unknown"));
            }
        }
        Ok(sidecar)
    }

    /// The file's text.
    pub fn to_toml(&self) -> String {
        // plain numbers and strings, which TOML can always hold
        toml::to_string(self).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measurement::{Provenance, SensorSigmas};

    #[test]
    fn sidecars_survive_the_round_trip() {
        let sidecar = Sidecar {
            layout_version: 1,
            sigmas: SensorSigmas { position: Some(1e-3), length: Some(2e-4), ..SensorSigmas::default() },
            provenance: Some(Provenance { seed: Some(7), robot: Some("x".to_owned()), ..Provenance::default() }),
            ..Sidecar::default()
        };
        assert_eq!(Sidecar::from_toml_bytes(sidecar.to_toml().as_bytes(), "a").unwrap(), sidecar);
    }

    #[test]
    fn mistakes_are_placed() {
        for (text, line, what) in [
            ("layout_version = 2", 1, "not known"),
            ("layout_version = 1\nknown = [\"level[1,2]\", \"height[1]\"]", 2, "height[1]"),
            ("layout_version = 1\n[sigmas]\nposition_m = -1.0", 3, "0 or more"),
            ("layout_version = 1\n[sigmas]\nposition_mm = 1.0", 3, "position_mm"),
        ] {
            let error = Sidecar::from_toml_bytes(text.as_bytes(), "data.meta.toml").unwrap_err();
            assert_eq!(error.line(), Some(line), "{error}");
            assert!(error.to_string().contains(what), "{error}");
        }
    }
}

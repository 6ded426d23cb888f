//! Files given where a file of another kind is read, named by their content with the command that takes them.
//!
//! Kinds are sought only after a reader has refused the file, so that no readable file is refused.

use std::path::Path;

use cdpr_model::reading::ReadError;

use crate::failure::Failure;

/// Kinds of files that commands take or write, and those of other tools that are given to them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FileKind {
    Robot,
    Study,
    Scenario,
    Sweep,
    Map,
    Sidecar,
    Table,
    CasprBodies,
    CasprCables,
    Simulator,
    OtherXml,
    Page,
    Answer,
    Archive,
}

/// Contents of a file as far as they show its kind.
enum Content {
    Toml(toml::Table),
    /// Name of the outermost element.
    Xml(String),
    Json,
    /// A line of words between commas, semicolons or tabs before all others.
    Rows,
    Archive,
}

impl FileKind {
    /// The kind with its article.
    fn noun(self) -> &'static str {
        match self {
            Self::Robot => "a robot file",
            Self::Study => "a study",
            Self::Scenario => "a scenario",
            Self::Sweep => "a sweep",
            Self::Map => "a map that corrects lengths",
            Self::Sidecar => "the sidecar of a measurement file",
            Self::Table => "a table (CSV)",
            Self::CasprBodies => "CASPR's file of bodies",
            Self::CasprCables => "CASPR's file of cables",
            Self::Simulator => "a model of a simulator of rigid bodies (URDF, SDF or MJCF)",
            Self::OtherXml => "an XML file of another tool",
            Self::Page => "a page or drawing for a browser",
            Self::Answer => "JSON, as commands answer with --format json",
            Self::Archive => "an archive or a workbook of a spreadsheet program",
        }
    }

    /// The commands that take a file of this kind, or the way to a file that is taken.
    fn taken_by(self, name: &str) -> String {
        let file = crate::session::quoted(name);
        match self {
            Self::Robot => format!("`cdpr check {file}` takes it"),
            Self::Study => format!("`cdpr accuracy {file}` and `cdpr study {file} --out DIR` take it"),
            Self::Scenario => format!("`cdpr run {file} --out DIR` takes it"),
            Self::Sweep => format!("`cdpr sweep plan {file} --out DIR` takes it"),
            Self::Map => format!("`cdpr ik ROBOT --pose POSE --compensation {file}` takes it"),
            Self::Sidecar => "it is read by itself with the table of the same name: give that".to_owned(),
            Self::Table => format!("`cdpr evaluate ROBOT {file}` takes measurements, the robot file before them"),
            Self::CasprBodies => {
                format!("`cdpr import caspr {file} CABLES.xml --out ROBOT.toml` makes a robot file of it")
            }
            Self::CasprCables => {
                format!("`cdpr import caspr BODIES.xml {file} --out ROBOT.toml` makes a robot file of it")
            }
            Self::Simulator => {
                "cables are no part of such models: `cdpr new` writes a robot file to put the anchors into".to_owned()
            }
            Self::OtherXml => {
                "models of CASPR are taken by `cdpr import caspr`; `cdpr new` writes a robot file to fill in".to_owned()
            }
            Self::Page => {
                "its result.json or the folder's other files have the numbers; no command reads it".to_owned()
            }
            Self::Answer => format!("`cdpr export csv {file}` takes answers of select, demo and identify"),
            Self::Archive => "save the sheet as CSV, or take the file out of the archive".to_owned(),
        }
    }

    fn is_of_caspr(self) -> bool {
        matches!(self, Self::CasprBodies | Self::CasprCables)
    }

    /// The kind that the content shows; `None` where it may be anything.
    fn of(bytes: &[u8]) -> Option<Self> {
        match Content::of(bytes)? {
            Content::Toml(table) => of_tables(&table),
            Content::Json => Some(Self::Answer),
            Content::Rows => Some(Self::Table),
            Content::Archive => Some(Self::Archive),
            Content::Xml(root) => Some(match root.as_str() {
                "bodies_system" => Self::CasprBodies,
                "cables" => Self::CasprCables,
                "robot" | "sdf" | "mujoco" => Self::Simulator,
                "html" | "svg" => Self::Page,
                _ => Self::OtherXml,
            }),
        }
    }

    /// The refusal of a file that is read as this kind: that of its reader, unless the content shows another kind.
    pub(crate) fn refusal(self, bytes: &[u8], error: ReadError) -> Failure {
        // the reader of CASPR's files asks by itself whether they are given in the right order
        let is_expected = |found: Self| found == self || [self, found].into_iter().all(Self::is_of_caspr);
        let Some(found) = Self::of(bytes).filter(|found| !is_expected(*found)) else { return error.into() };
        let name = error.file_name;
        let message = format!("this is {}, and {} is expected here", found.noun(), self.noun());
        let mut help = found.taken_by(&name);
        if self == Self::Robot
            && let Some(robot) = robot_in(bytes, &name)
        {
            help.push_str(&format!("; the robot of its machine is {robot}"));
        }
        ReadError::new(name, "file::other-kind", message).with_help(help).into()
    }
}

/// The kind of a TOML file by its keys.
fn of_tables(table: &toml::Table) -> Option<FileKind> {
    let has = |key: &str| table.contains_key(key);
    let inside = |outer: &str, key: &str| table.get(outer).is_some_and(|value| value.get(key).is_some());
    let kinds = [
        (FileKind::Robot, has("cable") || has("motion_pattern")),
        (FileKind::Scenario, has("machine") && has("time") || inside("control", "kind")),
        (FileKind::Study, inside("control", "robot") || has("machine") && has("initial")),
        (FileKind::Sweep, has("study") && (has("parameter") || has("calibration"))),
        (FileKind::Map, has("noise_ratio") || has("ranges_m")),
        (FileKind::Sidecar, has("sigmas") || has("columns") || has("frames")),
    ];
    kinds.into_iter().find(|(_, is_so)| *is_so).map(|(kind, _)| kind)
}

/// The robot that the machine of a study or scenario is, as it is given to commands.
fn robot_in(bytes: &[u8], name: &str) -> Option<String> {
    let Some(Content::Toml(table)) = Content::of(bytes) else { return None };
    let robot = table.get("machine")?.get("robot")?.as_str()?;
    let folder = Path::new(name).parent().unwrap_or(Path::new(""));
    Some(robot_path(robot, folder))
}

/// Robot that a study or scenario in a folder names: a path is relative to the folder, a built-in name stands for itself.
pub(crate) fn robot_path(robot: &str, folder: &Path) -> String {
    let is_path = robot.contains(['/', '\\', '.']);
    if is_path { folder.join(robot).display().to_string() } else { robot.to_owned() }
}

impl Content {
    fn of(bytes: &[u8]) -> Option<Self> {
        if bytes.starts_with(b"PK\x03\x04") {
            return Some(Self::Archive);
        }
        let text = String::from_utf8_lossy(bytes);
        let text = text.trim_start_matches('\u{feff}').trim_start();
        if text.starts_with('<') {
            return outermost_element(text).map(Self::Xml);
        }
        if text.starts_with(['{', '[']) && serde_json::from_str::<serde::de::IgnoredAny>(text).is_ok() {
            return Some(Self::Json);
        }
        match toml::from_str::<toml::Table>(text) {
            Ok(table) => Some(Self::Toml(table)),
            Err(_) => is_header(text.lines().find(|line| !line.starts_with('#'))?).then_some(Self::Rows),
        }
    }
}

/// Name of the outermost element of an XML text, behind declarations and comments, in lower case and without its prefix.
fn outermost_element(text: &str) -> Option<String> {
    let mut rest = text;
    loop {
        rest = &rest[rest.find('<')? + 1..];
        if let Some(comment) = rest.strip_prefix("!--") {
            rest = &comment[comment.find("-->")?..];
        } else if rest.starts_with(char::is_alphabetic) {
            let name = rest.split(|character: char| character.is_whitespace() || "/>".contains(character)).next()?;
            return Some(name.rsplit(':').next().unwrap_or(name).to_lowercase());
        }
    }
}

/// True of a line of three words or more, none of which has an equals sign.
fn is_header(line: &str) -> bool {
    let has_words = |separator: char| line.split(separator).filter(|word| !word.trim().is_empty()).count() > 2;
    [',', ';', '\t'].into_iter().any(has_words) && !line.contains(['=', '{', '['])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_are_named_by_their_content() {
        for (text, kind) in [
            ("motion_pattern = \"3T\"\nlayout_version = 1", Some(FileKind::Robot)),
            ("[control]\nrobot = \"a\"\n[machine]\nrobot = \"a\"\n[initial]\n", Some(FileKind::Study)),
            ("[machine]\nrobot = \"a\"\n[time]\nduration_s = 1", Some(FileKind::Scenario)),
            ("study = \"a.toml\"\n[[parameter]]\n", Some(FileKind::Sweep)),
            ("layout_version = 1\n[sigmas]\nposition_m = 1", Some(FileKind::Sidecar)),
            ("# of a day\nx_m,y_m,length_1\n0,0,1", Some(FileKind::Table)),
            ("<?xml version=\"1.0\"?>\n<!-- <cables> -->\n<bodies_system>", Some(FileKind::CasprBodies)),
            ("<!DOCTYPE cables SYSTEM \"a.dtd\">\n<cables>", Some(FileKind::CasprCables)),
            ("\u{feff}<robot name=\"a\">", Some(FileKind::Simulator)),
            ("<cdpr:platform>", Some(FileKind::OtherXml)),
            ("<!doctype html>\n<html lang=\"en\">", Some(FileKind::Page)),
            ("{\"status\": \"ok\"}", Some(FileKind::Answer)),
            ("PK\u{3}\u{4}xl", Some(FileKind::Archive)),
            ("frame_anchor_m = [0, 1, ", None),
            ("hello", None),
            ("", None),
        ] {
            assert_eq!(FileKind::of(text.as_bytes()), kind, "{text}");
        }
    }
}

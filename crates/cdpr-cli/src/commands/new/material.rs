//! Files that come with the command: templates of robots and the studies of the book.

use cdpr_model::reading::ReadError;
use cdpr_model::robot::Robot;

/// A file with its path in the folder that it is written to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct EmbeddedFile {
    pub(super) path: &'static str,
    pub(super) text: &'static str,
}

/// A robot with a study and a scenario of it.
#[derive(Debug)]
pub(super) struct Template {
    pub(super) name: &'static str,
    files: [EmbeddedFile; 3],
}

macro_rules! templates {
    ($($name:literal,)*) => {
        [$(Template {
            name: $name,
            files: [
                EmbeddedFile { path: "robot.toml", text: include_str!(concat!("templates/", $name, "-robot.toml")) },
                EmbeddedFile { path: "study.toml", text: include_str!(concat!("templates/", $name, "-study.toml")) },
                EmbeddedFile { path: "scenario.toml", text: include_str!(concat!("templates/", $name, "-scenario.toml")) },
            ],
        },)*]
    };
}

/// One template for each motion pattern.
pub(super) const TEMPLATES: [Template; 4] = templates!["wall-plotter", "suspended-camera", "planar-frame", "box",];

impl Template {
    /// The template of a name or of a motion pattern.
    pub(super) fn named(name: &str) -> Option<&'static Self> {
        let is_meant = |template: &Self| {
            let pattern = || template.robot().ok().map(|robot| robot.motion_pattern.name());
            template.name == name || pattern().is_some_and(|pattern| pattern.eq_ignore_ascii_case(name))
        };
        TEMPLATES.iter().find(|template| is_meant(template))
    }

    pub(super) fn files(&self) -> &[EmbeddedFile] {
        &self.files
    }

    pub(super) fn robot(&self) -> Result<Robot, ReadError> {
        Robot::from_toml(self.files[0].text, self.files[0].path)
    }
}

macro_rules! studies {
    ($($path:literal,)*) => {
        &[$(EmbeddedFile { path: $path, text: include_str!(concat!(env!("CDPR_STUDIES"), "/", $path)) },)*]
    };
}

/// All files of the folder `studies` but its description: studies, sweeps, and what these name.
const STUDY_FILES: &[EmbeddedFile] = studies![
    "planar-circle.toml",
    "planar-disconnected.toml",
    "planar-force-circle-identified.toml",
    "planar-force-circle.toml",
    "planar-force-control-points.toml",
    "planar-force-control.toml",
    "planar-force-tracking-identified.toml",
    "planar-force-tracking.toml",
    "planar-initial-tension-stiff.toml",
    "planar-initial-tension.toml",
    "planar-low-calibrated.toml",
    "planar-low-grid.toml",
    "planar-pulleys.toml",
    "planar-small-circle.toml",
    "planar-stiff.toml",
    "planar-unloaded-3000.toml",
    "planar-unloaded-8000.toml",
    "planar-validation.toml",
    "planar-wide-calibrated.toml",
    "planar-wide-grid.toml",
    "scenario-cable-break.toml",
    "scenario-measuring.toml",
    "sweep-planar-anchor.toml",
    "sweep-planar-force-control.toml",
    "sweep-planar-pulleys-soft.toml",
    "sweep-planar-pulleys.toml",
    "sweep-planar-stiffness-four.toml",
    "sweep-planar-stiffness.toml",
    "sweep-planar-tension-stiff.toml",
    "sweep-planar-tension.toml",
    "sweep-twin-cost.toml",
    "twin-campaign.toml",
    "twin-chain.toml",
    "twin-compensated.toml",
    "twin-elastostatic-measurements.toml",
    "twin-elastostatic-nominal.toml",
    "twin-kinematic-calibrated.toml",
    "twin-kinematic-measurements.toml",
    "twin-measurements.toml",
    "twin-nominal.toml",
    "twin-tolerances.toml",
    "twin-winch-offsets.toml",
    "maps/twin-kinematic.toml",
    "poses/planar-circle.csv",
    "poses/planar-small-circle.csv",
    "robots/planar-calibrated-low.toml",
    "robots/planar-calibrated-wide.toml",
    "robots/planar-over-the-top-placed.toml",
    "robots/planar-over-the-top.toml",
    "robots/planar-stiff.toml",
    "robots/planar-tracking-identified.toml",
    "robots/planar-tracking-machine.toml",
    "robots/planar-unloaded.toml",
    "robots/simulator-in-motion.toml",
    "robots/twin-elastostatic-nominal.toml",
];

/// A study or sweep of the book.
#[derive(Clone, Copy, Debug)]
pub(super) struct Example {
    pub(super) name: &'static str,
    pub(super) file: EmbeddedFile,
}

impl Example {
    pub(super) fn named(name: &str) -> Option<Self> {
        let file = STUDY_FILES.iter().find(|file| name_of(file) == Some(name))?;
        Some(Self { name: name_of(file)?, file: *file })
    }

    /// The first line of its head.
    pub(super) fn title(&self) -> &'static str {
        self.file.text.lines().next().unwrap_or_default().trim_start_matches('#').trim()
    }

    /// The study with every file that it names, and those that they name.
    pub(super) fn files(&self) -> Vec<EmbeddedFile> {
        let mut found = vec![self.file];
        let mut looked_at = 0;
        while let Some(text) = found.get(looked_at).map(|file| file.text) {
            let is_named = |file: &&EmbeddedFile| text.contains(&format!("\"{}\"", file.path)) && !found.contains(file);
            let named: Vec<EmbeddedFile> = STUDY_FILES.iter().filter(is_named).copied().collect();
            found.extend(named);
            looked_at += 1;
        }
        found
    }
}

/// The name of a study: a file beside the folders of maps, poses and robots.
fn name_of(file: &EmbeddedFile) -> Option<&'static str> {
    file.path.strip_suffix(".toml").filter(|name| !name.contains('/'))
}

pub(super) fn study_names() -> impl Iterator<Item = &'static str> {
    STUDY_FILES.iter().filter_map(name_of)
}

pub(super) fn all_studies() -> Vec<EmbeddedFile> {
    STUDY_FILES.to_vec()
}

/// The commands of a file's head, without what is said about them; those of several lines are left out.
pub(super) fn commands(text: &'static str) -> impl Iterator<Item = &'static str> {
    let head = text.lines().take_while(|line| line.starts_with('#'));
    let commands = head.filter_map(|line| line.strip_prefix("#   ")).filter(|line| line.starts_with("cdpr "));
    commands.map(|line| line.split("  ").next().unwrap_or(line).trim_end()).filter(|line| !line.ends_with('\\'))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    /// A study that is added to the folder comes with the command, as does what it names.
    #[test]
    fn every_file_of_the_folder_of_studies_is_embedded() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies");
        let mut paths = Vec::new();
        for folder in ["", "maps", "poses", "robots"] {
            for entry in std::fs::read_dir(root.join(folder)).unwrap().map(|entry| entry.unwrap()) {
                let path = Path::new(folder).join(entry.file_name()).display().to_string();
                if entry.path().is_file() && path != "README.md" {
                    paths.push(path);
                }
            }
        }
        paths.sort();
        let mut embedded: Vec<&str> = STUDY_FILES.iter().map(|file| file.path).collect();
        embedded.sort_unstable();
        assert_eq!(embedded, paths);
    }

    /// Quoted names that end like files are those of files that are written with the study.
    #[test]
    fn a_study_comes_with_all_that_it_names() {
        for example in study_names().filter_map(Example::named) {
            let files = example.files();
            for text in files.iter().map(|file| file.text) {
                let names = text.split('"').skip(1).step_by(2);
                for name in names.filter(|name| name.ends_with(".toml") || name.ends_with(".csv")) {
                    assert!(files.iter().any(|file| file.path == name), "{}: {name}", example.name);
                }
            }
        }
    }
}

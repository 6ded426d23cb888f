//! `cdpr new`: a robot file with a study and a scenario to start from, and the studies of the book.

mod material;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use cdpr_model::reading::{Size, did_you_mean};
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;

use crate::answer::{Answer, Output};
use crate::failure::Failure;
use crate::files;
use crate::session::quoted;
use cdpr_reports::table::Table;
use material::{EmbeddedFile, Example, Template};

const EXAMPLES: &str = "\
Examples:
  cdpr new
  cdpr new suspended-camera --out my-robot
  cdpr new 3R3T
  cdpr new planar-wide-grid";

/// Folder of the book's studies, as their comments name it.
const STUDIES: &str = "studies";

/// Write a robot file, a study and a scenario to start from, or a study of the book.
///
/// A template makes a folder with robot.toml, every key explained, study.toml, which drives that robot with elastic cables, and scenario.toml, in which
/// it moves: check, ik, fk, workspace, accuracy, study, reachable, sensitivity, campaign, simulate and run take them as they are. A study of the book comes with the robots, poses and
/// studies that it names, and `studies` stands for all of them. Files that are there already and differ are left alone unless --force is given; all
/// files of a name are written, or none.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Template (wall-plotter, suspended-camera, planar-frame, box), its motion pattern (2T, 3T, 1R2T, 3R3T), or study; without it all are listed.
    #[arg(value_name = "NAME")]
    name: Option<String>,

    /// List the templates and the book's studies.
    #[arg(long, conflicts_with = "name")]
    list: bool,

    /// Folder to write to, made where it does not exist; of a template its name when left out, of studies `studies`.
    #[arg(long, value_name = "DIR", requires = "name")]
    out: Option<PathBuf>,

    /// Replace files that are there already.
    #[arg(long, requires = "name")]
    force: bool,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let Some(name) = arguments.name.filter(|_| !arguments.list) else { return output.answer(&Offer::new()?) };
    let start = Start::named(&name)?;
    let folder = arguments.out.unwrap_or_else(|| PathBuf::from(&start.folder));
    let written = write(&folder, &start.files, arguments.force)?;
    let try_next = start.commands(&folder);
    output.answer(&Written { name, out: folder.display().to_string(), written, try_next })
}

/// Files of a name, and the folder that they belong into.
struct Start {
    folder: String,
    files: Vec<EmbeddedFile>,
    /// Files whose head tells commands, with the folder in those.
    told: Vec<&'static str>,
}

impl Start {
    fn named(name: &str) -> Result<Self, Failure> {
        if let Some(template) = Template::named(name) {
            let files = template.files().to_vec();
            let told = files.iter().map(|file| file.text).collect();
            return Ok(Self { folder: template.name.to_owned(), files, told });
        }
        let folder = STUDIES.to_owned();
        if name == STUDIES {
            return Ok(Self { folder, files: material::all_studies(), told: Vec::new() });
        }
        let example = Example::named(name).ok_or_else(|| unknown(name))?;
        Ok(Self { folder, files: example.files(), told: vec![example.file.text] })
    }

    /// The commands that the files tell in their heads, with the folder's path.
    fn commands(&self, folder: &Path) -> Vec<String> {
        let path = |name: &str| quoted(&folder.join(name).display().to_string());
        let replaced = |word: &str| match word.strip_prefix("studies/").unwrap_or(word) {
            name if self.files.iter().any(|file| file.path == name) => path(name),
            _ => word.to_owned(),
        };
        let lines = self.told.iter().flat_map(|text| material::commands(text));
        lines.map(|line| line.split(' ').map(replaced).collect::<Vec<_>>().join(" ")).collect()
    }
}

/// Names of the templates.
pub(crate) fn template_names() -> impl Iterator<Item = &'static str> {
    material::TEMPLATES.iter().map(|template| template.name)
}

/// Names of the templates and of the book's studies.
pub(crate) fn names() -> impl Iterator<Item = &'static str> {
    material::TEMPLATES.iter().map(|template| template.name).chain(material::study_names())
}

fn unknown(name: &str) -> Failure {
    let help = match did_you_mean(name, names()) {
        Some(meant) => format!("did you mean `{meant}`? `cdpr new` lists the templates and studies"),
        None => "`cdpr new` lists the templates and studies; a motion pattern (2T, 3T, 1R2T, 3R3T) names its template"
            .to_owned(),
    };
    Failure::input("new::unknown-name", format!("there is neither a template nor a study named `{name}`"), help)
}

/// Writes the files that are not there yet; with `force` also over others.
fn write(folder: &Path, wanted: &[EmbeddedFile], force: bool) -> Result<Vec<String>, Failure> {
    let _own = files::OwnFolder::make(folder)?;
    let mut missing = Vec::new();
    for file in wanted {
        let path = folder.join(file.path);
        match files::read_if_there(&path, Size::Table) {
            Ok(Some(content)) if content == file.text.as_bytes() => continue,
            Ok(None) => {}
            // whatever else is there is not ours
            _ if force => {}
            _ => {
                let message = format!("{} is there already, with another content; nothing is written", path.display());
                let help = "give another folder with --out, or --force to replace it";
                return Err(Failure::input("new::file-exists", message, help));
            }
        }
        missing.push((path, file.text.as_bytes()));
    }
    for folder in missing.iter().filter_map(|(path, _)| path.parent()) {
        files::make_folder(folder)?;
    }
    let pairs: Vec<(&Path, &[u8])> = missing.iter().map(|(path, text)| (path.as_path(), *text)).collect();
    files::write_all(&pairs)?;
    Ok(missing.iter().map(|(path, _)| path.display().to_string()).collect())
}

/// Folder with the files of a new robot.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "NewFolder")]
pub(super) struct Written {
    name: String,
    out: String,
    /// Paths; files that were there already as they are do not count.
    written: Vec<String>,
    /// Commands for these files.
    #[serde(rename = "try")]
    try_next: Vec<String>,
}

impl Answer for Written {
    fn words(&self, _width: Option<usize>) -> String {
        let mut text = match self.written.is_empty() {
            true => format!("{} has these files already\n", self.out),
            false => format!("wrote {}\n", self.written.join(", ")),
        };
        if !self.try_next.is_empty() {
            text.push_str("\ntry\n");
            self.try_next.iter().for_each(|command| text.push_str(&format!("  {command}\n")));
        }
        text
    }
}

/// Robots and studies to start from.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "TemplateList")]
pub(super) struct Offer {
    /// Robots to start from.
    templates: Vec<TemplateEntry>,
    /// Studies to start from.
    studies: Vec<StudyEntry>,
}

/// Robot to start from.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "TemplateRobot")]
pub(super) struct TemplateEntry {
    name: &'static str,
    motion_pattern: &'static str,
    cable_count: usize,
    title: String,
}

/// Study to start from.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "TemplateStudy")]
pub(super) struct StudyEntry {
    name: &'static str,
    title: &'static str,
}

impl Offer {
    fn new() -> Result<Self, Failure> {
        let entry = |template: &Template| -> Result<TemplateEntry, Failure> {
            let robot = template.robot()?;
            let (motion_pattern, cable_count) = (robot.motion_pattern.name(), robot.cable_count());
            Ok(TemplateEntry {
                name: template.name,
                motion_pattern,
                cable_count,
                title: robot.title.unwrap_or_default(),
            })
        };
        let study = |example: Example| StudyEntry { name: example.name, title: example.title() };
        Ok(Self {
            templates: material::TEMPLATES.iter().map(entry).collect::<Result<_, _>>()?,
            studies: material::study_names().filter_map(Example::named).map(study).collect(),
        })
    }
}

impl Answer for Offer {
    fn words(&self, width: Option<usize>) -> String {
        let mut templates = Table::new(["template", "pattern", "cables", "title"]);
        for entry in &self.templates {
            let cells = [entry.name, entry.motion_pattern, &entry.cable_count.to_string(), &entry.title];
            templates.row(cells.map(str::to_owned).to_vec());
        }
        let mut studies = Table::new(["study of the book", "title"]);
        for entry in &self.studies {
            studies.row(vec![entry.name.to_owned(), entry.title.to_owned()]);
        }
        let (templates, studies) = (templates.left_column(3).text(width), studies.left_column(1).text(width));
        format!("{templates}\n{studies}\n`cdpr new NAME` writes the files of one, `cdpr new studies` all studies\n")
    }
}

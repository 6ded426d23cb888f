//! The report as a browser shows it: opens pages in headless Chromium, and builds the viewer anew to compare it with the
//! committed bundle.

mod pages;

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::notices;
use crate::outcome::Outcome;
use crate::programs::{can_install, install, on_path, run};
use pages::Made;

/// What `viewer/` makes, in the folder that pages include it from.
const GENERATED: &str = "crates/cdpr-reports/src/html_page/generated";
const MADE: [&str; 4] = ["notices.txt", "viewer.css", "viewer.js", "viewer.stamp"];

/// Passes when the bundle is what its sources make and every page is as it should be; says why where it cannot look.
pub(crate) fn check(root: &Path) -> Outcome {
    let tools = match Tools::found_or_installed() {
        Ok(tools) => tools,
        Err(reason) => return skipped(&reason),
    };
    if let Err(reason) = packages(root) {
        return skipped(&reason);
    }
    let folder = root.join("target/browser");
    let result = rebuilt_is_committed(root, &folder).and_then(|()| {
        let pages = pages::of_every_kind(root, &folder)?;
        open(root, &tools, &folder.join("screenshots"), &pages)?;
        Ok(pages.len())
    });
    match result {
        Ok(pages) => Outcome { passed: 1 + pages, ..Outcome::default() },
        Err(complaint) => Outcome::of(vec![complaint]),
    }
}

/// Sees to it that there are a browser, Node and the packages of `viewer/`.
pub(crate) fn fetch(root: &Path) -> Result<(), String> {
    Tools::found_or_installed()?;
    packages(root)
}

/// Builds the viewer into the folder of the pages.
pub(crate) fn build(root: &Path) -> Result<(), String> {
    packages(root)?;
    run(npm(root, &["run", "build"]))?;
    println!("wrote {GENERATED}");
    notices::write(root)
}

/// Nothing was looked at: a failure in CI, where somebody relies on it.
fn skipped(reason: &str) -> Outcome {
    println!("the browser test is skipped: {reason}");
    if std::env::var("CI").as_deref() == Ok("true") {
        return Outcome::of(vec![format!("CI must not skip the browser test: {reason}")]);
    }
    Outcome::default()
}

struct Tools {
    chromium: PathBuf,
}

impl Tools {
    fn found_or_installed() -> Result<Self, String> {
        Self::find().or_else(|missing| Self::install(&missing))
    }

    /// The programs on the search path, or what is missing.
    fn find() -> Result<Self, String> {
        let chromium = std::env::var_os("CDPR_CHROMIUM")
            .map(PathBuf::from)
            .or_else(|| ["chromium", "chromium-browser", "google-chrome"].iter().find_map(|name| on_path(name)));
        let missing: Vec<&str> = ["node", "npm"].into_iter().filter(|name| on_path(name).is_none()).collect();
        match chromium {
            Some(chromium) if missing.is_empty() => Ok(Self { chromium }),
            None if missing.is_empty() => Err("there is no Chromium".to_owned()),
            None => Err(format!("there is no Chromium, no {}", missing.join(", no "))),
            Some(_) => Err(format!("there is no {}", missing.join(", no "))),
        }
    }

    /// Installs Debian's packages where this runs as root, as in a container of CI.
    fn install(missing: &str) -> Result<Self, String> {
        if !can_install() {
            return Err(format!("{missing}; install chromium, nodejs and npm (CDPR_CHROMIUM names another Chromium)"));
        }
        println!("{missing}");
        let node = if on_path("node").is_none() || on_path("npm").is_none() { &["nodejs", "npm"][..] } else { &[] };
        install(&[&["chromium"], node].concat())?;
        Self::find()
    }
}

/// Installs the packages of `viewer/` where they are not those of its lock file.
fn packages(root: &Path) -> Result<(), String> {
    let lock = root.join("viewer/package-lock.json");
    let installed = root.join("viewer/node_modules/.installed-lock.json");
    let read = |path: &Path| std::fs::read(path).ok();
    if read(&installed).is_some() && read(&installed) == read(&lock) {
        return Ok(());
    }
    run(npm(root, &["ci", "--ignore-scripts"]))
        .map_err(|error| format!("the packages of viewer/ cannot be installed: {error}"))?;
    std::fs::copy(&lock, &installed).map(|_| ()).map_err(|error| format!("{}: {error}", installed.display()))
}

fn npm(root: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new("npm");
    command.args(arguments).current_dir(root.join("viewer")).stdin(Stdio::null());
    command
}

fn rebuilt_is_committed(root: &Path, folder: &Path) -> Result<(), String> {
    let rebuilt = folder.join("viewer");
    let mut build = npm(root, &["run", "build"]);
    build.env("CDPR_VIEWER_OUT", &rebuilt);
    run(build)?;
    let read = |path: PathBuf| std::fs::read(&path).map_err(|error| format!("{}: {error}", path.display()));
    for name in MADE {
        if read(rebuilt.join(name))? != read(root.join(GENERATED).join(name))? {
            return Err(format!(
                "{GENERATED}/{name} is not what viewer/ makes: run `cargo xtask viewer` and commit it"
            ));
        }
    }
    Ok(())
}

fn open(root: &Path, tools: &Tools, screenshots: &Path, pages: &[Made]) -> Result<(), String> {
    let mut node = Command::new("node");
    node.arg("test/browser.mjs").arg(&tools.chromium).arg(screenshots).current_dir(root.join("viewer"));
    for Made { kind, folder } in pages {
        node.arg(kind).arg(folder);
    }
    let status = node.stdin(Stdio::null()).status().map_err(|error| format!("cannot start node: {error}"))?;
    match status.success() {
        true => Ok(()),
        false => Err(format!("a page is not as it should be (above); screenshots are in {}", screenshots.display())),
    }
}

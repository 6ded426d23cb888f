//! The report as a browser shows it: opens pages in headless Chromium, and builds the viewer anew to compare it with the
//! committed bundle.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::outcome::Outcome;
use crate::programs::{can_install, install, on_path, run};
use crate::{cargo, notices};

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
        let pages = pages(root, &folder)?;
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

/// Makes the pages: the demo, an identification of a rigid model, and the real robot where its data may be read.
fn pages(root: &Path, folder: &Path) -> Result<Vec<PathBuf>, String> {
    let at = |name: &str| folder.join(name);
    let text = |path: PathBuf| path.display().to_string();
    let demo = at("demo");
    cdpr(root, &["demo", "--require", "position_mean_m=0.005", "--out", &text(demo.clone())])?;
    let identified = at("identify");
    std::fs::create_dir_all(&identified).map_err(|error| format!("{}: {error}", identified.display()))?;
    let (robot, data) = (text(demo.join("robot.toml")), text(demo.join("training.csv")));
    let report = text(identified.join("report.html"));
    cdpr(root, &["identify", &robot, &data, "--free", "frame-anchor,platform-anchor", "--report", &report])?;
    let mut pages = vec![demo.clone(), identified];
    pages.extend(dirty_pages(root, folder, &demo)?);
    let shared = root.join("../shared/data");
    let measured = shared.join("measurements/gtcable-concentric-diamonds/samples.csv");
    if measured.is_file() {
        let (robot, out) = (text(shared.join("robots/gtcable-planar.toml")), at("gtcable"));
        cdpr(
            root,
            &["select", &robot, &text(measured), "--require", "position_mean_m=0.001", "--out", &text(out.clone())],
        )?;
        pages.push(out);
    } else {
        println!("the page of the real robot is skipped: {} is not here", measured.display());
    }
    pages.extend(workspace_pages(root, folder)?);
    pages.extend(study_pages(root, folder)?);
    let run = at("run");
    cdpr(root, &["run", "studies/scenario-cable-break.toml", "--out", &text(run.clone())])?;
    pages.push(run);
    Ok(pages)
}

/// Another line in place of one of a table; the first line is its heading.
type Change = fn(usize, &str) -> String;

fn displaced(row: usize, line: &str) -> String {
    match line.split_once(',') {
        Some((x, rest)) if row > 0 && row.is_multiple_of(31) => {
            x.parse::<f64>().map_or_else(|_| line.to_owned(), |x| format!("{},{rest}", x + 0.3))
        }
        _ => line.to_owned(),
    }
}

/// After seven numbers of the pose: the lengths of the third and of the fifth cable change places.
fn swapped(row: usize, line: &str) -> String {
    let mut fields: Vec<&str> = line.split(',').collect();
    if row > 0 && fields.len() > 11 {
        fields.swap(9, 11);
    }
    fields.join(",")
}

/// Pages of data that are wrong: rows displaced by 0.3 m, and two cables whose lengths stand in each other's column.
fn dirty_pages(root: &Path, folder: &Path, demo: &Path) -> Result<Vec<PathBuf>, String> {
    let complain = |path: &Path, error: std::io::Error| format!("{}: {error}", path.display());
    let read = |name: &str| {
        let path = demo.join(name);
        std::fs::read_to_string(&path).map_err(|error| complain(&path, error))
    };
    let mut pages = Vec::new();
    for (name, change) in [("displaced", displaced as Change), ("swapped", swapped)] {
        let out = folder.join(format!("{name}-data"));
        std::fs::create_dir_all(&out).map_err(|error| complain(&out, error))?;
        for (file, meta) in [("training.csv", "training.meta.toml"), ("validation.csv", "validation.meta.toml")] {
            let lines: Vec<String> = read(file)?.lines().enumerate().map(|(row, line)| change(row, line)).collect();
            std::fs::write(out.join(file), lines.join("\n") + "\n").map_err(|error| complain(&out, error))?;
            std::fs::write(out.join(meta), read(meta)?).map_err(|error| complain(&out, error))?;
        }
        let text = |path: PathBuf| path.display().to_string();
        let (robot, data, other) =
            (text(demo.join("robot.toml")), text(out.join("training.csv")), text(out.join("validation.csv")));
        let result = folder.join(name);
        cdpr(root, &["select", &robot, &data, "--validation", &other, "--out", &text(result.clone())])?;
        pages.push(result);
    }
    Ok(pages)
}

/// Pages of studies: two in a plane, one of them of a small region, and one in space.
fn study_pages(root: &Path, folder: &Path) -> Result<Vec<PathBuf>, String> {
    let study = |name: &str| -> Result<PathBuf, String> {
        let out = folder.join(format!("study-{name}"));
        cdpr(root, &["study", &format!("studies/{name}.toml"), "--out", &out.display().to_string()])?;
        Ok(out)
    };
    ["planar-wide-grid", "planar-low-grid", "twin-nominal"].into_iter().map(study).collect()
}

/// Pages of workspaces: one in a plane and one in space, each with an earlier result laid over it, and the surface of a grid.
fn workspace_pages(root: &Path, folder: &Path) -> Result<Vec<PathBuf>, String> {
    let planar = ["workspace", "planar-example", "--method", "hull", "--max", "8000"];
    let spatial = ["workspace", "cablerobot-simulator-helicopter", "--method", "hull", "--rays", "642"];
    let mut pages = Vec::new();
    for (name, arguments) in [("workspace-planar", &planar[..]), ("workspace-spatial", &spatial[..])] {
        let folder = folder.join(name);
        std::fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        let (page, earlier) = (folder.join("workspace.html"), folder.join("earlier.html"));
        let (page, earlier) = (page.display().to_string(), earlier.display().to_string());
        cdpr(root, &[arguments, &["--min", "500", "--page", &earlier]].concat())?;
        cdpr(root, &[arguments, &["--min", "1000", "--page", &page, "--overlay", &earlier]].concat())?;
        pages.push(folder);
    }
    let folder = folder.join("workspace-grid");
    std::fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let page = folder.join("workspace.html").display().to_string();
    cdpr(root, &["workspace", "cablerobot-simulator-helicopter", "--step", "0.4", "--page", &page])?;
    pages.push(folder);
    Ok(pages)
}

/// Runs the command; a negative answer (1) has its page too.
fn cdpr(root: &Path, arguments: &[&str]) -> Result<(), String> {
    let program = cargo::the_command(root)?;
    let output = Command::new(&program).args(arguments).current_dir(root).stdin(Stdio::null()).output();
    let output = output.map_err(|error| format!("cannot start {}: {error}", program.display()))?;
    match output.status.code() {
        Some(0 | 1) => Ok(()),
        _ => Err(format!("`cdpr {}` failed: {}", arguments.join(" "), String::from_utf8_lossy(&output.stderr).trim())),
    }
}

fn open(root: &Path, tools: &Tools, screenshots: &Path, pages: &[PathBuf]) -> Result<(), String> {
    let mut node = Command::new("node");
    node.arg("test/browser.mjs").arg(&tools.chromium).arg(screenshots).args(pages).current_dir(root.join("viewer"));
    let status = node.stdin(Stdio::null()).status().map_err(|error| format!("cannot start node: {error}"))?;
    match status.success() {
        true => Ok(()),
        false => Err(format!("a page is not as it should be (above); screenshots are in {}", screenshots.display())),
    }
}

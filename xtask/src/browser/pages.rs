//! Pages of every kind, as commands write them.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::cargo;

/// Kinds of pages in the code: `Self::Run => "run"` names one.
const NAMED: &str = "crates/cdpr-reports/src/html_page/kind.rs";

/// Folders with pages, made by commands in the root for a folder.
type Maker = fn(&Path, &Path) -> Result<Vec<PathBuf>, String>;

/// Every kind of page with what makes examples of it; a kind of the code without a line here fails the test.
const KINDS: [(&str, Maker); 9] = [
    ("report", reports),
    ("workspace", workspaces),
    ("study", studies),
    ("run", runs),
    ("campaign", campaigns),
    ("chain", chains),
    ("benchmark", benchmarks),
    ("capability", capabilities),
    ("response", responses),
];

/// A page in its folder.
pub(super) struct Made {
    /// Kind that its body has to name.
    pub(super) kind: &'static str,
    pub(super) folder: PathBuf,
}

/// Makes pages of every kind that the code names.
pub(super) fn of_every_kind(root: &Path, folder: &Path) -> Result<Vec<Made>, String> {
    let named = named(&std::fs::read_to_string(root.join(NAMED)).map_err(|error| format!("{NAMED}: {error}"))?);
    let opened: Vec<&str> = KINDS.iter().map(|(kind, _)| *kind).collect();
    if named != opened {
        return Err(format!(
            "{NAMED} names the pages {named:?}, the browser test opens {opened:?}: add what is missing to xtask/src/browser/pages.rs and viewer/test/browser.mjs"
        ));
    }
    let mut pages = Vec::new();
    for (kind, make) in KINDS {
        pages.extend(make(root, folder)?.into_iter().map(|folder| Made { kind, folder }));
    }
    Ok(pages)
}

/// Names of kinds in the source that lists them.
fn named(source: &str) -> Vec<String> {
    let name =
        |line: &str| Some(line.trim().strip_prefix("Self::")?.split_once(" => \"")?.1.split_once('"')?.0.to_owned());
    source.lines().filter_map(name).collect()
}

/// Reports of models: the demo, an identification of a rigid model, data that are wrong, and the real robot where its data may be read.
fn reports(root: &Path, folder: &Path) -> Result<Vec<PathBuf>, String> {
    let at = |name: &str| folder.join(name);
    let text = |path: PathBuf| path.display().to_string();
    let demo = at("demo");
    cdpr(root, &["demo", "--require", "position_mean_m=0.005", "--out", &text(demo.clone())])?;
    let identified = made(&at("identify"))?;
    let (robot, data) = (text(demo.join("robot.toml")), text(demo.join("training.csv")));
    let report = text(identified.join("report.html"));
    cdpr(root, &["identify", &robot, &data, "--free", "frame-anchor,platform-anchor", "--report", &report])?;
    let mut pages = vec![demo.clone(), identified];
    pages.extend(dirty(root, folder, &demo)?);
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
    Ok(pages)
}

/// A run with a cable that breaks.
fn runs(root: &Path, folder: &Path) -> Result<Vec<PathBuf>, String> {
    let run = folder.join("run");
    cdpr(root, &["run", "studies/scenario-cable-break.toml", "--out", &run.display().to_string()])?;
    Ok(vec![run])
}

/// Rounds of measurements, begun anew.
fn campaigns(root: &Path, folder: &Path) -> Result<Vec<PathBuf>, String> {
    let out = folder.join("campaign");
    match std::fs::remove_dir_all(&out) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => Err(format!("{}: {error}", out.display())),
        _ => cdpr(root, &["campaign", "studies/twin-campaign.toml", "--out", &out.display().to_string()]),
    }?;
    Ok(vec![out])
}

/// Stages of a twin of which numbers are printed, and of a robot of which none are.
fn chains(root: &Path, folder: &Path) -> Result<Vec<PathBuf>, String> {
    let chain = |name: &str| -> Result<PathBuf, String> {
        let out = made(&folder.join(format!("chain-{name}")))?;
        let page = out.join("report.html").display().to_string();
        cdpr(root, &["chain", &format!("studies/{name}.toml"), "--report", &page])?;
        Ok(out)
    };
    ["twin-chain", "planar-wide-grid"].into_iter().map(chain).collect()
}

/// Robots under the same rules.
fn benchmarks(root: &Path, folder: &Path) -> Result<Vec<PathBuf>, String> {
    let out = folder.join("benchmark");
    let robots = "planar-example,cablerobot-simulator-helicopter";
    cdpr(root, &["benchmark", "--robots", robots, "--out", &out.display().to_string()])?;
    Ok(vec![out])
}

/// Capabilities of a planar and of a spatial robot in boxes.
fn capabilities(root: &Path, folder: &Path) -> Result<Vec<PathBuf>, String> {
    let capability = |robot: &str, limits: &str| -> Result<PathBuf, String> {
        let out = made(&folder.join(format!("capability-{robot}")))?;
        let page = out.join("report.html").display().to_string();
        cdpr(root, &["capability", robot, limits, "--report", &page])?;
        Ok(out)
    };
    Ok(vec![capability("planar-example", "--box=-1,1,3,5")?, capability("cogiro", "--box=-1,1,-1,1,1,2")?])
}

/// Response of a lag under a sum of sines.
fn responses(root: &Path, folder: &Path) -> Result<Vec<PathBuf>, String> {
    let out = made(&folder.join("response"))?;
    let mut text = "t_s,motor_torque_Nm,tension_N\n".to_owned();
    for row in 0..4000 {
        let time = 0.005 * f64::from(row);
        let (mut told, mut said) = (0.0, 0.01 * f64::from(row * 7919 % 101 - 50));
        for k in 1..=50 {
            let (turn, lag) = (std::f64::consts::PI * f64::from(k), 0.02 * std::f64::consts::PI * f64::from(k));
            let phase = turn * time + 0.7 * f64::from(k * k);
            told += phase.cos();
            said += 5.0 * (phase - lag.atan()).cos() / 1_f64.hypot(lag);
        }
        text += &format!("{time:.3},{told:.6},{said:.6}\n");
    }
    let record = out.join("record.csv");
    std::fs::write(&record, text).map_err(|error| format!("{}: {error}", record.display()))?;
    let page = out.join("report.html").display().to_string();
    cdpr(root, &["frequency-response", &record.display().to_string(), "--report", &page])?;
    Ok(vec![out])
}

/// The folder, made where it is not there.
fn made(folder: &Path) -> Result<PathBuf, String> {
    std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    Ok(folder.to_owned())
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
fn dirty(root: &Path, folder: &Path, demo: &Path) -> Result<Vec<PathBuf>, String> {
    let complain = |path: &Path, error: std::io::Error| format!("{}: {error}", path.display());
    let read = |name: &str| {
        let path = demo.join(name);
        std::fs::read_to_string(&path).map_err(|error| complain(&path, error))
    };
    let mut pages = Vec::new();
    for (name, change) in [("displaced", displaced as Change), ("swapped", swapped)] {
        let out = made(&folder.join(format!("{name}-data")))?;
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
fn studies(root: &Path, folder: &Path) -> Result<Vec<PathBuf>, String> {
    let study = |name: &str| -> Result<PathBuf, String> {
        let out = folder.join(format!("study-{name}"));
        cdpr(root, &["study", &format!("studies/{name}.toml"), "--out", &out.display().to_string()])?;
        Ok(out)
    };
    ["planar-wide-grid", "planar-low-grid", "twin-nominal"].into_iter().map(study).collect()
}

/// Pages of workspaces: one in a plane and one in space, each with an earlier result laid over it, and the surface of a grid.
fn workspaces(root: &Path, folder: &Path) -> Result<Vec<PathBuf>, String> {
    let planar = ["workspace", "planar-example", "--method", "hull", "--max", "8000"];
    let spatial = ["workspace", "cablerobot-simulator-helicopter", "--method", "hull", "--rays", "642"];
    let mut pages = Vec::new();
    for (name, arguments) in [("workspace-planar", &planar[..]), ("workspace-spatial", &spatial[..])] {
        let folder = made(&folder.join(name))?;
        let (page, earlier) = (folder.join("workspace.html"), folder.join("earlier.html"));
        let (page, earlier) = (page.display().to_string(), earlier.display().to_string());
        cdpr(root, &[arguments, &["--min", "500", "--page", &earlier]].concat())?;
        cdpr(root, &[arguments, &["--min", "1000", "--page", &page, "--overlay", &earlier]].concat())?;
        pages.push(folder);
    }
    let folder = made(&folder.join("workspace-grid"))?;
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The list of kinds in the code is that of the table; another kind would be told.
    #[test]
    fn every_kind_of_page_in_the_code_is_opened() {
        let source = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(NAMED)).unwrap();
        assert_eq!(named(&source), KINDS.map(|(kind, _)| kind));
        assert_eq!(named("            Self::Sketch => \"sketch\","), ["sketch"]);
    }
}

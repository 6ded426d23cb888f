//! THIRD-PARTY.txt: whose work is in the command and in reports, and under which licences.

use std::path::{Path, PathBuf};

use crate::packages::{Licence, Package, linked};

/// The page at the root.
const FILE: &str = "THIRD-PARTY.txt";

/// What the build of `viewer/` says of the packages in its bundle.
const BUNDLE: &str = "crates/cdpr-reports/src/html_page/generated/notices.txt";

/// A heading, some copyright lines, or Apache's appendix stand beside the terms; more words say more than that.
const WORDS_BESIDES: usize = 260;

const HEAD: &str = "\
The command cdpr and the Python module cdpr are built from the Rust packages listed second. The reports (report.html) that it writes contain a program that was
bundled from viewer/; every report shows the licences of that, which come first, at its end. Built-in robots:
crates/cdpr-model/robots/NOTICE.md. `cargo xtask generate` writes this file.

";

const RUST: &str = "
========================================================================

The command and the module contain the following Rust packages, on one system or another, under the MIT licence, whose text follows the list.

";

const APACHE: &str = "
========================================================================

They contain the following ones, and the Rust standard library (Copyright (c) The Rust Project Contributors), under the
Apache licence 2.0, whose text follows the list.

";

const OWN: &str = "
========================================================================

The Python module contains the following ones under terms of their own.

";

/// Writes the page.
pub(crate) fn write(root: &Path) -> Result<(), String> {
    std::fs::write(root.join(FILE), text(root)?).map_err(|error| format!("{FILE}: {error}"))?;
    println!("wrote {FILE}");
    Ok(())
}

/// Complains where the page is not that of the packages linked now.
pub(crate) fn check(root: &Path) -> Option<String> {
    match (text(root), read(&root.join(FILE))) {
        (Err(message), _) | (_, Err(message)) => Some(message),
        (Ok(expected), Ok(found)) => (expected != found).then(|| format!("{FILE} is out of date")),
    }
}

/// Puts the page together.
fn text(root: &Path) -> Result<String, String> {
    let bundle = read(&root.join(BUNDLE))?;
    let (mit, apache) = (Text::ours(root, Licence::Mit)?, Text::ours(root, Licence::Apache)?);
    let packages = linked(root)?;
    let list = |text: &Text| -> Result<String, String> {
        let own = packages.iter().filter(|package| package.licence == text.licence);
        let whole = |package| Ok::<_, String>(notice(package, text)? + &terms_besides(package)?);
        Ok(own.map(whole).collect::<Result<Vec<_>, _>>()?.concat())
    };
    let own = packages.iter().filter(|package| package.licence == Licence::Own);
    let own = own.map(terms_of_its_own).collect::<Result<Vec<_>, _>>()?.concat();
    Ok([HEAD, &bundle, RUST, &list(&mit)?, "\n", &mit.shown, APACHE, &list(&apache)?, "\n", &apache.shown, OWN, &own]
        .concat())
}

/// A licence's text: as it is shown, and bare of copyright lines, headings and line breaks, to compare with.
struct Text {
    licence: Licence,
    shown: String,
    terms: String,
}

impl Text {
    /// From the licence files of the project itself.
    fn ours(root: &Path, licence: Licence) -> Result<Self, String> {
        let text = read(&root.join(if licence == Licence::Mit { "LICENSE-MIT" } else { "LICENSE-APACHE" }))?;
        let mut shown: Vec<&str> = text.lines().filter(|line| !is_copyright(line)).collect();
        shown.dedup_by(|line, before| line.is_empty() && before.is_empty());
        let terms = terms(&text, licence).ok_or("the project's own licence files lack the terms")?;
        Ok(Self { licence, shown: format!("{}\n", shown.join("\n").trim_end()), terms })
    }
}

/// Title, copyright lines, and the text where it is not the usual one.
fn notice(package: &Package, usual: &Text) -> Result<String, String> {
    let Some((text, terms)) = licence_file(package)? else {
        return Ok(format!("{}\n    {}\n", package.title, authors(package)?));
    };
    let besides = text.split_whitespace().count().saturating_sub(terms.split(' ').count());
    if terms != usual.terms || besides > WORDS_BESIDES {
        return Ok(format!("{}, in these words:\n{}\n", package.title, indented(&text)));
    }
    let lines: Vec<&str> = text.lines().map(str::trim).filter(|line| is_copyright(line)).collect();
    let lines = if lines.is_empty() { vec![authors(package)?] } else { lines.into_iter().map(str::to_owned).collect() };
    Ok(format!("{}\n    {}\n", package.title, lines.join("\n    ")))
}

/// Title and terms of a package that has none of the usual ones.
fn terms_of_its_own(package: &Package) -> Result<String, String> {
    let file = package.besides.ok_or_else(|| format!("{}: the file with its terms is not named", package.title))?;
    Ok(format!("{}, in these words:\n{}\n", package.title, indented(&read(&package.folder.join(file))?)))
}

/// A text four columns to the right.
fn indented(text: &str) -> String {
    let lines: Vec<String> = text.lines().map(|line| format!("    {line}").trim_end().to_owned()).collect();
    lines.join("\n").trim_end().to_owned()
}

/// Terms that a package has beside those of its licence, in its words.
fn terms_besides(package: &Package) -> Result<String, String> {
    let Some(file) = package.besides else { return Ok(String::new()) };
    let text = read(&package.folder.join(file))?;
    Ok(format!("and, for parts of it, in these words:\n{}\n", indented(&text)))
}

/// The file with the terms of the package's licence, the one named after it first, and these terms.
fn licence_file(package: &Package) -> Result<Option<(String, String)>, String> {
    let folders = ["", "licenses"].map(|name| package.folder.join(name));
    let entries = folders
        .iter()
        .filter(|folder| folder.is_dir())
        .map(|folder| std::fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display())));
    let entries: Vec<_> = entries.collect::<Result<_, _>>()?;
    let word = if package.licence == Licence::Mit { "MIT" } else { "APACHE" };
    let mut files: Vec<(bool, PathBuf)> = entries
        .into_iter()
        .flatten()
        .filter_map(|entry| Some(entry.ok()?.path()).filter(|path| path.is_file()))
        .filter_map(|path| Some((path.file_name()?.to_str()?.to_uppercase(), path)))
        .filter(|(name, path)| name.starts_with("LICEN") || path.parent() == Some(&folders[1]))
        .map(|(name, path)| (!name.contains(word), path))
        .collect();
    files.sort_unstable();
    for (_, file) in files {
        let text = read(&file)?;
        if let Some(terms) = terms(&text, package.licence) {
            return Ok(Some((text, terms)));
        }
    }
    Ok(None)
}

/// Where no copyright line says whose work it is, the manifest does.
fn authors(package: &Package) -> Result<String, String> {
    let manifest = read(&package.folder.join("Cargo.toml"))?;
    let after = |key: &str| Some(manifest.split_once(&format!("\n{key} = "))?.1);
    let list = after("authors").and_then(|rest| Some(rest.strip_prefix('[')?.split_once(']')?.0));
    let names: Vec<&str> = list.unwrap_or_default().split('"').skip(1).step_by(2).collect();
    let repository = after("repository").and_then(|rest| rest.strip_prefix('"')?.split_once('"'));
    let names: Vec<&str> = names.into_iter().map(|name| name.split(" <").next().unwrap_or(name)).collect();
    match (names.is_empty(), repository) {
        (false, _) => Ok(format!("by {}", names.join(", "))),
        (true, Some((repository, _))) => Ok(format!("by the authors of {repository}")),
        (true, None) => {
            Err(format!("{}: neither a licence file nor its manifest says whose work it is", package.title))
        }
    }
}

/// The terms in one line of lower case, without what stands around them.
fn terms(text: &str, licence: Licence) -> Option<String> {
    let words: Vec<String> =
        text.split_whitespace().map(|word| word.trim_matches(['"', '“', '”', '\'']).to_lowercase()).collect();
    let text = words.join(" ");
    let (first, last) = match licence {
        Licence::Mit => ("permission is hereby granted, free of charge", "dealings in the software"),
        Licence::Own => return None,
        Licence::Apache => {
            ("terms and conditions for use, reproduction, and distribution", "end of terms and conditions")
        }
    };
    let start = text.find(first)?;
    let end = start + text[start..].find(last)? + last.len();
    Some(text[start..end].to_owned())
}

fn is_copyright(line: &str) -> bool {
    let line = line.trim().to_lowercase();
    let rest = line.strip_prefix("copyright ").unwrap_or_default();
    line.starts_with('©') || rest.starts_with(['©', '1', '2']) || rest.starts_with("(c) ")
}

fn read(path: &Path) -> Result<String, String> {
    let text = std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    Ok(text.replace("\r\n", "\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    const MIT: &str =
        "MIT License\n\nCopyright (c) 2020 A. Nobody\n\nPermission is hereby granted, free of charge, to\nsome,
        \"with\" OTHER DEALINGS IN THE SOFTWARE.\nThe end.";

    #[test]
    fn terms_are_the_same_whatever_stands_around_them_and_wherever_lines_break() {
        let other = MIT.replace("A. Nobody", "B. Somebody").replace(",\n", ", ").replace("MIT License", "");
        assert_eq!(terms(MIT, Licence::Mit), terms(&other, Licence::Mit));
        assert_ne!(terms(MIT, Licence::Mit), terms(&MIT.replace("some", "none"), Licence::Mit));
        assert_eq!(terms(MIT, Licence::Apache), None);
    }

    #[test]
    fn copyright_lines_are_told_from_sentences_about_copyright() {
        for line in ["Copyright (c) Microsoft Corporation.", "  Copyright 2018 Developers", "© 2020 A. Nobody"] {
            assert!(is_copyright(line), "{line}");
        }
        for line in ["Copyright holders be liable", "copyright notice that is included", "The above copyright notice"] {
            assert!(!is_copyright(line), "{line}");
        }
    }
}

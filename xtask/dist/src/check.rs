//! Packages written, read back and compared.

use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

use crate::contents::{Contents, Packed};
use crate::{archive, whole};

/// Packs a program into a folder; gives what went in, and the place of the archive.
pub(crate) fn packed(root: &Path, command: &Path, folder: &Path) -> Result<(Contents, PathBuf), String> {
    let contents = Contents::read(root, command)?;
    let path = folder.join(format!("{}.tar.gz", archive::name(&contents)));
    whole::write(&path, &archive::bytes(&archive::files(&contents))?)?;
    Ok((contents, path))
}

/// Packs a program, and complains where the archive gives back other files than went in.
pub(crate) fn check(root: &Path, command: &Path, folder: &Path) -> Result<Vec<String>, String> {
    let (contents, path) = packed(root, command, folder)?;
    let bytes = read(&path)?;
    println!("{} ({:.1} MB)", path.display(), bytes.len() as f64 / 1e6);
    Ok(others(&path, &archive::unpack(&bytes)?, &archive::files(&contents)))
}

/// Writes the checksums of all packages of a folder into its file `SHA256SUMS`, as `sha256sum --check` reads them.
pub(crate) fn sums(folder: &Path) -> Result<PathBuf, String> {
    let entries = std::fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut names: Vec<String> =
        entries.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.retain(|name| [".tar.gz", ".whl"].iter().any(|end| name.ends_with(end)));
    names.sort();
    let line = |name: &String| {
        let digest = Sha256::digest(read(&folder.join(name))?);
        let digits: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
        Ok(format!("{digits}  {name}\n"))
    };
    let text = names.iter().map(line).collect::<Result<String, String>>()?;
    let path = folder.join("SHA256SUMS");
    whole::write(&path, text.as_bytes())?;
    Ok(path)
}

fn others(package: &Path, found: &[Packed], expected: &[Packed]) -> Vec<String> {
    if found == expected {
        return Vec::new();
    }
    let places = |files: &[Packed]| files.iter().map(|file| file.path.clone()).collect::<Vec<_>>().join(" ");
    let (there, expected) = (places(found), places(expected));
    vec![format!("{} gives back other files than went in: {there}; expected: {expected}", package.display())]
}

fn read(path: &Path) -> Result<Vec<u8>, String> {
    std::fs::read(path).map_err(|error| format!("cannot read {}: {error}", path.display()))
}

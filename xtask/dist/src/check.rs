//! Packages written, read back and compared.

use std::path::{Path, PathBuf};

use crate::contents::{Contents, Packed};
use crate::{archive, record, wheel, whole};

/// Packs a program into a folder; gives what went in, and the places of archive and wheel.
pub(crate) fn packed(root: &Path, command: &Path, folder: &Path) -> Result<(Contents, [PathBuf; 2]), String> {
    let contents = Contents::read(root, command)?;
    let names = [format!("{}.tar.gz", archive::name(&contents)), wheel::name(&contents)];
    // as much work each
    let (of_archive, of_wheel) = std::thread::scope(|scope| {
        let of_archive = scope.spawn(|| archive::bytes(&archive::files(&contents)));
        let of_wheel = wheel::bytes(&wheel::files(&contents));
        (of_archive.join().unwrap_or_else(|_| Err("packing the archive panicked".to_owned())), of_wheel)
    });
    let paths = names.map(|name| folder.join(name));
    whole::write(&paths[0], &of_archive?)?;
    whole::write(&paths[1], &of_wheel?)?;
    Ok((contents, paths))
}

/// Packs a program, and complains where a package gives back other files than went in or its RECORD is wrong.
pub(crate) fn check(root: &Path, command: &Path, folder: &Path) -> Result<Vec<String>, String> {
    let (contents, [of_archive, of_wheel]) = packed(root, command, folder)?;
    let unpacked = archive::unpack(&read(&of_archive)?)?;
    let mut complaints = others(&of_archive, &unpacked, &archive::files(&contents));
    let unpacked = wheel::unpack(&read(&of_wheel)?)?;
    complaints.extend(others(&of_wheel, &unpacked, &wheel::files(&contents)));
    let place = wheel::record_place(&contents.version);
    let record = unpacked.iter().find(|file| file.path == place);
    let record = record.map(|file| String::from_utf8_lossy(&file.bytes)).unwrap_or_default();
    complaints.extend(record::differences(&unpacked, &record, &place));
    for path in [of_archive, of_wheel] {
        let size = std::fs::metadata(&path).map(|data| data.len()).unwrap_or_default();
        println!("{} ({:.1} MB)", path.display(), size as f64 / 1e6);
    }
    Ok(complaints)
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

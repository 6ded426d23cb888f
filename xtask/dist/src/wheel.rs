//! The wheel: a zip file from which pip puts the command among the programs of a Python environment (PEP 427).

use std::io::{Cursor, Read, Write};

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipArchive, ZipWriter};

use crate::contents::{Contents, Packed};
use crate::record;

/// Name of the file, which pip reads for version and machines.
pub(crate) fn name(contents: &Contents) -> String {
    format!("cdpr-{}-{}.whl", contents.version, tag(contents))
}

/// Place of RECORD in the wheel of a version.
pub(crate) fn record_place(version: &str) -> String {
    format!("cdpr-{version}.dist-info/RECORD")
}

/// Any Python 3, no binary interface of it, these machines.
fn tag(contents: &Contents) -> String {
    format!("py3-none-{}", contents.platform.tag)
}

/// Files of the wheel in their order; what describes it stands last, as the format recommends.
pub(crate) fn files(contents: &Contents) -> Vec<Packed> {
    let info = |name: &str| format!("cdpr-{}.dist-info/{name}", contents.version);
    let program = Packed {
        path: format!("cdpr-{}.data/scripts/{}", contents.version, contents.program.path),
        ..contents.program.clone()
    };
    let mut files = vec![program];
    let licences = contents.licences.iter();
    files.extend(licences.map(|file| Packed { path: info(&format!("licenses/{}", file.path)), ..file.clone() }));
    files.push(Packed::data(info("METADATA"), metadata(contents)));
    files.push(Packed::data(info("WHEEL"), description(contents)));
    let place = record_place(&contents.version);
    files.push(Packed::data(place.clone(), record::text(&files, &place)));
    files
}

/// Head of the package (core metadata 2.4) with the README as its page.
fn metadata(contents: &Contents) -> String {
    let licences: String = contents.licences.iter().map(|file| format!("License-File: {}\n", file.path)).collect();
    let page = contents.pages.iter().find(|page| page.path == "README.md");
    let page = page.map(|page| String::from_utf8_lossy(&page.bytes)).unwrap_or_default();
    format!(
        "Metadata-Version: 2.4\nName: cdpr\nVersion: {}\n\
         Summary: The cdpr command: calibration and model selection for cable-driven parallel robots\n\
         Keywords: robotics,cable-robot,calibration,kinematics\nLicense-Expression: MIT OR Apache-2.0\n{licences}\
         Requires-Python: >=3\nDescription-Content-Type: text/markdown\n\n{page}",
        contents.version,
    )
}

fn description(contents: &Contents) -> String {
    let tag = tag(contents);
    format!("Wheel-Version: 1.0\nGenerator: cdpr {}\nRoot-Is-Purelib: false\nTag: {tag}\n", contents.version)
}

/// Bytes of the wheel: a function of the files alone.
pub(crate) fn bytes(files: &[Packed]) -> Result<Vec<u8>, String> {
    let told = |error: &dyn std::error::Error| format!("the wheel cannot be packed: {error}");
    let mut wheel = ZipWriter::new(Cursor::new(Vec::new()));
    for file in files {
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Deflated)
            .last_modified_time(DateTime::default())
            .unix_permissions(file.mode());
        wheel.start_file(&file.path, options).map_err(|error| told(&error))?;
        wheel.write_all(&file.bytes).map_err(|error| told(&error))?;
    }
    Ok(wheel.finish().map_err(|error| told(&error))?.into_inner())
}

/// Files of a wheel, in its order.
pub(crate) fn unpack(bytes: &[u8]) -> Result<Vec<Packed>, String> {
    let told = |error: &dyn std::error::Error| format!("the wheel cannot be read: {error}");
    let mut wheel = ZipArchive::new(Cursor::new(bytes)).map_err(|error| told(&error))?;
    let mut files = Vec::new();
    for i in 0..wheel.len() {
        let mut file = wheel.by_index(i).map_err(|error| told(&error))?;
        let is_program = file.unix_mode().is_some_and(|mode| mode & 0o111 != 0);
        let path = file.name().map_err(|error| told(&error))?.into_owned();
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(|error| told(&error))?;
        files.push(Packed { path, bytes, is_program });
    }
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::platform::Platform;

    fn contents() -> Contents {
        let platform = Platform { target: "x".to_owned(), tag: "manylinux_2_34_x86_64".to_owned() };
        Contents {
            version: "1.2.3".to_owned(),
            platform,
            program: Packed::program("cdpr", vec![1; 1000]),
            licences: vec![Packed::data("LICENSE-MIT", "free")],
            pages: vec![Packed::data("README.md", "# cdpr\n")],
            helps: Vec::new(),
        }
    }

    #[test]
    fn a_wheel_gives_back_what_went_in_and_has_the_same_bytes_again() {
        let files = files(&contents());
        let packed = bytes(&files).unwrap();
        assert_eq!(packed, bytes(&files).unwrap());
        assert_eq!(unpack(&packed).unwrap(), files);
    }

    #[test]
    fn the_program_is_started_and_the_record_names_all() {
        let files = files(&contents());
        assert_eq!(files[0].path, "cdpr-1.2.3.data/scripts/cdpr");
        assert!(files[0].is_program && files[1..].iter().all(|file| !file.is_program));
        let (last, place) = (files.last().unwrap(), record_place("1.2.3"));
        assert_eq!(last.path, place);
        let record = String::from_utf8(last.bytes.clone()).unwrap();
        assert!(record::differences(&files, &record, &place).is_empty());
        assert_eq!(name(&contents()), "cdpr-1.2.3-py3-none-manylinux_2_34_x86_64.whl");
    }
}

//! The archive: a compressed tar file with one folder.

use std::io::{Cursor, Read};

use flate2::Compression;
use flate2::read::GzDecoder;
use flate2::write::GzEncoder;

use crate::contents::{Contents, Packed, TIME};

/// Name of the archive without its extension, and of the folder in it.
pub(crate) fn name(contents: &Contents) -> String {
    format!("cdpr-{}-{}", contents.version, contents.target)
}

/// Files of the archive, sorted by their places.
pub(crate) fn files(contents: &Contents) -> Vec<Packed> {
    let all =
        [&contents.licences[..], &contents.pages, &contents.helps, std::slice::from_ref(&contents.program)].concat();
    let mut files: Vec<Packed> =
        all.into_iter().map(|file| Packed { path: format!("{}/{}", name(contents), file.path), ..file }).collect();
    files.sort_unstable_by(|a, b| a.path.cmp(&b.path));
    files
}

/// Bytes of the archive: a function of the files alone.
pub(crate) fn bytes(files: &[Packed]) -> Result<Vec<u8>, String> {
    let told = |error: std::io::Error| format!("the archive cannot be packed: {error}");
    // flate2 states neither time nor system in the header
    let mut archive = tar::Builder::new(GzEncoder::new(Vec::new(), Compression::default()));
    for file in files {
        let mut header = tar::Header::new_ustar();
        header.set_size(file.bytes.len() as u64);
        header.set_mode(file.mode());
        header.set_mtime(TIME);
        header.set_uid(0);
        header.set_gid(0);
        archive.append_data(&mut header, &file.path, &file.bytes[..]).map_err(told)?;
    }
    archive.into_inner().and_then(GzEncoder::finish).map_err(told)
}

/// Files of an archive, in its order.
pub(crate) fn unpack(bytes: &[u8]) -> Result<Vec<Packed>, String> {
    let told = |error: std::io::Error| format!("the archive cannot be read: {error}");
    let mut whole = Vec::new();
    // to its end, where the sum of all bytes is compared
    GzDecoder::new(bytes).read_to_end(&mut whole).map_err(told)?;
    let mut archive = tar::Archive::new(Cursor::new(whole));
    let file = |entry: std::io::Result<tar::Entry<'_, _>>| {
        let mut entry = entry?;
        let path = entry.path()?.display().to_string();
        let is_program = entry.header().mode()? & 0o111 != 0;
        let mut bytes = Vec::new();
        entry.read_to_end(&mut bytes)?;
        Ok(Packed { path, bytes, is_program })
    };
    archive.entries().map_err(told)?.map(file).collect::<std::io::Result<_>>().map_err(told)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_archive_gives_back_what_went_in_and_has_the_same_bytes_again() {
        let files = [Packed::data("a/README.md", "read"), Packed::program("a/cdpr", vec![7; 100_000])];
        let packed = bytes(&files).unwrap();
        assert_eq!(packed, bytes(&files).unwrap());
        assert_eq!(unpack(&packed).unwrap(), files);
        assert!(packed.len() < 1000, "{} bytes", packed.len());
    }

    #[test]
    fn an_archive_that_is_cut_off_is_an_error() {
        let packed = bytes(&[Packed::data("a/b", vec![1; 5000])]).unwrap();
        assert!(unpack(&packed[..packed.len() - 8]).is_err());
    }
}

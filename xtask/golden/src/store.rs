//! The committed answers: one JSON object by the names of calls, compressed.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{Read, Write};
use std::path::Path;

use flate2::Compression;
use flate2::read::GzDecoder;
use flate2::write::GzEncoder;
use serde_json::Value;

/// Largest size of the file (bytes).
pub(crate) const LARGEST: u64 = 3_000_000;

/// Reads the committed answers; none if there is no file yet.
pub(crate) fn read(path: &Path) -> Result<BTreeMap<String, Value>, String> {
    if !path.exists() {
        return Ok(BTreeMap::new());
    }
    let told = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
    let mut text = String::new();
    let file = File::open(path).map_err(|error| told(&error))?;
    GzDecoder::new(file).read_to_string(&mut text).map_err(|error| told(&error))?;
    serde_json::from_str(&text).map_err(|error| told(&error))
}

/// Writes them; the same answers give the same bytes. Returns the size of the file (bytes).
pub(crate) fn write(path: &Path, answers: &BTreeMap<String, Value>) -> Result<u64, String> {
    let told = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
    let text = serde_json::to_string(answers).map_err(|error| told(&error))?;
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(text.as_bytes()).map_err(|error| told(&error))?;
    let bytes = encoder.finish().map_err(|error| told(&error))?;
    std::fs::write(path, &bytes).map_err(|error| told(&error))?;
    Ok(bytes.len() as u64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn what_is_written_is_read_and_the_same_answers_are_the_same_bytes() {
        let path = std::env::temp_dir().join(format!("cdpr-golden-store-{}.gz", std::process::id()));
        let answers = BTreeMap::from([("robots: check cogiro".to_owned(), json!({"exit": 0, "answer": {"x_m": 0.1}}))]);
        let size = write(&path, &answers).expect("the folder of temporary files takes one");
        let bytes = std::fs::read(&path).expect("it was written");
        assert_eq!((size, read(&path)), (bytes.len() as u64, Ok(answers.clone())));
        write(&path, &answers).expect("the folder of temporary files takes one");
        assert_eq!(std::fs::read(&path).ok(), Some(bytes));
        assert!(std::fs::remove_file(&path).is_ok() && read(&path) == Ok(BTreeMap::new()));
    }
}

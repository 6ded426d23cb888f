//! RECORD of a wheel: every file with the hash of its bytes and their number.

use sha2::{Digest, Sha256};

use crate::contents::Packed;

/// Characters of Base64 for names of files and addresses (RFC 4648, section 5).
const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/// Text of a RECORD at a place, which it names without a hash.
pub(crate) fn text(files: &[Packed], place: &str) -> String {
    let lines = files.iter().map(|file| format!("{},{},{}\n", file.path, hash(&file.bytes), file.bytes.len()));
    lines.chain([format!("{place},,\n")]).collect()
}

/// Complaints about files that differ from a RECORD, that it lacks, and of which only it knows.
pub(crate) fn differences(files: &[Packed], record: &str, place: &str) -> Vec<String> {
    let mut complaints = Vec::new();
    let mut named = vec![place];
    for line in record.lines() {
        let [path, hash_there, size] = line.split(',').collect::<Vec<_>>()[..] else {
            complaints.push(format!("RECORD: `{line}` is no path with hash and size"));
            continue;
        };
        let file = files.iter().find(|file| file.path == path);
        match file {
            None => complaints.push(format!("RECORD names {path}, which is not in the wheel")),
            Some(_) if path == place => {}
            Some(file) if hash_there == hash(&file.bytes) && size == file.bytes.len().to_string() => {}
            Some(_) => complaints.push(format!("{path} is not the file of which RECORD has hash and size")),
        }
        named.push(path);
    }
    let lacking = files.iter().filter(|file| !named.contains(&file.path.as_str()));
    complaints.extend(lacking.map(|file| format!("RECORD lacks {}", file.path)));
    complaints
}

/// `sha256=` and the hash in Base64 without the signs that fill it up (PEP 427).
fn hash(bytes: &[u8]) -> String {
    format!("sha256={}", base64(&Sha256::digest(bytes)))
}

fn base64(bytes: &[u8]) -> String {
    let letters = |three: &[u8]| {
        let number = (0..3).fold(0, |sum, i| sum << 8 | usize::from(three.get(i).copied().unwrap_or(0)));
        (0..=three.len()).map(move |i| char::from(LETTERS[number >> (18 - 6 * i) & 63])).collect::<String>()
    };
    bytes.chunks(3).map(letters).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Test vectors of RFC 4648, section 10, without the signs that fill up.
    #[test]
    fn base64_is_that_of_the_rfc() {
        let words = ["", "f", "fo", "foo", "foob", "fooba", "foobar"];
        let expected = ["", "Zg", "Zm8", "Zm9v", "Zm9vYg", "Zm9vYmE", "Zm9vYmFy"];
        assert_eq!(words.map(|word| base64(word.as_bytes())), expected);
        assert_eq!(base64(&[0xfb, 0xff]), "-_8");
    }

    /// The hash of nothing, as every program prints it: e3b0c442…
    #[test]
    fn hashes_are_those_of_sha_256() {
        assert_eq!(hash(b""), "sha256=47DEQpj8HBSa-_TImW-5JCeuQeRkm5NMpJWZG3hSuFU");
    }

    #[test]
    fn a_changed_a_forgotten_and_a_lost_file_are_told() {
        let mut files = vec![Packed::data("a", "1"), Packed::data("b", "2")];
        let record = text(&files, "RECORD");
        files.push(Packed::data("RECORD", record.clone()));
        assert!(differences(&files, &record, "RECORD").is_empty());
        files[0].bytes = b"3".to_vec();
        files[1].path = "c".to_owned();
        let told = differences(&files, &record, "RECORD");
        assert_eq!(told.len(), 3, "{told:?}");
    }
}

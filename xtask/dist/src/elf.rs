//! Which symbols a program for Linux asks of shared libraries, as its file says (ELF, section `.gnu.version_r`).

/// Type of the section with the versions of symbols that a program needs (SHT_GNU_verneed).
const VERSIONS_NEEDED: u64 = 0x6fff_fffe;

/// Machine and C library of a compiled program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Program {
    /// Number of the processor's kind (e_machine).
    pub(crate) machine: u64,
    /// A shared library and a version of symbols of it, such as `libc.so.6` and `GLIBC_2.34`.
    pub(crate) versions: Vec<(String, String)>,
}

impl Program {
    /// Reads the head of a program; `None` of anything but a whole program of 64 bits with the low byte first.
    pub(crate) fn read(bytes: &[u8]) -> Option<Self> {
        let file = Bytes(bytes);
        if !bytes.starts_with(b"\x7fELF\x02\x01") {
            return None;
        }
        let head = |offset, size| file.number(0, offset, size);
        let (start, size, count) = (head(0x28, 8)?, head(0x3a, 2)?, head(0x3c, 2)?);
        let section = |index: u64| start.checked_add(index.checked_mul(size)?);
        let mut versions = Vec::new();
        for index in 0..count {
            let own = section(index)?;
            if file.number(own, 4, 4)? == VERSIONS_NEEDED {
                let names = file.number(section(file.number(own, 40, 4)?)?, 24, 8)?;
                versions.extend(file.versions(file.number(own, 24, 8)?, file.number(own, 44, 4)?, names)?);
            }
        }
        Some(Self { machine: head(0x12, 2)?, versions })
    }
}

struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    /// The whole number at an offset from a place, of as many bytes; `None` beyond the end.
    fn number(&self, place: u64, offset: u64, size: usize) -> Option<u64> {
        let start = usize::try_from(place.checked_add(offset)?).ok()?;
        let bytes = self.0.get(start..start.checked_add(size)?)?;
        Some(bytes.iter().rev().fold(0, |sum, byte| sum << 8 | u64::from(*byte)))
    }

    /// The text at an offset from a place, up to the byte 0.
    fn text(&self, place: u64, offset: u64) -> Option<String> {
        let bytes = self.0.get(usize::try_from(place.checked_add(offset)?).ok()?..)?;
        let end = bytes.iter().position(|byte| *byte == 0)?;
        String::from_utf8(bytes[..end].to_vec()).ok()
    }

    /// Chain of libraries, each with a chain of versions; names stand in a section of their own.
    fn versions(&self, mut library: u64, count: u64, names: u64) -> Option<Vec<(String, String)>> {
        let mut all = Vec::new();
        for _ in 0..count {
            let name = self.text(names, self.number(library, 4, 4)?)?;
            let mut version = library.checked_add(self.number(library, 8, 4)?)?;
            for _ in 0..self.number(library, 2, 2)? {
                all.push((name.clone(), self.text(names, self.number(version, 8, 4)?)?));
                version = version.checked_add(self.number(version, 12, 4)?)?;
            }
            library = library.checked_add(self.number(library, 12, 4)?)?;
        }
        Some(all)
    }
}

#[cfg(test)]
#[cfg(all(target_os = "linux", target_env = "gnu"))]
mod tests {
    use super::*;

    fn this_test() -> Vec<u8> {
        std::fs::read(std::env::current_exe().unwrap()).unwrap()
    }

    #[test]
    fn a_program_of_rust_needs_the_c_library() {
        let program = Program::read(&this_test()).unwrap();
        let of_libc = |(library, version): &(String, String)| library == "libc.so.6" && version.starts_with("GLIBC_2.");
        assert!(program.versions.iter().any(of_libc), "{:?}", program.versions);
    }

    /// objdump reads the same file by code of other people.
    #[test]
    fn versions_are_those_that_objdump_lists() {
        let path = std::env::current_exe().unwrap();
        let Ok(listed) = std::process::Command::new("objdump").arg("-T").arg(path).output() else {
            return; // not on this machine: the test above still reads the file
        };
        let listed = String::from_utf8_lossy(&listed.stdout);
        let mut expected: Vec<&str> =
            listed.split_whitespace().map(|word| word.trim_matches(['(', ')'])).filter(|word| is_glibc(word)).collect();
        expected.sort_unstable();
        expected.dedup();
        let program = Program::read(&this_test()).unwrap();
        let mut found: Vec<&str> =
            program.versions.iter().map(|(_, version)| version.as_str()).filter(|version| is_glibc(version)).collect();
        found.sort_unstable();
        found.dedup();
        assert_eq!(found, expected);
    }

    fn is_glibc(word: &str) -> bool {
        word.starts_with("GLIBC_")
    }

    #[test]
    fn a_damaged_program_is_none_and_no_panic() {
        let whole = this_test();
        assert_eq!(Program::read(&whole[..whole.len().min(300)]), None);
        assert_eq!(Program::read(b"#!/bin/sh\n"), None);
        let mut head = whole;
        for place in 0x28..0x40 {
            head[place] = 0xff;
            let _ = Program::read(&head);
        }
    }
}

//! Machines that a program runs on, in the words of Rust and of Python.

use crate::elf::Program;

/// Processors by their number in the file of a program.
const PROCESSORS: [(u64, &str); 2] = [(62, "x86_64"), (183, "aarch64")];

/// Shared libraries that every Linux with the C library of GNU has (PEP 600).
const EVERYWHERE: [&str; 8] = [
    "ld-linux-aarch64.so.1",
    "ld-linux-x86-64.so.2",
    "libc.so.6",
    "libdl.so.2",
    "libgcc_s.so.1",
    "libm.so.6",
    "libpthread.so.0",
    "librt.so.1",
];

const NOT_KNOWN: &str = "the program is not for Linux with the C library of GNU on x86_64 or aarch64, and packages are \
                         made of no others yet; their target and tag belong into xtask/dist/src/platform.rs";

/// Target of a program and the tag of its wheel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Platform {
    /// As rustc calls it.
    pub(crate) target: String,
    /// Platform tag of a wheel: the oldest C library that has all symbols; the system alone where other libraries are
    /// needed.
    pub(crate) tag: String,
}

impl Platform {
    /// As the file of the program says.
    pub(crate) fn of(program: &[u8]) -> Result<Self, String> {
        let known = Program::read(program).and_then(|program| {
            let (_, processor) = PROCESSORS.iter().find(|(number, _)| *number == program.machine)?;
            Some((*processor, newest(&program)?, program))
        });
        let Some((processor, minor, program)) = known else {
            return Err(NOT_KNOWN.to_owned());
        };
        let is_everywhere = program.versions.iter().all(|(library, _)| EVERYWHERE.contains(&library.as_str()));
        let system = if is_everywhere { format!("manylinux_2_{minor}") } else { "linux".to_owned() };
        Ok(Self { target: format!("{processor}-unknown-linux-gnu"), tag: format!("{system}_{processor}") })
    }
}

/// Newest minor version of the C library whose symbols are needed; `None` if none is.
fn newest(program: &Program) -> Option<u32> {
    let minor = |version: &String| version.strip_prefix("GLIBC_2.")?.split('.').next()?.parse::<u32>().ok();
    program.versions.iter().filter_map(|(_, version)| minor(version)).max()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_newest_symbol_counts_by_its_number() {
        let needs = ["GLIBC_2.2.5", "GLIBC_2.34", "GLIBC_2.9", "GCC_3.0"];
        let versions = needs.map(|version| ("libc.so.6".to_owned(), version.to_owned())).to_vec();
        assert_eq!(newest(&Program { machine: 62, versions }), Some(34));
        assert_eq!(newest(&Program { machine: 62, versions: Vec::new() }), None);
    }

    #[test]
    fn a_program_of_another_system_is_told() {
        assert!(Platform::of(b"MZ").unwrap_err().contains("platform.rs"));
    }
}

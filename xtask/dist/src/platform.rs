//! Machines that a program runs on, in the words of Rust.

/// First bytes of a program of 64 bits with the low byte first.
const HEAD: &[u8] = b"\x7fELF\x02\x01";

/// Place of the number of the processor in the file of a program (ELF, `e_machine`).
const PROCESSOR: usize = 0x12;

/// Processors by their number there.
const PROCESSORS: [(u16, &str); 2] = [(62, "x86_64"), (183, "aarch64")];

const NOT_KNOWN: &str = "the program is not for Linux on x86_64 or aarch64, and archives are made of no others yet; their target belongs \
                         into xtask/dist/src/platform.rs";

/// Target of a program, as rustc calls it, by the head of its file.
pub(crate) fn target(program: &[u8]) -> Result<String, String> {
    let number = program.get(PROCESSOR..PROCESSOR + 2).filter(|_| program.starts_with(HEAD));
    let number = number.map(|bytes| u16::from_le_bytes([bytes[0], bytes[1]]));
    let known = PROCESSORS.iter().find(|(own, _)| Some(*own) == number);
    known.map(|(_, processor)| format!("{processor}-unknown-linux-gnu")).ok_or_else(|| NOT_KNOWN.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_processor_is_read_from_the_head_and_other_systems_are_told() {
        let mut program = [HEAD, &[0; 20]].concat();
        program[PROCESSOR] = 183;
        assert_eq!(target(&program).unwrap(), "aarch64-unknown-linux-gnu");
        assert!(target(b"MZ").unwrap_err().contains("platform.rs"));
        assert_eq!(target(&program[..PROCESSOR + 1]), Err(NOT_KNOWN.to_owned()));
    }
}

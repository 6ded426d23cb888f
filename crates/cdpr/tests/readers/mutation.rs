//! Damaged files, the same for the same seed.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Words that readers give a meaning to, and numbers at the ends of their range.
const WORDS: [&str; 48] = [
    "nan",
    "inf",
    "-inf",
    "1e308",
    "-1e308",
    "1e400",
    "1e-320",
    "0",
    "-0.0",
    "-1",
    "0.1",
    "9223372036854775808",
    "1_000",
    "0x7fffffff",
    "true",
    "\"2T\"",
    "\"3R3T\"",
    "\"\"",
    "\"\\u0000\"",
    "[]",
    "{}",
    "[[]]",
    "[[[[[[[[",
    "[0.6, 0.0, 0.8]",
    "[1.0, 2.0]",
    "\"\"\"",
    "'''",
    "#",
    "=",
    "[[cable]]",
    "[poses.grid]",
    "count = [1000000, 1000000, 1000, 1, 1, 1]",
    "count = 18446744073709551615",
    "1979-05-27T07:32:00Z",
    "\u{feff}",
    "\u{202e}",
    ",,,,",
    "\"\n\"",
    "\r\n",
    "\0",
    "<a>",
    "</location>",
    "<!--",
    "<![CDATA[",
    "&#0;",
    "&x;",
    "<!ENTITY",
    "xmlns=''",
];

/// A file of the corpus with one to five damages; now and then just bytes.
pub(crate) fn mutated(corpus: &[Vec<u8>], seed: u64) -> Vec<u8> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    if rng.random_range(0..50) == 0 {
        return (0..rng.random_range(0..400)).map(|_| rng.random()).collect();
    }
    let mut bytes = corpus[rng.random_range(0..corpus.len())].clone();
    for _ in 0..rng.random_range(1..=5) {
        damage(&mut bytes, corpus, &mut rng);
    }
    bytes
}

fn damage(bytes: &mut Vec<u8>, corpus: &[Vec<u8>], rng: &mut ChaCha8Rng) {
    let at = rng.random_range(0..=bytes.len());
    let to = (at + rng.random_range(1..200_usize)).min(bytes.len());
    match rng.random_range(0..9) {
        0 if at < bytes.len() => bytes[at] ^= 1 << rng.random_range(0..8),
        1 if at < bytes.len() => bytes[at] = rng.random(),
        2 => drop(bytes.drain(at..to)),
        3 => {
            let part = bytes[at..to].to_vec();
            let target = rng.random_range(0..=bytes.len());
            bytes.splice(target..target, part);
        }
        4 => {
            let word = WORDS[rng.random_range(0..WORDS.len())];
            bytes.splice(at..at, word.bytes());
        }
        5 => {
            let other = &corpus[rng.random_range(0..corpus.len())];
            let from = rng.random_range(0..=other.len());
            let end = (from + rng.random_range(1..400_usize)).min(other.len());
            bytes.splice(at..to, other[from..end].iter().copied());
        }
        6 => swap_lines(bytes, rng),
        7 => {
            // the same line many times, or a deep nest
            let part = bytes[at..to.min(at + 20)].to_vec();
            let times = rng.random_range(2..200);
            bytes.splice(at..at, part.repeat(times));
        }
        _ => replace_number(bytes, at, rng),
    }
}

fn swap_lines(bytes: &mut Vec<u8>, rng: &mut ChaCha8Rng) {
    let mut lines: Vec<&[u8]> = bytes.split(|byte| *byte == b'\n').collect();
    let (one, other) = (rng.random_range(0..lines.len()), rng.random_range(0..lines.len()));
    lines.swap(one, other);
    *bytes = lines.join(&b'\n');
}

/// Another value for the number at or after a place.
fn replace_number(bytes: &mut Vec<u8>, at: usize, rng: &mut ChaCha8Rng) {
    let is_part = |byte: &u8| byte.is_ascii_digit() || b"+-.eE_".contains(byte);
    let Some(start) = bytes[at..].iter().position(u8::is_ascii_digit).map(|offset| at + offset) else { return };
    let end = bytes[start..].iter().position(|byte| !is_part(byte)).map_or(bytes.len(), |length| start + length);
    let value = match rng.random_range(0..3) {
        0 => WORDS[rng.random_range(0..14)].to_owned(),
        1 => format!("{:e}", f64::from_bits(rng.random())),
        _ => rng.random_range(-1000..1000_i32).to_string(),
    };
    bytes.splice(start..end, value.bytes());
}

//! Text of a table in any encoding that loggers and spreadsheets write.

use std::borrow::Cow;

use encoding_rs::{Encoding, UTF_16BE, UTF_16LE, WINDOWS_1252};

use super::{ReadError, Size, TextPlace, text_from_bytes};

/// Number of bytes at the start that are tested for UTF-16 without a byte order mark.
const LOOKED_AT: usize = 512;

/// A table as text, with its encoding if that is not UTF-8.
pub(crate) struct TableText<'a> {
    pub(crate) text: Cow<'a, str>,
    /// Name of the encoding, for messages.
    pub(crate) encoding: Option<&'static str>,
}

/// Decodes a table: UTF-8, otherwise UTF-16, otherwise Latin-1; control characters of a binary file are an error.
pub(crate) fn table_text<'a>(bytes: &'a [u8], file_name: &str) -> Result<TableText<'a>, ReadError> {
    Size::Table.check(bytes.len() as u64, file_name)?;
    if let Some(encoding) = utf_16(bytes) {
        return from_utf_16(bytes, encoding, file_name);
    }
    match std::str::from_utf8(bytes) {
        Ok(text) => Ok(TableText { text: Cow::Borrowed(text.trim_start_matches('\u{feff}')), encoding: None }),
        Err(_) if bytes.iter().copied().any(is_control) => text_from_bytes(bytes, Size::Table, file_name)
            .map(|text| TableText { text: Cow::Borrowed(text), encoding: None }),
        Err(_) => {
            // the superset of Latin-1 that spreadsheets write; every byte is valid in it
            let text = WINDOWS_1252.decode_without_bom_handling(bytes).0;
            Ok(TableText { text, encoding: Some("Latin-1") })
        }
    }
}

fn from_utf_16<'a>(bytes: &'a [u8], encoding: &'static Encoding, file_name: &str) -> Result<TableText<'a>, ReadError> {
    let (text, is_wrong) = encoding.decode_with_bom_removal(bytes);
    if !is_wrong {
        return Ok(TableText { text: Cow::Owned(text.into_owned()), encoding: Some("UTF-16") });
    }
    let wrong = text.find('\u{fffd}').unwrap_or_default();
    let place = TextPlace::of_span(&text, wrong..wrong);
    Err(ReadError::new(file_name, "file::not-utf8", "this is UTF-16 with a character that does not exist")
        .at(place)
        .with_help("save the file as UTF-8"))
}

/// The kind of UTF-16: by its byte order mark, otherwise by zeros in every other byte, as in text of Western languages.
fn utf_16(bytes: &[u8]) -> Option<&'static Encoding> {
    if let Some((encoding, _)) = Encoding::for_bom(bytes) {
        return [UTF_16LE, UTF_16BE].into_iter().find(|utf_16| *utf_16 == encoding);
    }
    let start = &bytes[..bytes.len().min(LOOKED_AT)];
    let zeros = |odd: usize| start.iter().skip(odd).step_by(2).filter(|byte| **byte == 0).count();
    let (even, odd) = (zeros(0), zeros(1));
    let most = start.len() / 2 * 9 / 10;
    match () {
        () if start.len() < 4 => None,
        () if even == 0 && odd > most => Some(UTF_16LE),
        () if odd == 0 && even > most => Some(UTF_16BE),
        () => None,
    }
}

fn is_control(byte: u8) -> bool {
    byte.is_ascii_control() && !matches!(byte, b'\t' | b'\n' | b'\r')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn utf_16_of(text: &str, bytes_of: fn(u16) -> [u8; 2]) -> Vec<u8> {
        text.encode_utf16().flat_map(bytes_of).collect()
    }

    #[test]
    fn the_same_text_comes_from_every_encoding() {
        let text = "größe_m,t_s\n1,2\n";
        let latin: Vec<u8> = text.chars().map(|character| character as u8).collect();
        for (bytes, encoding) in [
            (text.as_bytes().to_vec(), None),
            (format!("\u{feff}{text}").into_bytes(), None),
            (latin, Some("Latin-1")),
            (utf_16_of(&format!("\u{feff}{text}"), u16::to_le_bytes), Some("UTF-16")),
            (utf_16_of(&format!("\u{feff}{text}"), u16::to_be_bytes), Some("UTF-16")),
            (utf_16_of(text, u16::to_le_bytes), Some("UTF-16")),
            (utf_16_of(text, u16::to_be_bytes), Some("UTF-16")),
        ] {
            let decoded = table_text(&bytes, "a.csv").unwrap();
            assert_eq!((decoded.text.as_ref(), decoded.encoding), (text, encoding));
        }
    }

    #[test]
    fn what_is_no_text_is_refused_with_its_place() {
        let place = |bytes: &[u8]| {
            let error = table_text(bytes, "a.csv").map(|text| text.text.into_owned()).unwrap_err();
            assert_eq!(error.code, "file::not-utf8");
            (error.line(), error.column())
        };
        assert_eq!(place(b"PK\x03\x04\n\xff\x00"), (Some(2), Some(1)));
        assert_eq!(place(b"\xff\xfea\x00\n\x00\x00\xd8b\x00"), (Some(2), Some(1)));
    }
}

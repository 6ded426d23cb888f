//! A parsed XML file with the positions of all its elements.
//!
//! The file may come from an untrusted source: nothing outside it is read, it cannot define entities, and its size, its
//! elements and the attributes of each are limited before they are parsed.

use std::ops::Range;

use roxmltree::{Document, Node, ParsingOptions};
use thiserror::Error;

use super::{MAGNITUDE_LIMIT, ReadError, Size, TextPlace, text_from_bytes};

/// The largest XML file that is read (bytes); robots have some ten thousand.
const XML_SIZE_LIMIT: usize = 4 * 1024 * 1024;

/// Largest number of elements, texts and comments of a file.
const NODE_LIMIT: u32 = 200_000;

/// Largest number of attributes of one tag: the parser compares each with all others.
const ATTRIBUTE_LIMIT: usize = 256;

/// Largest number of namespaces of a file: the parser passes them to every element.
const NAMESPACE_LIMIT: usize = 16;

/// An XML file.
#[derive(Debug)]
pub(crate) struct XmlDocument<'a> {
    text: &'a str,
    file_name: &'a str,
    tree: Document<'a>,
}

/// One element of a file.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Element<'t, 'a> {
    document: &'t XmlDocument<'a>,
    node: Node<'t, 'a>,
}

impl<'a> XmlDocument<'a> {
    /// Parses bytes that may not be text.
    pub(crate) fn parse(bytes: &'a [u8], file_name: &'a str) -> Result<Self, ReadError> {
        let text = text_from_bytes(bytes, Size::Text, file_name)?;
        check_bounds(text, file_name)?;
        // a document type is allowed, but external files in it are not read
        let options = ParsingOptions { allow_dtd: true, nodes_limit: NODE_LIMIT, entity_resolver: None };
        let tree = Document::parse_with_options(text, options).map_err(|error| {
            let (line, column) = (error.pos().row as usize, error.pos().col as usize);
            let source_line = text.lines().nth(line.saturating_sub(1)).unwrap_or_default();
            ReadError::new(file_name, "xml::syntax", format!("this is not XML: {error}"))
                .at(TextPlace::on_line(source_line, line, column, 1))
                .with_help("is this the right file, and was it written completely?")
        })?;
        Ok(Self { text, file_name, tree })
    }

    /// The outermost element; an error if it does not have this name.
    pub(crate) fn root(&self, name: &str) -> Result<Element<'_, 'a>, ReadError> {
        let root = Element { document: self, node: self.tree.root_element() };
        if root.name() == name {
            return Ok(root);
        }
        let message = format!("the outermost element is <{}>, expected <{name}>", root.name());
        Err(root.error("xml::wrong-root", message).with_help("are the files given in the right order?"))
    }

    fn error_at(&self, span: Range<usize>, code: &'static str, message: impl Into<String>) -> ReadError {
        ReadError::new(self.file_name, code, message).at(TextPlace::of_span(self.text, span))
    }
}

/// Refuses files whose parsing would be slow or large, before parsing.
fn check_bounds(text: &str, file_name: &str) -> Result<(), ReadError> {
    let error = |at: usize, code, message: String| {
        ReadError::new(file_name, code, message).at(TextPlace::of_span(text, at..at))
    };
    if text.trim().is_empty() {
        return Err(error(0, "xml::empty", "the file says nothing".to_owned()));
    }
    if text.len() > XML_SIZE_LIMIT {
        let message = format!("the file has more than {} MiB, the most that is read of XML", XML_SIZE_LIMIT >> 20);
        return Err(ReadError::new(file_name, "file::too-large", message).with_help("is this the right file?"));
    }
    if let Some(at) = text.find("<!ENTITY") {
        let message = "the file defines an entity; entities are not expanded".to_owned();
        return Err(error(at, "xml::entity", message).with_help("write what the entity stands for in its place"));
    }
    if let Some((at, _)) = text.match_indices("xmlns").nth(NAMESPACE_LIMIT) {
        return Err(error(at, "xml::namespaces", format!("more than {NAMESPACE_LIMIT} namespaces")));
    }
    // no `<` can be inside a tag, and every attribute has two quotes
    let mut start = 0;
    for piece in text.split('<') {
        if piece.bytes().filter(|byte| matches!(byte, b'"' | b'\'')).nth(2 * ATTRIBUTE_LIMIT).is_some() {
            return Err(error(start, "xml::attributes", format!("more than {ATTRIBUTE_LIMIT} attributes in one tag")));
        }
        start += piece.len() + 1;
    }
    Ok(())
}

impl<'t, 'a> Element<'t, 'a> {
    /// The name of the tag.
    pub(crate) fn name(&self) -> &'t str {
        self.node.tag_name().name()
    }

    /// The file as the caller named it.
    pub(crate) fn file_name(&self) -> &'a str {
        self.document.file_name
    }

    /// Line of the tag, from 1.
    pub(crate) fn line(&self) -> usize {
        TextPlace::of_span(self.document.text, self.tag()).line()
    }

    /// Byte range of the tag up to its name.
    fn tag(&self) -> Range<usize> {
        let start = self.node.range().start;
        start..start + 1 + self.name().len()
    }

    /// An error at the tag.
    pub(crate) fn error(&self, code: &'static str, message: impl Into<String>) -> ReadError {
        self.document.error_at(self.tag(), code, message)
    }

    /// An error at the text inside, or at the tag if there is none.
    pub(crate) fn content_error(&self, code: &'static str, message: impl Into<String>) -> ReadError {
        let text = self.node.children().find(|child| child.is_text() && !is_blank(child));
        let span = text.map_or_else(
            || self.tag(),
            |text| {
                let raw = &self.document.text[text.range()];
                let start = text.range().start + raw.len() - raw.trim_start().len();
                start..start + raw.trim().len()
            },
        );
        self.document.error_at(span, code, message)
    }

    /// An error at the value of an attribute, or at the tag if it is missing.
    pub(crate) fn attribute_error(&self, name: &str, code: &'static str, message: impl Into<String>) -> ReadError {
        let span = self.node.attribute_node(name).map_or_else(|| self.tag(), |attribute| attribute.range_value());
        self.document.error_at(span, code, message)
    }

    /// The value of an attribute.
    pub(crate) fn attribute(&self, name: &str) -> Option<&'t str> {
        self.node.attribute(name)
    }

    /// The value of a required attribute; an error if it is missing or empty.
    pub(crate) fn required_attribute(&self, name: &str) -> Result<&'t str, ReadError> {
        self.attribute(name).filter(|value| !value.trim().is_empty()).ok_or_else(|| {
            self.attribute_error(name, "xml::missing", format!("<{}> needs the attribute `{name}`", self.name()))
        })
    }

    /// Names of all attributes.
    pub(crate) fn attribute_names(&self) -> impl Iterator<Item = &'t str> + use<'t, 'a> {
        self.node.attributes().map(|attribute| attribute.name())
    }

    /// The elements directly inside.
    pub(crate) fn elements(&self) -> impl Iterator<Item = Element<'t, 'a>> + use<'t, 'a> {
        let document = self.document;
        self.node.children().filter(Node::is_element).map(move |node| Element { document, node })
    }

    /// The only element of a name directly inside; `None` if there is none, an error if there are several.
    pub(crate) fn child(&self, name: &str) -> Result<Option<Element<'t, 'a>>, ReadError> {
        let mut found = self.elements().filter(|element| element.name() == name);
        let first = found.next();
        match found.next() {
            Some(second) => Err(second.error("xml::twice", format!("<{name}> stands here twice"))),
            None => Ok(first),
        }
    }

    /// The only element of a name directly inside; an error if it is missing.
    pub(crate) fn required(&self, name: &str) -> Result<Element<'t, 'a>, ReadError> {
        let missing = || self.error("xml::missing", format!("<{name}> is missing in <{}>", self.name()));
        self.child(name)?.ok_or_else(missing)
    }

    /// The text inside; an error if it is empty, or contains elements or comments.
    pub(crate) fn text(&self) -> Result<&'t str, ReadError> {
        if let Some(inner) = self.elements().next() {
            let message = format!("<{}> stands where only text belongs", inner.name());
            return Err(inner.error("xml::wrong-type", message));
        }
        let mut texts = self.node.children().filter(|child| child.is_text() && !is_blank(child));
        match (texts.next(), texts.next()) {
            (None, _) => Err(self.error("xml::missing", format!("<{}> is empty", self.name()))),
            (Some(text), None) => Ok(text.text().unwrap_or_default().trim()),
            (Some(_), Some(_)) => {
                Err(self.error("xml::wrong-type", format!("the text of <{}> is interrupted by a comment", self.name())))
            }
        }
    }

    /// The number inside.
    pub(crate) fn number(&self) -> Result<f64, ReadError> {
        let text = self.text()?;
        number(text).map_err(|why| self.content_error("xml::wrong-type", why.to_string()))
    }

    /// The three numbers inside.
    pub(crate) fn vector(&self) -> Result<[f64; 3], ReadError> {
        let list = numbers(self.text()?).map_err(|why| self.content_error("xml::wrong-type", why.to_string()))?;
        let count = list.len();
        list.try_into().map_err(|_| {
            let message = format!("<{}> needs 3 numbers, found {count}", self.name());
            self.content_error("xml::wrong-type", message)
        })
    }

    /// The whole number inside.
    pub(crate) fn index(&self) -> Result<usize, ReadError> {
        let text = self.text()?;
        let message = || format!("`{text}` is not a whole number ≥ 0");
        text.parse().map_err(|_| self.content_error("xml::wrong-type", message()))
    }
}

fn is_blank(node: &Node<'_, '_>) -> bool {
    node.text().is_none_or(|text| text.trim().is_empty())
}

/// Text that is not a usable number, with its first 40 characters.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub(crate) enum NumberError {
    #[error("{shown} is beyond ±{MAGNITUDE_LIMIT:e}")]
    Beyond { shown: String },
    #[error("{shown} is not a number to calculate with")]
    NotFinite { shown: String },
    #[error("`{shown}` is not a number")]
    NotANumber { shown: String },
}

/// Numbers separated by spaces or commas, all finite.
pub(crate) fn numbers(text: &str) -> Result<Vec<f64>, NumberError> {
    let words = text.split(|separator: char| separator.is_whitespace() || separator == ',');
    words.filter(|word| !word.is_empty()).map(number).collect()
}

/// A finite number of limited size.
pub(crate) fn number(text: &str) -> Result<f64, NumberError> {
    let shown: String = text.chars().take(40).collect();
    match text.parse::<f64>() {
        Ok(number) if number.abs() <= MAGNITUDE_LIMIT => Ok(number),
        Ok(number) if number.is_finite() => Err(NumberError::Beyond { shown }),
        Ok(_) => Err(NumberError::NotFinite { shown }),
        Err(_) => Err(NumberError::NotANumber { shown }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn code_of(text: &str) -> &'static str {
        XmlDocument::parse(text.as_bytes(), "a.xml").unwrap_err().code
    }

    #[test]
    fn places_are_those_of_the_element_its_content_and_its_attribute() {
        let text = "<?xml version=\"1.0\"?>\n<a>\n  <b kind=\"x\"> 1.5e </b>\n</a>";
        let document = XmlDocument::parse(text.as_bytes(), "a.xml").unwrap();
        let b = document.root("a").unwrap().required("b").unwrap();
        let place = |error: ReadError| (error.line().unwrap(), error.column().unwrap());
        assert_eq!(place(b.number().unwrap_err()), (3, 16));
        assert_eq!(place(b.error("x", "y")), (3, 3));
        assert_eq!(place(b.attribute_error("kind", "x", "y")), (3, 12));
        assert_eq!(place(document.root("c").unwrap_err()), (2, 1));
    }

    #[test]
    fn numbers_are_finite_and_whole() {
        assert_eq!(numbers(" 1 -2e-3,3\t"), Ok(vec![1.0, -2e-3, 3.0]));
        for wrong in ["nan", "inf", "1e400", "1e31", "1 2x 3", "pi"] {
            assert!(numbers(wrong).is_err(), "{wrong}");
        }
        let interrupted = XmlDocument::parse(b"<a>1<!-- -->2</a>", "a.xml").unwrap();
        assert_eq!(interrupted.root("a").unwrap().number().unwrap_err().code, "xml::wrong-type");
    }

    /// Each of these files is small, but would cost a careless reader gigabytes or hours.
    #[test]
    fn hostile_files_are_refused_quickly() {
        let laughs = "<!DOCTYPE a [<!ENTITY b \"ha\"><!ENTITY c \"&b;&b;&b;\">]><a>&c;</a>";
        assert_eq!(code_of(laughs), "xml::entity");
        assert_eq!(code_of("<!DOCTYPE a [<!ENTITY b SYSTEM \"file:///etc/passwd\">]><a>&b;</a>"), "xml::entity");
        let attributes: String = (0..400_000).map(|index| format!(" a{index}=''")).collect();
        assert_eq!(code_of(&format!("<a{}/>", &attributes[..4_000_000])), "xml::attributes");
        let namespaces: String = (0..1000).map(|index| format!("<a xmlns:n{index}='u'>")).collect();
        assert_eq!(code_of(&namespaces), "xml::namespaces");
        assert_eq!(code_of(&"<a>".repeat(100_000)), "xml::syntax");
        assert_eq!(code_of(&"<a/>".repeat(1_000_000)), "xml::syntax");
        assert_eq!(code_of(&format!("<a>{}</a>", "<b/>".repeat(300_000))), "xml::syntax");
        assert_eq!(code_of(&" ".repeat(5 * 1024 * 1024)), "xml::empty");
        assert_eq!(code_of(&format!("<a>{}</a>", " ".repeat(5 * 1024 * 1024))), "file::too-large");
        assert_eq!(code_of(""), "xml::empty");
        assert_eq!(code_of("<a>&undefined;</a>"), "xml::syntax");
    }

    /// Deep nesting is not followed by recursion and is cheap to free.
    #[test]
    fn deep_nesting_is_harmless() {
        let deep = format!("{}{}", "<a>".repeat(90_000), "</a>".repeat(90_000));
        assert!(XmlDocument::parse(deep.as_bytes(), "a.xml").is_ok());
    }
}

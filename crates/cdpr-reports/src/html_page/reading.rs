//! A written page read again, as the tests of every page do.

/// The page without its style and its program, which are no XML; the data block stays.
pub(crate) fn markup(page: &str) -> String {
    let without = |text: &str, start: &str, end: &str| -> String {
        let (before, rest) = text.split_once(start).unwrap();
        let (_, after) = rest.split_once(end).unwrap();
        format!("{before}{after}")
    };
    without(&without(page, "<style>", "</style>"), "<script>\n", "</script>")
}

/// Parses the page as XML, which checks that every tag is closed and every attribute quoted and unique.
pub(crate) fn parsed(page: &str) -> roxmltree::Document<'_> {
    let options = roxmltree::ParsingOptions { allow_dtd: true, ..Default::default() };
    roxmltree::Document::parse_with_options(page, options).unwrap()
}

/// Data block that the program of the page reads.
pub(crate) fn data(page: &str) -> serde_json::Value {
    let page = markup(page);
    let document = parsed(&page);
    let block = document.descendants().find(|node| node.attribute("id") == Some("cdpr-data")).unwrap();
    serde_json::from_str(block.text().unwrap()).unwrap()
}

/// Asserts that a page is well-formed, that its links lead somewhere within it, and that it asks nothing of the network.
pub(crate) fn assert_stands_alone(page: &str) {
    let markup = markup(page);
    let document = parsed(&markup);
    for node in document.descendants() {
        for attribute in ["src", "href"] {
            let value = node.attribute(attribute).unwrap_or_default();
            assert!(value.is_empty() || value.starts_with('#'), "{attribute}={value}");
        }
    }
    for link in document.descendants().filter_map(|node| node.attribute("href")?.strip_prefix('#')) {
        assert!(document.descendants().any(|node| node.attribute("id") == Some(link)), "#{link} leads nowhere");
    }
    assert!(page.len() < 2_000_000, "{} bytes", page.len());
}

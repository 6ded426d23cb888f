//! Rules of a file's own sentences: errors are no text, and doc lines begin with a noun or a verb.

/// First words of a doc line that point at its subject instead of naming it.
const POINTERS: &[&str] = &["What", "Where", "Whose", "That", "Something", "Who", "All that", "How much"];

/// Complains of text as an error and of doc lines that point. `name` is the file's place in the workspace.
pub(crate) fn complaints(name: &str, text: &str) -> Vec<String> {
    let mut complaints = text_as_errors(name, text);
    complaints.extend(pointing_doc_lines(name, text));
    complaints
}

/// Results whose error is text: callers could not tell one from another.
fn text_as_errors(name: &str, text: &str) -> Vec<String> {
    let code = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    let is_text =
        |code: &str| code.contains("Result<") && code.contains(", String>") || code.contains("type Err = String");
    let told = |line: usize| format!("{name}:{line}: text as an error; give it a type of its own");
    (1..).zip(code).filter(|(_, code)| is_text(code)).map(|(line, _)| told(line)).collect()
}

/// First lines of doc comments that begin with one of [`POINTERS`].
fn pointing_doc_lines(name: &str, text: &str) -> Vec<String> {
    let mut complaints = Vec::new();
    let mut is_first = true;
    for (line, text) in (1..).zip(text.lines().map(str::trim_start)) {
        let doc = text.strip_prefix("///").or_else(|| text.strip_prefix("//!"));
        if let Some(word) = doc.filter(|_| is_first).and_then(pointer) {
            complaints.push(format!(
                "{name}:{line}: a doc line begins with `{word}`; say what the thing is: noun or verb first"
            ));
        }
        is_first = doc.is_none();
    }
    complaints
}

/// The pointer that a doc line begins with, as a whole word.
fn pointer(doc: &str) -> Option<&'static str> {
    let is_whole = |rest: &str| !rest.starts_with(|letter: char| letter.is_alphanumeric());
    POINTERS.iter().copied().find(|word| doc.trim_start().strip_prefix(word).is_some_and(is_whole))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_no_error_of_the_library() {
        let refused = |text: &str| text_as_errors("crates/cdpr-model/src/robot.rs", text);
        assert!(refused("fn f() -> Result<String, Error> {\n/// Result<f64, String>\n").is_empty());
        let at = ["crates/cdpr-model/src/robot.rs:2: text as an error; give it a type of its own"];
        assert_eq!(refused("\nfn f() -> Result<Vec<f64>, String> {\n"), at);
        assert_eq!(refused("impl FromStr for Law {\n    type Err = String;\n"), at);
    }

    #[test]
    fn a_doc_line_that_points_at_its_subject_is_refused() {
        let refused = |text: &str| pointing_doc_lines("crates/cdpr-core/src/cable/mod.rs", text);
        let named =
            "//! Laws of one cable.\n\n/// Length (m).\n/// Where it is slack, 0.\nfn f() {}\n// What is left.\n";
        assert!(refused(named).is_empty());
        assert!(refused("/// Whatever the unit, a length.\n").is_empty(), "a longer word");
        assert_eq!(
            refused("//! What one cable does.\n\n    /// Whose.\n    /// All that is told.\n"),
            [
                "crates/cdpr-core/src/cable/mod.rs:1: a doc line begins with `What`; say what the thing is: noun or verb first",
                "crates/cdpr-core/src/cable/mod.rs:3: a doc line begins with `Whose`; say what the thing is: noun or verb first"
            ]
        );
        for word in POINTERS {
            assert_eq!(refused(&format!("/// {word} is there.\n")).len(), 1, "{word}");
        }
    }
}

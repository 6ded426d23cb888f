//! `page-types SCHEMA`: TypeScript interfaces of a JSON Schema on stdout; `page-types --python SCHEMA`: classes of Python.

mod python;
mod typescript;
mod words;

use std::io::Write;
use std::process::ExitCode;

/// Makes types of another language from a schema.
type Translation = fn(&serde_json::Value) -> Result<String, String>;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let (translate, path): (Translation, _) = match words.as_slice() {
        [path] => (typescript::interfaces, path),
        [option, path] if option == "--python" => (python::module, path),
        _ => return failed("usage: page-types [--python] SCHEMA"),
    };
    let schema = match std::fs::read_to_string(path).map_err(|error| error.to_string()).and_then(|text| parsed(&text)) {
        Ok(schema) => schema,
        Err(error) => return failed(&format!("{path}: {error}")),
    };
    match translate(&schema) {
        Ok(text) => match std::io::stdout().write_all(text.as_bytes()) {
            Ok(()) => ExitCode::SUCCESS,
            Err(error) => failed(&error.to_string()),
        },
        Err(error) => failed(&format!("{path}: {error}")),
    }
}

fn parsed(text: &str) -> Result<serde_json::Value, String> {
    serde_json::from_str(text).map_err(|error| error.to_string())
}

fn failed(message: &str) -> ExitCode {
    // nobody is left to tell where stderr is gone
    let _ = writeln!(std::io::stderr(), "{message}");
    ExitCode::FAILURE
}

//! Rules of signatures and messages: every parameter has its name, and libraries know no command.

/// Complains of tuples among the parameters of functions that other files call. `name` is the file's place in the workspace.
pub(crate) fn tuples(name: &str, text: &str) -> Vec<String> {
    let mut complaints = Vec::new();
    for (at, _) in text.match_indices("fn ") {
        let line = text[..at].rsplit('\n').next().unwrap_or_default().trim();
        if !line.starts_with("pub") || line.contains("//") {
            continue;
        }
        let rest = &text[at + 3..];
        let function = rest.split(['<', '(']).next().unwrap_or_default();
        let Some(list) = after_generics(&rest[function.len()..]).strip_prefix('(') else { continue };
        if parameters(list).iter().any(|parameter| is_tuple(parameter)) {
            let number = text[..at].lines().count();
            complaints.push(format!(
                "{name}:{number}: a tuple is a parameter of `{function}`; name its parts, up to seven parameters, or give them a struct"
            ));
        }
    }
    complaints
}

/// The text behind generic parameters, where it begins with some.
fn after_generics(text: &str) -> &str {
    let (mut depth, mut before) = (0, ' ');
    for (at, letter) in text.char_indices() {
        match letter {
            '<' => depth += 1,
            '>' if before != '-' && before != '=' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return &text[at + usize::from(letter == '>')..];
        }
        before = letter;
    }
    ""
}

/// Parameters between the parentheses that are open at the beginning of a text.
fn parameters(text: &str) -> Vec<&str> {
    let (mut depth, mut start, mut found, mut before) = (0, 0, Vec::new(), ' ');
    for (at, letter) in text.char_indices() {
        match letter {
            '(' | '[' | '<' | '{' => depth += 1,
            ')' if depth == 0 => {
                found.push(text[start..at].trim());
                return found;
            }
            '>' if before == '-' || before == '=' => {}
            ')' | ']' | '>' | '}' => depth -= 1,
            ',' if depth == 0 => {
                found.push(text[start..at].trim());
                start = at + 1;
            }
            _ => {}
        }
        before = letter;
    }
    found
}

/// True for a pattern of a tuple, and for a tuple of borrowed things; pairs of numbers are points and ranges.
fn is_tuple(parameter: &str) -> bool {
    let of = parameter.split_once(": ").map_or("", |(_, of)| of);
    parameter.starts_with('(') || of.trim_start_matches(['&', ' ']).starts_with("(&")
}

/// Complains of messages of a library that name a command or an option: they belong to the command (`REMEDIES` of cdpr-cli).
pub(crate) fn commands(name: &str, text: &str) -> Vec<String> {
    if name.contains("/tests/") || name.ends_with("/tests.rs") {
        return Vec::new();
    }
    let product = text.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
    let told = |line: usize| {
        format!("{name}:{line}: a message names a command or an option; the command adds them by the error's code")
    };
    let lines = (1..).zip(product.lines());
    lines
        .filter(|(_, line)| !line.trim_start().starts_with("//"))
        .filter(|(_, line)| line.split('"').skip(1).step_by(2).any(names_a_command))
        .map(|(number, _)| told(number))
        .collect()
}

fn names_a_command(message: &str) -> bool {
    let begins = |rest: &str| rest.starts_with(|letter: char| letter.is_ascii_lowercase());
    let option = |(at, mark): (usize, &str)| begins(&message[at + mark.len()..]);
    message.match_indices("`cdpr ").any(option)
        || message.match_indices(" --").chain(message.match_indices("`--")).any(option)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tuples_are_no_parameters_of_functions_that_other_files_call() {
        let count = |text: &str| tuples("crates/cdpr-model/src/robot.rs", text).len();
        assert_eq!(count("    pub fn f(&self, (a, b): (&A, f64)) -> A {\n"), 1);
        assert_eq!(count("pub(super) fn f<'a>(\n    a: A,\n    moving: (&'a A, f64),\n) {\n"), 1);
        assert_eq!(count("pub(crate) fn f(rows: &(&A, B)) {\n"), 1);
        assert_eq!(count("pub fn f<F: Fn(f64) -> f64>((a, b): (A, F)) {\n"), 1);
        assert_eq!(count("fn f((a, b): (A, B)) {\n"), 0, "known to its own file only");
        assert_eq!(count("pub fn f(bounds: (f64, f64), of: &dyn Fn((f64, f64)) -> f64) -> (A, B) {\n"), 0);
    }

    #[test]
    fn messages_of_libraries_name_no_command() {
        let count = |text: &str| commands("crates/cdpr-model/src/robot.rs", text).len();
        assert_eq!(count("    \"run `cdpr test-bench` first\"\n    \"give --out\"\n    \"`--out`\"\n"), 3);
        assert_eq!(count("/// `cdpr robots` lists them.\n    \"a -- b\"\n    \"the file of cdpr\"\n"), 0);
        assert_eq!(count("#[cfg(test)]\nmod tests {\n    \"give --out\"\n"), 0);
    }
}

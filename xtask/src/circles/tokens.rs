//! Tokens of Rust text: names and marks with their lines; comments, strings, characters and lifetimes are left out.

use std::iter::Peekable;
use std::str::Chars;

/// A name, a number, `::` or a single mark.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Token {
    pub(crate) text: String,
    pub(crate) line: usize,
}

impl Token {
    pub(crate) fn is(&self, text: &str) -> bool {
        self.text == text
    }

    pub(crate) fn is_name(&self) -> bool {
        self.text.starts_with(|letter: char| letter.is_alphabetic() || letter == '_')
    }
}

/// Tokens of a text without the items that are compiled for unit tests alone.
pub(crate) fn product_tokens(text: &str) -> Vec<Token> {
    let all = tokens(text);
    let (mut kept, mut at) = (Vec::new(), 0);
    while at < all.len() {
        match after_test_item(&all, at) {
            Some(after) => at = after,
            None => {
                kept.push(all[at].clone());
                at += 1;
            }
        }
    }
    kept
}

/// Names of the child modules that are compiled for unit tests alone.
pub(crate) fn test_modules(text: &str) -> Vec<String> {
    let all = tokens(text);
    let items = (0..all.len()).filter_map(|at| Some(&all[at..after_test_item(&all, at)?]));
    items
        .filter_map(|item| item.windows(3).find(|three| three[0].is("mod") && three[2].is(";")))
        .map(|three| three[1].text.clone())
        .collect()
}

/// Place after the item that `#[cfg(test)]` at `at` belongs to, `None` if there is no such attribute or no item.
fn after_test_item(all: &[Token], at: usize) -> Option<usize> {
    const ATTRIBUTE: [&str; 7] = ["#", "[", "cfg", "(", "test", ")", "]"];
    const ITEMS: [&str; 12] =
        ["pub", "mod", "fn", "use", "const", "static", "struct", "enum", "impl", "type", "trait", "unsafe"];
    let attribute = all.get(at..at + ATTRIBUTE.len())?;
    if !attribute.iter().zip(ATTRIBUTE).all(|(token, text)| token.is(text)) {
        return None;
    }
    let mut start = at + ATTRIBUTE.len();
    while all.get(start)?.is("#") {
        start = after_group(all, start + 1);
    }
    if !ITEMS.contains(&all.get(start)?.text.as_str()) {
        return None;
    }
    let is_value = all[start..].iter().take(6).any(|token| token.is("use") || token.is("static"));
    let mut here = start;
    while here < all.len() {
        match all[here].text.as_str() {
            ";" => return Some(here + 1),
            "{" if !is_value => return Some(after_group(all, here)),
            "{" | "(" | "[" => here = after_group(all, here),
            _ => here += 1,
        }
    }
    Some(all.len())
}

/// Place after the group of brackets that opens at `at`.
pub(crate) fn after_group(all: &[Token], at: usize) -> usize {
    let mut depth = 0_usize;
    for (here, token) in all.iter().enumerate().skip(at) {
        match token.text.as_str() {
            "{" | "(" | "[" => depth += 1,
            "}" | ")" | "]" => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return here + 1;
        }
    }
    all.len()
}

fn tokens(text: &str) -> Vec<Token> {
    Reader { letters: text.chars().peekable(), line: 1, found: Vec::new() }.read()
}

struct Reader<'t> {
    letters: Peekable<Chars<'t>>,
    line: usize,
    found: Vec<Token>,
}

impl Reader<'_> {
    fn read(mut self) -> Vec<Token> {
        while let Some(letter) = self.next() {
            match letter {
                '/' if self.letters.peek() == Some(&'/') => self.skip_line(),
                '/' if self.letters.peek() == Some(&'*') => self.skip_comment(),
                '"' => self.skip_string(),
                '\'' => self.skip_character_or_lifetime(),
                ':' if self.letters.next_if_eq(&':').is_some() => self.push("::".to_owned()),
                _ if is_of_name(letter) => self.name(letter),
                _ if letter.is_whitespace() => {}
                _ => self.push(letter.to_string()),
            }
        }
        self.found
    }

    fn next(&mut self) -> Option<char> {
        let letter = self.letters.next()?;
        self.line += usize::from(letter == '\n');
        Some(letter)
    }

    fn push(&mut self, text: String) {
        self.found.push(Token { text, line: self.line });
    }

    fn skip_line(&mut self) {
        while self.letters.next_if(|letter| *letter != '\n').is_some() {}
    }

    fn skip_comment(&mut self) {
        let mut depth = 1_usize;
        let mut last = self.next();
        while let Some(letter) = self.next().filter(|_| depth > 0) {
            match (last, letter) {
                (Some('*'), '/') => depth -= 1,
                (Some('/'), '*') => depth += 1,
                _ => {}
            }
            last = Some(letter);
            if depth == 0 {
                break;
            }
        }
    }

    fn skip_string(&mut self) {
        while let Some(letter) = self.next() {
            match letter {
                '\\' => drop(self.next()),
                '"' => break,
                _ => {}
            }
        }
    }

    fn skip_raw_string(&mut self, marks: usize) {
        let mut closing = None;
        while let Some(letter) = self.next() {
            closing = match (letter, closing) {
                ('"', _) => Some(0),
                ('#', Some(seen)) => Some(seen + 1),
                _ => None,
            };
            if closing == Some(marks) {
                break;
            }
        }
    }

    fn skip_character_or_lifetime(&mut self) {
        match self.next() {
            Some('\\') => {
                self.next();
                while self.next().is_some_and(|letter| letter != '\'') {}
            }
            // 'a' is a character, 'a and 'static are lifetimes
            Some(letter) if is_of_name(letter) => {
                if self.letters.next_if_eq(&'\'').is_none() {
                    while self.letters.next_if(|letter| is_of_name(*letter)).is_some() {}
                }
            }
            _ => drop(self.letters.next_if_eq(&'\'')),
        }
    }

    fn name(&mut self, first: char) {
        let mut name = first.to_string();
        while let Some(letter) = self.letters.next_if(|letter| is_of_name(*letter)) {
            name.push(letter);
        }
        let opens_string = matches!(name.as_str(), "r" | "b" | "br" | "c" | "cr");
        match self.letters.peek() {
            Some('"') if opens_string && name.ends_with('r') => {
                self.next();
                self.skip_raw_string(0);
            }
            Some('#') if opens_string => {
                let mut marks = 0;
                while self.letters.next_if_eq(&'#').is_some() {
                    marks += 1;
                }
                // r#type is a name, r#"text"# a string
                if self.letters.next_if_eq(&'"').is_some() {
                    self.skip_raw_string(marks);
                }
            }
            _ => self.push(name),
        }
    }
}

fn is_of_name(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_'
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(text: &str) -> Vec<String> {
        product_tokens(text).into_iter().map(|token| token.text).collect()
    }

    #[test]
    fn comments_strings_characters_and_lifetimes_are_no_tokens() {
        let text = "/* a /* b */ c */ f::<'a>(\"x \\\" y\", 'z', '\\'', r#\"q \" q\"#, b\"w\") // end\n";
        assert_eq!(texts(text), ["f", "::", "<", ">", "(", ",", ",", ",", ",", "b", ")"]);
        assert_eq!(product_tokens("a\n\"\n\"b")[1].line, 3);
    }

    #[test]
    fn items_of_unit_tests_are_no_product() {
        let text = "#[cfg(test)]\nmod tests {\n fn f() { g() }\n}\n#[cfg(test)]\nmod law_tests;\nfn h() {}\n";
        assert_eq!(texts(text), ["fn", "h", "(", ")", "{", "}"]);
        assert_eq!(test_modules(text), ["law_tests"]);
        assert_eq!(texts("#[cfg(test)]\nuse a::{b};\nc"), ["c"]);
        assert_eq!(texts("#[cfg(test)]\n#[path = \"x\"]\npub(crate) fn f(a: [u8; 2]) { g }\nc"), ["c"]);
    }
}

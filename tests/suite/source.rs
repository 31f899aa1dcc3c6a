//! Rust source as tokens: as much of a reader as the tests of the shape of the house need, and no more.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Every Rust file below a folder, by its path relative to that folder.
pub fn files(folder: &str) -> BTreeMap<String, String> {
    fn walk(root: &Path, folder: &Path, found: &mut BTreeMap<String, String>) {
        let entries = std::fs::read_dir(folder).unwrap();
        let paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
        for path in paths {
            if path.is_dir() {
                walk(root, &path, found);
            } else if path.extension().is_some_and(|e| e == "rs") {
                let name = path.strip_prefix(root).unwrap().to_str().unwrap();
                found.insert(name.to_owned(), std::fs::read_to_string(&path).unwrap());
            }
        }
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut found = BTreeMap::new();
    walk(&root, &root, &mut found);
    assert!(!found.is_empty(), "no Rust file in {folder}");
    found
}

/// A word, a number, a literal (`"` for a string, `'` for a character), or punctuation.
#[derive(Clone, Debug, PartialEq)]
pub struct Token {
    pub text: String,
    /// Lines from which and to which it goes, counted from 1.
    pub lines: [usize; 2],
}

/// Punctuation that is read as one token.
const PAIRS: [&str; 6] = ["::", "=>", "->", "&&", "||", ".."];

/// The tokens of a file without its comments, up to its unit tests.
pub fn tokens(text: &str) -> Vec<Token> {
    let text = text.split("#[cfg(test)]\n").next().unwrap_or_default();
    let chars: Vec<char> = text.chars().collect();
    let mut reader = Reader {
        chars: &chars,
        at: 0,
        line: 1,
    };
    let mut tokens = Vec::new();
    while reader.at < chars.len() {
        let first = reader.line;
        if let Some(text) = reader.next() {
            tokens.push(Token {
                text,
                lines: [first, reader.line],
            });
        }
    }
    tokens
}

struct Reader<'a> {
    chars: &'a [char],
    at: usize,
    line: usize,
}

impl Reader<'_> {
    fn peek(&self, ahead: usize) -> char {
        self.chars.get(self.at + ahead).copied().unwrap_or('\0')
    }

    fn take(&mut self) -> char {
        let c = self.peek(0);
        self.line += usize::from(c == '\n');
        self.at += 1;
        c
    }

    fn is_over(&self) -> bool {
        self.at >= self.chars.len()
    }

    /// The next token; `None` for what is none.
    fn next(&mut self) -> Option<String> {
        match self.peek(0) {
            c if c.is_whitespace() => {
                self.take();
                None
            }
            '/' if self.peek(1) == '/' => {
                while !self.is_over() && self.peek(0) != '\n' {
                    self.take();
                }
                None
            }
            '/' if self.peek(1) == '*' => {
                self.block_comment();
                None
            }
            '"' => Some(self.string(0)),
            'r' | 'b' if self.opens_raw_string().is_some() => {
                let (prefix, hashes) = self.opens_raw_string()?;
                for _ in 0..prefix {
                    self.take();
                }
                Some(self.string(hashes))
            }
            '\'' => Some(self.quote()),
            c if c.is_alphanumeric() || c == '_' => {
                let mut word = String::new();
                while self.peek(0).is_alphanumeric() || self.peek(0) == '_' {
                    word.push(self.take());
                }
                Some(word)
            }
            c => {
                let pair: String = [c, self.peek(1)].iter().collect();
                self.take();
                if PAIRS.contains(&pair.as_str()) {
                    self.take();
                    return Some(pair);
                }
                Some(c.to_string())
            }
        }
    }

    fn block_comment(&mut self) {
        let mut depth = 0;
        while !self.is_over() {
            let pair = (self.peek(0), self.peek(1));
            depth += i32::from(pair == ('/', '*')) - i32::from(pair == ('*', '/'));
            self.take();
            if pair == ('/', '*') || pair == ('*', '/') {
                self.take();
            }
            if depth == 0 {
                break;
            }
        }
    }

    /// Length of what stands before the quote of a string with a prefix, and its hashes; the hashes are `usize::MAX` where a backslash escapes.
    fn opens_raw_string(&self) -> Option<(usize, usize)> {
        let mut at = usize::from(self.peek(0) == 'b');
        let raw = self.peek(at) == 'r';
        at += usize::from(raw);
        let first = at;
        while raw && self.peek(at) == '#' {
            at += 1;
        }
        let hashes = at - first;
        let hashes = if raw { hashes + 1 } else { 0 };
        (at > 0 && self.peek(at) == '"').then_some((at, hashes))
    }

    /// A string from its quote on. `raw`: 0 where a backslash escapes, else the number of hashes and one.
    fn string(&mut self, raw: usize) -> String {
        self.take();
        while !self.is_over() {
            match self.take() {
                '\\' if raw == 0 => {
                    self.take();
                }
                '"' if raw <= 1 => break,
                '"' if (0..raw - 1).all(|ahead| self.peek(ahead) == '#') => {
                    (1..raw).for_each(|_| {
                        self.take();
                    });
                    break;
                }
                _ => {}
            }
        }
        "\"".to_owned()
    }

    /// A character, or the name of a lifetime.
    fn quote(&mut self) -> String {
        let character = self.peek(1) == '\\' || self.peek(2) == '\'';
        self.take();
        if !character {
            let mut name = "'".to_owned();
            while self.peek(0).is_alphanumeric() || self.peek(0) == '_' {
                name.push(self.take());
            }
            return name;
        }
        if self.take() == '\\' {
            self.take();
        }
        while !self.is_over() && self.take() != '\'' {}
        "'".to_owned()
    }
}

#[test]
fn comments_and_what_stands_in_strings_are_no_code() {
    let words = |text: &str| -> Vec<String> {
        let tokens = tokens(text).into_iter();
        tokens.map(|token| token.text).collect()
    };
    for (text, wanted) in [
        ("a // if b", "a"),
        ("a /* if /* b */ */ c", "a c"),
        (r#"a("if \" {", 'x', '\'', '{')"#, "a ( \" , ' , ' , ' )"),
        ("r#\"if \" b\"# c br\"\\\" d", "\" c \" d"),
        (
            "fn f<'a>(x: &'a str) -> x::Y",
            "fn f < 'a > ( x : & 'a str ) -> x :: Y",
        ),
        ("raw || breaks && rb", "raw || breaks && rb"),
        ("a\n#[cfg(test)]\nmod tests { if }", "a"),
    ] {
        assert_eq!(words(text).join(" "), wanted, "{text}");
    }
    let lines: Vec<[usize; 2]> = tokens("a\n\"b\nc\" d").iter().map(|t| t.lines).collect();
    assert_eq!(lines, [[1, 1], [2, 3], [3, 3]]);
}

//! Words of a scene, an engine or a file as a table for people shows them. Formats for programs keep them to the bit.

use crate::scene::{is_hidden, printable};
use std::borrow::Cow;

/// One line that moves no cursor and hides nothing: line breaks and tabs are spaces, and what nobody would see, or what would turn
/// the words around it, is an escape such as `\u{202e}`.
pub fn plain(words: &str) -> Cow<'_, str> {
    if !words.contains(is_hidden) {
        return Cow::Borrowed(words);
    }
    Cow::Owned(printable(&words.replace(['\n', '\r', '\t'], " ")))
}

/// The same for a cell of a table. Whoever pastes it into a spreadsheet gets the words: what a spreadsheet would compute has an
/// apostrophe before it, as there.
pub fn in_cell(words: &str) -> Cow<'_, str> {
    if is_formula(words) {
        return Cow::Owned(format!("'{}", plain(words)));
    }
    plain(words)
}

/// True for words that a spreadsheet would take for something to compute. A number is none, with or without its unit.
pub fn is_formula(words: &str) -> bool {
    let words = words.trim_start();
    let mut chars = words.chars();
    let first = chars.next();
    let rest = chars.as_str().trim_start();
    match first {
        Some('=' | '@') => !rest.is_empty(),
        Some('+' | '-') => {
            let number = words.split(' ').next().unwrap_or_default();
            let operators = ['+', '-', '*', '/', '^', '&', '=', '(', '|', '!'];
            let is_number = number.parse::<f64>().is_ok();
            let computes = words[number.len()..].contains(operators);
            rest.starts_with(|c: char| c.is_alphanumeric() || "(\"'.+-=@".contains(c))
                && (!is_number || computes)
        }
        _ => false,
    }
}

/// Words in pieces, each with whether it is code: what stands between two backticks that enclose it as quotation marks would.
/// A single word is a name, whose backticks are its own.
pub fn pieces(words: &str) -> Vec<(bool, &str)> {
    let mut pieces = Vec::new();
    let mut from = 0;
    let is_name = !words.contains(char::is_whitespace);
    if !is_name && words.matches('`').count().is_multiple_of(2) {
        while let Some(code) = code_after(words, from) {
            pieces.push((false, &words[from..code.start - 1]));
            from = code.end + 1;
            pieces.push((true, &words[code]));
        }
    }
    pieces.push((false, &words[from..]));
    pieces.retain(|(_, piece)| !piece.is_empty());
    pieces
}

/// Where the first code after byte `from` stands, without its backticks.
fn code_after(words: &str, from: usize) -> Option<std::ops::Range<usize>> {
    let mut at = from;
    loop {
        let open = at + words[at..].find('`')?;
        let close = open + 1 + words[open + 1..].find('`')?;
        let code = &words[open + 1..close];
        let before = words[..open].chars().next_back().unwrap_or(' ');
        let after = words[close + 1..].chars().next().unwrap_or(' ');
        let apart = |c: char| !c.is_alphanumeric() && c != '`';
        if !code.is_empty() && code.trim() == code && apart(before) && apart(after) {
            return Some(open + 1..close);
        }
        at = open + 1;
    }
}

#[cfg(test)]
mod tests {
    use super::{in_cell, is_formula, pieces, plain};

    #[test]
    fn nothing_hides_and_nothing_commands() {
        for (words, shown) in [
            ("cue", "cue"),
            ("a\nb\tc", "a b c"),
            ("\u{1b}[2J", "\\u{1b}[2J"),
            ("\u{9b}2J", "\\u{9b}2J"),
            ("a\u{202e}b", "a\\u{202e}b"),
            ("a\u{200b}b\u{feff}", "a\\u{200b}b\\u{feff}"),
            ("a\u{2028}b", "a\\u{2028}b"),
            // letters of every script are themselves, and so are the joiners that some of them need
            (
                "\u{645}\u{200c}\u{5d0} \u{65e5} e\u{301}",
                "\u{645}\u{200c}\u{5d0} \u{65e5} e\u{301}",
            ),
        ] {
            assert_eq!(plain(words), shown);
        }
    }

    #[test]
    fn what_a_spreadsheet_would_compute_is_words() {
        for words in [
            "=1+1",
            "@SUM(A1)",
            "+1+1",
            "-2+3",
            "-cmd",
            "=cmd|' /C calc'!A0",
            "\t=1+1",
            "-1 +2",
            "--1",
        ] {
            assert!(is_formula(words), "{words}");
            assert!(in_cell(words).starts_with('\''), "{words}");
        }
        for words in [
            "-1.5",
            "+3e-4",
            "-0.5 R",
            "-",
            "+",
            "=",
            "1-2",
            "a=b",
            "",
            "- none of",
        ] {
            let expected = words == "- none of";
            assert_eq!(is_formula(words), expected, "{words}");
        }
    }

    #[test]
    fn code_stands_between_backticks_that_enclose_it() {
        for (words, code) in [
            ("the `dt` of one", vec!["dt"]),
            ("`a=b`: no (`c d`), `e`.", vec!["a=b", "c d", "e"]),
            ("`name`", vec![]),
            ("a`b c`d", vec![]),
            ("one ` two", vec![]),
            ("x ` y ` z", vec![]),
            ("``` ` three", vec![]),
        ] {
            let found: Vec<&str> = pieces(words)
                .into_iter()
                .filter_map(|(is_code, piece)| is_code.then_some(piece))
                .collect();
            assert_eq!(found, code, "{words}");
        }
    }
}

//! Text of others on a terminal: no file, name or argument may command it, nor show other words than it holds.

/// `text` with hidden characters shown as escapes, such as `\n` and `\u{202e}`.
pub fn printable(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if is_hidden(c) {
            out.extend(c.escape_default());
        } else {
            out.push(c);
        }
    }
    out
}

/// True for characters that command a terminal, change the direction of what stands around them, end a line, or cannot be seen.
/// The joiners without which some scripts cannot be written are not among them.
pub fn is_hidden(c: char) -> bool {
    c.is_control()
        || matches!(
            c,
            // soft hyphen, marks of direction, spaces without width
            '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}' | '\u{200e}' | '\u{200f}' | '\u{feff}'
            // line and paragraph separators, embeddings and overrides
            | '\u{2028}'..='\u{202e}'
            // operators that are not seen, isolates
            | '\u{2060}'..='\u{206f}'
            // letters that are blank
            | '\u{115f}' | '\u{1160}' | '\u{3164}' | '\u{ffa0}'
            // marks of annotations, and of languages
            | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}'
        )
}

//! How much room words take, and how they are made to fit.

/// Width of a line of text, px: no less than that of the widest of the fonts that a page asks for (DejaVu Sans, where there is
/// no other).
pub fn text_width(words: &str, size: f64) -> f64 {
    let em = |c: char| match c {
        'i' | 'l' | 'j' => 0.29,
        't' | 'f' | 'r' | ' ' | '.' | ',' | ':' | ';' | '|' | '-' | '(' | ')' | '/' => 0.42,
        'w' | '+' | '=' | '<' | '>' | '~' | '#' | '^' => 0.84,
        'm' | 'M' | 'W' | '@' | '%' => 1.0,
        'A'..='Z' | '&' => 0.79,
        '⁰' | '¹' | '²' | '³' | '⁴'..='⁹' | '⁻' => 0.53,
        c if c.is_ascii() => 0.64,
        _ => 1.0,
    };
    words.chars().map(em).sum::<f64>() * size
}

/// Words in lines no wider than `room`, px, broken between words only; `None` where one of them is wider.
pub fn wrapped(words: &str, size: f64, room: f64) -> Option<Vec<String>> {
    let mut lines: Vec<String> = Vec::new();
    for word in words.split_whitespace() {
        if text_width(word, size) > room {
            return None;
        }
        match lines.last_mut() {
            Some(line) if text_width(&format!("{line} {word}"), size) <= room => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    Some(lines)
}

/// Words no wider than `room`, px: what does not fit is left out, and a sign says so.
pub fn elided(words: &str, size: f64, room: f64) -> String {
    if text_width(words, size) <= room {
        return words.to_owned();
    }
    let mut kept = String::new();
    for c in words.chars() {
        kept.push(c);
        if text_width(&kept, size) + size > room {
            kept.pop();
            break;
        }
    }
    kept.trim_end().to_owned() + "…"
}

#[cfg(test)]
mod tests {
    use super::{elided, text_width, wrapped};

    #[test]
    fn words_fit_into_the_room_that_they_are_given() {
        for (words, room) in [
            ("rapier f64 stock", 60.0),
            ("stepper approach check", 70.0),
            ("a b c", 30.0),
        ] {
            let lines = wrapped(words, 11.0, room).unwrap_or_default();
            assert_eq!(lines.join(" "), words);
            for line in lines {
                assert!(text_width(&line, 11.0) <= room, "`{line}` in {room} px");
            }
        }
        assert_eq!(wrapped("unbreakable", 11.0, 20.0), None);
        let long = "a name that is much too long for its place";
        for room in [40.0, 90.0, 150.0] {
            let short = elided(long, 13.0, room);
            assert!(text_width(&short, 13.0) <= room, "`{short}` in {room} px");
            assert!(short.ends_with('…') && short.len() > 4, "`{short}`");
        }
        assert_eq!(elided("short", 13.0, 90.0), "short");
    }
}

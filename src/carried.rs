//! Files that travel with the program: scenes and accepted findings, built in, so that a program that was moved has those of its own version.
//!
//! The build script lists every file of `validation/scenes`, `baselines`, `hard` and `engines`; what a file means is for the room that reads it.

/// Names and texts, by name; a name is the path below `validation/` with `/` between its parts.
const FILES: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/carried.rs"));

/// The text of the file called `name`, such as `scenes/slide.toml`.
pub const fn text(name: &str) -> Option<&'static str> {
    let (mut from, mut to) = (0, FILES.len());
    while from < to {
        let middle = from + (to - from) / 2;
        match order(name.as_bytes(), FILES[middle].0.as_bytes()) {
            0 => return Some(FILES[middle].1),
            i8::MIN..0 => to = middle,
            1.. => from = middle + 1,
        }
    }
    None
}

/// Names and texts of the files below a folder, such as `baselines`, by name.
pub fn below(folder: &str) -> impl Iterator<Item = (&'static str, &'static str)> {
    FILES.iter().filter_map(move |&(name, text)| {
        let own = name.strip_prefix(folder)?.strip_prefix('/')?;
        Some((own, text))
    })
}

/// Negative, 0 or positive as `a` comes before, is, or comes after `b`; in a form that the compiler can run.
const fn order(a: &[u8], b: &[u8]) -> i8 {
    let mut at = 0;
    while at < a.len() && at < b.len() {
        if a[at] != b[at] {
            return if a[at] < b[at] { -1 } else { 1 };
        }
        at += 1;
    }
    if a.len() == b.len() {
        0
    } else if a.len() < b.len() {
        -1
    } else {
        1
    }
}

#[cfg(test)]
mod tests {
    use super::{FILES, below, text};

    #[test]
    fn every_file_is_found_by_its_name_and_no_other_is() {
        assert!(FILES.len() > 200, "{}", FILES.len());
        for (name, own) in FILES {
            assert_eq!(text(name), Some(*own), "{name}");
            for other in [&name[..name.len() - 1], &format!("{name}x")] {
                assert_eq!(text(other), None, "{other}");
            }
        }
        assert_eq!(text(""), None);
    }

    #[test]
    fn a_folder_has_its_own_files() {
        let all: usize = ["baselines", "engines", "hard", "scenes"]
            .map(|folder| below(folder).count())
            .iter()
            .sum();
        assert_eq!(all, FILES.len());
        assert!(below("scenes").any(|(name, _)| name == "slide.toml"));
        assert_eq!(below("scene").count(), 0);
    }
}

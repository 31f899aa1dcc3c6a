//! Words in kebab-case: what scenes and engines are called.

/// Longest name of a scene or ball, characters: it becomes part of file names and table rows.
pub(super) const LONGEST: usize = 64;

/// True for words of lower-case letters and digits joined by single hyphens, 64 characters at most.
pub fn is_kebab_case(name: &str) -> bool {
    let word = |word: &str| {
        !word.is_empty()
            && word
                .bytes()
                .all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit())
    };
    name.len() <= LONGEST && name.split('-').all(word)
}

/// The kebab-case name nearest to `name`, if it has any letters or digits to make one of.
pub(super) fn kebab_case(name: &str) -> Option<String> {
    let words = name.split(|c: char| !c.is_ascii_alphanumeric());
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    let better = words.join("-").to_ascii_lowercase();
    is_kebab_case(&better).then_some(better)
}

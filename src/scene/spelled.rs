//! The words of a scene file that tables for people repeat, each with its place: a person can be told of those that need care.

use super::pieces::Pieces;
use super::read;
use std::ops::Range;

/// Words of a scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spelled {
    /// Path of the key, such as `balls[0].id`.
    pub path: String,
    /// The words.
    pub words: String,
    /// Bytes of the text where they stand.
    pub span: Range<usize>,
}

/// Description, units and ids of a scene file, in the order of the text; empty for a text that is no scene file.
pub fn spelled(text: &str) -> Vec<Spelled> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let pieces = Pieces::of(text);
    let Ok((file, located)) = read(text, pieces.as_ref()) else {
        return Vec::new();
    };
    let units = [
        ("units.length", file.units.length),
        ("units.mass", file.units.mass),
    ];
    let units = units
        .into_iter()
        .filter_map(|(path, unit)| Some((path.to_owned(), unit?)));
    let balls = file.balls.into_iter().enumerate();
    let ids = balls.map(|(i, ball)| (format!("balls[{i}].id"), ball.id));
    let description = [("description".to_owned(), file.description)];
    let all = description.into_iter().chain(units).chain(ids);
    let mut found: Vec<Spelled> = all
        .map(|(path, words)| Spelled {
            span: located.value(&path),
            path,
            words,
        })
        .collect();
    found.sort_by_key(|spelled| spelled.span.start);
    found
}

//! The parsed text with the position of every key and value, looked up by path: `balls[2].position[0]`.

use super::pieces::{Chunk, Piece, Shift};
use std::cell::RefCell;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A parsed scene file that still knows where everything stands.
pub(super) struct Located<'t> {
    text: &'t str,
    /// Keys and values with their positions; without the balls where these are in chunks.
    pub root: DeTable<'t>,
    shift: Shift,
    chunks: Vec<Chunk>,
    /// The chunk that was looked into last, with its balls.
    opened: RefCell<Option<(usize, DeTable<'t>)>>,
}

impl<'t> Located<'t> {
    /// A file that was read as a whole.
    pub fn whole(text: &'t str, root: DeTable<'t>) -> Self {
        Located::in_pieces(text, root, Shift::default(), Vec::new())
    }

    /// A file that was read in pieces: what is around its balls, and where these are.
    pub fn in_pieces(text: &'t str, root: DeTable<'t>, shift: Shift, chunks: Vec<Chunk>) -> Self {
        Located {
            text,
            root,
            shift,
            chunks,
            opened: RefCell::new(None),
        }
    }

    /// Where the value at `path` stands; for a table its header. What is not there stands where its nearest parent does.
    pub fn value(&self, path: &str) -> Range<usize> {
        self.find(path).1
    }

    /// Where the last key of `path` stands.
    pub fn key(&self, path: &str) -> Range<usize> {
        self.find(path).0
    }

    /// The path of the deepest key that stands, or whose value stands, where `place` begins; empty if none does. Lists are not
    /// entered.
    pub fn path_at(&self, place: usize) -> String {
        path_at(&self.root, place)
    }

    fn find(&self, path: &str) -> (Range<usize>, Range<usize>) {
        if let Some(found) = self.find_in_chunks(path) {
            return found;
        }
        let (key, value) = find(&self.root, path);
        (self.shift.place(key), self.shift.place(value))
    }

    /// A ball, or something of it, in the chunk that holds it.
    fn find_in_chunks(&self, path: &str) -> Option<(Range<usize>, Range<usize>)> {
        let (index, rest) = path.strip_prefix("balls[")?.split_once(']')?;
        let index: usize = index.parse().ok()?;
        let number = self.chunks.partition_point(|chunk| chunk.first <= index);
        let number = number.checked_sub(1)?;
        let chunk = self.chunks.get(number)?;
        let mut opened = self.opened.borrow_mut();
        if opened.as_ref().is_none_or(|(known, _)| *known != number) {
            let piece = Piece::parse(self.text, chunk.clone())?;
            *opened = Some((number, piece.into_table()));
        }
        let (_, table) = opened.as_ref()?;
        let path = format!("balls[{}]{rest}", index - chunk.first);
        let (key, value) = find(table, &path);
        let shift = Shift::to(chunk.text.start);
        Some((shift.place(key), shift.place(value)))
    }
}

/// Where the last key of `path` in `table` stands, and its value.
fn find(table: &DeTable<'_>, path: &str) -> (Range<usize>, Range<usize>) {
    let mut found = (0..0, 0..0);
    let mut table = Some(table);
    for step in path.split('.') {
        let mut parts = step.split(['[', ']']).filter(|part| !part.is_empty());
        let key = parts.next().unwrap_or_default();
        let Some((key, mut value)) = table.and_then(|t| t.get_key_value(key)) else {
            return found;
        };
        found = (key.span(), value.span());
        for index in parts {
            let Some(item) = item(value, index) else {
                return found;
            };
            value = item;
            found = (value.span(), value.span());
        }
        table = value.get_ref().as_table();
    }
    found
}

/// The path of the deepest key of `table` that stands, or whose value stands, where `place` begins; empty if none does.
fn path_at(table: &DeTable<'_>, place: usize) -> String {
    let mut best = (usize::MAX, String::new());
    for (key, value) in table {
        let inner = match value.get_ref() {
            DeValue::Table(table) => path_at(table, place),
            _ => String::new(),
        };
        if !inner.is_empty() {
            return join(key.get_ref(), &inner);
        }
        for span in [key.span(), value.span()] {
            if span.contains(&place) && span.len() < best.0 {
                best = (span.len(), key.get_ref().to_string());
            }
        }
    }
    best.1
}

fn item<'a, 't>(value: &'a Spanned<DeValue<'t>>, index: &str) -> Option<&'a Spanned<DeValue<'t>>> {
    value
        .get_ref()
        .as_array()?
        .get(index.parse::<usize>().ok()?)
}

/// The path of `key` below `path`.
pub(super) fn join(path: &str, key: &str) -> String {
    if path.is_empty() {
        key.to_owned()
    } else {
        format!("{path}.{key}")
    }
}

/// The table at `path` as its header is written: `[ball]`, `[[balls]]`; for the root, `the scene`.
pub(super) fn header(path: &str) -> String {
    match path.split_once('[') {
        _ if path.is_empty() => "the scene".to_owned(),
        Some((list, _)) => format!("`[[{list}]]`"),
        None => format!("`[{path}]`"),
    }
}

/// The last step of `path`: the name by which an error calls a value.
pub(super) fn last(path: &str) -> &str {
    path.rsplit('.').next().unwrap_or(path)
}

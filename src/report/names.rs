//! Names of the files and anchors of a report: safe on every file system, unique whatever the ids are.

use crate::finding::{Block, Document};
use std::collections::BTreeSet;

/// A document and all pages below it, in reading order, each with its names.
pub struct Pages<'a> {
    /// The first page, then the others; never empty.
    pub list: Vec<Page<'a>>,
}

/// One page.
pub struct Page<'a> {
    /// Its contents.
    pub document: &'a Document,
    /// How deep below the first page it is: 0 for the first.
    pub depth: usize,
    /// Index of the page above it; the first page is above itself.
    pub parent: usize,
    /// Its name without extension, unique among the pages.
    pub name: String,
    /// A name for each block, unique in the page: of a table or figure its id, of a heading its words.
    pub blocks: Vec<String>,
}

impl<'a> Pages<'a> {
    /// All pages of a document.
    pub fn of(document: &'a Document) -> Self {
        let mut pages = Pages { list: Vec::new() };
        let mut taken = BTreeSet::new();
        pages.add(document, 0, 0, &mut taken);
        pages
    }

    /// The page with this id.
    pub fn find(&self, id: &str) -> Option<&Page<'a>> {
        self.list.iter().find(|page| page.document.id == id)
    }

    fn add(
        &mut self,
        document: &'a Document,
        depth: usize,
        parent: usize,
        taken: &mut BTreeSet<String>,
    ) {
        let index = self.list.len();
        let mut anchors = BTreeSet::new();
        let mut blocks = vec![String::new(); document.blocks.len()];
        // ids first: a heading must not take the name of a table's file
        for (name, block) in blocks.iter_mut().zip(&document.blocks) {
            match block {
                Block::Table(table) => *name = unique(&table.id, &mut anchors),
                Block::Figure(figure) => *name = unique(&figure.id, &mut anchors),
                Block::Replay(_) => *name = unique("replay", &mut anchors),
                Block::Heading(_) | Block::Text(_) | Block::List(_) | Block::Command(_) => {}
            }
        }
        for (name, block) in blocks.iter_mut().zip(&document.blocks) {
            if let Block::Heading(words) = block {
                *name = unique(words, &mut anchors);
            }
        }
        self.list.push(Page {
            document,
            depth,
            parent,
            name: unique(&document.id, taken),
            blocks,
        });
        for page in &document.pages {
            self.add(page, depth + 1, index, taken);
        }
    }
}

/// A safe name made from `words` that is not taken yet, and now is.
pub fn unique(words: &str, taken: &mut BTreeSet<String>) -> String {
    let name = safe(words);
    let mut candidate = name.clone();
    let mut number = 2;
    while !taken.insert(candidate.clone()) {
        candidate = format!("{name}-{number}");
        number += 1;
    }
    candidate
}

/// Lower-case letters, digits and single hyphens, at most 60 of them, at least one.
fn safe(words: &str) -> String {
    let mut name = String::new();
    for c in words.chars() {
        if c.is_ascii_alphanumeric() {
            name.push(c.to_ascii_lowercase());
        } else if !name.ends_with('-') && !name.is_empty() {
            name.push('-');
        }
        if name.len() >= 60 {
            break;
        }
    }
    let name = name.trim_end_matches('-');
    if name.is_empty() { "untitled" } else { name }.to_owned()
}

#[cfg(test)]
mod tests {
    use super::unique;
    use std::collections::BTreeSet;

    #[test]
    fn names_are_safe_and_unique_whatever_the_ids_are() {
        let mut taken = BTreeSet::new();
        for (words, expected) in [
            ("report-break", "report-break"),
            ("../../etc/passwd", "etc-passwd"),
            ("<script>", "script"),
            ("Script", "script-2"),
            ("", "untitled"),
            ("ü", "untitled-2"),
            ("rapier-f64 | exact", "rapier-f64-exact"),
        ] {
            assert_eq!(unique(words, &mut taken), expected);
        }
        assert_eq!(unique(&"x".repeat(500), &mut taken).len(), 60);
    }
}

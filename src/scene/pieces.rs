//! A large file in pieces: what stands around its list of balls, and the balls a few hundred at a time.
//!
//! Read as a whole, a file takes a kilobyte for each of its lines while it is parsed; in pieces it takes what a few hundred balls do. A
//! file is cut at lines that begin with `[[balls]]`. Each piece must be right by itself and hold nothing but balls, and what is around
//! them no ball; where it is otherwise, such as where such a line stands inside a text, the file is read as a whole.

use super::file::BallFile;
use serde::Deserialize;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue, Deserializer};

/// Files up to this size are read as a whole, bytes.
pub const LARGE: usize = 1 << 20;

/// Pieces are about this large, bytes.
const PIECE: usize = 1 << 16;

/// How the line that begins a ball begins.
const BALL: &str = "[[balls]]";

/// Where a part of a text stands in the whole: what is at `from` or later stands `by` later.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Shift {
    pub from: usize,
    pub by: usize,
}

impl Shift {
    /// Of a part that begins at `start`.
    pub fn to(start: usize) -> Self {
        Shift { from: 0, by: start }
    }

    /// The place in the whole of a place in the part.
    pub fn place(self, span: Range<usize>) -> Range<usize> {
        let place = |at: usize| if at >= self.from { at + self.by } else { at };
        let start = place(span.start);
        start..start + span.len()
    }
}

/// A piece of a text that lists balls.
#[derive(Clone, Debug)]
pub(super) struct Chunk {
    /// Where it stands.
    pub text: Range<usize>,
    /// Index of its first ball.
    pub first: usize,
}

/// A text cut where its list of balls begins and ends.
#[derive(Debug)]
pub(super) struct Pieces<'t> {
    text: &'t str,
    /// What is around the balls, as one text.
    pub around: String,
    /// Where the balls stand.
    cut: Range<usize>,
}

/// A piece, parsed.
#[derive(Debug)]
pub(super) struct Piece<'t> {
    /// Where it stands.
    pub chunk: Chunk,
    root: Spanned<DeTable<'t>>,
}

#[derive(Deserialize)]
struct Balls {
    balls: Vec<BallFile>,
}

impl<'t> Pieces<'t> {
    /// The pieces of a text; `None` for one that is not large, or has no list of balls in one place.
    pub fn of(text: &'t str) -> Option<Self> {
        if text.len() <= LARGE {
            return None;
        }
        let begins = |line: &str, with: &str| line.trim_start().starts_with(with);
        let mut cut: Option<Range<usize>> = None;
        let mut at = 0;
        for line in text.split_inclusive('\n') {
            match &mut cut {
                None if begins(line, BALL) => cut = Some(at..text.len()),
                Some(cut) if begins(line, "[") && !begins(line, BALL) => cut.end = cut.end.min(at),
                // a list in two places
                Some(cut) if cut.end < text.len() && begins(line, BALL) => return None,
                _ => {}
            }
            at += line.len();
        }
        let cut = cut?;
        Some(Pieces {
            text,
            around: format!("{}{}", &text[..cut.start], &text[cut.end..]),
            cut,
        })
    }

    /// By how much what is found in [`Pieces::around`] stands elsewhere in the text.
    pub fn shift(&self) -> Shift {
        Shift {
            from: self.cut.start,
            by: self.cut.len(),
        }
    }

    /// The pieces, one after another, each parsed when it is asked for; `None` where one is not what it should be.
    pub fn each(&self) -> impl Iterator<Item = Option<Piece<'t>>> {
        let (text, end) = (self.text, self.cut.end);
        let (mut start, mut first) = (self.cut.start, 0);
        std::iter::from_fn(move || {
            if start >= end {
                return None;
            }
            let chunk = Chunk {
                text: start..next_ball(text, start + PIECE, end),
                first,
            };
            start = chunk.text.end;
            let piece = Piece::parse(text, chunk);
            first += piece.as_ref().map_or(0, |piece| piece.balls().len());
            Some(piece)
        })
    }
}

/// Where the first line at `from` or later begins a ball; `end` if none does before it.
fn next_ball(text: &str, from: usize, end: usize) -> usize {
    let mut at = from;
    while at < end {
        let Some(newline) = text.as_bytes()[at..end]
            .iter()
            .position(|byte| *byte == b'\n')
        else {
            return end;
        };
        at += newline + 1;
        if text[at..end]
            .trim_start_matches([' ', '\t'])
            .starts_with(BALL)
        {
            return at;
        }
    }
    end
}

impl<'t> Piece<'t> {
    /// Reads the piece of `text` at `chunk`; `None` unless it is a list of balls and nothing else.
    pub fn parse(text: &'t str, chunk: Chunk) -> Option<Self> {
        let (root, errors) = DeTable::parse_recoverable(&text[chunk.text.clone()]);
        let mut keys = root.get_ref().iter();
        let list = keys.next().filter(|(key, _)| key.get_ref() == "balls")?;
        let alone = errors.is_empty() && keys.next().is_none();
        let whole = alone && matches!(list.1.get_ref(), DeValue::Array(_));
        whole.then_some(Piece { chunk, root })
    }

    /// Its balls.
    pub fn balls(&self) -> &[Spanned<DeValue<'t>>] {
        let list = self.root.get_ref().get("balls");
        let list = list.and_then(|list| list.get_ref().as_array());
        list.map_or(&[], |list| list.as_ref())
    }

    /// Its balls as the file type has them.
    pub fn read(self) -> Result<Vec<BallFile>, toml::de::Error> {
        Balls::deserialize(Deserializer::from(self.root)).map(|read| read.balls)
    }

    /// The table that holds its balls.
    pub fn into_table(self) -> DeTable<'t> {
        self.root.into_inner()
    }
}

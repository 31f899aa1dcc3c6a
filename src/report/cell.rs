//! One cell as every format shows it: short for a reader, exact for a program.

use super::words::{in_cell, plain};
use crate::finding::{Cell, Column, Table};
use crate::trace::files::shortest;

/// A number with three significant digits: `0`, `1.23`, `0.00123`, `12346`, `1.23e-9`, `NaN`, `inf`.
pub fn significant(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return if x == 0.0 {
            "0".to_owned()
        } else {
            shortest(x)
        };
    }
    let scientific = format!("{x:.2e}");
    let exponent = scientific.split_once('e').map(|(_, e)| e.parse::<i32>());
    match exponent {
        Some(Ok(e @ -3..=5)) => format!("{x:.*}", (2 - e).max(0) as usize),
        _ => scientific,
    }
}

/// What a reader sees, in one line; what is markup in a format is for its writer.
pub fn shown(cell: &Cell) -> String {
    match cell {
        Cell::Empty => String::new(),
        Cell::Text(words) | Cell::Verdict(_, words) | Cell::Page(_, words) => {
            in_cell(words).into_owned()
        }
        Cell::Number(x) => significant(*x),
        Cell::Fixed(x, digits) if x.is_finite() => format!("{x:.*}", usize::from(*digits)),
        Cell::Fixed(x, _) => shortest(*x),
        Cell::Count(n) => n.to_string(),
        Cell::Owned(x, owner) if owner.is_empty() => significant(*x),
        Cell::Owned(x, owner) => format!("{} ({})", significant(*x), plain(owner)),
        Cell::Picture(figure) => in_cell(&figure.title).into_owned(),
    }
}

/// True for a column of pictures, which has no place in text.
pub fn only_pictures(table: &Table, index: usize) -> bool {
    let mut cells = table
        .rows
        .iter()
        .filter_map(|row| row.get(index))
        .peekable();
    cells.peek().is_some() && cells.all(|cell| matches!(cell, Cell::Picture(_)))
}

/// What a program reads: every digit.
#[derive(Clone, Debug, PartialEq)]
pub enum Exact<'a> {
    /// There is no value.
    Nothing,
    /// Words.
    Words(&'a str),
    /// A number.
    Number(f64),
    /// A whole number.
    Whole(u64),
}

impl Exact<'_> {
    /// As a CSV field: the shortest decimal that reads back to the bit.
    pub fn field(&self) -> String {
        match *self {
            Exact::Nothing => String::new(),
            Exact::Words(words) => words.to_owned(),
            Exact::Number(x) => shortest(x),
            Exact::Whole(n) => n.to_string(),
        }
    }
}

/// One column of the exact table. A column whose cells carry a second value (the owner of a number, the page of a link)
/// becomes two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExactColumn<'a> {
    /// The column that it comes from.
    pub column: &'a Column,
    index: usize,
    second: Option<&'static str>,
}

impl<'a> ExactColumn<'a> {
    /// Key in CSV and JSON: the column's, with `-owner` or `-page` for a second value.
    pub fn key(&self) -> String {
        match self.second {
            None => self.column.key.clone(),
            Some(second) => format!("{}-{second}", self.column.key),
        }
    }

    /// Unit; empty for none.
    pub fn unit(&self) -> &'a str {
        if self.second.is_some() {
            ""
        } else {
            &self.column.unit
        }
    }

    /// The value of this column in a row; nothing where the row is too short.
    pub fn value<'r>(&self, row: &'r [Cell]) -> Exact<'r> {
        let Some(cell) = row.get(self.index) else {
            return Exact::Nothing;
        };
        match self.second {
            None => first(cell),
            Some(kind) => match second(cell) {
                Some((name, words)) if name == kind => Exact::Words(words),
                _ => Exact::Nothing,
            },
        }
    }
}

/// The columns of a table as programs see them.
pub fn exact_columns(table: &Table) -> Vec<ExactColumn<'_>> {
    let mut columns = Vec::new();
    for (index, column) in table.columns.iter().enumerate() {
        let entry = |second| ExactColumn {
            column,
            index,
            second,
        };
        columns.push(entry(None));
        for kind in ["owner", "page"] {
            let cells = table.rows.iter().filter_map(|row| row.get(index));
            if cells.filter_map(second).any(|(name, _)| name == kind) {
                columns.push(entry(Some(kind)));
            }
        }
    }
    columns
}

fn first(cell: &Cell) -> Exact<'_> {
    match cell {
        Cell::Empty => Exact::Nothing,
        Cell::Text(words) | Cell::Verdict(_, words) | Cell::Page(_, words) => Exact::Words(words),
        Cell::Number(x) | Cell::Fixed(x, _) | Cell::Owned(x, _) => Exact::Number(*x),
        Cell::Count(n) => Exact::Whole(*n),
        Cell::Picture(figure) => Exact::Words(&figure.title),
    }
}

fn second(cell: &Cell) -> Option<(&'static str, &str)> {
    match cell {
        Cell::Owned(_, owner) => Some(("owner", owner)),
        Cell::Page(id, _) => Some(("page", id)),
        Cell::Empty
        | Cell::Text(_)
        | Cell::Verdict(..)
        | Cell::Number(_)
        | Cell::Fixed(..)
        | Cell::Count(_)
        | Cell::Picture(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::significant;

    #[test]
    fn three_digits_are_significant_whatever_the_size() {
        for (x, expected) in [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1.00"),
            (9.999, "10.0"),
            (-123.456, "-123"),
            (12345.6, "12346"),
            (1_234_567.0, "1.23e6"),
            (0.001_234, "0.00123"),
            (0.000_123_4, "1.23e-4"),
            (5e-324, "4.94e-324"),
            (f64::NAN, "NaN"),
            (f64::NEG_INFINITY, "-inf"),
        ] {
            assert_eq!(significant(x), expected, "{x:e}");
        }
    }
}

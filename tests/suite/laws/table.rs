//! A table of numbers in `validation/references/`, read by the names of its columns.

use carom::math::Vec3;

/// A CSV file.
pub struct Table {
    name: String,
    header: Vec<String>,
    rows: Vec<Vec<String>>,
}

/// One row of it.
#[derive(Clone, Copy)]
pub struct Row<'a> {
    table: &'a Table,
    index: usize,
}

impl Table {
    /// Reads `validation/references/NAME`.
    pub fn read(name: &str) -> Table {
        let text = crate::references::text(name);
        let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned));
        let header = lines.next().unwrap().collect();
        let rows: Vec<Vec<String>> = lines.map(Iterator::collect).collect();
        assert!(!rows.is_empty(), "{name} has no row");
        Table {
            name: name.to_owned(),
            header,
            rows,
        }
    }

    pub fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        (0..self.rows.len()).map(|index| Row { table: self, index })
    }
}

impl Row<'_> {
    /// The cell of a column, as written.
    pub fn text(&self, column: &str) -> &str {
        let at = self.table.header.iter().position(|name| name == column);
        let at = at.unwrap_or_else(|| panic!("{} has no column {column}", self.table.name));
        &self.table.rows[self.index][at]
    }

    /// The number in a column.
    pub fn number(&self, column: &str) -> f64 {
        let text = self.text(column);
        text.parse()
            .unwrap_or_else(|_| panic!("{self}: {column} is {text}"))
    }

    /// The numbers in the columns `{before}x{after}`, `{before}y{after}` and `{before}z{after}`.
    pub fn vector(&self, before: &str, after: &str) -> Vec3 {
        let part = |axis: &str| self.number(&format!("{before}{axis}{after}"));
        Vec3::new(part("x"), part("y"), part("z"))
    }
}

impl std::fmt::Display for Row<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} row {}", self.table.name, self.index + 1)
    }
}

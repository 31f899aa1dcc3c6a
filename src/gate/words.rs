//! What differs from what was accepted, as a table and in a sentence.

use super::{Change, Kind, Row};
use crate::finding::{Cell, Column, Table, Tone};

/// A change with the scene that it belongs to.
#[derive(Clone, Debug, PartialEq)]
pub struct Located {
    /// Name of the scene.
    pub scene: String,
    /// The change.
    pub change: Change,
}

/// One row a change, the first `most` of them.
pub fn changes_table(changes: &[Located], most: usize) -> Table {
    let row = |located: &Located| {
        let change = &located.change;
        let named = change.row();
        let text = |of: fn(&Row) -> &str| named.map_or(Cell::Empty, |row| Cell::text(of(row)));
        let number = |row: &Option<Row>| Cell::maybe(row.as_ref().and_then(|row| row.value));
        let verdict = |row: &Option<Row>| {
            let known = row.as_ref().and_then(|row| row.verdict);
            known.map_or(Cell::Empty, |verdict| Cell::text(verdict.id()))
        };
        vec![
            Cell::text(&located.scene),
            text(|row| &row.engine),
            text(|row| &row.check),
            text(|row| &row.subject),
            Cell::verdict(tone(change.kind), change.kind.id()),
            verdict(&change.old),
            verdict(&change.new),
            number(&change.old),
            number(&change.new),
            Cell::maybe(change.bound),
        ]
    };
    Table {
        id: "changes".to_owned(),
        title: "What is not as accepted".to_owned(),
        columns: vec![
            Column::words("scene", "scene"),
            Column::words("engine", "engine"),
            Column::words("check", "check"),
            Column::words("subject", "subject"),
            Column::words("change", "change"),
            Column::words("old-verdict", "was"),
            Column::words("new-verdict", "is"),
            Column::number("old", "was", ""),
            Column::number("new", "is", ""),
            Column::number("bound", "may move by", ""),
        ],
        rows: changes.iter().take(most).map(row).collect(),
        note: match changes.len().saturating_sub(most) {
            0 => String::new(),
            more => format!("{more} more are not shown."),
        },
    }
}

fn tone(kind: Kind) -> Tone {
    match kind {
        Kind::Worse | Kind::Vanished => Tone::Bad,
        Kind::Better | Kind::Moved | Kind::Appeared => Tone::Notice,
    }
}

/// `12 findings differ: 3 worse, 9 moved`; `None` where none does.
pub fn changes_sentence(changes: &[Located]) -> Option<String> {
    if changes.is_empty() {
        return None;
    }
    let kinds = [
        Kind::Worse,
        Kind::Better,
        Kind::Moved,
        Kind::Vanished,
        Kind::Appeared,
    ];
    let count = |kind: Kind| changes.iter().filter(|c| c.change.kind == kind).count();
    let parts: Vec<String> = kinds
        .into_iter()
        .filter(|kind| count(*kind) > 0)
        .map(|kind| format!("{} {}", count(kind), kind.id()))
        .collect();
    let verb = if changes.len() == 1 {
        "finding differs"
    } else {
        "findings differ"
    };
    Some(format!("{} {verb}: {}", changes.len(), parts.join(", ")))
}

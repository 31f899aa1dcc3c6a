//! The audit of the report's claims as a document.

use crate::finding::{Align, Block, Cell, Column as TableColumn, Document, Table};
use crate::study::claims::Claim;

/// The page of the audit.
pub fn page(claims: &[Claim]) -> Document {
    let mut blocks = vec![Block::Text(
        "Every statement of the report that can be computed, computed now by the engines of this workbench.".to_owned(),
    )];
    for claim in claims {
        let rows = claim.numbers.iter().map(|(what, value, unit)| {
            vec![
                Cell::text(what.clone()),
                Cell::Number(*value),
                Cell::text(unit.clone()),
            ]
        });
        blocks.push(Block::Heading(claim.says.to_owned()));
        blocks.push(Block::Text(claim.found.clone()));
        blocks.push(Block::Table(Table {
            id: format!("claim-{}", claim.id),
            title: String::new(),
            columns: vec![
                TableColumn::words("what", "what"),
                TableColumn {
                    align: Align::Right,
                    ..TableColumn::words("value", "computed")
                },
                TableColumn::words("unit", "unit"),
            ],
            rows: rows.collect(),
            note: claim.how.clone(),
        }));
    }
    Document {
        id: "report-audit".to_owned(),
        stopped_early: None,
        title: "Audit of the report".to_owned(),
        lead: String::new(),
        blocks,
        pages: Vec::new(),
    }
}

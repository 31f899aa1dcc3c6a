//! Every metric of every engine: the worst of each over balls and events, from the list of metrics.

use crate::compare::METRICS;
use crate::finding::{Cell, Column, Table};
use crate::study::compare::{ComparisonEntry, ComparisonOutcome};

/// One row a metric, one column an engine; where there is no reference also one a pair.
pub fn table(outcome: &ComparisonOutcome) -> Table {
    let engines: Vec<String> = outcome.entries.iter().map(ComparisonEntry::label).collect();
    let mut labels: Vec<&str> = Vec::new();
    for finding in &outcome.findings {
        let label = finding.engine.as_str();
        let is_told = outcome.reference.is_none() || engines.iter().any(|known| known == label);
        if is_told && !labels.contains(&label) {
            labels.push(label);
        }
    }
    let mut columns = vec![
        Column::words("metric", "metric"),
        Column::words("unit", "unit"),
    ];
    columns.extend(labels.iter().map(|label| Column::number(label, label, "")));
    columns.push(Column::words("what", "what it is"));
    let rows = METRICS.iter().map(|metric| {
        let mut row = vec![Cell::text(metric.id), Cell::text(metric.unit)];
        let worst = |label: &&str| outcome.worst(label, metric.id).map(|(value, _)| value);
        row.extend(labels.iter().map(|label| Cell::maybe(worst(label))));
        row.push(Cell::text(metric.what));
        row
    });
    Table {
        id: "metrics".to_owned(),
        title: String::new(),
        columns,
        rows: rows.collect(),
        note: "The largest over balls and events; an empty place has none. R is the smallest radius of the scene.".to_owned(),
    }
}

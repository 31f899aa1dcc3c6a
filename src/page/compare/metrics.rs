//! Every metric of every engine: the worst of each over balls and events, from the list of metrics.

use crate::compare::METRICS;
use crate::finding::{Cell, Column, Table};
use crate::study::compare::ComparisonOutcome;

/// One row a metric, one column an engine, or a pair where there is no reference.
pub fn table(outcome: &ComparisonOutcome) -> Table {
    let mut labels: Vec<&str> = Vec::new();
    for finding in &outcome.findings {
        if !labels.contains(&finding.engine.as_str()) {
            labels.push(&finding.engine);
        }
    }
    let mut columns = vec![
        Column::words("metric", "metric"),
        Column::words("unit", "unit"),
        Column::words("what", "what it is"),
    ];
    columns.extend(labels.iter().map(|label| Column::number(label, label, "")));
    let rows = METRICS.iter().map(|metric| {
        let mut row = vec![
            Cell::text(metric.id),
            Cell::text(metric.unit),
            Cell::text(metric.what),
        ];
        let worst = |label: &&str| outcome.worst(label, metric.id).map(|(value, _)| value);
        row.extend(labels.iter().map(|label| Cell::maybe(worst(label))));
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

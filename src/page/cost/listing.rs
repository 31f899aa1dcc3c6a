//! The price lists of earlier studies, as a report shows them.

use crate::finding::{Block, Cell, Column, Table};
use crate::scene::Scene;
use crate::study::cost::{PriceList, Quantity};
use crate::words::describe_span;

/// The errors of the final position that a report has prices for, R.
const SHOWN: [f64; 5] = [1e-1, 1e-2, 1e-4, 1e-6, 1e-9];

/// Price lists of the scenes of a report, and the command that makes one where there is none.
///
/// A list of an earlier version, or of a scene that has changed since, is not shown.
pub fn listing(scenes: &[Scene], lists: &[PriceList]) -> Vec<Block> {
    let list = |scene: &Scene| lists.iter().find(|list| list.is_of(scene));
    let known: Vec<(&Scene, &PriceList)> = scenes
        .iter()
        .filter_map(|scene| Some((scene, list(scene)?)))
        .collect();
    let mut blocks = Vec::new();
    if !known.is_empty() {
        blocks.push(Block::Table(table(&known)));
    }
    let missing: Vec<&str> = scenes
        .iter()
        .filter(|scene| list(scene).is_none())
        .map(|scene| scene.name.as_str())
        .collect();
    if let Some(first) = missing.first() {
        blocks.push(Block::Text(format!(
            "No prices yet for {}. A study leaves them in the folder of this report:",
            missing.join(", ")
        )));
        blocks.push(Block::Command(format!("carom cost {first}")));
    }
    blocks
}

fn table(known: &[(&Scene, &PriceList)]) -> Table {
    let mut columns = vec![Column::words("scene", "scene")];
    columns.extend(SHOWN.map(|error| {
        let key = format!("within-{error:e}");
        Column::words(&key, &format!("{error:e} R"))
    }));
    let row = |(scene, list): &(&Scene, &PriceList)| {
        let price = |error: f64| {
            let mut prices = list.prices.iter();
            let price = prices.find(|price| {
                price.quantity == Quantity::FinalPosition.id() && price.error == error
            });
            price.map_or(Cell::Empty, |price| {
                Cell::Text(format!("{} {}", describe_span(price.seconds), price.label))
            })
        };
        let cells = SHOWN.map(price);
        std::iter::once(Cell::text(scene.name.clone()))
            .chain(cells)
            .collect()
    };
    Table {
        id: "prices".to_owned(),
        title: "The cheapest setting for an error of the final position".to_owned(),
        columns,
        rows: known.iter().map(row).collect(),
        note: "Time per shot and setting, from the latest study of each scene. Empty: no setting of its grid reaches it.".to_owned(),
    }
}

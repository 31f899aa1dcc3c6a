//! Where a run broke, on the table.

use crate::finding::{Figure, Series, Style};
use crate::page::compare::{TABLE_CAPTION, table_picture};
use crate::scene::Scene;
use crate::study::stability::{FoundAt, Judged};
use crate::trace::Trace;

/// Paths on the table, and points where it broke.
pub fn picture(scene: &Scene, label: &str, trace: &Trace, judged: &Judged) -> Figure {
    let id = format!("{}-{label}", scene.name).replace([' ', '=', ':', '.'], "-");
    let mut figure = table_picture(scene, trace, &id);
    figure.title = format!("{label}: {}", judged.why);
    figure.caption = format!("{TABLE_CAPTION} Signs: where it broke.");
    let place = judged.spoken().and_then(|(_, j)| j.place.as_ref());
    for point in place.map_or(Vec::new(), |place| points(trace, place)) {
        figure.series.push(Series {
            name: "broken here".to_owned(),
            points: vec![point],
            style: Style::Points,
        });
    }
    figure
}

fn points(trace: &Trace, place: &FoundAt) -> Vec<[f64; 2]> {
    let at = |&ball: &usize| {
        let state = trace.paths.get(ball)?.state_at(place.time)?;
        let point = [state.position.x, state.position.y];
        point.iter().all(|x| x.is_finite()).then_some(point)
    };
    place.balls.iter().filter_map(at).collect()
}

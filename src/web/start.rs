//! The picture of a scene before anything has run: where the balls lie, and where the shot goes.

use crate::finding::{Axis, Figure, Series, Style};
use crate::report::svg;
use crate::scene::{Ball, Scene};

/// Length of the line of a shot on a plane without edges, radii.
const REACH: f64 = 40.0;

/// The picture as a part of a page.
pub fn html(scene: &Scene) -> String {
    let drawing = svg::draw(&picture(scene), "start");
    format!("<div class=\"picture at-start\">{}</div>", drawing.svg)
}

fn picture(scene: &Scene) -> Figure {
    let cue = scene.cue_ball();
    let mut series = Vec::new();
    for (i, ball) in scene.balls.iter().enumerate() {
        let name = if i == cue { "cue ball" } else { "other balls" };
        if ball.state.speed() > 0.0 {
            series.push(Series {
                name: "where it goes".to_owned(),
                points: way(scene, ball),
                style: Style::Line,
            });
        }
        series.push(Series {
            name: name.to_owned(),
            points: vec![[ball.state.position.x, ball.state.position.y]],
            style: Style::Discs(ball.radius),
        });
    }
    let unit = &scene.units.length;
    Figure {
        id: "start".to_owned(),
        title: format!("The start of {}", scene.name),
        caption: String::new(),
        x: Axis::linear("x", unit),
        y: Axis::linear("y", unit),
        equal_scale: true,
        outline: scene.table.map(|table| [table.min, table.max]),
        series,
        marks: Vec::new(),
    }
}

/// A line along the velocity of a ball, as far as its centre may go.
fn way(scene: &Scene, ball: &Ball) -> Vec<[f64; 2]> {
    let (at, v) = (ball.state.position, ball.state.velocity);
    let along = v / ball.state.speed();
    let mut reach = REACH * ball.radius;
    if let Some(table) = scene.table {
        let to_edge = |axis: usize| {
            let (low, high) = (table.min[axis] + ball.radius, table.max[axis] - ball.radius);
            match along[axis] {
                c if c > 0.0 => (high - at[axis]) / c,
                c if c < 0.0 => (low - at[axis]) / c,
                _ => f64::INFINITY,
            }
        };
        reach = to_edge(0).min(to_edge(1)).max(0.0);
    }
    vec![
        [at.x, at.y],
        [at.x + reach * along.x, at.y + reach * along.y],
    ]
}

//! Guides: thin lines to hold others against, each with its name at its end, and the broad pale lines below all others.

use super::series::places_in_order;
use super::words::text_width;
use super::{Plane, lettering, px};
use crate::finding::{Figure, Series, Style};

/// Size of the words, px.
const SIZE: f64 = 11.0;
/// Height of a line of them, px.
const LINE: f64 = 14.0;

/// Every band, then every guide.
pub fn lines(figure: &Figure, plane: &Plane) -> String {
    let of = |wanted: Style, class: &str| -> String {
        let series = figure.series.iter().filter(|s| s.style == wanted);
        series.map(|series| line(class, series, plane)).collect()
    };
    of(Style::Band, "b") + &of(Style::Guide, "j")
}

/// The name of every guide; `corners`: left, top, right, bottom of the plot, px.
pub fn names(figure: &Figure, plane: &Plane, corners: [f64; 4]) -> String {
    let mut taken: Vec<[f64; 4]> = Vec::new();
    let guides = figure.series.iter().filter(|s| s.style == Style::Guide);
    guides
        .map(|guide| name(guide, plane, corners, &mut taken))
        .collect()
}

fn line(class: &str, series: &Series, plane: &Plane) -> String {
    let mut d = String::new();
    for run in places_in_order(series, plane) {
        for (i, (x, y)) in run.into_iter().enumerate() {
            d += &format!("{}{} {}", if i == 0 { 'M' } else { 'L' }, px(x), px(y));
        }
    }
    match d.as_str() {
        "" => d,
        d => format!("<path class=\"{class}\" d=\"{d}\"/>"),
    }
}

/// The name of a guide by its last point, within the plot and over no other name.
fn name(series: &Series, plane: &Plane, corners: [f64; 4], taken: &mut Vec<[f64; 4]>) -> String {
    let [left, top, right, bottom] = corners;
    let runs = places_in_order(series, plane);
    let Some(&(x, y)) = runs.last().and_then(|run| run.last()) else {
        return String::new();
    };
    if series.name.is_empty() {
        return String::new();
    }
    let width = text_width(&series.name, SIZE);
    let x = (x + 4.0).min(right - width - 4.0).max(left + 2.0);
    let free = |y: f64, taken: &[[f64; 4]]| {
        taken
            .iter()
            .all(|[l, t, r, b]| x > *r || x + width < *l || y - LINE >= *b || y <= *t)
    };
    // above the line, else below it, else farther away
    let shifts = (0..8).flat_map(|k| [-5.0 - f64::from(k) * LINE, 14.0 + f64::from(k) * LINE]);
    let places = shifts.map(|shift| y + shift);
    let mut places = places.filter(|y| *y - LINE >= top && *y + 3.0 <= bottom);
    let Some(y) = places.find(|y| free(*y, taken)) else {
        return String::new();
    };
    taken.push([x, y - LINE, x + width, y]);
    format!(
        "<text class=\"n p\" x=\"{}\" y=\"{}\">{}</text>",
        px(x),
        px(y),
        lettering(&series.name)
    )
}

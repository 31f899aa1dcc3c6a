//! Pictures without axes: places side by side that have only their own scale.

use super::legend::Legend;
use super::series::{self, Pen};
use super::{Drawing, Plane, described, lettering, px, text_width};
use crate::finding::{Figure, Style};

/// Largest size of what is drawn without the words around it, px: it stands beside a table.
const SIZE: (f64, f64) = (500.0, 260.0);
/// Space at every side, px.
const EDGE: f64 = 10.0;

/// The picture, with its legend above it.
pub fn draw(figure: &Figure, anchor: &str) -> Drawing {
    let plane = Plane::of(figure);
    let (wide, high) = plane.fitted(SIZE.0, SIZE.1);
    let plane = plane.placed(0.0, 0.0, wide, high);
    let (left, right) = written(figure, &plane, wide);
    let legend = Legend::of(figure, (right - left).max(SIZE.0));
    let width = (right - left).max(legend.width) + 2.0 * EDGE;
    let top = EDGE + legend.height;
    let indent = 0.5 * (width - (right - left)) - left;
    let plane = plane.placed(indent, top, wide, high);
    let mut svg = format!(
        "<svg class=\"fig\" viewBox=\"0 0 {w} {h}\" width=\"{w}\" height=\"{h}\" \
         role=\"img\" aria-labelledby=\"{anchor}-title {anchor}-what\"><title id=\"{anchor}-title\">{title}</title>\
         <desc id=\"{anchor}-what\">{what}</desc>",
        w = px(width),
        h = px(top + high + EDGE),
        anchor = lettering(anchor),
        title = lettering(&figure.title),
        what = lettering(&described(figure)),
    );
    svg += &legend.drawn(0.5 * (width - legend.width), 0.5 * EDGE);
    svg += &series::drawn(figure, &plane, &Pen::FULL);
    svg += "</svg>";
    // gaps in a line are where it leaves a place: nothing to remark
    Drawing {
        svg,
        remarks: Vec::new(),
    }
}

/// From where to where the picture reaches with its words, px: the plane itself from 0 to `wide`.
fn written(figure: &Figure, plane: &Plane, wide: f64) -> (f64, f64) {
    let words = figure
        .series
        .iter()
        .filter(|series| matches!(series.style, Style::Words));
    let mut reach = (0.0_f64, wide);
    for series in words {
        let half = 0.5 * text_width(&series.name, 13.0);
        for (x, _) in series.points.iter().filter_map(|&at| plane.place(at)) {
            reach = (reach.0.min(x - half), reach.1.max(x + half));
        }
    }
    reach
}

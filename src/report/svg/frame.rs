//! The frame of a picture: where everything goes, and the table.

use super::axes::Axes;
use super::scale::Scale;
use super::{Plane, WIDTH, guides, legend, marks, px, series, tiles};
use crate::finding::{Figure, Style};

/// Space below the plot for numbers and the name of the axis, px.
const BELOW: f64 = 46.0;
/// Height of an ordinary plot, px.
const PLOT: f64 = 330.0;
/// Largest height of a picture of a table, px.
const TABLE: f64 = 440.0;
/// Height of a row of a matrix, and of a list, px.
const ROWS: (f64, f64) = (17.0, 30.0);
/// Width of the cushions around a table, px.
const RAIL: f64 = 7.0;

/// Where everything goes.
pub struct Frame {
    /// Width of the picture, px.
    pub width: f64,
    /// Height of the picture, px.
    pub height: f64,
    /// Marks whose labels have no room.
    pub dropped_labels: usize,
    plane: Plane,
    axes: Axes,
    legend: legend::Legend,
    marks: marks::Marks,
    empty: bool,
}

impl Frame {
    /// The layout of a figure.
    pub fn of(figure: &Figure) -> Frame {
        let plane = Plane::of(figure);
        let rail = if figure.outline.is_some() { RAIL } else { 0.0 };
        let right = 18.0 + rail;
        let room = |beside: f64| WIDTH - (14.0 + beside + rail) - right;
        let height = match figure.y.names.len() {
            _ if figure.equal_scale => plane.fitted(room(60.0), TABLE).1,
            0 => PLOT,
            rows => rows as f64 * row_height(figure),
        };
        let width = |beside: f64| match figure.equal_scale {
            true => plane.fitted(room(beside), TABLE).0,
            false => room(beside),
        };
        let axes = Axes::of(figure, &plane, height, width);
        let left = 14.0 + axes.left + rail;
        let (plot_width, plot_height) = match figure.equal_scale {
            true => plane.fitted(WIDTH - left - right, TABLE),
            false => (WIDTH - left - right, height),
        };
        let legend = legend::Legend::of(figure, WIDTH - left - right + rail);
        let width = (left + plot_width.max(legend.width) + right).clamp(300.0, WIDTH);
        let across = if plane.on_its_side { plane.y } else { plane.x };
        let across = Scale {
            from: left,
            to: left + plot_width,
            ..across
        };
        let marks = marks::Marks::of(figure, &across, plane.on_its_side);
        let top = 8.0 + legend.height + marks.height + axes.above + rail;
        Frame {
            width,
            height: top + plot_height + rail + BELOW,
            dropped_labels: marks.dropped,
            plane: plane.placed(left, top, plot_width, plot_height),
            empty: !series::any_place(figure, &plane.placed(left, top, plot_width, plot_height)),
            axes,
            legend,
            marks,
        }
    }

    /// Everything inside the `svg` element.
    pub fn drawn(&self, figure: &Figure) -> String {
        let (left, top, right, bottom) = self.corners();
        let rail = if figure.outline.is_some() { RAIL } else { 0.0 };
        let mut svg = self.legend.drawn(left - rail, 8.0);
        svg += &outline(figure, &self.plane, rail);
        let corners = [left, top, right, bottom];
        svg += &tiles::drawn(figure, &self.plane);
        svg += &self.axes.drawn(figure, &self.plane, corners, rail);
        if self.empty {
            let (x, y) = (0.5 * (left + right), 0.5 * (top + bottom));
            svg += &format!(
                "<text class=\"s a\" x=\"{}\" y=\"{}\">no points to show</text>",
                px(x),
                px(y)
            );
        }
        svg += &self.marks.drawn(top - rail - self.axes.above, bottom);
        svg += &guides::lines(figure, &self.plane);
        svg += &series::drawn(figure, &self.plane, &series::Pen::FULL);
        svg + &guides::names(figure, &self.plane, corners)
    }

    /// Left, top, right and bottom of the plot, px.
    fn corners(&self) -> (f64, f64, f64, f64) {
        let (x, y) = (self.plane.x, self.plane.y);
        if self.plane.on_its_side {
            (y.from, x.from, y.to, x.to)
        } else {
            (x.from, y.from.min(y.to), x.to, y.from.max(y.to))
        }
    }
}

/// Height of one place of an upright axis of words, px.
fn row_height(figure: &Figure) -> f64 {
    let mut series = figure.series.iter();
    match series.any(|series| matches!(series.style, Style::Tiles(_))) {
        true => ROWS.0,
        false => ROWS.1,
    }
}

/// The table and its cushions, or nothing.
pub fn outline(figure: &Figure, plane: &Plane, rail: f64) -> String {
    let Some([low, high]) = figure.outline else {
        return String::new();
    };
    let (Some(a), Some(b)) = (plane.place(low), plane.place(high)) else {
        return String::new();
    };
    let (x, y) = (a.0.min(b.0), a.1.min(b.1));
    let (width, height) = ((a.0 - b.0).abs(), (a.1 - b.1).abs());
    let rect = |class: &str, grow: f64, round: f64| {
        format!(
            "<rect class=\"{class}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"{round}\"/>",
            px(x - grow),
            px(y - grow),
            px(width + 2.0 * grow),
            px(height + 2.0 * grow)
        )
    };
    let cushions = if rail > 0.0 {
        rect("r", rail, 4.0)
    } else {
        String::new()
    };
    cushions + &rect("t", 0.0, 0.0)
}

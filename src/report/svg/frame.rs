//! The frame of a picture: where everything goes, axes, grid, table.

use super::scale::Scale;
use super::ticks::{self, Tick};
use super::{Plane, WIDTH, escape, legend, marks, px, series, text_width};
use crate::finding::{Axis, Figure};

/// Space below the plot for numbers and the name of the axis, px.
const BELOW: f64 = 46.0;
/// Height of an ordinary plot, px.
const PLOT: f64 = 330.0;
/// Largest height of a picture of a table, px.
const TABLE: f64 = 440.0;
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
    legend: legend::Legend,
    marks: marks::Marks,
    empty: bool,
}

impl Frame {
    /// The layout of a figure.
    pub fn of(figure: &Figure) -> Frame {
        let plane = Plane::of(figure);
        let rail = if figure.outline.is_some() { RAIL } else { 0.0 };
        let (upright, _) = axes(figure, &plane);
        let widest = vertical_ticks(&plane)
            .iter()
            .map(|tick| text_width(&tick.label, 13.0))
            .fold(0.0, f64::max);
        let name = if axis_name(upright).is_empty() {
            0.0
        } else {
            22.0
        };
        let left = 14.0 + name + widest + rail;
        let right = 18.0 + rail;
        let (plot_width, plot_height) = if figure.equal_scale {
            plane.fitted(WIDTH - left - right, TABLE)
        } else {
            (WIDTH - left - right, PLOT)
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
        let top = 8.0 + legend.height + marks.height + rail;
        Frame {
            width,
            height: top + plot_height + rail + BELOW,
            dropped_labels: marks.dropped,
            plane: plane.placed(left, top, plot_width, plot_height),
            empty: !series::any_place(figure, &plane.placed(left, top, plot_width, plot_height)),
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
        svg += &self.axes(figure, rail);
        if self.empty {
            let (x, y) = (0.5 * (left + right), 0.5 * (top + bottom));
            svg += &format!(
                "<text class=\"s a\" x=\"{}\" y=\"{}\">no points to show</text>",
                px(x),
                px(y)
            );
        }
        svg += &self.marks.drawn(top - rail, bottom);
        svg + &series::drawn(figure, &self.plane, &series::Pen::FULL)
    }

    /// Left, top, right and bottom of the plot, px.
    fn corners(&self) -> (f64, f64, f64, f64) {
        let (x, y) = (self.plane.x, self.plane.y);
        if self.plane.on_its_side {
            (y.from, x.from, y.to, x.to)
        } else {
            (x.from, y.to, x.to, y.from)
        }
    }

    fn axes(&self, figure: &Figure, rail: f64) -> String {
        let (left, top, right, bottom) = self.corners();
        let (upright, level) = axes(figure, &self.plane);
        let (vertical, horizontal) = if self.plane.on_its_side {
            (self.plane.x, self.plane.y)
        } else {
            (self.plane.y, self.plane.x)
        };
        let grid = figure.outline.is_none();
        let mut lines = String::new();
        let mut svg = String::new();
        for tick in vertical_ticks(&self.plane) {
            let Some(y) = vertical.place(tick.at) else {
                continue;
            };
            let major = !tick.label.is_empty();
            if grid && major {
                lines += &format!("M{} {}H{}", px(left), px(y), px(right));
            } else {
                lines += &format!(
                    "M{} {}h-{}",
                    px(left - rail),
                    px(y),
                    if major { 5 } else { 3 }
                );
            }
            if major {
                let (x, y) = (left - rail - 8.0, y + 4.5);
                svg += &format!(
                    "<text class=\"s e\" x=\"{}\" y=\"{}\">{}</text>",
                    px(x),
                    px(y),
                    escape(&tick.label)
                );
            }
        }
        svg += &format!("<path class=\"g\" d=\"{lines}\"/>");
        let mut lines = format!("M{} {}H{}", px(left), px(bottom), px(right));
        if !grid {
            lines.clear();
        }
        for tick in level_ticks(&horizontal) {
            let Some(x) = horizontal.place(tick.at) else {
                continue;
            };
            let major = !tick.label.is_empty();
            lines += &format!(
                "M{} {}v{}",
                px(x),
                px(bottom + rail),
                if major { 5 } else { 3 }
            );
            if major {
                let y = bottom + rail + 18.0;
                svg += &format!(
                    "<text class=\"s a\" x=\"{}\" y=\"{}\">{}</text>",
                    px(x),
                    px(y),
                    escape(&tick.label)
                );
            }
        }
        svg += &format!("<path class=\"x\" d=\"{lines}\"/>");
        let (x, y) = (0.5 * (left + right), bottom + rail + 38.0);
        svg += &format!(
            "<text class=\"a\" x=\"{}\" y=\"{}\">{}</text>",
            px(x),
            px(y),
            escape(&axis_name(level))
        );
        let y = 0.5 * (top + bottom);
        svg + &format!(
            "<text class=\"a\" transform=\"translate(16 {}) rotate(-90)\">{}</text>",
            px(y),
            escape(&axis_name(upright))
        )
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

/// The axis that runs up the paper and the one that runs across it.
fn axes<'a>(figure: &'a Figure, plane: &Plane) -> (&'a Axis, &'a Axis) {
    if plane.on_its_side {
        (&figure.x, &figure.y)
    } else {
        (&figure.y, &figure.x)
    }
}

fn vertical_ticks(plane: &Plane) -> Vec<Tick> {
    let scale = if plane.on_its_side { plane.x } else { plane.y };
    if scale.log {
        ticks::logarithmic(scale.range)
    } else {
        ticks::linear(scale.range, 5)
    }
}

fn level_ticks(scale: &Scale) -> Vec<Tick> {
    if scale.log {
        ticks::logarithmic(scale.range)
    } else {
        ticks::linear(
            scale.range,
            (scale.length() / 90.0).clamp(3.0, 9.0) as usize,
        )
    }
}

fn axis_name(axis: &Axis) -> String {
    if axis.unit.is_empty() {
        axis.label.clone()
    } else {
        format!("{} ({})", axis.label, axis.unit)
    }
}

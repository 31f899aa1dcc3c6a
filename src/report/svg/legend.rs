//! The legend: one entry a name, in rows above the plot where it covers nothing.

use super::series::{Look, Marker, cross, ring};
use super::{escape, names, px, text_width};
use crate::finding::{Figure, Style};

/// Height of a row, px.
const ROW: f64 = 22.0;
/// Length of the sample of a line, px.
const SAMPLE: f64 = 34.0;

/// Entries in their places.
pub struct Legend {
    /// Height of all rows, px; 0 where no legend is needed.
    pub height: f64,
    /// Width of the longest row, px.
    pub width: f64,
    entries: Vec<Entry>,
}

struct Entry {
    x: f64,
    y: f64,
    name: String,
    look: Look,
    lines: bool,
    dashed: bool,
    points: bool,
    rings: bool,
    crosses: bool,
}

impl Legend {
    /// Rows no longer than `room`, px.
    pub fn of(figure: &Figure, room: f64) -> Legend {
        let names = names(figure);
        let mut legend = Legend {
            height: 0.0,
            width: 0.0,
            entries: Vec::new(),
        };
        if names.is_empty() {
            return legend;
        }
        let (mut x, mut y) = (0.0, 0.0);
        for (index, name) in names.iter().enumerate() {
            let length = SAMPLE + 8.0 + text_width(name, 13.0);
            if x > 0.0 && x + length > room {
                (x, y) = (0.0, y + ROW);
            }
            let drawn = |wanted: fn(&Style) -> bool| {
                let mut mine = figure.series.iter().filter(|series| series.name == *name);
                mine.any(|series| wanted(&series.style))
            };
            legend.entries.push(Entry {
                x,
                y,
                name: (*name).to_owned(),
                look: Look::of(figure, Some(index)),
                lines: drawn(|style| matches!(style, Style::Line)),
                dashed: drawn(|style| matches!(style, Style::Dashed)),
                points: drawn(|style| matches!(style, Style::Points)),
                rings: drawn(|style| matches!(style, Style::Discs(_) | Style::Rings)),
                crosses: drawn(|style| matches!(style, Style::Crosses)),
            });
            legend.width = legend.width.max(x + length);
            x += length + 22.0;
        }
        legend.height = y + ROW + 6.0;
        legend
    }

    /// All entries; `left` and `top`: where the first is, px.
    pub fn drawn(&self, left: f64, top: f64) -> String {
        let mut svg = String::new();
        for entry in &self.entries {
            let (x, y) = (left + entry.x, top + entry.y + 0.5 * ROW);
            let mut sample = String::new();
            if entry.lines || entry.dashed {
                let stroke = if entry.lines {
                    entry.look.line()
                } else {
                    entry.look.dashed()
                };
                sample += &format!(
                    "<path class=\"l\" d=\"M{} {}h{SAMPLE}\"{stroke}/>",
                    px(x),
                    px(y)
                );
            }
            let middle = (x + 0.5 * SAMPLE, y);
            if entry.rings {
                sample += &ring(middle, 6.0);
            }
            if entry.crosses {
                sample += &cross(middle, 5.0);
            }
            if entry.points || (entry.lines && entry.look.marked) {
                sample += &Marker::of(entry.look.index).at(middle, 4.0);
            }
            svg += &format!("<g class=\"{}\">{sample}</g>", entry.look.class());
            let (x, y) = (x + SAMPLE + 8.0, y + 4.5);
            svg += &format!(
                "<text x=\"{}\" y=\"{}\">{}</text>",
                px(x),
                px(y),
                escape(&entry.name)
            );
        }
        svg
    }
}

//! The legend: one entry a name, in rows above the plot where it covers nothing.

use super::series::{Look, Marker, cross, dot, is_crowded, ring, warning_ring};
use super::{entries, lettering, names, px, text_width, tiles};
use crate::finding::{Figure, Sign, Style};

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
    crowded: bool,
    entries: Vec<LegendEntry>,
}

struct LegendEntry {
    x: f64,
    y: f64,
    name: String,
    look: Look,
    lines: bool,
    points: bool,
    discs: bool,
    rings: bool,
    crosses: bool,
    band: bool,
    tile: Option<Sign>,
}

impl Legend {
    /// Rows no longer than `room`, px.
    pub fn of(figure: &Figure, room: f64) -> Legend {
        let coloured = names(figure);
        let names = entries(figure);
        let mut legend = Legend {
            height: 0.0,
            width: 0.0,
            crowded: is_crowded(figure),
            entries: Vec::new(),
        };
        if names.is_empty() {
            return legend;
        }
        let (mut x, mut y) = (0.0, 0.0);
        for name in &names {
            let index = coloured.iter().position(|known| known == name);
            let length = SAMPLE + 8.0 + text_width(name, 13.0);
            if x > 0.0 && x + length > room {
                (x, y) = (0.0, y + ROW);
            }
            let drawn = |wanted: fn(&Style) -> bool| {
                let mut mine = figure.series.iter().filter(|series| series.name == *name);
                mine.any(|series| wanted(&series.style))
            };
            legend.entries.push(LegendEntry {
                x,
                y,
                name: (*name).to_owned(),
                look: Look::of(figure, index),
                lines: drawn(|style| matches!(style, Style::Line)),
                points: drawn(|style| matches!(style, Style::Points)),
                discs: drawn(|style| matches!(style, Style::Discs(_))),
                rings: drawn(|style| matches!(style, Style::Rings)),
                crosses: drawn(|style| matches!(style, Style::Crosses)),
                band: drawn(|style| matches!(style, Style::Band)),
                tile: figure.series.iter().find_map(|series| match series.style {
                    Style::Tiles(sign) if series.name == *name => Some(sign),
                    _ => None,
                }),
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
            if entry.lines {
                let stroke = entry.look.line();
                sample += &format!(
                    "<path class=\"l\" d=\"M{} {}h{SAMPLE}\"{stroke}/>",
                    px(x),
                    px(y)
                );
            }
            let middle = (x + 0.5 * SAMPLE, y);
            if entry.band {
                sample += &format!("<path class=\"b\" d=\"M{} {}h{SAMPLE}\"/>", px(x), px(y));
            }
            if let Some(sign) = entry.tile {
                sample += &tiles::fields(&[middle], (18.0, 16.0), sign);
            }
            if entry.discs {
                sample += &ring(middle, 6.0);
            }
            if entry.rings {
                sample += &warning_ring(middle, 6.0);
            }
            if entry.crosses {
                sample += &cross(middle, 5.0);
            }
            if entry.points && self.crowded {
                sample += &dot(middle, entry.look.index, 2.4);
            } else if entry.points || (entry.lines && entry.look.marked) {
                sample += &Marker::of(entry.look.index).at(middle, 4.0);
            }
            let class = match entry.look.index {
                Some(_) => entry.look.class(),
                None => "w".to_owned(),
            };
            svg += &format!("<g class=\"{class}\">{sample}</g>");
            let (x, y) = (x + SAMPLE + 8.0, y + 4.5);
            svg += &format!(
                "<text x=\"{}\" y=\"{}\">{}</text>",
                px(x),
                px(y),
                lettering(&entry.name)
            );
        }
        svg
    }
}

//! Marked times: a thin line through the plot with a few words above it, none of them over another.

use super::scale::Scale;
use super::{lettering, px, text_width};
use crate::finding::Figure;

/// Height of a row of labels, px.
const ROW: f64 = 15.0;
/// Most rows of labels.
const ROWS: usize = 5;

/// Marks in their places.
pub struct Marks {
    /// Height of all rows of labels, px.
    pub height: f64,
    /// Labels without room.
    pub dropped: usize,
    placed: Vec<Placed>,
    rows: usize,
}

struct Placed {
    x: f64,
    /// Row of the label counted from the plot, its left end and its words.
    label: Option<(usize, f64, String)>,
}

impl Marks {
    /// Marks along the horizontal axis `scale`; none where the picture lies on its side.
    pub fn of(figure: &Figure, scale: &Scale, on_its_side: bool) -> Marks {
        let mut marks = Marks {
            height: 0.0,
            dropped: 0,
            placed: Vec::new(),
            rows: 0,
        };
        if on_its_side {
            return marks;
        }
        let inside = |x: &f64| *x >= scale.from - 0.5 && *x <= scale.to + 0.5;
        let mut wanted: Vec<(f64, &str)> = figure
            .marks
            .iter()
            .filter_map(|mark| Some((scale.place(mark.at)?, mark.label.as_str())))
            .filter(|(x, _)| inside(x))
            .collect();
        wanted.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (x, label) in wanted {
            let spot = marks.spot(x, label, scale.to);
            if spot.is_none() && !label.is_empty() {
                marks.dropped += 1;
            }
            let repeated = marks.placed.last().is_some_and(|last| x - last.x < 0.7);
            if spot.is_some() || !repeated {
                marks.placed.push(Placed {
                    x,
                    label: spot.map(|(row, left)| (row, left, label.to_owned())),
                });
            }
        }
        let rows = marks.placed.iter().filter_map(|mark| mark.label.as_ref());
        marks.rows = rows.map(|(row, ..)| row + 1).max().unwrap_or(0);
        marks.height = if marks.rows == 0 {
            0.0
        } else {
            marks.rows as f64 * ROW + 5.0
        };
        marks
    }

    /// A row and left end at which a label covers no other label and no line to one.
    fn spot(&self, x: f64, label: &str, right: f64) -> Option<(usize, f64)> {
        if label.is_empty() {
            return None;
        }
        let width = text_width(label, 11.0);
        let lefts = [x + 3.0, x - 3.0 - width];
        let fits = |row: usize, left: f64| {
            let end = left + width;
            end <= right + 14.0
                && self.placed.iter().all(|other| match &other.label {
                    None => true,
                    Some((its_row, its_left, words)) => {
                        let its_end = its_left + text_width(words, 11.0);
                        let beside =
                            *its_row != row || left > its_end + 6.0 || end < its_left - 6.0;
                        let its_line =
                            *its_row <= row || other.x < left - 2.0 || other.x > end + 2.0;
                        let my_line = *its_row >= row || x < its_left - 2.0 || x > its_end + 2.0;
                        beside && its_line && my_line
                    }
                })
        };
        let rows = (0..ROWS).flat_map(|row| lefts.map(|left| (row, left)));
        // to the left only where there is no more room to the right
        let mut rows = rows.filter(|&(_, left)| left > x || x + 3.0 + width > right + 14.0);
        rows.find(|&(row, left)| fits(row, left))
    }

    /// All marks; `top` and `bottom`: ends of the plot, px.
    pub fn drawn(&self, top: f64, bottom: f64) -> String {
        let (mut lines, mut faint) = (String::new(), String::new());
        let mut labels = String::new();
        for mark in &self.placed {
            match &mark.label {
                None => faint += &format!("M{} {}V{}", px(mark.x), px(top), px(bottom)),
                Some((row, left, words)) => {
                    let y = top - 5.0 - *row as f64 * ROW;
                    labels += &format!(
                        "<text class=\"n\" x=\"{}\" y=\"{}\">{}</text>",
                        px(*left),
                        px(y),
                        lettering(words)
                    );
                    lines += &format!("M{} {}V{}", px(mark.x), px(y - 9.0), px(bottom));
                }
            }
        }
        let path = |class: &str, d: String| match d.as_str() {
            "" => String::new(),
            d => format!("<path class=\"{class}\" d=\"{d}\"/>"),
        };
        path("f", faint) + &path("v", lines) + &labels
    }
}

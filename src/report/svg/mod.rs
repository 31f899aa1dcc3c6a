//! Figures as SVG: the same bytes for the same figure, readable in black and white, in the dark, and by screen readers.
//!
//! Colours are near those of Okabe and Ito 2008, moved until each stands out from the paper and all can be told apart by
//! colour-blind people (the tests measure both); every series also has its own dashes or its own kind of
//! point. Colours and fonts are style, which a page holds once ([`STYLE`]), so that a picture follows the page into the
//! dark and onto paper.

mod axes;
mod bare;
mod frame;
mod guides;
mod legend;
mod marks;
mod scale;
mod series;
mod simplify;
mod ticks;
mod tiles;
mod words;

use crate::finding::{Figure, Series, Style};
use crate::scene::is_hidden;
use scale::{Extent, Scale, on_axis};
use words::text_width;

/// The style that every picture needs, once a page.
pub const STYLE: &str = include_str!("figure.css");

/// Height over width of the flattest picture of a table.
const FLATTEST: f64 = 0.2;

/// Width of a picture, px.
const WIDTH: f64 = 860.0;

/// A picture and what it does not show.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// The `svg` element.
    pub svg: String,
    /// What a reader must know beside the caption: points left out, labels that did not fit.
    pub remarks: Vec<String>,
}

/// A picture for a page that holds [`STYLE`]. `anchor`: a name that is unique in the page.
pub fn draw(figure: &Figure, anchor: &str) -> Drawing {
    if is_bare(figure) {
        return bare::draw(figure, anchor);
    }
    let frame = frame::Frame::of(figure);
    let (width, height) = (frame.width, frame.height);
    let words = |words: &str| lettering(words);
    let mut svg = format!(
        "<svg class=\"fig\" viewBox=\"0 0 {w} {h}\" width=\"{w}\" height=\"{h}\" \
         role=\"img\" aria-labelledby=\"{anchor}-title {anchor}-what\"><title id=\"{anchor}-title\">{title}</title>\
         <desc id=\"{anchor}-what\">{what}</desc>",
        w = px(width),
        h = px(height),
        anchor = words(anchor),
        title = words(&figure.title),
        what = words(&described(figure)),
    );
    svg += &frame.drawn(figure);
    svg += "</svg>";
    Drawing {
        svg,
        remarks: remarks(figure, &frame),
    }
}

/// True for a picture of places whose axes have no names: it has none then, since it is no map of one place.
pub fn is_bare(figure: &Figure) -> bool {
    figure.equal_scale && figure.x.label.is_empty() && figure.y.label.is_empty()
}

/// A picture that stands alone in a file.
pub fn standalone(figure: &Figure) -> String {
    let svg = draw(figure, "figure").svg;
    let svg = svg.replacen("<svg ", "<svg xmlns=\"http://www.w3.org/2000/svg\" ", 1);
    // opaque, or the text of a picture for the dark would be lost on a white page
    let style = format!(
        "<style>{STYLE}</style><rect width=\"100%\" height=\"100%\" fill=\"var(--paper)\"/>"
    );
    svg.replacen("</desc>", &format!("</desc>{style}"), 1) + "\n"
}

/// A picture for a row of a table: no axes, no words.
pub fn thumbnail(figure: &Figure) -> String {
    const WIDE: f64 = 116.0;
    const HIGH: f64 = 64.0;
    let plane = Plane::of(figure);
    let (width, height) = if figure.equal_scale {
        plane.fitted(WIDE, HIGH)
    } else {
        (WIDE, HIGH * 0.6)
    };
    let plane = plane.placed(2.0, 2.0, width - 4.0, height - 4.0);
    let mut svg = format!(
        "<svg class=\"fig thumb\" viewBox=\"0 0 {w} {h}\" width=\"{w}\" height=\"{h}\" \
         role=\"img\" aria-label=\"{title}\">",
        w = px(width),
        h = px(height),
        title = lettering(&figure.title),
    );
    svg += &frame::outline(figure, &plane, 0.0);
    svg += &series::drawn(figure, &plane, &series::Pen::THUMBNAIL);
    svg + "</svg>"
}

/// Names that have a colour, in order of appearance.
fn names(figure: &Figure) -> Vec<&str> {
    named(figure, |style| {
        matches!(style, Style::Line | Style::Points | Style::Discs(_))
    })
}

/// Names that have an entry in the legend, in order of appearance.
fn entries(figure: &Figure) -> Vec<&str> {
    named(figure, |style| {
        !matches!(style, Style::Guide | Style::Words)
    })
}

fn named(figure: &Figure, of: fn(&Style) -> bool) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for series in figure.series.iter().filter(|series| of(&series.style)) {
        if !series.name.is_empty() && !names.contains(&series.name.as_str()) {
            names.push(&series.name);
        }
    }
    names
}

/// What a screen reader says.
fn described(figure: &Figure) -> String {
    let axis = |axis: &crate::finding::Axis| {
        let unit = if axis.unit.is_empty() {
            String::new()
        } else {
            format!(" in {}", axis.unit)
        };
        format!(
            "{}{unit}{}",
            axis.label,
            if axis.log { ", logarithmic" } else { "" }
        )
    };
    let mut text = figure.caption.clone();
    if !is_bare(figure) {
        text += &format!(
            " Vertical: {}. Horizontal: {}.",
            axis(&figure.y),
            axis(&figure.x)
        );
    }
    let names = entries(figure);
    if !names.is_empty() {
        text += &format!(" Series: {}.", names.join(", "));
    }
    text
}

/// What the picture does not show.
fn remarks(figure: &Figure, frame: &frame::Frame) -> Vec<String> {
    let (log_x, log_y) = logarithmic(figure);
    let points = || figure.series.iter().flat_map(|series| &series.points);
    let not_numbers = points()
        .filter(|p| !(p[0].is_finite() && p[1].is_finite()))
        .count();
    let not_positive = points()
        .filter(|p| p[0].is_finite() && p[1].is_finite())
        .filter(|p| on_axis(p[0], log_x).is_none() || on_axis(p[1], log_y).is_none())
        .count();
    let mut remarks = Vec::new();
    if series::has_signs(figure) {
        remarks.push("Signs on the lines only tell them apart.".to_owned());
    }
    let are = |n: usize, what: &str| match n {
        1 => format!("1 point {what}"),
        n => format!("{n} points {what}"),
    };
    if not_positive > 0 {
        remarks.push(are(
            not_positive,
            "at or below zero cannot be on a logarithmic axis.",
        ));
    }
    if not_numbers > 0 {
        remarks.push(are(
            not_numbers,
            "with a value that is no number interrupt the lines.",
        ));
    }
    if frame.dropped_labels > 0 {
        let all = figure
            .marks
            .iter()
            .filter(|mark| !mark.label.is_empty())
            .count();
        let shown = all - frame.dropped_labels;
        remarks.push(format!(
            "{shown} of {all} marks have room for their label; all are in the data."
        ));
    }
    remarks
}

/// Which axes are logarithmic: in a picture of a table, none; of words, none.
fn logarithmic(figure: &Figure) -> (bool, bool) {
    let log =
        |axis: &crate::finding::Axis| axis.log && !figure.equal_scale && axis.names.is_empty();
    (log(&figure.x), log(&figure.y))
}

/// Both axes. A tall picture of a table lies on its side: y to the right, x downwards, which is a turn and no mirror image.
#[derive(Clone, Copy, Debug)]
struct Plane {
    x: Scale,
    y: Scale,
    on_its_side: bool,
    downwards: bool,
}

/// From where to where the points, outline and marks of a figure go, across and up.
fn drawn(figure: &Figure) -> (Extent, Extent) {
    let (log_x, log_y) = logarithmic(figure);
    let (mut x, mut y) = (Extent::NONE, Extent::NONE);
    for series in &figure.series {
        let reach = match series.style {
            Style::Discs(radius) if radius.is_finite() => radius.abs(),
            _ => 0.0,
        };
        for &[px, py] in &series.points {
            if let (Some(px), Some(py)) = (on_axis(px, log_x), on_axis(py, log_y)) {
                for side in [-reach, reach] {
                    x.add(if log_x { px } else { px + side });
                    y.add(if log_y { py } else { py + side });
                }
            }
        }
    }
    for [px, py] in figure.outline.into_iter().flatten() {
        x.add(on_axis(px, log_x).unwrap_or(f64::NAN));
        y.add(on_axis(py, log_y).unwrap_or(f64::NAN));
    }
    for mark in &figure.marks {
        if let Some(at) = on_axis(mark.at, log_x)
            && !x.is_empty()
            && figure.outline.is_none()
        {
            x.add(at);
        }
    }
    (x, y)
}

impl Plane {
    /// The ranges that a figure needs, not yet on any paper.
    fn of(figure: &Figure) -> Plane {
        let (log_x, log_y) = logarithmic(figure);
        let (mut x, mut y) = drawn(figure);
        let outlined = figure.outline.is_some();
        let line =
            |series: &Series| matches!(series.style, Style::Line | Style::Guide | Style::Band);
        let dots = !figure.series.iter().all(line);
        // an axis that starts near zero starts at zero, and ends a little above its largest value
        let from_zero = |extent: &mut Extent, log: bool, near: f64| {
            if !figure.equal_scale && !log && extent.lo > 0.0 && extent.lo < near * extent.hi {
                extent.add(0.0);
            }
        };
        from_zero(&mut x, log_x, 0.1);
        from_zero(&mut y, log_y, 0.4);
        let named = |extent: &mut Extent, names: &[String]| {
            if !names.is_empty() {
                extent.add(0.5);
                extent.add(names.len() as f64 + 0.5);
            }
        };
        named(&mut x, &figure.x.names);
        named(&mut y, &figure.y.names);
        let widened = |extent: Extent, share: f64, names: &[String]| {
            if outlined || !names.is_empty() {
                return extent.widened(0.0);
            }
            let wide = extent.widened(share);
            let lo = if extent.lo == 0.0 && extent.hi > 0.0 && !figure.equal_scale {
                0.0
            } else {
                wide.lo
            };
            Extent { lo, ..wide }
        };
        let mut x = widened(x, if dots { 0.03 } else { 0.0 }, &figure.x.names);
        let mut y = widened(y, 0.05, &figure.y.names);
        if figure.equal_scale {
            let least = FLATTEST * x.half().max(y.half());
            (x, y) = (x.at_least(least), y.at_least(least));
        }
        let scale = |range: Extent, log: bool| Scale {
            range,
            log,
            from: 0.0,
            to: 1.0,
        };
        Plane {
            on_its_side: figure.equal_scale && y.half() > 1.2 * x.half(),
            // a list is read from the top down
            downwards: !figure.equal_scale && !figure.y.names.is_empty(),
            x: scale(x, log_x),
            y: scale(y, log_y),
        }
    }

    /// Width and height within a box at which one unit is equally long on both axes, px.
    fn fitted(&self, wide: f64, high: f64) -> (f64, f64) {
        let (across, up) = if self.on_its_side {
            (self.y.range.half(), self.x.range.half())
        } else {
            (self.x.range.half(), self.y.range.half())
        };
        let shape = (up / across).clamp(1e-3, 1e3);
        let width = wide.min(high / shape);
        (width, width * shape)
    }

    /// On paper: upper left corner and size, px.
    fn placed(mut self, left: f64, top: f64, width: f64, height: f64) -> Plane {
        let (right, bottom) = (left + width, top + height);
        if self.on_its_side {
            (self.y.from, self.y.to) = (left, right);
            (self.x.from, self.x.to) = (top, bottom);
        } else {
            (self.x.from, self.x.to) = (left, right);
            (self.y.from, self.y.to) = if self.downwards {
                (top, bottom)
            } else {
                (bottom, top)
            };
        }
        self
    }

    /// Where a point is, px; `None` for one that cannot be shown.
    fn place(&self, [x, y]: [f64; 2]) -> Option<(f64, f64)> {
        let (x, y) = (self.x.place(x)?, self.y.place(y)?);
        Some(if self.on_its_side { (y, x) } else { (x, y) })
    }
}

/// A length or place with one decimal, which is finer than any screen.
fn px(x: f64) -> String {
    let tenths = (x.clamp(-1e6, 1e6) * 10.0).round();
    // -0 is 0
    format!("{}", tenths / 10.0 + 0.0)
}

/// Words of a picture: each character is one character, so that they take the room that was measured; a hidden one is a mark.
fn lettering(words: &str) -> String {
    escape(&words.replace(is_hidden, "\u{fffd}"))
}

/// Text that is safe within XML and HTML, between tags and within quotes.
pub fn escape(words: &str) -> String {
    let mut safe = String::with_capacity(words.len());
    for c in words.chars() {
        match c {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            '\'' => safe.push_str("&#39;"),
            '\n' | '\r' | '\t' => safe.push(' '),
            // not allowed in XML at all
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => safe.push('\u{fffd}'),
            c => safe.push(c),
        }
    }
    safe
}

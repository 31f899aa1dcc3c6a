//! Axes: which numbers or words stand along them, so that none covers another, and how they are drawn.

use super::scale::Scale;
use super::ticks::{self, Tick};
use super::words::{elided, text_width, wrapped};
use super::{Plane, entries, lettering, px};
use crate::finding::{Axis, Figure};

/// Size of numbers and words along an axis, px.
const SIZE: f64 = 13.0;
/// Size of the words at the heads of columns, px.
const HEAD: f64 = 11.0;
/// Height of a line of them, px.
const HEAD_LINE: f64 = 13.0;
/// The least height that a number on the upright axis needs, px.
const LINE: f64 = 17.0;
/// The least room between two numbers side by side, px.
const GAP: f64 = 9.0;
/// How far a number may reach beyond an end of the axis below, px.
const OVERHANG: f64 = 17.0;
/// Height of a line of the name of the upright axis, px.
const NAME_LINE: f64 = 16.0;
/// How much longer than the plot such a line may be, px: without a legend above it, and with one.
const LONGER: (f64, f64) = (14.0, 70.0);
/// Widest name beside the upright axis, px.
const WIDEST: f64 = 280.0;

/// The axis that runs up the paper and the one that runs across it, with what is written along them.
pub struct Axes {
    /// Width of what is written beside the upright axis, with its name, px.
    pub left: f64,
    /// Height of the words above the plot, px.
    pub above: f64,
    upright: Marked,
    level: Marked,
    heads: Vec<Head>,
    /// Lines of the name of the upright axis.
    name: Vec<String>,
}

/// What is written along one axis.
struct Marked {
    name: String,
    ticks: Vec<Tick>,
    words: bool,
}

/// Words above a column: lines from the top down, or one line that reads upwards.
struct Head {
    at: f64,
    lines: Vec<String>,
    upwards: bool,
}

impl Axes {
    /// The axes of a figure. `left_of`: given the width beside the upright axis, the plane on the paper; its lengths decide how many
    /// numbers have room.
    pub fn of(figure: &Figure, plane: &Plane, height: f64, width: impl Fn(f64) -> f64) -> Axes {
        let (upright, level) = match plane.on_its_side {
            true => (&figure.x, &figure.y),
            false => (&figure.y, &figure.x),
        };
        let (vertical, horizontal) = match plane.on_its_side {
            true => (plane.x, plane.y),
            false => (plane.y, plane.x),
        };
        let upright = Marked::of(upright, on_paper(vertical, height), |_| LINE, 45.0);
        let widest = upright
            .ticks
            .iter()
            .map(|tick| text_width(&tick.label, SIZE))
            .fold(0.0, f64::max);
        let longer = match entries(figure).is_empty() {
            true => LONGER.0,
            false => LONGER.1,
        };
        let name = lines_of(&upright.name, height + longer);
        let left = widest + 6.0 + NAME_LINE * name.len() as f64;
        let across = on_paper(horizontal, width(left));
        let level_axis = level;
        let mut level = Marked::of(
            level,
            across,
            |tick| text_width(&tick.label, SIZE) + GAP,
            90.0,
        );
        let heads = match level.words {
            true => heads(level_axis, across.length()),
            false => Vec::new(),
        };
        for tick in &mut level.ticks {
            let half = 0.5 * text_width(&tick.label, SIZE);
            let place = across.place(tick.at).unwrap_or(0.0);
            if place < half - OVERHANG || place + half > across.length() + OVERHANG {
                tick.label.clear();
            }
        }
        if level.words {
            level.ticks.clear();
        }
        let above = heads.iter().map(Head::height).fold(0.0, f64::max);
        Axes {
            left,
            above: if above > 0.0 { above + 8.0 } else { 0.0 },
            upright,
            level,
            heads,
            name,
        }
    }

    /// Both axes around a plot; `corners`: left, top, right, bottom of it, px; `rail`: width of the cushions around it, px.
    pub fn drawn(&self, figure: &Figure, plane: &Plane, corners: [f64; 4], rail: f64) -> String {
        let [left, top, right, bottom] = corners;
        let (vertical, horizontal) = match plane.on_its_side {
            true => (plane.x, plane.y),
            false => (plane.y, plane.x),
        };
        let grid = figure.outline.is_none() && self.heads.is_empty();
        let mut lines = String::new();
        let mut svg = String::new();
        for tick in &self.upright.ticks {
            let Some(y) = vertical.place(tick.at) else {
                continue;
            };
            let major = !tick.label.is_empty();
            if grid && major {
                lines += &format!("M{} {}H{}", px(left), px(y), px(right));
            } else if self.heads.is_empty() {
                let long = if major { 5 } else { 3 };
                lines += &format!("M{} {}h-{long}", px(left - rail), px(y));
            }
            if major {
                let x = left - rail - 8.0;
                svg += &text("s e", x, y + 4.5, &tick.label);
            }
        }
        svg += &path("g", &lines);
        let mut lines = String::new();
        if grid && self.heads.is_empty() {
            lines = format!("M{} {}H{}", px(left), px(bottom), px(right));
        }
        for tick in &self.level.ticks {
            let Some(x) = horizontal.place(tick.at) else {
                continue;
            };
            let major = !tick.label.is_empty();
            let long = if major { 5 } else { 3 };
            lines += &format!("M{} {}v{long}", px(x), px(bottom + rail));
            if major {
                svg += &text("s a", x, bottom + rail + 18.0, &tick.label);
            }
        }
        svg += &path("x", &lines);
        for head in &self.heads {
            if let Some(x) = horizontal.place(head.at) {
                svg += &head.drawn(x, top - 6.0);
            }
        }
        let level_name = if self.heads.is_empty() { 38.0 } else { 20.0 };
        let x = 0.5 * (left + right);
        svg += &text("a", x, bottom + rail + level_name, &self.level.name);
        for (k, line) in self.name.iter().enumerate() {
            svg += &format!(
                "<text class=\"a\" transform=\"translate({} {}) rotate(-90)\">{}</text>",
                px(16.0 + k as f64 * NAME_LINE),
                px(0.5 * (top + bottom)),
                lettering(line)
            );
        }
        svg
    }
}

impl Marked {
    /// As many numbers as have room, one in about `apart` px at most; `size`: how long a label is along the axis, px.
    fn of(axis: &Axis, scale: Scale, size: impl Fn(&Tick) -> f64, apart: f64) -> Marked {
        if !axis.names.is_empty() {
            return Marked {
                name: axis_name(axis, 0.0),
                ticks: named(axis),
                words: true,
            };
        }
        let offset = ticks::offset(scale.range);
        let offset = if scale.log { 0.0 } else { offset };
        let most = (scale.length() / apart).clamp(1.0, 9.0) as usize;
        let candidates = (1..=most).rev().map(|wanted| match scale.log {
            true => ticks::logarithmic(scale.range, wanted.max(2)),
            false => ticks::linear_from(offset, scale.range, wanted),
        });
        let mut last = Vec::new();
        for ticks in candidates {
            if apart_enough(&ticks, &scale, &size) {
                return Marked {
                    name: axis_name(axis, offset),
                    ticks,
                    words: false,
                };
            }
            last = ticks;
        }
        Marked {
            name: axis_name(axis, offset),
            ticks: thinned(last, &scale, &size),
            words: false,
        }
    }
}

/// A name in lines of at most this length, px.
fn lines_of(name: &str, room: f64) -> Vec<String> {
    match name {
        "" => Vec::new(),
        name => wrapped(name, SIZE, room).unwrap_or_else(|| vec![elided(name, SIZE, room)]),
    }
}

/// True where no label covers the one before it.
fn apart_enough(ticks: &[Tick], scale: &Scale, size: &impl Fn(&Tick) -> f64) -> bool {
    let labelled = ticks.iter().filter(|tick| !tick.label.is_empty());
    let places: Vec<(f64, f64)> = labelled
        .filter_map(|tick| Some((scale.place(tick.at)?, size(tick))))
        .collect();
    places
        .windows(2)
        .all(|pair| (pair[1].0 - pair[0].0).abs() >= 0.5 * (pair[0].1 + pair[1].1))
}

/// The same ticks without the labels that would cover the one before.
fn thinned(mut ticks: Vec<Tick>, scale: &Scale, size: &impl Fn(&Tick) -> f64) -> Vec<Tick> {
    let mut before: Option<(f64, f64)> = None;
    for tick in &mut ticks {
        let Some(place) = scale.place(tick.at).filter(|_| !tick.label.is_empty()) else {
            continue;
        };
        let own = size(tick);
        if before.is_some_and(|(at, its)| (place - at).abs() < 0.5 * (own + its)) {
            tick.label.clear();
        } else {
            before = Some((place, own));
        }
    }
    ticks
}

/// The words of an axis as ticks.
fn named(axis: &Axis) -> Vec<Tick> {
    let tick = |(k, name): (usize, &String)| Tick {
        at: k as f64 + 1.0,
        label: elided(name, SIZE, WIDEST),
    };
    axis.names.iter().enumerate().map(tick).collect()
}

/// Words above columns on an axis of this length, px: broken into lines where they fit so, else all of them upwards.
fn heads(axis: &Axis, length: f64) -> Vec<Head> {
    let room = length / axis.names.len().max(1) as f64 - 6.0;
    let names = axis.names.iter();
    let lines: Option<Vec<Vec<String>>> = names.map(|name| wrapped(name, HEAD, room)).collect();
    let upwards = lines.is_none();
    let lines = lines.unwrap_or_else(|| {
        let names = axis.names.iter();
        names.map(|name| vec![elided(name, HEAD, 180.0)]).collect()
    });
    let head = |(k, lines)| Head {
        at: k as f64 + 1.0,
        lines,
        upwards,
    };
    lines.into_iter().enumerate().map(head).collect()
}

impl Head {
    fn height(&self) -> f64 {
        match self.upwards {
            true => self.lines.iter().map(|line| text_width(line, HEAD)).sum(),
            false => self.lines.len() as f64 * HEAD_LINE,
        }
    }

    /// Above `bottom`, over the middle of the column at `x`, px.
    fn drawn(&self, x: f64, bottom: f64) -> String {
        if self.upwards {
            let words = self.lines.concat();
            return format!(
                "<text class=\"n\" transform=\"translate({} {}) rotate(-90)\">{}</text>",
                px(x + 4.0),
                px(bottom),
                lettering(&words)
            );
        }
        let count = self.lines.len();
        let line = |(k, words): (usize, &String)| {
            let y = bottom - (count - 1 - k) as f64 * HEAD_LINE;
            text("n a", x, y, words)
        };
        self.lines.iter().enumerate().map(line).collect()
    }
}

/// A scale as it will be on the paper: `length` px long.
fn on_paper(scale: Scale, length: f64) -> Scale {
    Scale {
        from: 0.0,
        to: length,
        ..scale
    }
}

fn text(class: &str, x: f64, y: f64, words: &str) -> String {
    if words.is_empty() {
        return String::new();
    }
    format!(
        "<text class=\"{class}\" x=\"{}\" y=\"{}\">{}</text>",
        px(x),
        px(y),
        lettering(words)
    )
}

fn path(class: &str, d: &str) -> String {
    match d {
        "" => String::new(),
        d => format!("<path class=\"{class}\" d=\"{d}\"/>"),
    }
}

/// The name of an axis with its unit; `offset`: what is to be added to the numbers along it.
fn axis_name(axis: &Axis, offset: f64) -> String {
    let label = match offset {
        0.0 => axis.label.clone(),
        below if below < 0.0 => format!("{} + {:e}", axis.label, -below),
        above => format!("{} − {above:e}", axis.label),
    };
    let unit = &axis.unit;
    match () {
        () if unit.is_empty() => label,
        () if label.is_empty() => unit.clone(),
        // brackets in brackets are hard to read
        () if unit.contains('(') => format!("{label}, {unit}"),
        () => format!("{label} ({unit})"),
    }
}

//! Curves, points and balls.

use super::simplify::{self, PaperPoint};
use super::{Plane, lettering, names, px};
use crate::finding::{Figure, Series, Style};

/// Names that have a colour of their own: as many as the style sheet has.
const DISTINCT: usize = 7;

/// Dashes of the first, second, ... name: each can be told apart without colour.
const DASHES: [&str; 6] = ["", "9 4", "2.5 3", "10 3 2.5 3", "16 5", "5 2 1.5 2 1.5 2"];

/// More points than this are drawn finer, all of a figure alike.
const MOST_MARKERS: usize = 600;

/// How fine a picture is drawn.
pub struct Pen {
    /// How far a simplified line may be from the true one, px.
    tolerance: f64,
    /// Factor on all widths.
    weight: f64,
    /// Radius of a point, px.
    point: f64,
    /// Whether lines carry markers.
    markers: bool,
}

impl Pen {
    /// For a picture of its own.
    pub const FULL: Pen = Pen {
        tolerance: 0.2,
        weight: 1.0,
        point: 3.6,
        markers: true,
    };
    /// For a row of a table.
    pub const THUMBNAIL: Pen = Pen {
        tolerance: 0.5,
        weight: 0.55,
        point: 1.4,
        markers: false,
    };
}

/// How one name is drawn.
pub struct Look {
    /// Place among the names; `None` for a series without a name.
    pub index: Option<usize>,
    /// Whether its lines carry markers.
    pub marked: bool,
    width: f64,
}

impl Look {
    /// The look of the name with this index.
    pub fn of(figure: &Figure, index: Option<usize>) -> Look {
        let names = names(figure).len();
        let lines = figure
            .series
            .iter()
            .filter(|series| series.style == Style::Line)
            .count();
        // the first is the widest and below the others, so that all are seen where they agree
        let below = names.saturating_sub(1 + index.unwrap_or(0)).min(4) as f64;
        let (finest, more) = if lines > 12 { (1.1, 0.5) } else { (1.5, 0.6) };
        Look {
            index,
            marked: lines <= 12 && names > 1 && marks_lines(figure),
            width: if index.is_some() {
                finest + more * below
            } else {
                0.9
            },
        }
    }

    /// Class of the group.
    pub fn class(&self) -> String {
        match self.index {
            Some(index) => format!("k{}", index % DISTINCT),
            None => "q".to_owned(),
        }
    }

    /// Attributes of a line.
    pub fn line(&self) -> String {
        self.stroke(DASHES[self.index.unwrap_or(0) % DASHES.len()], 1.0)
    }

    fn stroke(&self, dashes: &str, weight: f64) -> String {
        let width = format!(" stroke-width=\"{}\"", px(self.width * weight));
        if dashes.is_empty() {
            width
        } else {
            format!("{width} stroke-dasharray=\"{dashes}\"")
        }
    }

    fn weighed(&self, weight: f64) -> String {
        // dashes are lost in a small picture
        match weight < 1.0 {
            true => self.stroke("", weight),
            false => self.line(),
        }
    }
}

/// Whether lines may carry markers: not on a table, and not where a marker is a point that was measured.
fn marks_lines(figure: &Figure) -> bool {
    let mut series = figure.series.iter();
    !figure.equal_scale && series.all(|series| series.style != Style::Points)
}

/// Whether any line of a figure carries markers.
pub fn has_signs(figure: &Figure) -> bool {
    let lines = figure.series.iter().any(|s| s.style == Style::Line);
    lines && Look::of(figure, Some(0)).marked
}

/// The shape of a point; all are open, so that one upon another hides nothing.
#[derive(Clone, Copy)]
pub enum Marker {
    Circle,
    Square,
    Triangle,
    Diamond,
    Cross,
    Plus,
    Hanging,
    Star,
    Target,
    Window,
}

impl Marker {
    /// The shape of the name with this index.
    pub fn of(index: Option<usize>) -> Marker {
        const SHAPES: [Marker; 10] = [
            Marker::Circle,
            Marker::Square,
            Marker::Triangle,
            Marker::Diamond,
            Marker::Cross,
            Marker::Plus,
            Marker::Hanging,
            Marker::Star,
            Marker::Target,
            Marker::Window,
        ];
        SHAPES[index.unwrap_or(0) % SHAPES.len()]
    }

    /// The shape around a place; `r`: its radius, px.
    pub fn at(self, (x, y): PaperPoint, r: f64) -> String {
        let square = || {
            format!(
                "M{} {}h{d}v{d}h-{d}z",
                px(x - r),
                px(y - r),
                d = px(2.0 * r)
            )
        };
        // `up`: 1 with its point up, -1 with its point down
        let triangle = |up: f64| {
            format!(
                "M{} {}L{} {}H{}z",
                px(x),
                px(y - 1.2 * up * r),
                px(x + 1.1 * r),
                px(y + 0.9 * up * r),
                px(x - 1.1 * r)
            )
        };
        let plus = |r: f64| {
            let (from, d) = (px(x - r), px(2.0 * r));
            format!("M{from} {}h{d}M{} {}v{d}", px(y), px(x), px(y - r))
        };
        let circle = |r: f64| {
            format!(
                "<circle class=\"m\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>",
                px(x),
                px(y),
                px(r)
            )
        };
        let d = match self {
            Marker::Circle => return circle(r),
            Marker::Target => return circle(1.2 * r) + &circle(0.3 * r),
            Marker::Square => square(),
            Marker::Triangle => triangle(1.0),
            Marker::Hanging => triangle(-1.0),
            Marker::Diamond => format!(
                "M{} {}L{} {}L{} {}L{} {}z",
                px(x),
                px(y - 1.3 * r),
                px(x + 1.3 * r),
                px(y),
                px(x),
                px(y + 1.3 * r),
                px(x - 1.3 * r),
                px(y)
            ),
            Marker::Cross => crossed((x, y), r),
            Marker::Plus => plus(1.3 * r),
            Marker::Star => crossed((x, y), r) + &plus(1.3 * r),
            Marker::Window => square() + &plus(r),
        };
        format!("<path class=\"m\" d=\"{d}\"/>")
    }
}

/// Two strokes across each other.
fn crossed((x, y): PaperPoint, r: f64) -> String {
    format!(
        "M{} {}l{d} {d}m0 -{d}l-{d} {d}",
        px(x - r),
        px(y - r),
        d = px(2.0 * r)
    )
}

/// True when at least one point can be shown.
pub fn any_place(figure: &Figure, plane: &Plane) -> bool {
    let mut points = figure.series.iter().flat_map(|series| &series.points);
    points.any(|&point| plane.place(point).is_some())
}

/// Every series of a figure, in order.
pub fn drawn(figure: &Figure, plane: &Plane, pen: &Pen) -> String {
    let names = names(figure);
    let crowded = pen.point < 2.0 || is_crowded(figure);
    let mut svg = String::new();
    for (number, series) in figure.series.iter().enumerate() {
        let index = names.iter().position(|name| *name == series.name);
        let look = Look::of(figure, index);
        let content = match series.style {
            Style::Line => {
                let stroke = look.weighed(pen.weight);
                let mut content = line(series, plane, pen, &stroke);
                if look.marked && pen.markers {
                    let shift = (number % 5) as f64 / 5.0;
                    content += &markers(series, plane, Marker::of(index), shift);
                }
                content
            }
            Style::Points if crowded => dots(series, plane, pen, index),
            Style::Points => points(series, plane, pen, Marker::of(index)),
            Style::Rings => warnings(series, plane, pen, warning_ring),
            Style::Crosses => warnings(series, plane, pen, cross),
            Style::Discs(radius) => discs(series, plane, radius),
            Style::Words => words(series, plane),
            // these lie below all others
            Style::Guide | Style::Band | Style::Tiles(_) => String::new(),
        };
        let class = match series.style {
            Style::Rings | Style::Crosses => "w".to_owned(),
            _ => look.class(),
        };
        if !content.is_empty() {
            svg += &format!("<g class=\"{class}\">{content}</g>");
        }
    }
    svg
}

/// Whether a figure has more points than can have shapes.
pub fn is_crowded(figure: &Figure) -> bool {
    let of_points = figure.series.iter().filter(|s| s.style == Style::Points);
    of_points.map(|s| s.points.len()).sum::<usize>() > MOST_MARKERS
}

/// Stretches of points that can be shown, without those that cannot.
pub fn places_in_order(series: &Series, plane: &Plane) -> Vec<Vec<PaperPoint>> {
    let mut runs = vec![Vec::new()];
    for &point in &series.points {
        match (plane.place(point), runs.last_mut()) {
            (Some(place), Some(run)) => run.push(place),
            _ => runs.push(Vec::new()),
        }
    }
    runs.retain(|run| !run.is_empty());
    runs
}

fn line(series: &Series, plane: &Plane, pen: &Pen, stroke: &str) -> String {
    let mut d = String::new();
    let mut dots = String::new();
    for run in places_in_order(series, plane) {
        let places = simplify::line(&run, pen.tolerance);
        if let [(x, y)] = places[..] {
            dots += &format!(
                "<circle class=\"d\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>",
                px(x),
                px(y),
                px(0.5 * pen.point)
            );
            continue;
        }
        let mut last = String::new();
        for (i, (x, y)) in places.into_iter().enumerate() {
            let place = format!("{} {}", px(x), px(y));
            if place != last {
                d.push(if i == 0 { 'M' } else { 'L' });
                d += &place;
                last = place;
            }
        }
    }
    if d.is_empty() {
        return dots;
    }
    format!("<path class=\"l\" d=\"{d}\"{stroke}/>{dots}")
}

/// Markers on a line, the same way apart along the horizontal axis whatever its points are; `shift` keeps those of different lines apart.
fn markers(series: &Series, plane: &Plane, marker: Marker, shift: f64) -> String {
    const APART: f64 = 110.0;
    const MOST: usize = 12;
    let mut svg = String::new();
    let mut drawn = 0;
    for run in places_in_order(series, plane) {
        let mut next = APART * (0.3 + 0.6 * shift);
        let mut travelled = 0.0;
        for pair in run.windows(2) {
            let ((x0, y0), (x1, y1)) = (pair[0], pair[1]);
            // along the axis: a jump has one marker at most
            let step = (x1 - x0).abs();
            while travelled + step >= next && step > 0.0 && drawn < MOST {
                drawn += 1;
                let share = (next - travelled) / step;
                svg += &marker.at((x0 + share * (x1 - x0), y0 + share * (y1 - y0)), 3.6);
                next += APART;
            }
            travelled += step;
        }
    }
    svg
}

fn points(series: &Series, plane: &Plane, pen: &Pen, marker: Marker) -> String {
    let places = places(series, plane).into_iter();
    places.map(|place| marker.at(place, pen.point)).collect()
}

/// Points of a crowd.
fn dots(series: &Series, plane: &Plane, pen: &Pen, index: Option<usize>) -> String {
    let places = places(series, plane).into_iter();
    places.map(|place| dot(place, index, pen.point)).collect()
}

/// A point of a crowd: a ring for the first name, which is seen upon the dots of the others; `r`: its largest radius, px.
pub fn dot((x, y): PaperPoint, index: Option<usize>, r: f64) -> String {
    let (class, r) = match index {
        Some(0) => ("m", r.min(2.4)),
        _ => ("d", r.min(1.6)),
    };
    format!(
        "<circle class=\"{class}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>",
        px(x),
        px(y),
        px(r)
    )
}

fn warnings(
    series: &Series,
    plane: &Plane,
    pen: &Pen,
    shape: fn(PaperPoint, f64) -> String,
) -> String {
    let shapes = places(series, plane)
        .into_iter()
        .map(|place| shape(place, 1.9 * pen.point));
    shapes.collect()
}

/// A ring of radius `r`, px.
pub fn ring((x, y): PaperPoint, r: f64) -> String {
    format!(
        "<circle class=\"o\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>",
        px(x),
        px(y),
        px(r)
    )
}

/// The name of the series, its middle at each point.
fn words(series: &Series, plane: &Plane) -> String {
    let written = places(series, plane).into_iter().map(|(x, y)| {
        format!(
            "<text class=\"a h\" x=\"{}\" y=\"{}\">{}</text>",
            px(x),
            px(y + 4.5),
            lettering(&series.name)
        )
    });
    written.collect()
}

/// A ring around a point, with nothing in it.
pub fn warning_ring((x, y): PaperPoint, r: f64) -> String {
    format!(
        "<circle class=\"z\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>",
        px(x),
        px(y),
        px(r)
    )
}

/// A large cross.
pub fn cross(place: PaperPoint, r: f64) -> String {
    format!("<path class=\"z\" d=\"{}\"/>", crossed(place, r))
}

fn discs(series: &Series, plane: &Plane, radius: f64) -> String {
    let unit = plane.x.length() / (2.0 * plane.x.range.half());
    let r = (radius.abs() * unit).clamp(0.5, 1e4);
    places(series, plane)
        .into_iter()
        .map(|place| ring(place, r))
        .collect()
}

/// Places of points, each once: those that fall on the same tenth of a pixel are one.
fn places(series: &Series, plane: &Plane) -> Vec<PaperPoint> {
    let mut seen = std::collections::BTreeSet::new();
    let shown = series.points.iter().filter_map(|&point| plane.place(point));
    shown
        .filter(|(x, y)| seen.insert(((x * 10.0).round() as i64, (y * 10.0).round() as i64)))
        .collect()
}

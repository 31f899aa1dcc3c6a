//! Fields of a matrix: a shade and a sign, which can be read without colour.

use super::scale::Scale;
use super::simplify::PaperPoint;
use super::{Plane, px};
use crate::finding::{Figure, Sign, Style};

/// Every field of a figure.
pub fn drawn(figure: &Figure, plane: &Plane) -> String {
    // one unit, without the line between two fields
    let one = |scale: &Scale| (scale.length() / (2.0 * scale.range.half()) - 1.0).clamp(1.0, 1e3);
    let size = (one(&plane.x), one(&plane.y));
    let mut svg = String::new();
    for series in &figure.series {
        if let Style::Tiles(sign) = series.style {
            let shown = series.points.iter().filter_map(|&point| plane.place(point));
            svg += &fields(&shown.collect::<Vec<_>>(), size, sign);
        }
    }
    svg
}

/// Fields of this width and height around places, px.
pub fn fields(places: &[PaperPoint], (wide, high): (f64, f64), sign: Sign) -> String {
    if places.is_empty() {
        return String::new();
    }
    let r = 0.27 * wide.min(high);
    let (mut grounds, mut signs) = (String::new(), String::new());
    for &(x, y) in places {
        grounds += &format!(
            "M{} {}h{w}v{}h-{w}z",
            px(x - 0.5 * wide),
            px(y - 0.5 * high),
            px(high),
            w = px(wide)
        );
        signs += &match sign {
            Sign::Dot => round(x, y, 0.4 * r),
            Sign::Ring => round(x, y, r),
            Sign::Dash => format!("M{} {}h{}", px(x - r), px(y), px(2.0 * r)),
            Sign::Triangle => format!(
                "M{} {}L{} {}H{}z",
                px(x),
                px(y - 1.1 * r),
                px(x + 1.2 * r),
                px(y + 0.9 * r),
                px(x - 1.2 * r)
            ),
            Sign::Cross => format!(
                "M{} {}l{d} {d}m0 -{d}l-{d} {d}",
                px(x - r),
                px(y - r),
                d = px(2.0 * r)
            ),
        };
    }
    format!(
        "<g class=\"{}\"><path class=\"u\" d=\"{grounds}\"/><path class=\"i\" d=\"{signs}\"/></g>",
        class(sign)
    )
}

/// A circle as a path.
fn round(x: f64, y: f64, r: f64) -> String {
    let (across, back) = (px(2.0 * r), px(-2.0 * r));
    let arc = format!("a{r} {r} 0 1 0 ", r = px(r));
    format!("M{} {}{arc}{across} 0{arc}{back} 0", px(x - r), px(y))
}

/// Class of fields with this sign.
fn class(sign: Sign) -> &'static str {
    match sign {
        Sign::Dot => "t0",
        Sign::Triangle => "t1",
        Sign::Cross => "t2",
        Sign::Ring => "t3",
        Sign::Dash => "t4",
    }
}

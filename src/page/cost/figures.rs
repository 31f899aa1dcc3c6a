//! Work against precision: what each error costs.

use crate::finding::{Axis, Figure, Series, Style};
use crate::page::logarithm::{beyond, mark, zero_among};
use crate::study::cost::{CostOutcome, GAINS, Measured, Point, Quantity, front, noise, offers};

/// Where an error of zero is drawn where no error is larger, in the unit of the quantity.
const ZERO: f64 = f64::EPSILON;

/// Families of an engine in the main pictures; further ones vary one parameter of these, and have a picture of their own.
const MAIN: usize = 2;

/// Orders of convergence whose slopes are drawn.
const ORDERS: [f64; 2] = [1.0, 2.0];

/// How far above the points the slopes are drawn: a factor on the time.
const CLEAR: f64 = 2.0;

/// Part of the decades between the best and the worst error that the slopes span.
const SPAN: f64 = 0.65;

/// A figure a quantity, with the time of a shot; one with the time of a simulated second; one of the families that vary a parameter.
pub fn all(outcome: &CostOutcome) -> Vec<Figure> {
    let groups = Groups::of(outcome);
    let shot = |quantity| figure(Some(outcome), &groups.main, quantity, "time per shot", 1.0);
    let mut figures: Vec<Figure> = Quantity::ALL.into_iter().filter_map(shot).collect();
    let position = Quantity::FinalPosition;
    // far from the front, which would leave them no room
    let variants = figure(None, &groups.variants, position, "time per shot", 1.0);
    figures.extend(variants.map(|figure| Figure {
        id: "cost-variants".to_owned(),
        title: format!("{}: families that vary one parameter", figure.title),
        ..figure
    }));
    let per_second = figure(
        Some(outcome),
        &groups.main,
        position,
        "time per simulated second",
        1.0 / outcome.simulated,
    );
    figures.extend(per_second.map(|figure| Figure {
        id: "cost-per-second".to_owned(),
        title: format!("{}, per simulated second", figure.title),
        ..figure
    }));
    figures
}

/// The figure that says most: final positions.
pub fn main(outcome: &CostOutcome) -> Option<Figure> {
    let main = Groups::of(outcome).main;
    figure(
        Some(outcome),
        &main,
        Quantity::FinalPosition,
        "time per shot",
        1.0,
    )
}

/// Which families are drawn together.
struct Groups<'a> {
    main: Vec<&'a Measured>,
    variants: Vec<&'a Measured>,
}

impl<'a> Groups<'a> {
    fn of(outcome: &'a CostOutcome) -> Self {
        let mut groups = Groups {
            main: Vec::new(),
            variants: Vec::new(),
        };
        for measured in &outcome.families {
            let engine = |m: &&&Measured| {
                m.family.given.engine.id() == measured.family.given.engine.id()
                    && m.family.given.setting == measured.family.given.setting
            };
            if groups.main.iter().filter(engine).count() < MAIN {
                groups.main.push(measured);
            } else {
                groups.variants.push(measured);
            }
        }
        groups
    }
}

/// Where points of one quantity are drawn.
struct Places {
    quantity: Quantity,
    /// Where an error of zero stands.
    zero: f64,
    /// Where a point without an answer stands.
    none: f64,
    /// What a time is multiplied by.
    factor: f64,
    /// Whether the axis of errors is logarithmic: a share has zeros that count.
    log: bool,
}

impl Places {
    fn of(families: &[&Measured], quantity: Quantity, factor: f64) -> Self {
        let points = || families.iter().flat_map(|measured| &measured.points);
        let errors = || points().filter_map(|point| point.error(quantity));
        let log = quantity != Quantity::Order;
        Places {
            quantity,
            zero: if log { zero_among(errors(), ZERO) } else { 0.0 },
            none: if log { beyond(errors(), 1.0) } else { 1.15 },
            factor,
            log,
        }
    }

    fn place(&self, point: &Point) -> Option<[f64; 2]> {
        let error = point
            .error(self.quantity)
            .filter(|error| error.is_finite())?;
        Some(self.at(error, point.seconds()?))
    }

    fn at(&self, error: f64, seconds: f64) -> [f64; 2] {
        let error = if error > 0.0 { error } else { self.zero };
        [error, seconds * self.factor]
    }
}

/// `front_of`: the study whose front is drawn.
fn figure(
    front_of: Option<&CostOutcome>,
    families: &[&Measured],
    quantity: Quantity,
    time: &str,
    factor: f64,
) -> Option<Figure> {
    let places = Places::of(families, quantity, factor);
    let mut series = lines(families, &places);
    if series.is_empty() {
        return None;
    }
    series.extend(slopes(families, &places));
    series.extend(front_of.and_then(|outcome| edge(outcome, &places)));
    series.extend(remarkable(families, &places));
    let mut points = families.iter().flat_map(|measured| &measured.points);
    let zeros = points.any(|point| point.error(quantity) == Some(0.0));
    let unanswered = series.iter().any(|s| s.style == Style::Crosses);
    let mut marks = Vec::new();
    if zeros && places.log {
        marks.push(mark(places.zero, "error 0"));
    }
    if unanswered {
        marks.push(mark(places.none, "no answer"));
    }
    let label = format!("error of the {}", quantity.name());
    Some(Figure {
        id: format!("cost-{}", quantity.id()),
        title: format!("What an error of the {} costs", quantity.name()),
        caption: format!(
            "Left and down is better. Error: {}, mean over the starts. Time: the shortest of several runs, alone. {}A point without an \
             answer, or with one that is infinitely wrong, stands at the right edge.",
            quantity.what(),
            if places.log {
                "Thin lines: how a method of order 1 or 2 would fall. "
            } else {
                ""
            }
        ),
        x: match places.log {
            true => Axis::log(&label, quantity.unit()),
            false => Axis::linear(&label, "share"),
        },
        y: Axis::log(time, "s"),
        equal_scale: false,
        outline: None,
        series,
        marks,
    })
}

/// Each family's points, joined.
fn lines(families: &[&Measured], places: &Places) -> Vec<Series> {
    let mut series = Vec::new();
    for measured in families {
        let points: Vec<[f64; 2]> = measured
            .points
            .iter()
            .filter_map(|point| places.place(point))
            .collect();
        if points.is_empty() {
            continue;
        }
        for style in [Style::Line, Style::Points] {
            series.push(Series {
                name: measured.family.label(),
                points: points.clone(),
                style,
            });
        }
    }
    series
}

/// Points that gain energy, and those without an answer.
fn remarkable(families: &[&Measured], places: &Places) -> Vec<Series> {
    let points = || families.iter().flat_map(|measured| &measured.points);
    let gains = |point: &&Point| point.gained().is_some_and(|gained| gained > GAINS);
    let failed = points()
        .filter(|point| !point.errors.is_empty() && places.place(point).is_none())
        .filter_map(|point| Some([places.none, point.seconds()? * places.factor]));
    let gaining = points()
        .filter(gains)
        .filter_map(|point| places.place(point));
    let found = [
        ("gains energy", gaining.collect::<Vec<_>>(), Style::Rings),
        ("no answer", failed.collect(), Style::Crosses),
    ];
    let found = found
        .into_iter()
        .filter(|(_, points, _)| !points.is_empty());
    let series = found.map(|(name, points, style)| Series {
        name: name.to_owned(),
        points,
        style,
    });
    series.collect()
}

/// The edge of what can be had: for each error, the shortest time of any setting of the whole study that is as good.
fn edge(outcome: &CostOutcome, places: &Places) -> Option<Series> {
    let offers = offers(outcome, places.quantity);
    let most = offers.iter().map(|offer| offer.error).fold(0.0, f64::max);
    let mut points: Vec<[f64; 2]> = Vec::new();
    for offer in front(&offers, noise(outcome)) {
        let [error, time] = places.at(offer.error, offer.seconds);
        let before = points.last().map_or(most.max(places.zero), |last| last[0]);
        points.extend([[before, time], [error, time]]);
    }
    (!points.is_empty()).then(|| Series {
        name: "front: none better for less".to_owned(),
        points,
        style: Style::Band,
    })
}

/// How errors of methods of some orders fall with time, from the best point of any family whose settings are steps.
fn slopes(families: &[&Measured], places: &Places) -> Vec<Series> {
    if !places.log {
        return Vec::new();
    }
    let stepped = families.iter().filter(|measured| {
        let levels = measured.points.iter();
        levels.clone().filter(|p| p.level.size.is_some()).count() > 1
    });
    let mut points = stepped
        .flat_map(|measured| &measured.points)
        .filter(|point| {
            point
                .error(places.quantity)
                .is_some_and(|error| error > 0.0)
        })
        .filter_map(|point| places.place(point))
        .collect::<Vec<_>>();
    points.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let (Some(best), Some(worst)) = (points.first(), points.last()) else {
        return Vec::new();
    };
    if worst[0] < 10.0 * best[0] {
        return Vec::new();
    }
    let slope = |order: f64| {
        let fall = (worst[0] / best[0]).powf(SPAN);
        let from = [best[0], CLEAR * best[1]];
        Series {
            name: format!("order {order}"),
            points: vec![from, [from[0] * fall, from[1] * fall.powf(-1.0 / order)]],
            style: Style::Guide,
        }
    };
    ORDERS.into_iter().map(slope).collect()
}

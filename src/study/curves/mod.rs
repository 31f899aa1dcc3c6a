//! Curves of the impact laws: throw, squirt and rebound, against published formulas, an independent program and a paper.
//!
//! Plan: many small shots, each at one point of a curve, in every engine. Conclusion: the curves with the engines' points on them, and
//! by how much each engine departs.

mod rebound;
mod shots_2014;
mod squirt;
mod throw;

use super::Extent;
use super::matrix::{self, Configuration, Timing, Watch};
use crate::finding::{Figure, Series, Style, Table};
use crate::scene::{Scene, SceneError};
use crate::trace::{Record, Trace};

/// Distance at which balls are put before an impact, m: what the cloth does on the way does not show in the digits of a curve.
const GAP: f64 = 1e-9;

/// Unit of angles.
const DEGREES: &str = "degrees";

/// One curve family: its picture and how far the engines are from it.
#[derive(Debug, Default)]
pub struct Curve {
    /// Its pictures.
    pub figures: Vec<Figure>,
    /// How far each engine is from it.
    pub departures: Vec<Departure>,
}

/// What finds a family of curves.
type Part = fn(&Lab<'_>) -> Result<Curve, SceneError>;

/// How far something is from a curve.
#[derive(Debug)]
pub struct Departure {
    /// Whose points.
    pub who: String,
    /// What they are held against.
    pub from: &'static str,
    /// Number of points.
    pub points: usize,
    /// The largest departure; `None` where there is no point.
    pub largest: Option<f64>,
    /// Its unit.
    pub unit: &'static str,
    /// Why points are missing, with their number.
    pub missing: Vec<(String, usize)>,
}

/// What was found of the impact laws.
#[derive(Debug)]
pub struct CurvesOutcome {
    /// Each family of curves, with its name.
    pub curves: Vec<(&'static str, Curve)>,
    /// The shots of a paper; `None` where the user asked to stop before.
    pub shots: Option<Table>,
    /// The engines.
    pub columns: Vec<Configuration>,
    /// Families that were run in every engine.
    pub extent: Extent,
}

/// Runs every point of every curve in the engines. Errors: a scene of the catalogue that is no scene.
pub fn study(columns: &[Configuration], watch: Watch<'_>) -> Result<CurvesOutcome, SceneError> {
    let mut found = Vec::new();
    let parts: [(&str, Part); 3] = [
        ("throw", throw::curve),
        ("squirt", squirt::curve),
        ("rebound", rebound::curve),
    ];
    let lab = Lab { columns, watch };
    let mut extent = Extent::default();
    for (done, (name, part)) in parts.into_iter().enumerate() {
        (watch.progress)(done, parts.len() + 1, name);
        // a curve that lacks points says nothing about how far an engine is from it
        let curve = watch.whole(|| part(&lab));
        extent.count(curve.is_some());
        if let Some(curve) = curve {
            found.push((name, curve?));
        }
    }
    (watch.progress)(parts.len(), parts.len() + 1, "five shots of a paper");
    let shots = watch.whole(|| shots_2014::table(&lab));
    extent.count(shots.is_some());
    Ok(CurvesOutcome {
        curves: found,
        shots: shots.transpose()?,
        columns: columns.to_vec(),
        extent,
    })
}

/// Where points are run.
struct Lab<'a> {
    columns: &'a [Configuration],
    watch: Watch<'a>,
}

impl Lab<'_> {
    /// One shot in every engine: its trace, or why there is none.
    fn run(&self, scene: &Scene) -> Vec<Result<Trace, String>> {
        let silent = Watch {
            progress: &|_, _, _| {},
            cancelled: self.watch.cancelled,
        };
        let cells = matrix::run_row(scene, self.columns, Record::Events, Timing::None, silent);
        let answer = |cell: matrix::Cell| match cell {
            Ok(ran) => Ok(ran.trace),
            Err(refusal) => Err(refusal.to_string()),
        };
        cells.into_iter().map(answer).collect()
    }

    /// The points that every engine gives for some shots, and how far they are from the curves.
    ///
    /// `shots`: place on the horizontal axis, scene, and what the curve says; `read`: the value of a trace, which has none where the
    /// impact did not happen.
    fn points(
        &self,
        shots: &[(f64, Scene, f64)],
        from: &'static str,
        unit: &'static str,
        read: impl Fn(&Trace, f64) -> Option<f64>,
    ) -> (Vec<Series>, Vec<Departure>) {
        let mut series: Vec<Series> = Vec::new();
        let mut departures: Vec<Departure> = Vec::new();
        for column in self.columns {
            series.push(Series {
                name: column.label(),
                points: Vec::new(),
                style: Style::Points,
            });
            departures.push(Departure {
                who: column.label(),
                from,
                points: 0,
                largest: None,
                unit,
                missing: Vec::new(),
            });
        }
        for (x, scene, curve) in shots {
            for (k, answer) in self.run(scene).into_iter().enumerate() {
                let value = answer.and_then(|trace| {
                    read(&trace, *x).ok_or_else(|| "the impact did not happen".to_owned())
                });
                match value {
                    Ok(value) => {
                        series[k].points.push([*x, value]);
                        departures[k].note((value - curve).abs());
                    }
                    Err(why) => departures[k].miss(why),
                }
            }
        }
        series.retain(|series| !series.points.is_empty());
        (series, departures)
    }
}

impl Departure {
    fn note(&mut self, departure: f64) {
        self.points += 1;
        self.largest = Some(
            self.largest
                .map_or(departure, |most| crate::math::worse(most, departure)),
        );
    }

    fn miss(&mut self, why: String) {
        match self.missing.iter_mut().find(|(known, _)| *known == why) {
            Some((_, count)) => *count += 1,
            None => self.missing.push((why, 1)),
        }
    }
}

/// Velocity of a ball just after its first collision; `None` where there was none.
fn velocity_after(trace: &Trace, ball: usize) -> Option<crate::math::Vec3> {
    let first = trace
        .events
        .iter()
        .position(|event| event.kind.is_collision())?;
    let mut knots = trace.paths.get(ball)?.knots.iter();
    let far = knots.find(|knot| knot.after == Some(first as u32))?;
    Some(far.state.velocity)
}

/// A line in a figure.
fn line(name: impl Into<String>, points: Vec<[f64; 2]>, style: Style) -> Series {
    Series {
        name: name.into(),
        points,
        style,
    }
}

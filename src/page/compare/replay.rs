//! The replay of a comparison: the knots of every run that did not refuse, and where they part.

use crate::finding::{Replay, ReplayBall, ReplayDivergence, ReplayEvent, ReplayParting, ReplayRun};
use crate::scene::Scene;
use crate::study::compare::{ComparisonEntry, ComparisonOutcome, Standing};
use crate::trace::thin::{self, Jumps, Tolerance};
use crate::trace::{EventKind, Path, Trace};
use crate::words::{self, describe_event};

/// What a knot may be off before it is kept, in R and the largest initial speed. A pixel of the report's table, drawn 2000 px long, is
/// 0.052 R.
pub const TOLERANCE: f64 = 1e-3;

/// Where there are too many knots, the tolerance doubles up to this, in R: still below that pixel.
pub const COARSEST: f64 = 0.032;

/// Numbers in all knots of a replay at most: most of them take less than 3 bytes of a page, none more than 16/3.
const MOST_NUMBERS: usize = 130_000;

/// Events of all runs at most: one takes some 50 bytes of a page.
const MOST_EVENTS: usize = 5_000;

/// Relative spacing of the numbers in which a browser is told times.
const ULP: f64 = f32::EPSILON as f64;

/// Balls at most: more cannot be told apart in a picture.
const MOST_BALLS: usize = 2_000;

/// What a distance may be off before its point is kept, decades.
const DECADES: f64 = 0.02;

/// Distances below this, in R, are as good as none in a picture.
const NOTHING: f64 = 1e-16;

/// The replay of a comparison. Errors: why there is none, in one sentence.
pub fn replay(outcome: &ComparisonOutcome) -> Result<Replay, String> {
    let scene = &outcome.scene;
    let ran: Vec<usize> = (0..outcome.entries.len())
        .filter(|&i| outcome.entries[i].trace().is_some())
        .collect();
    if ran.is_empty() {
        return Err("no engine ran the scene".to_owned());
    }
    if scene.balls.len() > MOST_BALLS {
        return Err(format!(
            "{} balls are too many to be shown",
            scene.balls.len()
        ));
    }
    let traces: Vec<&Trace> = ran
        .iter()
        .filter_map(|&i| outcome.entries[i].trace())
        .collect();
    let units = Units::of(scene);
    let end = traces
        .iter()
        .map(|trace| trace.end_time)
        .fold(0.0, f64::max);
    if end * ULP * units.speed > COARSEST * units.radius {
        return Err(format!(
            "at {end} s the clock of a picture is too coarse for the speed of the balls"
        ));
    }
    let shown = shown(&traces)?;
    let thinned = thinned(&units, scene, &traces, &shown)?;
    let remark = remark(outcome, &ran, &shown, &thinned);
    let runs = ran.iter().zip(thinned).zip(&shown);
    let runs = runs.filter_map(|((&i, thinned), shown)| {
        let entry = &outcome.entries[i];
        run(entry, outcome.reference == Some(i), thinned, shown)
    });
    let runs: Vec<ReplayRun> = runs.collect();
    let place = |i: usize| ran.iter().position(|&known| known == i);
    Ok(Replay {
        scene: scene.name.clone(),
        duration: scene.duration,
        length_unit: scene.units.length.clone(),
        time_unit: scene.units.time.clone(),
        origin: units.origin,
        radius: units.radius,
        speed_scale: units.speed,
        table: scene.table.map(|table| [table.min, table.max]),
        pockets: scene
            .effects
            .pockets
            .iter()
            .flat_map(|pockets| pockets.circles.clone())
            .collect(),
        rotates: scene.effects.rotates(),
        balls: balls(scene),
        remark,
        runs,
        partings: partings(outcome, place),
        horizon: outcome
            .horizon
            .as_ref()
            .filter(|horizon| !horizon.is_whole())
            .map(|horizon| horizon.until),
        divergence: divergence(outcome, place),
    })
}

/// In what the numbers of a replay are counted.
struct Units {
    origin: [f64; 3],
    radius: f64,
    speed: f64,
}

impl Units {
    fn of(scene: &Scene) -> Self {
        let around = |axis: usize| match scene.table {
            Some(table) => [table.min[axis], table.max[axis]],
            None => {
                let at = scene.balls.iter().map(|ball| ball.state.position[axis]);
                at.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
                    [low.min(x), high.max(x)]
                })
            }
        };
        let middle = |axis: usize| {
            let [low, high] = around(axis);
            low + (high - low) / 2.0
        };
        let speed = scene.largest_speed();
        Units {
            origin: [middle(0), middle(1), 0.0],
            radius: scene.smallest_radius(),
            speed: if speed > 0.0 { speed } else { 1.0 },
        }
    }
}

fn balls(scene: &Scene) -> Vec<ReplayBall> {
    let ball = |(i, ball): (usize, &crate::scene::Ball)| ReplayBall {
        id: ball.id.clone(),
        radius: ball.radius,
        mass: ball.mass,
        inertia: scene.inertia(i).unwrap_or(0.0),
    };
    scene.balls.iter().enumerate().map(ball).collect()
}

/// Which events of each run are shown: all, or where there are too many of all runs, in those with the most of them collisions and
/// pockets only. Errors: even those are too many.
fn shown(traces: &[&Trace]) -> Result<Vec<Vec<bool>>, String> {
    let all = |trace: &&Trace| vec![true; trace.events.len()];
    let mut shown: Vec<Vec<bool>> = traces.iter().map(all).collect();
    let mut order: Vec<usize> = (0..traces.len()).collect();
    order.sort_by_key(|&i| traces[i].events.len());
    loop {
        let count = |shown: &Vec<bool>| shown.iter().filter(|shown| **shown).count();
        let events: usize = shown.iter().map(count).sum();
        if events <= MOST_EVENTS {
            return Ok(shown);
        }
        let Some(i) = order.pop() else {
            return Err(format!(
                "{events} collisions of all engines are too many for a page"
            ));
        };
        let events = traces[i].events.iter();
        shown[i] = events
            .map(|event| event.kind.is_collision() || matches!(event.kind, EventKind::Pocket(..)))
            .collect();
    }
}

/// One run's paths with fewer knots, and what they are held to.
struct Thinned {
    paths: Vec<Path>,
    /// R.
    tolerance: f64,
    /// Whether every jump is there.
    every_jump: bool,
}

impl Thinned {
    fn of(trace: &Trace, units: &Units, tolerance: f64, jumps: Jumps) -> Self {
        // where jumps are left out there is no speed to be held to
        let every_jump = jumps == Jumps::All;
        let of_speeds = if every_jump { tolerance } else { f64::INFINITY };
        let bounds = Tolerance {
            position: tolerance * units.radius,
            velocity: of_speeds * units.speed,
            spin: of_speeds * units.speed / units.radius,
        };
        let thin = |path: &Path| thin::thin(path, bounds, jumps);
        Thinned {
            paths: trace.paths.iter().map(thin).collect(),
            tolerance,
            every_jump,
        }
    }

    fn knots(&self) -> usize {
        self.paths.iter().map(|path| path.knots.len()).sum()
    }

    /// With the next coarser bounds; `None` at the end of what a picture allows.
    fn coarser(&self, trace: &Trace, units: &Units, shown: &[bool]) -> Option<Self> {
        let tolerance = 2.0 * self.tolerance;
        let fewer = Jumps::FirstOf(shown);
        match self.every_jump {
            true if tolerance <= COARSEST => Some(Thinned::of(trace, units, tolerance, Jumps::All)),
            true => Some(Thinned::of(trace, units, TOLERANCE, fewer)),
            false if tolerance <= COARSEST => Some(Thinned::of(trace, units, tolerance, fewer)),
            false => None,
        }
    }
}

/// The paths of every run with few enough knots in all. Errors: there are too many however few a picture allows.
fn thinned(
    units: &Units,
    scene: &Scene,
    traces: &[&Trace],
    shown: &[Vec<bool>],
) -> Result<Vec<Thinned>, String> {
    let columns = if scene.effects.rotates() { 10 } else { 7 };
    let first = |trace: &&Trace| Thinned::of(trace, units, TOLERANCE, Jumps::All);
    let mut runs: Vec<Thinned> = traces.iter().map(first).collect();
    loop {
        let knots: usize = runs.iter().map(Thinned::knots).sum();
        if knots * columns <= MOST_NUMBERS {
            return Ok(runs);
        }
        // the largest run goes one step coarser; if it cannot, nor would the others help
        let largest = (0..runs.len()).max_by_key(|&i| runs[i].knots());
        let next = largest.and_then(|i| Some((i, runs[i].coarser(traces[i], units, &shown[i])?)));
        let Some((i, next)) = next else {
            return Err(format!(
                "{knots} knots, as few as a picture allows, are too many for a page"
            ));
        };
        runs[i] = next;
    }
}

/// What the runs do not show.
fn remark(
    outcome: &ComparisonOutcome,
    ran: &[usize],
    shown: &[Vec<bool>],
    thinned: &[Thinned],
) -> String {
    let listed = |wanted: &dyn Fn(usize) -> Option<String>| {
        let named = (0..ran.len()).filter_map(|k| {
            let words = wanted(k)?;
            Some(format!("{}{words}", outcome.entries[ran[k]].label()))
        });
        words::listed(&named.collect::<Vec<_>>())
    };
    let jumps = listed(&|k| {
        let to = format!(" (to {} R)", thinned[k].tolerance);
        (!thinned[k].every_jump).then_some(to)
    });
    let events = listed(&|k| {
        let left_out = shown[k].iter().filter(|shown| !**shown).count();
        (left_out > 0).then(|| format!(" ({left_out})"))
    });
    let mut sentences = Vec::new();
    if !jumps.is_empty() {
        sentences.push(format!(
            "In {jumps} balls that stay in contact hit each other again and again: the replay shows where they are, but of their \
             speeds only some."
        ));
    }
    if !events.is_empty() {
        sentences.push(format!(
            "Stops and changes of rolling are too many to be marked in {events}."
        ));
    }
    sentences.join(" ")
}

fn run(
    entry: &ComparisonEntry,
    reference: bool,
    thinned: Thinned,
    shown: &[bool],
) -> Option<ReplayRun> {
    let trace = entry.trace()?;
    let all: usize = trace.paths.iter().map(|path| path.knots.len()).sum();
    let event = |event: &crate::trace::Event| {
        let (a, b) = event.kind.parties(|ball| &trace.balls[ball]);
        ReplayEvent {
            time: event.time,
            kind: event.kind.id(),
            a,
            b,
        }
    };
    let events = trace.events.iter().zip(shown);
    let events = events.filter_map(|(event, shown)| shown.then_some(event));
    Some(ReplayRun {
        label: entry.label(),
        engine: entry.column.engine.id().to_owned(),
        reference,
        end: trace.end_time,
        ending: words::ending(trace),
        resolution: trace.provenance.resolution,
        events: events.map(event).collect(),
        left_out: all - thinned.knots(),
        tolerance: thinned.tolerance,
        paths: thinned.paths,
    })
}

fn partings(
    outcome: &ComparisonOutcome,
    place: impl Fn(usize) -> Option<usize>,
) -> Vec<ReplayParting> {
    let parting = |&(i, j, standing): &(usize, usize, &Standing)| {
        let parting = standing.order.parting.as_ref()?;
        let (ours, theirs) = (&outcome.entries[i], &outcome.entries[j]);
        let (trace, other) = (ours.trace()?, theirs.trace()?);
        let mut balls: Vec<String> = Vec::new();
        for event in [parting.event, parting.reference].into_iter().flatten() {
            for ball in event.kind.each_ball() {
                let id = &trace.balls[ball];
                if !balls.contains(id) {
                    balls.push(id.clone());
                }
            }
        }
        let why = standing
            .cause
            .as_ref()
            .map(|cause| format!(": {}", cause.sentence()));
        Some(ReplayParting {
            time: parting.time(),
            runs: [place(i)?, place(j)?],
            balls,
            words: format!(
                "At event {} {} has {}, {} has {}{}.",
                parting.index + 1,
                ours.label(),
                describe_event(parting.event.as_ref(), trace),
                theirs.label(),
                describe_event(parting.reference.as_ref(), other),
                why.unwrap_or_default()
            ),
        })
    };
    let mut partings: Vec<ReplayParting> = outcome.held().iter().filter_map(parting).collect();
    partings.sort_by(|a, b| a.time.total_cmp(&b.time));
    partings
}

/// Distances over time: of all from the reference, or without one of all from the engine that stands in its place in the first pair.
fn divergence(
    outcome: &ComparisonOutcome,
    place: impl Fn(usize) -> Option<usize>,
) -> Vec<ReplayDivergence> {
    let held = outcome.held();
    let Some(&(_, yardstick, _)) = held.first() else {
        return Vec::new();
    };
    let curve = |&(i, j, standing): &(usize, usize, &Standing)| {
        let (run, against) = match (i == yardstick, j == yardstick) {
            (_, true) => (i, j),
            (true, _) => (j, i),
            _ => return None,
        };
        Some(ReplayDivergence {
            run: place(run)?,
            against: place(against)?,
            points: fewer(&standing.divergence),
        })
    };
    held.iter().filter_map(curve).collect()
}

/// The points of a curve that those around them do not give, on a logarithmic scale.
fn fewer(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let level = |i: usize| points[i][1].max(NOTHING).log10();
    let fits = |a: usize, b: usize| {
        let span = points[b][0] - points[a][0];
        (a + 1..b).all(|i| {
            let share = (points[i][0] - points[a][0]) / span;
            (level(a) + share * (level(b) - level(a)) - level(i)).abs() <= DECADES
        })
    };
    let kept = thin::stretch(points.len(), fits);
    kept.into_iter().map(|i| points[i]).collect()
}

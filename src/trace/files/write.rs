//! A trace as the text of four files.

use super::number::shortest;
use super::{
    CERTAINTY_COLUMNS, EVENT_COLUMNS, FINAL_COLUMNS, FileError, Files, SAMPLE_COLUMNS, id_of, run,
};
use crate::physics::State;
use crate::trace::{EventKind, Trace};
use std::cmp::{Ordering, Reverse};
use std::collections::{BinaryHeap, HashSet};

/// The four files of a trace.
///
/// Errors: a trace that contradicts itself, such as an event of a ball that it does not have; no engine writes one.
pub fn write(trace: &Trace) -> Result<Files, FileError> {
    let balls = trace.balls.len();
    if trace.paths.len() != balls || trace.stop_times.len() != balls {
        return Err(unwritable(format!(
            "it has {balls} balls, {} paths and {} stop times",
            trace.paths.len(),
            trace.stop_times.len()
        )));
    }
    Ok(Files {
        events: events(trace)?,
        samples: samples(trace)?,
        final_states: final_states(trace)?,
        run: run::write(trace)?,
    })
}

fn events(trace: &Trace) -> Result<String, FileError> {
    if !trace.certainty.is_empty() && trace.certainty.len() != trace.events.len() {
        return Err(unwritable(format!(
            "it has {} events and the certainty of {}",
            trace.events.len(),
            trace.certainty.len()
        )));
    }
    let mut sheet = Sheet::new(&[&EVENT_COLUMNS[..], &CERTAINTY_COLUMNS].concat())?;
    for (index, event) in trace.events.iter().enumerate() {
        let (a, b) = event.kind.balls();
        for ball in std::iter::once(a).chain(b) {
            id_of(trace, ball as u32)?;
        }
        if matches!(event.kind, EventKind::BallBall(a, b) if a >= b) {
            return Err(unwritable(format!(
                "event {index}: the pair is not in scene order"
            )));
        }
        let (a, b) = event.kind.parties(|ball| &trace.balls[ball]);
        let exchanges = event
            .exchanges
            .map(|count| count.to_string())
            .unwrap_or_default();
        let certainty = trace.certainty.get(index).copied().unwrap_or_default();
        let [margin, condition, time_error] =
            [certainty.margin, certainty.condition, certainty.time_error]
                .map(|number| number.map(shortest).unwrap_or_default());
        sheet.row([
            &index.to_string(),
            &shortest(event.time),
            event.kind.id(),
            &a,
            &b,
            &exchanges,
            &margin,
            &condition,
            &time_error,
        ])?;
    }
    sheet.text()
}

/// Knots by time, then ball; every path keeps its own order, whatever its times are.
fn samples(trace: &Trace) -> Result<String, FileError> {
    let mut sheet = Sheet::new(&SAMPLE_COLUMNS)?;
    let mut heads: BinaryHeap<Reverse<Head>> = BinaryHeap::new();
    let head = |ball: usize, knot: usize| {
        let time = trace.paths[ball].knots.get(knot)?.time;
        Some(Reverse(Head { time, ball, knot }))
    };
    heads.extend((0..trace.paths.len()).filter_map(|ball| head(ball, 0)));
    while let Some(Reverse(Head { ball, knot, .. })) = heads.pop() {
        let row = &trace.paths[ball].knots[knot];
        let time = shortest(row.time);
        let event = row.after.map(|event| event.to_string()).unwrap_or_default();
        let numbers = state_fields(Some(&row.state));
        let fields = [&time, &trace.balls[ball]].into_iter();
        sheet.row(fields.chain(&numbers).chain([&event]))?;
        heads.extend(head(ball, knot + 1));
    }
    sheet.text()
}

fn final_states(trace: &Trace) -> Result<String, FileError> {
    let mut sheet = Sheet::new(&FINAL_COLUMNS)?;
    let mut named = HashSet::new();
    for (i, state) in trace.final_states().iter().enumerate() {
        let id = &trace.balls[i];
        if !named.insert(id) {
            return Err(unwritable(format!("two balls are called `{id}`")));
        }
        if trace.paths[i].knots.is_empty() {
            return Err(unwritable(format!("the path of ball `{id}` is empty")));
        }
        let numbers = state_fields(state.as_ref());
        let stop = trace.stop_times[i].map(shortest).unwrap_or_default();
        sheet.row([id].into_iter().chain(&numbers).chain([&stop]))?;
    }
    sheet.text()
}

/// Position, velocity and spin; nine empty fields for a ball that left play.
fn state_fields(state: Option<&State>) -> [String; 9] {
    let Some(state) = state else {
        return Default::default();
    };
    let (r, v, w) = (&state.position, &state.velocity, &state.spin);
    [r.x, r.y, r.z, v.x, v.y, v.z, w.x, w.y, w.z].map(shortest)
}

/// The first knot of a path that is not yet written.
struct Head {
    time: f64,
    ball: usize,
    knot: usize,
}

impl Ord for Head {
    fn cmp(&self, other: &Self) -> Ordering {
        // -0 is 0 here, and a NaN comes last whatever its sign
        let key = |t: f64| if t.is_nan() { f64::NAN.abs() } else { t + 0.0 };
        key(self.time)
            .total_cmp(&key(other.time))
            .then(self.ball.cmp(&other.ball))
    }
}

impl PartialOrd for Head {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Head {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Head {}

/// A CSV file in the making.
struct Sheet(csv::Writer<Vec<u8>>);

impl Sheet {
    fn new(columns: &[&str]) -> Result<Self, FileError> {
        let mut sheet = Sheet(csv::Writer::from_writer(Vec::new()));
        sheet.row(columns)?;
        Ok(sheet)
    }

    fn row(&mut self, fields: impl IntoIterator<Item: AsRef<[u8]>>) -> Result<(), FileError> {
        self.0
            .write_record(fields)
            .map_err(|error| unwritable(error.to_string()))
    }

    fn text(self) -> Result<String, FileError> {
        let bytes = self
            .0
            .into_inner()
            .map_err(|error| unwritable(error.to_string()))?;
        String::from_utf8(bytes).map_err(|error| unwritable(error.to_string()))
    }
}

fn unwritable(problem: String) -> FileError {
    FileError::Unwritable { problem }
}

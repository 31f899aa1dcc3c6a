//! The text of four files as a trace, with every fault named by file, line and column.

use super::{
    CERTAINTY_COLUMNS, EVENT_COLUMNS, EVENTS, FINAL, FINAL_COLUMNS, FileError, Files, RUN,
    SAMPLE_COLUMNS, SAMPLES, ball_index, run,
};
use crate::math::Vec3;
use crate::physics::{Side, State};
use crate::trace::{Certainty, Ending, Event, EventKind, Knot, Partner, Path, Trace};
use std::collections::HashMap;

/// The trace that four files hold.
///
/// What they say twice must agree: the states in `final.csv` are the last knots, and a knot's event is one of its ball. Times are finite,
/// and so are positions, velocities and spins unless the run ended because one of them was not.
///
/// Errors: the first fault found, with file, line, column and what would be right.
pub fn read(files: &Files) -> Result<Trace, FileError> {
    let rows = final_rows(&files.final_states)?;
    let balls: Vec<String> = rows.iter().map(|row| row.id.clone()).collect();
    let index: Index = balls
        .iter()
        .enumerate()
        .map(|(i, id)| (id.as_str(), i as u32))
        .collect();
    let part = run::read(&files.run, &balls)?;
    let broken = matches!(part.ending, Ending::NotFinite(_));
    let (events, certainty) = events(&files.events, &balls, &index)?;
    let paths = samples(&files.samples, &balls, &index, &events, broken)?;
    let trace = Trace {
        provenance: part.provenance,
        paths,
        events,
        certainty,
        stop_times: rows.iter().map(|row| row.stop_time).collect(),
        extrema: part.extrema,
        counters: part.counters,
        ending: part.ending,
        end_time: part.end_time,
        balls,
    };
    for (row, state) in rows.iter().zip(trace.final_states()) {
        row.agree(state)?;
    }
    Ok(trace)
}

/// Ball ids to indices in scene order.
type Index<'a> = HashMap<&'a str, u32>;

/// One row of `final.csv`.
struct FinalRow {
    line: u64,
    id: String,
    /// The state as nine numbers, or `None` for a pocketed ball.
    state: Option<[f64; 9]>,
    stop_time: Option<f64>,
}

fn final_rows(text: &str) -> Result<Vec<FinalRow>, FileError> {
    let mut table = Table::open(FINAL, text, &FINAL_COLUMNS)?;
    let mut rows: Vec<FinalRow> = Vec::new();
    let mut lines: HashMap<String, u64> = HashMap::new();
    while let Some(fields) = table.row()? {
        let [ball, state @ .., stop_time] = fields;
        if let Some(first) = lines.insert(ball.text.to_owned(), ball.line) {
            return Err(ball.wrong(format!("ball `{}` is already on line {first}", ball.text)));
        }
        let given = state.iter().filter(|field| !field.text.is_empty()).count();
        rows.push(FinalRow {
            line: ball.line,
            id: ball.text.to_owned(),
            state: if given == 0 {
                None
            } else {
                Some(numbers(&state)?)
            },
            stop_time: stop_time.optional(Field::finite)?,
        });
    }
    Ok(rows)
}

impl FinalRow {
    /// Holds the row against the last knot of the ball's path.
    fn agree(&self, last: Option<State>) -> Result<(), FileError> {
        let wrong = |column: &'static str, problem: String| FileError::Field {
            file: FINAL,
            line: self.line,
            column,
            problem,
        };
        let (given, last) = match (&self.state, last) {
            (None, None) => return Ok(()),
            (Some(given), Some(last)) => (given, last),
            (None, Some(_)) => {
                let problem =
                    "empty, but the ball is in play: expected the last state in samples.csv";
                return Err(wrong(FINAL_COLUMNS[1], problem.to_owned()));
            }
            (Some(_), None) => {
                let problem =
                    "the ball is pocketed in events.csv: expected empty numbers".to_owned();
                return Err(wrong(FINAL_COLUMNS[1], problem));
            }
        };
        let (r, v, w) = (last.position, last.velocity, last.spin);
        let known = [r.x, r.y, r.z, v.x, v.y, v.z, w.x, w.y, w.z];
        for (i, (given, known)) in given.iter().zip(known).enumerate() {
            if *given != known && !(given.is_nan() && known.is_nan()) {
                let problem =
                    format!("{given}, but the last row of the ball in {SAMPLES} says {known}");
                return Err(wrong(FINAL_COLUMNS[i + 1], problem));
            }
        }
        Ok(())
    }
}

/// The events, and what is known of their certainty: nothing at all if no row says anything.
fn events(
    text: &str,
    balls: &[String],
    index: &Index,
) -> Result<(Vec<Event>, Vec<Certainty>), FileError> {
    let mut table = Table::open(EVENTS, text, &EVENT_COLUMNS)?.with_optional(&CERTAINTY_COLUMNS);
    let mut events: Vec<Event> = Vec::new();
    let mut certainty: Vec<Certainty> = Vec::new();
    while let Some([number, time, kind, a, b, exchanges]) = table.row()? {
        if number.whole::<usize>()? != events.len() {
            let expected = events.len();
            return Err(number.wrong(format!(
                "`{}`: events are numbered from 0; expected {expected}",
                number.text
            )));
        }
        let event = Event {
            time: time.finite()?,
            kind: event_kind(&kind, &a, &b, balls, index)?,
            exchanges: exchanges.optional(Field::whole)?,
        };
        if events.last().is_some_and(|last| event.time < last.time) {
            return Err(time.wrong(format!("{} is earlier than the event before", event.time)));
        }
        events.push(event);
        let [margin, condition, time_error] = table.optional_fields();
        certainty.push(Certainty {
            margin: margin.optional(Field::measure)?,
            condition: condition.optional(Field::measure)?,
            // an estimate whose derivative overflowed is no number, and says so
            time_error: time_error.optional(Field::number)?,
        });
    }
    if certainty.iter().all(|known| *known == Certainty::default()) {
        certainty.clear();
    }
    Ok((events, certainty))
}

fn event_kind(
    kind: &Field,
    a: &Field,
    b: &Field,
    balls: &[String],
    index: &Index,
) -> Result<EventKind, FileError> {
    let first = a.ball(balls, index)?;
    let alone = |kind: EventKind| {
        if b.text.is_empty() {
            Ok(kind)
        } else {
            let problem = format!("`{}`: expected nothing for this kind", b.text);
            Err(b.wrong(problem))
        }
    };
    let side_of = || Side::ALL.into_iter().find(|side| side.id() == b.text);
    let second_ball = || -> Result<u32, FileError> {
        let second = b.ball(balls, index)?;
        if first < second {
            return Ok(second);
        }
        let problem = format!(
            "`{}` with `{}`: expected two balls in the order of {FINAL}",
            b.text, a.text
        );
        Err(b.wrong(problem))
    };
    let partner = || match side_of() {
        Some(side) => Ok(Partner::Cushion(side)),
        None => second_ball().map(Partner::Ball),
    };
    match kind.text {
        "ball-ball" => Ok(EventKind::BallBall(first, second_ball()?)),
        "ball-cushion" => {
            let side = side_of().ok_or_else(|| {
                b.wrong(format!("`{}`: expected a cushion, x0, x1, y0 or y1", b.text))
            })?;
            Ok(EventKind::BallCushion(first, side))
        }
        "contact-begin" => Ok(EventKind::ContactBegin(first, partner()?)),
        "contact-end" => Ok(EventKind::ContactEnd(first, partner()?)),
        "stop" => alone(EventKind::Stop(first)),
        "slide-to-roll" => alone(EventKind::SlideToRoll(first)),
        "spin-end" => alone(EventKind::SpinEnd(first)),
        "pocket" => {
            let number = b.text.strip_prefix('p').and_then(|n| n.parse().ok());
            let number = number
                .ok_or_else(|| b.wrong(format!("`{}`: expected a pocket, p0, p1, ...", b.text)))?;
            Ok(EventKind::Pocket(first, number))
        }
        other => Err(kind.wrong(format!(
            "unknown kind `{other}`; known are ball-ball, ball-cushion, stop, slide-to-roll, spin-end, pocket, contact-begin, contact-end"
        ))),
    }
}

/// The paths. `broken`: the run ended because a state was no number, so that states may be none.
fn samples(
    text: &str,
    balls: &[String],
    index: &Index,
    events: &[Event],
    broken: bool,
) -> Result<Vec<Path>, FileError> {
    let mut table = Table::open(SAMPLES, text, &SAMPLE_COLUMNS)?;
    let mut paths = vec![Path::default(); balls.len()];
    let mut line = 1;
    while let Some([time, ball, state @ .., event]) = table.row()? {
        line = time.line;
        let i = ball.ball(balls, index)?;
        let knot = Knot {
            time: time.finite()?,
            state: state_of(if broken {
                numbers(&state)?
            } else {
                finite_numbers(&state)?
            }),
            after: event.optional(Field::whole)?,
        };
        if let Some(after) = knot.after {
            let parties = events.get(after as usize).map(|event| event.kind.balls());
            let (a, b) = parties.ok_or_else(|| {
                event.wrong(format!(
                    "{EVENTS} has {} rows, no event {after}",
                    events.len()
                ))
            })?;
            if a != i as usize && b != Some(i as usize) {
                let problem = format!("event {after} is not one of ball `{}`", ball.text);
                return Err(event.wrong(problem));
            }
        }
        let knots = &mut paths[i as usize].knots;
        if knots.last().is_some_and(|last| knot.time < last.time) {
            let problem = format!("{} is earlier than the ball's row before", knot.time);
            return Err(time.wrong(problem));
        }
        knots.push(knot);
    }
    if let Some(empty) = paths.iter().position(|path| path.knots.is_empty()) {
        return Err(FileError::Line {
            file: SAMPLES,
            line,
            problem: format!(
                "the file has no row of ball `{}`; every ball of {FINAL} has at least its first state",
                balls[empty]
            ),
        });
    }
    Ok(paths)
}

fn numbers(fields: &[Field; 9]) -> Result<[f64; 9], FileError> {
    let mut numbers = [0.0; 9];
    for (number, field) in numbers.iter_mut().zip(fields) {
        *number = field.number()?;
    }
    Ok(numbers)
}

/// The numbers of a state in a run that did not end because they were none.
fn finite_numbers(fields: &[Field; 9]) -> Result<[f64; 9], FileError> {
    let numbers = numbers(fields)?;
    match numbers.iter().position(|x| !x.is_finite()) {
        None => Ok(numbers),
        Some(at) => Err(fields[at].wrong(format!(
            "`{}`: expected a finite number; only a run that ends as not-finite in {RUN} may hold others",
            fields[at].text
        ))),
    }
}

fn state_of(n: [f64; 9]) -> State {
    State {
        position: Vec3::new(n[0], n[1], n[2]),
        velocity: Vec3::new(n[3], n[4], n[5]),
        spin: Vec3::new(n[6], n[7], n[8]),
    }
}

/// A CSV file being read, row by row.
struct Table<'a, const N: usize, const M: usize = 0> {
    file: &'static str,
    columns: &'static [&'static str; N],
    /// Where each known column is in this file.
    at: [usize; N],
    /// Columns that a file may lack.
    optional: &'static [&'static str; M],
    /// Where they are, if anywhere.
    optional_at: [Option<usize>; M],
    reader: csv::Reader<&'a [u8]>,
    record: csv::StringRecord,
}

impl<'a, const N: usize> Table<'a, N> {
    fn open(
        file: &'static str,
        text: &'a str,
        columns: &'static [&'static str; N],
    ) -> Result<Self, FileError> {
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let header = reader.headers().map_err(|error| unreadable(file, &error))?;
        let mut at = [0; N];
        for (at, &column) in at.iter_mut().zip(columns) {
            let found = header.iter().position(|name| name == column);
            *at = found.ok_or(FileError::MissingColumn {
                file,
                column,
                columns,
            })?;
        }
        Ok(Table {
            file,
            columns,
            at,
            optional: &[],
            optional_at: [],
            reader,
            record: csv::StringRecord::new(),
        })
    }

    /// The same table, also reading columns that it may lack.
    fn with_optional<const M: usize>(
        mut self,
        optional: &'static [&'static str; M],
    ) -> Table<'a, N, M> {
        // the header was read when the table was opened
        let header = self.reader.headers().cloned().unwrap_or_default();
        Table {
            file: self.file,
            columns: self.columns,
            at: self.at,
            optional,
            optional_at: optional.map(|column| header.iter().position(|name| name == column)),
            reader: self.reader,
            record: self.record,
        }
    }
}

impl<const N: usize, const M: usize> Table<'_, N, M> {
    /// The fields of the row read last that a file may lack; empty where it does.
    fn optional_fields(&self) -> [Field<'_>; M] {
        let line = self.record.position().map_or(0, csv::Position::line);
        std::array::from_fn(|i| Field {
            file: self.file,
            line,
            column: self.optional[i],
            text: self.optional_at[i]
                .and_then(|at| self.record.get(at))
                .unwrap_or_default(),
        })
    }

    /// The known fields of the next row, or `None` after the last.
    fn row(&mut self) -> Result<Option<[Field<'_>; N]>, FileError> {
        let more = self
            .reader
            .read_record(&mut self.record)
            .map_err(|error| unreadable(self.file, &error))?;
        if !more {
            return Ok(None);
        }
        let line = self.record.position().map_or(0, csv::Position::line);
        Ok(Some(std::array::from_fn(|i| Field {
            file: self.file,
            line,
            column: self.columns[i],
            // the reader holds every row to the length of the header
            text: self.record.get(self.at[i]).unwrap_or_default(),
        })))
    }
}

fn unreadable(file: &'static str, error: &csv::Error) -> FileError {
    let line = error.position().map_or(1, csv::Position::line);
    let problem = match error.kind() {
        csv::ErrorKind::UnequalLengths {
            expected_len, len, ..
        } => format!(
            "expected {expected_len} fields, as many as the first line has, and found {len}"
        ),
        _ => error.to_string(),
    };
    FileError::Line {
        file,
        line,
        problem,
    }
}

/// One field with its address.
struct Field<'a> {
    file: &'static str,
    line: u64,
    column: &'static str,
    text: &'a str,
}

impl Field<'_> {
    fn wrong(&self, problem: String) -> FileError {
        FileError::Field {
            file: self.file,
            line: self.line,
            column: self.column,
            problem,
        }
    }

    fn number(&self) -> Result<f64, FileError> {
        self.text
            .parse()
            .map_err(|_| self.wrong(format!("`{}`: expected a number", self.text)))
    }

    /// A number that is one.
    fn finite(&self) -> Result<f64, FileError> {
        let x = self.number()?;
        if x.is_finite() {
            return Ok(x);
        }
        Err(self.wrong(format!("`{}`: expected a finite number", self.text)))
    }

    /// A size that may be without bound: a margin to nothing, a condition of what only touches.
    fn measure(&self) -> Result<f64, FileError> {
        let x = self.number()?;
        if x >= 0.0 {
            return Ok(x);
        }
        let expected = "expected a number, 0 or more, or inf";
        Err(self.wrong(format!("`{}`: {expected}", self.text)))
    }

    fn whole<T: std::str::FromStr>(&self) -> Result<T, FileError> {
        let problem = || format!("`{}`: expected a whole number, 0 or more", self.text);
        self.text.parse().map_err(|_| self.wrong(problem()))
    }

    /// The value of a field that may be empty.
    fn optional<T>(
        &self,
        value: impl Fn(&Self) -> Result<T, FileError>,
    ) -> Result<Option<T>, FileError> {
        if self.text.is_empty() {
            Ok(None)
        } else {
            value(self).map(Some)
        }
    }

    fn ball(&self, balls: &[String], index: &Index) -> Result<u32, FileError> {
        match index.get(self.text) {
            Some(&i) => Ok(i),
            None => ball_index(balls, self.text).map_err(|problem| self.wrong(problem)),
        }
    }
}

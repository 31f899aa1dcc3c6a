//! The reference rows of `validation/references/contact_roots.csv` and `wall_crossings.csv`, and the judgement of a finder by
//! them: error over the conditioning bound, and whether it found, missed, invented or doubted a contact.
//!
//! Shared with `benches/roots.rs`, which prints the table.

use carom::math::first_root::{
    Approach, Blur, Contact, InputError, crossing_error, first_contact, first_crossing,
    straight_contact, time_error, turn_error,
};
use carom::math::{DoubleDouble, Dual, Octuple, Real};
use std::collections::BTreeMap;
use std::fmt::Write;

/// What the truth of a row is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A contact up to the limit.
    Hit,
    /// Touching or overlapping, and approaching, at time 0.
    Now,
    /// Overlapping and receding; contact at the turn inward.
    Turn,
    /// A contact after the limit.
    Late,
    /// No contact at all.
    Miss,
}

/// How the discs move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Motion {
    /// Relative acceleration.
    Curved([f64; 2]),
    /// Along a line, to rest within this time; infinite: constant velocity.
    Straight(f64),
    /// A disc and a wall: `p[0]` is the gap, `v[0]` the speed, and this the acceleration.
    Wall(f64),
}

/// One problem and its solution.
#[derive(Clone, Debug)]
pub struct Row {
    pub class: String,
    pub p: [f64; 2],
    pub v: [f64; 2],
    pub motion: Motion,
    pub distance: f64,
    pub limit: f64,
    /// Largest coordinate, where positions are worse than their differences show.
    pub extent: Option<f64>,
    pub kind: Kind,
    /// Of the contact, s.
    pub time: Option<Octuple>,
    /// By how much a closest approach is a hit or a miss, length; infinite where there is none.
    pub margin: f64,
}

fn records(name: &str) -> Vec<BTreeMap<String, String>> {
    let path = format!(
        "{}/validation/references/{name}",
        env!("CARGO_MANIFEST_DIR")
    );
    let mut reader = csv::Reader::from_path(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
    let rows: Vec<_> = reader.deserialize().map(Result::unwrap).collect();
    assert!(rows.len() > 500, "{path}: {} rows", rows.len());
    rows
}

/// All rows: pairs first, then walls.
pub fn rows() -> Vec<Row> {
    let number = |r: &BTreeMap<String, String>, key: &str| -> f64 {
        r[key]
            .parse()
            .unwrap_or_else(|e| panic!("{key} in {r:?}: {e}"))
    };
    let optional =
        |r: &BTreeMap<String, String>, key: &str| (!r[key].is_empty()).then(|| number(r, key));
    let kind = |r: &BTreeMap<String, String>| match r["kind"].as_str() {
        "hit" => Kind::Hit,
        "now" => Kind::Now,
        "turn" => Kind::Turn,
        "late" => Kind::Late,
        "miss" => Kind::Miss,
        other => panic!("kind {other}"),
    };
    let time = |r: &BTreeMap<String, String>| {
        let digits = &r["time"];
        (!digits.is_empty()).then(|| digits.parse::<Octuple>().unwrap())
    };
    let pair = |r: BTreeMap<String, String>| Row {
        class: r["class"].clone(),
        p: [number(&r, "px"), number(&r, "py")],
        v: [number(&r, "vx"), number(&r, "vy")],
        motion: match optional(&r, "rest") {
            Some(rest) => Motion::Straight(rest),
            None => Motion::Curved([number(&r, "ax"), number(&r, "ay")]),
        },
        distance: number(&r, "distance"),
        limit: number(&r, "limit"),
        extent: optional(&r, "extent"),
        kind: kind(&r),
        time: time(&r),
        margin: optional(&r, "margin").unwrap_or(f64::INFINITY),
    };
    let wall = |r: BTreeMap<String, String>| Row {
        class: format!("wall: {}", r["class"]),
        p: [number(&r, "gap"), 0.0],
        v: [number(&r, "speed"), 0.0],
        motion: Motion::Wall(number(&r, "acceleration")),
        distance: 0.0,
        limit: number(&r, "limit"),
        extent: None,
        kind: kind(&r),
        time: time(&r),
        margin: optional(&r, "margin").unwrap_or(f64::INFINITY),
    };
    let pairs = records("contact_roots.csv").into_iter().map(pair);
    let walls = records("wall_crossings.csv").into_iter().map(wall);
    pairs.chain(walls).collect()
}

/// A scalar whose numbers can be written with 237 bits.
pub trait Wide: Real {
    fn wide(self) -> Octuple;
}

impl Wide for f32 {
    fn wide(self) -> Octuple {
        Octuple::lift(f64::from(self))
    }
}

impl Wide for f64 {
    fn wide(self) -> Octuple {
        Octuple::lift(self)
    }
}

impl Wide for DoubleDouble {
    fn wide(self) -> Octuple {
        Octuple::lift(self.high()) + Octuple::lift(self.low())
    }
}

impl Wide for Octuple {
    fn wide(self) -> Octuple {
        self
    }
}

impl<T: Wide, const N: usize> Wide for Dual<T, N> {
    fn wide(self) -> Octuple {
        self.value.wide()
    }
}

/// Which finder answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Finder {
    /// `first_contact`.
    Search,
    /// `straight_contact`.
    Straight,
    /// `first_crossing`.
    Wall,
}

impl Row {
    /// The finders that can solve it; the closed form's own first.
    pub fn finders(&self) -> &'static [Finder] {
        match self.motion {
            Motion::Curved(_) => &[Finder::Search],
            Motion::Straight(_) => &[Finder::Straight, Finder::Search],
            Motion::Wall(_) => &[Finder::Wall],
        }
    }

    /// As the general finder takes it.
    pub fn approach<T: Real>(&self) -> Approach<T> {
        let lift = |x: [f64; 2]| x.map(T::lift);
        Approach {
            p: lift(self.p),
            v: lift(self.v),
            a: match self.motion {
                Motion::Curved(a) => lift(a),
                Motion::Straight(rest) => lift(self.v).map(|v| -v / T::lift(rest)),
                Motion::Wall(a) => [T::lift(a), T::zero()],
            },
            distance: T::lift(self.distance),
        }
    }

    /// What a scene of this extent would hold positions and velocities to: as in the engine's world.
    pub fn blur<T: Real>(&self) -> Blur<T> {
        let m = self.approach::<f64>();
        let norm = |x: [f64; 2]| x[0].hypot(x[1]);
        let path = norm(m.v) * self.limit + 0.5 * norm(m.a) * self.limit * self.limit;
        let extent = self.extent.unwrap_or(norm(m.p) + m.distance + path);
        let fastest = norm(m.v) + norm(m.a) * self.limit;
        Blur {
            length: T::lift(4.0 * T::ULP * extent),
            speed: T::lift(8.0 * T::ULP * fastest),
        }
    }

    /// True if the squares of its numbers stay well within the range of a scalar whose smallest normal number is `least`.
    pub fn fits(&self, least: f64) -> bool {
        let m = self.approach::<f64>();
        let b = self.blur::<f64>();
        let path = (b.length / f64::EPSILON).powi(2);
        let numbers = [m.p, m.v, m.a, [m.distance, self.limit]];
        numbers.iter().flatten().all(|x| {
            let square = x * x;
            least == 0.0 || *x == 0.0 || (square > 1e8 * least && square * path < 1e-8 / least)
        })
    }

    /// Asks a finder in a scalar of its own.
    pub fn ask<T: Real>(&self, finder: Finder) -> Contact<T> {
        let m = self.approach::<T>();
        self.ask_about(finder, &m, &self.blur())
    }

    /// The same about other numbers than its own.
    pub fn ask_about<T: Real>(
        &self,
        finder: Finder,
        m: &Approach<T>,
        blur: &Blur<T>,
    ) -> Contact<T> {
        let limit = T::lift(self.limit);
        match (finder, self.motion) {
            (Finder::Search, _) => first_contact(m, limit, blur),
            (_, Motion::Straight(rest)) => {
                straight_contact(m.p, m.v, T::lift(rest), m.distance, limit, blur)
            }
            (_, Motion::Wall(_)) => first_crossing(m.p[0], m.v[0], m.a[0], limit, blur),
            (_, Motion::Curved(_)) => panic!("{}: no closed form", self.class),
        }
    }

    /// Largest motion of the contact at `t` under an error of the numbers; see `math::first_root`.
    pub fn bound(&self, t: Octuple, error: &InputError<Octuple>) -> Option<f64> {
        let m = self.approach::<Octuple>();
        let bound = match (self.motion, self.kind) {
            (Motion::Wall(_), Kind::Turn) => {
                // the speed vanishes there
                let speed = error.speed(t);
                Some(speed / Real::abs(m.a[0]))
            }
            (Motion::Wall(_), _) => crossing_error(m.v[0], m.a[0], t, error),
            (_, Kind::Turn) => turn_error(&m, t, error),
            _ => time_error(&m, t, error),
        };
        bound.map(|b| b.to_f64())
    }

    /// Distance still free at time `t`, length, and the speed at which it closes.
    pub fn gap(&self, t: Octuple) -> (f64, f64) {
        let m = self.approach::<Octuple>();
        let half = Octuple::lift(0.5);
        let position = [0, 1].map(|i| m.p[i] + t * (m.v[i] + m.a[i] * t * half));
        let velocity = [0, 1].map(|i| m.v[i] + m.a[i] * t);
        if let Motion::Wall(_) = self.motion {
            let [gap, _] = m.p;
            let moved = position[0] - gap;
            return ((gap - moved).to_f64(), velocity[0].to_f64());
        }
        let dot = |x: [Octuple; 2], y: [Octuple; 2]| x[0] * y[0] + x[1] * y[1];
        let apart = Real::sqrt(dot(position, position));
        let closing = -dot(position, velocity) / apart;
        ((apart - m.distance).to_f64(), closing.to_f64())
    }
}

impl Row {
    /// Relative speed at time `t`, and the size of the second derivative of the distance there, over the closing speed's
    /// units: length/s and length/s^2.
    pub fn motion_at(&self, t: f64) -> (f64, f64) {
        let m = self.approach::<f64>();
        let u = [0, 1].map(|i| m.v[i] + m.a[i] * t);
        let (speed, acceleration) = (u[0].hypot(u[1]), m.a[0].hypot(m.a[1]));
        let turning = if self.distance > 0.0 {
            speed * speed / self.distance
        } else {
            0.0
        };
        (speed, turning + acceleration)
    }
}

/// What a finder's answer is worth.
#[derive(Clone, Debug, PartialEq)]
pub enum Judged {
    /// A contact, with its error over what rounding of the input alone may do, and over the finder's whole bound.
    Hit { over_input: f64, over_bound: f64 },
    /// Rightly none.
    Miss,
    /// Not decided, where the margin is at the level of the blur.
    Unclear,
    /// A contact that was not found.
    Missed(String),
    /// A contact that is none.
    Ghost(String),
    /// Anything else that is wrong.
    Wrong(String),
}

/// Judges the answer of one finder in one scalar.
pub fn judge<T: Wide>(row: &Row, finder: Finder) -> Judged {
    let (blur, answer) = (row.blur::<T>(), row.ask::<T>(finder));
    let exact = row.approach::<Octuple>();
    let rounding = T::ROUNDING;
    let input = InputError::of_numbers(&exact, rounding);
    let own = match finder {
        Finder::Search => InputError::of_search(&exact, rounding),
        Finder::Straight => InputError::of_straight(&exact, rounding),
        Finder::Wall => InputError::of_crossing(exact.v[0], exact.a[0], rounding),
    };
    let total = input.and(own);
    let limit = Octuple::lift(row.limit);
    let length = blur.length.wide().to_f64();
    let say = |what: &str| {
        format!(
            "{what}: {finder:?} answered {answer:?}, true is {:?} at {:?}, margin {:e}, blur {length:e}, for {row:?}",
            row.kind,
            row.time.map(|t| t.to_f64()),
            row.margin
        )
    };
    // the time that matters: of the contact, or of the end
    let t = row.time.unwrap_or(limit);
    // whether there is a contact depends on the miss distance alone, which is good to 3 roundings of every length
    let decision = 0.75 * length * T::ROUNDING / T::ULP;
    // a gap that is small at the limit only is for the caller, who searches on from there, unless everything stops there
    let (last, _) = row.gap(limit);
    let interior = finder == Finder::Straight || last.abs() > row.margin + decision;
    let doubtful = row.margin < length - decision && interior;
    let near = length + decision;
    let (first, closing) = row.gap(Octuple::ZERO);
    let touching = first <= near;
    match answer {
        Contact::At(found) if found == T::zero() && touching => {
            // by the rule: within the blur and closing in is contact now, whatever comes after
            let over = first.max(0.0) / near;
            if closing > 0.0 {
                Judged::Hit {
                    over_input: over,
                    over_bound: over,
                }
            } else {
                Judged::Ghost(say("receding"))
            }
        }
        Contact::At(found) => {
            let found = found.wide();
            if row.kind == Kind::Miss {
                return if doubtful {
                    Judged::Wrong(say("decided what rounding decides"))
                } else {
                    Judged::Ghost(say("a ghost"))
                };
            }
            let error = Real::abs(found - t).to_f64();
            let Some(bound) = row.bound(t, &total) else {
                return Judged::Wrong(say("decided what rounding decides"));
            };
            if row.kind == Kind::Late && error > bound {
                return Judged::Ghost(say("beyond the limit"));
            }
            let over = |bound: f64| if error == 0.0 { 0.0 } else { error / bound };
            Judged::Hit {
                over_input: over(row.bound(t, &input).unwrap_or(0.0)),
                over_bound: over(bound),
            }
        }
        Contact::Never => match row.kind {
            Kind::Miss if doubtful => Judged::Wrong(say("decided what rounding decides")),
            Kind::Miss | Kind::Late => Judged::Miss,
            // touching, and too slow to be told from rest
            Kind::Now if closing <= blur.speed.wide().to_f64() => Judged::Miss,
            Kind::Hit | Kind::Now | Kind::Turn => {
                let beside = Real::abs(t - limit).to_f64();
                let bound = row.bound(t, &total);
                if bound.is_some_and(|bound| beside <= bound + row.limit * rounding) {
                    Judged::Miss
                } else {
                    Judged::Missed(say("missed"))
                }
            }
        },
        Contact::Unclear(since) => {
            let (_, closing) = row.gap(t);
            let slow = row.time.is_some()
                && closing.abs()
                    <= blur.speed.wide().to_f64() + total.speed(t.at_most(limit)).to_f64();
            // clearly a contact, but an error of the size of the blur moves it without bound
            let adrift = InputError {
                position: blur.length.wide(),
                ..total
            };
            let unbound = row.time.is_some() && row.bound(t, &adrift).is_none();
            let (gap, _) = row.gap(since.wide());
            if row.margin > near && !slow && !unbound {
                Judged::Wrong(say("unclear without need"))
            } else if gap.abs() > 4.0 * near {
                Judged::Wrong(say(&format!("unclear from a gap of {gap:e} on")))
            } else {
                Judged::Unclear
            }
        }
    }
}

/// What a finder did with a class of rows.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    pub rows: usize,
    pub hits: usize,
    pub unclear: usize,
    pub missed: usize,
    pub ghosts: usize,
    pub wrong: usize,
    pub over_input: f64,
    pub over_bound: f64,
    /// The first failures, in words.
    pub failures: Vec<String>,
}

impl Tally {
    fn add(&mut self, judged: Judged) {
        self.rows += 1;
        let failure = match judged {
            Judged::Hit {
                over_input,
                over_bound,
            } => {
                self.hits += 1;
                self.over_input = self.over_input.max(over_input);
                self.over_bound = self.over_bound.max(over_bound);
                return;
            }
            Judged::Miss => return,
            Judged::Unclear => {
                self.unclear += 1;
                return;
            }
            Judged::Missed(why) => {
                self.missed += 1;
                why
            }
            Judged::Ghost(why) => {
                self.ghosts += 1;
                why
            }
            Judged::Wrong(why) => {
                self.wrong += 1;
                why
            }
        };
        if self.failures.len() < 2 {
            self.failures.push(failure);
        }
    }
}

/// Every class of the file in the scalar `T`, in the order of the file; `least` as in [`Row::fits`], 0 for every row.
pub fn tallies<T: Wide>(rows: &[Row], least: f64) -> Vec<(String, Tally)> {
    let mut found: Vec<(String, Tally)> = Vec::new();
    for row in rows {
        if !row.fits(least) {
            continue;
        }
        for finder in row.finders() {
            let class = match (finder, row.motion) {
                (Finder::Search, Motion::Straight(_)) => format!("{}, searched", row.class),
                _ => row.class.clone(),
            };
            let judged = judge::<T>(row, *finder);
            match found.iter_mut().find(|(name, _)| *name == class) {
                Some((_, tally)) => tally.add(judged),
                None => {
                    let mut tally = Tally::default();
                    tally.add(judged);
                    found.push((class, tally));
                }
            }
        }
    }
    found
}

/// The table: a class a line.
pub fn table(tallies: &[(String, Tally)]) -> String {
    let mut text = format!(
        "{:42} {:>5} {:>5} {:>10} {:>10} {:>8} {:>7} {:>7}\n",
        "class", "rows", "hits", "err/input", "err/bound", "unclear", "missed", "ghosts"
    );
    for (class, t) in tallies {
        let _ = writeln!(
            text,
            "{class:42} {:>5} {:>5} {:>10.3} {:>10.3} {:>8} {:>7} {:>7}",
            t.rows, t.hits, t.over_input, t.over_bound, t.unclear, t.missed, t.ghosts
        );
    }
    text
}

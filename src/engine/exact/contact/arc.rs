//! The common motion of a group for a while: power series of every member, up to the next change.
//!
//! The series converge up to the nearest singularity: the end of a slip or of a roll whose direction turns, where `u/|u|` has no limit series. A
//! stretch ends well before one, by what its highest coefficients leave out, so a motion that turns towards its end takes a stretch for each fifth
//! or so of the time that is left, until what is left is rounding. Where nothing turns the series end by themselves, and one stretch is exact.

use super::equations::Equations;
use super::group::{Change, Group, Mode, loudest};
use crate::engine::exact::spin::Moving;
use crate::engine::exact::world::World;
use crate::math::Real;
use crate::math::series::{Node, Tape, at, reach, slope_at};

/// Orders of a series for each bit that it is to tell: so many that a quarter of the way to a singularity leaves nothing out.
const ORDERS: f64 = 0.5;

/// Bits that a series tells, at least.
const FEWEST: f64 = 16.0;

/// What a stretch leaves out of a position or a speed, in ulps of the largest.
const LEFT_OUT: f64 = 0.5;

/// Places at which a monitor is looked at within a stretch.
const LOOKS: usize = 8;

/// The sizes of all terms of a velocity add up to no more than this many times the largest speed at the start.
const BEYOND: f64 = 16.0;

/// What a derivative leaves out within a piece of a stretch, in parts of its size.
const SLOPES: f64 = 1e-12;

/// Pieces in which the derivatives of a stretch are told, at most.
const MOST_PIECES: usize = 200;

/// In this last part of a stretch they are told no more: a slip that ends there turns by what is left of it, and its logarithm, some 1e-7.
const NEAR_THE_END: f64 = 1e-8;

/// Units of time that are tried, each this part of the one before.
const UNITS: usize = 24;
const SHORTER: f64 = 1e-3;

/// Bisections and Newton steps, at most, for one root.
const STEPS: usize = 400;

/// One member during a stretch, by powers of the time since its start in units of its own.
#[derive(Clone, Debug)]
pub struct Series<T> {
    /// Index in scene order.
    pub ball: usize,
    /// One unit of the series' time, s.
    pub unit: T,
    /// Centre.
    pub position: [Vec<T>; 2],
    /// Velocity.
    pub velocity: [Vec<T>; 2],
    /// Spin.
    pub spin: [Vec<T>; 3],
    /// No faster than this, length/s.
    pub fastest: T,
    /// Acceleration no larger than this, length/s^2.
    pub strongest: T,
    /// How fast its acceleration changes, length/s^3, at most.
    pub jerk: f64,
    /// Whether it slips over the cloth.
    pub slides: bool,
    /// Series from later times on, s, whose derivatives are told farther than those of this one.
    slopes: Vec<(T, Series<T>)>,
}

impl<T: Real> Series<T> {
    /// How it moves `h` seconds after the start.
    pub fn at(&self, h: T) -> Moving<T> {
        let mut later = self.slopes.iter().rev();
        match later.find(|(start, _)| *start <= h) {
            Some((start, series)) => self.plain(h).following(&series.plain(h - *start)),
            None => self.plain(h),
        }
    }

    fn plain(&self, h: T) -> Moving<T> {
        let h = h / self.unit;
        Moving {
            position: [0, 1].map(|axis| at(&self.position[axis], h)),
            velocity: [0, 1].map(|axis| at(&self.velocity[axis], h)),
            spin: [0, 1, 2].map(|axis| at(&self.spin[axis], h)),
        }
    }

    /// How far its centre comes in `h` seconds after the start, length.
    fn advance(&self, h: T) -> [T; 2] {
        let h = h / self.unit;
        [0, 1].map(|axis| h * at(self.position[axis].get(1..).unwrap_or_default(), h))
    }

    /// Its acceleration `h` seconds after the start, length/s^2.
    pub fn acceleration(&self, h: T) -> [T; 2] {
        let h = h / self.unit;
        [0, 1].map(|axis| slope_at(&self.velocity[axis], h) / self.unit)
    }

    /// `h`: the length of the stretch in units of its time; `unit`: that unit, s.
    fn bounded(
        ball: usize,
        position: [Vec<T>; 2],
        velocity: [Vec<T>; 2],
        spin: [Vec<T>; 3],
        [h, unit]: [T; 2],
        slides: bool,
    ) -> Self {
        // the sums of the sizes of all terms at the end of the stretch bound every sum before it
        let bound = |series: &[Vec<T>; 2], derivative: usize| {
            let squares = series.iter().map(|series| {
                let mut sum = 0.0;
                for (order, coefficient) in series.iter().enumerate().skip(derivative) {
                    let falling: f64 = (order + 1 - derivative..=order).map(|k| k as f64).product();
                    let power = h.to_f64().powi((order - derivative) as i32);
                    sum += falling * coefficient.to_f64().abs() * power;
                }
                sum * sum
            });
            squares.sum::<f64>().sqrt() / unit.to_f64().powi(derivative as i32)
        };
        let above = 1.0 + 64.0 * f64::EPSILON;
        Series {
            ball,
            fastest: T::lift(bound(&velocity, 0) * above),
            strongest: T::lift(bound(&velocity, 1) * above),
            jerk: bound(&velocity, 2),
            unit,
            position,
            velocity,
            spin,
            slides,
            slopes: Vec::new(),
        }
    }
}

/// A stretch of the motion of a group.
#[derive(Clone, Debug)]
pub struct Arc<T> {
    /// Its length, s.
    pub length: T,
    /// The members.
    pub series: Vec<Series<T>>,
    /// What ends it; empty where the series ends before anything changes.
    pub changes: Vec<Change>,
    /// How far its derivatives are told by it, s.
    told: T,
}

impl<T: Real> Arc<T> {
    /// The next stretch of a group, no longer than `most`, s. `tick`: what the clock tells apart, s.
    pub fn of(world: &World<T>, group: &Group<T>, most: T, tick: T) -> Self {
        let most = most.at_most(world.longest);
        let (equations, unit) = solved(world, group, most);
        let tape = &equations.tape;
        let mut length = most / unit;
        let loudest = loudest(world, &group.members);
        let speed = loudest.to_f64();
        let part = LEFT_OUT * world.accuracy;
        for node in equations.velocity.iter().flatten() {
            length = length.at_most(T::lift(reach(tape.series(*node), speed, part)));
        }
        // friction between balls turns them where it hardly moves them
        for (member, nodes) in group.members.iter().zip(&equations.spin) {
            let turn = speed / world.radius[member.ball].to_f64();
            for node in nodes {
                length = length.at_most(T::lift(reach(tape.series(*node), turn, part)));
            }
        }
        // a sum of terms that is far beyond what balls have at the start does not converge
        let bound = |length: T| {
            let sizes = equations.velocity.iter().flatten();
            sizes.fold(0.0_f64, |most, node| {
                let terms = tape.series(*node).iter().rev();
                most.max(terms.fold(0.0, |sum, c| sum * length.to_f64() + c.to_f64().abs()))
            })
        };
        while bound(length) > BEYOND * speed {
            length *= T::lift(0.5);
        }
        let watched: Vec<(Change, &[T])> = equations
            .monitors
            .iter()
            .map(|monitor| (monitor.change, tape.series(monitor.node)))
            .collect();
        // what the cloth ends within a tick is over, too
        let none = world.over(loudest).at_least(world.strongest() * tick);
        let (mut length, mut changes) = first_change(&watched, length);
        while let Some(series) = misleads(world, group, &equations, &changes, length, none) {
            let size = at(series, T::zero()).to_f64();
            let believed = T::lift(reach(series, size, part));
            let shorter = believed.at_most(length * T::lift(0.5));
            (length, changes) = first_change(&watched, shorter);
        }
        let falls = !changes.is_empty();
        for change in over(&watched, length, none) {
            if !changes.contains(&change) {
                changes.push(change);
            }
        }
        if T::DIFFERENTIATES && falls {
            length = length.following(moves(&watched, &changes, length, world.estimates));
        }
        let series = group.members.iter().enumerate().map(|(i, member)| {
            let own = |nodes: &[Node]| -> Vec<Vec<T>> {
                nodes.iter().map(|node| trimmed(tape, *node)).collect()
            };
            let pair = |nodes: [Node; 2]| {
                let mut found = own(&nodes).into_iter();
                [
                    found.next().unwrap_or_default(),
                    found.next().unwrap_or_default(),
                ]
            };
            let [wx, wy, wz] = equations.spin[i];
            let [x, y] = pair([wx, wy]);
            Series::bounded(
                member.ball,
                pair(equations.position[i]),
                pair(equations.velocity[i]),
                [x, y, trimmed(tape, wz)],
                [length, unit],
                member.mode == Mode::Slides,
            )
        });
        Arc {
            series: series.collect(),
            told: told_slopes(&equations, length).detached() * unit.detached(),
            length: length * unit,
            changes,
        }
    }

    /// Whether it is made of numbers: a speed that turns within a time which no number holds is not.
    pub fn is_told(&self) -> bool {
        let told = |series: &Series<T>| {
            let mut each = series.velocity.iter().chain(&series.spin).flatten();
            each.all(|c| c.is_finite())
        };
        self.length.is_finite() && self.series.iter().all(told)
    }

    /// Goes on with derivatives where their series end before the stretch does. What moves along a line has series that end by themselves, up to where its
    /// slip ends; but aside of it the slip turns, and those of derivatives do not reach that far.
    pub fn tell_slopes(&mut self, world: &World<T>, group: &Group<T>) {
        let whole = self.length.detached();
        let mut group = group.clone();
        let mut at = self.told;
        let strongest = world.strongest().detached();
        let over = world.over(loudest(world, &group.members)).detached() / strongest;
        let least = (whole * T::lift(NEAR_THE_END)).at_least(over);
        for _ in 0..MOST_PIECES {
            if whole - at <= least {
                break;
            }
            for (member, series) in group.members.iter_mut().zip(&self.series) {
                member.moving = series.at(at);
            }
            let piece = Arc::of(world, &group, whole - at, T::zero());
            let told = piece.told.at_least(least);
            for (series, next) in self.series.iter_mut().zip(piece.series) {
                series.slopes.push((at, next));
            }
            at += told;
        }
        if whole - at > least {
            // they are not told to the end
            for series in &mut self.series {
                let mut last = series.clone();
                for input in 0..T::INPUTS {
                    last.unit = last.unit.nudged(input, f64::NAN);
                }
                series.slopes.push((at, last));
            }
        }
    }

    /// Puts members at their places at the end, with what those before could not tell; answers what these cannot.
    pub fn places(&self, beyond: &[[T; 2]], states: &mut [Moving<T>]) -> Vec<[T; 2]> {
        let mut left = Vec::with_capacity(states.len());
        for (i, (series, state)) in self.series.iter().zip(states).enumerate() {
            let come = series.advance(self.length);
            left.push([0, 1].map(|axis| {
                let start = series.position[axis].first().copied();
                let start = start.unwrap_or_else(T::zero);
                let come = come[axis] + beyond.get(i).map_or_else(T::zero, |place| place[axis]);
                let place = start + come;
                state.position[axis] = place.following(state.position[axis]);
                (come - (place - start)).detached()
            }));
        }
        left
    }

    /// How the members move at the end, with what ended there set.
    pub fn end(&self, world: &World<T>, group: &Group<T>) -> Vec<Moving<T>> {
        let mut states: Vec<Moving<T>> = self.series.iter().map(|s| s.at(self.length)).collect();
        for change in &self.changes {
            match *change {
                Change::Rolls(i) => {
                    let radius = world.radius[group.members[i].ball];
                    states[i].end_slip(radius);
                }
                Change::Stops(i) => {
                    states[i].velocity = [T::zero(); 2];
                    [states[i].spin[0], states[i].spin[1]] = [T::zero(); 2];
                }
                Change::Unspun(i) => states[i].spin[2] = T::zero(),
                _ => {}
            }
        }
        states
    }
}

/// How far the derivatives of velocities and spins are told, of a stretch of this length; both in units of the time.
fn told_slopes<T: Real>(equations: &Equations<T>, length: T) -> T {
    let nodes = || equations.velocity.iter().flatten();
    let turns = equations.spin.iter().flatten();
    let all: Vec<&[T]> = (nodes().chain(turns))
        .map(|node| equations.tape.series(*node))
        .collect();
    let mut told = length;
    for lane in 0..T::INPUTS {
        for series in &all {
            let slopes: Vec<f64> = series.iter().map(|c| c.partial(lane)).collect();
            let size = slopes.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
            if size > 0.0 && size.is_finite() {
                told = told.at_most(T::lift(reach(&slopes, size, SLOPES)));
            }
        }
    }
    told
}

/// The equations of a group with their series, and the unit of its time, s. Where a slip soon vanishes a coefficient can leave the range of numbers: then in
/// a shorter unit.
fn solved<T: Real>(world: &World<T>, group: &Group<T>, most: T) -> (Equations<T>, T) {
    let mut equations = group.equations(world);
    let mut unit = pace(world, &equations);
    let mut tries = UNITS;
    loop {
        let bits = bits(world, group, unit);
        equations
            .tape
            .solve(orders(bits, (most / unit).to_f64()), unit);
        let mut nodes = equations.velocity.iter().flatten();
        let mut spins = equations.spin.iter().flatten();
        let numbers = |node: &Node| equations.tape.series(*node).iter().all(|c| c.is_finite());
        if tries == 0 || (nodes.all(numbers) && spins.all(numbers)) {
            return (equations, unit);
        }
        tries -= 1;
        equations = group.equations(world);
        unit *= T::lift(SHORTER);
    }
}

/// Bits that the series of a group are to tell of what changes in a `unit` of time, s: a slip that is nearly over changes so little that few of them are
/// within the accuracy of the speeds.
fn bits<T: Real>(world: &World<T>, group: &Group<T>, unit: T) -> f64 {
    let changes = (world.strongest() * unit / loudest(world, &group.members)).to_f64();
    FEWEST.max(changes.min(1.0).log2() - world.accuracy.log2())
}

/// Orders of the series that tell `bits` of a stretch of no more than `length` of the time in which a group changes.
fn orders(bits: f64, length: f64) -> usize {
    let all = ORDERS * bits;
    // what is short needs fewer, and some in hand
    let few = if length < 0.25 {
        bits / -length.log2() + 4.0
    } else {
        all
    };
    all.min(few) as usize + 2
}

/// The time in which a group changes: that in which the first slip or roll would end, or in which a ball crosses another.
fn pace<T: Real>(world: &World<T>, equations: &Equations<T>) -> T {
    let strongest = world.strongest();
    let crossing = T::lift(world.widest_distance()) / world.fastest;
    let ends = equations.monitors.iter().filter_map(|monitor| {
        let ends = matches!(monitor.change, Change::Rolls(_) | Change::Stops(_));
        ends.then(|| equations.tape.value(monitor.node) / strongest)
    });
    // a slip that is none has a stretch of its own, and no pace
    let ends = ends.filter(|time| *time > T::zero());
    ends.fold(crossing, T::at_most)
}

/// The coefficients of a node without the zeros at the end.
fn trimmed<T: Real>(tape: &Tape<T>, node: Node) -> Vec<T> {
    let series = tape.series(node);
    let last = series.iter().rposition(|c| !c.is_nothing()).unwrap_or(0);
    series[..=last].to_vec()
}

/// The first time within `length` at which one of the monitors reaches zero, and all that do so then.
fn first_change<T: Real>(watched: &[(Change, &[T])], length: T) -> (T, Vec<Change>) {
    let mut first = length;
    let mut changes: Vec<(Change, T)> = Vec::new();
    for (change, series) in watched {
        if let Some(when) = falls(series, first) {
            first = first.at_most(when);
            changes.push((*change, when));
        }
    }
    let together = first * T::lift(1.0 + 1024.0 * T::ULP);
    let changes = changes.into_iter().filter(|(_, when)| *when <= together);
    (first, changes.map(|(change, _)| change).collect())
}

/// The series of a slip or a speed that falls to zero, at `length`, where the velocities and spins themselves say that more than `none` is left, length/s. The size of
/// what passes zero at a small distance turns there, and so its series converge no farther, while what it is the size of may go on smoothly: where the cloth takes next to nothing.
fn misleads<'a, T: Real>(
    world: &World<T>,
    group: &Group<T>,
    equations: &'a Equations<T>,
    changes: &[Change],
    length: T,
    none: T,
) -> Option<&'a [T]> {
    let tape = &equations.tape;
    let value = |node: Node| at(tape.series(node), length);
    let left = |change: Change| match change {
        Change::Stops(i) => Some(equations.velocity[i].map(value)),
        Change::Rolls(i) => {
            let member = &group.members[i];
            let moving = Moving {
                velocity: equations.velocity[i].map(value),
                spin: equations.spin[i].map(value),
                ..member.moving
            };
            Some(moving.slip(world.radius[member.ball]))
        }
        _ => None,
    };
    let mut monitors = equations.monitors.iter();
    let found = monitors.find(|monitor| {
        let left = changes
            .contains(&monitor.change)
            .then(|| left(monitor.change));
        left.flatten()
            .is_some_and(|[x, y]| (x * x + y * y).sqrt() > none)
    });
    found.map(|monitor| tape.series(monitor.node))
}

/// How the time of changes moves with what has derivatives. Of several at one time that move apart nobody can say which comes first, unless `any` will do.
fn moves<T: Real>(watched: &[(Change, &[T])], changes: &[Change], first: T, any: bool) -> T {
    let first = first.detached();
    let series = changes.iter().filter_map(|change| {
        let own = watched.iter().find(|(watched, _)| watched == change)?;
        Some(own.1)
    });
    let times = series.map(|series| first - at(series, first) / slope_at(series, first));
    let time = times.reduce(|time, own| if any { time } else { time.common(own) });
    time.unwrap_or(first)
}

/// When a series that is positive first falls to zero within `length`.
fn falls<T: Real>(series: &[T], length: T) -> Option<T> {
    let zero = T::zero();
    let mut low = zero;
    for look in 1..=LOOKS {
        let high = length * T::lift(look as f64 / LOOKS as f64);
        if at(series, high) <= zero {
            // what begins at zero and falls has fallen already
            if look == 1 && at(series, low) <= zero && slope_at(series, low) <= zero {
                return Some(zero);
            }
            return Some(root(series, low, high));
        }
        low = high;
    }
    None
}

/// A root between `low`, where the series is positive, and `high`, where it is not.
fn root<T: Real>(series: &[T], mut low: T, mut high: T) -> T {
    let half = T::lift(0.5);
    let mut t = (low + high) * half;
    for _ in 0..STEPS {
        let value = at(series, t);
        if value > T::zero() {
            low = t;
        } else {
            high = t;
        }
        let step = value / slope_at(series, t);
        let newton = t - step;
        let next = if newton > low && newton < high {
            newton
        } else {
            (low + high) * half
        };
        if (next - t).abs() <= T::lift(T::ULP) * t.abs() {
            return next;
        }
        t = next;
    }
    t
}

/// Slips and speeds that have shrunk to no more than `none` at the end of a stretch: those that turn while they end never fall to zero in a series.
fn over<T: Real>(watched: &[(Change, &[T])], length: T, none: T) -> Vec<Change> {
    let ended = watched.iter().filter(|(change, series)| {
        let left = at(series, length);
        let ends = matches!(change, Change::Rolls(_) | Change::Stops(_));
        ends && left <= none && left <= at(series, T::zero())
    });
    ended.map(|(change, _)| *change).collect()
}

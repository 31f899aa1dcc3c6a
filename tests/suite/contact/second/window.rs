//! What of a trace is held against the second method: the first contact, from before the impacts that lead to it to some time past its end.

use carom::trace::{Event, EventKind, Partner, Trace};

/// How long past the end of the contact the two methods are compared, s.
const PAST: f64 = 10e-3;

/// By how much the two methods may differ in the time of an impact, s.
const LATER: f64 = 1e-7;

/// How long before the limit of others the window ends, s: they meet at some 1e-5 m/s then.
const PILE: f64 = 1e-5;

/// Why a window ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Until {
    /// Some time past the end of the contact, or at the end of the trace.
    Past,
    /// A third ball hits one of the two while they press.
    Hit,
    /// The two meet again.
    Again,
    /// One of the balls meets a cushion or a pocket.
    Other,
    /// Impacts of one of them with yet another have a limit.
    Pile,
}

/// One contact with the balls that matter to it.
#[derive(Clone, Debug)]
pub struct Window {
    /// The two.
    pub pair: (usize, usize),
    /// All that matter, the two first, and up to when: what they meet later says nothing of the two, s.
    pub balls: Vec<(usize, f64)>,
    /// Before the first impact of the two, after all that happened before it, s.
    pub from: f64,
    /// When the contact begins and ends, s.
    pub begin: f64,
    pub end: f64,
    /// Up to when the methods are compared, s.
    pub to: f64,
    pub until: Until,
}

fn pair_of(kind: EventKind) -> Option<(usize, usize)> {
    match kind {
        EventKind::BallBall(a, b) | EventKind::ContactBegin(a, Partner::Ball(b)) => {
            Some((a as usize, b as usize))
        }
        _ => None,
    }
}

/// The impacts of a pair that come at shorter and shorter intervals up to its contact at `begin`, the last one first.
fn chain(trace: &Trace, pair: (usize, usize), begin: f64) -> Vec<f64> {
    let meets =
        |kind: EventKind| matches!(kind, EventKind::BallBall(..)) && pair_of(kind) == Some(pair);
    let events = trace.events.iter().rev();
    let hits = events.filter(|event| meets(event.kind) && event.time < begin);
    let (mut next, mut interval) = (begin, 0.0);
    let mut chain = Vec::new();
    for hit in hits {
        // where two times differ by their rounding nothing is said
        if next - hit.time + 64.0 * f64::EPSILON * begin < interval {
            break;
        }
        (next, interval) = (hit.time, next - hit.time);
        chain.push(next);
    }
    chain
}

/// The balls that have a say in what the two do until `to`: those that hit them, and those that hit these before.
fn cone(trace: &Trace, pair: (usize, usize), from: f64, to: f64) -> Vec<(usize, f64)> {
    let mut balls = vec![(pair.0, f64::INFINITY), (pair.1, f64::INFINITY)];
    let holds = |balls: &[(usize, f64)], ball: usize| balls.iter().any(|(other, _)| *other == ball);
    for event in trace.events.iter().rev() {
        if event.time <= from || event.time >= to {
            continue;
        }
        let EventKind::BallBall(a, b) = event.kind else {
            continue;
        };
        for (one, other) in [(a as usize, b as usize), (b as usize, a as usize)] {
            if holds(&balls, one) && !holds(&balls, other) {
                balls.push((other, event.time + LATER));
            }
        }
    }
    balls
}

/// The window of the first contact of a trace; `None` where there is none of two balls.
pub fn first(trace: &Trace) -> Option<Window> {
    let begins = |kind: EventKind| matches!(kind, EventKind::ContactBegin(..));
    let index = trace.events.iter().position(|event| begins(event.kind))?;
    let begin = trace.events[index].time;
    let pair = pair_of(trace.events[index].kind)?;
    let ends = EventKind::ContactEnd(pair.0 as u32, Partner::Ball(pair.1 as u32));
    let later = &trace.events[index + 1..];
    let end = later.iter().find(|event| event.kind == ends);
    let end = end.map_or(trace.end_time, |event| event.time);
    let mut window = Window {
        pair,
        balls: Vec::new(),
        from: begin,
        begin,
        end,
        to: trace.end_time.min(end + PAST),
        until: Until::Past,
    };
    // from before the first of them since which there is nothing but impacts of balls
    for start in chain(trace, pair, begin) {
        let before = trace.events.iter().rev().find(|event| event.time < start);
        let from = 0.5 * (before.map_or(0.0, |event| event.time) + start);
        window.balls = cone(trace, pair, from, begin);
        let mut since = trace
            .events
            .iter()
            .filter(|event| event.time > from && event.time < begin);
        if since.any(|event| window.leaves(event)) {
            break;
        }
        window.from = from;
    }
    loop {
        window.balls = cone(trace, pair, window.from, window.to);
        let within = later.iter().filter(|event| event.time < window.to);
        let mut stops = within.filter_map(|event| window.stop(trace, event));
        let Some((time, until)) = stops.next() else {
            return Some(window);
        };
        (window.to, window.until) = (time, until);
        if until == Until::Pile && time < end {
            // while they press a path is known at its knots
            let known = |ball: usize, time: f64| {
                let mut knots = trace.paths[ball].knots.iter();
                knots.any(|knot| knot.time == time)
            };
            let knots = trace.paths[pair.0].knots.iter().rev();
            let times = knots.map(|knot| knot.time);
            let mut common = times.filter(|at| *at <= time && known(pair.1, *at));
            window.to = common.next().unwrap_or(begin);
        }
        if window.to <= begin {
            return Some(window);
        }
    }
}

impl Window {
    /// Whether a trace goes on to where the window ends by itself.
    pub fn is_past(&self, trace: &Trace) -> bool {
        self.end + PAST <= trace.end_time
    }

    /// Whether a ball that matters does now.
    fn ours(&self, ball: usize, time: f64) -> bool {
        let mut all = self.balls.iter();
        all.any(|(other, until)| *other == ball && time <= *until)
    }

    /// Whether one of them meets what is no ball.
    fn leaves(&self, event: &Event) -> bool {
        match event.kind {
            EventKind::BallCushion(ball, _) | EventKind::Pocket(ball, _) => {
                self.ours(ball as usize, event.time)
            }
            _ => false,
        }
    }

    /// Whether the window ends with an event after the first of its contact, when, and why.
    fn stop(&self, trace: &Trace, event: &Event) -> Option<(f64, Until)> {
        let time = event.time;
        if self.leaves(event) {
            return Some((time, Until::Other));
        }
        let ours = |ball: usize| ball == self.pair.0 || ball == self.pair.1;
        match event.kind {
            EventKind::BallBall(a, b) => {
                let (one, other) = (ours(a as usize), ours(b as usize));
                if one && other && time > self.end {
                    // they meet again: before they do
                    let before = (0.1 * (time - self.end)).min(PILE);
                    return Some((time - before, Until::Again));
                }
                let hit = (one || other) && time <= self.end;
                hit.then_some((time, Until::Hit))
            }
            EventKind::ContactBegin(a, Partner::Ball(b)) => {
                let (a, b) = (a as usize, b as usize);
                // its impacts come ever faster: before they do
                let first = chain(trace, (a, b), time).last().copied();
                let before = (0.1 * (time - first.unwrap_or(time))).min(PILE);
                let matters = self.ours(a, time) || self.ours(b, time);
                matters.then_some((time - before, Until::Pile))
            }
            EventKind::ContactBegin(a, Partner::Cushion(_)) => {
                self.ours(a as usize, time).then_some((time, Until::Other))
            }
            _ => None,
        }
    }
}

//! What comes next: the earliest event that every ball knows of, and who may be a partner in it.
//!
//! An event of a pair is known to at least one of the two. A candidate whose partner has changed its course since is stale and is made
//! anew when its time comes; where there are many balls, one that leaves its square of the cells is listed in the next one.
//! Both are upkeep of the agenda and nothing of the trace, and [`Agenda::due`] tells them from events, so that nobody processes one as the
//! other. Whatever is foreseen is noted here only by [`Agenda::schedule`].

use super::cells::{Cells, ENOUGH_BALLS};
use super::kinematics::Kinematics;
use super::predict::{Row, Watch};
use super::queue::{Candidate, Queue, What};
use crate::math::Real;
use crate::physics::Side;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Which balls a prediction looks at. The trace is the same to the bit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Partners {
    /// Those nearby in scenes of many balls, all in others.
    #[default]
    Auto,
    /// All others.
    All,
    /// Those nearby.
    Cells,
}

/// What is to be done next.
#[derive(Clone, Copy, Debug)]
pub enum Due<T> {
    /// An event of the trace, and its time, s.
    Event(T, What),
    /// Something of the agenda's own, and its time, s: for [`Agenda::keep_up`].
    Upkeep(T, Upkeep),
    /// Nothing any more.
    Nothing,
}

/// What an agenda does for itself.
#[derive(Clone, Copy, Debug)]
pub enum Upkeep {
    /// The partner of a ball's next event has changed its course.
    Stale(usize),
    /// A ball goes on into the next square of the cells.
    Leaves(usize, Side),
}

/// Work done.
#[derive(Clone, Copy, Debug, Default)]
pub struct Work {
    /// Root searches.
    pub searches: u64,
    /// Balls that left their square of the cells.
    pub crossings: u64,
    /// Layouts of the cells.
    pub layouts: u64,
}

/// The next event of every ball.
#[derive(Clone, Debug)]
pub struct Agenda<T> {
    queue: Queue<T>,
    /// Who may meet whom, where there are many balls.
    cells: Option<Cells>,
    /// Whether balls have been held since the cells were laid out: what is held crosses their edges unnoticed.
    stale: bool,
    /// The partners of the prediction at hand.
    nearby: Vec<u32>,
    work: Work,
}

impl<T: Real> Agenda<T> {
    /// The agenda of balls that begin what they do now.
    pub fn new(balls: &Kinematics<'_, T>, partners: Partners) -> Self {
        let n = balls.count();
        let mut agenda = Agenda {
            queue: Queue::new(n),
            cells: None,
            stale: false,
            nearby: Vec::new(),
            work: Work::default(),
        };
        let cells = match partners {
            Partners::Auto => n >= ENOUGH_BALLS,
            Partners::All => false,
            Partners::Cells => true,
        };
        // balls that pass through each other need no partners
        if cells && balls.world().contact.is_some() {
            agenda.lay_out(balls);
            return agenda;
        }
        // each pair once: the row of the ball that comes later holds it
        for ball in 0..n {
            let row = Row::of(balls, ball);
            let next = row.next_event(0..ball, None, &mut agenda.work.searches);
            agenda.queue.set(ball, next);
        }
        agenda
    }

    /// Work done so far.
    pub fn work(&self) -> Work {
        self.work
    }

    /// What is to be done next.
    #[inline]
    pub fn due(&self, balls: &Kinematics<'_, T>) -> Due<T> {
        let (ball, next) = self.queue.first();
        Agenda::due_to(balls, ball, next)
    }

    #[inline]
    fn due_to(balls: &Kinematics<'_, T>, ball: usize, next: Candidate<T>) -> Due<T> {
        match next.what {
            What::Nothing => Due::Nothing,
            What::Leaving(a, side) => Due::Upkeep(next.time, Upkeep::Leaves(a as usize, side)),
            What::Pair(a, b) | What::UnclearPair(a, b) => {
                let other = if a as usize == ball { b } else { a };
                if balls.version(other as usize) == next.stamp {
                    Due::Event(next.time, next.what)
                } else {
                    Due::Upkeep(next.time, Upkeep::Stale(ball))
                }
            }
            What::Cushion(..)
            | What::UnclearCushion(..)
            | What::Pocket(..)
            | What::UnclearPocket(..)
            | What::End(_) => Due::Event(next.time, next.what),
        }
    }

    /// The next events of all balls, as far as they are known: their times, s, and what, the earliest first.
    pub fn pending(&self, balls: &Kinematics<'_, T>) -> Vec<(T, What)> {
        let each = self.queue.all().iter().enumerate();
        let due = each.filter_map(|(ball, next)| match Agenda::due_to(balls, ball, *next) {
            Due::Event(time, what) => Some((time, what)),
            Due::Upkeep(..) | Due::Nothing => None,
        });
        let mut pending: Vec<(T, What)> = due.collect();
        pending.sort_by(|(one, _), (other, _)| {
            one.partial_cmp(other).unwrap_or(std::cmp::Ordering::Equal)
        });
        pending
    }

    /// Whether an event is the next one of a ball.
    pub fn expects(&self, balls: &Kinematics<'_, T>, what: What) -> bool {
        what.balls().into_iter().any(|ball| {
            let next = self.queue.all()[ball];
            next.what == what && matches!(Agenda::due_to(balls, ball, next), Due::Event(..))
        })
    }

    /// Does what is due for the agenda itself.
    pub fn keep_up(&mut self, balls: &Kinematics<'_, T>, upkeep: Upkeep) {
        match upkeep {
            Upkeep::Stale(ball) => self.predict(&Row::of(balls, ball)),
            Upkeep::Leaves(ball, side) => {
                self.work.crossings += 1;
                let Some(cells) = &mut self.cells else {
                    return;
                };
                cells.cross(ball, side);
                if cells.worn_out() {
                    self.lay_out(balls);
                } else {
                    self.predict(&Row::of(balls, ball));
                }
            }
        }
    }

    /// Lays the cells out over where the balls are, and predicts the next event of each.
    #[cold]
    fn lay_out(&mut self, balls: &Kinematics<'_, T>) {
        let places = (0..balls.count()).map(|ball| balls.place(ball).map(T::to_f64));
        let places: Vec<[f64; 2]> = places.collect();
        self.work.layouts += 1;
        self.stale = false;
        let world = balls.world();
        let (widest, uncertainty) = (world.widest_distance(), world.position_uncertainty());
        self.cells = Some(Cells::over(&places, widest, uncertainty));
        for (ball, place) in places.into_iter().enumerate() {
            if let Some(cells) = &mut self.cells {
                cells.enter(ball, place);
            }
            self.predict(&Row::of(balls, ball));
        }
    }

    /// The next event of a row, of which nothing is noted here. `watch` is told what is near.
    pub fn foresee(&mut self, row: &Row<'_, T>, watch: Option<&mut Watch<T>>) -> Candidate<T> {
        let all = 0..row.balls().count();
        let searches = &mut self.work.searches;
        let Some(cells) = &mut self.cells else {
            return row.next_event(all, watch, searches);
        };
        self.stale |= row.balls().holds_any();
        if self.stale {
            return row.next_event(all, watch, searches);
        }
        let now = row.balls().now();
        let mut best = row.end();
        if row.flight().moves() {
            cells.leaving(row.ball(), row.flight(), now, &mut best);
        }
        // what is noted may be farther away than the squares tell
        let reach = watch.as_ref().map_or(0.0, |watch| watch.reach().to_f64());
        if reach <= cells.slack {
            cells.around(row.ball(), &mut self.nearby);
            let nearby = self.nearby.iter().map(|other| *other as usize);
            row.among(nearby, &mut best, watch, searches);
        } else {
            row.among(all, &mut best, watch, searches);
        }
        best.time = best.time.at_least(now);
        best
    }

    /// Notes the next event of a ball.
    #[inline]
    pub fn schedule(&mut self, ball: usize, next: Candidate<T>) {
        self.queue.set(ball, next);
    }

    /// Foresees and notes the next event of a row.
    pub fn predict(&mut self, row: &Row<'_, T>) {
        if self.stale && self.cells.is_some() && !row.balls().holds_any() {
            self.lay_out(row.balls());
            return;
        }
        let next = self.foresee(row, None);
        self.schedule(row.ball(), next);
    }

    /// Balls that may be within `gap` of a ball, by surfaces; itself included, in scene order.
    pub fn neighbours(&self, balls: &Kinematics<'_, T>, ball: usize, gap: T) -> Vec<usize> {
        match &self.cells {
            Some(cells) if !self.stale && gap.to_f64() <= cells.slack => cells.within_slack(ball),
            _ => (0..balls.count()).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::exact::spin::Moving;
    use crate::scene::{Scene, catalogue};

    fn scene() -> Scene {
        catalogue::scene("report-break").unwrap_or_else(|error| panic!("{error}"))
    }

    fn event(due: Due<f64>) -> (f64, What) {
        match due {
            Due::Event(time, what) => (time, what),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn what_is_foreseen_is_not_noted_until_it_is_scheduled() {
        let scene = scene();
        let balls = Kinematics::<f64>::new(&scene);
        let mut agenda = Agenda::new(&balls, Partners::All);
        let (time, what) = event(agenda.due(&balls));
        let What::Pair(cue, _) = what else {
            panic!("{what:?}");
        };
        // the cue ball hits what it hits in half the time if it is twice as fast
        let cue = cue as usize;
        let mut fast = balls.moving(cue);
        fast.velocity = fast.velocity.map(|v| 2.0 * v);
        let course = balls.course(cue, fast);
        let row = Row::setting_off(&balls, cue, &course.flight);
        let next = agenda.foresee(&row, None);
        assert!(next.what == what && next.time < 0.6 * time, "{next:?}");
        assert_eq!(event(agenda.due(&balls)), (time, what));
        agenda.schedule(cue, next);
        assert_eq!(event(agenda.due(&balls)), (next.time, what));
    }

    #[test]
    fn an_event_whose_partner_has_set_off_is_upkeep_and_no_event() {
        let scene = scene();
        let mut balls = Kinematics::<f64>::new(&scene);
        let mut agenda = Agenda::new(&balls, Partners::All);
        let (time, what) = event(agenda.due(&balls));
        let What::Pair(a, b) = what else {
            panic!("{what:?}");
        };
        let (holder, _) = agenda.queue.first();
        let partner = if a as usize == holder { b } else { a } as usize;
        // goes on exactly as it did
        let moving: Moving<f64> = balls.moving(partner);
        balls.set_off(partner, &balls.course(partner, moving));
        let Due::Upkeep(at, upkeep) = agenda.due(&balls) else {
            panic!("{:?}", agenda.due(&balls));
        };
        assert_eq!(at, time);
        assert!(matches!(upkeep, Upkeep::Stale(ball) if ball == holder));
        agenda.keep_up(&balls, upkeep);
        let (again, same) = event(agenda.due(&balls));
        assert_eq!(same, what);
        // the partner's path begins anew at time 0, with the same numbers
        assert_eq!(again, time);
    }
}

//! Which events of two runs are the same: those of one kind at the same place in the histories of their balls.
//!
//! Impacts that shrink to a contact are as many as the scalar tells, so the histories of two precisions get out of step there. Where the contact begins in
//! both they are in step again.

use crate::trace::{EventKind, Trace};

/// The histories of the balls of one run: its events, by index, one after the other.
struct Histories {
    kinds: Vec<EventKind>,
    times: Vec<f64>,
    of_ball: Vec<Vec<usize>>,
    /// Of each event its place in the histories of its balls.
    place: Vec<(usize, Option<usize>)>,
}

impl Histories {
    fn of(trace: &Trace) -> Self {
        let mut of_ball: Vec<Vec<usize>> = vec![Vec::new(); trace.balls.len()];
        let mut place = Vec::with_capacity(trace.events.len());
        for (index, event) in trace.events.iter().enumerate() {
            let (a, b) = event.kind.balls();
            let mut add = |ball: usize| {
                of_ball[ball].push(index);
                of_ball[ball].len() - 1
            };
            place.push((add(a), b.map(add)));
        }
        Histories {
            kinds: trace.events.iter().map(|event| event.kind).collect(),
            times: trace.events.iter().map(|event| event.time).collect(),
            of_ball,
            place,
        }
    }
}

/// Two runs, event by event.
pub struct Places {
    ours: Histories,
    theirs: Histories,
    /// How many events more the other run has had of each ball.
    ahead: Vec<isize>,
}

impl Places {
    /// Both from their starts.
    pub fn of(ours: &Trace, theirs: &Trace) -> Self {
        Places {
            ours: Histories::of(ours),
            theirs: Histories::of(theirs),
            ahead: vec![0; ours.balls.len()],
        }
    }

    /// The other run's event that is ours with this index.
    pub fn find(&self, index: usize) -> Option<usize> {
        let kind = self.ours.kinds[index];
        let (a, b) = kind.balls();
        let (first, second) = self.ours.place[index];
        let found = *self.theirs.of_ball[a].get(first.checked_add_signed(self.ahead[a])?)?;
        let place = b.zip(second);
        let place = place.map(|(b, second)| second.checked_add_signed(self.ahead[b]));
        let same = self.theirs.kinds[found] == kind
            && place.is_none_or(|place| place == self.theirs.place[found].1);
        same.then_some(found)
    }

    /// The same where the histories are out of step: the nearest of its kind within `error`, s. From there on they are in step.
    pub fn find_later(&mut self, index: usize, error: f64) -> Option<usize> {
        let (kind, time) = (self.ours.kinds[index], self.ours.times[index]);
        let (a, b) = kind.balls();
        let apart = |found: &usize| (self.theirs.times[*found] - time).abs();
        let of_ball = &self.theirs.of_ball[a];
        let near = of_ball.partition_point(|found| self.theirs.times[*found] < time - error);
        let near = of_ball[near..].iter().copied();
        let near = near.take_while(|found| self.theirs.times[*found] <= time + error);
        let same = near.filter(|found| self.theirs.kinds[*found] == kind);
        let found = same.min_by(|one, other| apart(one).total_cmp(&apart(other)))?;
        let (ours, theirs) = (self.ours.place[index], self.theirs.place[found]);
        self.ahead[a] = theirs.0 as isize - ours.0 as isize;
        if let (Some(b), Some(ours), Some(theirs)) = (b, ours.1, theirs.1) {
            self.ahead[b] = theirs as isize - ours as isize;
        }
        Some(found)
    }

    /// Whether the other run has no events beyond ours.
    pub fn all_told(&self) -> bool {
        let histories = self.ours.of_ball.iter().zip(&self.theirs.of_ball);
        let mut ends = histories.zip(&self.ahead);
        ends.all(|((ours, theirs), ahead)| ours.len() as isize + ahead == theirs.len() as isize)
    }
}

//! The next event of a ball while something is held or parts: the same as in `predict`, with what moves along a series searched by `meet`.

use super::held::Held;
use super::meet::{Gap, Path, between, closes, falls};
use crate::engine::exact::encounter::Encounter;
use crate::engine::exact::flight::Phase;
use crate::engine::exact::predict::{Row, Watch, later};
use crate::engine::exact::queue::{Candidate, What};
use crate::math::Real;
use crate::physics::Side;

impl<'a, T: Real> Row<'a, T> {
    /// The group that holds the ball of this row, if it does not set off.
    fn held(&self) -> Option<&'a Held<T>> {
        if self.flight.phase == Phase::Held {
            self.balls.contacts().of(self.ball)
        } else {
            None
        }
    }

    /// Whether the row is that of a ball on the course that it is on.
    fn goes_on(&self) -> bool {
        std::ptr::eq(self.flight, self.balls.flight(self.ball))
    }

    fn path(&self) -> Path<'a, T> {
        self.path_of(self.ball, self.flight)
    }

    fn path_of(
        &self,
        ball: usize,
        flight: &'a crate::engine::exact::flight::Flight<T>,
    ) -> Path<'a, T> {
        let held = match flight.phase {
            Phase::Held => self.balls.contacts().of(ball),
            _ => None,
        };
        match held.and_then(|held| Some((held.series(ball)?, held.start))) {
            Some((series, start)) => Path::Series(series, start),
            None => Path::Flight(flight),
        }
    }

    /// What rounding makes of the rate of a gap at time `t`, s, length/s.
    fn still(&self, parties: &[Path<'_, T>], t: T, distance: T) -> T {
        let speeds = parties.iter().map(|path| {
            let (_, [x, y]) = path.at(t);
            (x * x + y * y).sqrt()
        });
        let speed = speeds.fold(T::zero(), |sum, speed| sum + speed);
        self.balls.world().grain_of_rate(speed, distance)
    }

    /// Replaces `best` by an event that precedes it, where something is held or parts.
    #[cold]
    pub(in crate::engine::exact) fn among_contacts(
        &self,
        partners: impl IntoIterator<Item = usize>,
        best: &mut Candidate<T>,
        mut watch: Option<&mut Watch<T>>,
        searches: &mut u64,
    ) {
        let world = self.balls.world();
        let held = self.held();
        if let Some(held) = held {
            // the end of a stretch is the event of its first member
            let head = held.group.members.first().map(|member| member.ball);
            if head != Some(self.ball) {
                *best = Candidate {
                    time: world.duration,
                    ..Candidate::none()
                };
            }
        }
        if self.flight.moves() {
            self.cushions_beside(held, best, watch.as_deref_mut(), searches);
            if held.is_some() {
                self.pockets_beside(best, searches);
            } else if !world.pockets.is_empty() {
                self.pockets(best, searches);
            }
        }
        if world.contact.is_some() {
            let (beside, ordinary): (Vec<usize>, Vec<usize>) = partners
                .into_iter()
                .filter(|other| *other != self.ball)
                .partition(|other| self.is_beside(*other));
            self.partners(ordinary, best, watch.as_deref_mut(), searches);
            for other in beside {
                self.partner_beside(held, other, best, watch.as_deref_mut(), searches);
            }
        }
        if best.what == What::Nothing {
            *best = Candidate::none();
        }
    }

    /// Whether a pair is none for the finders.
    fn is_beside(&self, other: usize) -> bool {
        if self.flight.phase == Phase::Held {
            return true;
        }
        if other == self.mate {
            return false;
        }
        self.balls.is_held(other) || self.parts_from(other)
    }

    fn parts_from(&self, other: usize) -> bool {
        let pair = Encounter::Pair(self.ball.min(other), self.ball.max(other));
        self.goes_on() && self.balls.is_parting(pair)
    }

    /// From when to when a search goes, s.
    fn span(&self, best: &Candidate<T>, end: T) -> [T; 2] {
        let until = later(best.time)
            .at_most(end)
            .at_most(self.balls.world().duration);
        [self.balls.now().at_least(self.flight.start), until]
    }

    fn partner_beside(
        &self,
        held: Option<&Held<T>>,
        other: usize,
        best: &mut Candidate<T>,
        watch: Option<&mut Watch<T>>,
        searches: &mut u64,
    ) {
        let partner = match self.ahead {
            Some(ahead) if other == self.mate => ahead,
            _ if other == self.mate => return,
            _ => self.balls.flight(other),
        };
        let pair = Encounter::Pair(self.ball.min(other), self.ball.max(other));
        if held.is_some_and(|held| held.encounters().contains(&pair)) {
            return;
        }
        if !(self.flight.moves() || partner.moves()) && watch.is_none() {
            return;
        }
        let world = self.balls.world();
        let parting = self.parts_from(other);
        let [from, until] = self.span(best, self.flight.end.at_most(partner.end));
        let (at, falls) = between(
            self.path(),
            self.path_of(other, partner),
            world.distance(self.ball, other),
            [from, until],
        );
        if let Some(watch) = watch
            && !parting
            && at(from).0 <= watch.reach()
        {
            watch.note(pair);
        }
        *searches += 1;
        let gap = Gap {
            at: &at,
            falls,
            still: self.still(
                &[self.path(), self.path_of(other, partner)],
                from,
                world.distance(self.ball, other),
            ),
        };
        if let Some(time) = closes(&gap, [from, until], parting, &world.blur) {
            let (first, second) = (self.ball.min(other) as u32, self.ball.max(other) as u32);
            self.take(best, time, What::Pair(first, second), self.stamp(other));
        }
    }

    fn cushions_beside(
        &self,
        held: Option<&Held<T>>,
        best: &mut Candidate<T>,
        mut watch: Option<&mut Watch<T>>,
        searches: &mut u64,
    ) {
        let parts = |side| {
            let encounter = Encounter::Cushion(self.ball, side);
            self.goes_on() && self.balls.is_parting(encounter)
        };
        if held.is_none() && !Side::ALL.into_iter().any(parts) {
            self.cushions(best, watch, searches);
            return;
        }
        let world = self.balls.world();
        let Some(reach) = world.reach.get(self.ball) else {
            return;
        };
        let path = self.path();
        for side in Side::ALL {
            let encounter = Encounter::Cushion(self.ball, side);
            let touches = held.is_some_and(|held| held.encounters().contains(&encounter));
            if touches || self.except == Some(side) {
                continue;
            }
            let axis = side.axis();
            let outward = |x: T| if side.sign() < 0 { -x } else { x };
            let at = |t: T| {
                let (position, velocity) = path.at(t);
                let gap = outward(reach[side as usize] - position[axis]);
                (gap, -outward(velocity[axis]))
            };
            let [from, until] = self.span(best, self.flight.end);
            if let Some(watch) = watch.as_deref_mut()
                && !parts(side)
                && at(from).0 <= watch.reach()
            {
                watch.note(encounter);
            }
            *searches += 1;
            let gap = Gap {
                at: &at,
                falls: falls(path, Path::Place([T::zero(); 2]), [from, until]),
                still: self.still(&[self.path()], from, world.radius[self.ball]),
            };
            if let Some(time) = closes(&gap, [from, until], parts(side), &world.blur) {
                self.take(best, time, What::Cushion(self.ball as u32, side), 0);
            }
        }
    }

    fn pockets_beside(&self, best: &mut Candidate<T>, searches: &mut u64) {
        let world = self.balls.world();
        for (pocket, [x, y, radius]) in world.pockets.iter().enumerate() {
            let span = self.span(best, self.flight.end);
            let (at, falls) = between(self.path(), Path::Place([*x, *y]), *radius, span);
            *searches += 1;
            let gap = Gap {
                at: &at,
                falls,
                still: self.still(&[self.path()], span[0], *radius),
            };
            if let Some(time) = closes(&gap, span, false, &world.blur) {
                let what = What::Pocket(self.ball as u32, pocket as u32);
                self.take(best, time, what, 0);
            }
        }
    }

    fn take(&self, best: &mut Candidate<T>, time: T, what: What, stamp: u32) {
        let one = Candidate { time, what, stamp };
        if one.precedes(best) {
            *best = one;
        }
    }
}

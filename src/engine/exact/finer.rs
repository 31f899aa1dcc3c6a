//! The event loop's part where its scalar will soon no longer tell what happens: impacts that shrink to a limit.
//!
//! Two balls that the cloth presses together, one that knocks at a third meanwhile, a chain of them: the gaps between impacts sink below the rounding of a
//! coordinate long before their limit. No limit is looked for, which for several encounters together would be hard. The run goes on in the next scalar with
//! more digits, with all balls, by the same laws and into the same trace, until nothing slow happens any more. There an approach that is nothing to
//! the first scalar is taken out by impulses to which every ball answers as it rolls, slides or rests, and the contacts say what follows. That leaves an
//! error in proportion to the approach, some tenth of it, and no energy is gained. Where nested limits take very many impacts more and more is nothing, up to
//! what rounding of the first scalar makes of an approach.

use super::agenda::{Agenda, Due, Partners};
use super::collapse::Streaks;
use super::contact::decide::{member_but_for, resettle};
use super::contact::group::{Group, Member, Touch, Twist};
use super::contact::held::Held;
use super::contact::touching::{Steady, close_gaps, keep_contacts, touching};
use super::encounter::Encounter;
use super::kinematics::Kinematics;
use super::queue::What;
use super::solve::Loop;
use super::spin::Moving;
use super::stretch::stretch;
use super::world::{Coarser, NONE, SHRINKS, World};
use crate::engine::Limits;
use crate::math::Real;
use crate::trace::Ending;

/// What is left of a slip or a speed when the rest of an approach is over, in approaches, at most.
const OVER: f64 = 8.0;

/// Parties whose approach is nothing are no farther apart than this many of the ways in which the cloth takes it.
const NEAR: f64 = 4.0;

/// Events after which ten times as much is nothing.
const PATIENCE: u32 = 500;

/// Gaps of no more than this many errors of a position are none.
const CLOSED: f64 = 4.0;

/// It is over when nothing happens within this many times what a ball takes to get as fast as rounding lets an approach look.
const CALM: f64 = 1e3;

/// Events of a run in another scalar, at most.
const MOST_EVENTS: u32 = 200_000;

/// What one run hands over to another in another scalar.
struct Handover<T> {
    time: T,
    /// Balls in play that are not held.
    balls: Vec<Member<T>>,
    /// Balls that are held.
    groups: Vec<Group<T>>,
    /// Parties that part.
    parting: Vec<Encounter>,
}

/// What another run expects next, to which this one goes back for what it does not see: of balls that this one lets go on as they were.
struct Expected<T> {
    /// Times, s, and events, the earliest last.
    events: Vec<(T, What)>,
    /// The count of changes of each ball's course at the start.
    versions: Vec<u32>,
}

impl<T: Real> Expected<T> {
    /// Whether an event of balls that have gone on as they were comes before `time`, s, and this run does not know of it.
    fn is_missed(&mut self, time: T, balls: &Kinematics<'_, T>, agenda: &Agenda<T>) -> bool {
        while let Some((_, what)) = self.events.pop_if(|(next, _)| *next < time) {
            let as_they_were = |ball: &usize| balls.version(*ball) == self.versions[*ball];
            if what.balls().iter().all(as_they_were) && !agenda.expects(balls, what) {
                return true;
            }
        }
        false
    }
}

/// The same ball in another scalar, with what its mode makes of velocity and spin.
fn in_scalar<T: Real, U: Real>(world: &World<U>, m: &Member<T>) -> Member<U> {
    let moving = Moving {
        position: m.moving.position.map(T::widen),
        velocity: m.moving.velocity.map(T::widen),
        spin: m.moving.spin.map(T::widen),
    };
    let mut member = Member {
        ball: m.ball,
        moving,
        mode: m.mode,
        twist: m.twist,
    };
    resettle(world, &mut member, U::zero());
    member
}

impl<T: Real> Loop<'_, T> {
    /// An impact too slow for this scalar to tell how it goes on: another scalar takes over, or the parties touch from now on. Answers whether that ends the run.
    #[cold]
    pub(super) fn shrinks(&mut self, encounter: Encounter) -> Option<Ending> {
        if self.is_fine {
            return self.comes_to_touch(encounter);
        }
        self.blurred = true;
        None
    }

    /// Parties approach so slowly that it is nothing to the run that this one has taken over from: they touch, and so does everything about them that is as
    /// slow.
    fn comes_to_touch(&mut self, encounter: Encounter) -> Option<Ending> {
        let world = self.balls.world();
        let steady = Steady {
            near: (world.touching)
                .at_least(self.slow * self.slow / world.strongest() * T::lift(NEAR)),
            slow: self.slow * T::lift(2.0),
            roundings: 0.0,
        };
        let mut gathered = self.connected(encounter, &steady);
        let still = self.slow * T::lift(OVER);
        let before = if T::DIFFERENTIATES {
            gathered.members.clone()
        } else {
            Vec::new()
        };
        for m in &mut gathered.members {
            *m = member_but_for(world, m.ball, m.moving, still);
        }
        keep_contacts(world, &mut gathered.members, &gathered.touches);
        if T::DIFFERENTIATES {
            self.note_taken(&before, &gathered.touches);
        }
        self.touches(encounter, gathered)
    }

    /// What is at hand goes on in the next scalar with more digits until it is over; answers whether that ends the run.
    #[cold]
    #[inline(never)]
    pub(super) fn finer(mut self, what: What, limits: &Limits<'_>) -> (Option<Ending>, Self) {
        self.blurred = false;
        self.journal.hands_over();
        let world = self.balls.world();
        let patience = T::lift(CALM) * world.noise() / world.strongest();
        let closed = self.closed(&what.balls());
        let mut events = self.agenda.pending(&self.balls);
        events.retain(|(_, expected)| *expected != what);
        events.reverse();
        let given = self.hand_over();
        let from = Coarser {
            ulp: T::ULP,
            noise: self.balls.world().noise().widen(),
            longest: patience.widen(),
        };
        let (scene, now) = (self.balls.scene(), given.time.widen());
        let mut balls = Kinematics::<T::Finer>::taking_over(scene, now, &from);
        let mut derived = self.derived.take();
        if let Some(derived) = &derived {
            balls = balls.in_world(|world| derived.of_world(scene, world));
        }
        take_up(&mut balls, &given, &closed);
        let nothing = balls.world().none;
        let most = nothing * T::Finer::lift(1.0 / NONE);
        let versions = (0..balls.count()).map(|ball| balls.version(ball));
        let mut expected = Expected {
            events: (events.into_iter())
                .map(|(time, what)| (time.widen(), what))
                .collect(),
            versions: versions.collect(),
        };
        if let Some(derived) = &mut derived {
            derived.look_at(&balls);
        }
        let mut fine = Loop {
            agenda: Agenda::new(&balls, Partners::Auto),
            streaks: Streaks::new(balls.count()),
            slow: nothing,
            begun: std::mem::take(&mut self.begun),
            is_open: false,
            is_fine: true,
            blurred: false,
            derived,
            balls,
            journal: self.journal.handed_over(),
        };
        let (events, mut ending) = match fine.untold() {
            None => fine.until_calm(from.longest, most, &mut expected, limits),
            untold => (0, untold),
        };
        let mut taken = fine.hand_over();
        let changed = |ball: usize| fine.balls.version(ball) != expected.versions[ball];
        taken.balls.retain(|m| changed(m.ball));
        let mut coarse = Loop {
            journal: fine.journal.handed_over(),
            begun: fine.begun,
            derived: fine.derived,
            ..self
        };
        if let Some(derived) = &mut coarse.derived {
            derived.look_at(&coarse.balls);
        }
        coarse.balls.advance(taken.time.widen());
        let set_off = take_up(&mut coarse.balls, &taken, &[]);
        ending = ending.or_else(|| coarse.untold());
        coarse.predict_all(&set_off);
        if events == 0 && ending.is_none() {
            // it does not see what this one sees, which is then for this one to say
            let slow = std::mem::replace(&mut coarse.slow, T::zero());
            ending = coarse.happen(what);
            coarse.slow = slow;
        }
        (ending, coarse)
    }

    /// Everything for another run to go on with; no ball is held any more.
    fn hand_over(&mut self) -> Handover<T> {
        let free = (0..self.balls.count()).filter(|ball| !self.balls.is_held(*ball));
        let member = |ball| {
            Some(Member {
                ball,
                moving: self.balls.moving(ball),
                mode: self.balls.mode(ball)?,
                twist: Twist::Free,
            })
        };
        let balls = free.filter_map(member).collect();
        let mut groups = Vec::new();
        while let Some(head) = self.balls.contacts().held().first() {
            let Some(held) = self.balls.let_go(head.group.members[0].ball) else {
                break;
            };
            self.journal.stretch(&self.balls, &held);
            let members = held.group.members.iter().map(|m| Member {
                moving: self.balls.state_in(&held, m.ball),
                ..*m
            });
            groups.push(Group {
                members: members.collect(),
                holds: held.group.holds.clone(),
            });
        }
        Handover {
            time: self.balls.now(),
            balls,
            groups,
            parting: self.balls.parting(),
        }
    }

    /// The encounters whose gap is none, of balls that are connected with `seeds`, of those that are held, and of those that part.
    fn closed(&self, seeds: &[usize]) -> Vec<Encounter> {
        let world = self.balls.world();
        let steady = Steady {
            near: world.blur.length * T::lift(CLOSED),
            slow: T::lift(f64::INFINITY),
            roundings: 0.0,
        };
        let mut balls = seeds.to_vec();
        let near = |encounter: &Encounter| self.balls.gap(*encounter).abs() <= steady.near;
        let parting = self.balls.parting().into_iter();
        let mut found: Vec<Encounter> = parting.filter(near).collect();
        for held in self.balls.contacts().held() {
            found.extend(held.encounters());
        }
        let mut next = 0;
        while let Some(&ball) = balls.get(next) {
            next += 1;
            for encounter in touching(&self.balls, &self.agenda, ball, &steady) {
                if !found.contains(&encounter) {
                    found.push(encounter);
                }
                for other in encounter.balls() {
                    if !balls.contains(&other) {
                        balls.push(other);
                    }
                }
            }
        }
        found
    }

    /// Runs until nothing slow happens for `patience`, s, or something `expected` is missed, taking more and more of an approach for nothing, up to `most`, length/s;
    /// answers how many events that took, and whether they end the run.
    fn until_calm(
        &mut self,
        patience: T,
        most: T,
        expected: &mut Expected<T>,
        limits: &Limits<'_>,
    ) -> (u32, Option<Ending>) {
        let mut since = self.balls.now();
        let mut events = 0;
        loop {
            match self.agenda.due(&self.balls) {
                Due::Nothing => return (events, None),
                Due::Upkeep(time, _) | Due::Event(time, _)
                    if events > 0 && time > since + patience =>
                {
                    return (events, None);
                }
                Due::Upkeep(time, upkeep) => {
                    self.balls.advance(time);
                    self.agenda.keep_up(&self.balls, upkeep);
                }
                Due::Event(time, _) if expected.is_missed(time, &self.balls, &self.agenda) => {
                    return (events, None);
                }
                Due::Event(time, what) => {
                    let time = if T::DIFFERENTIATES {
                        if self.is_past(time) {
                            return (events.max(1), Some(Ending::Cancelled));
                        }
                        self.moved(time, what)
                    } else {
                        time
                    };
                    self.balls.advance(time);
                    let over = events > 0 && self.is_fast(what);
                    if over || self.journal.events() >= limits.max_events || limits.is_cancelled() {
                        return (events, None);
                    }
                    events += 1;
                    if !self.continues(what) {
                        since = time;
                    }
                    let ending = self.happen(what);
                    if T::DIFFERENTIATES {
                        self.note();
                    }
                    if ending.is_some() {
                        return (events, ending);
                    }
                    if events % PATIENCE == 0 {
                        self.slow = (self.slow * T::lift(10.0)).at_most(most);
                    }
                    if events > MOST_EVENTS {
                        let why = "impacts of several encounters shrink together without end";
                        let spot = self.balls.spot(&what.balls(), why);
                        return (events, Some(Ending::Collapsed(spot)));
                    }
                }
            }
        }
    }

    /// Whether an event is only the end of a stretch after which a group goes on as before.
    fn continues(&self, what: What) -> bool {
        match what {
            What::End(ball) => {
                let held = self.balls.contacts().of(ball as usize);
                held.is_some_and(|held| held.arc.changes.is_empty())
            }
            _ => false,
        }
    }

    /// Whether an event is none of those that shrink together.
    fn is_fast(&self, what: What) -> bool {
        match what {
            What::Pocket(..) | What::UnclearPocket(..) => true,
            _ => encounter_of(what).is_some_and(|encounter| {
                let least = self.balls.world().fastest * T::lift(SHRINKS);
                -self.balls.rate(encounter) >= least
            }),
        }
    }
}

/// The parties of an event that meet.
fn encounter_of(what: What) -> Option<Encounter> {
    match what {
        What::Pair(a, b) | What::UnclearPair(a, b) => Some(Encounter::Pair(a as usize, b as usize)),
        What::Cushion(a, side) | What::UnclearCushion(a, side) => {
            Some(Encounter::Cushion(a as usize, side))
        }
        _ => None,
    }
}

/// Puts balls on the courses that another run has left them on; answers which. `closed`: encounters whose gap is none.
fn take_up<T: Real, U: Real>(
    balls: &mut Kinematics<'_, U>,
    given: &Handover<T>,
    closed: &[Encounter],
) -> Vec<usize> {
    let world = balls.world().clone();
    let grouped = given.groups.iter().flat_map(|group| &group.members);
    let all = given.balls.iter().chain(grouped);
    let mut all: Vec<Member<U>> = all.map(|m| in_scalar(&world, m)).collect();
    let touches = closed.iter();
    let touches: Vec<Touch> = touches.filter_map(|e| Touch::of(*e, &all)).collect();
    close_gaps(&world, &mut all, &touches);
    let (free, grouped) = all.split_at(given.balls.len());
    for m in free {
        let course = balls.course(m.ball, m.moving);
        balls.set_off(m.ball, &course);
    }
    let mut grouped = grouped.iter().copied();
    for group in &given.groups {
        let mut group = Group {
            members: grouped.by_ref().take(group.members.len()).collect(),
            holds: group.holds.clone(),
        };
        let touches = group.touches();
        keep_contacts(&world, &mut group.members, &touches);
        balls.hold(Held {
            arc: stretch(balls, &group),
            group,
            start: balls.now(),
            stuck: 0,
            unchanged: 0,
            beyond: Vec::new(),
        });
    }
    for encounter in &given.parting {
        balls.part(*encounter);
    }
    all.iter().map(|m| m.ball).collect()
}

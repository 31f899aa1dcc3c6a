//! The event loop's part in contacts that last: accumulations, stretches of common motion, and impacts into what is held.

use super::agenda::Agenda;
use super::cluster_impact::ClusterImpact;
use super::contact::arc::{Arc, Series};
use super::contact::decide::{Undetermined, decide, member, settle};
use super::contact::group::{Change, Group, Hold, Member, Mode, Touch, Twist};
use super::contact::held::{Held, Next, Way, encounter};
use super::contact::tail;
use super::flight::{Flight, Phase};
use super::impact::Impact;
use super::journal::Passage;
use super::kinematics::Kinematics;
use super::predict::{Encounter, Row};
use super::queue::What;
use super::simultaneous::{self, Cluster};
use super::solve::Loop;
use super::spin::Moving;
use crate::math::Real;
use crate::physics::Side;
use crate::trace::{Ending, Partner};
use nalgebra::Vector3;

/// Below this part of the largest speed an impact may be one of an accumulation.
pub const SLOW: f64 = 1e-3;

/// An accumulation is left to its limit when an approach is this many times what rounding makes of one.
const NOISE: f64 = 100.0;

/// Parties that touch and approach or part by no more than this many roundings of the fastest ball do neither.
const STEADY: f64 = 64.0;

/// Two answers for one limit are the same if velocities differ by no more than this part of the approach.
const SAME: f64 = 1e-2;

/// The way to a limit is followed if what the approach does to it is this many errors of a position.
const RESOLVED: f64 = 64.0;

/// On the way to a limit no ball is faster or slower by more than this many approaches, and what the cloth does.
const NEAR: f64 = 32.0;

/// Rounds in which what is left of approaches at a limit is taken out.
const ROUNDS: usize = 200;

/// A stretch may be this many times what is left of the run.
const PAST_THE_END: f64 = 1.0 + 1e-6;

/// Stretches without length after which a group does not get on.
const STUCK: u32 = 64;

/// Where an accumulation leads, as found at the first of its impacts that was slow enough to ask.
#[derive(Clone, Debug)]
pub struct Foreseen<T> {
    encounter: Encounter,
    /// When, s.
    time: T,
    states: Vec<Moving<T>>,
}

impl<T: Real> Foreseen<T> {
    /// Whether the velocities at both limits are the same within `speed`, length/s.
    fn agrees(&self, other: &Self, speed: T) -> bool {
        let pairs = self.states.iter().zip(&other.states);
        pairs
            .clone()
            .all(|(a, b)| (0..2).all(|i| (a.velocity[i] - b.velocity[i]).abs() <= speed))
    }
}

/// Balls that touch, taken out of their courses.
pub(super) struct Gathered<T> {
    members: Vec<Member<T>>,
    touches: Vec<Touch>,
    /// The contacts that held until now.
    held: Vec<Encounter>,
}

impl<T: Real> Loop<'_, T> {
    /// An impact that may be one of an accumulation: puts its balls on the way to the limit, if there is one and nothing else comes before it.
    #[cold]
    #[inline(never)]
    pub(super) fn accumulates<const N: usize>(&mut self, impact: &Impact<T, N>) -> bool {
        let (encounter, closing) = (impact.encounter, impact.closing);
        let states = impact.sides.each_ref().map(|side| Moving {
            position: side.position,
            velocity: side.before,
            spin: side.spin_before,
        });
        let now = self.balls.now();
        let Some(limit) = tail::limit(self.balls.world(), encounter, &states) else {
            return false;
        };
        let found = Foreseen {
            encounter,
            time: now + limit.after,
            states: limit.states,
        };
        // the first answer sees least of the rounding of gaps; it stands while the impacts go as it says
        let known = self.foreseen.iter().find(|known| {
            known.encounter == found.encounter
                && (known.time - found.time).abs() <= limit.after * T::lift(SLOW)
                && known.time > now
                && known.agrees(&found, closing * T::lift(SAME))
        });
        let chosen = known.cloned().unwrap_or(found);
        let others = |known: &Foreseen<T>| known.time > now && known.encounter != encounter;
        self.foreseen.retain(others);
        self.foreseen.push(chosen.clone());
        if !self.is_noise(closing) {
            return false;
        }
        let balls = impact.sides.iter().map(|side| side.ball);
        let ends: Vec<(usize, Moving<T>)> = balls.zip(chosen.states).collect();
        let Some(passages) = self.way_to(&ends, &[encounter], [chosen.time, closing]) else {
            return false;
        };
        self.go_to_limit(
            encounter,
            &passages,
            &[encounter],
            chosen.time,
            limit.impacts,
        );
        true
    }

    /// Whether parties that touch neither approach nor part, but for rounding.
    pub(super) fn is_still(&self, closing: T) -> bool {
        closing <= self.balls.world().blur.speed * T::lift(STEADY)
    }

    /// Whether an approach is so slow that rounding will soon say how it goes on.
    fn is_noise(&self, closing: T) -> bool {
        let world = self.balls.world();
        let noise = (world.blur.length * world.strongest() * T::lift(2.0)).sqrt();
        closing <= noise * T::lift(NOISE)
    }

    /// The straight way of balls to their limit at `time`, s; `None` if it is not near what they do, or something else comes before.
    fn way_to(
        &mut self,
        ends: &[(usize, Moving<T>)],
        encounters: &[Encounter],
        [time, closing]: [T; 2],
    ) -> Option<Vec<Passage<T>>> {
        let now = self.balls.now();
        let after = time - now;
        let world = self.balls.world();
        if after <= T::zero() || time > world.duration {
            return None;
        }
        // where the way is so short that its rounding tells, the balls are there at once
        let resolved = after * closing > world.blur.length * T::lift(RESOLVED);
        let most = closing * T::lift(NEAR) + world.strongest() * after * T::lift(2.0);
        let mut passages = Vec::new();
        for (ball, end) in ends {
            let start = self.balls.moving(*ball);
            let two = T::lift(2.0);
            let way = [0, 1].map(|i| end.position[i] - start.position[i]);
            // through both ends with a constant acceleration
            let through = [0, 1].map(|i| way[i] / after * two - end.velocity[i]);
            let leaving = if resolved { through } else { end.velocity };
            let near = |v: [T; 2]| (0..2).all(|i| (v[i] - start.velocity[i]).abs() <= most);
            if !near(leaving) || !near(end.velocity) {
                return None;
            }
            let change = |from: T, to: T| {
                if resolved {
                    (to - from) / after
                } else {
                    T::zero()
                }
            };
            passages.push(Passage {
                ball: *ball,
                before: start,
                leaving: Moving {
                    velocity: leaving,
                    ..start
                },
                acceleration: [0, 1].map(|i| change(leaving[i], end.velocity[i])),
                rate: [0, 1, 2].map(|i| change(start.spin[i], end.spin[i])),
                end: *end,
            });
        }
        let comes = passages
            .iter()
            .any(|passage| self.comes_before(passage, encounters, time));
        (!comes).then_some(passages)
    }

    /// Whether an event of a ball on its way to a limit, besides its `encounters`, comes before `time`, s.
    fn comes_before(&mut self, passage: &Passage<T>, encounters: &[Encounter], time: T) -> bool {
        let Passage { ball, leaving, .. } = *passage;
        let size = |[x, y]: [T; 2]| (x * x + y * y).sqrt();
        let flight = Flight {
            start: self.balls.now(),
            end: T::lift(f64::INFINITY),
            position: leaving.position,
            velocity: leaving.velocity,
            acceleration: passage.acceleration,
            fastest: size(leaving.velocity).at_least(size(passage.end.velocity)),
            phase: Phase::Curve,
        };
        let row = Row::setting_off(&self.balls, ball, &flight);
        let row = match encounters {
            [one] => row.without(*one),
            _ => row,
        };
        let next = self.agenda.foresee(&row, None);
        let own = match next.what {
            What::Pair(a, b) => encounters.contains(&Encounter::Pair(a as usize, b as usize)),
            What::Cushion(a, side) => encounters.contains(&Encounter::Cushion(a as usize, side)),
            _ => false,
        };
        next.time <= time && !own
    }

    /// Puts balls on their way to a limit at `time`, s, of these encounters.
    fn go_to_limit(
        &mut self,
        encounter: Encounter,
        passages: &[Passage<T>],
        encounters: &[Encounter],
        time: T,
        impacts: u32,
    ) {
        let now = self.balls.now();
        let after = time - now;
        self.journal
            .accumulation(&self.balls, encounter, passages, impacts);
        let place = |ball: usize| passages.iter().position(|p| p.ball == ball).unwrap_or(0);
        let holds = encounters.iter().map(|encounter| Hold {
            touch: match *encounter {
                Encounter::Pair(a, b) => Touch::Pair(place(a), place(b)),
                Encounter::Cushion(a, side) => Touch::Cushion(place(a), side),
            },
            pressed: true,
        });
        let members = passages.iter().map(|p| Member {
            ball: p.ball,
            moving: p.leaving,
            mode: Mode::Floats,
            twist: Twist::Free,
        });
        let series = passages
            .iter()
            .map(|p| Series::straight(p.ball, &p.leaving, p.acceleration, p.rate, after));
        self.hold(Held {
            group: Group {
                holds: holds.collect(),
                members: members.collect(),
            },
            arc: Arc {
                length: after,
                series: series.collect(),
                changes: Vec::new(),
            },
            start: now,
            next: Next::Limit(Way {
                encounter: match encounters {
                    [one] => Some(*one),
                    _ => None,
                },
                before: passages.iter().map(|p| p.before).collect(),
                ends: passages.iter().map(|p| p.end).collect(),
            }),
            stuck: 0,
        });
    }

    /// Takes up a group and predicts what its balls meet.
    fn hold(&mut self, held: Held<T>) {
        let balls: Vec<usize> = held.group.members.iter().map(|m| m.ball).collect();
        self.balls.hold(held);
        self.predict_all(&balls);
    }

    /// Predicts the next events of balls that have set off together.
    fn predict_all(&mut self, balls: &[usize]) {
        for ball in balls {
            self.agenda.predict(&Row::of(&self.balls, *ball));
        }
    }

    /// A stretch of a group ends.
    #[cold]
    #[inline(never)]
    pub(super) fn stretch_end(&mut self, ball: usize) -> Option<Ending> {
        let held = self.balls.let_go(ball)?;
        self.journal.stretch(&self.balls, &held);
        let encounters = held.encounters();
        let world = self.balls.world();
        if let Next::Limit(way) = &held.next {
            self.journal
                .passed(&self.balls, &held.group.members, &way.before, &way.ends);
            let states = way.ends.iter().copied();
            let members = held.group.members.iter().zip(states);
            let members = members.map(|(m, state)| member(world, m.ball, state));
            let members: Vec<Member<T>> = members.collect();
            for m in members.iter().filter(|m| m.mode == Mode::Rests) {
                self.journal.stop(&self.balls, m);
            }
            let gathered = Gathered {
                members,
                touches: held.group.holds.iter().map(|hold| hold.touch).collect(),
                held: Vec::new(),
            };
            return self.go_on(gathered, &[], &[], 0);
        }
        let mut states = held.arc.end(world, &held.group);
        keep_contacts(world, &held.group, &mut states);
        let changes = held.arc.changes.clone();
        let mut group = held.group;
        for (member, state) in group.members.iter_mut().zip(&states) {
            member.moving = *state;
        }
        if changes.is_empty() {
            self.hold(Held {
                arc: self.stretch(&group),
                group,
                start: self.balls.now(),
                next: Next::Motion,
                stuck: held.stuck,
            });
            return None;
        }
        let stuck = if held.arc.length > T::zero() {
            0
        } else {
            held.stuck + 1
        };
        let mut gone = Vec::new();
        for change in &changes {
            match *change {
                Change::Rolls(i) => group.members[i].mode = self.ends_slip(&group.members[i]),
                Change::Stops(i) => group.members[i].mode = Mode::Rests,
                Change::Unspun(i) => group.members[i].twist = Twist::Held,
                Change::Released(k) | Change::Opens(k) => gone.push(group.holds[k].touch),
                Change::Presses(_) | Change::Slips(_) | Change::Breaks(_) | Change::Twists(_) => {}
            }
        }
        self.journal
            .changes(&self.balls, &held.arc, &group, &changes);
        let gathered = Gathered {
            touches: group.holds.iter().map(|hold| hold.touch).collect(),
            members: group.members,
            held: encounters,
        };
        self.go_on(gathered, &gone, &changes, stuck)
    }

    /// What a member does whose slip has ended.
    fn ends_slip(&self, m: &Member<T>) -> Mode {
        member(self.balls.world(), m.ball, m.moving).mode
    }

    fn stretch(&self, group: &Group<T>) -> Arc<T> {
        let world = self.balls.world();
        // a stretch that reaches the end of the run ends after it, which is no event
        let most = (world.duration - self.balls.now()) * T::lift(PAST_THE_END);
        Arc::of(world, group, most)
    }

    /// Decides how balls go on that touch, and lets them. `gone`: contacts whose force has vanished; `changes`: what else has just happened.
    pub(super) fn go_on(
        &mut self,
        gathered: Gathered<T>,
        gone: &[Touch],
        changes: &[Change],
        stuck: u32,
    ) -> Option<Ending> {
        let Gathered {
            members,
            touches,
            held,
        } = gathered;
        let named = |members: &[Member<T>], touch: &Touch| encounter_of(members, *touch);
        let before: Vec<Encounter> = touches.iter().map(|t| named(&members, t)).collect();
        if stuck > STUCK {
            let balls: Vec<usize> = members.iter().map(|m| m.ball).collect();
            let why = "balls in contact change their states again and again without time passing";
            return Some(Ending::Collapsed(self.balls.spot(&balls, why)));
        }
        let world = self.balls.world();
        let decision = match decide(world, members.clone(), &touches, gone, changes) {
            Ok(decision) => decision,
            Err(undetermined) => {
                return Some(self.undetermined(&undetermined, &members, &touches));
            }
        };
        let members = decision.group.members.clone();
        let mut free: Vec<usize> = Vec::new();
        let mut balls: Vec<usize> = Vec::new();
        let mut lasting: Vec<Encounter> = Vec::new();
        for group in components(&decision.group) {
            balls.extend(group.members.iter().map(|m| m.ball));
            let rests = group.members.iter().all(|m| m.mode == Mode::Rests);
            if group.holds.is_empty() || rests {
                free.extend(group.members.iter().map(|m| m.ball));
                for m in &group.members {
                    self.balls
                        .set_off(m.ball, &self.balls.course(m.ball, m.moving));
                }
                continue;
            }
            lasting.extend(group.holds.iter().map(|hold| encounter(&group, hold.touch)));
            let arc = self.stretch(&group);
            self.balls.hold(Held {
                arc,
                group,
                start: self.balls.now(),
                next: Next::Motion,
                stuck,
            });
        }
        for touch in &decision.parting {
            self.balls.part(encounter_of(&members, *touch));
        }
        self.tell(&before, &held, &lasting);
        self.predict_all(&balls);
        None
    }

    /// Whether two of these balls came to touch during this run.
    #[cold]
    pub(super) fn has_begun(&self, balls: &[usize]) -> bool {
        self.begun.iter().any(|encounter| match *encounter {
            Encounter::Pair(a, b) => balls.contains(&a) && balls.contains(&b),
            Encounter::Cushion(a, _) => balls.contains(&a),
        })
    }

    fn begin(&mut self, encounter: Encounter) {
        if !self.begun.contains(&encounter) {
            self.begun.push(encounter);
        }
    }

    /// Writes down which contacts began and which ended.
    fn tell(&mut self, before: &[Encounter], held: &[Encounter], lasting: &[Encounter]) {
        for encounter in before {
            let was = held.contains(encounter);
            let is = lasting.contains(encounter);
            if !was {
                self.begin(*encounter);
                self.journal.contact(&self.balls, *encounter, true);
            }
            if !is {
                self.journal.contact(&self.balls, *encounter, false);
            }
        }
    }

    #[cold]
    fn undetermined(
        &self,
        undetermined: &Undetermined,
        members: &[Member<T>],
        touches: &[Touch],
    ) -> Ending {
        let scene = self.balls.scene();
        let id = |ball: usize| scene.balls[ball].id.as_str();
        let name = |touch: &Touch| match encounter_of(members, *touch) {
            Encounter::Pair(a, b) => format!("{}-{}", id(a), id(b)),
            Encounter::Cushion(a, side) => format!("{}-{}", id(a), side.id()),
        };
        let names = undetermined.contacts.iter().filter_map(|k| touches.get(*k));
        let names: Vec<String> = names.map(name).collect();
        let why = format!("{}: contacts {}", undetermined.why, names.join(", "));
        let balls: Vec<usize> = members.iter().map(|m| m.ball).collect();
        Ending::Indeterminate(self.balls.spot(&balls, &why))
    }

    /// Parties touch without closing in: what they do is for their contact to say.
    #[cold]
    #[inline(never)]
    pub(super) fn touch(&mut self, encounter: Encounter) -> Option<Ending> {
        let mut gathered = self.gather(encounter);
        let mut states: Vec<(usize, Moving<T>)> = gathered
            .members
            .iter()
            .map(|m| (m.ball, m.moving))
            .collect();
        let named = gathered
            .touches
            .iter()
            .map(|t| encounter_of(&gathered.members, *t));
        let named: Vec<Encounter> = named.collect();
        calm(self.balls.world(), &named, &mut states);
        for (known, (ball, moving)) in gathered.members.iter_mut().zip(states) {
            if known.moving.velocity != moving.velocity {
                *known = member(self.balls.world(), ball, moving);
            }
        }
        let balls: Vec<usize> = gathered.members.iter().map(|m| m.ball).collect();
        if let Some(ending) = self.streak_of(&balls) {
            return Some(ending);
        }
        self.go_on(gathered, &[], &[], 0)
    }

    /// An impact into balls that are held, or that touch others: all their contacts resolve it together.
    #[cold]
    #[inline(never)]
    pub(super) fn struck(&mut self, encounter: Encounter) -> Option<Ending> {
        let (first, second) = match encounter {
            Encounter::Pair(a, b) => (a, b),
            Encounter::Cushion(a, _) => (a, a),
        };
        self.interrupt(first);
        self.interrupt(second);
        if !self.balls.is_held(first) && !self.balls.is_held(second) {
            return match encounter {
                Encounter::Pair(a, b) => self.pair(a, b),
                Encounter::Cushion(a, side) => self.cushion(a, side),
            };
        }
        let closing = -self.rate_of(encounter);
        if self.is_still(closing) {
            return self.touch(encounter);
        }
        let mut gathered = self.gather(encounter);
        let impact = match self.resolve(encounter, &gathered) {
            Ok(impact) => impact,
            Err(ending) => return Some(ending),
        };
        if let Some(ending) = self.streak(&impact.sides) {
            return Some(ending);
        }
        for side in &impact.sides {
            self.balls.set_off(side.ball, &side.course);
            let moving = Moving {
                position: side.position,
                velocity: side.after,
                spin: side.spin_after,
            };
            let next = member(self.balls.world(), side.ball, moving);
            let known = gathered.members.iter_mut().find(|m| m.ball == side.ball);
            if let Some(known) = known {
                *known = next;
            }
        }
        self.journal.cluster_impact(&self.balls, &impact);
        let Gathered {
            members,
            touches,
            held,
        } = gathered;
        let steady = touches.iter().copied();
        let steady = steady.filter(|touch| self.is_steady(&members, *touch));
        let steady: Vec<Touch> = steady.collect();
        for encounter in &held {
            let stays = steady
                .iter()
                .any(|t| encounter_of(&members, *t) == *encounter);
            if !stays {
                self.journal.contact(&self.balls, *encounter, false);
            }
        }
        let gathered = Gathered {
            members,
            touches: steady,
            held,
        };
        self.go_on(gathered, &[], &[], 0)
    }

    /// A ball that is held leaves play: the others of its group go on without it.
    #[cold]
    pub(super) fn leaves_group(&mut self, ball: usize) -> Option<Gathered<T>> {
        let held = self.balls.contacts().of(ball)?.encounters();
        let Gathered {
            members,
            touches,
            held,
        } = self.gather(*held.first()?);
        let ended = held.iter().filter(|encounter| involves(encounter, ball));
        for encounter in ended {
            self.journal.contact(&self.balls, *encounter, false);
        }
        let place = members.iter().position(|m| m.ball == ball)?;
        let after = |i: usize| if i > place { i - 1 } else { i };
        let touches = touches.into_iter().filter_map(|touch| match touch {
            Touch::Pair(a, b) if a == place || b == place => None,
            Touch::Pair(a, b) => Some(Touch::Pair(after(a), after(b))),
            Touch::Cushion(a, _) if a == place => None,
            Touch::Cushion(a, side) => Some(Touch::Cushion(after(a), side)),
        });
        let touches = touches.collect();
        let members = members.into_iter().filter(|m| m.ball != ball).collect();
        Some(Gathered {
            members,
            touches,
            held,
        })
    }

    /// What the contacts of balls that touch make of an impact, all together.
    fn resolve(
        &self,
        encounter: Encounter,
        gathered: &Gathered<T>,
    ) -> Result<ClusterImpact<T>, Ending> {
        let world = self.balls.world();
        let members = &gathered.members;
        let touches = gathered.touches.iter().map(|touch| match *touch {
            Touch::Pair(a, b) => {
                let p =
                    [0, 1].map(|i| members[b].moving.position[i] - members[a].moving.position[i]);
                let size = (p[0] * p[0] + p[1] * p[1]).sqrt();
                let n = Vector3::new(p[0] / size, p[1] / size, T::zero());
                simultaneous::Touch::Pair(a, b, n)
            }
            Touch::Cushion(a, side) => simultaneous::Touch::Cushion(a, side),
        });
        let cluster = Cluster::of(
            world,
            members.iter().map(|m| m.ball).collect(),
            members.iter().map(|m| m.moving.velocity).collect(),
            members.iter().map(|m| m.moving.spin).collect(),
            touches.collect(),
        );
        let seeds: Vec<usize> = match encounter {
            Encounter::Pair(a, b) => vec![a, b],
            Encounter::Cushion(a, _) => vec![a],
        };
        ClusterImpact::of_cluster(&self.balls, &cluster, &seeds)
    }

    /// Rate of the gap of two parties now, length/s.
    fn rate_of(&self, encounter: Encounter) -> T {
        match encounter {
            Encounter::Pair(a, b) => {
                let ((p, v), (q, w)) = (self.balls.at(a), self.balls.at(b));
                let p = [0, 1].map(|i| q[i] - p[i]);
                (p[0] * (w[0] - v[0]) + p[1] * (w[1] - v[1])) / (p[0] * p[0] + p[1] * p[1]).sqrt()
            }
            Encounter::Cushion(a, side) => {
                let v = self.balls.at(a).1[side.axis()];
                if side.sign() < 0 { v } else { -v }
            }
        }
    }

    /// Something comes between a ball and the limit that it is on its way to: its group is where its impacts have brought it by now.
    fn interrupt(&mut self, ball: usize) {
        let on_the_way = |held: &Held<T>| matches!(held.next, Next::Limit(_));
        if !self.balls.contacts().of(ball).is_some_and(on_the_way) {
            return;
        }
        let Some(held) = self.balls.let_go(ball) else {
            return;
        };
        let Next::Limit(way) = &held.next else {
            return;
        };
        self.journal.stretch(&self.balls, &held);
        let after = self.balls.now() - held.start;
        let world = self.balls.world();
        let found = way
            .encounter
            .and_then(|encounter| tail::until(world, encounter, &way.before, after));
        let along = held.group.members.iter();
        let states =
            found.unwrap_or_else(|| along.map(|m| self.balls.state_in(&held, m.ball)).collect());
        self.journal
            .passed(&self.balls, &held.group.members, &way.before, &states);
        let mut balls = Vec::new();
        for (m, moving) in held.group.members.iter().zip(states) {
            let course = self.balls.course(m.ball, moving);
            self.balls.set_off(m.ball, &course);
            balls.push(m.ball);
        }
        self.predict_all(&balls);
    }

    /// Gives up the group that holds a ball: until it is decided how its balls go on, they do as they would alone.
    fn give_up(&mut self, ball: usize) {
        if let Some(group) = self.balls.let_go(ball) {
            self.journal.stretch(&self.balls, &group);
            for m in &group.group.members {
                let moving = self.balls.state_in(&group, m.ball);
                let course = self.balls.course(m.ball, moving);
                self.balls.set_off(m.ball, &course);
            }
        }
    }

    /// Whether two parties that touch neither approach nor part.
    fn is_steady(&self, members: &[Member<T>], touch: Touch) -> bool {
        let slow = self.balls.world().blur.speed * T::lift(STEADY);
        rate(members, touch).abs() <= slow
    }

    /// Everything that touches the parties of `seed`, directly or through others, without closing in; taken out of the groups that hold it.
    fn gather(&mut self, seed: Encounter) -> Gathered<T> {
        let (first, second) = match seed {
            Encounter::Pair(a, b) => (a, Some(b)),
            Encounter::Cushion(a, _) => (a, None),
        };
        let mut balls: Vec<usize> = std::iter::once(first).chain(second).collect();
        let mut encounters = vec![seed];
        let mut held = Vec::new();
        let mut next = 0;
        while let Some(&ball) = balls.get(next) {
            next += 1;
            self.interrupt(ball);
            if let Some(group) = self.balls.contacts().of(ball) {
                for encounter in group.encounters() {
                    if !held.contains(&encounter) {
                        held.push(encounter);
                    }
                }
            }
            for encounter in touching(&self.balls, &self.agenda, ball) {
                if !encounters.contains(&encounter) {
                    encounters.push(encounter);
                }
                if let Encounter::Pair(a, b) = encounter {
                    for other in [a, b] {
                        if !balls.contains(&other) {
                            balls.push(other);
                        }
                    }
                }
            }
            for encounter in held.iter().filter(|e| involves(e, ball)) {
                if !encounters.contains(encounter) {
                    encounters.push(*encounter);
                }
                if let Encounter::Pair(a, b) = *encounter {
                    for other in [a, b] {
                        if !balls.contains(&other) {
                            balls.push(other);
                        }
                    }
                }
            }
        }
        let members: Vec<Member<T>> = balls.iter().map(|ball| self.as_member(*ball)).collect();
        let place = |ball: usize| balls.iter().position(|b| *b == ball).unwrap_or(0);
        let touches = encounters.iter().map(|encounter| match *encounter {
            Encounter::Pair(a, b) => Touch::Pair(place(a), place(b)),
            Encounter::Cushion(a, side) => Touch::Cushion(place(a), side),
        });
        let touches = touches.collect();
        for ball in &balls {
            self.give_up(*ball);
        }
        Gathered {
            members,
            touches,
            held,
        }
    }

    /// A ball as it is now; one that is held keeps its state of motion.
    fn as_member(&self, ball: usize) -> Member<T> {
        let moving = self.balls.moving(ball);
        let known = self.balls.contacts().of(ball).and_then(|held| {
            let own = held.group.members.iter().find(|m| m.ball == ball)?;
            matches!(held.next, Next::Motion).then_some(*own)
        });
        match known {
            Some(known) => Member { moving, ..known },
            None => member(self.balls.world(), ball, moving),
        }
    }
}

fn involves(encounter: &Encounter, ball: usize) -> bool {
    match *encounter {
        Encounter::Pair(a, b) => a == ball || b == ball,
        Encounter::Cushion(a, _) => a == ball,
    }
}

fn encounter_of<T: Real>(members: &[Member<T>], touch: Touch) -> Encounter {
    match touch {
        Touch::Pair(a, b) => {
            let (a, b) = (members[a].ball, members[b].ball);
            Encounter::Pair(a.min(b), a.max(b))
        }
        Touch::Cushion(a, side) => Encounter::Cushion(members[a].ball, side),
    }
}

/// Rate of the gap of two parties, length/s.
fn rate<T: Real>(members: &[Member<T>], touch: Touch) -> T {
    match touch {
        Touch::Pair(a, b) => {
            let (a, b) = (&members[a].moving, &members[b].moving);
            let p = [0, 1].map(|i| b.position[i] - a.position[i]);
            let v = [0, 1].map(|i| b.velocity[i] - a.velocity[i]);
            (p[0] * v[0] + p[1] * v[1]) / (p[0] * p[0] + p[1] * p[1]).sqrt()
        }
        Touch::Cushion(a, side) => {
            let v = members[a].moving.velocity[side.axis()];
            if side.sign() < 0 { v } else { -v }
        }
    }
}

/// What touches a ball now and neither approaches nor parts from it. Two balls at rest touch nothing but what they are told of.
fn touching<T: Real>(balls: &Kinematics<'_, T>, agenda: &Agenda<T>, ball: usize) -> Vec<Encounter> {
    let world = balls.world();
    let slow = world.blur.speed * T::lift(STEADY);
    let (here, v) = balls.at(ball);
    let mut found = Vec::new();
    if world.contact.is_some() {
        for other in agenda.neighbours(balls, ball, world.touching) {
            if other == ball {
                continue;
            }
            let (there, w) = balls.at(other);
            let p = [there[0] - here[0], there[1] - here[1]];
            let apart = (p[0] * p[0] + p[1] * p[1]).sqrt();
            let rate = (p[0] * (w[0] - v[0]) + p[1] * (w[1] - v[1])) / apart;
            let pair = Encounter::Pair(ball.min(other), ball.max(other));
            let near = apart <= world.distance(ball, other) + world.touching;
            if near && rate.abs() <= slow && !balls.is_parting(pair) {
                found.push(pair);
            }
        }
    }
    if let Some(reach) = world.reach.get(ball) {
        for side in Side::ALL {
            let gap = (reach[side as usize] - here[side.axis()]).abs();
            let encounter = Encounter::Cushion(ball, side);
            let near = gap <= world.touching && v[side.axis()].abs() <= slow;
            if near && !balls.is_parting(encounter) {
                found.push(encounter);
            }
        }
    }
    found
}

/// Groups of members that contacts connect.
fn components<T: Real>(whole: &Group<T>) -> Vec<Group<T>> {
    let n = whole.members.len();
    let mut of: Vec<usize> = (0..n).collect();
    for hold in &whole.holds {
        if let Touch::Pair(a, b) = hold.touch {
            let (to, from) = (of[a].min(of[b]), of[a].max(of[b]));
            for label in &mut of {
                if *label == from {
                    *label = to;
                }
            }
        }
    }
    let mut groups = Vec::new();
    for label in 0..n {
        let own: Vec<usize> = (0..n).filter(|i| of[*i] == label).collect();
        if own.is_empty() {
            continue;
        }
        let place = |i: usize| own.iter().position(|o| *o == i);
        let holds = whole.holds.iter().filter_map(|hold| {
            let touch = match hold.touch {
                Touch::Pair(a, b) => Touch::Pair(place(a)?, place(b)?),
                Touch::Cushion(a, side) => Touch::Cushion(place(a)?, side),
            };
            Some(Hold { touch, ..*hold })
        });
        groups.push(Group {
            holds: holds.collect(),
            members: own.iter().map(|i| whole.members[*i]).collect(),
        });
    }
    groups
}

/// Takes the rounding of a stretch out of the gaps of a group: no gap opens or closes, and none has changed.
fn keep_contacts<T: Real>(
    world: &super::world::World<T>,
    group: &Group<T>,
    states: &mut [Moving<T>],
) {
    for hold in &group.holds {
        match hold.touch {
            Touch::Cushion(a, side) => states[a].velocity[side.axis()] = T::zero(),
            Touch::Pair(a, b) => {
                let (ma, mb) = (
                    world.mass[group.members[a].ball],
                    world.mass[group.members[b].ball],
                );
                let rests = |i: usize| group.members[i].mode == Mode::Rests;
                // a ball at rest takes no part in it
                let share = match (rests(a), rests(b)) {
                    (false, false) => mb / (ma + mb),
                    (true, false) => T::zero(),
                    _ => T::one(),
                };
                let (one, other) = (states[a], states[b]);
                let p = [0, 1].map(|i| other.position[i] - one.position[i]);
                let v = [0, 1].map(|i| other.velocity[i] - one.velocity[i]);
                let square = p[0] * p[0] + p[1] * p[1];
                let along = (p[0] * v[0] + p[1] * v[1]) / square;
                for i in 0..2 {
                    states[a].velocity[i] += p[i] * along * share;
                    states[b].velocity[i] -= p[i] * along * (T::one() - share);
                }
            }
        }
    }
    for (m, state) in group.members.iter().zip(states) {
        settle(world.radius[m.ball], m.mode, state);
    }
}

/// Takes out of states what is left of approach and parting of encounters.
fn calm<T: Real>(
    world: &super::world::World<T>,
    encounters: &[Encounter],
    states: &mut [(usize, Moving<T>)],
) {
    for _ in 0..ROUNDS {
        for encounter in encounters {
            let place = |ball: usize| states.iter().position(|(b, _)| *b == ball);
            match *encounter {
                Encounter::Cushion(a, side) => {
                    if let Some(a) = place(a) {
                        states[a].1.velocity[side.axis()] = T::zero();
                    }
                }
                Encounter::Pair(a, b) => {
                    let (Some(i), Some(j)) = (place(a), place(b)) else {
                        continue;
                    };
                    let share = world.mass[b] / (world.mass[a] + world.mass[b]);
                    let (one, other) = (states[i].1, states[j].1);
                    let p = [0, 1].map(|k| other.position[k] - one.position[k]);
                    let v = [0, 1].map(|k| other.velocity[k] - one.velocity[k]);
                    let square = p[0] * p[0] + p[1] * p[1];
                    let along = (p[0] * v[0] + p[1] * v[1]) / square;
                    for k in 0..2 {
                        states[i].1.velocity[k] += p[k] * along * share;
                        states[j].1.velocity[k] -= p[k] * along * (T::one() - share);
                    }
                }
            }
        }
    }
}

/// A contact as the trace has it: the first ball, and its partner.
pub fn parties(encounter: Encounter) -> (usize, Partner) {
    match encounter {
        Encounter::Pair(a, b) => (a.min(b), Partner::Ball(a.max(b) as u32)),
        Encounter::Cushion(a, side) => (a, Partner::Cushion(side)),
    }
}

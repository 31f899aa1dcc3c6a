//! The event loop's part in contacts that last: accumulations, stretches of common motion, and impacts into what is held.

use super::agenda::Agenda;
use super::contact::arc::{Arc, Series};
use super::contact::decide::{Undetermined, decide, member, settle};
use super::contact::group::{Change, Group, Hold, Member, Mode, Touch, Twist};
use super::contact::held::{Held, Next, encounter};
use super::contact::tail;
use super::impact::Impact;
use super::kinematics::Kinematics;
use super::predict::{Encounter, Row};
use super::solve::Loop;
use super::spin::Moving;
use crate::math::Real;
use crate::physics::Side;
use crate::trace::{Ending, Partner};

/// Below this part of the largest speed an impact may be one of an accumulation.
pub const SLOW: f64 = 1e-3;

/// An accumulation is left to its limit when an approach is this many times what rounding makes of one.
const NOISE: f64 = 100.0;

/// Parties that touch and approach or part by no more than this many roundings of the fastest ball do neither.
const STEADY: f64 = 64.0;

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

/// Balls that touch, taken out of their courses.
struct Gathered<T> {
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
        let states = impact.sides.each_ref().map(|side| Moving {
            position: side.position,
            velocity: side.before,
            spin: side.spin_before,
        });
        let now = self.balls.now();
        let Some(limit) = tail::limit(self.balls.world(), impact.encounter, &states) else {
            return false;
        };
        let found = Foreseen {
            encounter: impact.encounter,
            time: now + limit.after,
            states: limit.states,
        };
        // the first answer sees least of the rounding of gaps; it stands while the impacts go as it says
        let known = self.foreseen.iter().find(|known| {
            known.encounter == found.encounter
                && (known.time - found.time).abs() <= limit.after * T::lift(SLOW)
                && known.time > now
        });
        let chosen = known.cloned().unwrap_or(found);
        self.foreseen
            .retain(|known| known.time > now && known.encounter != chosen.encounter);
        self.foreseen.push(chosen.clone());
        let world = self.balls.world();
        let noise = (world.blur.length * world.strongest() * T::lift(2.0)).sqrt();
        if impact.closing > noise * T::lift(NOISE) || self.comes_before(impact, chosen.time) {
            return false;
        }
        self.go_to_limit(impact, &states, chosen, limit.impacts);
        true
    }

    /// Whether another event of the balls of an impact comes before `time`, s.
    fn comes_before<const N: usize>(&mut self, impact: &Impact<T, N>, time: T) -> bool {
        let mut comes = false;
        for side in &impact.sides {
            let mut flight = side.course.flight;
            // the ends of their own phases are part of the accumulation
            flight.end = T::lift(f64::INFINITY);
            let row = Row::setting_off(&self.balls, side.ball, &flight).without(impact.encounter);
            let next = self.agenda.foresee(&row, None);
            comes |= next.time <= time;
        }
        comes || time > self.balls.world().duration
    }

    /// Puts the balls of an impact on the straight way to the limit of their accumulation.
    fn go_to_limit<const N: usize>(
        &mut self,
        impact: &Impact<T, N>,
        states: &[Moving<T>; N],
        limit: Foreseen<T>,
        impacts: u32,
    ) {
        let now = self.balls.now();
        let after = limit.time - now;
        let balls = impact.sides.each_ref().map(|side| side.ball);
        let mut members = Vec::new();
        let mut series = Vec::new();
        for ((ball, start), end) in balls.iter().zip(states).zip(&limit.states) {
            // through both ends with a constant acceleration
            let two = T::lift(2.0);
            let leaving = [0, 1]
                .map(|i| (end.position[i] - start.position[i]) / after * two - end.velocity[i]);
            let moving = Moving {
                velocity: leaving,
                ..*start
            };
            let acceleration = [0, 1].map(|i| (end.velocity[i] - leaving[i]) / after);
            let rate = [0, 1, 2].map(|i| (end.spin[i] - start.spin[i]) / after);
            series.push(Series::straight(*ball, &moving, acceleration, rate, after));
            members.push(Member {
                ball: *ball,
                moving,
                mode: Mode::Floats,
                twist: Twist::Free,
            });
        }
        self.journal
            .accumulation(&self.balls, impact, &members, &limit.states, impacts);
        let touch = match impact.encounter {
            Encounter::Pair(..) => Touch::Pair(0, 1),
            Encounter::Cushion(_, side) => Touch::Cushion(0, side),
        };
        let hold = Hold {
            touch,
            pressed: true,
        };
        self.hold(Held {
            group: Group {
                members,
                holds: vec![hold],
            },
            arc: Arc {
                length: after,
                series,
                changes: Vec::new(),
            },
            start: now,
            next: Next::Limit(limit.states),
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
        if let Next::Limit(states) = held.next {
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
        Arc::of(world, group, world.duration - self.balls.now())
    }

    /// Decides how balls go on that touch, and lets them. `gone`: contacts whose force has vanished; `changes`: what else has just happened.
    fn go_on(
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

    /// Writes down which contacts began and which ended.
    fn tell(&mut self, before: &[Encounter], held: &[Encounter], lasting: &[Encounter]) {
        for encounter in before {
            let was = held.contains(encounter);
            let is = lasting.contains(encounter);
            if !was {
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
        let gathered = self.gather(encounter);
        self.go_on(gathered, &[], &[], 0)
    }

    /// An impact into balls that are held, or that touch others: its law first, then what their contacts make of it.
    #[cold]
    #[inline(never)]
    pub(super) fn struck(&mut self, encounter: Encounter) -> Option<Ending> {
        let gathered = self.gather(encounter);
        let world = self.balls.world();
        let mut members = gathered.members;
        let ended = match encounter {
            Encounter::Pair(a, b) => {
                let impact = Impact::of_balls(&self.balls, world.contact?, a, b);
                impact.fault(&self.balls).or_else(|| {
                    self.strike(&impact, &mut members);
                    None
                })
            }
            Encounter::Cushion(a, side) => {
                let impact = Impact::on_cushion(&self.balls, world.cushion?, a, side);
                impact.fault(&self.balls).or_else(|| {
                    self.strike(&impact, &mut members);
                    None
                })
            }
        };
        if ended.is_some() {
            return ended;
        }
        let steady: Vec<Touch> = gathered
            .touches
            .iter()
            .copied()
            .filter(|touch| {
                encounter_of(&members, *touch) != encounter && self.is_steady(&members, *touch)
            })
            .collect();
        for encounter in &gathered.held {
            let stays = steady
                .iter()
                .any(|t| encounter_of(&members, *t) == *encounter);
            if !stays {
                self.journal.contact(&self.balls, *encounter, false);
            }
        }
        let held = gathered.held;
        self.go_on(
            Gathered {
                members,
                touches: steady,
                held,
            },
            &[],
            &[],
            0,
        )
    }

    fn strike<const N: usize>(&mut self, impact: &Impact<T, N>, members: &mut [Member<T>]) {
        for side in &impact.sides {
            let moving = Moving {
                position: side.position,
                velocity: side.after,
                spin: side.spin_after,
            };
            let next = member(self.balls.world(), side.ball, moving);
            if let Some(known) = members.iter_mut().find(|m| m.ball == side.ball) {
                *known = next;
            }
            self.balls.set_off(side.ball, &side.course);
        }
        self.journal.impact(&self.balls, impact);
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
            if let Some(group) = self.balls.let_go(*ball) {
                self.journal.stretch(&self.balls, &group);
                for m in &group.group.members {
                    // until it is decided how they go on, they do as they would alone
                    let moving = self.balls.state_in(&group, m.ball);
                    let course = self.balls.course(m.ball, moving);
                    self.balls.set_off(m.ball, &course);
                }
            }
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

/// A contact as the trace has it: the first ball, and its partner.
pub fn parties(encounter: Encounter) -> (usize, Partner) {
    match encounter {
        Encounter::Pair(a, b) => (a.min(b), Partner::Ball(a.max(b) as u32)),
        Encounter::Cushion(a, side) => (a, Partner::Cushion(side)),
    }
}

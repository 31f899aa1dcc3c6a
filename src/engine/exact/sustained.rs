//! The event loop's part in contacts that last: accumulations, stretches of common motion, and impacts into what is held.

use super::cluster_impact::ClusterImpact;
use super::contact::decide::{Undetermined, decide, member, member_as_is, tidy};
use super::contact::group::{Change, Hold, Member, Mode, Touch, Twist, loudest};
use super::contact::held::Held;
use super::contact::touching::{
    Gathered, Steady, Touched, calm, components, keep_contacts, rate, slowest, touching,
};
use super::encounter::Encounter;
use super::predict::Row;
use super::simultaneous::{self, Cluster};
use super::solve::Loop;
use super::spin::Moving;
use super::stretch::stretch;
use crate::math::Real;
use crate::trace::Ending;
use nalgebra::Vector3;

/// Stretches in which next to no time passes after which a group does not get on.
const STUCK: u32 = 64;

/// Stretches without a change between them, at most: one that turns towards its end takes a few for each bit of the scalar.
const MOST_STRETCHES: u32 = 20_000;

impl<T: Real> Loop<'_, T> {
    /// Whether parties that touch do not approach, at this rate, but for rounding.
    pub(super) fn is_still(&self, encounter: Encounter, closing: T) -> bool {
        let steady = Steady::of(self.balls.world());
        closing <= slowest(&self.balls, encounter, &steady)
    }

    /// Takes up a group and predicts what its balls meet; answers whether that ends the run.
    fn hold(&mut self, held: Held<T>) -> Option<Ending> {
        let balls: Vec<usize> = held.group.members.iter().map(|m| m.ball).collect();
        self.balls.hold(held);
        let ending = self.untold();
        self.predict_all(&balls);
        ending
    }

    /// Predicts the next events of balls that have set off together.
    pub(super) fn predict_all(&mut self, balls: &[usize]) {
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
        let mut states = held.arc.end(world, &held.group);
        let changes = held.arc.changes.clone();
        let beyond = held.arc.places(&held.beyond, &mut states);
        let mut group = held.group;
        for (member, state) in group.members.iter_mut().zip(states) {
            member.moving = state;
        }
        let touches = group.touches();
        keep_contacts(world, &mut group.members, &touches);
        if changes.is_empty() {
            if held.unchanged >= MOST_STRETCHES {
                let balls: Vec<usize> = group.members.iter().map(|m| m.ball).collect();
                let why = "the motion of balls in contact turns within ever shorter times";
                return Some(Ending::Collapsed(self.balls.spot(&balls, why)));
            }
            return self.hold(Held {
                arc: stretch(&self.balls, &group),
                group,
                start: self.balls.now(),
                stuck: held.stuck,
                unchanged: held.unchanged + 1,
                beyond,
            });
        }
        // no ball gets as fast meanwhile as rounding tells
        let moment = world.blur.speed / world.strongest();
        let stuck = if held.arc.length > moment {
            0
        } else {
            held.stuck + 1
        };
        if T::DIFFERENTIATES {
            self.note_turn(&mut group.members, held.start, held.arc.length <= moment);
        }
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
            touches,
            members: group.members,
            held: encounters,
        };
        self.go_on(gathered, &gone, &changes, stuck)
    }

    /// The end of a run with a group whose motion no series tells; its balls are left where and as they are.
    pub(super) fn untold(&mut self) -> Option<Ending> {
        let mut groups = self.balls.contacts().held().iter();
        let first = groups.find(|held| !held.arc.is_told())?;
        let group = self.balls.let_go(first.group.members[0].ball)?.group;
        for m in &group.members {
            let course = self.balls.course(m.ball, m.moving);
            self.balls.set_off(m.ball, &course);
        }
        let balls: Vec<usize> = group.members.iter().map(|m| m.ball).collect();
        let why = "the motion of balls in contact turns within a time that no number holds";
        Some(Ending::Collapsed(self.balls.spot(&balls, why)))
    }

    /// What a member does whose slip has ended.
    fn ends_slip(&self, m: &Member<T>) -> Mode {
        member(self.balls.world(), m.ball, m.moving).mode
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
        let before = touches.iter().map(|touch| touch.encounter(&members));
        let before: Vec<Encounter> = before.collect();
        if stuck > STUCK {
            let balls: Vec<usize> = members.iter().map(|m| m.ball).collect();
            let why = "balls in contact change their states again and again without time passing";
            return Some(Ending::Collapsed(self.balls.spot(&balls, why)));
        }
        let world = self.balls.world();
        let decision = match decide(world, members.clone(), &touches, gone, changes) {
            Ok(decision) => decision,
            Err(undetermined) => {
                for m in &members {
                    self.balls
                        .set_off(m.ball, &self.balls.course(m.ball, m.moving));
                }
                return Some(self.undetermined(&undetermined, &members, &touches));
            }
        };
        let mut near = members;
        let members = decision.group.members.clone();
        let mut balls: Vec<usize> = Vec::new();
        let mut lasting: Vec<Encounter> = Vec::new();
        for mut group in components(&decision.group) {
            balls.extend(group.members.iter().map(|m| m.ball));
            let rests = group.members.iter().all(|m| m.mode == Mode::Rests);
            if group.holds.is_empty() || rests {
                for m in &group.members {
                    self.balls
                        .set_off(m.ball, &self.balls.course(m.ball, m.moving));
                }
                continue;
            }
            let named = |hold: &Hold| hold.touch.encounter(&group.members);
            lasting.extend(group.holds.iter().map(named));
            for m in &mut group.members {
                tidy(self.balls.world(), m);
            }
            // one that is let go creeps: those that it touches go with it
            let mut calmed = group.members.clone();
            calm(self.balls.world(), &mut calmed, &group.touches());
            let mut both = group.members.iter().zip(&calmed);
            if both.all(|(m, calmed)| m.mode == calmed.mode) {
                group.members = calmed;
            }
            let arc = stretch(&self.balls, &group);
            self.balls.hold(Held {
                arc,
                group,
                start: self.balls.now(),
                stuck,
                unchanged: 0,
                beyond: Vec::new(),
            });
        }
        if let Some(ending) = self.untold() {
            return Some(ending);
        }
        for touch in &decision.parting {
            self.balls.part(touch.encounter(&members));
        }
        self.tell(&before, &held, &lasting, &mut near);
        self.predict_all(&balls);
        None
    }

    /// Whether two of these balls came to touch during this run.
    #[cold]
    pub(super) fn has_begun(&self, balls: &[usize]) -> bool {
        let begun = &mut self.begun.iter();
        begun.any(|encounter| encounter.balls().all(|ball| balls.contains(&ball)))
    }

    fn begin(&mut self, encounter: Encounter) {
        if !self.begun.contains(&encounter) {
            self.begun.push(encounter);
        }
    }

    /// Writes down which contacts began and which ended. `near`: how balls moved before it was decided how they go on; what has been told is taken out.
    fn tell(
        &mut self,
        before: &[Encounter],
        held: &[Encounter],
        lasting: &[Encounter],
        near: &mut Vec<Member<T>>,
    ) {
        for encounter in before {
            let was = held.contains(encounter);
            let is = lasting.contains(encounter);
            if is && !was {
                self.begin(*encounter);
            }
            if is != was {
                self.journal.contact(&self.balls, *encounter, is, near);
                near.retain(|m| !encounter.involves(m.ball));
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
        let name = |touch: &Touch| match touch.encounter(members) {
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
        let steady = Steady::of(self.balls.world());
        if !self.is_still(encounter, self.balls.rate(encounter)) {
            // they part already: rounding has them meet
            let balls: Vec<usize> = encounter.balls().collect();
            self.balls.part(encounter);
            self.predict_all(&balls);
            return self.streak_of(&balls);
        }
        let mut gathered = self.connected(encounter, &steady);
        calm(self.balls.world(), &mut gathered.members, &gathered.touches);
        self.touches(encounter, gathered)
    }

    /// What a contact that begins now does to a ball.
    fn touched(&self, member: &Member<T>) -> Touched<T> {
        let before = self.balls.moving(member.ball);
        let zero = [T::zero(); 2];
        // also one whose phase ends at this very time
        let moved = self.balls.flight(member.ball).moves() && !self.balls.is_held(member.ball);
        Touched {
            ball: member.ball,
            before,
            after: member.moving,
            stops: member.moving.velocity == zero && (moved || before.velocity != zero),
        }
    }

    /// Balls go on from contacts that begin now. `gathered`: how they move from now on.
    pub(super) fn touches(
        &mut self,
        encounter: Encounter,
        mut gathered: Gathered<T>,
    ) -> Option<Ending> {
        let balls: Vec<usize> = gathered.members.iter().map(|m| m.ball).collect();
        if let Some(ending) = self.streak_of(&balls) {
            return Some(ending);
        }
        let members = gathered.members.iter();
        let changes: Vec<Touched<T>> = members.map(|m| self.touched(m)).collect();
        for ball in balls {
            self.give_up(ball);
        }
        if changes.iter().any(Touched::is_changed) {
            self.begin(encounter);
            self.journal.touch(&self.balls, encounter, &changes);
            if !gathered.held.contains(&encounter) {
                gathered.held.push(encounter);
            }
        }
        self.go_on(gathered, &[], &[], 0)
    }

    /// An impact of balls that are held, or of which others are that are within its reach.
    #[cold]
    pub(super) fn struck_together(&mut self, encounter: Encounter) -> Option<Ending> {
        let closing = -self.balls.rate(encounter);
        if self.is_still(encounter, closing) {
            return self.touch(encounter);
        }
        if closing < self.slow {
            return self.shrinks(encounter);
        }
        let mut gathered = self.gather(encounter, &Steady::of(self.balls.world()));
        if T::DIFFERENTIATES {
            self.note_together(&mut gathered.members, &gathered.touches);
        }
        let impact = match self.resolve(encounter, &gathered) {
            Ok(impact) => impact,
            Err(ending) => return Some(ending),
        };
        if T::DIFFERENTIATES {
            self.note_error(impact.error);
        }
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
            let next = member_as_is(self.balls.world(), side.ball, moving);
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
            let stays = steady.iter().any(|t| t.encounter(&members) == *encounter);
            if !stays {
                self.journal.contact(&self.balls, *encounter, false, &[]);
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
        } = self.gather(*held.first()?, &Steady::of(self.balls.world()));
        let ended = held.iter().filter(|encounter| encounter.involves(ball));
        for encounter in ended {
            self.journal.contact(&self.balls, *encounter, false, &[]);
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
        let seeds: Vec<usize> = encounter.balls().collect();
        ClusterImpact::of_cluster(&self.balls, &cluster, &seeds)
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
        let world = self.balls.world();
        let parties = touch.members().map(|(i, _)| members[i]);
        let parties: Vec<Member<T>> = parties.collect();
        let distance = match parties[..] {
            [a, b] => world.distance(a.ball, b.ball),
            _ => world.radius[parties[0].ball],
        };
        let slowest = Steady::of(world).slowest(world, loudest(world, &parties), distance);
        rate(members, touch).abs() <= slowest
    }

    /// Everything that touches the parties of `seed`, directly or through others, without closing in; taken out of the groups that hold it.
    fn gather(&mut self, seed: Encounter, steady: &Steady<T>) -> Gathered<T> {
        let gathered = self.connected(seed, steady);
        for member in &gathered.members {
            self.give_up(member.ball);
        }
        gathered
    }

    /// The same, left in the groups that hold it.
    pub(super) fn connected(&self, seed: Encounter, steady: &Steady<T>) -> Gathered<T> {
        let mut balls: Vec<usize> = seed.balls().collect();
        let mut encounters = vec![seed];
        let mut held = Vec::new();
        let mut next = 0;
        while let Some(&ball) = balls.get(next) {
            next += 1;
            let own = self.balls.contacts().of(ball);
            let own = own.map_or_else(Vec::new, Held::encounters);
            let own = own.into_iter().filter(|encounter| encounter.involves(ball));
            let own: Vec<Encounter> = own.collect();
            let touched = touching(&self.balls, &self.agenda, ball, steady);
            for encounter in touched.iter().chain(&own) {
                if !encounters.contains(encounter) {
                    encounters.push(*encounter);
                }
                for other in encounter.balls() {
                    if !balls.contains(&other) {
                        balls.push(other);
                    }
                }
            }
            for encounter in own {
                if !held.contains(&encounter) {
                    held.push(encounter);
                }
            }
        }
        let members: Vec<Member<T>> = balls.iter().map(|ball| self.as_member(*ball)).collect();
        let touches = encounters.iter();
        let touches = touches.filter_map(|encounter| Touch::of(*encounter, &members));
        let touches = touches.collect();
        Gathered {
            members,
            touches,
            held,
        }
    }

    /// A ball as it is now; one that is held keeps its state of motion.
    fn as_member(&self, ball: usize) -> Member<T> {
        let moving = self.balls.moving(ball);
        let known = self
            .balls
            .contacts()
            .of(ball)
            .and_then(|held| held.group.members.iter().find(|m| m.ball == ball).copied());
        match known {
            Some(known) => Member { moving, ..known },
            None => member_as_is(self.balls.world(), ball, moving),
        }
    }
}

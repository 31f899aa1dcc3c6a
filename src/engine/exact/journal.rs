//! What a run writes down of its events: rows, both sides, the extrema, and how many there were.

use super::cluster_impact::{ClusterImpact, Met, RowSide};
use super::contact::arc::Arc;
use super::contact::group::{Change, Group, Member, Mode};
use super::contact::held::Held;
use super::contact::touching::Touched;
use super::encounter::Encounter;
use super::impact::{Impact, ImpactSide};
use super::kinematics::Kinematics;
use super::phases::PhaseEnd;
use crate::math::Real;
use crate::physics::invariants::{kinetic_energy, momentum};
use crate::physics::{Side, State};
use crate::trace::{
    Counter, Ending, EventKind, Provenance, Record, Recorder, Trace, UNEXPLAINED_IN_CONTACT,
};

/// Knots of one stretch, at most.
const MOST_PIECES: f64 = 10_000.0;

/// The trace of a run under way. It is told of an event when its balls have set off.
pub struct Journal<T> {
    recorder: Recorder,
    events: u64,
    ball_ball: u64,
    ball_cushion: u64,
    handovers: u64,
    /// Time of every event in the scalar of the run, where someone asks for it.
    times: Option<Vec<T>>,
}

impl<T: Real> Journal<T> {
    /// The journal of balls at time 0. `times`: whether the time of every event is kept in the scalar of the run.
    pub fn new(
        balls: &Kinematics<'_, T>,
        provenance: Provenance,
        record: Record,
        times: bool,
    ) -> Self {
        Journal {
            recorder: Recorder::new(balls.scene(), provenance, record, &balls.first_states()),
            events: 0,
            ball_ball: 0,
            ball_cushion: 0,
            handovers: 0,
            times: times.then(Vec::new),
        }
    }

    /// The same journal, of a run that goes on in another scalar.
    pub fn handed_over<U: Real>(self) -> Journal<U> {
        let times = self.times.map(|times| times.into_iter().map(T::widen));
        Journal {
            recorder: self.recorder,
            events: self.events,
            ball_ball: self.ball_ball,
            ball_cushion: self.ball_cushion,
            handovers: self.handovers,
            times: times.map(Iterator::collect),
        }
    }

    /// A scalar with more digits takes over.
    pub fn hands_over(&mut self) {
        self.handovers += 1;
    }

    /// Events so far: rows of the trace.
    pub fn events(&self) -> u64 {
        self.events
    }

    /// Times of the events, s; empty if they are not kept.
    pub fn take_times(&mut self) -> Vec<T> {
        self.times.take().unwrap_or_default()
    }

    fn count(&mut self, now: T) {
        self.events += 1;
        if let Some(times) = &mut self.times {
            times.push(now);
        }
    }

    /// An impact that stands by itself.
    pub fn impact<const N: usize>(&mut self, balls: &Kinematics<'_, T>, impact: &Impact<T, N>) {
        let sides = &impact.sides;
        let mut gained = 0.0;
        for side in sides {
            gained += gain(balls, side);
        }
        let time = balls.now().to_f64();
        let (first, other) = (&sides[0], sides.get(1));
        self.recorder
            .energy_change(time, gained, first.ball, other.map(|other| other.ball));
        match (impact.encounter, other) {
            (Encounter::Cushion(_, edge), _) => self.edge(balls, first, edge),
            (Encounter::Pair(..), Some(other)) => self.exchange(balls, first, other),
            (Encounter::Pair(..), None) => {}
        }
        for side in sides {
            self.rest(balls, side);
        }
    }

    /// An instant at which several contacts were resolved together; its energy is booked as one change.
    pub fn cluster_impact(&mut self, balls: &Kinematics<'_, T>, cluster: &ClusterImpact<T>) {
        let gained: f64 = cluster.sides.iter().map(|side| gain(balls, side)).sum();
        if let Some(first) = cluster.sides.first() {
            self.recorder
                .energy_change(balls.now().to_f64(), gained, first.ball, None);
        }
        let side = |of: &RowSide<T>| {
            let whole = cluster.sides[of.member];
            let [spin_before, spin_after] =
                (of.spins).unwrap_or([whole.spin_before, whole.spin_after]);
            ImpactSide {
                // by an earlier contact of the instant, if by nothing else
                moved: true,
                before: of.before,
                after: of.after,
                spin_before,
                spin_after,
                ..whole
            }
        };
        for row in &cluster.rows {
            let first = side(&row.first);
            match &row.second {
                Met::Ball(second) => {
                    self.exchange(balls, &first, &side(second));
                    if row.first.closes {
                        self.rest(balls, &first);
                    }
                    if second.closes {
                        self.rest(balls, &side(second));
                    }
                }
                Met::Cushion(edge) => {
                    self.edge(balls, &first, *edge);
                    if row.first.closes {
                        self.rest(balls, &first);
                    }
                }
            }
        }
    }

    /// One contact of two balls: all but energy and stops.
    fn exchange(&mut self, balls: &Kinematics<'_, T>, one: &ImpactSide<T>, other: &ImpactSide<T>) {
        let (a, b) = (one.ball, other.ball);
        let time = balls.now().to_f64();
        let ((a0, a1), (b0, b1)) = (both(balls, one), both(balls, other));
        self.count(balls.now());
        self.ball_ball += 1;
        let event = self
            .recorder
            .event(time, EventKind::ball_ball(a, b), Some(1));
        self.recorder.jump(a, time, &a0, &a1, event);
        self.recorder.jump(b, time, &b0, &b1, event);
        let scene = balls.scene();
        let (ma, mb) = (scene.balls[a].mass, scene.balls[b].mass);
        let change =
            (momentum(&a1, ma) - momentum(&a0, ma)) + (momentum(&b1, mb) - momentum(&b0, mb));
        self.recorder.momentum_error(time, change.norm(), a, b);
        let x = other.position[0] - one.position[0];
        let y = other.position[1] - one.position[1];
        let overlap = balls.world().distance(a, b) - (x * x + y * y).sqrt();
        self.recorder.overlap(time, overlap.to_f64(), a, b);
    }

    /// One contact with a cushion: all but energy and stops.
    fn edge(&mut self, balls: &Kinematics<'_, T>, one: &ImpactSide<T>, side: Side) {
        let a = one.ball;
        let time = balls.now().to_f64();
        let (before, after) = both(balls, one);
        self.count(balls.now());
        self.ball_cushion += 1;
        let kind = EventKind::BallCushion(a as u32, side);
        let event = self.recorder.event(time, kind, Some(1));
        self.recorder.jump(a, time, &before, &after, event);
        let beyond = one.position[side.axis()] - balls.world().reach[a][side as usize];
        let beyond = if side.sign() < 0 { -beyond } else { beyond };
        self.recorder.outside(time, beyond.to_f64(), a);
    }

    /// A ball that an impact brought to rest, if it moved before.
    fn rest(&mut self, balls: &Kinematics<'_, T>, side: &ImpactSide<T>) {
        let zero = [T::zero(); 2];
        if side.moved && side.before != zero && side.after == zero {
            let spin = balls.spin_now(side.ball);
            let at_rest = balls.state(side.ball, side.position, zero, spin);
            self.count(balls.now());
            self.recorder
                .stop(side.ball, balls.now().to_f64(), &at_rest, &at_rest);
        }
    }

    /// A phase that ended by itself.
    pub fn phase_end(&mut self, balls: &Kinematics<'_, T>, end: &PhaseEnd<T>) {
        let (ball, time) = (end.ball, balls.now().to_f64());
        let mut near = &end.before;
        if end.unspun {
            self.count(balls.now());
            let kind = EventKind::SpinEnd(ball as u32);
            self.recorder.phase(ball, time, near, &end.after, kind);
            // what else ends at this instant finds the ball on the far side
            near = &end.after;
        }
        if end.rolls {
            self.count(balls.now());
            let kind = EventKind::SlideToRoll(ball as u32);
            self.recorder.phase(ball, time, near, &end.after, kind);
        }
        if end.stops {
            self.count(balls.now());
            self.recorder.stop(ball, time, near, &end.after);
        }
    }

    /// Parties that touch from now on: what was left of their approach is over, and balls that touch them have answered to it.
    pub fn touch(
        &mut self,
        balls: &Kinematics<'_, T>,
        encounter: Encounter,
        touched: &[Touched<T>],
    ) {
        let time = balls.now().to_f64();
        let event = self.contact_row(balls, encounter, true);
        let scene = balls.scene();
        let mut gained = 0.0;
        let told = |t: &&Touched<T>| t.is_changed() || encounter.involves(t.ball);
        for t in touched.iter().filter(told) {
            let ball = t.ball;
            let [near, far] = [&t.before, &t.after].map(|moving| balls.state_of(ball, moving));
            let (mass, inertia) = (scene.balls[ball].mass, scene.inertia(ball));
            gained += kinetic_energy(&far, mass, inertia) - kinetic_energy(&near, mass, inertia);
            self.recorder.jump(ball, time, &near, &far, event);
        }
        for t in touched.iter().filter(|t| t.stops) {
            let far = balls.state_of(t.ball, &t.after);
            self.count(balls.now());
            self.recorder.stop(t.ball, time, &far, &far);
        }
        let mut parties = encounter.balls();
        if let Some(first) = parties.next() {
            self.recorder
                .energy_change(time, gained, first, parties.next());
        }
    }

    /// What balls did that were held until now: states between which their acceleration is nearly constant.
    pub fn stretch(&mut self, balls: &Kinematics<'_, T>, held: &Held<T>) {
        if !self.recorder.keeps_knots() {
            return;
        }
        let length = (balls.now() - held.start).at_most(held.arc.length);
        let members = || held.arc.series.iter().zip(&held.group.members);
        // between two knots h apart a changing acceleration leaves jerk h^3 / 12 unexplained
        let pieces = members().map(|(series, member)| {
            let most = UNEXPLAINED_IN_CONTACT * balls.world().radius[member.ball].to_f64();
            length.to_f64() * (series.jerk / (12.0 * most)).cbrt()
        });
        // the same times for all, or one is told at a time at which another is only interpolated
        let pieces = pieces.fold(1.0, f64::max).ceil().min(MOST_PIECES);
        for (series, member) in members() {
            for piece in 1..=pieces as u32 {
                let after = length * T::lift(f64::from(piece) / pieces);
                let state = balls.state_of(member.ball, &series.at(after));
                let time = (held.start + after).to_f64().min(balls.now().to_f64());
                self.recorder.pin(member.ball, time, &state);
            }
        }
    }

    /// What ended with a stretch; `group`: its members on the far side.
    pub fn changes(
        &mut self,
        balls: &Kinematics<'_, T>,
        arc: &Arc<T>,
        group: &Group<T>,
        changes: &[Change],
    ) {
        let time = balls.now().to_f64();
        for change in changes {
            let (i, kind): (usize, fn(u32) -> EventKind) = match *change {
                Change::Rolls(i) => (i, EventKind::SlideToRoll),
                Change::Stops(i) => (i, EventKind::Stop),
                Change::Unspun(i) => (i, EventKind::SpinEnd),
                _ => continue,
            };
            let member = &group.members[i];
            let near = arc.series[i].at(arc.length);
            let near = balls.state_of(member.ball, &near);
            let far = balls.state_of(member.ball, &member.moving);
            let rests = member.mode == Mode::Rests;
            let comes_to_rest = match change {
                Change::Stops(_) => true,
                Change::Rolls(_) => rests,
                _ => false,
            };
            self.count(balls.now());
            if comes_to_rest {
                self.recorder.stop(member.ball, time, &near, &far);
            } else {
                self.recorder
                    .phase(member.ball, time, &near, &far, kind(member.ball as u32));
            }
        }
    }

    /// A contact that begins to last, or ends. `near`: how balls moved before it was decided that they do, if otherwise than now.
    pub fn contact(
        &mut self,
        balls: &Kinematics<'_, T>,
        encounter: Encounter,
        begins: bool,
        near: &[Member<T>],
    ) {
        let event = self.contact_row(balls, encounter, begins);
        let time = balls.now().to_f64();
        for ball in encounter.balls() {
            let far = balls.state_of(ball, &balls.moving(ball));
            let before = near.iter().find(|m| m.ball == ball);
            let near = before.map_or(far, |m| balls.state_of(ball, &m.moving));
            self.recorder.jump(ball, time, &near, &far, event);
        }
    }

    fn contact_row(
        &mut self,
        balls: &Kinematics<'_, T>,
        encounter: Encounter,
        begins: bool,
    ) -> u32 {
        let (ball, partner) = encounter.parties();
        let kind = match begins {
            true => EventKind::ContactBegin(ball as u32, partner),
            false => EventKind::ContactEnd(ball as u32, partner),
        };
        self.count(balls.now());
        self.recorder.event(balls.now().to_f64(), kind, None)
    }

    /// A ball that left play in `state`.
    pub fn pocket(&mut self, balls: &Kinematics<'_, T>, ball: usize, state: &State, pocket: u32) {
        self.count(balls.now());
        self.recorder
            .pocket(ball, balls.now().to_f64(), state, pocket);
    }

    /// The trace, rounded to f64. `further`: counters besides those of events.
    pub fn finish(
        self,
        balls: &Kinematics<'_, T>,
        ending: Ending,
        further: impl IntoIterator<Item = (Counter, u64)>,
    ) -> Trace {
        let own = [
            (Counter::Events, self.events),
            (Counter::BallBall, self.ball_ball),
            (Counter::BallCushion, self.ball_cushion),
        ];
        // where none was needed the row is not there
        let handovers = (self.handovers > 0).then_some((Counter::Handovers, self.handovers));
        let counters = own.into_iter().chain(further).chain(handovers);
        self.recorder
            .finish(balls.now().to_f64(), &balls.states(), ending, counters)
    }
}

fn both<T: Real>(balls: &Kinematics<'_, T>, side: &ImpactSide<T>) -> (State, State) {
    (
        balls.state(side.ball, side.position, side.before, side.spin_before),
        balls.state(side.ball, side.position, side.after, side.spin_after),
    )
}

/// Change of a ball's kinetic energy.
fn gain<T: Real>(balls: &Kinematics<'_, T>, side: &ImpactSide<T>) -> f64 {
    let scene = balls.scene();
    let mass = scene.balls[side.ball].mass;
    if !balls.rotates() {
        let energy = |velocity: [T; 2]| {
            let [x, y] = velocity.map(T::to_f64);
            0.5 * mass * (x * x + y * y)
        };
        return energy(side.after) - energy(side.before);
    }
    let (before, after) = both(balls, side);
    let inertia = scene.inertia(side.ball);
    kinetic_energy(&after, mass, inertia) - kinetic_energy(&before, mass, inertia)
}

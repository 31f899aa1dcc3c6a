//! Turns the states before and after each step, and the impulses in between, into events, knots and extrema.
//!
//! Engines report contacts when they are near, not when they act, so an impact is what changed a velocity: a contact
//! impulse worth more than rounding. Both sides of an impact are written at the end of the step in which it fell, at the
//! position that the engine has there: the near side with the velocity that the ball would have had without the impact, the
//! far side with the one that it has. A third knot pins the state at the start of that step.
//!
//! An engine of substeps finds a hit with the first substep that could reach it and reverses velocities once, after the last: an
//! event is up to a step late, and up to a substep early, against the motion that it interrupts.
//!
//! What these knots leave unexplained is then known. While a ball slides, every substep h moves it with the velocity at the
//! substep's end: |dr - T (v0 + v1)/2| = h |v1 - v0|/2, h v/2 at most. In the step of an impact the ball moves first with its
//! old velocity and then, until restitution acts at the end of the step, with one that no longer approaches: the difference
//! to the near side is at most the normal velocity that the impact took from it, so at most dt |jump| (half of that for two
//! equal balls at e = 1). A stop within a step leaves at most a dt^2, a the deceleration. So `unexplained` stays below
//! v dt (1 + 1/(2 substeps)), v the largest speed, as long as no ball moves farther in a step than contacts are predicted.
//! A faster one is found inside what it hit, and pushing it out moves it without a velocity by at most the v dt that it went
//! in. Under a cloth that turns balls, a ball that rolls fast is pressed by the cloth in some substeps only, so that its vertical
//! velocity at the end of a step is anything up to g dt with a mean of zero: g dt times the time between two records more.
//! A hit that is not reported leaves |jump|/2 times the whole time to the next knot.
//!
//! Counters: [`Counter::Contacts`] (impulses, also those below rounding), [`Counter::Exchanges`] (those above it),
//! [`Counter::Unattributed`] (changes of a ball's velocity that neither they nor the cloth explain).

use super::clock::Span;
use super::cloth::{Felt, Load, is_aloft, lever};
use super::rest::{rest_speed, top_speed};
use super::world::{Other, Push};
use crate::math::Vec3;
use crate::math::near::Near;
use crate::physics::invariants::kinetic_energy;
use crate::physics::{Motion, Side, State, friction, pockets};
use crate::scene::Scene;
use crate::trace::{Counter, Ending, EventKind, Provenance, Record, Recorder, Trace};

/// An impulse counts once it changes a velocity by this many ulp of the largest speed: warm starting adds an old impulse
/// and takes it away again, a handful of operations on numbers of that size.
const ROUNDING_ULPS: f64 = 16.0;

/// What squares and roots may round a distance by, relative.
const ROUNDING: f64 = 1e-12;

/// A contact from its first exchange until a step without one.
struct Episode {
    kind: EventKind,
    event: u32,
    exchanges: u64,
    last_step: u64,
}

/// Writes the trace of a run.
pub(super) struct Journal<'a> {
    scene: &'a Scene,
    recorder: Recorder,
    rest_speed: f64,
    felt: Felt,
    /// The largest coefficient of friction between balls, whatever their slip.
    rub: f64,
    /// Smallest change of velocity that is not rounding, length/s.
    noise: f64,
    steps: u64,
    episodes: Vec<Episode>,
    moving: Vec<bool>,
    sliding: Vec<bool>,
    spinning: Vec<bool>,
    aloft: Vec<bool>,
    in_play: Vec<bool>,
    left: Vec<usize>,
    balls: Vec<BallStep>,
    /// Whether something was written in `balls` since all of it was as at the start of a step.
    used: bool,
    /// Where no centre is beyond where the cushions let it be, whatever its radius: the least and the greatest x, those of y, length.
    inner: [[f64; 2]; 2],
    /// What every step asks of each ball, close together: the way to memory is most of what a quiet step costs.
    bodies: Vec<Body>,
    /// Pairs that may overlap; `None` where distances cannot be squared.
    near: Option<Near>,
    /// Square of the distance, in plan or in space, from which on no two balls overlap, length^2.
    bound: f64,
    exchanges: u64,
    contacts: u64,
    unattributed: u64,
}

/// One ball, as every step needs it.
#[derive(Clone, Copy, Debug)]
struct Body {
    mass: f64,
    /// Moment of inertia, mass * length^2; `None` where balls do not turn.
    inertia: Option<f64>,
    /// Kinetic energy at the start of the step, mass * length^2/s^2.
    energy: f64,
}

impl Body {
    /// Kinetic energy of this ball in `state`, mass * length^2/s^2.
    fn energy_in(&self, state: &State) -> f64 {
        kinetic_energy(state, self.mass, self.inertia)
    }
}

/// What is known of one ball within one step.
#[derive(Clone, Copy, Debug, Default)]
struct BallStep {
    /// Motion after the exchanges processed so far; `None` before the first.
    motion: Option<Motion>,
    /// Exchanges still to come.
    left: u32,
    /// Sum of all impulses, mass * length/s.
    impulse: Vec3,
    /// Sum of the sizes of the impulses by other balls, mass * length/s.
    pressed: f64,
    /// Label of the group of balls that exchange momentum in this step.
    group: usize,
    /// Whether a cushion takes momentum from the ball.
    cushion: bool,
}

impl<'a> Journal<'a> {
    /// A journal that starts at time 0 with the states `initial`.
    pub fn new(
        scene: &'a Scene,
        provenance: Provenance,
        record: Record,
        initial: &[State],
        ulp: f64,
    ) -> Self {
        let rest_speed = rest_speed(scene);
        let felt = Felt::new(scene, ulp);
        let turns = felt.rotational().is_some();
        let rub = scene.effects.friction;
        let largest_radius = scene.balls.iter().map(|b| b.radius).fold(0.0, f64::max);
        let states_that = |holds: &dyn Fn(&State, f64) -> bool| -> Vec<bool> {
            let balls = initial.iter().zip(&scene.balls);
            balls
                .map(|(state, ball)| holds(state, ball.radius))
                .collect()
        };
        Journal {
            scene,
            recorder: Recorder::new(scene, provenance, record, initial),
            rest_speed,
            felt,
            rub: rub.map_or(0.0, |law| friction::coefficient(law, 0.0)),
            noise: ROUNDING_ULPS * ulp * top_speed(scene),
            steps: 0,
            episodes: Vec::new(),
            moving: initial.iter().map(|s| s.speed() > rest_speed).collect(),
            sliding: states_that(&|state, radius| turns && felt.slides(state, radius)),
            spinning: states_that(&|state, radius| turns && felt.spins(state, radius)),
            aloft: vec![false; initial.len()],
            in_play: vec![true; initial.len()],
            left: Vec::new(),
            balls: vec![BallStep::default(); initial.len()],
            used: true,
            inner: inner(scene),
            bodies: (initial.iter().enumerate())
                .map(|(ball, state)| {
                    let mass = scene.balls[ball].mass;
                    let inertia = scene.inertia(ball);
                    Body {
                        mass,
                        inertia,
                        energy: kinetic_energy(state, mass, inertia),
                    }
                })
                .collect(),
            near: Near::new(2.0 * largest_radius, initial.len()),
            bound: (2.0 * largest_radius).powi(2) * (1.0 + ROUNDING),
            exchanges: 0,
            contacts: 0,
            unattributed: 0,
        }
    }

    /// True when no ball in play moves or spins.
    pub fn all_at_rest(&self, states: &[State]) -> bool {
        let rests = |(i, state): (usize, &State)| {
            !exceeds(state, self.rest_speed) && !self.spinning[i] && !self.sliding[i]
                || !self.in_play[i]
        };
        states.iter().enumerate().all(rests)
    }

    /// The balls that left play in the last step.
    pub fn left(&self) -> &[usize] {
        &self.left
    }

    /// What acts on a ball besides the engine's own forces in a step of `dt` that begins in `state`.
    pub fn load(&self, ball: usize, state: &State, dt: f64) -> Load {
        if self.aloft[ball] || !self.in_play[ball] {
            return Load::NONE;
        }
        let body = &self.scene.balls[ball];
        let slides = self.sliding[ball];
        self.felt.load(state, slides, body.mass, body.radius, dt)
    }

    /// True when the scene has a cloth of which an engine may lack something.
    pub fn loads(&self) -> bool {
        self.felt.rotational().is_some()
    }

    /// Writes one step. `before` and `after` are in scene order; `pushes` is reordered and loses what is only rounding.
    ///
    /// `presses`: normal impulse of the cloth on every ball in the step, mass * length/s; read only where [`Journal::loads`].
    pub fn step(
        &mut self,
        span: Span,
        before: &[State],
        after: &[State],
        pushes: &mut Vec<Push>,
        presses: &[f64],
    ) {
        self.contacts += pushes.len() as u64;
        self.prepare(span, before, after, pushes, presses);
        pushes.retain(|push| self.is_exchange(push));
        pushes.sort_unstable_by_key(|push| match push.other {
            Other::Ball(other) => (0, push.ball, other),
            Other::Cushion(side) => (1, push.ball, side as usize),
        });
        for push in pushes.iter() {
            self.balls[push.ball].left += 1;
            if let Other::Ball(other) = push.other {
                self.balls[other].left += 1;
            }
        }
        for push in pushes.iter() {
            self.exchange(span, before, after, push);
        }
        self.extrema(span, before, after, pushes, presses);
        self.pockets(span, before, after);
        self.phases(span, before, after);
        self.stops(span, before, after);
        self.hops(span, before, after);
        self.steps += 1;
        // the cadence is a multiple of the step as written, not as rounded
        let rounding = 1e-6 * (span.end - span.start);
        if self.recorder.due(span.end + rounding) {
            self.recorder.sample(span.end, after);
        }
    }

    /// Ends the trace after `steps` steps in `states`.
    pub fn finish(
        self,
        time: f64,
        states: &[State],
        ending: Ending,
        steps: u64,
        substeps: u64,
    ) -> Trace {
        let counters = [
            (Counter::Steps, steps),
            (Counter::Substeps, substeps),
            (Counter::Contacts, self.contacts),
            (Counter::Exchanges, self.exchanges),
            (Counter::Unattributed, self.unattributed),
        ];
        self.recorder.finish(time, states, ending, counters)
    }

    /// Sums the impulses on each ball and counts velocity changes that neither they nor the cloth explain.
    fn prepare(
        &mut self,
        span: Span,
        before: &[State],
        after: &[State],
        pushes: &[Push],
        presses: &[f64],
    ) {
        // in most steps nothing was written of any ball
        let used = std::mem::replace(&mut self.used, !pushes.is_empty());
        let stale = if used { &mut self.balls[..] } else { &mut [] };
        for (index, ball) in stale.iter_mut().enumerate() {
            *ball = BallStep {
                group: index,
                ..BallStep::default()
            };
        }
        for push in pushes {
            self.balls[push.ball].impulse += push.impulse;
            if let Other::Ball(other) = push.other {
                self.balls[other].impulse -= push.impulse;
                let pressed = push.impulse.norm();
                self.balls[push.ball].pressed += pressed;
                self.balls[other].pressed += pressed;
            }
        }
        let dt = span.end - span.start;
        let pushed = !pushes.is_empty();
        for (index, body) in self.bodies.iter().enumerate() {
            let mut left = after[index].velocity - before[index].velocity;
            // the cloth takes mu g dt in any direction of the plan, to its own solver's accuracy; the impulses are normal
            let cloth = self.felt.most_drag(presses[index] / body.mass, dt) * dt;
            let mut explained = 1.001 * cloth + self.noise;
            if pushed {
                let ball = &self.balls[index];
                left -= ball.impulse / body.mass;
                explained += self.rub * ball.pressed / body.mass;
            }
            // the sum is no less than the norm, and needs no root
            let within = left.x.abs() + left.y.abs() <= explained;
            if !within && left.xy().norm() > explained {
                self.unattributed += 1;
            }
        }
    }

    /// True when a push changes a velocity by more than rounding.
    fn is_exchange(&self, push: &Push) -> bool {
        let mass = |ball: usize| self.scene.balls[ball].mass;
        let lightest = match push.other {
            Other::Ball(other) => mass(push.ball).min(mass(other)),
            Other::Cushion(_) => mass(push.ball),
        };
        push.impulse.norm() > self.noise * lightest
    }

    /// Writes one exchange: a new event, or one more of a contact that was there in the step before.
    fn exchange(&mut self, span: Span, before: &[State], after: &[State], push: &Push) {
        self.exchanges += 1;
        let kind = match push.other {
            Other::Ball(other) => EventKind::ball_ball(push.ball, other),
            Other::Cushion(side) => EventKind::BallCushion(push.ball as u32, side),
        };
        let event = self.event(span.end, kind);
        self.jump(span, before, after, push.ball, push.impulse, event);
        if let Other::Ball(other) = push.other {
            self.jump(span, before, after, other, -push.impulse, event);
        }
    }

    /// Index of the event of a contact's episode, which begins or goes on in this step.
    fn event(&mut self, time: f64, kind: EventKind) -> u32 {
        let step = self.steps;
        self.episodes.retain(|open| open.last_step + 1 >= step);
        if let Some(open) = self.episodes.iter_mut().find(|open| open.kind == kind) {
            open.exchanges += 1;
            open.last_step = step;
            self.recorder.set_exchanges(open.event, open.exchanges);
            return open.event;
        }
        let event = self.recorder.event(time, kind, Some(1));
        self.episodes.push(Episode {
            kind,
            event,
            exchanges: 1,
            last_step: step,
        });
        event
    }

    /// Both sides of what one exchange did to one ball.
    fn jump(
        &mut self,
        span: Span,
        before: &[State],
        after: &[State],
        ball: usize,
        impulse: Vec3,
        event: u32,
    ) {
        let near = self.near(span, before, after, ball);
        self.balls[ball].left -= 1;
        let mut far = after[ball];
        // of several exchanges in one step the last ends in the velocity that the engine has
        if self.balls[ball].left > 0 {
            far.velocity = near.velocity + impulse / self.scene.balls[ball].mass;
            far.spin = near.spin;
        }
        self.balls[ball].motion = Some(Motion {
            velocity: far.velocity,
            spin: far.spin,
        });
        self.recorder.jump(ball, span.end, &near, &far, event);
    }

    /// The near side of the next thing that happens to a ball in this step.
    fn near(&mut self, span: Span, before: &[State], after: &[State], ball: usize) -> State {
        self.used = true;
        let Motion { velocity, spin } = match self.balls[ball].motion {
            Some(motion) => motion,
            None => {
                self.recorder.pin(ball, span.start, &before[ball]);
                let radius = self.scene.balls[ball].radius;
                let dt = span.end - span.start;
                let slides = self.sliding[ball];
                let mut coasting = self.felt.coast(&before[ball], slides, radius, dt);
                // gravity settles a ball within a step; only friction of another ball makes it hop
                if self.rub == 0.0 {
                    coasting.velocity.z = after[ball].velocity.z;
                }
                coasting
            }
        };
        self.balls[ball].motion = Some(Motion { velocity, spin });
        State {
            velocity,
            spin,
            ..after[ball]
        }
    }

    /// Writes the balls that left play in a step, and books the energy that they took along.
    fn pockets(&mut self, span: Span, before: &[State], after: &[State]) {
        self.left.clear();
        let Some(pockets) = &self.scene.effects.pockets else {
            return;
        };
        for ball in 0..after.len() {
            if !self.in_play[ball] {
                continue;
            }
            let way = after[ball].position - before[ball].position;
            let enters = |circle: &[f64; 3]| {
                let nearest = nearest(&before[ball].position, &way, circle);
                pockets::depth(circle, &nearest) >= 0.0
            };
            if let Some(pocket) = pockets.circles.iter().position(enters) {
                self.in_play[ball] = false;
                self.left.push(ball);
                let near = self.near(span, before, after, ball);
                self.recorder.pocket(ball, span.end, &near, pocket as u32);
                let taken = self.bodies[ball].energy_in(&after[ball]);
                self.recorder.energy_change(span.end, -taken, ball, None);
            }
        }
    }

    /// Writes where balls began to roll and where they lost their spin.
    fn phases(&mut self, span: Span, before: &[State], after: &[State]) {
        if self.felt.rotational().is_none() {
            return;
        }
        for ball in 0..after.len() {
            if !self.in_play[ball] {
                continue;
            }
            let radius = self.scene.balls[ball].radius;
            let slides = self.felt.slides(&after[ball], lever(&before[ball], radius));
            let spins = self.felt.spins(&after[ball], radius);
            let ended = [
                (
                    self.sliding[ball] && !slides,
                    EventKind::SlideToRoll(ball as u32),
                ),
                (
                    self.spinning[ball] && !spins,
                    EventKind::SpinEnd(ball as u32),
                ),
            ];
            for (_, kind) in ended.into_iter().filter(|(ended, _)| *ended) {
                let near = self.near(span, before, after, ball);
                self.recorder
                    .phase(ball, span.end, &near, &after[ball], kind);
                self.balls[ball].motion = Some(Motion {
                    velocity: after[ball].velocity,
                    spin: after[ball].spin,
                });
            }
            self.sliding[ball] = slides;
            self.spinning[ball] = spins;
        }
    }

    /// Writes the stops of a step.
    fn stops(&mut self, span: Span, before: &[State], after: &[State]) {
        for ball in 0..after.len() {
            if !self.in_play[ball] {
                continue;
            }
            if exceeds(&after[ball], self.rest_speed) {
                self.moving[ball] = true;
            } else if self.moving[ball] {
                self.moving[ball] = false;
                let near = self.near(span, before, after, ball);
                self.recorder.stop(ball, span.end, &near, &after[ball]);
            }
        }
    }

    /// Pins the steps in which a ball hops off its cloth, and those in which the cloth stops its fall; neither is an event.
    ///
    /// Friction of another ball lifts a ball. A ball that rolls fast falls for a few steps when the run begins, until it lies so
    /// deep that its turning points of contact still touch.
    fn hops(&mut self, span: Span, before: &[State], after: &[State]) {
        if self.felt.rotational().is_none() {
            return;
        }
        let chatter = 2.0 * self.scene.gravity * (span.end - span.start);
        for ball in 0..after.len() {
            let aloft = is_aloft(&after[ball], self.scene.balls[ball].radius);
            let jump = (after[ball].velocity.z - before[ball].velocity.z).abs();
            if self.in_play[ball] && (aloft != self.aloft[ball] || jump > chatter) {
                if self.balls[ball].motion.is_none() {
                    self.recorder.pin(ball, span.start, &before[ball]);
                }
                self.recorder.pin(ball, span.end, &after[ball]);
            }
            self.aloft[ball] = aloft;
        }
    }

    /// Books what should stay small. `pushes` are the exchanges of the step.
    fn extrema(
        &mut self,
        span: Span,
        before: &[State],
        after: &[State],
        pushes: &[Push],
        presses: &[f64],
    ) {
        self.energy(span.end, after, pushes);
        if !pushes.is_empty() {
            self.momentum(span, before, after, pushes, presses);
        }
        if self.scene.effects.contact.is_some() {
            self.overlaps(span.end, after);
        }
        if let (Some(_), Some(table)) = (self.scene.effects.cushion, self.scene.table) {
            let [[x0, x1], [y0, y1]] = self.inner;
            for (index, state) in after.iter().enumerate() {
                let (x, y) = (state.position.x, state.position.y);
                let inside = (x >= x0) & (x <= x1) & (y >= y0) & (y <= y1);
                if inside || !self.in_play[index] {
                    continue;
                }
                for side in Side::ALL {
                    let reach = table.reach(side, self.scene.balls[index].radius);
                    let beyond = f64::from(side.sign()) * (state.position[side.axis()] - reach);
                    // the extremum begins at 0
                    if beyond > 0.0 {
                        self.recorder.outside(span.end, beyond, index);
                    }
                }
            }
        }
    }

    fn energy(&mut self, time: f64, after: &[State], pushes: &[Push]) {
        let (mut total, mut largest, mut winner) = (0.0, f64::NEG_INFINITY, 0);
        for (index, (body, state)) in self.bodies.iter_mut().zip(after).enumerate() {
            let now = body.energy_in(state);
            let change = now - body.energy;
            body.energy = now;
            total += change;
            if change > largest {
                (largest, winner) = (change, index);
            }
        }
        // who gained it: the pair that met, if one did
        let (ball, other) = match pushes.first() {
            Some(push) => match push.other {
                Other::Ball(other) => (push.ball, Some(other)),
                Other::Cushion(_) => (push.ball, None),
            },
            None => (winner, None),
        };
        self.recorder.energy_change(time, total, ball, other);
    }

    /// Momentum of each group of balls that meet in this step, beyond what the cloth can take: mu m g dt a ball. Groups that
    /// meet a cushion as well have no sum to hold.
    fn momentum(
        &mut self,
        span: Span,
        before: &[State],
        after: &[State],
        pushes: &[Push],
        presses: &[f64],
    ) {
        for push in pushes {
            match push.other {
                Other::Cushion(_) => self.balls[push.ball].cushion = true,
                Other::Ball(other) => {
                    let (keep, drop) = (self.balls[push.ball].group, self.balls[other].group);
                    for ball in &mut self.balls {
                        if ball.group == drop {
                            ball.group = keep;
                        }
                    }
                }
            }
        }
        let dt = span.end - span.start;
        for push in pushes {
            let Other::Ball(other) = push.other else {
                continue;
            };
            let group = self.balls[push.ball].group;
            let (mut change, mut allowed, mut cushion) = (Vec3::zeros(), 0.0, false);
            for (index, ball) in self.balls.iter().enumerate() {
                if ball.group == group {
                    let mass = self.scene.balls[index].mass;
                    change += (after[index].velocity - before[index].velocity) * mass;
                    allowed += self.felt.most_drag(presses[index] / mass, dt) * mass * dt;
                    cushion |= ball.cushion;
                }
            }
            if !cushion {
                let error = (change.xy().norm() - allowed).max(0.0);
                self.recorder
                    .momentum_error(span.end, error, push.ball, other);
            }
        }
    }

    fn overlaps(&mut self, time: f64, after: &[State]) {
        let balls = &self.scene.balls;
        let reach = |a: usize, b: usize| balls[a].radius + balls[b].radius;
        let Some(mut near) = self.near.take() else {
            for a in 0..after.len() {
                for b in a + 1..after.len() {
                    self.overlap(time, after, a, b);
                }
            }
            return;
        };
        // in plan no two balls are farther apart than in space
        let plan = |state: &State| [state.position.x, state.position.y];
        near.place(after.iter().map(plan), reach);
        for pair in near.pairs() {
            let [a, b] = pair.map(|ball| ball as usize);
            let [first, second] = [near.now()[a], near.now()[b]];
            let apart = (first[0] - second[0]).powi(2) + (first[1] - second[1]).powi(2);
            // a gap is no extremum: most pairs need no root
            if apart < self.bound {
                self.overlap(time, after, a, b);
            }
        }
        self.near = Some(near);
    }

    fn overlap(&mut self, time: f64, after: &[State], a: usize, b: usize) {
        if !(self.in_play[a] && self.in_play[b]) {
            return;
        }
        let reach = self.scene.balls[a].radius + self.scene.balls[b].radius;
        let depth = reach - (after[a].position - after[b].position).norm();
        self.recorder.overlap(time, depth, a, b);
    }
}

/// True when a ball's centre is faster than `speed`, length/s. A component that is alone saves the root.
fn exceeds(state: &State, speed: f64) -> bool {
    let [x, y] = [state.velocity.x.abs(), state.velocity.y.abs()];
    x > speed || y > speed || state.speed() > speed
}

/// Where the cushions let every ball of a scene be: the least and the greatest x, and those of y, length.
fn inner(scene: &Scene) -> [[f64; 2]; 2] {
    let mut inner = [[f64::NEG_INFINITY, f64::INFINITY]; 2];
    let Some(table) = scene.table else {
        return inner;
    };
    for ball in &scene.balls {
        for side in Side::ALL {
            let reach = table.reach(side, ball.radius);
            let [least, greatest] = &mut inner[side.axis()];
            if side.sign() < 0 {
                *least = least.max(reach);
            } else {
                *greatest = greatest.min(reach);
            }
        }
    }
    inner
}

/// The point of the way from `start` that is nearest to the centre of a circle `[x, y, r]`, in plan.
fn nearest(start: &Vec3, way: &Vec3, [x, y, _]: &[f64; 3]) -> Vec3 {
    let to_centre = Vec3::new(x - start.x, y - start.y, 0.0);
    let length = way.xy().norm_squared();
    let share = if length > 0.0 {
        (to_centre.dot(way) / length).clamp(0.0, 1.0)
    } else {
        0.0
    };
    start + way * share
}

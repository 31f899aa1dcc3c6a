//! What every ball does, and the clock: each ball's course since its own last event.
//!
//! Only here does a ball change its course, and whoever holds the kinematics can rely on three things: the clock never goes back; every
//! change of a course is counted with its ball, so that a prediction made before it is known to be stale; and the number of balls that
//! move or turn is that of the courses. Everything else reads: an impact or the end of a phase is first decided as a value and
//! then set off.

use super::contact::group::Mode;
use super::contact::held::{Contacts, Held};
use super::encounter::{Encounter, rate_between, rate_to};
use super::flight::{Flight, Ground, Phase};
use super::spin::{Moving, Rotation, Spin, Turn};
use super::world::{Coarser, World};
use crate::math::{Real, Vec3};
use crate::physics::State;
use crate::scene::Scene;
use crate::trace::Spot;

/// How a ball goes on until its next event.
#[derive(Clone, Copy, Debug)]
pub struct Course<T> {
    /// How its centre moves.
    pub flight: Flight<T>,
    /// How it turns meanwhile; `None` in a scene that does not call for rotation.
    pub spin: Option<Spin<T>>,
}

impl<T: Real> Course<T> {
    /// True while the ball moves or turns.
    fn is_active(&self) -> bool {
        self.flight.moves() || self.spin.as_ref().is_some_and(Spin::turns)
    }
}

/// All balls at one time.
#[derive(Clone, Debug)]
pub struct Kinematics<'a, T: Real> {
    scene: &'a Scene,
    world: World<T>,
    flights: Vec<Flight<T>>,
    /// Empty in a scene that does not call for rotation.
    spins: Vec<Spin<T>>,
    /// How often every ball has changed its course.
    versions: Vec<u32>,
    /// Balls that are held together, and parties that part.
    contacts: Contacts<T>,
    /// True as long as there has been none of those: what every prediction asks.
    quiet: bool,
    /// Balls that move or turn.
    active: usize,
    now: T,
}

impl<'a, T: Real> Kinematics<'a, T> {
    /// A scene at time 0.
    pub fn new(scene: &'a Scene) -> Self {
        let world = World::new(scene);
        let (flights, spins) = world.first_flights(scene);
        Kinematics::begin(scene, world, flights, spins)
    }

    /// Balls at time 0 in a world of one's own.
    pub fn begin(
        scene: &'a Scene,
        world: World<T>,
        flights: Vec<Flight<T>>,
        spins: Vec<Spin<T>>,
    ) -> Self {
        let mut kinematics = Kinematics {
            scene,
            world,
            versions: vec![0; flights.len()],
            flights,
            spins,
            contacts: Contacts::new(),
            quiet: true,
            active: 0,
            now: T::zero(),
        };
        let all = 0..kinematics.count();
        kinematics.active = all
            .filter(|ball| kinematics.course_of(*ball).is_active())
            .count();
        kinematics
    }

    /// A scene at `time`, s, for a run that takes over from one in another scalar (see [`World::taking_over`]): every ball has yet to set off.
    pub fn taking_over(scene: &'a Scene, time: T, from: &Coarser<T>) -> Self {
        let new = Kinematics::new(scene);
        let mut balls = Kinematics {
            world: new.world.taking_over(from),
            now: time,
            ..new
        };
        for ball in 0..balls.count() {
            balls.take_out(ball);
        }
        balls
    }

    /// The same in a world of one's own.
    pub fn in_world(self, world: impl FnOnce(World<T>) -> World<T>) -> Self {
        Kinematics {
            world: world(self.world),
            ..self
        }
    }

    /// The scene: names, and the third dimension of states.
    pub fn scene(&self) -> &'a Scene {
        self.scene
    }

    /// What stays the same.
    #[inline]
    pub fn world(&self) -> &World<T> {
        &self.world
    }

    /// Number of balls.
    #[inline]
    pub fn count(&self) -> usize {
        self.flights.len()
    }

    /// The time, s.
    #[inline]
    pub fn now(&self) -> T {
        self.now
    }

    /// Sets the clock to `time`, s; never back.
    #[inline]
    pub fn advance(&mut self, time: T) {
        self.now = self.now.at_least(time).following(time);
    }

    /// How a ball moves at a time of its course, s.
    pub fn moving_at(&self, ball: usize, time: T) -> Moving<T> {
        let flight = &self.flights[ball];
        if !self.quiet
            && flight.phase == Phase::Held
            && let Some(moving) = (self.contacts.of(ball)).and_then(|held| held.at(ball, time))
        {
            return moving;
        }
        let (position, velocity) = flight.at(time);
        let spin = self.spins.get(ball);
        Moving {
            position,
            velocity,
            spin: spin.map_or([T::zero(); 3], |spin| spin.after(time - flight.start)),
        }
    }

    /// Gives what a ball does the derivatives of a course.
    pub fn derive(&mut self, ball: usize, course: &Course<T>) {
        self.flights[ball] = self.flights[ball].following(&course.flight);
        if let (Some(spin), Some(next)) = (self.spins.get_mut(ball), &course.spin) {
            *spin = spin.following(next);
        }
    }

    /// The group of a ball, to be given other derivatives; its values stay as they are.
    pub fn derive_held(&mut self, ball: usize) -> Option<&mut Held<T>> {
        self.contacts.of_mut(ball)
    }

    /// How the centres of all balls move.
    #[inline]
    pub fn flights(&self) -> &[Flight<T>] {
        &self.flights
    }

    /// How the centre of a ball moves.
    #[inline]
    pub fn flight(&self, ball: usize) -> &Flight<T> {
        &self.flights[ball]
    }

    /// How often a ball has changed its course.
    #[inline]
    pub fn version(&self, ball: usize) -> u32 {
        self.versions[ball]
    }

    /// The count of changes that a ball will have once it has set off again.
    #[inline]
    pub fn next_version(&self, ball: usize) -> u32 {
        self.versions[ball].wrapping_add(1)
    }

    /// True in a scene that calls for rotation.
    #[inline]
    pub fn rotates(&self) -> bool {
        !self.spins.is_empty()
    }

    /// True if no ball moves or turns.
    pub fn all_rest(&self) -> bool {
        self.active == 0
    }

    /// Centre and velocity of a ball now.
    #[inline]
    pub fn at(&self, ball: usize) -> ([T; 2], [T; 2]) {
        let flight = &self.flights[ball];
        if !self.quiet && flight.phase == Phase::Held {
            let moving = self.held_now(ball);
            return (moving.position, moving.velocity);
        }
        flight.at(self.now)
    }

    /// How a ball that is held moves now.
    #[cold]
    #[inline(never)]
    fn held_now(&self, ball: usize) -> Moving<T> {
        let flight = &self.flights[ball];
        let held = self.contacts.of(ball);
        let moving = held.and_then(|held| held.at(ball, self.now));
        // a ball whose group is given up is where it set out until it sets off again
        moving.unwrap_or_else(|| Moving {
            position: flight.position,
            velocity: flight.velocity,
            spin: (self.spins.get(ball)).map_or([T::zero(); 3], |spin| spin.start),
        })
    }

    /// Centre of a ball now.
    pub fn place(&self, ball: usize) -> [T; 2] {
        self.at(ball).0
    }

    /// Angular velocity of a ball now, rad/s; zero in a scene that does not call for rotation.
    #[inline]
    pub fn spin_now(&self, ball: usize) -> [T; 3] {
        match self.spins.get(ball) {
            None => [T::zero(); 3],
            Some(_) if self.is_held(ball) => self.held_now(ball).spin,
            Some(spin) => spin.after(self.now - self.flights[ball].start),
        }
    }

    /// How a ball moves now.
    pub fn moving(&self, ball: usize) -> Moving<T> {
        let (position, velocity) = self.at(ball);
        Moving {
            position,
            velocity,
            spin: self.spin_now(ball),
        }
    }

    /// The gap of two parties now, length; negative where they overlap.
    pub fn gap(&self, encounter: Encounter) -> T {
        match encounter {
            Encounter::Pair(a, b) => {
                let (p, q) = (self.place(a), self.place(b));
                let [x, y] = [0, 1].map(|i| q[i] - p[i]);
                (x * x + y * y).sqrt() - self.world.distance(a, b)
            }
            Encounter::Cushion(a, side) => {
                let beyond = self.world.reach[a][side as usize] - self.place(a)[side.axis()];
                if side.sign() < 0 { -beyond } else { beyond }
            }
        }
    }

    /// Rate of the gap of two parties now, length/s.
    pub fn rate(&self, encounter: Encounter) -> T {
        match encounter {
            Encounter::Pair(a, b) => rate_between(&self.moving(a), &self.moving(b)),
            Encounter::Cushion(a, side) => rate_to(&self.moving(a), side),
        }
    }

    /// The gap of two parties, length, and its rate, length/s, at a time of their courses, s.
    pub fn gap_at(&self, encounter: Encounter, time: T) -> (T, T) {
        match encounter {
            Encounter::Pair(a, b) => {
                let (one, other) = (self.moving_at(a, time), self.moving_at(b, time));
                let [x, y] = [0, 1].map(|i| other.position[i] - one.position[i]);
                let gap = (x * x + y * y).sqrt() - self.world.distance(a, b);
                (gap, rate_between(&one, &other))
            }
            Encounter::Cushion(a, side) => {
                let moving = self.moving_at(a, time);
                let beyond = self.world.reach[a][side as usize] - moving.position[side.axis()];
                let gap = if side.sign() < 0 { -beyond } else { beyond };
                (gap, rate_to(&moving, side))
            }
        }
    }

    /// What a ball does.
    pub fn course_of(&self, ball: usize) -> Course<T> {
        Course {
            flight: self.flights[ball],
            spin: self.spins.get(ball).copied(),
        }
    }

    /// How a ball would go on from here and now.
    #[inline]
    pub fn course(&self, ball: usize, moving: Moving<T>) -> Course<T> {
        match &self.world.rotation {
            None => Course {
                flight: Flight::new(
                    self.world.ground,
                    self.now,
                    moving.position,
                    moving.velocity,
                ),
                spin: None,
            },
            Some(rotation) => self.turning(rotation, ball, moving),
        }
    }

    /// The same of a ball that turns, kept out of the code of those that do not.
    #[cold]
    #[inline(never)]
    fn turning(&self, rotation: &Rotation<T>, ball: usize, moving: Moving<T>) -> Course<T> {
        let moving = if T::DIFFERENTIATES {
            rotation.unspun(moving)
        } else {
            moving
        };
        let (flight, spin) = rotation.depart(self.world.radius[ball], self.now, moving);
        Course {
            flight,
            spin: Some(spin),
        }
    }

    /// Puts a ball on another course.
    #[inline]
    pub fn set_off(&mut self, ball: usize, course: &Course<T>) {
        debug_assert!(self.contacts.of(ball).is_none(), "ball {ball} is held");
        let mut was_active = self.flights[ball].moves();
        let mut is_active = course.flight.moves();
        if let Some(next) = &course.spin
            && let Some(spin) = self.spins.get_mut(ball)
        {
            was_active |= spin.turns();
            is_active |= next.turns();
            *spin = *next;
        }
        self.active += usize::from(is_active);
        self.active -= usize::from(was_active);
        self.flights[ball] = course.flight;
        self.versions[ball] = self.next_version(ball);
    }

    /// Balls that are held together, and parties that part.
    #[inline]
    pub fn contacts(&self) -> &Contacts<T> {
        &self.contacts
    }

    /// Whether a ball is held by contacts.
    #[inline]
    pub fn is_held(&self, ball: usize) -> bool {
        !self.quiet && self.flights[ball].phase == Phase::Held
    }

    /// Whether any ball is held.
    #[inline]
    pub fn holds_any(&self) -> bool {
        !self.quiet && !self.contacts.held().is_empty()
    }

    /// True as long as nothing has been held, and nothing has parted.
    #[inline]
    pub fn is_quiet(&self) -> bool {
        self.quiet
    }

    /// Whether two parties are on the courses on which they parted.
    pub fn is_parting(&self, encounter: Encounter) -> bool {
        self.contacts
            .is_parting(encounter, |ball| self.versions[ball])
    }

    /// The parties that are on the courses on which they parted.
    pub fn parting(&self) -> Vec<Encounter> {
        self.contacts.parting(|ball| self.versions[ball])
    }

    /// What the cloth does to the centre of a ball that is not held; `None` of one that is out of play.
    pub fn mode(&self, ball: usize) -> Option<Mode> {
        let flight = &self.flights[ball];
        if !flight.position[0].is_finite() {
            return None;
        }
        let slides = self.spins.get(ball).is_some_and(|spin| spin.slides);
        Some(match (self.world.rotation, self.world.ground) {
            (Some(rotation), _) if rotation.slide <= T::zero() => Mode::Floats,
            (Some(_), _) if slides => Mode::Slides,
            (None, Ground::Frictionless) => Mode::Floats,
            _ if !flight.moves() => Mode::Rests,
            (Some(_), _) => Mode::Rolls,
            (None, Ground::Coulomb(_)) => Mode::Drags,
        })
    }

    /// Puts the balls of a group on their common course, from now on.
    #[cold]
    pub fn hold(&mut self, held: Held<T>) {
        let zero = T::zero();
        for (series, member) in held.arc.series.iter().zip(&held.group.members) {
            let moving = series.at(zero);
            let flight = Flight {
                start: self.now,
                end: self.now + held.arc.length,
                position: moving.position,
                velocity: moving.velocity,
                acceleration: [zero; 2],
                fastest: series.fastest,
                phase: Phase::Held,
            };
            let spin = self.rotates().then_some(Spin {
                start: moving.spin,
                rate: [zero; 3],
                turn: Turn::Never,
                slides: series.slides,
            });
            self.set_off(member.ball, &Course { flight, spin });
        }
        self.contacts.add(held);
        self.quiet = false;
    }

    /// How a ball of a group that is given up moves now.
    pub fn state_in(&self, held: &Held<T>, ball: usize) -> Moving<T> {
        match held.at(ball, self.now) {
            Some(moving) => moving,
            None => self.moving(ball),
        }
    }

    /// Gives up the group of a ball, all of whose balls have to set off next.
    #[cold]
    pub fn let_go(&mut self, ball: usize) -> Option<Held<T>> {
        self.contacts.remove(ball)
    }

    /// Notes that two parties part on the courses that they are on.
    #[cold]
    pub fn part(&mut self, encounter: Encounter) {
        let versions = &self.versions;
        self.contacts.forget(|ball| versions[ball]);
        self.contacts.part(encounter, |ball| versions[ball]);
        self.quiet = false;
    }

    /// Takes a ball out of play: from here on it is nowhere, and nothing meets it.
    #[cold]
    pub fn take_out(&mut self, ball: usize) {
        let zero = T::zero();
        let nowhere = Flight {
            start: self.now,
            end: T::lift(f64::INFINITY),
            position: [T::lift(f64::INFINITY); 2],
            velocity: [zero; 2],
            acceleration: [zero; 2],
            fastest: zero,
            phase: Phase::Rest,
        };
        let course = Course {
            flight: nowhere,
            spin: self.rotates().then(Spin::none),
        };
        self.set_off(ball, &course);
    }

    /// States with which all balls began what they do, in f64.
    pub fn first_states(&self) -> Vec<State> {
        let read = |ball: usize| {
            let flight = &self.flights[ball];
            let spin = self.spins.get(ball).map(|spin| spin.after(T::zero()));
            let spin = spin.unwrap_or([T::zero(); 3]);
            self.state(ball, flight.position, flight.velocity, spin)
        };
        (0..self.count()).map(read).collect()
    }

    /// States of all balls now, in f64.
    pub fn states(&self) -> Vec<State> {
        let read = |ball: usize| {
            let (position, velocity) = self.at(ball);
            self.state(ball, position, velocity, self.spin_now(ball))
        };
        (0..self.count()).map(read).collect()
    }

    /// A state in f64 for the trace: what is given, in the plane of the ball's centre.
    pub fn state(&self, ball: usize, position: [T; 2], velocity: [T; 2], spin: [T; 3]) -> State {
        let height = self.scene.balls[ball].state.position.z;
        State {
            position: Vec3::new(position[0].to_f64(), position[1].to_f64(), height),
            velocity: Vec3::new(velocity[0].to_f64(), velocity[1].to_f64(), 0.0),
            spin: spin.map(T::to_f64).into(),
        }
    }

    /// The same of how a ball moves.
    pub fn state_of(&self, ball: usize, moving: &Moving<T>) -> State {
        self.state(ball, moving.position, moving.velocity, moving.spin)
    }

    /// Here and now.
    pub fn spot(&self, balls: &[usize], why: &str) -> Spot {
        Spot {
            time: self.now.to_f64(),
            balls: balls.iter().map(|b| *b as u32).collect(),
            why: why.to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::random::Draws;
    use crate::scene::catalogue;

    fn scene(name: &str) -> Scene {
        catalogue::scene(name).unwrap_or_else(|error| panic!("{error}"))
    }

    /// A ball that moves, turns on the spot, or does neither.
    fn drawn(balls: &Kinematics<'_, f64>, ball: usize, draws: &mut Draws) -> Moving<f64> {
        let velocity = [draws.between(-1.0, 1.0), draws.between(-1.0, 1.0)];
        let turning = [0.0, 0.0, draws.between(-9.0, 9.0)];
        let (velocity, spin) = match draws.bits() % 3 {
            0 => (velocity, turning),
            1 => ([0.0; 2], turning),
            _ => ([0.0; 2], [0.0; 3]),
        };
        Moving {
            position: balls.place(ball),
            velocity,
            spin,
        }
    }

    #[test]
    fn every_change_of_a_course_is_counted_with_its_ball_and_in_what_is_active() {
        // without rotation, and with it
        for name in ["report-break", "pool-break"] {
            let scene = scene(name);
            let mut balls = Kinematics::<f64>::new(&scene);
            let mut draws = Draws::new(3, 0);
            let mut rested = 0;
            for round in 0..400 {
                balls.advance(0.01 * f64::from(round));
                let ball = (draws.bits() % balls.count() as u64) as usize;
                let versions = balls.versions.clone();
                if round % 50 == 49 {
                    balls.take_out(ball);
                } else {
                    let course = balls.course(ball, drawn(&balls, ball, &mut draws));
                    balls.set_off(ball, &course);
                }
                for (other, before) in versions.iter().enumerate() {
                    let changes = u32::from(other == ball);
                    assert_eq!(balls.version(other), before + changes, "{name}, {round}");
                }
                let all = 0..balls.count();
                let active = all.filter(|b| balls.course_of(*b).is_active()).count();
                assert_eq!(balls.active, active, "{name}, round {round}");
                assert_eq!(balls.all_rest(), active == 0);
                rested += usize::from(!balls.course_of(ball).is_active());
            }
            assert!(rested > 50 && rested < 350, "{name}: {rested} rested");
        }
    }

    #[test]
    fn the_clock_never_goes_back() {
        let scene = scene("report-break");
        let mut balls = Kinematics::<f64>::new(&scene);
        for (time, now) in [(1.0, 1.0), (0.5, 1.0), (1.0, 1.0), (2.0, 2.0)] {
            balls.advance(time);
            assert_eq!(balls.now(), now);
        }
    }

    #[test]
    fn a_ball_out_of_play_is_nowhere_and_stays_there() {
        let scene = scene("pool-break");
        let mut balls = Kinematics::<f64>::new(&scene);
        balls.take_out(0);
        balls.advance(3.0);
        assert_eq!(balls.place(0), [f64::INFINITY; 2]);
        assert!(!balls.course_of(0).is_active());
    }
}

//! The event loop: take the earliest event, decide what it does, let its balls set off, predict again.
//!
//! Only the balls of an event are touched. Every other ball stays where its own last event left it, so nothing is
//! accumulated. The loop never decides what the scalar cannot tell: it ends with the reason instead.
//!
//! It owns four parts and is the only one to change them: what the balls do (`kinematics`), what comes next (`agenda`), impacts
//! while no time passes (`collapse`), and what is written down (`journal`). An event is a value before it is applied: `impact`,
//! `cluster_impact` and `phases` decide it from the kinematics, `ambiguity` whether it stands alone.

use super::AtContacts;
use super::agenda::{Agenda, Due, Partners, Work};
use super::ambiguity::{self, Standing};
use super::cluster_impact::ClusterImpact;
use super::collapse::Streaks;
use super::contact::domain::{is_followed, starts_pressed};
use super::derived::Derived;
use super::encounter::Encounter;
use super::impact::{Impact, ImpactSide};
use super::journal::Journal;
use super::kinematics::Kinematics;
use super::phases::PhaseEnd;
use super::predict::{Row, Watch};
use super::queue::{Candidate, What};
use super::range::unfit;
use crate::engine::Limits;
use crate::math::Real;
use crate::physics::Side;
use crate::scene::Scene;
use crate::trace::{Counter, Ending, Provenance, Record, Trace};
use std::array;

/// A run in the scalar `T` that has not begun.
#[derive(Clone, Debug)]
pub struct Solver<'a, T: Real> {
    balls: Kinematics<'a, T>,
    partners: Partners,
    contacts: AtContacts,
    derived: Option<Box<Derived>>,
}

impl<'a, T: Real> Solver<'a, T> {
    /// A scene at time 0.
    pub fn new(scene: &'a Scene) -> Self {
        Solver::of(Kinematics::new(scene))
    }

    /// Balls at time 0.
    pub(super) fn of(balls: Kinematics<'a, T>) -> Self {
        Solver {
            balls,
            partners: Partners::Auto,
            contacts: AtContacts::Auto,
            derived: None,
        }
    }

    /// The same run, in dual numbers, with what their derivatives are for.
    pub(super) fn deriving(self, derived: Derived) -> Self {
        Solver {
            derived: Some(Box::new(derived)),
            ..self
        }
    }

    /// The same run with predictions that look at `partners`.
    pub fn looking_at(self, partners: Partners) -> Self {
        Solver { partners, ..self }
    }

    /// The same run, which ends or goes on where contacts last.
    pub fn at_contacts(self, contacts: AtContacts) -> Self {
        Solver { contacts, ..self }
    }

    /// What is inside: the balls at time 0.
    pub fn balls(&self) -> &Kinematics<'a, T> {
        &self.balls
    }

    /// Runs to an ending.
    pub fn run(self, provenance: Provenance, record: Record, limits: &Limits<'_>) -> Trace {
        self.play(provenance, record, limits, false).trace()
    }

    /// Runs to an ending. `times`: whether the time of every event is kept in the scalar of the run.
    pub fn play(
        self,
        provenance: Provenance,
        record: Record,
        limits: &Limits<'_>,
        times: bool,
    ) -> Played<'a, T> {
        let Solver {
            balls,
            partners,
            contacts,
            derived,
        } = self;
        let journal = Journal::new(&balls, provenance, record, times);
        if let Some(ending) = unfit(&balls) {
            return Played {
                ending,
                balls,
                journal,
                derived,
                work: Work::default(),
            };
        }
        let run = Loop {
            agenda: Agenda::new(&balls, partners),
            streaks: Streaks::new(balls.count()),
            slow: if contacts != AtContacts::Collapse && balls.world().presses() {
                balls.world().blurs()
            } else {
                T::lift(f64::NEG_INFINITY) // none is
            },
            begun: Vec::new(),
            // asked where the first slow impact is
            is_open: contacts == AtContacts::Auto,
            is_fine: false,
            blurred: false,
            derived,
            balls,
            journal,
        };
        let (ending, mut run) = run.run(limits);
        for held in run.balls.contacts().held() {
            run.journal.stretch(&run.balls, held);
        }
        Played {
            ending,
            work: run.agenda.work(),
            balls: run.balls,
            derived: run.derived,
            journal: run.journal,
        }
    }
}

/// A run that came to its end.
pub struct Played<'a, T: Real> {
    ending: Ending,
    balls: Kinematics<'a, T>,
    journal: Journal<T>,
    work: Work,
    derived: Option<Box<Derived>>,
}

impl<'a, T: Real> Played<'a, T> {
    /// The balls at the end.
    pub fn balls(&self) -> &Kinematics<'a, T> {
        &self.balls
    }

    /// What went along with a run in dual numbers.
    pub(super) fn derived(&self) -> Option<&Derived> {
        self.derived.as_deref()
    }

    /// The same, to be kept.
    pub(super) fn take_derived(&mut self) -> Option<Derived> {
        self.derived.take().map(|derived| *derived)
    }

    /// Times of the events, s; empty if they were not kept.
    pub fn take_times(&mut self) -> Vec<T> {
        self.journal.take_times()
    }

    /// The trace, rounded to f64.
    pub fn trace(self) -> Trace {
        let work = [
            (Counter::CellCrossings, self.work.crossings),
            (Counter::CellLayouts, self.work.layouts),
            (Counter::RootCalls, self.work.searches),
        ];
        self.journal.finish(&self.balls, self.ending, work)
    }
}

/// A run under way.
pub(super) struct Loop<'a, T: Real> {
    pub(super) balls: Kinematics<'a, T>,
    pub(super) agenda: Agenda<T>,
    /// How often each ball was hit without time passing.
    pub(super) streaks: Streaks<T>,
    /// The speed below which the scalar does not tell how impacts go on that shrink, length/s.
    pub(super) slow: T,
    /// Contacts that this run has brought about, which no convention of the scene speaks of.
    pub(super) begun: Vec<Encounter>,
    /// Whether it is open yet whether contacts are followed in this scene.
    pub(super) is_open: bool,
    /// Whether this run has taken over from one with fewer digits.
    pub(super) is_fine: bool,
    /// Whether this scalar no longer tells what happens now.
    pub(super) blurred: bool,
    /// What goes along with a run in dual numbers.
    pub(super) derived: Option<Box<Derived>>,
    pub(super) journal: Journal<T>,
}

impl<T: Real> Loop<'_, T> {
    /// Runs to an ending.
    fn run(mut self, limits: &Limits<'_>) -> (Ending, Self) {
        loop {
            let due = self.agenda.due(&self.balls);
            if let Due::Nothing = due {
                return (self.nothing_left(), self);
            }
            if limits.is_cancelled() {
                return (Ending::Cancelled, self);
            }
            match due {
                Due::Nothing => {}
                Due::Upkeep(time, upkeep) => {
                    self.balls.advance(time);
                    self.agenda.keep_up(&self.balls, upkeep);
                }
                Due::Event(time, what) => {
                    if self.journal.events() >= limits.max_events {
                        let why = format!("the limit of {} events is reached", limits.max_events);
                        return (Ending::Budget(self.balls.spot(&what.balls(), &why)), self);
                    }
                    let time = if T::DIFFERENTIATES {
                        if self.is_past(time) {
                            return (Ending::Cancelled, self);
                        }
                        self.moved(time, what)
                    } else {
                        time
                    };
                    self.balls.advance(time);
                    let mut ending = self.happen(what);
                    if self.blurred {
                        (ending, self) = self.finer(what, limits);
                    }
                    if T::DIFFERENTIATES {
                        self.note();
                    }
                    if let Some(ending) = ending {
                        return (ending, self);
                    }
                }
            }
        }
    }

    /// The end of a run in which nothing happens any more.
    fn nothing_left(&mut self) -> Ending {
        if self.balls.all_rest() && !self.balls.scene().run_to_duration {
            return Ending::Rest;
        }
        self.balls.advance(self.balls.world().duration);
        Ending::Duration
    }

    /// An event; answers whether it ends the run.
    #[inline]
    pub(super) fn happen(&mut self, what: What) -> Option<Ending> {
        match what {
            What::Pair(a, b) => self.pair(a as usize, b as usize),
            What::Cushion(a, side) => self.cushion(a as usize, side),
            What::Pocket(a, pocket) => self.pocket(a as usize, pocket),
            What::End(a) => self.phase_end(a as usize),
            What::UnclearPair(..) | What::UnclearCushion(..) | What::UnclearPocket(..) => {
                self.unclear(what)
            }
            // upkeep of the agenda, which it does not take for an event
            What::Leaving(..) | What::Nothing => None,
        }
    }

    /// Rounding decides whether something happens.
    #[cold]
    fn unclear(&mut self, what: What) -> Option<Ending> {
        let encounter = match what {
            What::UnclearPair(a, b) => Some(Encounter::Pair(a as usize, b as usize)),
            What::UnclearCushion(a, side) => Some(Encounter::Cushion(a as usize, side)),
            _ => None,
        };
        // where contacts have begun what is unclear belongs to them; elsewhere the scene is too close to call
        let slow = encounter.filter(|encounter| {
            let touched = self.begun.iter().flat_map(|begun| begun.balls());
            let mut touched = touched.filter(|ball| encounter.involves(*ball));
            touched.next().is_some() && self.balls.rate(*encounter).abs() < self.slow
        });
        match slow {
            Some(encounter) => self.shrinks(encounter),
            None => Some(self.undecidable(what)),
        }
    }

    #[cold]
    fn undecidable(&self, what: What) -> Ending {
        let why = match what {
            What::UnclearCushion(_, side) => format!(
                "it stops so close to {} that rounding decides whether it touches",
                side.id()
            ),
            What::UnclearPocket(_, pocket) => {
                format!(
                    "it passes pocket p{pocket} so closely that rounding decides whether it falls"
                )
            }
            _ => "they pass so closely, or so slowly, that rounding decides whether they touch"
                .to_owned(),
        };
        Ending::Undecidable(self.balls.spot(&what.balls(), &why))
    }

    /// Two balls meet.
    #[inline(never)]
    pub(super) fn pair(&mut self, a: usize, b: usize) -> Option<Ending> {
        if !self.balls.is_quiet() && (self.balls.is_held(a) || self.balls.is_held(b)) {
            return self.struck_together(Encounter::Pair(a, b));
        }
        let law = self.balls.world().contact?;
        let impact = Impact::of_balls(&self.balls, law, a, b);
        self.impact(&impact)
    }

    /// A ball meets a cushion.
    #[inline(never)]
    pub(super) fn cushion(&mut self, a: usize, side: Side) -> Option<Ending> {
        if self.balls.is_held(a) {
            return self.struck_together(Encounter::Cushion(a, side));
        }
        let law = self.balls.world().cushion?;
        if T::DIFFERENTIATES {
            self.note_error(Impact::error_on_cushion(&self.balls, law, a, side));
        }
        let impact = Impact::on_cushion(&self.balls, law, a, side);
        self.impact(&impact)
    }

    /// Applies an impact, unless others at this instant have a say in it.
    #[inline(always)]
    fn impact<const N: usize>(&mut self, impact: &Impact<T, N>) -> Option<Ending> {
        let sides = &impact.sides;
        if impact.closing < self.slow && self.follows() {
            if self.is_still(impact.encounter, impact.closing) {
                return self.touch(impact.encounter);
            }
            return self.shrinks(impact.encounter);
        }
        let fault = impact.fault(&self.balls);
        if let Some(ending) = fault.or_else(|| self.streak(sides)) {
            return Some(ending);
        }
        let world = self.balls.world();
        let window = world.time_error(self.balls.now(), impact.closing) * T::lift(2.0);
        let reach = world.touching + world.fastest * window;
        let mut watch = Watch::new(reach, Some(impact.encounter));
        let next: [Candidate<T>; N] = array::from_fn(|i| self.foresee(i, sides, &mut watch));
        let ending = if watch.is_clear() {
            None
        } else {
            match ambiguity::standing(&self.balls, &self.agenda, sides, window, watch) {
                Standing::Alone => None,
                // what this run brought together it also resolves together
                Standing::Ambiguous { balls, .. } if self.has_begun(&balls) => {
                    return self.resolve_together(impact.encounter, sides, window);
                }
                Standing::Ambiguous { balls, happened } => {
                    let ending = Some(ambiguity::indeterminate(&self.balls, &balls));
                    if !happened {
                        return ending;
                    }
                    ending
                }
                Standing::Together => {
                    return self.resolve_together(impact.encounter, sides, window);
                }
            }
        };
        for side in sides {
            self.balls.set_off(side.ball, &side.course);
        }
        for (side, next) in sides.iter().zip(&next) {
            self.agenda.schedule(side.ball, *next);
        }
        self.journal.impact(&self.balls, impact);
        ending
    }

    /// Whether what is slow is followed.
    #[cold]
    fn follows(&mut self) -> bool {
        let scene = self.balls.scene();
        let is_open = std::mem::take(&mut self.is_open);
        if is_open && (!is_followed(scene) || starts_pressed(scene)) {
            self.slow = T::lift(f64::NEG_INFINITY);
        }
        self.slow > T::zero()
    }

    /// The next event of the `i`th ball of an impact, all of whose balls would set off now. `watch` is told what is near.
    #[inline]
    fn foresee(&mut self, i: usize, sides: &[ImpactSide<T>], watch: &mut Watch<T>) -> Candidate<T> {
        let row = Row::setting_off(&self.balls, sides[i].ball, &sides[i].course.flight);
        let row = match (i, sides) {
            (0, [_, mate]) => row.with(mate.ball, &mate.course.flight),
            // the pair itself belongs to the row of the first
            (1, [first, _]) => row.without_ball(first.ball),
            _ => row,
        };
        self.agenda.foresee(&row, Some(watch))
    }

    /// An instant with several contacts: with those that are held, if there are any.
    #[cold]
    fn resolve_together(
        &mut self,
        encounter: Encounter,
        sides: &[ImpactSide<T>],
        window: T,
    ) -> Option<Ending> {
        if self.balls.contacts().held().is_empty() {
            self.cluster_impact(sides, window)
        } else {
            self.struck_together(encounter)
        }
    }

    /// Applies what the scene's convention makes of an instant with several contacts; `seeds`: the impact under which it showed.
    #[cold]
    fn cluster_impact(&mut self, seeds: &[ImpactSide<T>], window: T) -> Option<Ending> {
        let seeds: Vec<usize> = seeds.iter().map(|side| side.ball).collect();
        let found = ClusterImpact::of(&self.balls, &self.agenda, &seeds, window);
        let mut cluster = match found {
            Ok(cluster) => cluster,
            Err(ending) => return Some(ending),
        };
        if T::DIFFERENTIATES {
            self.note_error(cluster.error);
            self.note_cluster(&mut cluster);
        }
        if let Some(ending) = self.streak(cluster.leaving()) {
            return Some(ending);
        }
        for side in cluster.leaving() {
            self.balls.set_off(side.ball, &side.course);
        }
        let mut first = None;
        for side in cluster.leaving() {
            let row = Row::of(&self.balls, side.ball);
            // the pair itself belongs to the row of the first
            let row = match first {
                None => row,
                Some(first) => row.without_ball(first),
            };
            first = first.or(Some(side.ball));
            self.agenda.predict(&row);
        }
        cluster.turn_as(&self.balls);
        self.journal.cluster_impact(&self.balls, &cluster);
        None
    }

    /// Counts impacts of balls while no time passes; answers when there are too many to be finite.
    #[inline]
    pub(super) fn streak<'s>(
        &mut self,
        hit: impl IntoIterator<Item = &'s ImpactSide<T>> + Clone,
    ) -> Option<Ending> {
        let balls = hit.clone().into_iter().map(|side| side.ball);
        let collapsed = self.streaks.count(balls, self.balls.now())?;
        let balls: Vec<usize> = hit.into_iter().map(|side| side.ball).collect();
        Some(Ending::Collapsed(self.balls.spot(&balls, &collapsed)))
    }

    /// The same for balls that touch.
    #[cold]
    pub(super) fn streak_of(&mut self, balls: &[usize]) -> Option<Ending> {
        let collapsed = self
            .streaks
            .count(balls.iter().copied(), self.balls.now())?;
        Some(Ending::Collapsed(self.balls.spot(balls, &collapsed)))
    }

    /// The phase of a ball ends by itself.
    #[inline(never)]
    fn phase_end(&mut self, ball: usize) -> Option<Ending> {
        if self.balls.is_held(ball) {
            return self.stretch_end(ball);
        }
        let end = PhaseEnd::of(&self.balls, ball);
        let row = Row::setting_off(&self.balls, ball, &end.course.flight);
        let mut ending = None;
        let next = if end.stops {
            let mut watch = Watch::new(self.balls.world().blur.length, None);
            let next = self.agenda.foresee(&row, Some(&mut watch));
            if !watch.is_clear() {
                ending = ambiguity::of_stop(&self.balls, ball, watch);
            }
            next
        } else {
            self.agenda.foresee(&row, None)
        };
        self.balls.set_off(ball, &end.course);
        self.agenda.schedule(ball, next);
        self.journal.phase_end(&self.balls, &end);
        ending
    }

    /// A ball leaves play.
    #[cold]
    #[inline(never)]
    fn pocket(&mut self, ball: usize, pocket: u32) -> Option<Ending> {
        let left = if self.balls.is_held(ball) {
            self.leaves_group(ball)
        } else {
            None
        };
        let (position, velocity) = self.balls.at(ball);
        let spin = self.balls.spin_now(ball);
        if T::DIFFERENTIATES {
            self.note_fall(ball);
        }
        let last = self.balls.state(ball, position, velocity, spin);
        self.balls.take_out(ball);
        self.agenda.schedule(ball, Candidate::none());
        self.journal.pocket(&self.balls, ball, &last, pocket);
        self.go_on(left?, &[], &[], 0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Vec3;
    use crate::physics::{Cloth, Contact, Cushion, Effects, State};
    use crate::scene::{Ball, Simultaneous, Table, Units};

    fn three_balls() -> Scene {
        let ball = |id: &str, x: f64, y: f64, vx: f64, vy: f64| Ball {
            id: id.to_owned(),
            radius: 0.25,
            mass: 0.17,
            state: State {
                position: Vec3::new(x, y, 0.25),
                velocity: Vec3::new(vx, vy, 0.0),
                spin: Vec3::zeros(),
            },
        };
        Scene {
            name: "three".to_owned(),
            description: String::new(),
            sets: Vec::new(),
            duration: 20.0,
            run_to_duration: false,
            gravity: 9.81,
            units: Units {
                length: "L".to_owned(),
                length_in_metres: None,
                mass: "M".to_owned(),
                mass_in_kg: None,
                time: "s".to_owned(),
            },
            table: Some(Table {
                min: [0.0, 0.0],
                max: [6.0, 10.0],
            }),
            balls: vec![
                ball("a", 1.0, 1.0, 3.0, 6.0),
                ball("b", 2.5, 3.8, 0.0, 0.0),
                ball("c", 4.0, 8.0, -1.0, -2.0),
            ],
            shot: None,
            effects: Effects {
                cloth: Some(Cloth::Translational { mu: 0.2 }),
                contact: Some(Contact::Elastic {}),
                cushion: Some(Cushion::Elastic {}),
                ..Effects::default()
            },
            simultaneous: Simultaneous::Refuse,
            richer: None,
            try_settings: Vec::new(),
        }
    }

    fn run<T: Real>(scene: &Scene) -> Trace {
        Solver::<T>::new(scene).run(Provenance::default(), Record::Events, &Limits::NONE)
    }

    #[test]
    fn another_scalar_runs_the_same_source() {
        let scene = three_balls();
        let (wide, narrow) = (run::<f64>(&scene), run::<f32>(&scene));
        assert_eq!(
            (&wide.ending, &narrow.ending),
            (&Ending::Rest, &Ending::Rest)
        );
        let kinds = |trace: &Trace| -> Vec<_> { trace.events.iter().map(|e| e.kind).collect() };
        assert_eq!(kinds(&wide), kinds(&narrow));
        assert!(wide.counters["ball_ball"] > 0, "{:?}", wide.counters);
        for (a, b) in wide.paths.iter().zip(&narrow.paths) {
            let ends = a.last().zip(b.last());
            let error = ends.map_or(f64::NAN, |(a, b)| (a.position - b.position).norm());
            // an ulp of f32 at 10 is 1e-6; a few hits let it grow
            assert!(error > 0.0 && error < 1e-3, "off by {error:e}");
        }
    }
}

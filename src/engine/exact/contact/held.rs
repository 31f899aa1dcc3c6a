//! Balls that are held together by contacts now, and pairs that are just parting.

use super::arc::{Arc, Series};
use super::group::Group;
use crate::engine::exact::encounter::Encounter;
use crate::engine::exact::spin::Moving;
use crate::math::Real;

/// A group under way.
#[derive(Clone, Debug)]
pub struct Held<T> {
    /// Balls and contacts.
    pub group: Group<T>,
    /// How they move.
    pub arc: Arc<T>,
    /// When the stretch began, s.
    pub start: T,
    /// Stretches without any length that came before this one.
    pub stuck: u32,
    /// Stretches since something last changed.
    pub unchanged: u32,
    /// How far each member has come in those beyond what its place can tell, length: where one turns within a very short time, others come no farther
    /// in a stretch than their rounding. Empty where nothing has been left.
    pub beyond: Vec<[T; 2]>,
}

impl<T: Real> Held<T> {
    /// Who touches whom, by balls.
    pub fn encounters(&self) -> Vec<Encounter> {
        let holds = self.group.holds.iter();
        let named = holds.map(|hold| hold.touch.encounter(&self.group.members));
        named.collect()
    }

    /// How a ball moves at `time`, s; no later than the end of the stretch, whatever the clock can tell.
    pub fn at(&self, ball: usize, time: T) -> Option<Moving<T>> {
        let since = time - self.start;
        let after = since.at_most(self.arc.length).following(since);
        Some(self.series(ball)?.at(after))
    }

    /// The series of a ball.
    pub fn series(&self, ball: usize) -> Option<&Series<T>> {
        self.arc.series.iter().find(|series| series.ball == ball)
    }
}

/// Two parties whose contact has just ended: their gap grows from nothing, and only later can they meet again.
#[derive(Clone, Copy, Debug)]
struct Parting {
    encounter: Encounter,
    /// The counts of changes of their courses for which this holds.
    versions: [u32; 2],
}

/// All contacts of a run.
#[derive(Clone, Debug)]
pub struct Contacts<T> {
    held: Vec<Held<T>>,
    parting: Vec<Parting>,
}

impl<T: Real> Contacts<T> {
    /// No contacts.
    pub fn new() -> Self {
        Contacts {
            held: Vec::new(),
            parting: Vec::new(),
        }
    }

    /// The group of a ball.
    pub fn of(&self, ball: usize) -> Option<&Held<T>> {
        self.held.iter().find(|held| held.series(ball).is_some())
    }

    /// The same, to be given other derivatives.
    pub fn of_mut(&mut self, ball: usize) -> Option<&mut Held<T>> {
        let mut held = self.held.iter_mut();
        held.find(|held| held.series(ball).is_some())
    }

    /// All groups.
    pub fn held(&self) -> &[Held<T>] {
        &self.held
    }

    /// Takes up a group.
    pub fn add(&mut self, held: Held<T>) {
        self.held.push(held);
    }

    /// Gives up the group of a ball.
    pub fn remove(&mut self, ball: usize) -> Option<Held<T>> {
        let place = self
            .held
            .iter()
            .position(|held| held.series(ball).is_some())?;
        Some(self.held.swap_remove(place))
    }

    /// Notes parties that part now. `version`: of each ball, once it has set off.
    pub fn part(&mut self, encounter: Encounter, version: impl Fn(usize) -> u32) {
        let versions = match encounter {
            Encounter::Pair(a, b) => [version(a), version(b)],
            Encounter::Cushion(a, _) => [version(a); 2],
        };
        // the same again, as from a run in more digits that knew of it, is one
        self.parting.retain(|known| known.encounter != encounter);
        self.parting.push(Parting {
            encounter,
            versions,
        });
    }

    /// Whether two parties are on the courses on which they parted.
    pub fn is_parting(&self, encounter: Encounter, version: impl Fn(usize) -> u32) -> bool {
        self.parting
            .iter()
            .any(|parting| parting.encounter == encounter && holds(parting, &version))
    }

    /// The parties that are on the courses on which they parted.
    pub fn parting(&self, version: impl Fn(usize) -> u32) -> Vec<Encounter> {
        let parting = self.parting.iter();
        let parting = parting.filter(|parting| holds(parting, &version));
        parting.map(|parting| parting.encounter).collect()
    }

    /// Forgets parties that have gone on since.
    pub fn forget(&mut self, version: impl Fn(usize) -> u32) {
        self.parting.retain(|parting| holds(parting, &version));
    }
}

fn holds(parting: &Parting, version: &impl Fn(usize) -> u32) -> bool {
    match parting.encounter {
        Encounter::Pair(a, b) => parting.versions == [version(a), version(b)],
        Encounter::Cushion(a, _) => parting.versions[0] == version(a),
    }
}

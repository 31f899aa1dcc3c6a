//! The pairs that overlap, how long they have, and the event of their contact.
//!
//! Pairs come in order in every step, so those of a step and of the one before are walked side by side.

/// A pair that overlaps.
#[derive(Clone, Copy, Debug)]
pub struct Overlap {
    /// Indices in play, the smaller first.
    pub pair: (usize, usize),
    /// The first step of this unbroken overlap.
    pub since: u64,
    /// The contact, from the first exchange on.
    pub contact: Option<Contact>,
}

/// A contact episode: from the first exchange of a pair until it no longer overlaps.
#[derive(Clone, Copy, Debug)]
pub struct Contact {
    /// Index of its event.
    pub event: u32,
    /// Exchanges so far.
    pub exchanges: u64,
}

/// The overlapping pairs of a step and of the one before.
#[derive(Clone, Debug)]
pub struct Overlaps {
    now: Vec<Overlap>,
    before: Vec<Overlap>,
    /// Pairs of the step before that have been passed.
    passed: usize,
}

impl Overlaps {
    /// No pair overlaps.
    pub fn new(capacity: usize) -> Self {
        Overlaps {
            now: Vec::with_capacity(capacity),
            before: Vec::with_capacity(capacity),
            passed: 0,
        }
    }

    /// Begins a step. What is not met in it overlaps no longer.
    pub fn begin(&mut self) {
        std::mem::swap(&mut self.now, &mut self.before);
        self.now.clear();
        self.passed = 0;
    }

    /// A pair that overlaps in `step`; ascending within a step. Answers its index among those of the step.
    pub fn meet(&mut self, step: u64, pair: (usize, usize)) -> usize {
        let rest = &self.before[self.passed..];
        self.passed += rest.iter().take_while(|known| known.pair < pair).count();
        let known = self.before.get(self.passed);
        self.now
            .push(match known.filter(|known| known.pair == pair) {
                Some(known) => *known,
                None => Overlap {
                    pair,
                    since: step,
                    contact: None,
                },
            });
        self.now.len() - 1
    }

    /// The pairs of the step, in order.
    pub fn now(&self) -> &[Overlap] {
        &self.now
    }

    /// The contact of a pair of the step.
    pub fn contact(&mut self, index: usize) -> &mut Option<Contact> {
        &mut self.now[index].contact
    }

    /// Forgets balls that left play, by ascending index; those after them move up.
    pub fn remove(&mut self, leaving: &[usize]) {
        let stays = |ball: usize| leaving.binary_search(&ball).is_err();
        self.now
            .retain(|overlap| stays(overlap.pair.0) && stays(overlap.pair.1));
        let moved = |ball: usize| ball - leaving.partition_point(|left| *left < ball);
        for overlap in &mut self.now {
            overlap.pair = (moved(overlap.pair.0), moved(overlap.pair.1));
        }
    }
}

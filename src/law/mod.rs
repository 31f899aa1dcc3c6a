//! What must hold of a run, whoever made it: each invariant in a file of its own, with its measure, its bound and why that is the bound, and
//! where it compares two runs, the image of the scene that must run alike.
//!
//! Measures read a scene and a trace and know no engine; bounds follow from what a trace says of its scheme ([`Run`]): its step, 0 for an
//! engine that solves for its events, and the spacing of its numbers. `stability`, `check` and `fuzz` hold runs against what stands here
//! and add their own words; the contract tests measure anew and take the bounds.
//!
//! An engine names what it promises by [`Invariant`]; [`LAWS`] has one line for each.

pub mod closed_forms;
pub mod energy;
pub mod finite;
pub mod image;
pub mod impact_energy;
pub mod mirror;
pub mod momentum;
pub mod outside;
pub mod overlap;
pub mod quarter_turn;
pub mod relabelling;
pub mod rerun;
pub mod rest;
mod run;
pub mod scaling;
pub mod time_reversal;

pub use image::Image;
pub use run::{Reach, Run, amplified};

use crate::math::within;
use crate::physics::invariants::Invariant;
use crate::trace::Extremum;

/// One invariant.
#[derive(Clone, Copy, Debug)]
pub struct Law {
    /// Which.
    pub invariant: Invariant,
    /// Unit of its figure, as printed; empty for a count. `R` is the smallest radius, `E0` the initial energy, `m v0` the largest mass
    /// times the largest initial speed.
    pub unit: &'static str,
    /// What it demands, with the bound, in one sentence.
    pub what: &'static str,
    /// What must be looked at.
    pub reads: Reads,
}

/// What an invariant is seen by.
#[derive(Clone, Copy, Debug)]
pub enum Reads {
    /// The run alone; `None` where it does not apply.
    Run(fn(&Run<'_>) -> Option<Held>),
    /// The run beside that of an image of its scene.
    Image(Image),
    /// The run beside another of the same scene.
    Rerun,
}

/// A figure beside its bound, both in the unit of the measure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held {
    /// The figure, with when and whose it is.
    pub seen: Extremum,
    /// What it may be at most.
    pub bound: f64,
}

impl Held {
    /// True if the figure is a number within its bound.
    pub fn holds(&self) -> bool {
        within(self.seen.value, self.bound)
    }

    /// A number of things of which there may be none.
    fn none_of(count: usize) -> Self {
        let seen = Extremum {
            value: count as f64,
            ..Extremum::default()
        };
        Held { seen, bound: 0.0 }
    }
}

/// Every invariant, in the order of [`Invariant`].
pub const LAWS: &[Law] = &[
    finite::LAW,
    momentum::LAW,
    impact_energy::LAW,
    energy::LAW,
    outside::LAW,
    overlap::LAW,
    rest::LAW,
    rerun::LAW,
    mirror::LAW,
    relabelling::LAW,
    quarter_turn::LAW,
    scaling::LAW,
    time_reversal::LAW,
    closed_forms::LAW,
];

/// The line of an invariant.
pub fn law(invariant: Invariant) -> Option<&'static Law> {
    LAWS.iter().find(|law| law.invariant == invariant)
}

/// Something that must not be.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// Kebab-case name of what is broken.
    pub what: &'static str,
    /// When, who and how much.
    pub words: String,
}

impl Fault {
    /// A fault with its words.
    pub fn new(what: &'static str, words: String) -> Self {
        Fault { what, words }
    }
}

#[cfg(test)]
mod tests {
    use super::{LAWS, Reads, law};
    use crate::physics::invariants::Invariant;

    /// Place of an invariant in the list; a new one does not compile until it has a place.
    fn place(invariant: Invariant) -> usize {
        match invariant {
            Invariant::Finite => 0,
            Invariant::Momentum => 1,
            Invariant::ImpactEnergy => 2,
            Invariant::EnergyNeverGrows => 3,
            Invariant::Bounds => 4,
            Invariant::Overlap => 5,
            Invariant::EverythingStops => 6,
            Invariant::Rerun => 7,
            Invariant::Mirror => 8,
            Invariant::Relabelling => 9,
            Invariant::QuarterTurn => 10,
            Invariant::Scaling => 11,
            Invariant::TimeReversal => 12,
            Invariant::Laws => 13,
        }
    }

    #[test]
    fn every_invariant_has_one_line_with_words_and_what_it_is_seen_by() {
        assert_eq!(LAWS.len(), place(Invariant::Laws) + 1);
        for (at, own) in LAWS.iter().enumerate() {
            assert_eq!(place(own.invariant), at, "{}", own.invariant.id());
            assert!(!own.what.is_empty() && !own.what.ends_with('.'));
            assert!(law(own.invariant).is_some_and(|found| found.what == own.what));
            let image = matches!(own.reads, Reads::Image(_));
            assert_eq!(image, (8..13).contains(&at), "{}", own.invariant.id());
        }
    }
}

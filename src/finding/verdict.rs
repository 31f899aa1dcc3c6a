//! Verdicts, and by how much an accepted number may move before it counts as changed.

use crate::math::within;
use serde::Serialize;

/// What one check says of one run. Ordered by how much it asks for attention: the worst of several is the largest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// The engine cannot simulate the scene: nothing ran.
    CannotExpress,
    /// Within its bound.
    Holds,
    /// There is no single right answer to hold it against.
    Indeterminate,
    /// Off by a figure that nothing forbids: more than its step or its scalar explains, or another order of collisions that they do explain.
    Drifts,
    /// Against a law, or without an event that it must have.
    Breaks,
}

impl Verdict {
    /// Every verdict, from the worst to the one that says least.
    pub const ALL: [Verdict; 5] = [
        Verdict::Breaks,
        Verdict::Drifts,
        Verdict::Indeterminate,
        Verdict::Holds,
        Verdict::CannotExpress,
    ];

    /// Kebab-case name, as in files.
    pub fn id(self) -> &'static str {
        match self {
            Verdict::CannotExpress => "cannot-express",
            Verdict::Holds => "holds",
            Verdict::Indeterminate => "indeterminate",
            Verdict::Drifts => "drifts",
            Verdict::Breaks => "breaks",
        }
    }

    /// The verdict called `id`.
    pub fn find(id: &str) -> Option<Verdict> {
        Verdict::ALL.into_iter().find(|verdict| verdict.id() == id)
    }
}

/// By how much a number may differ from the accepted one. Each kind says by its name how it measures.
///
/// Whatever the kind, a number that is not finite is the same as itself alone: no part of infinity is a bound.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Tolerance {
    /// Not at all: counts, and words.
    None,
    /// By this much, in the unit of the number.
    Absolute(f64),
    /// By this part of the larger of the two, or of `above` where both are smaller than that.
    Relative {
        /// The part.
        part: f64,
        /// Numbers below this size, in their unit, are held as if they had it.
        above: f64,
    },
}

impl Tolerance {
    /// The largest difference between `a` and `b` that is no change, in their unit; 0 where either is not finite.
    pub fn bound(self, a: f64, b: f64) -> f64 {
        if !(a.is_finite() && b.is_finite()) {
            return 0.0;
        }
        match self {
            Tolerance::None => 0.0,
            Tolerance::Absolute(bound) => bound,
            Tolerance::Relative { part, above } => part * a.abs().max(b.abs()).max(above),
        }
    }

    /// True if `a` and `b` are the same within it. Of numbers that are not finite two infinities of one sign are, and two NaN.
    pub fn holds(self, a: f64, b: f64) -> bool {
        // numbers near the largest differ by more than any: such a difference is within nothing
        a == b || (a.is_nan() && b.is_nan()) || within((a - b).abs(), self.bound(a, b))
    }
}

/// How an accepted value is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hold {
    /// To the last one: a count is the same on every target, or something happened.
    Count,
    /// Within grown rounding.
    ///
    /// One target gives the same bits for any number of threads, in debug and release. Another may round a sine or a fused product
    /// otherwise: one ulp, which growth multiplies. 2^22 ulp are 1e-9 in f64; in f32, where that would be all, 2^10 ulp are 1.2e-4. Figures below
    /// 1 are held as if they were 1, since most are differences of such numbers.
    Figure,
}

impl Hold {
    /// By how much a value may move in an engine with rounding `ulp`.
    pub fn tolerance(self, ulp: f64) -> Tolerance {
        let grown = if ulp > f64::EPSILON {
            1024.0
        } else {
            4_194_304.0
        };
        match self {
            Hold::Count => Tolerance::None,
            Hold::Figure => Tolerance::Relative {
                part: grown * ulp,
                above: 1.0,
            },
        }
    }

    /// Why, in one sentence.
    pub fn why(self) -> &'static str {
        match self {
            Hold::Count => "a count is the same on every target",
            Hold::Figure => {
                "one target gives the same bits; another rounds a sine otherwise, which growth multiplies: 2^22 ulp in f64, 2^10 in f32, \
                 relative to the figure or to 1"
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Tolerance, Verdict};

    #[test]
    fn every_verdict_is_found_by_its_name() {
        for verdict in Verdict::ALL {
            assert_eq!(Verdict::find(verdict.id()), Some(verdict));
        }
        assert_eq!(Verdict::find("passes"), None);
    }

    #[test]
    fn a_tolerance_measures_as_its_name_says() {
        let relative = Tolerance::Relative {
            part: 1e-2,
            above: 1.0,
        };
        for (tolerance, a, b, same) in [
            (Tolerance::None, 3.0, 3.0, true),
            (Tolerance::None, 3.0, 3.0 + 1e-15, false),
            (Tolerance::Absolute(0.5), 1e9, 1e9 + 0.5, true),
            (Tolerance::Absolute(0.5), 0.0, 0.6, false),
            (relative, 100.0, 101.0, true),
            (relative, 100.0, 101.1, false),
            // below `above` it is absolute
            (relative, 0.0, 9e-3, true),
            (relative, 0.0, 1.1e-2, false),
            (relative, f64::INFINITY, f64::INFINITY, true),
            (relative, f64::NAN, f64::NAN, true),
            (relative, f64::NAN, 0.0, false),
            (Tolerance::Absolute(1.0), f64::INFINITY, 0.0, false),
            // a part of infinity would hold everything
            (relative, f64::INFINITY, 0.0, false),
            (relative, f64::INFINITY, f64::MAX, false),
            (relative, f64::NEG_INFINITY, f64::INFINITY, false),
            (relative, f64::NEG_INFINITY, f64::NEG_INFINITY, true),
            (relative, f64::NAN, f64::INFINITY, false),
            (Tolerance::Absolute(f64::INFINITY), 0.0, 1.0, false),
            (Tolerance::None, f64::INFINITY, f64::INFINITY, true),
            // and a difference that overflows is no small one
            (relative, f64::MAX, -f64::MAX, false),
            (relative, 1e308, 1.0, false),
            (relative, 1e308, 1.001e308, true),
        ] {
            assert_eq!(tolerance.holds(a, b), same, "{tolerance:?} {a} {b}");
            assert_eq!(tolerance.holds(b, a), same, "{tolerance:?} {b} {a}");
        }
    }
}

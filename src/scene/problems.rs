//! The errors of one file while they are being found: the first by position are kept, the rest is counted.
//!
//! A file can have as many errors as it has lines, and nobody reads them all.

use super::diagnostics::{Diagnostic, Diagnostics};
use std::ops::Range;

/// Errors of one file that are kept with their words.
pub const KEPT: usize = 1000;

/// Errors in the order in which they are found.
#[derive(Debug)]
pub(super) struct Problems {
    kept: Vec<Diagnostic>,
    found: usize,
    /// Where the last of those stands that are sure to be kept; what stands there or later, found later, is not.
    edge: usize,
}

impl Problems {
    pub fn new() -> Self {
        Problems {
            kept: Vec::new(),
            found: 0,
            edge: usize::MAX,
        }
    }

    /// Number of errors so far.
    pub fn found(&self) -> usize {
        self.found
    }

    pub fn is_empty(&self) -> bool {
        self.found == 0
    }

    /// Adds an error.
    pub fn push(&mut self, problem: Diagnostic) {
        self.push_at(problem.span.clone(), |_| problem);
    }

    /// Adds an error at `span`, whose words are put together only if it is one of the first.
    pub fn push_at(
        &mut self,
        span: Range<usize>,
        problem: impl FnOnce(Range<usize>) -> Diagnostic,
    ) {
        self.found += 1;
        if span.start >= self.edge {
            return;
        }
        self.kept.push(problem(span));
        // each paring takes as long as it takes to find as many as are kept
        if self.kept.len() >= 2 * KEPT {
            self.pare();
        }
    }

    pub fn extend(&mut self, problems: impl IntoIterator<Item = Diagnostic>) {
        problems.into_iter().for_each(|problem| self.push(problem));
    }

    /// Adds an error of a kind that is looked for along the text. `told`: how many of the kind there were, from 0; the first are put
    /// together, with their places, and those that come later than so many are only counted.
    pub fn push_along(&mut self, told: &mut usize, problem: impl FnOnce() -> Diagnostic) {
        if *told < KEPT {
            self.push(problem());
        } else {
            self.found += 1;
        }
        *told += 1;
    }

    fn pare(&mut self) {
        self.kept.sort_by_key(|problem| problem.span.start);
        self.kept.truncate(KEPT);
        if self.kept.len() == KEPT
            && let Some(last) = self.kept.last()
        {
            self.edge = last.span.start;
        }
    }

    /// What is wrong with `file`.
    pub fn of_file(self, file: &str, text: &str) -> Diagnostics {
        Diagnostics::new(file, text, self.into_first())
    }

    /// The first by position, at most [`KEPT`], those at one place in the order in which they were found; and the number of the rest.
    pub fn into_first(mut self) -> (Vec<Diagnostic>, usize) {
        self.pare();
        let rest = self.found - self.kept.len();
        (self.kept, rest)
    }
}

impl Diagnostics {
    /// These problems of `file`, the first by position.
    pub fn of(file: &str, text: &str, found: impl IntoIterator<Item = Diagnostic>) -> Self {
        let mut problems = Problems::new();
        problems.extend(found);
        problems.of_file(file, text)
    }
}

#[cfg(test)]
mod tests {
    use super::super::diagnostics::Kind;
    use super::*;
    use crate::math::random::Draws;

    #[test]
    fn the_first_by_position_are_kept_whatever_the_order_in_which_they_are_found() {
        let mut draws = Draws::new(3, 0);
        let (mut problems, mut all, mut built) = (Problems::new(), Vec::new(), 0);
        for number in 0..100_000 {
            let start = (draws.bits() % 20_000) as usize;
            all.push((start, number));
            problems.push_at(start..start + 1, |span| {
                built += 1;
                Diagnostic::new(Kind::UnknownKey, span, number.to_string(), "")
            });
        }
        all.sort_by_key(|(start, _)| *start);
        let (kept, rest) = problems.into_first();
        assert_eq!((kept.len(), rest), (KEPT, 100_000 - KEPT));
        let found = kept
            .iter()
            .map(|kept| (kept.span.start, kept.message.clone()));
        let want = all[..KEPT]
            .iter()
            .map(|(start, number)| (*start, number.to_string()));
        assert!(found.eq(want));
        // in any order few are put into words: the k-th with the probability that it is among the first so far
        assert!(built < 10 * KEPT, "{built}");
    }
}

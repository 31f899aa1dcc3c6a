//! One scene compared, as a document.

use super::compare::{self, LengthUnit};
use super::ensemble;
use crate::finding::Document;
use crate::study::Answer;

/// What the terminal shows.
pub fn summary(answer: &Answer, unit: LengthUnit) -> Document {
    surrounded(answer, compare::summary(&answer.outcome, unit))
}

/// The same with pictures, ball by ball.
pub fn page(answer: &Answer) -> Document {
    surrounded(answer, compare::page(&answer.outcome))
}

fn surrounded(answer: &Answer, mut document: Document) -> Document {
    if let Some(surroundings) = &answer.surroundings {
        let blocks = ensemble::surroundings(&answer.outcome, surroundings);
        ensemble::surround(&mut document, blocks);
    }
    document
}

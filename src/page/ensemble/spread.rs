//! A scene whose touching balls are an ensemble, in a comparison: the spread of the exact answers over random gaps, and who is like them.

use super::short;
use crate::finding::{Block, Cell, Column, Document, Table, Tone};
use crate::math::statistics::Distribution;
use crate::oracle;
use crate::physics::State;
use crate::study::compare;
use crate::study::ensemble::{AROUND, EnsembleOutcome, SEED_AROUND, Surroundings};

/// An answer is like the samples if at least this part of all answers lie as far from their nearest neighbour.
const ALIKE: f64 = 0.02;

/// What is said of the ensemble around a scene.
pub fn surroundings(compared: &compare::ComparisonOutcome, found: &Surroundings) -> Vec<Block> {
    match found {
        Ok(outcome) => blocks(compared, outcome),
        Err(error) => vec![Block::Text(format!("There is no ensemble: {error}."))],
    }
}

/// Puts blocks before the first table that follows a text, which says whether there is a right answer.
pub fn surround(page: &mut Document, blocks: Vec<Block>) {
    let find = |from: usize, wanted: fn(&Block) -> bool| {
        let rest = page.blocks.iter().skip(from);
        rest.enumerate()
            .find_map(|(k, block)| wanted(block).then_some(from + k))
            .unwrap_or(page.blocks.len())
    };
    let text = find(0, |block| matches!(block, Block::Text(_)));
    let at = find(text, |block| matches!(block, Block::Table(_)));
    page.blocks.splice(at..at, blocks);
}

fn blocks(compared: &compare::ComparisonOutcome, ensemble: &EnsembleOutcome) -> Vec<Block> {
    let Some(exact) = ensemble.entries.first() else {
        return Vec::new();
    };
    let complete = exact.complete().count();
    let mut text = format!(
        "The scene asks for an ensemble: {}; {} samples in {}, seed {SEED_AROUND}, of which {complete} are complete and have {} \
         different collision orders.",
        ensemble.law.join("; "),
        ensemble.done,
        exact.label(),
        exact.orders
    );
    for (label, places) in answers(compared, ensemble) {
        let alike = places.iter().flatten().filter(|p| p.is_alike()).count();
        text += &format!(
            " {label} ends like the samples for {alike} of {} balls.",
            places.iter().flatten().count()
        );
    }
    vec![
        Block::Text(text),
        Block::Table(table(compared, ensemble)),
        Block::Command(format!(
            "carom ensemble {} --samples {AROUND} --seed {SEED_AROUND} --engines {}",
            compared.scene.name,
            exact.label()
        )),
    ]
}

/// Where a single answer lies among the samples, for one ball.
#[derive(Clone, Copy, Debug, PartialEq)]
struct AnswerPlace {
    /// Distance from the nearest sample, length.
    nearest: f64,
    /// Part of all answers, this one among them, that are at least as far from their nearest neighbour: if it is one more
    /// sample, the probability of at most `part` is at most `part`, whatever the distribution.
    part: f64,
}

impl AnswerPlace {
    /// Where `answer` lies among `samples`; `None` without any.
    fn of(answer: [f64; 2], samples: &[[f64; 2]]) -> Option<Self> {
        let apart = |a: &[f64; 2], b: &[f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
        let to_answer = samples.iter().map(|sample| apart(sample, &answer));
        let nearest = to_answer.reduce(f64::min)?;
        let is_as_far = |(i, sample): &(usize, &[f64; 2])| {
            let others = samples.iter().enumerate().filter(|(j, _)| j != i);
            let from_others = others.map(|(_, other)| apart(sample, other));
            from_others.fold(apart(sample, &answer), f64::min) >= nearest
        };
        let as_far = samples.iter().enumerate().filter(is_as_far).count();
        Some(AnswerPlace {
            nearest,
            part: (as_far + 1) as f64 / (samples.len() + 1) as f64,
        })
    }

    fn is_alike(&self) -> bool {
        self.part >= ALIKE
    }
}

/// For each engine but the exact one that ran to the end: its label, and the place of each ball.
fn answers(
    compared: &compare::ComparisonOutcome,
    ensemble: &EnsembleOutcome,
) -> Vec<(String, Vec<Option<AnswerPlace>>)> {
    let mut answers = Vec::new();
    for entry in &compared.entries {
        let complete = entry.trace().filter(|trace| trace.ending.is_complete());
        let Some(trace) = complete.filter(|_| !oracle::is_reference(&*entry.column.engine)) else {
            continue;
        };
        let place = |(ball, state): (usize, Option<State>)| {
            let exact = ensemble.entries.first()?.complete();
            let samples: Vec<[f64; 2]> =
                exact.filter_map(|(_, landing)| landing.at[ball]).collect();
            let position = state?.position;
            AnswerPlace::of([position.x, position.y], &samples)
        };
        let states = trace.final_states().into_iter().enumerate();
        answers.push((entry.label(), states.map(place).collect()));
    }
    answers
}

fn table(compared: &compare::ComparisonOutcome, ensemble: &EnsembleOutcome) -> Table {
    let scene = &compared.scene;
    let radius = scene.smallest_radius();
    let mut columns = vec![
        Column::words("ball", "ball"),
        Column::number("x-mean", "x at the end", "R"),
        Column::number("x-deviation", "+-", "R"),
        Column::number("y-mean", "y at the end", "R"),
        Column::number("y-deviation", "+-", "R"),
    ];
    let answers = answers(compared, ensemble);
    for (label, _) in &answers {
        columns.push(Column::words(&label.replace([' ', '='], "-"), label));
    }
    let mut rows = Vec::new();
    for (ball, id) in scene.balls.iter().map(|ball| &ball.id).enumerate() {
        let mut row = vec![Cell::text(id.clone())];
        let distributions = ensemble.entries.first().map(|e| &e.distributions[ball]);
        for distribution in distributions.into_iter().flatten().take(2) {
            let number = |x: Option<f64>| x.map_or(Cell::Empty, |x| Cell::Fixed(x / radius, 3));
            row.push(number(distribution.as_ref().map(Distribution::mean)));
            row.push(number(
                distribution.as_ref().and_then(Distribution::deviation),
            ));
        }
        for (_, places) in &answers {
            let place = places.get(ball).copied().flatten();
            row.push(place.map_or(Cell::Empty, |place| verdict(place, radius)));
        }
        rows.push(row);
    }
    Table {
        id: format!("ensemble-{}", scene.name),
        title: "The ensemble, and each engine's single answer in it".to_owned(),
        columns,
        rows,
        note: format!(
            "Mean and standard deviation over the samples. Engines: distance from the nearest sample, and the part of all \
             answers that lie at least as far from their nearest. Below {:.0} % an answer is not like the samples.",
            100.0 * ALIKE
        ),
    }
}

fn verdict(place: AnswerPlace, radius: f64) -> Cell {
    let tone = if place.is_alike() {
        Tone::Good
    } else {
        Tone::Notice
    };
    let percent = 100.0 * place.part;
    Cell::verdict(
        tone,
        format!("{} R, {percent:.1} %", short(place.nearest / radius)),
    )
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::{ALIKE, AnswerPlace};
    use crate::math::random::Draws;

    /// Two heaps, as the mirror images of a triple hit.
    fn heaps(n: u64) -> Vec<[f64; 2]> {
        let sample = |index| {
            let (x, y) = Draws::new(5, index).in_disc(0.1);
            [if index % 2 == 0 { x - 3.0 } else { x + 3.0 }, y]
        };
        (0..n).map(sample).collect()
    }

    #[test]
    fn what_lies_between_two_heaps_is_not_like_them() {
        let samples = heaps(200);
        let between = AnswerPlace::of([0.0, 0.0], &samples).unwrap();
        assert!(
            !between.is_alike() && (between.nearest - 2.9).abs() < 0.1,
            "{between:?}"
        );
        let on_a_sample = AnswerPlace::of(samples[7], &samples).unwrap();
        assert_eq!(
            on_a_sample,
            AnswerPlace {
                nearest: 0.0,
                part: 1.0
            }
        );
        assert_eq!(AnswerPlace::of([0.0, 0.0], &[]), None);
    }

    #[test]
    fn one_more_sample_is_rarely_taken_for_a_stranger() {
        let trials = 400;
        let mut strangers = 0;
        for trial in 0..trials {
            let mut draws = Draws::new(9, trial);
            let mut cloud: Vec<[f64; 2]> = (0..100)
                .map(|_| {
                    let (x, y) = draws.in_disc(1.0);
                    [x * x * x, y]
                })
                .collect();
            let answer = cloud.pop().unwrap();
            strangers += u32::from(!AnswerPlace::of(answer, &cloud).unwrap().is_alike());
        }
        // at most ALIKE of the trials: its expectation and five deviations
        let expected = ALIKE * trials as f64;
        let most = expected + 5.0 * (expected * (1.0 - ALIKE)).sqrt();
        assert!(f64::from(strangers) <= most, "{strangers} of {trials}");
    }
}

//! How far one scene can be predicted, as a document.

use super::certainty;
use crate::finding::{Block, Cell, Column, Document, Table};
use crate::oracle::{BAND, Horizon, Influence, Limit, Sight};
use crate::scene::Scene;
use crate::study::horizon::{HorizonOutcome, Predicted};
use crate::trace::EventKind;
use crate::words::{
    describe_ending, describe_growth, describe_kind, describe_lost, describe_rough, describe_scene,
    describe_span,
};

/// How far a scene can be predicted; where the user asked to stop before that was found there is nothing to say but that.
pub fn page(outcome: &HorizonOutcome) -> Document {
    let scene = &outcome.scene;
    match &outcome.found {
        Some(found) => told(scene, found),
        None => {
            let what = "how far the scene can be predicted was not found";
            Document {
                stopped_early: Some(format!("This was stopped early: {what}.")),
                ..document(
                    scene,
                    String::new(),
                    vec![Block::Text(describe_scene(scene))],
                )
            }
        }
    }
}

fn told(scene: &Scene, found: &Predicted) -> Document {
    let Predicted {
        horizon,
        influences,
        errors,
    } = found;
    let mut blocks = vec![
        Block::Text(describe_scene(scene)),
        Block::Text(format!(
            "{}. Held against {}: an event is within the horizon while both have it at the same place in the history of its balls, \
             differ by less than {BAND:e} R (speeds in the largest initial speed), and the next other candidate is farther away \
             than the error of the time. Impacts that shrink to a contact that both reach alike are of no account among themselves.",
            describe_ending(&horizon.trace),
            horizon.witness.id()
        )),
    ];
    let growth = horizon.growth.as_ref();
    let figures = [
        growth.and_then(|growth| certainty::growth(scene, horizon, growth)),
        certainty::margins(scene, horizon),
        certainty::apart(scene, horizon, growth),
    ];
    blocks.extend(figures.into_iter().flatten().map(Block::Figure));
    blocks.extend(without_derivative(horizon, influences).map(Block::Text));
    blocks.extend(ends(scene, errors).map(Block::Text));
    if let Some(sentence) = matters_most(scene, horizon, influences) {
        blocks.push(Block::Text(sentence));
        blocks.push(Block::Table(influence_table(scene, influences)));
        blocks.push(Block::Table(derivative_table(scene, influences)));
    } else {
        blocks.push(Block::Text(
            "Positions have no derivative here: the run did not reach its end, or a convention resolved several contacts at once."
                .to_owned(),
        ));
    }
    blocks.push(Block::Table(event_table(scene, horizon)));
    blocks.push(Block::Command(format!("carom horizon {}", scene.name)));
    document(scene, sentence(scene, horizon), blocks)
}

fn document(scene: &Scene, lead: String, blocks: Vec<Block>) -> Document {
    Document {
        id: "index".to_owned(),
        stopped_early: None,
        title: format!("How far {} can be predicted", scene.name),
        lead,
        blocks,
        pages: Vec::new(),
    }
}

/// The balls that have no derivative by an input, in one sentence.
fn without_derivative(horizon: &Horizon, influences: &[Influence]) -> Option<String> {
    let lost = influences
        .iter()
        .filter(|influence| !influence.lost.is_empty());
    let lost = lost.map(|influence| {
        let lost = describe_lost(&influence.lost, &horizon.trace);
        format!("By {} {lost}", influence.input.name())
    });
    let lost: Vec<String> = lost.collect();
    (!lost.is_empty()).then(|| format!("{}.", lost.join("; ")))
}

/// How far balls may be off in the end, in one sentence, where they were in contact.
fn ends(scene: &Scene, errors: &[f64]) -> Option<String> {
    let known = errors.iter().copied().filter(|error| !error.is_nan());
    let largest = known.reduce(f64::max)? / scene.smallest_radius();
    let whose = if errors.iter().any(|error| error.is_nan()) {
        "balls that have a derivative"
    } else {
        "balls"
    };
    Some(format!(
        "Through rounding, and what was left of approaches when contacts began, {whose} are off by no more than an estimated {largest:.1e} R in the end."
    ))
}

/// The horizon in one sentence, and the growth in another.
fn sentence(scene: &Scene, horizon: &Horizon) -> String {
    let all = horizon.sights.len();
    let (precision, witness) = (horizon.precision.id(), horizon.witness.id());
    let reach = format!(
        "{precision} is right up to event {} of {all}, t = {:.4} {}",
        horizon.certain, horizon.until, scene.units.time
    );
    let first = match horizon.limit {
        Limit::Whole if !horizon.trace.ending.is_complete() => format!(
            "{precision} is right about {all} events, and then the run has no answer: it ends as {}",
            horizon.trace.ending.id()
        ),
        Limit::Whole => format!("{precision} is right about the whole shot: all {all} events"),
        Limit::Order => format!("{reach}: then {precision} and {witness} go different ways"),
        Limit::Apart => {
            format!("{reach}: then {precision} and {witness} differ by more than {BAND:e} R")
        }
        Limit::Margin => {
            let next = horizon.sights.get(horizon.certain);
            let next = next.map_or_else(String::new, |sight| {
                describe_kind(sight.event.kind, &horizon.trace)
            });
            format!("{reach}: then {next} is too close to another event to be certain of its place")
        }
    };
    let second = horizon.growth.as_ref().map(|growth| {
        let grows = || {
            format!(
                " A perturbation of the start grows {}.",
                describe_growth(growth.last())
            )
        };
        match describe_rough(growth, &horizon.trace) {
            None => grows(),
            Some(rough)
                if growth.lost.is_empty() || growth.lost.len() == horizon.trace.balls.len() =>
            {
                format!(" Its growth is {rough}.")
            }
            Some(rough) => format!("{} Its growth is {rough}.", grows()),
        }
    });
    format!("{first}.{}", second.unwrap_or_default())
}

/// Which input moves a ball farthest, in one sentence.
fn matters_most(scene: &Scene, horizon: &Horizon, influences: &[Influence]) -> Option<String> {
    let mut moved: Vec<(&Influence, usize, f64)> = influences
        .iter()
        .filter_map(|influence| {
            let (ball, length) = influence.largest()?;
            Some((influence, ball, length / scene.smallest_radius()))
        })
        .filter(|(_, _, length)| *length > 0.0)
        .collect();
    moved.sort_by(|a, b| b.2.total_cmp(&a.2));
    let (first, ball, length) = *moved.first()?;
    let mut sentence = format!(
        "Of the inputs, {} matters most: {} moves ball {} by {} R",
        first.input.name(),
        first.input.change(),
        scene.balls[ball].id,
        short_length(length)
    );
    for (influence, ball, length) in &moved[1..] {
        sentence += &format!(
            "; {} of {} ball {} by {} R",
            influence.input.change(),
            influence.input.name(),
            scene.balls[*ball].id,
            short_length(*length)
        );
    }
    if !horizon.is_whole() {
        sentence += &format!(
            " at the horizon, t = {:.4} {}",
            horizon.until, scene.units.time
        );
    }
    Some(sentence + ".")
}

fn short_length(r: f64) -> String {
    if (1e-3..1e4).contains(&r) {
        let digits = (1 - r.log10().floor() as i32).clamp(0, 5) as usize;
        format!("{r:.digits$}")
    } else {
        format!("{r:.1e}")
    }
}

/// One row a ball, one column an input: how far its usual change moves the ball.
fn influence_table(scene: &Scene, influences: &[Influence]) -> Table {
    let radius = scene.smallest_radius();
    let heading = |influence: &Influence| {
        let title = format!("{} {}", influence.input.name(), influence.input.change());
        Column::number(&key(influence), &title, "R")
    };
    Table {
        id: "influences".to_owned(),
        title: "What moves the balls".to_owned(),
        columns: with_ball(influences.iter().map(heading)),
        rows: rows(scene, |ball| {
            let moves = influences.iter().map(|influence| influence.moves(ball) / radius);
            moves.map(|x| Cell::maybe(Some(x).filter(|x| !x.is_nan()))).collect()
        }),
        note: "First order, along the order of events of this run: a change large enough to reorder hits does more.".to_owned(),
    }
}

/// The derivatives themselves.
fn derivative_table(scene: &Scene, influences: &[Influence]) -> Table {
    let radius = scene.smallest_radius();
    let headings = influences.iter().flat_map(|influence| {
        ["x", "y"].map(|axis| {
            Column::number(
                &format!("{}-{axis}", key(influence)),
                &format!("{axis} by {}", influence.input.name()),
                influence.input.unit(),
            )
        })
    });
    Table {
        id: "derivatives".to_owned(),
        title: "Derivatives of the positions".to_owned(),
        columns: with_ball(headings),
        rows: rows(scene, |ball| {
            let both = influences.iter().flat_map(|influence| influence.derivative[ball]);
            both.map(|d| Cell::maybe(Some(d / radius).filter(|d| !d.is_nan()))).collect()
        }),
        note: "By rad of the aim, by a relative change of speeds and numbers of effects, by a restitution itself.".to_owned(),
    }
}

fn key(influence: &Influence) -> String {
    influence.input.name().replace([' ', '.', '_'], "-")
}

fn with_ball(columns: impl Iterator<Item = Column>) -> Vec<Column> {
    std::iter::once(Column::words("ball", "ball"))
        .chain(columns)
        .collect()
}

fn rows(scene: &Scene, cells: impl Fn(usize) -> Vec<Cell>) -> Vec<Vec<Cell>> {
    let row = |(ball, known): (usize, &crate::scene::Ball)| {
        let mut row = vec![Cell::text(known.id.clone())];
        row.extend(cells(ball));
        row
    };
    scene.balls.iter().enumerate().map(row).collect()
}

/// Every event with what is known of its certainty.
fn event_table(scene: &Scene, horizon: &Horizon) -> Table {
    let time = &scene.units.time;
    let mut columns = vec![
        Column::number("event", "#", ""),
        Column::number("time", "time", time),
        Column::words("what", "what"),
        Column::number("margin", "margin", time),
        Column::number("condition", "condition", ""),
        Column::number("time-error", "error, estimated", time),
        Column::number("seen", "seen", time),
        Column::number("apart", "apart", "R"),
        Column::number("growth", "growth", ""),
    ];
    if !horizon.is_whole() {
        columns.push(Column::words("horizon", "horizon"));
    }
    let factors = horizon
        .growth
        .as_ref()
        .map_or(&[][..], |growth| &growth.factors);
    let row = |(index, sight): (usize, &Sight)| {
        let who = describe_kind(sight.event.kind, &horizon.trace);
        let what = match sight.event.kind {
            EventKind::Stop(_) => format!("{who} stops"),
            _ => who,
        };
        let mut row = vec![
            Cell::Count(index as u64 + 1),
            Cell::Fixed(sight.event.time, 9),
            Cell::text(what),
            Cell::maybe(sight.margin.filter(|margin| margin.is_finite())),
            Cell::maybe(sight.condition),
            Cell::maybe(sight.estimated),
            Cell::maybe(sight.seen),
            Cell::maybe(sight.apart),
            Cell::maybe(factors.get(index).copied()),
        ];
        if !horizon.is_whole() {
            row.push(Cell::text(if sight.shrinks {
                "of no account"
            } else if index < horizon.certain {
                "within"
            } else {
                "beyond"
            }));
        }
        row
    };
    let told = horizon.sights.iter().filter(|sight| !sight.shrinks);
    let closest = told.filter_map(|sight| sight.margin);
    let closest = closest.fold(f64::INFINITY, f64::min);
    let note = format!(
        "margin: until the next other candidate of its balls, had it not happened (smallest: {}). condition: relative speed over \
         its normal part. error: of the time, estimated from rounding, and seen as the difference from the finer precision. apart: \
         largest difference of the two.",
        describe_span(closest)
    );
    Table {
        id: "events".to_owned(),
        title: "How certain each event is".to_owned(),
        columns,
        rows: horizon.sights.iter().enumerate().map(row).collect(),
        note,
    }
}

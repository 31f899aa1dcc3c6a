//! The sentence a person came for, and lists in words.

use crate::study::effects::{EffectsOutcome, Optional, Variant, Verdict, WHOLE};
use crate::words::describe_span;

/// Which effects the shot needs and what leaving each out would cost.
pub fn sentence(outcome: &EffectsOutcome) -> String {
    let name = &outcome.plan.scene.name;
    if outcome.cells.is_empty() {
        return format!("{name} was not run, so what its effects are worth is unknown.");
    }
    let Some(column) = outcome.reference else {
        let whys = (0..outcome.columns.len()).filter_map(|column| outcome.why_not(WHOLE, column));
        return format!(
            "No engine reaches the end of {name} with all its effects, so what leaving one out costs is unknown. {}.",
            whys.collect::<Vec<_>>().join("; ")
        );
    };
    let mut sentences = Vec::new();
    if outcome.plan.effects.is_empty() {
        sentences.push(
            "This shot names no effect beyond the bare model: there is nothing to leave out."
                .to_owned(),
        );
    }
    let of = |verdict: Verdict| -> Vec<&Variant> {
        let mut found = outcome.by_cost();
        found.retain(|variant| outcome.verdict(variant) == verdict);
        found
    };
    let needed = of(Verdict::Needed);
    if !needed.is_empty() {
        let costs = needed.iter().enumerate().map(|(i, variant)| {
            let cost = cost(outcome, variant);
            if i == 0 {
                let effect = variant.effect;
                format!("{}: leaving {} out {cost}", effect.name(), effect.pronoun())
            } else {
                format!("{} ({cost})", variant.effect.name())
            }
        });
        sentences.push(format!(
            "This shot needs {}.",
            costs.collect::<Vec<_>>().join("; ")
        ));
    }
    let spare = of(Verdict::NotNeeded);
    if !spare.is_empty() {
        let costs = spare.iter().map(|variant| {
            let moved = outcome.cost(variant).map_or(0.0, |change| change.moved());
            format!("{} ({} R)", variant.effect.name(), short(moved))
        });
        let costs: Vec<String> = costs.collect();
        sentences.push(format!("It does not need {}.", listed(&costs, "or")));
    }
    let unknown = of(Verdict::Unknown);
    if !unknown.is_empty() {
        let whys = unknown.iter().map(|variant| {
            let why = outcome.why_not(variant.row, column);
            let why = why.unwrap_or_else(|| "it was not run".to_owned());
            format!("without {} {why}", variant.effect.name())
        });
        sentences.push(format!(
            "Whether it needs the rest is unknown: {}.",
            whys.collect::<Vec<_>>().join("; ")
        ));
    }
    sentences.extend(ladder(outcome, column));
    sentences.join(" ")
}

/// What leaving an effect out does to the shot: `moves ball 3 by 12.0 R`.
fn cost(outcome: &EffectsOutcome, variant: &Variant) -> String {
    let Some(change) = outcome.cost(variant) else {
        return String::new();
    };
    let moves = change
        .position()
        .filter(|owned| owned.value > outcome.threshold || owned.value.is_nan())
        .map(|owned| format!("moves ball {} by {} R", owned.ball, short(owned.value)));
    let falls = change.falls.first().map(|first| match change.falls.len() {
        1 => first.clone(),
        2 => format!("{first} and 1 other falls otherwise"),
        n => format!("{first} and {} others fall otherwise", n - 1),
    });
    let both: Vec<String> = moves.into_iter().chain(falls).collect();
    both.join(", and ")
}

/// What the richest scene of the chain does that this one does not.
fn ladder(outcome: &EffectsOutcome, column: usize) -> Option<String> {
    let top = outcome.plan.top();
    if !outcome.plan.is_chain || top == WHOLE {
        return None;
    }
    let name = &outcome.plan.ladder.last()?.name;
    let Some(change) = outcome.change(WHOLE, column, top) else {
        let why = outcome.why_not(top, column)?;
        return Some(format!("What {name} adds is unknown: {why}."));
    };
    let owned = change.position()?;
    Some(format!(
        "Everything that {name} adds moves ball {} by {} R.",
        owned.ball,
        short(owned.value)
    ))
}

/// What all effects together cost in time.
pub fn time(outcome: &EffectsOutcome) -> Option<String> {
    if outcome.plan.effects.is_empty() {
        return None;
    }
    let column = outcome.reference?;
    let whole = outcome.seconds(WHOLE, column)?;
    let bare = outcome.seconds(outcome.plan.bare, column)?;
    Some(format!(
        "One shot takes {} in {} with every effect and {} in the bare model, {:.1} times as long.",
        describe_span(whole),
        outcome.columns[column].label(),
        describe_span(bare),
        whole / bare
    ))
}

/// What comes or goes with an effect: `with rolling resistance, throw`.
pub fn along(effects: &[Optional]) -> String {
    let names: Vec<&str> = effects.iter().map(|effect| effect.name()).collect();
    names.join(", ")
}

/// `a, b or c`.
fn listed(items: &[String], last: &str) -> String {
    match items {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., end] => format!("{} {last} {end}", first.join(", ")),
    }
}

/// A distance with three significant digits.
pub fn short(x: f64) -> String {
    if x == 0.0 {
        "0".to_owned()
    } else if (1e-3..1e5).contains(&x) {
        let digits = (2 - x.log10().floor() as i32).clamp(0, 5) as usize;
        format!("{x:.digits$}")
    } else {
        format!("{x:.1e}")
    }
}

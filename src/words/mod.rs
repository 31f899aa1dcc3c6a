//! Scenes, events and endings in plain words.

use crate::compare::Order;
use crate::oracle::{Growth, Horizon, Lost, Why};
use crate::physics::Pockets;
use crate::scene::Scene;
use crate::trace::{Ending, Event, EventKind, Trace};

/// `16 balls · cloth.translational mu 0.2 · contact.elastic · 20 s`.
pub fn describe_scene(scene: &Scene) -> String {
    let balls = match scene.balls.len() {
        1 => "1 ball".to_owned(),
        n => format!("{n} balls"),
    };
    let mut numbers: Vec<(&'static str, f64)> = Vec::new();
    scene.effects.map(|key, value| numbers.push((key, value)));
    let with_numbers = |id: &&'static str| {
        if let (&Pockets::<f64>::ID, Some(pockets)) = (id, &scene.effects.pockets) {
            return match pockets.circles.len() {
                1 => "1 pocket".to_owned(),
                n => format!("{n} pockets"),
            };
        }
        let own = numbers.iter().filter_map(|(key, value)| {
            let name = key.strip_prefix(id)?.strip_prefix('.')?;
            Some(format!(" {name} {value}"))
        });
        let words = id.replace('.', " ");
        format!("{words}{}", own.collect::<String>())
    };
    let mut parts = vec![balls];
    parts.extend(scene.effects.named().iter().map(with_numbers));
    parts.push(format!("{} s", scene.duration));
    parts.join(" · ")
}

/// `2-5 at 0.7300652 s`, or `nothing more`.
pub fn describe_event(event: Option<&Event>, trace: &Trace) -> String {
    match event {
        Some(event) => format!(
            "{} at {:.7} s",
            describe_kind(event.kind, trace),
            event.time
        ),
        None => "nothing more".to_owned(),
    }
}

/// `2-5`, or `11-y1` for a cushion.
pub fn describe_kind(kind: EventKind, trace: &Trace) -> String {
    let (a, b) = kind.parties(|ball| trace.balls.get(ball).map_or("?", String::as_str));
    if b.is_empty() { a } else { format!("{a}-{b}") }
}

/// How a run ended, in one sentence.
pub fn describe_ending(trace: &Trace) -> String {
    let engine = &trace.provenance.engine;
    match (&trace.ending, trace.ending.spot()) {
        (ending, Some(spot)) => {
            let name = |&ball: &u32| trace.balls.get(ball as usize).cloned().unwrap_or_default();
            let balls: Vec<String> = spot.balls.iter().map(name).collect();
            let at = format!("{:.7} s", spot.time);
            format!(
                "{engine} ends as {} at {at}, balls {}: {}",
                ending.id(),
                balls.join(", "),
                spot.why
            )
        }
        (Ending::Rest, None) => {
            format!("{engine}: everything at rest after {:.7} s", trace.end_time)
        }
        (Ending::Duration, None) => format!("{engine}: ran for {} s", trace.end_time),
        (ending, None) => format!(
            "{engine} ended early ({}) at {:.7} s",
            ending.id(),
            trace.end_time
        ),
    }
}

/// Why a run ended, in a few words beside its name and time: `everything at rest`, `indeterminate: ...`.
pub fn ending(trace: &Trace) -> String {
    match (&trace.ending, trace.ending.spot()) {
        (ending, Some(spot)) => format!("{}: {}", ending.id(), spot.why),
        (Ending::Rest, None) => "everything at rest".to_owned(),
        (Ending::Duration, None) => "the scene asks for no more".to_owned(),
        (ending, None) => format!("ended early: {}", ending.id()),
    }
}

/// `whole shot, growth 812 x`, or `event 51 of 115, t = 10.2776 s, growth 1.7e17 x`.
pub fn describe_horizon(horizon: &Horizon) -> String {
    let reach = if horizon.is_whole() {
        "whole shot".to_owned()
    } else {
        format!(
            "event {} of {}, t = {:.4} s",
            horizon.certain,
            horizon.sights.len(),
            horizon.until
        )
    };
    match &horizon.growth {
        Some(growth) => {
            let whose = if growth.lost.is_empty() {
                ""
            } else {
                " of those that have one"
            };
            format!("{reach}, growth{whose} {}", describe_growth(growth.last()))
        }
        None => reach,
    }
}

/// `no derivative has ball 2 from event 7 on (there two things come at one instant that a small change sets apart), ball 3 from event 9 on (it met one
/// without)`.
pub fn describe_lost(lost: &[Lost], trace: &Trace) -> String {
    let each = lost.iter().map(|lost| {
        let why = match lost.why {
            Why::Together => "there two things come at one instant that a small change sets apart",
            Why::Met => "it met one without",
            Why::Untold => "it cannot be told within a contact",
        };
        let (ball, event) = (&trace.balls[lost.ball], lost.event + 1);
        format!("ball {ball} from event {event} on ({why})")
    });
    format!("no derivative has {}", each.collect::<Vec<_>>().join(", "))
}

/// Up to where the growth of a run is known, in one sentence; `None` if all along and of all balls.
pub fn describe_rough(growth: &Growth, trace: &Trace) -> Option<String> {
    let event = growth.rough?;
    Some(if growth.lost.len() == trace.balls.len() {
        format!(
            "known up to event {event} only: {}",
            describe_lost(&growth.lost, trace)
        )
    } else if growth.differs {
        format!("known up to event {event} only: then the run with derivatives goes another way")
    } else if growth.lost.is_empty() {
        format!(
            "known up to event {event} only: then a convention resolved several contacts at once"
        )
    } else {
        format!(
            "that of the other balls from event {event} on: {}",
            describe_lost(&growth.lost, trace)
        )
    })
}

/// `812 x`.
pub fn describe_growth(factor: f64) -> String {
    if (1.0..1e5).contains(&factor) {
        let digits = (2 - factor.log10().floor() as i32).max(0) as usize;
        format!("{factor:.digits$} x")
    } else {
        format!("{factor:.2e} x")
    }
}

/// A time span in the unit that shows it best: `78 us`.
pub fn describe_span(seconds: f64) -> String {
    let s = seconds.abs();
    let (factor, unit) = match s {
        _ if s >= 1.0 => (1.0, "s"),
        _ if s >= 1e-3 => (1e3, "ms"),
        _ if s >= 1e-6 => (1e6, "us"),
        _ => (1e9, "ns"),
    };
    let scaled = s * factor;
    let digits = if scaled >= 100.0 {
        0
    } else if scaled >= 10.0 {
        1
    } else {
        2
    };
    format!("{scaled:.digits$} {unit}")
}

/// `9/36`, and `5/5 +2` where all agree and the engine adds two of its own.
pub fn describe_order(order: &Order, agreeing: usize) -> String {
    let total = order.reference_collisions;
    match order.collisions.saturating_sub(total) {
        added if added > 0 && agreeing == total => format!("{total}/{total} +{added}"),
        _ => format!("{agreeing}/{total}"),
    }
}

/// `a`, `a and b`, `a, b and c`.
pub(super) fn listed(words: &[String]) -> String {
    match words {
        [] => String::new(),
        [one] => one.clone(),
        [most @ .., last] => format!("{} and {last}", most.join(", ")),
    }
}

//! Why two collision orders first differ: the margin against the resolution, a contact that lasts, or the setting that moves it.

use super::{ComparisonOutcome, Standing};
use crate::compare::{ContactPhase, Parting};
use crate::engine::{Name, Setting};
use crate::scene::Scene;
use crate::study::matrix::{Configuration, Timing, Watch, run_row};
use crate::trace::{Event, EventKind, Record, Trace};
use crate::words::describe_span;

/// Why two collision orders differ where they first do.
#[derive(Clone, Debug, PartialEq)]
pub enum Cause {
    /// The two candidates are closer together than what the engine resolves.
    Resolution {
        /// Time between the two candidates in the reference, s.
        margin: f64,
        /// What the engine resolves, s.
        resolution: f64,
    },
    /// With another setting the difference is gone.
    Setting {
        /// What the setting stands for.
        what: Name,
        /// The setting under which the orders agree at this place.
        setting: Setting,
    },
    /// The two that meet in one of the traces and not in the other are in contact, or so close to it that impacts come faster than the
    /// engine resolves.
    Contact {
        /// The two, as `cue-1`.
        name: String,
        /// From when to when the reference has them in contact, s.
        span: [f64; 2],
        /// Time from the impact before in the reference, s; `None` once they are in contact.
        interval: Option<f64>,
        /// What the engine resolves, s.
        resolution: f64,
    },
    /// None of these; the settings that were tried.
    Open {
        /// Time between the two candidates in the reference, s, if it has both.
        margin: Option<f64>,
        /// What the engine resolves, s.
        resolution: f64,
        /// What was tried.
        tried: Vec<Name>,
    },
}

impl Cause {
    /// The cause in one sentence.
    pub fn sentence(&self) -> String {
        match self {
            Cause::Resolution { margin, resolution } => format!(
                "the two are {} apart; event times are resolved to {}",
                describe_span(*margin),
                describe_span(*resolution)
            ),
            Cause::Setting { what, setting } => {
                format!("{what}: with {setting} the orders agree here")
            }
            Cause::Contact {
                name,
                span: [begin, end],
                interval,
                resolution,
            } => match interval {
                Some(interval) => format!(
                    "impacts of {name} are {} apart here, on their way into a contact at {begin:.7} s; event times are resolved to {}",
                    describe_span(*interval),
                    describe_span(*resolution)
                ),
                None if begin == end => format!(
                    "impacts of {name} shrink to nothing at {begin:.4} s, where the two part"
                ),
                None => format!(
                    "{name} is in contact from {begin:.4} s to {end:.4} s, which takes no hits"
                ),
            },
            Cause::Open {
                margin,
                resolution,
                tried,
            } => {
                let gap = match margin {
                    Some(margin) => format!(
                        "the two are {} apart and event times are resolved to {}",
                        describe_span(*margin),
                        describe_span(*resolution)
                    ),
                    None => "the other never has this event".to_owned(),
                };
                match tried.is_empty() {
                    true => gap,
                    false => format!(
                        "{gap}; changing {} alone does not cure it",
                        tried.join(" or ")
                    ),
                }
            }
        }
    }
}

/// Finds the cause of every first difference of an outcome. Margins and contacts are read; what they do not explain is rerun with one
/// knob changed, up to the difference.
pub(super) fn find_causes(outcome: &mut ComparisonOutcome, watch: Watch<'_>) {
    let mut causes = Vec::new();
    if let Some(reference) = outcome.reference.and_then(|i| outcome.entries[i].trace()) {
        for entry in &outcome.entries {
            let standing = entry.standing.as_ref();
            let Some(standing) = standing.filter(|standing| standing.order.parting.is_some())
            else {
                causes.push(None);
                continue;
            };
            // an ablation that did not come to its end did not fail to cure
            let found =
                watch.whole(|| cause(&outcome.scene, &entry.column, standing, reference, watch));
            outcome.extent.count(found.is_some());
            causes.push(found.flatten());
        }
    }
    for (entry, cause) in outcome.entries.iter_mut().zip(causes) {
        if let Some(standing) = entry.standing.as_mut() {
            standing.cause = cause;
        }
    }
    for pair in &mut outcome.pairs {
        // two engines that both step: the margin is all that can be read without a reference
        pair.standing.cause = pair.standing.order.parting.as_ref().map(|parting| {
            by_margin(parting, pair.standing.order.resolution).unwrap_or(Cause::Open {
                margin: parting.margin,
                resolution: pair.standing.order.resolution,
                tried: Vec::new(),
            })
        });
    }
}

fn cause(
    scene: &Scene,
    column: &Configuration,
    standing: &Standing,
    reference: &Trace,
    watch: Watch<'_>,
) -> Option<Cause> {
    let parting = standing.order.parting.as_ref()?;
    let resolution = standing.order.resolution;
    if let Some(cause) = by_margin(parting, resolution) {
        return Some(cause);
    }
    if let Some(cause) = by_contact(standing, reference) {
        return Some(cause);
    }
    // one more than agree: where the reference has nothing more, the engine may have nothing more either
    let prefix = |trace: &Trace| -> Vec<EventKind> {
        trace
            .collisions()
            .take(parting.index + 1)
            .map(|event| event.kind)
            .collect()
    };
    let wanted = prefix(reference);
    let ablations = column.engine.ablations(scene, &column.setting);
    let columns: Vec<Configuration> = ablations
        .iter()
        .map(|(_, setting)| Configuration::with(&column.engine, setting.clone()))
        .collect();
    let silent = Watch {
        progress: &|_, _, _| {},
        cancelled: watch.cancelled,
    };
    let cells = run_row(
        &up_to(scene, parting, resolution),
        &columns,
        Record::Events,
        Timing::None,
        silent,
    );
    for ((what, setting), cell) in ablations.iter().zip(&cells) {
        let Ok(ran) = cell else { continue };
        if prefix(&ran.trace) == wanted {
            return Some(Cause::Setting {
                what: what.clone(),
                setting: setting.clone(),
            });
        }
    }
    let tried = ablations.into_iter().map(|(what, _)| what).collect();
    Some(Cause::Open {
        margin: parting.margin,
        resolution,
        tried,
    })
}

fn by_margin(parting: &Parting, resolution: f64) -> Option<Cause> {
    let margin = parting.margin?.abs();
    (margin <= resolution).then_some(Cause::Resolution { margin, resolution })
}

/// A difference that a contact of the reference makes: hits while it lasts, and impacts before it that are closer than is resolved.
fn by_contact(standing: &Standing, reference: &Trace) -> Option<Cause> {
    let parting = standing.order.parting.as_ref()?;
    let resolution = standing.order.resolution;
    let cause = |phase: &ContactPhase| {
        let own = |event: &&Event| event.kind == phase.hit;
        let held = parting.event.as_ref().filter(own).is_some_and(|event| {
            event.time >= phase.begin - resolution && event.time <= phase.end + resolution
        });
        let before = reference
            .collisions()
            .take(parting.index)
            .filter(own)
            .last();
        let interval = parting.reference.as_ref().filter(own).zip(before);
        let interval = interval
            .filter(|(next, _)| next.time > phase.from && next.time <= phase.begin)
            .map(|(next, before)| next.time - before.time)
            .filter(|interval| *interval <= resolution);
        (held || interval.is_some()).then(|| Cause::Contact {
            name: phase.name(reference),
            span: [phase.begin, phase.end],
            interval,
            resolution,
        })
    };
    standing
        .contacts
        .iter()
        .find_map(|contact| cause(&contact.phase))
}

/// Part of the time to the difference by which a rerun goes on after it: an event may come later there.
const BEYOND: f64 = 0.1;

/// The scene, ended a little after the later of the two events.
fn up_to(scene: &Scene, parting: &Parting, resolution: f64) -> Scene {
    let times = [parting.event, parting.reference]
        .into_iter()
        .flatten()
        .map(|event| event.time);
    let last = times.fold(0.0, f64::max);
    Scene {
        duration: (last * (1.0 + BEYOND) + 10.0 * resolution).min(scene.duration),
        ..scene.clone()
    }
}

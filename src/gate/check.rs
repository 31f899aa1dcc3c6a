//! A check held against its baselines.

use super::{Accepted, Change, Kind, Located, Row, Standing, contradictions, diff};
use crate::finding::Finding;
use crate::page::check::Against;
use crate::study::check::{CheckOutcome, Level, ORACLE, level, unit_of};

/// What a check found, and how it differs from what was accepted.
#[derive(Clone, Debug)]
pub struct Held {
    /// What was found.
    pub outcome: CheckOutcome,
    /// By part of the outcome: scenes, then the random ones; `None` where nothing was accepted.
    pub accepted: Vec<Option<Accepted>>,
    /// What differs, in the scenes of which something was accepted.
    pub changes: Vec<Located>,
    /// Scenes that are not what they were when their findings were accepted.
    pub stale: Vec<String>,
    /// Baselines of scenes that are no longer checked.
    pub unread: Vec<String>,
    /// What a baseline says of itself that is not so: scene and sentence.
    pub contradictions: Vec<(String, String)>,
}

/// How the bits of a check stand to those of the accepted runs. They only inform.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Bits {
    /// Runs with the same bits.
    pub same: usize,
    /// Runs with other bits and the same findings: same physics, different bits.
    pub other: usize,
    /// Runs with other bits and findings that changed.
    pub changed: usize,
}

impl Held {
    /// Holds every scene. `unread`: baselines that no scene reads.
    pub fn new(
        outcome: CheckOutcome,
        accepted: Vec<Option<Accepted>>,
        unread: Vec<String>,
    ) -> Held {
        let mut held = Held {
            outcome,
            accepted,
            changes: Vec::new(),
            stale: Vec::new(),
            unread,
            contradictions: Vec::new(),
        };
        // what did not run has no findings, and that is no change
        if held.is_cut_short() {
            return held;
        }
        for ((scene, hash), accepted) in held.outcome.parts().into_iter().zip(&held.accepted) {
            let Some(accepted) = accepted else {
                continue;
            };
            if accepted.hash != hash {
                held.stale.push(scene.clone());
            }
            let found = contradictions(accepted, &scene, &held.bits_of(&scene));
            held.contradictions
                .extend(found.into_iter().map(|words| (scene.clone(), words)));
            let changes = diff(&accepted.rows, &held.rows(&scene), |row| {
                held.outcome.tolerance(&row.engine, &row.check)
            });
            held.changes
                .extend(changes.into_iter().map(|change| Located {
                    scene: scene.clone(),
                    change,
                }));
        }
        held
    }

    /// True if not everything ran: then nothing is held.
    pub fn is_cut_short(&self) -> bool {
        self.outcome.missing() > 0
    }

    /// True if what was accepted of a scene was accepted of another one, or says of itself what is not so.
    pub fn is_stale(&self, scene: &str) -> bool {
        let contradicts = self.contradictions.iter().any(|(of, _)| of == scene);
        contradicts || self.stale.iter().any(|of| of == scene)
    }

    /// How one engine of one scene stands to what was accepted on one level.
    pub fn against(&self, scene: &str, engine: &str, level: Level) -> Against {
        if self.is_cut_short() {
            Against::NotHeld
        } else if self.accepted_of(scene).is_none() {
            Against::NoBaseline
        } else {
            Against::Changed(self.changes_of(scene, engine, level).count())
        }
    }

    /// What would be accepted of a scene.
    pub fn rows(&self, scene: &str) -> Vec<Row> {
        let own = self.outcome.of_scene(scene);
        own.map(|finding: &Finding| Row::from(finding)).collect()
    }

    /// Digests of the runs of a scene, by engine.
    pub fn bits_of(&self, scene: &str) -> Vec<(String, String)> {
        let own = self.outcome.bits.iter().filter(|(of, ..)| of == scene);
        own.map(|(_, engine, digest)| (engine.clone(), digest.clone()))
            .collect()
    }

    /// Names of scenes of which nothing was accepted.
    pub fn unknown(&self) -> Vec<&str> {
        let parts = self.outcome.names().into_iter().zip(&self.accepted);
        parts
            .filter(|(_, accepted)| accepted.is_none())
            .map(|(name, _)| name)
            .collect()
    }

    /// How it stands to what was accepted.
    pub fn standing(&self) -> Standing {
        Standing {
            cut_short: self.is_cut_short(),
            missing: self.unknown().len(),
            stale: self.stale.len() + self.unread.len() + self.contradictions.len(),
            changes: self.changes.len(),
            broken_promises: self.outcome.broken.len(),
        }
    }

    /// The accepted findings of a scene.
    pub fn accepted_of(&self, scene: &str) -> Option<&Accepted> {
        let parts = self.outcome.names().into_iter().zip(&self.accepted);
        let mut own = parts.filter(|(own, _)| *own == scene);
        own.next().and_then(|(_, accepted)| accepted.as_ref())
    }

    /// What changed of one engine in one scene on one level. What changed of an engine that is no case of the scene, such as one that was
    /// accepted and is no more, is told with the oracle's errors: nothing that changed is without a place.
    pub fn changes_of<'a>(
        &'a self,
        scene: &'a str,
        engine: &'a str,
        wanted: Level,
    ) -> impl Iterator<Item = &'a Change> {
        let own = self.changes.iter().filter(move |l| l.scene == scene);
        let is_case = move |of: &str, on: Level| {
            let mut cases = self.outcome.cases.iter();
            cases.any(|c| c.scene == scene && c.engine == of && c.level == on)
        };
        let everything_else = engine == ORACLE && wanted == Level::Error;
        own.map(|located| &located.change).filter(move |change| {
            change.row().is_some_and(|row| {
                let on = level(&row.check);
                (row.engine == engine && on == wanted)
                    || (everything_else && !is_case(&row.engine, on))
            })
        })
    }

    /// How the bits stand to those of the accepted runs.
    pub fn bits(&self) -> Bits {
        let mut bits = Bits::default();
        for (scene, engine, digest) in &self.outcome.bits {
            let before = self.accepted_of(scene).map(|accepted| &accepted.bits);
            let before = before.and_then(|all| all.iter().find(|(of, _)| of == engine));
            let Some((_, before)) = before else {
                continue;
            };
            let mut changes = Level::ALL
                .iter()
                .map(|&l| self.changes_of(scene, engine, l));
            let changed = changes.any(|mut own| own.next().is_some());
            let count = match (before == digest, changed) {
                (true, _) => &mut bits.same,
                (false, false) => &mut bits.other,
                (false, true) => &mut bits.changed,
            };
            *count += 1;
        }
        bits
    }

    /// One change in a sentence that a person can act on: what, where, how much.
    pub fn sentence(&self, scene: &str, change: &Change) -> String {
        let Some(row) = change.row() else {
            return String::new();
        };
        let unit = unit_of(&row.check);
        let figure = |row: &Row| match (row.value, row.verdict) {
            (_, Some(verdict)) => verdict.id().to_owned(),
            (Some(value), None) => format!("{} {unit}", digits(value)).trim_end().to_owned(),
            (None, None) => "no number".to_owned(),
        };
        let what = format!("{} {}", row.check, row.subject);
        let place = format!("{} in {} of {scene}", what.trim_end(), row.engine);
        match (change.kind, &change.old, &change.new) {
            (Kind::Appeared, _, Some(new)) => {
                format!("{place}: was not there, is {}", figure(new))
            }
            (Kind::Vanished, Some(old), _) => {
                format!("{place}: was {}, is no longer found", figure(old))
            }
            (kind, Some(old), Some(new)) => {
                let by = match (old.value, new.value, change.bound) {
                    (Some(_), Some(_), Some(0.0)) => "; it may not move".to_owned(),
                    (Some(old), Some(new), Some(bound)) => {
                        format!(
                            ", a change of {:.3e}; it may move by {bound:.1e}",
                            new - old
                        )
                    }
                    _ => String::new(),
                };
                let (was, is) = (figure(old), figure(new));
                format!("{place}: {}, was {was}, is {is}{by}", kind.id())
            }
            _ => place,
        }
    }

    /// Since when it was otherwise: reason and versions of what was accepted.
    pub fn since(&self, scene: &str, engine: &str) -> String {
        let Some(accepted) = self.accepted_of(scene) else {
            return "nothing is accepted of this scene".to_owned();
        };
        let id = engine.split_whitespace().next().unwrap_or_default();
        let mut versions = vec![format!("carom {}", accepted.version("carom"))];
        for name in [id, "commit", "compiler", "target"] {
            let version = accepted.version(name);
            if !version.is_empty() {
                versions.push(format!("{name} {version}"));
            }
        }
        format!(
            "accepted because: {} ({})",
            accepted.reason,
            versions.join(", ")
        )
    }
}

/// Ten significant digits: more than any figure may move by without being told.
fn digits(value: f64) -> String {
    let rounded = format!("{value:.9e}").parse().unwrap_or(value);
    if rounded == 0.0 || (1e-4..1e7).contains(&f64::abs(rounded)) {
        format!("{rounded}")
    } else {
        format!("{rounded:e}")
    }
}

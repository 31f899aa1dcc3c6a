//! What stands above the findings in an accepted file, held against what is there now.
//!
//! | line      | how it is held                                                                                                  |
//! |-----------|-----------------------------------------------------------------------------------------------------------------|
//! | `scene`   | it is the scene that the file is named after                                                                    |
//! | `hash`    | it is that of the scene as it stands                                                                            |
//! | `reason`  | it is there; words for people, which nothing can be held against                                                |
//! | `version` | told where it differs: that another version gives the same is what a gate is for. A commit only says where they were accepted |
//! | `bits`    | there is one for every run that ran, and no other; digests that differ are counted and told, see [`super::Bits`] |

use super::Accepted;
use std::collections::BTreeSet;

/// The line that says where findings were accepted: it names no part of what runs.
const COMMIT: &str = "commit";

/// What a file says of itself that is not so, in sentences. `scene`: the one that it was read for; `bits`: engine and digest of every run
/// of it, empty where the file holds none.
pub fn contradictions(accepted: &Accepted, scene: &str, bits: &[(String, String)]) -> Vec<String> {
    let mut found = Vec::new();
    if accepted.scene != scene {
        found.push(format!(
            "the file of {scene} says that it is of {}",
            accepted.scene
        ));
    }
    let known = |list: &[(String, String)], engine: &str| list.iter().any(|(of, _)| of == engine);
    for (engine, _) in &accepted.bits {
        if !known(bits, engine) {
            found.push(format!(
                "the file of {scene} has the bits of {engine}, of which there is no run"
            ));
        }
    }
    for (engine, _) in bits {
        if !known(&accepted.bits, engine) {
            found.push(format!("the file of {scene} lacks the bits of {engine}"));
        }
    }
    found
}

/// Which versions gave accepted findings other than those that run now, a few words each. `now`: names and versions.
pub fn other_versions(accepted: &Accepted, now: &[(String, String)]) -> Vec<String> {
    let mut told = Vec::new();
    let named = accepted.versions.iter().filter(|(name, _)| name != COMMIT);
    for (name, was) in named {
        match now.iter().find(|(of, _)| of == name) {
            Some((_, is)) if is == was => {}
            Some((_, is)) => told.push(format!("{name} was {was} and is {is}")),
            None => told.push(format!("{name} was {was} and is not there")),
        }
    }
    let new = now.iter().filter(|(name, _)| name != COMMIT);
    for (name, is) in new.filter(|(name, _)| accepted.version(name).is_empty()) {
        told.push(format!("{name} is {is} and was not told"));
    }
    told
}

/// The same of many files, each once, in a sentence without its end; `None` where there is nothing to tell.
pub fn versions_sentence<'a>(
    accepted: impl IntoIterator<Item = &'a Accepted>,
    now: &[(String, String)],
) -> Option<String> {
    let all = accepted
        .into_iter()
        .flat_map(|one| other_versions(one, now));
    let told: BTreeSet<String> = all.collect();
    let told: Vec<String> = told.into_iter().collect();
    (!told.is_empty()).then(|| format!("accepted of other versions: {}", told.join(", ")))
}

#[cfg(test)]
mod tests {
    use super::{contradictions, versions_sentence};
    use crate::gate::Accepted;

    fn pairs(of: &[(&str, &str)]) -> Vec<(String, String)> {
        of.iter()
            .map(|(a, b)| ((*a).to_owned(), (*b).to_owned()))
            .collect()
    }

    fn accepted() -> Accepted {
        Accepted {
            scene: "slide".to_owned(),
            versions: pairs(&[
                ("carom", "0.1.0"),
                ("rapier-f64", "0.36.1"),
                ("commit", "0a"),
            ]),
            bits: pairs(&[("exact", "00"), ("stepper", "11")]),
            ..Accepted::default()
        }
    }

    #[test]
    fn a_file_is_of_its_scene_and_has_the_bits_of_every_run_and_of_no_other() {
        let runs = pairs(&[("exact", "00"), ("stepper", "22")]);
        // other digests only inform
        assert_eq!(contradictions(&accepted(), "slide", &runs), [""; 0]);
        for (scene, runs, words) in [
            (
                "rack",
                &runs[..],
                "the file of rack says that it is of slide",
            ),
            (
                "slide",
                &runs[..1],
                "has the bits of stepper, of which there is no run",
            ),
            (
                "slide",
                &pairs(&[("exact", ""), ("stepper", ""), ("rapier-f64", "")]),
                "lacks the bits of rapier-f64",
            ),
        ] {
            let found = contradictions(&accepted(), scene, runs);
            assert!(found.len() == 1 && found[0].contains(words), "{found:?}");
        }
    }

    #[test]
    fn other_versions_are_told_once_and_a_commit_is_none() {
        let one = accepted();
        let same = pairs(&[
            ("carom", "0.1.0"),
            ("rapier-f64", "0.36.1"),
            ("commit", "0b"),
        ]);
        assert_eq!(versions_sentence([&one, &one], &same), None);
        let now = pairs(&[("carom", "0.2.0"), ("exact", "carom 0.2.0")]);
        assert_eq!(
            versions_sentence([&one, &one], &now).unwrap_or_default(),
            "accepted of other versions: carom was 0.1.0 and is 0.2.0, exact is carom 0.2.0 and was not told, \
             rapier-f64 was 0.36.1 and is not there"
        );
    }
}

//! Engines speak for themselves: outside `engine/` and `oracle/` no id, key, value or counter of one is used as such.
//!
//! The words are those of the roster, so that a new engine is guarded without being listed here. A literal of the sources is an offence
//! when it is such a word, a list of engines, or text that sets or looks for a key. Comments and help are prose, and unit tests
//! are tests.

use crate::support::roster;
use carom::engine::{Limits, Setting, prepare};
use carom::scene::catalogue;
use carom::trace::Record;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Rooms in which engines are known by name.
const ROOMS: [(&str, &str); 5] = [
    ("engine/", "where they live"),
    ("oracle/", "who is asked for the right answer"),
    ("trace/counter.rs", "where counters get their names"),
    (
        "study/claims.rs",
        "the audit of a report is about one model",
    ),
    ("scene/", "the scene format, whose `try` names engines"),
];

/// Literals that are something else than a word of an engine, with the reason.
const OTHERS: &[(&str, &str, &str)] = &[
    ("report/json.rs", "events", "a key of a replay in JSON"),
    ("report/replay.rs", "events", "a key of a replay's data"),
    (
        "report/replay.rs",
        "length_unit",
        "a key of a replay's data",
    ),
    ("page/check.rs", "f32", "a column of tolerances"),
    ("page/check.rs", "f64", "a column of tolerances"),
    (
        "study/check/random.rs",
        "events",
        "a count of random scenes",
    ),
    (
        "study/check/written.rs",
        "events",
        "a finding about two runs",
    ),
    ("page/compare/parting.rs", "contact", "a mark in a picture"),
    (
        "study/cost/verdict.rs",
        "converging",
        "a verdict of a ladder",
    ),
    ("study/mutation/mutate.rs", "cue", "the id of a ball"),
    ("page/effects/tables.rs", "all", "every ball, in a table"),
    ("page/effects/tables.rs", "events", "a column of a table"),
    ("page/horizon.rs", "events", "the id of a table"),
    ("page/random.rs", "events", "a column of a table"),
    ("page/stability/mod.rs", "steps", "the id of a table"),
    ("page/stability/tables.rs", "steps", "the id of a table"),
    ("trace/files/mod.rs", "exchanges", "a column of events.csv"),
    ("web/form/change.rs", "off", "what a browser sends of a box"),
];

/// What engines call themselves, their knobs, values and counters.
#[derive(Default)]
struct Words {
    ids: BTreeSet<String>,
    keys: BTreeSet<String>,
    values: BTreeSet<String>,
    counters: BTreeSet<String>,
}

impl Words {
    fn of_the_roster() -> Self {
        let mut words = Words::default();
        let scene = catalogue::scene("three-ball").unwrap();
        for engine in roster() {
            words.ids.insert(engine.id().to_owned());
            let mut settings: Vec<Setting> = Vec::new();
            settings.extend(engine.presets().into_iter().map(|preset| preset.setting));
            settings.extend(engine.ladders().into_iter().flat_map(|(_, all)| all));
            for preset in engine.presets() {
                let ablations = engine.ablations(&scene, &preset.setting).into_iter();
                settings.extend(ablations.map(|(_, setting)| setting));
            }
            let knobs = engine.knobs().into_iter();
            let mut values: Vec<String> = settings
                .into_iter()
                .flat_map(|setting| setting.values.into_values())
                .collect();
            for knob in knobs {
                words.keys.insert(knob.key);
                values.extend(knob.choices);
            }
            let is_word =
                |value: &String| value.parse::<f64>().is_err() && value.parse::<bool>().is_err();
            words.values.extend(values.into_iter().filter(is_word));
            let run = prepare(engine.as_ref(), &scene, &Setting::default()).unwrap();
            let trace = run.simulate(Record::Final, &Limits::NONE);
            words.counters.extend(trace.counters.into_keys());
        }
        words
    }

    /// What kind of word a literal is, if it is one.
    fn kind(&self, literal: &str) -> Option<&'static str> {
        let is_id = |word: &str| self.ids.contains(word);
        let engine = |item: &str| is_id(item.split([':', ' ']).next().unwrap_or_default());
        if is_id(literal) || (literal.contains([',', ':']) && literal.split(',').all(engine)) {
            return Some("an id");
        }
        if self.keys.contains(literal) {
            return Some("a key");
        }
        if self.values.contains(literal) {
            return Some("a value");
        }
        if self.counters.contains(literal) {
            return Some("a counter");
        }
        // a key as it is set: at the start, or after what cannot be part of a name
        let sets = |key: &String| {
            let wanted = format!("{key}=");
            literal.match_indices(&wanted).any(|(at, _)| {
                let before = literal[..at].chars().next_back();
                before.is_none_or(|c| matches!(c, ' ' | ':' | '`' | ','))
            })
        };
        self.keys.iter().any(sets).then_some("a key that is set")
    }
}

/// The string literals of a source, comments and unit tests left out.
fn literals(text: &str) -> Vec<String> {
    let code = text.split("#[cfg(test)]\n").next().unwrap_or_default();
    let mut found = Vec::new();
    let mut rest = code;
    while let Some(c) = rest.chars().next() {
        if rest.starts_with("//") {
            rest = rest.split_once('\n').map_or("", |(_, after)| after);
        } else if rest.starts_with("r\"") || rest.starts_with("r#") {
            let hashes = rest[1..].chars().take_while(|c| *c == '#').count();
            let end = format!("\"{}", "#".repeat(hashes));
            let body = &rest[(2 + hashes).min(rest.len())..];
            let (literal, after) = body.split_once(&end).unwrap_or((body, ""));
            found.push(literal.to_owned());
            rest = after;
        } else if rest.starts_with("'\"'") || rest.starts_with("'\\\"'") {
            rest = &rest[3..];
        } else if c == '"' {
            let mut literal = String::new();
            let mut letters = rest[1..].char_indices();
            let mut end = rest.len();
            while let Some((at, c)) = letters.next() {
                match c {
                    '\\' => literal.extend(letters.next().map(|(_, c)| c)),
                    '"' => {
                        end = at + 2;
                        break;
                    }
                    c => literal.push(c),
                }
            }
            found.push(literal);
            rest = &rest[end.min(rest.len())..];
        } else {
            rest = &rest[c.len_utf8()..];
        }
    }
    found
}

/// Every offence in the given sources, one sentence each, and the exemptions that were needed.
fn offences(sources: &BTreeMap<String, String>, words: &Words) -> (Vec<String>, BTreeSet<usize>) {
    let (mut found, mut needed) = (Vec::new(), BTreeSet::new());
    for (file, text) in sources {
        if ROOMS.iter().any(|(room, _)| file.starts_with(room)) {
            continue;
        }
        for literal in literals(text) {
            let Some(kind) = words.kind(&literal) else {
                continue;
            };
            let is_it =
                |(room, other, _): &(&str, &str, &str)| file.starts_with(room) && *other == literal;
            match OTHERS.iter().position(is_it) {
                Some(known) => drop(needed.insert(known)),
                None => found.push(format!("{file}: `{literal}` is {kind} of an engine")),
            }
        }
    }
    (found, needed)
}

fn sources() -> BTreeMap<String, String> {
    fn walk(root: &Path, folder: &Path, found: &mut BTreeMap<String, String>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                walk(root, &path, found);
            } else if path.extension().is_some_and(|e| e == "rs") {
                let name = path
                    .strip_prefix(root)
                    .unwrap()
                    .to_str()
                    .unwrap()
                    .to_owned();
                found.insert(name, std::fs::read_to_string(&path).unwrap());
            }
        }
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut found = BTreeMap::new();
    walk(&root, &root, &mut found);
    found
}

#[test]
fn no_word_of_an_engine_is_used_outside_the_rooms_that_know_them() {
    let words = Words::of_the_roster();
    assert!(words.ids.len() >= 4 && words.keys.len() > 20 && words.counters.len() > 10);
    let sources = sources();
    assert!(sources.len() > 200, "{} files", sources.len());
    let (found, needed) = offences(&sources, &words);
    assert!(
        found.is_empty(),
        "{} offences:\n{}",
        found.len(),
        found.join("\n")
    );
    for (k, (room, literal, why)) in OTHERS.iter().enumerate() {
        assert!(
            !why.is_empty() && needed.contains(&k),
            "{room} {literal}: nothing needs that"
        );
    }
}

#[test]
fn planted_words_of_engines_are_seen() {
    let words = Words::of_the_roster();
    let plants = [
        (
            "study/cost/mod.rs",
            "if column.engine.id() == \"exact\" {",
            "an id",
        ),
        (
            "study/a.rs",
            "let list = \"exact,stepper:dt=1e-3\";",
            "an id",
        ),
        ("compare/a.rs", "roster.find(\"rapier-f64\")", "an id"),
        ("web/form/engines.rs", "knob.key == \"dt\"", "a key"),
        (
            "web/form/engines.rs",
            "message.starts_with(\"`dt=\")",
            "a key that is set",
        ),
        (
            "cli/a.rs",
            "setting.with(KEY, \"approaching-only\")",
            "a value",
        ),
        ("cli/a.rs", "let stock = \"stock\";", "a value"),
        (
            "study/b.rs",
            "trace.counters.get(\"root_calls\")",
            "a counter",
        ),
        (
            "study/b.rs",
            "trace.counters[r#\"longest_overlap_steps\"#]",
            "a counter",
        ),
    ];
    for (file, text, wanted) in plants {
        let planted = BTreeMap::from([(file.to_owned(), text.to_owned())]);
        let (found, _) = offences(&planted, &words);
        let seen = matches!(&found[..], [one, ..] if one.contains(&format!("is {wanted} of")));
        assert!(seen, "{file}: {text}: {found:?}");
    }
    let innocent = [
        (
            "study/a.rs",
            "// column.engine.id() == \"exact\"\nformat!(\"the exact engine\")",
        ),
        (
            "study/a.rs",
            "f();\n#[cfg(test)]\nmod tests { const A: &str = \"exact\"; }",
        ),
        ("engine/new/mod.rs", "const ID: &str = \"stepper\";"),
        ("trace/counter.rs", "where counters get their names"),
        ("study/claims.rs", "self.run(\"stepper\")"),
        ("web/a.rs", "let c = '\"'; let d = \"width=1\";"),
    ];
    for (file, text) in innocent {
        let planted = BTreeMap::from([(file.to_owned(), text.to_owned())]);
        assert_eq!(offences(&planted, &words).0, [""; 0], "{file}: {text}");
    }
}

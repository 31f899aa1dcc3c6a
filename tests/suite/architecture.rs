//! The shape of the house: one direction of imports, small files, no unfinished work.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A module may import from itself and from modules listed before it.
const ORDER: [&str; 18] = [
    "carried", "math", "physics", "scene", "trace", "engine", "finding", "compare", "oracle",
    "law", "words", "study", "page", "gate", "report", "web", "cli", "main",
];

/// Folders of `engine/` that are no engine: what several engines are made of.
const NO_ENGINES: [&str; 1] = ["stepped"];

/// Names that only one room may use, with the rooms that may.
const ONLY_IN: [(&str, &[&str]); 10] = [
    ("rayon::", &["study/matrix.rs"]),
    ("Instant::", &["study/matrix.rs", "cli"]),
    ("SystemTime", &["cli"]),
    ("std::thread", &["study/matrix.rs", "cli"]),
    ("std::env::", &["cli"]),
    ("std::fs::", &["cli"]),
    ("std::net", &["cli"]),
    ("rapier3d", &["engine/rapier"]),
    ("engine::exact", &["engine", "oracle"]),
    ("println!", &["cli"]),
];

/// What runs an engine, or asks whether to go on running one: nothing of it is on a page.
const RUNS: [&str; 6] = [
    "Limits",
    "Watch",
    "matrix::",
    "Runner",
    ".prepare(",
    ".simulate(",
];

/// What a study would write a document with.
const WRITES: [&str; 4] = ["Document", "Block", "Table {", "crate::page"];

/// Studies that write tables or figures themselves, so far.
const STILL_WRITE: [&str; 1] = ["study/curves/"];

/// The largest part of the sources that the studies, or their pages, may be.
const SHARE: f64 = 0.18;

/// Every Rust file below a folder, by its path relative to that folder.
fn sources(folder: &str) -> BTreeMap<String, String> {
    fn walk(root: &Path, folder: &Path, found: &mut BTreeMap<String, String>) {
        let mut entries: Vec<PathBuf> = std::fs::read_dir(folder)
            .unwrap()
            .map(|e| e.unwrap().path())
            .collect();
        entries.sort();
        for path in entries {
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
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut found = BTreeMap::new();
    walk(&root, &root, &mut found);
    assert!(!found.is_empty(), "no Rust file in {folder}");
    found
}

/// The code of a file: comments, and what follows its unit tests, taken away.
fn code(text: &str) -> String {
    let text = text
        .split("#[cfg(test)]\nmod tests")
        .next()
        .unwrap_or_default();
    let lines = text.lines().map(|line| {
        if line.trim_start().starts_with("//") {
            ""
        } else {
            line
        }
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// Every folder of `engine/` that is an engine, whoever puts it there.
fn engines() -> Vec<String> {
    let folders = sources("src/engine").into_keys().filter_map(|file| {
        let (folder, _) = file.split_once('/')?;
        Some(folder.to_owned())
    });
    let mut engines: Vec<String> = folders
        .filter(|folder| !NO_ENGINES.contains(&folder.as_str()))
        .collect();
    engines.dedup();
    assert!(engines.len() >= 3, "{engines:?}");
    engines
}

fn rank(module: &str) -> Option<usize> {
    ORDER.iter().position(|&m| m == module)
}

/// Every rule that the given sources break, one sentence each.
fn violations(sources: &BTreeMap<String, String>) -> Vec<String> {
    let mut found = Vec::new();
    let engines = engines();
    for (file, text) in sources {
        let module = file.split(['/', '.']).next().unwrap();
        if module == "lib" {
            continue;
        }
        let Some(own) = rank(module) else {
            found.push(format!(
                "{file}: the module {module} has no place in the order"
            ));
            continue;
        };
        let code = code(text);
        for root in ["crate::", "carom::"] {
            for piece in code.split(root).skip(1) {
                found.extend(
                    imported(piece)
                        .into_iter()
                        .filter_map(|name| match rank(&name) {
                            Some(theirs) if theirs > own => Some(format!(
                                "{file}: imports {name}, which is listed after {module}"
                            )),
                            _ => None,
                        }),
                );
            }
        }
        for engine in &engines {
            let sibling = module == "engine"
                && !file.starts_with(&format!("engine/{engine}/"))
                && file != "engine/mod.rs";
            let mentioned = ["super::", "engine::"]
                .iter()
                .any(|p| code.contains(&format!("{p}{engine}::")));
            if sibling && file != "engine/mod.rs" && mentioned {
                found.push(format!("{file}: an engine knows the engine {engine}"));
            }
        }
        for (name, rooms) in ONLY_IN {
            if code.contains(name) && !rooms.iter().any(|room| file.starts_with(room)) {
                found.push(format!("{file}: {name} belongs in {}", rooms.join(" or ")));
            }
        }
    }
    found
}

/// Pages that run something, and studies that write documents, one sentence each.
fn strays(sources: &BTreeMap<String, String>) -> Vec<String> {
    let mut found = Vec::new();
    for (file, text) in sources {
        let code = code(text);
        let words: &[&str] = match file.split(['/', '.']).next() {
            Some("page") => &RUNS,
            Some("study") if !STILL_WRITE.iter().any(|known| file.starts_with(known)) => &WRITES,
            _ => continue,
        };
        let strays = words.iter().filter(|word| code.contains(**word));
        found.extend(strays.map(|word| format!("{file}: {word}")));
    }
    found
}

#[test]
fn no_study_writes_a_document_and_no_page_runs_an_engine() {
    let sources = sources("src");
    assert_eq!(strays(&sources), [""; 0]);
    for (file, text) in [
        ("study/effects/mod.rs", "fn f() -> Document {}"),
        ("page/effects/mod.rs", "fn f(watch: Watch<'_>) {}"),
        ("page/check.rs", "let run = engine.prepare(&scene)?;"),
    ] {
        let planted = BTreeMap::from([(file.to_owned(), text.to_owned())]);
        assert_eq!(strays(&planted).len(), 1, "{file}: {text}");
    }
    let lines = |room: &str| -> usize {
        let own = sources.iter().filter(|(file, _)| file.starts_with(room));
        own.map(|(_, text)| text.lines().count()).sum()
    };
    let all = lines("") as f64;
    for room in ["study/", "page/"] {
        let share = lines(room) as f64 / all;
        assert!(share > 0.01 && share < SHARE, "{room}: {share}");
    }
}

/// Module names right after `crate::`, also of a group: `{math::x, trace::y}`.
fn imported(piece: &str) -> Vec<String> {
    let word = |s: &str| {
        s.chars()
            .take_while(|c| c.is_alphanumeric() || *c == '_')
            .collect::<String>()
    };
    let Some(group) = piece.strip_prefix('{') else {
        return vec![word(piece)];
    };
    let mut depth = 0;
    let mut names = vec![word(group.trim_start())];
    for (at, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => break,
            '}' => depth -= 1,
            ',' if depth == 0 => names.push(word(group[at + 1..].trim_start())),
            _ => {}
        }
    }
    names
}

#[test]
fn imports_point_one_way_and_each_tool_has_one_room() {
    let found = violations(&sources("src"));
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn planted_violations_are_seen() {
    for (file, text, wanted) in [
        (
            "math/mod.rs",
            "use crate::physics::State;",
            "listed after math",
        ),
        (
            "trace/path.rs",
            "use crate::{math::Vec3, engine::{Run, Limits}};",
            "imports engine",
        ),
        (
            "compare/order.rs",
            "fn f() { crate::study::run() }",
            "imports study",
        ),
        (
            "engine/exact/solve.rs",
            "use super::super::stepper::Settings;",
            "knows the engine stepper",
        ),
        (
            "engine/stepper/mod.rs",
            "use crate::engine::rapier::World;",
            "knows the engine rapier",
        ),
        (
            "engine/stepped/run.rs",
            "use crate::engine::stepper::Settings;",
            "knows the engine stepper",
        ),
        (
            "study/compare.rs",
            "use rayon::prelude::*;",
            "belongs in study/matrix.rs",
        ),
        (
            "engine/exact/mod.rs",
            "let t = std::time::Instant::now();",
            "belongs in",
        ),
        ("report/html.rs", "std::fs::write(a, b);", "belongs in cli"),
        ("web/mod.rs", "use std::net::TcpStream;", "belongs in cli"),
        (
            "compare/mod.rs",
            "use rapier3d_f64::prelude::*;",
            "belongs in engine/rapier",
        ),
        (
            "oracle/mod.rs",
            "use crate::study::Column;",
            "listed after oracle",
        ),
        (
            "study/cost/mod.rs",
            "use crate::engine::exact::Precision;",
            "belongs in engine or oracle",
        ),
        ("helpers/mod.rs", "", "no place in the order"),
    ] {
        let planted = BTreeMap::from([(file.to_owned(), text.to_owned())]);
        let found = violations(&planted);
        assert!(
            found.iter().any(|v| v.contains(wanted)),
            "{file}: {text}: found {found:?}"
        );
    }
    for (file, text) in [
        (
            "compare/mod.rs",
            "// crate::study\nuse crate::{trace::Trace, math::Vec3};",
        ),
        (
            "engine/stepper/run.rs",
            "use crate::engine::stepped::Clock;",
        ),
    ] {
        let innocent = BTreeMap::from([(file.to_owned(), text.to_owned())]);
        assert_eq!(violations(&innocent), [""; 0], "{file}");
    }
}

#[test]
fn files_are_small_opened_by_a_comment_and_finished() {
    // written in two halves so that this file does not contain the words itself
    let unfinished: Vec<String> = [
        ("TO", "DO"),
        ("FIX", "ME"),
        ("to", "do!"),
        ("unimpl", "emented!"),
        ("#[ig", "nore"),
    ]
    .iter()
    .map(|(a, b)| format!("{a}{b}"))
    .collect();
    for folder in ["src", "tests", "benches"] {
        for (file, text) in sources(folder) {
            let lines = text.lines().count();
            assert!(lines <= 700, "{folder}/{file} has {lines} lines");
            assert!(
                text.starts_with("//!"),
                "{folder}/{file} does not say what lives in it"
            );
            for word in &unfinished {
                assert!(
                    !text.contains(word.as_str()),
                    "{folder}/{file} contains {word}"
                );
            }
        }
    }
}

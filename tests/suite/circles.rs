//! No files import each other in a circle: of two files one can be read without the other.
//!
//! What a folder's `mod.rs` defines belongs to its room, so that a file may import it from there although `mod.rs` uses the file; what
//! `mod.rs` only passes on from another file is an import of that file.

use crate::source::{Token, files, tokens};
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// Files by what each imports, besides what its own room defines.
type Imports = BTreeMap<String, BTreeSet<String>>;

/// The path of a file's module: `["study", "check", "cell"]`.
fn module(file: &str) -> Vec<String> {
    let path = file.trim_end_matches(".rs");
    let path = path.strip_suffix("/mod").unwrap_or(path);
    if path == "lib" {
        return Vec::new();
    }
    path.split('/').map(str::to_owned).collect()
}

/// Every path that the tokens name, in `use` or in passing, as its words.
fn paths(tokens: &[Token]) -> Vec<Vec<String>> {
    let mut found = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        let text = tokens[at].text.as_str();
        let within = at > 0 && tokens[at - 1].text == "::";
        if text == "use" {
            at += 1;
            tree(tokens, &mut at, &[], &mut found);
        } else if ["crate", "carom", "super", "self"].contains(&text) && !within {
            tree(tokens, &mut at, &[], &mut found);
        } else {
            at += 1;
        }
    }
    found
}

/// Reads `a::b`, `a::{b, c::d}`, `a as b` from `at` on.
fn tree(tokens: &[Token], at: &mut usize, before: &[String], found: &mut Vec<Vec<String>>) {
    let text = |at: usize| tokens.get(at).map_or("", |token| token.text.as_str());
    let mut path = before.to_vec();
    loop {
        match text(*at) {
            "{" => {
                *at += 1;
                while !["}", ""].contains(&text(*at)) {
                    tree(tokens, at, &path, found);
                    if text(*at) == "," {
                        *at += 1;
                    }
                }
                *at += 1;
                return;
            }
            word if word.starts_with(|c: char| c.is_alphabetic() || c == '_') || word == "*" => {
                path.push(word.to_owned());
                *at += 1;
            }
            // not a path: the caller goes on behind it
            _ => {
                *at += 1;
                return;
            }
        }
        if text(*at) != "::" {
            break;
        }
        *at += 1;
    }
    if text(*at) == "as" {
        *at += 2;
    }
    found.push(path);
}

/// The source as modules that know what each passes on.
struct House {
    files: BTreeMap<Vec<String>, String>,
    named: BTreeMap<String, Vec<Vec<String>>>,
}

impl House {
    fn new(sources: &BTreeMap<String, String>) -> Self {
        let own = sources
            .iter()
            .filter(|(file, _)| !file.ends_with("/tests.rs"));
        let named = own.map(|(file, text)| (file.clone(), paths(&tokens(text))));
        House {
            files: sources
                .keys()
                .map(|file| (module(file), file.clone()))
                .collect(),
            named: named.collect(),
        }
    }

    /// The path from the root of what `file` calls by `path`; `None` for what is no part of the house.
    fn absolute(&self, file: &str, path: &[String]) -> Option<Vec<String>> {
        let own = module(file);
        let mut base = own.clone();
        let mut rest = path;
        match path.first()?.as_str() {
            "crate" | "carom" => return Some(path[1..].to_vec()),
            "super" | "self" => {
                while let Some((word, more)) = rest.split_first() {
                    match word.as_str() {
                        "super" => {
                            base.pop();
                        }
                        "self" => {}
                        _ => break,
                    }
                    rest = more;
                }
            }
            child => {
                base.push(child.to_owned());
                if !self.files.contains_key(&base) {
                    return None;
                }
                base = own;
            }
        }
        base.extend(rest.iter().cloned());
        Some(base)
    }

    /// The file that defines what `file` calls by `path`, through at most `depth` that pass it on.
    fn definer(&self, file: &str, path: &[String], depth: usize) -> Option<&String> {
        let path = self.absolute(file, path)?;
        let prefix = |n: &usize| self.files.contains_key(&path[..*n]);
        let known = (1..=path.len()).rev().find(prefix)?;
        let target = &self.files[&path[..known]];
        let passed_on = path.get(known).and_then(|name| {
            let mut named = self.named.get(target)?.iter();
            let own = named.find(|named| named.last() == Some(name) && named.len() > 1)?;
            depth
                .checked_sub(1)
                .and_then(|depth| self.definer(target, own, depth))
        });
        Some(passed_on.unwrap_or(target))
    }

    fn imports(&self) -> Imports {
        let of = |(file, paths): (&String, &Vec<Vec<String>>)| {
            let own = module(file);
            let targets = paths.iter().filter_map(|path| self.definer(file, path, 8));
            let others = targets.filter(|target| {
                let theirs = module(target);
                // its own room: a `mod.rs` above it
                *target != file && !(own.starts_with(&theirs) && theirs.len() < own.len())
            });
            (file.clone(), others.cloned().collect())
        };
        self.named.iter().map(of).collect()
    }
}

/// The shortest way from a file back to itself, without either file of a pair that is left out importing the other.
fn circle(imports: &Imports, start: &str, left_out: &[[&str; 2]]) -> Option<Vec<String>> {
    let mut from: BTreeMap<&str, &str> = BTreeMap::new();
    let mut queue = VecDeque::from([start]);
    while let Some(file) = queue.pop_front() {
        for next in imports.get(file).into_iter().flatten() {
            let pair = [file, next.as_str()];
            if left_out
                .iter()
                .any(|out| pair.iter().all(|file| out.contains(file)))
            {
                continue;
            }
            if next == start {
                let mut way = vec![start.to_owned(), file.to_owned()];
                let mut at = file;
                while let Some(before) = from.get(at) {
                    at = before;
                    way.push(at.to_owned());
                }
                way.reverse();
                way.dedup();
                return Some(way);
            }
            if next != start && !from.contains_key(next.as_str()) {
                from.insert(next, file);
                queue.push_back(next);
            }
        }
    }
    None
}

/// Every circle of files, each once, as a way from a file back to itself.
fn circles(sources: &BTreeMap<String, String>, left_out: &[[&str; 2]]) -> Vec<String> {
    let imports = House::new(sources).imports();
    let mut seen: BTreeSet<BTreeSet<String>> = BTreeSet::new();
    let mut found = Vec::new();
    for file in imports.keys() {
        if let Some(way) = circle(&imports, file, left_out)
            && seen.insert(way.iter().cloned().collect())
        {
            found.push(way.join(" -> "));
        }
    }
    found
}

#[test]
fn no_files_import_each_other_in_a_circle() {
    let sources = files("src");
    let imports = House::new(&sources).imports();
    let count: usize = imports.values().map(BTreeSet::len).sum();
    assert!(count > 1500, "only {count} imports were read");
    let found = circles(&sources, &[]);
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn planted_circles_are_seen() {
    let house = |files: &[(&str, &str)]| -> BTreeMap<String, String> {
        let owned = files
            .iter()
            .map(|(f, t)| ((*f).to_owned(), (*t).to_owned()));
        owned.collect()
    };
    let doors = [
        ("a/mod.rs", "mod x; mod y; pub use x::X; pub struct A;"),
        ("b/mod.rs", "pub mod z; pub use z::{Z, W as V};"),
    ];
    for (files, wanted) in [
        (
            vec![
                ("a/x.rs", "use super::y::Y;"),
                ("a/y.rs", "use super::x::X;"),
            ],
            "a/x.rs -> a/y.rs -> a/x.rs",
        ),
        // by what `mod.rs` passes on, from a group, and in passing
        (
            vec![
                ("a/x.rs", "use crate::{b::{z::Z}, math};"),
                ("b/z.rs", "fn f() { let x = crate::a::X; }"),
            ],
            "a/x.rs -> b/z.rs -> a/x.rs",
        ),
        (
            vec![
                ("a/x.rs", "fn f() -> super::y::Y { }"),
                ("a/y.rs", "use crate::b::Z;"),
                ("b/z.rs", "use crate::a::{self, X};"),
            ],
            "a/x.rs -> a/y.rs -> b/z.rs -> a/x.rs",
        ),
        // rooms that import each other
        (
            vec![
                ("a/x.rs", "use crate::b::Z;"),
                ("b/z.rs", "use crate::a::A;"),
            ],
            "a/mod.rs -> a/x.rs -> b/z.rs -> a/mod.rs",
        ),
    ] {
        let all: Vec<(&str, &str)> = doors.into_iter().chain(files).collect();
        let found = circles(&house(&all), &[]);
        assert!(found.iter().any(|way| way == wanted), "{all:?}: {found:?}");
    }
    // what its room defines, a comment, a test, another's name
    let innocent = [
        ("a/mod.rs", "mod x; mod y; pub use x::X; pub struct A;"),
        ("a/x.rs", "use super::A; use std::fmt;"),
        (
            "a/y.rs",
            "use super::{A, X}; // super::z\n#[cfg(test)]\nmod tests { use crate::a::y; }",
        ),
        ("b/mod.rs", "use crate::a::A; use self::z::Z; mod z;"),
        ("b/z.rs", "// use crate::b::w\nuse crate::a::X;"),
    ];
    assert_eq!(circles(&house(&innocent), &[]), Vec::<String>::new());
    let [first, second] = [
        ("a/x.rs", "use super::y::Y;"),
        ("a/y.rs", "use super::x::X;"),
    ];
    let pair = house(&[doors[0], first, second]);
    assert_eq!(
        circles(&pair, &[["a/x.rs", "a/y.rs"]]),
        Vec::<String>::new()
    );
}

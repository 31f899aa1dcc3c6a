//! Instruction counts: how they are obtained, and what they are held against.
//!
//! Counted is what the bench's own executable does: the C library chooses its code for copies and allocation by the processor. Two
//! builds of one source by one compiler for one target then execute the same instructions; a hash table with random keys, or
//! an address that is aligned by chance, moves a count by parts of a thousand. The limit is above that, and so small that what
//! passes needs no explanation. On another compiler or target the counts only advise.

#![allow(missing_docs, clippy::expect_used, clippy::print_stdout)]

use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio, exit};
use std::{env, fs};

/// A count may differ by so much from the committed one, relative, in both directions: what has become faster needs new counts
/// too, or it could become slower again unseen.
const LIMIT: f64 = 0.01;

/// Version of gungraun, and of its runner.
const VERSION: &str = "0.20.0";

/// Set in the process in which gungraun runs.
const INSIDE: &str = "CAROM_COUNTS_INSTRUCTIONS";

/// Instructions by case.
type Counts = BTreeMap<String, u64>;

/// True in the processes in which gungraun does its work.
pub fn inside() -> bool {
    env::var_os(INSIDE).is_some() || env::args().any(|argument| argument == "--gungraun-run")
}

/// Counts, prints, and does what the arguments say: `--hold` fails where a count has moved, `--accept` writes the new ones.
pub fn hold() {
    let says = |word: &str| env::args().any(|argument| argument == word);
    if says("--test") {
        println!("instruction counts: taken by `cargo bench` only");
        return;
    }
    let missing: Vec<&str> = ["valgrind", "gungraun-runner"]
        .into_iter()
        .filter(|program| !search_path().iter().any(|dir| dir.join(program).is_file()))
        .collect();
    if !missing.is_empty() {
        println!(
            "instruction counts: SKIPPED, no {} (runner version {VERSION}); .ci/instructions installs it",
            missing.join(" and no ")
        );
        exit(i32::from(says("--hold") || says("--accept")));
    }
    let counted = count();
    let compiler = compiler();
    let (known_for, committed) = committed();
    let binding = known_for == compiler;
    let moved = print(&counted, &committed);
    println!("counted on {compiler}, committed from {known_for}");
    if says("--accept") {
        fs::write(file(), written(&compiler, &counted)).expect("a file that can be written");
        println!("accepted: {}", file().display());
    } else if !moved.is_empty() && !binding {
        println!("another compiler or target: the counts only advise");
    } else if !moved.is_empty() {
        println!(
            "{} moved by more than {} %: find out why, then `.ci/instructions --accept`",
            moved.join(", "),
            100.0 * LIMIT
        );
        exit(i32::from(says("--hold")));
    }
}

/// The table, and the ratios that follow from it. Answers the cases that moved.
fn print(counted: &Counts, committed: &Counts) -> Vec<String> {
    println!(
        "{:<24} {:>14} {:>14} {:>9}",
        "instructions", "counted", "committed", "change"
    );
    let mut moved = Vec::new();
    let mut cases: Vec<&String> = counted.keys().chain(committed.keys()).collect();
    cases.sort();
    cases.dedup();
    for case in cases {
        let (now, before) = (counted.get(case), committed.get(case));
        let change = now.zip(before).map(|(n, b)| *n as f64 / *b as f64 - 1.0);
        let number = |count: Option<&u64>| count.map_or(String::new(), u64::to_string);
        let percent = change.map_or(String::new(), |c| format!("{:+.3} %", 100.0 * c));
        println!(
            "{case:<24} {:>14} {:>14} {percent:>9}",
            number(now),
            number(before)
        );
        if change.is_none_or(|change| change.abs() > LIMIT) {
            moved.push(case.clone());
        }
    }
    let of = |case: &str| counted.get(case).map(|count| *count as f64);
    if let (Some(engine), Some(alone)) = (of("rapier_f64_16_balls"), of("rapier_alone_16_balls")) {
        println!(
            "rapier-f64 / rapier alone {:8.4}   (demanded: at most 1.02)",
            engine / alone
        );
    }
    moved
}

/// Runs gungraun in a process of its own and reads what it counted.
fn count() -> Counts {
    let path = env::join_paths(search_path()).expect("folders of a search path");
    let own = env::current_exe().expect("a path to this program");
    let output = Command::new(own)
        .arg("--bench")
        .env("PATH", path)
        .env(INSIDE, "1")
        .env("GUNGRAUN_OUTPUT_FORMAT", "json")
        .stdout(Stdio::piped())
        .stderr(Stdio::inherit())
        .output()
        .expect("this program again");
    let text = String::from_utf8_lossy(&output.stdout);
    if !output.status.success() {
        println!("{text}\ngungraun failed: {}", output.status);
        exit(1);
    }
    let lines = text.lines().filter(|line| line.starts_with('{'));
    let counts: Counts = lines
        .map(|line| {
            let case: Value = serde_json::from_str(line).expect("a summary of gungraun");
            let word = |key: &str| case[key].as_str().unwrap_or_default().to_owned();
            let (function, id) = (word("function_name"), word("id"));
            let profile = format!("{}/callgrind.{function}.{id}.out", word("output_dir"));
            let profile = fs::read_to_string(root().join(profile)).expect("callgrind's file");
            let count = own_instructions(&profile);
            assert!(count > 0, "nothing was counted for {id}");
            (id, count)
        })
        .collect();
    assert!(!counts.is_empty(), "nothing was counted: {text}");
    counts
}

/// Instructions that a profile of callgrind gives to the bench itself and not to a library.
fn own_instructions(profile: &str) -> u64 {
    let (mut own, mut sum, mut inclusive) = (false, 0, false);
    for line in profile.lines() {
        // gungraun has callgrind write names in full
        if let Some(object) = line.strip_prefix("ob=") {
            own = object.contains("/deps/instructions-");
        } else if line.starts_with("calls=") {
            // the next line is what the callee cost
            inclusive = true;
        } else if line.starts_with(|c: char| c.is_ascii_digit() || "+-*".contains(c)) {
            let cost = line.split(' ').nth(1).and_then(|cost| cost.parse().ok());
            if own && !inclusive {
                sum += cost.unwrap_or(0);
            }
            inclusive = false;
        }
    }
    sum
}

/// The compiler's release and the target.
fn compiler() -> String {
    let rustc = env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let version = Command::new(rustc).arg("-vV").output();
    let text = version.map_or(String::new(), |v| {
        String::from_utf8_lossy(&v.stdout).into_owned()
    });
    let word = |key: &str| {
        let lines = text.lines();
        let mut values = lines.filter_map(|line| line.strip_prefix(key));
        values.next().unwrap_or("unknown").to_owned()
    };
    format!("rustc {} {}", word("release: "), word("host: "))
}

/// The committed counts, and the compiler and target that they are from.
fn committed() -> (String, Counts) {
    let text = fs::read_to_string(file()).unwrap_or_default();
    let compiler = text.lines().find_map(|line| line.strip_prefix("# of "));
    let counts = text.lines().filter_map(|line| {
        let (case, count) = line.split_once('\t')?;
        Some((case.to_owned(), count.parse().ok()?))
    });
    (compiler.unwrap_or("nothing").to_owned(), counts.collect())
}

fn written(compiler: &str, counted: &Counts) -> String {
    let mut text = format!(
        "# instructions of each case, written by `.ci/instructions --accept`\n# of {compiler}\n"
    );
    for (case, count) in counted {
        text += &format!("{case}\t{count}\n");
    }
    text
}

/// The package's own folder.
fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn file() -> PathBuf {
    root().join("benches/instructions.tsv")
}

/// The folders in which programs are looked for: first the one into which `.ci/instructions` installs.
fn search_path() -> Vec<PathBuf> {
    let path = env::var_os("PATH").unwrap_or_default();
    let installed = root().join("target/instructions/bin");
    std::iter::once(installed)
        .chain(env::split_paths(&path))
        .collect()
}

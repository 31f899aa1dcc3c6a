//! A source mutant made, built and held against the gate: a copy of the sources below `target/mutants`, and a build folder of its own that
//! compiles again only what the mutant touches.

use crate::table::Mutant;
use carom::study::check::{Level, level};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// What a copy needs to be built: folders and files of the repository.
const COPIED: [&str; 7] = [
    "src",
    "validation",
    "benches",
    "tests",
    "Cargo.toml",
    "Cargo.lock",
    "rust-toolchain.toml",
];

/// A check of a few scenes takes seconds; one that takes longer than this has no end, s.
const PATIENCE: u64 = 300;

/// How many findings of each level, and the first of them in words.
pub type Findings = BTreeMap<Level, (usize, String)>;

/// What caught a mutant.
#[derive(Debug)]
pub enum Caught {
    /// The gate's findings; none where it is green.
    Findings(Findings),
    /// The gate cannot run (exit code 2), and says why.
    Refused(String),
}

impl Caught {
    /// Whether the gate is green.
    pub fn is_nothing(&self) -> bool {
        matches!(self, Caught::Findings(findings) if findings.is_empty())
    }
}

/// The copy of the sources and what is built of it.
pub struct Workshop {
    sources: PathBuf,
    build: PathBuf,
}

impl Workshop {
    /// Brings the copy up to date with the repository at `root`. Files that are the same keep their age, so that they are not built again.
    pub fn new(root: &Path) -> Workshop {
        let place = root.join("target").join("mutants");
        let workshop = Workshop {
            sources: place.join("sources"),
            build: place.join("build"),
        };
        // dependencies that `cargo test` has built are not built again; where they cannot be had, cargo builds them
        let (theirs, ours) = (root.join("target/debug"), workshop.build.join("debug"));
        if !ours.exists() {
            for part in ["deps", "build", ".fingerprint"] {
                let _ = linked(&theirs.join(part), &ours.join(part));
            }
        }
        for name in COPIED {
            mirror(&root.join(name), &workshop.sources.join(name));
        }
        workshop
    }

    /// Builds the program of the copy as it stands, as a test asks for it: with the features of dependencies that `cargo test` has. Errors: what the
    /// compiler said.
    fn build(&self) -> Result<(), String> {
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let built = Command::new(cargo)
            .args(["test", "--locked", "--no-run", "--test", "source_mutants"])
            .arg("--target-dir")
            .arg(&self.build)
            .current_dir(&self.sources)
            .output()
            .map_err(|error| format!("cargo does not start: {error}"))?;
        if built.status.success() {
            return Ok(());
        }
        Err(String::from_utf8_lossy(&built.stderr).into_owned())
    }

    /// Holds scenes as `carom check` does; all of the gate where none is named. Errors: why there is no answer.
    pub fn check(&self, scenes: &[String]) -> Result<Caught, String> {
        self.build()?;
        // what is printed is cut short; the page is whole
        let page = self.build.join("check");
        let _ = fs::remove_dir_all(&page);
        let program = self.build.join("debug").join("carom");
        let said = self.build.join("said");
        let stderr = fs::File::create(&said).map_err(|error| error.to_string())?;
        let mut running = Command::new(program)
            .arg("check")
            .args(scenes)
            .arg("--baseline")
            .arg(self.sources.join("validation").join("baselines"))
            .arg("--out")
            .arg(&page)
            .stdout(Stdio::null())
            .stderr(stderr)
            .spawn()
            .map_err(|error| format!("it does not start: {error}"))?;
        let start = Instant::now();
        let status = loop {
            match running.try_wait().map_err(|error| error.to_string())? {
                Some(status) => break status,
                None if start.elapsed() > Duration::from_secs(PATIENCE) => {
                    running.kill().map_err(|error| error.to_string())?;
                    return Err(format!("it has not ended after {PATIENCE} s"));
                }
                None => std::thread::sleep(Duration::from_millis(20)),
            }
        };
        match status.code() {
            Some(0 | 1) => {
                let text = fs::read_to_string(page.join("report.json"));
                let findings = findings(&text.map_err(|error| error.to_string())?)?;
                if findings.is_empty() == (status.code() == Some(0)) {
                    Ok(Caught::Findings(findings))
                } else {
                    Err(format!("{status}, but {} levels differ", findings.len()))
                }
            }
            Some(2) => {
                let said = fs::read_to_string(said).map_err(|error| error.to_string())?;
                let first = said.lines().find(|line| line.starts_with("error"));
                let why = first.ok_or_else(|| format!("{status}, without a word"))?;
                Ok(Caught::Refused(why.to_owned()))
            }
            _ => Err(format!("it ended with {status}")),
        }
    }

    /// The same with a mutant in the sources. The copy is as it was afterwards.
    pub fn mutated(&self, mutant: &Mutant) -> Result<Caught, String> {
        let file = self.sources.join(&mutant.file);
        let right = fs::read_to_string(&file).map_err(|error| error.to_string())?;
        let wrong = right.replacen(&mutant.old, &mutant.new, 1);
        let write = |text: &str| fs::write(&file, text).map_err(|error| error.to_string());
        write(&wrong)?;
        let caught = self.check(&mutant.scenes);
        write(&right)?;
        caught
    }
}

/// Makes `to` the same as `from`, file by file.
fn mirror(from: &Path, to: &Path) {
    if from.is_dir() {
        fs::create_dir_all(to).unwrap();
        let names = |folder: &Path| -> Vec<_> {
            let entries = fs::read_dir(folder).unwrap();
            entries.map(|entry| entry.unwrap().file_name()).collect()
        };
        let ours = names(from);
        for name in names(to).iter().filter(|name| !ours.contains(name)) {
            let gone = to.join(name);
            let removed = if gone.is_dir() {
                fs::remove_dir_all(&gone)
            } else {
                fs::remove_file(&gone)
            };
            removed.unwrap();
        }
        for name in ours {
            mirror(&from.join(&name), &to.join(&name));
        }
    } else if from.is_file() {
        let ours = fs::read(from).unwrap();
        if fs::read(to).ok().as_ref() != Some(&ours) {
            fs::write(to, ours).unwrap();
        }
    }
}

/// Hard links of all files below `from`, which keep their age. What stands in this crate's own name is left out: it is built anew.
fn linked(from: &Path, to: &Path) -> std::io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        let name = entry.file_name();
        let words = name.to_string_lossy();
        let own = ["carom-", "libcarom-", "suite-", "source_mutants-"];
        if own.iter().any(|own| words.starts_with(own)) {
            continue;
        }
        if entry.file_type()?.is_dir() {
            linked(&entry.path(), &to.join(name))?;
        } else {
            fs::hard_link(entry.path(), to.join(name))?;
        }
    }
    Ok(())
}

/// What the JSON of a check says differs, level by level.
fn findings(json: &str) -> Result<Findings, String> {
    let document: Value = serde_json::from_str(json).map_err(|error| error.to_string())?;
    let mut findings = Findings::new();
    let mut note = |level: Level, words: String| {
        findings.entry(level).or_insert((0, words)).0 += 1;
    };
    // of the blocks only broken promises are a list: `exact in slide: rerun: why`
    let blocks = document["blocks"].as_array().into_iter().flatten();
    for broken in blocks
        .filter_map(|block| block["list"].as_array())
        .flatten()
    {
        note(
            Level::Promise,
            broken.as_str().unwrap_or_default().to_owned(),
        );
    }
    let rows = document["tables"]["changes"]["rows"].as_array();
    for row in rows.into_iter().flatten() {
        let word = |key: &str| row[key].as_str().unwrap_or_default();
        let level = level(word("check"));
        // a broken promise is told above, with its reason
        if level == Level::Promise && word("new-verdict") == "breaks" {
            continue;
        }
        note(level, words(row, &word));
    }
    Ok(findings)
}

/// `exact in slide: final-position cue moved, 1.030e-2 to 1.420e1`.
fn words<'a>(row: &Value, word: &dyn Fn(&str) -> &'a str) -> String {
    let said = |verdict: &str, value: &str| match (word(verdict), row[value].as_f64()) {
        ("", Some(number)) => format!("{number:.3e}"),
        ("", None) => "none".to_owned(),
        (verdict, _) => verdict.to_owned(),
    };
    let subject = [word("check"), word("subject")].join(" ");
    let named = format!(
        "{} in {}: {} {}",
        word("engine"),
        word("scene"),
        subject.trim_end(),
        word("change")
    );
    match word("change") {
        "appeared" | "vanished" => named,
        _ => format!(
            "{named}, {} to {}",
            said("old-verdict", "old"),
            said("new-verdict", "new")
        ),
    }
}

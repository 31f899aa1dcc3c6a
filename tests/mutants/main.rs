//! Mutants of the sources: one text replaced, the program built, the gate run.
//!
//! Without arguments, as in `cargo test`, it holds the table: every text that a mutant replaces stands exactly once where it says, every
//! scene is in the gate, and the page lists exactly these. `.ci/mutants` runs them.
//!
//! `--run [ID...]`: makes, builds and checks all mutants, or the named ones, and fails where one is not caught as the page says.
//! `--accept`: the same for all, and writes the page's table.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::print_stdout,
    missing_docs
)]

mod run;
mod table;

use carom::study::check::Level;
use run::{Caught, Findings, Workshop};
use std::fs;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;
use table::Mutant;

fn main() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (accept, named) = match arguments.split_first() {
        Some((word, named)) if word == "--run" => (false, named),
        Some((word, named)) if word == "--accept" => (true, named),
        _ => return hold(root),
    };
    let mutants = table::read();
    let mut chosen: Vec<&Mutant> = mutants.iter().collect();
    if !named.is_empty() {
        chosen.retain(|mutant| named.contains(&mutant.id));
        assert_eq!(chosen.len(), named.len(), "no such mutants: {named:?}");
    }
    let workshop = Workshop::new(root);
    let start = Instant::now();
    match workshop.check(&[]) {
        Ok(caught) if caught.is_nothing() => {}
        other => {
            println!("what is not mutated is not as accepted: {other:?}");
            return ExitCode::FAILURE;
        }
    }
    println!(
        "what is not mutated is as accepted ({:.0} s)",
        start.elapsed().as_secs_f64()
    );
    let page = table::page(root);
    let told = table::lines(&page);
    let (mut table, mut failed) = (table::heading(), false);
    for mutant in chosen {
        let start = Instant::now();
        let line = match workshop.mutated(mutant) {
            Ok(caught) => {
                if caught.is_nothing() {
                    println!("{} is not caught", mutant.id);
                    failed = true;
                }
                line(mutant, &caught)
            }
            Err(why) => {
                println!("{}: {why}", mutant.id);
                failed = true;
                continue;
            }
        };
        print!("{:.0} s {line}", start.elapsed().as_secs_f64());
        if !accept && !told.contains(&(mutant.id.clone(), line.clone())) {
            println!("validation/MUTANTS.md says something else of {}", mutant.id);
            failed = true;
        }
        table += &line;
    }
    if accept && !failed && named.is_empty() {
        fs::write(
            root.join("validation/MUTANTS.md"),
            table::with(&page, &table),
        )
        .unwrap();
    }
    ExitCode::from(u8::from(failed))
}

/// The table alone.
fn hold(root: &Path) -> ExitCode {
    let mutants = table::read();
    let faults = table::faults(&mutants, root);
    for fault in &faults {
        println!("{fault}");
    }
    println!(
        "{} mutants of the sources, {} faults in their table; `.ci/mutants` runs them",
        mutants.len(),
        faults.len()
    );
    ExitCode::from(u8::from(!faults.is_empty()))
}

/// One mutant: how many findings of each level caught it, and the first of the first level; or why the gate cannot run.
fn line(mutant: &Mutant, caught: &Caught) -> String {
    let none = Findings::new();
    let (findings, first) = match caught {
        Caught::Findings(findings) => {
            let first = findings.values().next().map(|(_, words)| words.clone());
            (findings, first.unwrap_or_default())
        }
        Caught::Refused(why) => (&none, format!("exit code 2: {why}")),
    };
    let counts = Level::ALL.map(|level| {
        let count = findings.get(&level).map(|(count, _)| count.to_string());
        count.unwrap_or_default()
    });
    format!(
        "| {} | {} | {} | {} | {} |\n",
        mutant.id,
        mutant.file,
        mutant.what,
        counts.join(" | "),
        first.replace('|', "/")
    )
}

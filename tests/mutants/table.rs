//! The table of source mutants, and what the page says of them.

use carom::scene::SetName;
use carom::study::check::Level;
use serde::Deserialize;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// Where the table of the page begins.
const BEGINS: &str = "| source mutant |";

/// One change of the sources.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mutant {
    /// Unique kebab-case name.
    pub id: String,
    /// What is wrong, in a few words.
    pub what: String,
    /// The file that it changes, below the repository.
    pub file: String,
    /// What stands there, exactly once; a line break at its start belongs to the table.
    pub old: String,
    /// What stands there instead.
    pub new: String,
    /// Scenes of the gate in which it can show.
    pub scenes: Vec<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    mutant: Vec<Mutant>,
}

/// Every source mutant, in the order of the page.
pub fn read() -> Vec<Mutant> {
    let table: Table = toml::from_str(include_str!("source.toml")).unwrap();
    table.mutant
}

/// The page as it stands below `root`.
pub fn page(root: &Path) -> String {
    fs::read_to_string(root.join("validation/MUTANTS.md")).unwrap()
}

/// The heading of the table.
pub fn heading() -> String {
    let levels: Vec<&str> = Level::ALL.iter().map(|level| level.id()).collect();
    let columns = levels.len() + 4;
    format!(
        "{BEGINS} file | what is wrong | {} | first finding |\n|{}\n",
        levels.join(" | "),
        "---|".repeat(columns)
    )
}

/// The lines of the page's table, with the id of each.
pub fn lines(page: &str) -> Vec<(String, String)> {
    let table = page.find(BEGINS).map_or("", |begins| &page[begins..]);
    let rows = table
        .lines()
        .take_while(|line| line.starts_with('|'))
        .skip(2);
    let row = |line: &str| {
        let id = line.split('|').nth(1).unwrap_or_default().trim();
        (id.to_owned(), format!("{line}\n"))
    };
    rows.map(row).collect()
}

/// The page with another table.
pub fn with(page: &str, table: &str) -> String {
    let begins = page.find(BEGINS).unwrap();
    let length: usize = page[begins..]
        .split_inclusive('\n')
        .take_while(|line| line.starts_with('|'))
        .map(str::len)
        .sum();
    format!("{}{table}{}", &page[..begins], &page[begins + length..])
}

/// What is wrong with the table itself, against the sources and the page below `root`; empty where nothing is.
pub fn faults(mutants: &[Mutant], root: &Path) -> Vec<String> {
    let mut faults = Vec::new();
    let ids: BTreeSet<&str> = mutants.iter().map(|mutant| mutant.id.as_str()).collect();
    if ids.len() != mutants.len() {
        faults.push("two mutants share a name".to_owned());
    }
    let gate = carom::scene::catalogue::set(SetName::Gate).unwrap();
    for Mutant {
        id,
        file,
        old,
        new,
        scenes,
        ..
    } in mutants
    {
        let text = fs::read_to_string(root.join(file)).unwrap_or_default();
        let count = text.matches(old.as_str()).count();
        if count != 1 {
            faults.push(format!("{id}: its text stands {count} times in {file}"));
        }
        if old == new {
            faults.push(format!("{id} changes nothing"));
        }
        if scenes.is_empty() {
            faults.push(format!("{id} shows in no scene"));
        }
        for scene in scenes {
            if gate.iter().all(|gated| gated.name != *scene) {
                faults.push(format!("{id}: {scene} is not in the gate set"));
            }
        }
    }
    let page = page(root);
    let told: Vec<String> = lines(&page).into_iter().map(|(id, _)| id).collect();
    let ours: Vec<&str> = mutants.iter().map(|mutant| mutant.id.as_str()).collect();
    if told != ours {
        faults.push(format!(
            "validation/MUTANTS.md lists {told:?} instead of {ours:?}"
        ));
    }
    if !page.contains(&heading()) {
        faults.push("the heading in validation/MUTANTS.md is another".to_owned());
    }
    faults
}

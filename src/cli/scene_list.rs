//! `carom scene list`: the catalogue for a person who looks for a scene, one line each, and as a table for programs.

use super::choice::choice;
use super::{Failure, terminal};
use crate::finding::{Block, Cell, Column, Document, Table};
use crate::physics::EFFECTS;
use crate::report::Format;
use crate::scene::{Scene, SceneError, SetName, catalogue, printable};
use clap::Args;
use clap::builder::PossibleValuesParser;
use std::process::ExitCode;

/// Which scenes are asked for. Without any of these: all.
#[derive(Clone, Debug, Default, Args)]
pub struct ListArguments {
    /// Words that the name or the description has, each of them; capitals or not.
    #[arg(value_name = "WORD")]
    pub words: Vec<String>,
    /// Only scenes of a set.
    #[arg(long, value_name = "NAME", value_parser = choice(&SetName::ALL, |set| set.id()))]
    pub set: Option<SetName>,
    /// Only scenes with an effect, such as `cloth.rotational`, or with any of a kind, such as `friction`.
    #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(effects()))]
    pub effect: Option<String>,
}

impl ListArguments {
    /// True for a scene that has all that is asked for.
    pub fn asks_for(&self, scene: &Scene) -> bool {
        let (name, description) = (&scene.name, scene.description.to_lowercase());
        let has = |word: &String| {
            let word = word.to_lowercase();
            name.contains(&word) || description.contains(&word)
        };
        let is_of = |wanted: &String| {
            let effects = scene.effects.named();
            effects
                .iter()
                .any(|id| id == wanted || kind(id) == wanted.as_str())
        };
        self.words.iter().all(has)
            && self.set.is_none_or(|set| scene.is_in(set))
            && self.effect.as_ref().is_none_or(is_of)
    }
}

/// The kind of an effect: what stands before the point.
fn kind(id: &str) -> &str {
    id.split('.').next().unwrap_or(id)
}

/// Every word of `--effect`: each kind, and below it its effects.
fn effects() -> Vec<&'static str> {
    let mut words = Vec::new();
    for effect in EFFECTS {
        for word in [kind(effect.id), effect.id] {
            if !words.contains(&word) {
                words.push(word);
            }
        }
    }
    words
}

/// Prints the scenes that are asked for. None is an answer too.
pub(super) fn list(arguments: &ListArguments, format: &Format) -> Result<ExitCode, Failure> {
    let scenes = found(arguments)?;
    if format.is_cut {
        return terminal::print(&lines(&scenes, arguments.set, terminal::width()));
    }
    if scenes.is_empty() && !format.has_words {
        terminal::say(NOTHING);
    }
    terminal::show(&document(&scenes), format)
}

/// The scenes that are asked for, in the order of the catalogue.
pub fn found(arguments: &ListArguments) -> Result<Vec<Scene>, SceneError> {
    let mut scenes = Vec::new();
    for entry in catalogue::all() {
        let scene = entry.scene()?;
        if arguments.asks_for(&scene) {
            scenes.push(scene);
        }
    }
    Ok(scenes)
}

/// What is said where no scene is found; it fits on the narrowest terminal, as the next does.
const NOTHING: &str = "No scene has all of that; `carom scene list` prints every one.";

/// What is said below the list.
const MORE: &str = "`carom scene show NAME` prints all of a scene.";

/// Space between two columns.
const GAP: &str = "  ";

/// One line a scene, none longer than `width` characters: by sets, each scene below the first that it names, or below `set` alone.
pub fn lines(scenes: &[Scene], set: Option<SetName>, width: usize) -> String {
    if scenes.is_empty() {
        return format!("{NOTHING}\n");
    }
    let length = |words: &str| words.chars().count();
    let names = scenes.iter().map(|scene| length(&scene.name)).max();
    let names = names.unwrap_or(0);
    let balls = |scene: &Scene| scene.balls.len().to_string();
    let digits = scenes.iter().map(|scene| balls(scene).len()).max();
    let digits = digits.unwrap_or(0).max(length("balls"));
    let mut text = format!(
        "{GAP}{:names$}{GAP}{:>digits$}{GAP}what it is\n",
        "scene", "balls"
    );
    let room = width.saturating_sub(names + digits + 3 * GAP.len());
    let groups = SetName::ALL.map(Some).into_iter().chain([None]);
    for group in groups {
        let is_here = |scene: &&Scene| match set {
            Some(_) => group == set,
            None => scene.sets.first().copied() == group,
        };
        let here: Vec<&Scene> = scenes.iter().filter(is_here).collect();
        if here.is_empty() {
            continue;
        }
        let (id, what) = group.map_or(("-", "in no set"), |set| (set.id(), set.what()));
        text += &format!("\n{id} ({}): {what}\n", here.len());
        for scene in here {
            let what = shortened(&printable(&first_sentence(&scene.description)), room);
            let line = format!(
                "{GAP}{:names$}{GAP}{:>digits$}{GAP}{what}",
                scene.name,
                balls(scene)
            );
            text += line.trim_end();
            text.push('\n');
        }
    }
    text + &format!("\n{MORE}\n")
}

/// The first sentence of a description, without its full stop, on one line.
fn first_sentence(description: &str) -> String {
    let words: Vec<&str> = description.split_whitespace().collect();
    let line = words.join(" ");
    let first = line.split(". ").next().unwrap_or_default();
    first.trim_end_matches('.').to_owned()
}

/// `words`, or as many of them as fit into `room` characters with a `…` behind the last.
fn shortened(words: &str, room: usize) -> String {
    if words.chars().count() <= room {
        return words.to_owned();
    }
    let mut kept = String::new();
    for word in words.split(' ') {
        let space = usize::from(!kept.is_empty());
        // one for the mark
        if kept.chars().count() + space + word.chars().count() + 1 > room {
            break;
        }
        kept += &" "[..space];
        kept += word;
    }
    kept.truncate(kept.trim_end_matches([',', ':', ';']).len());
    kept + "…"
}

/// The scenes as a table, with whole descriptions.
pub fn document(scenes: &[Scene]) -> Document {
    let row = |scene: &Scene| {
        let sets: Vec<&str> = scene.sets.iter().map(|set| set.id()).collect();
        vec![
            Cell::text(&scene.name),
            Cell::text(sets.join(" ")),
            Cell::Count(scene.balls.len() as u64),
            Cell::text(scene.effects.named().join(" ")),
            Cell::text(&scene.description),
        ]
    };
    let table = Table {
        id: "scenes".to_owned(),
        columns: vec![
            Column::words("scene", "scene"),
            Column::words("sets", "sets"),
            Column::number("balls", "balls", ""),
            Column::words("effects", "effects"),
            Column::words("description", "what it is, and what would be right"),
        ],
        rows: scenes.iter().map(row).collect(),
        note: "`carom scene show NAME` prints the file of a scene.".to_owned(),
        ..Table::default()
    };
    Document {
        id: "scenes".to_owned(),
        title: "Scenes".to_owned(),
        lead: match scenes {
            [] => NOTHING.to_owned(),
            _ => String::new(),
        },
        blocks: vec![Block::Table(table)],
        ..Document::default()
    }
}

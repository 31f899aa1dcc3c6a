//! The form: every key of the scene format that one line can hold, as a field, filled in from a scene.
//!
//! The fields are read from the schema of the format, so a new law or key is in the form as soon as it exists. Only the five
//! inputs of the report's own window are named here, because they have names of their own.

mod change;
mod engines;
mod five;
mod html;

pub use change::{changed, is_changed};
pub use engines::{ENGINE, Engines, MORE, STEP, as_argument, columns};
pub use five::{FIVE, Input};
pub use html::{Filled, html, rules};

use crate::scene::format::{
    advice, example, keys, kind_of, list, meaning, target, variants, words,
};
use crate::scene::schema;
use crate::trace::files::shortest;
use serde_json::Value as Schema;
use std::sync::LazyLock;
use toml::{Table, Value};

/// The word for a choice of laws of which none is chosen.
pub const NONE: &str = "none";

/// The word for a table that is there, where it may be absent.
pub const GIVEN: &str = "given";

/// The schema of the format: a constant that takes longer to make than a form.
static SCHEMA: LazyLock<Schema> = LazyLock::new(schema);

/// One key of the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// Name in the form: one of the five, or the path.
    pub name: String,
    /// Path of the key in the scene, such as `effects.cushion.restitution.e`.
    pub path: String,
    /// What a person calls it.
    pub label: String,
    /// What it means, with unit and range.
    pub meaning: String,
    /// What would be right.
    pub advice: String,
    /// What it may hold.
    pub kind: Kind,
    /// Whether the table that holds it must have it.
    pub required: bool,
    /// What it holds, as text; a value of another kind as it stands.
    pub value: String,
}

/// What a field may hold.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// A number between these.
    Number {
        /// Smallest value; of an exclusive bound the bound.
        least: Option<f64>,
        /// Largest value; of an exclusive bound the bound.
        most: Option<f64>,
        /// Whether it is a whole number.
        whole: bool,
    },
    /// One of these words; the first if none is given.
    Word(Vec<String>),
    /// On or off, off if nothing is said.
    Flag,
    /// Text.
    Text,
    /// So many numbers.
    Numbers(u64),
    /// Rows of so many numbers.
    Rows(u64),
}

/// A place at which one of several laws, or none, may stand.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// Path of the table that holds the law: also the name in the form.
    pub path: String,
    /// What a person calls it.
    pub label: String,
    /// What it decides.
    pub meaning: String,
    /// Id of the law that stands there; [`NONE`] if none does.
    pub chosen: String,
    /// All laws that may.
    pub laws: Vec<Law>,
}

/// One law of a choice.
#[derive(Clone, Debug, PartialEq)]
pub struct Law {
    /// Its key, or [`GIVEN`] for a table that is there or not.
    pub id: String,
    /// Path of its table.
    pub path: String,
    /// What it does.
    pub what: String,
    /// Its keys.
    pub nodes: Vec<Node>,
}

/// A part of the form.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// One key.
    Field(Field),
    /// One of several laws.
    Choice(Choice),
    /// A table that is always there: its path, what it is, its keys.
    Group(String, String, Vec<Node>),
}

/// The form of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Form {
    /// Its parts, in the order of the format.
    pub nodes: Vec<Node>,
}

impl Form {
    /// The form of a scene as written; keys that the format does not have are left out.
    pub fn of(scene: &Table) -> Self {
        Form {
            nodes: nodes(&SCHEMA, "", Some(scene)),
        }
    }

    /// Every field; `only_chosen`: without those of laws that are not chosen.
    pub fn fields(&self, only_chosen: bool) -> Vec<&Field> {
        let mut found = Vec::new();
        each(&self.nodes, only_chosen, &mut |node| {
            if let Node::Field(field) = node {
                found.push(field);
            }
        });
        found
    }

    /// Every choice of laws.
    pub fn choices(&self) -> Vec<&Choice> {
        let mut found = Vec::new();
        each(&self.nodes, false, &mut |node| {
            if let Node::Choice(choice) = node {
                found.push(choice);
            }
        });
        found
    }

    /// Name of the field or choice that a path of the scene belongs to: its own, or that of the nearest table around it.
    pub fn name_of(&self, mut path: &str) -> Option<String> {
        let (fields, choices) = (self.fields(true), self.choices());
        loop {
            if let Some(field) = fields.iter().find(|field| field.path == path) {
                return Some(field.name.clone());
            }
            if choices.iter().any(|choice| choice.path == path) {
                return Some(path.to_owned());
            }
            path = path.rsplit_once('.')?.0;
        }
    }
}

/// Calls `seen` with every part, those around before those within.
fn each<'n>(nodes: &'n [Node], only_chosen: bool, seen: &mut impl FnMut(&'n Node)) {
    for node in nodes {
        seen(node);
        match node {
            Node::Field(_) => {}
            Node::Group(_, _, inner) => each(inner, only_chosen, seen),
            Node::Choice(choice) => {
                for law in &choice.laws {
                    if !only_chosen || law.id == choice.chosen {
                        each(&law.nodes, only_chosen, seen);
                    }
                }
            }
        }
    }
}

/// The parts of one table. `held`: what the scene has of it.
fn nodes(schema: &'static Schema, path: &str, held: Option<&Table>) -> Vec<Node> {
    let properties = &schema["properties"];
    let required: Vec<&str> = list(&schema["required"])
        .iter()
        .filter_map(Schema::as_str)
        .collect();
    let mut found = Vec::new();
    for key in keys(properties) {
        let (property, value) = (&properties[key], held.and_then(|held| held.get(key)));
        let place = SchemaKey {
            path: join(path, key),
            key,
            property,
            target: target(&SCHEMA, property),
            required: required.contains(&key),
        };
        found.extend(place.node(value));
    }
    found
}

/// A key of the format.
struct SchemaKey<'k> {
    path: String,
    key: &'k str,
    property: &'static Schema,
    target: &'static Schema,
    required: bool,
}

impl SchemaKey<'_> {
    fn node(self, value: Option<&Value>) -> Option<Node> {
        let kind = match kind_of(self.target) {
            _ if words(self.target).is_some() => {
                let words = words(self.target).unwrap_or_default();
                Kind::Word(words.into_iter().map(str::to_owned).collect())
            }
            "choice" => return Some(Node::Choice(self.choice(value))),
            "object" => {
                let may_be_absent = !list(&self.property["anyOf"]).is_empty();
                return Some(match may_be_absent {
                    true => Node::Choice(self.table(value)),
                    false => {
                        let inner = nodes(self.target, &self.path, value.and_then(Value::as_table));
                        Node::Group(self.path.clone(), self.meaning(), inner)
                    }
                });
            }
            kind @ ("number" | "integer") => {
                let bound = |inclusive: &str, exclusive: &str| {
                    let bound = &self.target[inclusive];
                    bound.as_f64().or(self.target[exclusive].as_f64())
                };
                Kind::Number {
                    least: bound("minimum", "exclusiveMinimum"),
                    most: bound("maximum", "exclusiveMaximum"),
                    whole: kind == "integer",
                }
            }
            "boolean" => Kind::Flag,
            "string" => Kind::Text,
            "array" => self.numbers()?,
            _ => return None,
        };
        Some(Node::Field(Field {
            name: five::name_of(&self.path).unwrap_or(&self.path).to_owned(),
            label: self.label(),
            meaning: self.meaning(),
            advice: self.advice(),
            required: self.required,
            value: value.map(shown).unwrap_or_default(),
            kind,
            path: self.path,
        }))
    }

    /// A list of numbers, or of rows of numbers; nothing for a list of anything else.
    fn numbers(&self) -> Option<Kind> {
        let item = target(&SCHEMA, &self.target["items"]);
        match (kind_of(item), kind_of(target(&SCHEMA, &item["items"]))) {
            ("number", _) => Some(Kind::Numbers(self.target["minItems"].as_u64()?)),
            ("array", "number") => Some(Kind::Rows(item["minItems"].as_u64()?)),
            _ => None,
        }
    }

    fn choice(&self, value: Option<&Value>) -> Choice {
        let held = value.and_then(Value::as_table);
        let whats = list(&self.target["oneOf"])
            .iter()
            .map(|law| meaning(law, law));
        let laws = variants(self.target).into_iter().zip(whats);
        let laws: Vec<Law> = laws
            .map(|((id, schema), what)| {
                let path = join(&self.path, id);
                let inner = held.and_then(|held| held.get(id)).and_then(Value::as_table);
                Law {
                    nodes: nodes(schema, &path, inner),
                    id: id.to_owned(),
                    path,
                    what,
                }
            })
            .collect();
        let stands = |law: &&Law| held.is_some_and(|held| held.contains_key(&law.id));
        let chosen = laws.iter().find(stands).map_or(NONE, |law| &law.id);
        Choice {
            path: self.path.clone(),
            label: self.title(),
            meaning: self.meaning(),
            chosen: chosen.to_owned(),
            laws,
        }
    }

    /// A table that may be absent, as a choice of one law.
    fn table(&self, value: Option<&Value>) -> Choice {
        let held = value.and_then(Value::as_table);
        Choice {
            path: self.path.clone(),
            label: self.title(),
            meaning: self.meaning(),
            chosen: held.map_or(NONE, |_| GIVEN).to_owned(),
            laws: vec![Law {
                id: GIVEN.to_owned(),
                path: self.path.clone(),
                what: self.meaning(),
                nodes: nodes(self.target, &self.path, held),
            }],
        }
    }

    fn label(&self) -> String {
        self.key.replace('_', " ")
    }

    /// The name of a choice begins a line.
    fn title(&self) -> String {
        let label = self.label();
        let mut letters = label.chars();
        let first = letters.next().map(|first| first.to_ascii_uppercase());
        first.into_iter().chain(letters).collect()
    }

    fn meaning(&self) -> String {
        meaning(self.property, self.target)
    }

    fn advice(&self) -> String {
        advice(self.property, self.target)
    }
}

/// What a key holds where a person has not said it: the example of the format; for a ball the first of the scene.
fn proposed(path: &str, scene: &Table) -> Option<Value> {
    let mut schema: &'static Schema = &SCHEMA;
    for key in path.split('.') {
        schema = inner(schema, key)?;
    }
    if let Some(number) = example(schema) {
        return Some(match kind_of(target(&SCHEMA, schema)) {
            "integer" => Value::Integer(number as i64),
            _ => Value::Float(number),
        });
    }
    if let Some(numbers) = schema["examples"].get(0).and_then(Schema::as_array) {
        let numbers = numbers.iter().filter_map(Schema::as_f64);
        return Some(Value::Array(numbers.map(Value::Float).collect()));
    }
    let first = scene.get("balls").and_then(|balls| balls.get(0)?.get("id"));
    let from_rack = scene.get("rack").map(|_| Value::String("1".to_owned()));
    (path.starts_with("shot.") && path.ends_with(".ball"))
        .then(|| first.cloned().or(from_rack))
        .flatten()
}

/// The schema of a key of a table, or of a law of a choice.
fn inner(schema: &'static Schema, key: &str) -> Option<&'static Schema> {
    let target = target(&SCHEMA, schema);
    let law = variants(target).into_iter().find(|(id, _)| *id == key);
    law.map(|(_, law)| law)
        .or_else(|| target["properties"].get(key))
}

fn join(path: &str, key: &str) -> String {
    match path {
        "" => key.to_owned(),
        path => format!("{path}.{key}"),
    }
}

/// A value as a person writes it into a field.
fn shown(value: &Value) -> String {
    let row = |items: &[Value]| items.iter().map(shown).collect::<Vec<_>>().join(", ");
    match value {
        Value::String(text) => text.clone(),
        Value::Integer(whole) => whole.to_string(),
        Value::Float(number) => shortest(*number),
        Value::Boolean(on) => on.to_string(),
        Value::Array(items) if items.iter().any(Value::is_array) => {
            let rows = items.iter().map(shown);
            rows.collect::<Vec<_>>().join("\n")
        }
        Value::Array(items) => row(items),
        Value::Datetime(date) => date.to_string(),
        Value::Table(table) => table.to_string(),
    }
}

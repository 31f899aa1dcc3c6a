//! From the fields of a form back to the scene: only what differs from the scene that the form was filled in from is changed.
//!
//! What a person typed goes into the scene as it is, right or wrong: the check of the format is the only judge of it.

use super::{Choice, Field, Form, Kind, NONE, Node, proposed};
use crate::physics::pockets::six_pockets;
use crate::scene::{catalogue, is_kebab_case, nearest, printable};
use crate::web::encoding::Pairs;
use crate::web::problem::Problem;
use toml::{Table, Value};

/// Path of the pockets' list, which may be left blank for the six of a pool table.
const CIRCLES: &str = "effects.pockets.circles";

/// What the name of a catalogue's scene gets when it is no longer that scene.
const CHANGED: &str = "-changed";

/// Whether `name` is what a scene called `original` gets when it is changed.
pub fn is_changed(name: &str, original: &str) -> bool {
    name.strip_suffix(CHANGED) == Some(original)
}

/// The scene with the fields put into it, and what is wrong with the fields themselves.
///
/// A form sends the fields of every law, so those of laws that are not chosen are left out; where the choice itself is not among
/// the fields, such a field is an error.
pub fn changed(scene: &Table, fields: &Pairs) -> (Table, Vec<Problem>) {
    let (mut table, mut problems) = (scene.clone(), Vec::new());
    let before = Form::of(scene);
    let mut new_laws = Vec::new();
    for choice in before.choices() {
        if let Some(word) = fields.last(&choice.path) {
            match choose(&mut table, scene, choice, word) {
                Ok(new) => new_laws.extend(new),
                Err(problem) => problems.push(problem),
            }
        }
    }
    let after = Form::of(&table);
    for (name, _) in &fields.0 {
        problems.extend(stray(&before, &after, fields, name));
    }
    for field in after.fields(true) {
        let is_new = new_laws.iter().any(|law| field.path.starts_with(law));
        match fields.last(&field.name) {
            Some(text) => {
                let typed = typed(field, text, value_at(&table, &field.path));
                if field.required && typed.is_none() && field.path != CIRCLES {
                    problems.push(must_be_given(field));
                }
                put(&mut table, &field.path, typed);
            }
            None if is_new && field.required => {
                put(&mut table, &field.path, proposed(&field.path, scene));
            }
            None => {}
        }
    }
    six_pockets_if_blank(&mut table);
    if table != *scene {
        rename(scene, &mut table);
    }
    (table, problems)
}

/// Puts another law, or none, where one may stand. Answers the path of the law if it is new there.
fn choose(
    table: &mut Table,
    scene: &Table,
    choice: &Choice,
    word: &str,
) -> Result<Option<String>, Problem> {
    if word == choice.chosen {
        return Ok(None);
    }
    if word == NONE {
        put(table, &choice.path, None);
        return Ok(None);
    }
    let Some(law) = choice.laws.iter().find(|law| law.id == word) else {
        let ids: Vec<&str> = choice.laws.iter().map(|law| law.id.as_str()).collect();
        let message = format!("unknown word \"{}\" for {}", printable(word), choice.label);
        let help = format!("known are {NONE}, {}", ids.join(", "));
        return Err(Problem::at(&choice.path, message, help));
    };
    // the ball of a shot stays the same; numbers of another law mean something else
    let kept = choice.laws.iter().find(|law| law.id == choice.chosen);
    let ball = kept.and_then(|kept| value_at(scene, &format!("{}.ball", kept.path)));
    put(table, &choice.path, Some(Value::Table(Table::new())));
    put(table, &law.path, Some(Value::Table(Table::new())));
    let has_ball = law
        .nodes
        .iter()
        .any(|node| matches!(node, Node::Field(field) if field.label == "ball"));
    if let (true, Some(ball)) = (has_ball, ball) {
        put(table, &format!("{}.ball", law.path), Some(ball.clone()));
    }
    Ok(Some(law.path.clone()))
}

/// What is wrong with a name: it is no field, or that of a law that nobody chose.
fn stray(before: &Form, after: &Form, fields: &Pairs, name: &str) -> Option<Problem> {
    if before.choices().iter().any(|choice| choice.path == name) {
        return None;
    }
    let chosen = after.fields(true);
    if chosen.iter().any(|field| field.name == name) {
        return None;
    }
    let all = after.fields(false);
    let Some(field) = all.iter().find(|field| field.name == name) else {
        let known = all.iter().map(|field| field.name.as_str());
        let help = match nearest(name, known) {
            Some(guess) => format!("did you mean `{guess}`?"),
            None => "the page lists every field".to_owned(),
        };
        let message = format!("there is no field `{}`", printable(name));
        return Some(Problem::at(name, message, help));
    };
    let around = after
        .choices()
        .into_iter()
        .filter(|choice| field.path.starts_with(&choice.path))
        .max_by_key(|choice| choice.path.len())?;
    // of the form itself, which sends the fields of every law
    if fields.last(&around.path).is_some() {
        return None;
    }
    let message = format!(
        "the {} of this scene is `{}`, which has no {}",
        around.path, around.chosen, field.name
    );
    let help = format!("choose another `{}` with it", around.path);
    Some(Problem::at(name, message, help))
}

fn must_be_given(field: &Field) -> Problem {
    let message = format!("{} must be given", field.label);
    Problem::at(&field.name, message, field.advice.clone())
}

/// The value that `text` stands for, right or wrong; `None` for nothing. `held`: what the scene has there, which stays as it is
/// written where it means the same.
fn typed(field: &Field, text: &str, held: Option<&Value>) -> Option<Value> {
    let text = match field.kind {
        Kind::Text => text,
        _ => text.trim(),
    };
    let as_text = || Value::String(text.to_owned());
    if text.is_empty() {
        return None;
    }
    let value = match &field.kind {
        Kind::Number { whole, .. } => match (whole, text.parse::<i64>(), number(text)) {
            (true, Ok(whole), _) => Value::Integer(whole),
            (_, _, Some(number)) => Value::Float(number),
            _ => as_text(),
        },
        Kind::Flag => match text {
            "true" | "on" => Value::Boolean(true),
            "false" | "off" if held.is_none() => return None,
            "false" | "off" => Value::Boolean(false),
            _ => as_text(),
        },
        Kind::Word(words) if held.is_none() && words.first().is_some_and(|word| word == text) => {
            return None;
        }
        Kind::Word(_) | Kind::Text => as_text(),
        Kind::Numbers(_) => numbers(text).unwrap_or_else(as_text),
        Kind::Rows(_) => {
            let rows = text.lines().filter(|line| !line.trim().is_empty());
            let rows: Option<Vec<Value>> = rows.map(numbers).collect();
            rows.map_or_else(as_text, Value::Array)
        }
    };
    let same = held.filter(|held| means_the_same(held, &value));
    Some(same.cloned().unwrap_or(value))
}

fn number(text: &str) -> Option<f64> {
    text.parse().ok()
}

/// Numbers parted by commas or spaces.
fn numbers(text: &str) -> Option<Value> {
    let parts = text.split([',', ' ', '\t']).filter(|part| !part.is_empty());
    let numbers: Option<Vec<Value>> = parts.map(|part| number(part).map(Value::Float)).collect();
    numbers.map(Value::Array)
}

/// Equal, be a number whole or not.
fn means_the_same(a: &Value, b: &Value) -> bool {
    let float = |value: &Value| match value {
        Value::Integer(whole) => Some(*whole as f64),
        Value::Float(number) => Some(*number),
        _ => None,
    };
    match (a, b) {
        (Value::Array(a), Value::Array(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| means_the_same(a, b))
        }
        _ => a == b || float(a).zip(float(b)).is_some_and(|(a, b)| a == b),
    }
}

fn value_at<'t>(table: &'t Table, path: &str) -> Option<&'t Value> {
    let mut keys = path.split('.');
    let first = table.get(keys.next()?)?;
    keys.try_fold(first, |value, key| value.as_table()?.get(key))
}

/// Puts a value at a path, making the tables on the way; `None` takes away what is there.
fn put(table: &mut Table, path: &str, value: Option<Value>) {
    let (tables, key) = path.rsplit_once('.').unwrap_or(("", path));
    let mut at = table;
    for step in tables.split('.').filter(|step| !step.is_empty()) {
        if value.is_none() && !at.contains_key(step) {
            return;
        }
        let inner = at.entry(step).or_insert_with(|| Value::Table(Table::new()));
        let Value::Table(inner) = inner else {
            return;
        };
        at = inner;
    }
    match value {
        Some(value) => {
            at.insert(key.to_owned(), value);
        }
        None => {
            at.remove(key);
        }
    }
}

/// The six pockets of a pool table, where pockets are asked for and none is listed.
fn six_pockets_if_blank(scene: &mut Table) {
    let blank = value_at(scene, "effects.pockets").is_some() && value_at(scene, CIRCLES).is_none();
    let number = |path: &str| match value_at(scene, path) {
        Some(Value::Float(number)) => Some(*number),
        Some(Value::Integer(whole)) => Some(*whole as f64),
        _ => None,
    };
    let size = number("table.width").zip(number("table.length"));
    let (true, Some((width, length)), Some(radius)) = (blank, size, number("ball.radius")) else {
        return;
    };
    let origin = |axis: usize| {
        let corner = value_at(scene, "table.origin").and_then(Value::as_array);
        corner.and_then(|corner| corner.get(axis)?.as_float())
    };
    let (x, y) = (origin(0).unwrap_or(0.0), origin(1).unwrap_or(0.0));
    let circles = six_pockets([x, y], [x + width, y + length], radius);
    let row = |circle: [f64; 3]| Value::Array(circle.map(Value::Float).to_vec());
    let rows = circles.into_iter().map(row).collect();
    put(scene, CIRCLES, Some(Value::Array(rows)));
}

/// Takes from a changed scene of the catalogue what is true of that scene alone.
fn rename(scene: &Table, changed: &mut Table) {
    let name = |table: &Table| table.get("name").and_then(Value::as_str).map(str::to_owned);
    let Some(old) = name(scene).filter(|name| catalogue::find(name).is_some()) else {
        return;
    };
    for key in ["sets", "richer", "description"] {
        if changed.get(key) == scene.get(key) {
            changed.remove(key);
        }
    }
    let new = format!("{old}{CHANGED}");
    if name(changed).as_ref() == Some(&old) && is_kebab_case(&new) {
        changed.insert("name".to_owned(), Value::String(new));
    }
}

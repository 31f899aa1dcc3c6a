//! Which engines run, with which step: boxes to tick, one step an engine that has one, and a line for anything else.

use crate::engine::{Refusal, Roster, Setting, step_knob};
use crate::oracle;
use crate::scene::Scene;
use crate::study::Configuration;
use crate::study::compare::{default_columns, plan};
use crate::web::encoding::Pairs;
use crate::web::problem::Problem;

/// Name of the boxes.
pub const ENGINE: &str = "engine";

/// Name of the line for any other engine and setting.
pub const MORE: &str = "more-engines";

/// What the name of a field for a step begins with; the engine's id follows.
pub const STEP: &str = "dt.";

/// Most columns of one comparison.
const MOST_COLUMNS: usize = 12;

/// The part of the form about engines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Engines {
    /// All that there are.
    pub roster: Roster,
    /// Boxes, ticked or not.
    pub boxes: Vec<Tick>,
    /// Steps.
    pub steps: Vec<Step>,
    /// Any other engines, as in `carom compare --engines`.
    pub more: String,
}

/// One engine with a setting that is always offered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tick {
    /// As in `carom compare --engines`.
    pub spec: String,
    /// Engine and setting.
    pub label: String,
    /// How it solves in time.
    pub method: String,
    /// Whether it is ticked.
    pub ticked: bool,
    /// Whether it runs whatever is ticked: the others are held against it.
    pub always: bool,
}

/// The step of one engine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Step {
    /// Id of the engine.
    pub engine: String,
    /// What it means.
    pub meaning: String,
    /// As typed.
    pub value: String,
}

impl Engines {
    /// The fields about engines among `fields`, which are taken out; all default engines where none is named.
    pub fn taken_from(fields: &mut Pairs, roster: &Roster) -> Self {
        let named: Vec<String> = fields.all(ENGINE).map(str::to_owned).collect();
        fields.take(ENGINE);
        let defaults = plan(roster, &default_columns(roster)).into_iter();
        let boxes = defaults.map(|column| {
            let spec = column.spec();
            // the reference is what the others are held against: it always runs
            let always = oracle::is_reference(&*column.engine) && column.setting.values.is_empty();
            Tick {
                always,
                ticked: named.is_empty() || named.contains(&spec) || always,
                label: column.label(),
                method: column.engine.about().method.into_owned(),
                spec,
            }
        });
        let boxes: Vec<Tick> = boxes.collect();
        let steps = roster.iter().filter_map(|engine| {
            let knob = step_knob(engine.knobs())?;
            let typed = fields.take(&format!("{STEP}{}", engine.id()));
            Some(Step {
                engine: engine.id().to_owned(),
                meaning: knob.what,
                value: typed.unwrap_or(knob.default),
            })
        });
        let steps = steps.collect();
        let other = |spec: &&String| !boxes.iter().any(|known| known.spec == **spec);
        let mut more: Vec<String> = named.iter().filter(other).cloned().collect();
        more.extend(fields.take(MORE).filter(|more| !more.trim().is_empty()));
        Engines {
            roster: roster.clone(),
            boxes,
            steps,
            more: more.join(","),
        }
    }

    /// The columns that run `scene`. Errors: at the field that is wrong.
    ///
    /// An engine that cannot run the scene is an answer, not an error; so is one that refuses a setting, as in `carom compare`. A step
    /// that an engine does not understand is a mistake at its field.
    pub fn columns(&self, scene: &Scene) -> Result<Vec<Configuration>, Problem> {
        let ticked = self.boxes.iter().filter(|known| known.ticked);
        let mut columns = Vec::new();
        for known in ticked {
            columns.extend(self.listed(&known.spec, ENGINE)?);
        }
        for column in &mut columns {
            let id = column.engine.id();
            let knob = step_knob(column.engine.knobs());
            let typed = self.steps.iter().find(|step| step.engine == id);
            let Some((typed, knob)) = typed.zip(knob) else {
                continue;
            };
            if typed.value.trim() == knob.default {
                continue;
            }
            column.setting = column.setting.clone().with(&knob.key, typed.value.trim());
            match column.engine.pace(scene, &column.setting) {
                Err(Refusal::Setting { key, message }) if key.as_ref() == Some(&knob.key) => {
                    let field = format!("{STEP}{id}");
                    return Err(Problem::at(&field, message, typed.meaning.clone()));
                }
                _ => {}
            }
        }
        if !self.more.trim().is_empty() {
            columns.extend(self.listed(&self.more, MORE)?);
        }
        counted(columns)
    }

    fn listed(&self, list: &str, field: &str) -> Result<Vec<Configuration>, Problem> {
        listed(&self.roster, list, field)
    }
}

/// The columns of a list as `carom compare --engines` takes it.
pub fn columns(roster: &Roster, list: &str) -> Result<Vec<Configuration>, Problem> {
    counted(plan(roster, &listed(roster, list, "engines")?))
}

fn listed(roster: &Roster, list: &str, field: &str) -> Result<Vec<Configuration>, Problem> {
    Configuration::list(roster, list).map_err(|why| {
        let help = format!("such as {}", example(roster));
        Problem::at(field, why.to_string(), help)
    })
}

/// A list of two engines with settings: the first preset that sets something, and another engine with a step of its own.
pub fn example(roster: &Roster) -> String {
    let set = Configuration::presets(roster, |preset| !preset.setting.values.is_empty());
    let first = set.first().cloned();
    let other = roster.iter().rev().find_map(|engine| {
        let differs = first.as_ref().is_none_or(|c| c.engine.id() != engine.id());
        let step = engine.step(&Setting::default()).filter(|_| differs)?;
        let setting = engine.with_step(&Setting::default(), 0.1 * step)?;
        Some(Configuration::with(engine, setting))
    });
    let specs: Vec<String> = first
        .iter()
        .chain(&other)
        .map(Configuration::spec)
        .collect();
    specs.join(",")
}

/// The same columns, if there are not too many and each is there once.
fn counted(columns: Vec<Configuration>) -> Result<Vec<Configuration>, Problem> {
    if columns.len() > MOST_COLUMNS {
        let message = format!("{} engines are too many for one page", columns.len());
        let help = format!("{MOST_COLUMNS} are the most");
        return Err(Problem::at(MORE, message, help));
    }
    for (i, column) in columns.iter().enumerate() {
        let label = column.label();
        if columns[..i].iter().any(|known| known.label() == label) {
            let message = format!("`{label}` is listed twice");
            let help = "name each engine and setting once";
            return Err(Problem::at(MORE, message, help));
        }
    }
    Ok(columns)
}

/// `--engines LIST` for these columns, with a space before it; nothing for those that run where none is named.
pub fn as_argument<'c>(
    roster: &Roster,
    columns: impl Iterator<Item = &'c Configuration>,
) -> String {
    let specs: Vec<String> = columns.map(Configuration::spec).collect();
    let defaults = plan(roster, &default_columns(roster));
    let default: Vec<String> = defaults.iter().map(Configuration::spec).collect();
    match specs == default {
        true => String::new(),
        false => format!(" --engines {}", specs.join(",")),
    }
}

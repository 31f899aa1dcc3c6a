//! Which engines run, with which step: boxes to tick, one step an engine that has one, and a line for anything else.

use crate::engine::{ENGINES, Refusal};
use crate::scene::Scene;
use crate::study::Column;
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
    pub method: &'static str,
    /// Whether it is ticked.
    pub ticked: bool,
}

/// The step of one engine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Step {
    /// Id of the engine.
    pub engine: &'static str,
    /// What it means.
    pub meaning: String,
    /// As typed.
    pub value: String,
}

impl Engines {
    /// The fields about engines among `fields`, which are taken out; all default engines where none is named.
    pub fn taken_from(fields: &mut Pairs) -> Self {
        let named: Vec<String> = fields.all(ENGINE).map(str::to_owned).collect();
        fields.take(ENGINE);
        let boxes = plan(&default_columns()).into_iter().map(|column| {
            let spec = spec(&column);
            Tick {
                // the exact engine is what the others are held against: it always runs
                ticked: named.is_empty() || named.contains(&spec) || spec == "exact",
                label: column.label(),
                method: column.engine.about().method,
                spec,
            }
        });
        let boxes: Vec<Tick> = boxes.collect();
        let steps = ENGINES.iter().filter_map(|engine| {
            let knob = engine.knobs().into_iter().find(|knob| knob.key == "dt")?;
            let typed = fields.take(&format!("{STEP}{}", engine.id()));
            Some(Step {
                engine: engine.id(),
                meaning: knob.what,
                value: typed.unwrap_or(knob.default),
            })
        });
        let steps = steps.collect();
        let other = |spec: &&String| !boxes.iter().any(|known| known.spec == **spec);
        let mut more: Vec<String> = named.iter().filter(other).cloned().collect();
        more.extend(fields.take(MORE).filter(|more| !more.trim().is_empty()));
        Engines {
            boxes,
            steps,
            more: more.join(","),
        }
    }

    /// The columns that run `scene`. Errors: at the field that is wrong.
    pub fn columns(&self, scene: &Scene) -> Result<Vec<Column>, Problem> {
        let ticked = self.boxes.iter().filter(|known| known.ticked);
        let mut columns = Vec::new();
        for known in ticked {
            columns.extend(listed(&known.spec, ENGINE)?);
        }
        for column in &mut columns {
            let id = column.engine.id();
            let knobs = column.engine.knobs();
            let default = knobs.iter().find(|knob| knob.key == "dt");
            let typed = self.steps.iter().find(|step| step.engine == id);
            let Some((typed, default)) = typed.zip(default) else {
                continue;
            };
            if typed.value.trim() != default.default {
                column.setting = column.setting.clone().with("dt", typed.value.trim());
            }
        }
        if !self.more.trim().is_empty() {
            columns.extend(listed(&self.more, MORE)?);
        }
        checked(columns, scene)
    }
}

/// The columns of a list as `carom compare --engines` takes it, for `scene`.
pub fn columns(list: &str, scene: &Scene) -> Result<Vec<Column>, Problem> {
    checked(plan(&listed(list, "engines")?), scene)
}

fn listed(list: &str, field: &str) -> Result<Vec<Column>, Problem> {
    let help = "such as stepper,rapier-f64:preset=stock:dt=1e-3";
    Column::list(list).map_err(|why| Problem::at(field, why, help))
}

fn checked(columns: Vec<Column>, scene: &Scene) -> Result<Vec<Column>, Problem> {
    if columns.len() > MOST_COLUMNS {
        let message = format!("{} engines are too many for one page", columns.len());
        return Err(Problem::at(
            MORE,
            message,
            format!("{MOST_COLUMNS} are the most"),
        ));
    }
    for (i, column) in columns.iter().enumerate() {
        if columns[..i]
            .iter()
            .any(|known| known.label() == column.label())
        {
            let message = format!("`{}` is listed twice", column.label());
            return Err(Problem::at(
                MORE,
                message,
                "name each engine and setting once",
            ));
        }
        // what an engine cannot simulate is an answer; what it does not understand is a mistake of the form
        if let Err(Refusal::Setting { message }) = column.engine.pace(scene, &column.setting) {
            let id = column.engine.id();
            let of_step = message.starts_with("`dt=");
            let field = match of_step {
                true => format!("{STEP}{id}"),
                false => MORE.to_owned(),
            };
            return Err(Problem::at(&field, format!("{id}: {message}"), ""));
        }
    }
    Ok(columns)
}

fn spec(column: &Column) -> String {
    let setting = column.setting.to_string();
    let parts = setting.split_whitespace();
    parts.fold(column.engine.id().to_owned(), |spec, part| {
        format!("{spec}:{part}")
    })
}

//! What a request asks for: a scene as written, fields to be put into it, engines.

use super::Site;
use super::encoding::{Pairs, unpacked};
use super::form::{Engines, Form, changed, columns};
use super::misplaced::of_scene;
use super::problem::Problem;
use super::wire::Request;
use crate::scene::{Scene, catalogue, parse};
use crate::study::Configuration;
use serde::Deserialize;
use serde_json::Value;
use toml::Table;

/// Most balls of a scene.
pub const MOST_BALLS: usize = 200;

/// Most balls times seconds of a scene: what a run records, and a page can show, grows with both.
pub const MOST_BALL_SECONDS: f64 = 4000.0;

/// Name under which messages know the scene of a request.
const FILE: &str = "scene.toml";

/// A request, read.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    /// The scene that the fields are put into, as written.
    pub base: String,
    /// The fields that are put into it.
    pub fields: Pairs,
    /// The fields about engines.
    pub engines: Engines,
    /// The engines as a list, instead of the fields about them.
    pub list: Option<String>,
}

/// The body of a request in JSON.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct Body {
    /// The scene as a file; that of the server if absent.
    scene: Option<String>,
    /// Fields by name.
    fields: Option<serde_json::Map<String, Value>>,
    /// Engines, as in `carom compare --engines`.
    engines: Option<String>,
}

impl Asked {
    /// Of a scene and the fields to be put into it.
    fn new(site: &Site, base: String, mut fields: Pairs, list: Option<String>) -> Self {
        let engines = Engines::taken_from(&mut fields, &site.roster);
        Asked {
            base,
            fields,
            engines,
            list,
        }
    }

    /// Of the body of a request; where it has no scene, that of the site.
    pub fn of_body(request: &Request, site: &Site) -> Result<Self, Problem> {
        if request.is_of("application/x-www-form-urlencoded") {
            let body = String::from_utf8_lossy(&request.body);
            return Ok(Asked::of_form(Pairs::parse(&body), site));
        }
        let body: Body = serde_json::from_slice(&request.body).map_err(|error| Problem {
            line: Some(error.line()),
            column: Some(error.column()),
            ..Problem::new(format!("the body is not what this server reads: {error}"))
        })?;
        let mut pairs = Vec::new();
        for (name, value) in body.fields.unwrap_or_default() {
            match value {
                Value::Array(items) => {
                    pairs.extend(items.iter().map(|item| (name.clone(), plain(item))));
                }
                value => pairs.push((name, plain(&value))),
            }
        }
        let base = body.scene.unwrap_or_else(|| site.start.clone());
        Ok(Asked::new(site, base, Pairs(pairs), body.engines))
    }

    /// Of a form that was sent without scripts.
    fn of_form(mut fields: Pairs, site: &Site) -> Self {
        // browsers end the lines of a form as HTTP does
        let scene = fields.take("scene").map(|text| text.replace("\r\n", "\n"));
        if fields.take("run").as_deref() == Some("file") {
            fields.0.retain(|(name, _)| is_of_engines(name));
        }
        let base = scene.unwrap_or_else(|| site.start.clone());
        Asked::new(site, base, fields, None)
    }

    /// Of a link: `toml`, a packed scene, or `scene`, a name of the catalogue; and fields by name. Where it names none, `start` or the
    /// scene of the site; where the scene is not to be had, that one, and why.
    pub fn of_link(query: &str, site: &Site, start: Option<&str>) -> (Self, Option<Problem>) {
        let start = start.unwrap_or(&site.start);
        let mut fields = Pairs::parse(query);
        let (packed, name) = (fields.take("toml"), fields.take("scene"));
        let base = match (packed, name) {
            (Some(packed), _) => unpacked(&packed).map_err(Problem::new),
            (None, Some(name)) => catalogue::find(&name)
                .map(|entry| entry.text.to_owned())
                .ok_or_else(|| Problem::new(catalogue::unknown(&name).to_string())),
            (None, None) => Ok(start.to_owned()),
        };
        match base {
            Ok(base) => (Asked::new(site, base, fields, None), None),
            Err(problem) => {
                let asked = Asked::new(site, start.to_owned(), Pairs::default(), None);
                (asked, Some(problem))
            }
        }
    }

    /// The scene with the fields put into it, and everything that is wrong.
    pub fn drawn_up(&self) -> Drawn {
        let base = self.base.strip_prefix('\u{feff}').unwrap_or(&self.base);
        let Ok(table) = toml::from_str::<Table>(base) else {
            // what is no TOML has no keys that a field could be put into
            let problems = match parse(FILE, base) {
                Err(error) => of_scene(&error, &Form::of(&Table::new())),
                Ok(_) => vec![Problem::new("the scene cannot be read")],
            };
            let problems = problems.into_iter().map(|problem| Problem {
                field: Some("scene".to_owned()),
                ..problem
            });
            return Drawn {
                table: Table::new(),
                text: base.to_owned(),
                scene: None,
                problems: problems.collect(),
            };
        };
        let (changed, mut problems) = changed(&table, &self.fields);
        let text = match changed == table {
            true => base.to_owned(),
            false => toml::to_string(&changed).unwrap_or_else(|_| base.to_owned()),
        };
        let form = Form::of(&changed);
        let scene = match parse(FILE, &text) {
            Ok(scene) => {
                problems.extend(too_large(&scene));
                Some(scene)
            }
            Err(error) => {
                let found = of_scene(&error, &form);
                // a field that is empty is missing in the scene as well
                let known = |problem: &Problem| {
                    let field = problem.field.as_ref();
                    field.is_some() && problems.iter().any(|known| known.field.as_ref() == field)
                };
                let new: Vec<Problem> = found.into_iter().filter(|p| !known(p)).collect();
                problems.extend(new);
                None
            }
        };
        Drawn {
            table: changed,
            text,
            scene: scene.filter(|_| problems.is_empty()),
            problems,
        }
    }

    /// The engines that run `scene`.
    pub fn columns(&self, scene: &Scene) -> Result<Vec<Configuration>, Problem> {
        match &self.list {
            Some(list) => columns(&self.engines.roster, list),
            None => self.engines.columns(scene),
        }
    }
}

/// A scene as a request asks for it.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawn {
    /// The scene as written, right or wrong.
    pub table: Table,
    /// Its text.
    pub text: String,
    /// The scene; `None` if anything is wrong.
    pub scene: Option<Scene>,
    /// Everything that is wrong.
    pub problems: Vec<Problem>,
}

impl Drawn {
    /// The name of the scene, right or wrong.
    pub fn name(&self) -> &str {
        let name = self.table.get("name").and_then(toml::Value::as_str);
        name.unwrap_or("scene")
    }
}

fn is_of_engines(name: &str) -> bool {
    use super::form::{ENGINE, MORE, STEP};
    name == ENGINE || name == MORE || name.starts_with(STEP)
}

/// What makes a scene more than a page can show.
fn too_large(scene: &Scene) -> Option<Problem> {
    let balls = scene.balls.len();
    if balls > MOST_BALLS {
        let message =
            format!("{balls} balls are too many for this page, {MOST_BALLS} are the most");
        let help = "carom compare takes any number";
        return Some(Problem::at("scene", message, help));
    }
    let longest = MOST_BALL_SECONDS / balls.max(1) as f64;
    if scene.duration > longest {
        let message = format!(
            "{} s are too long for this page with {balls} balls",
            scene.duration
        );
        let help = format!("{longest} s are the most; carom compare takes any time");
        return Some(Problem::at("duration", message, help));
    }
    None
}

/// A value of JSON as it would be typed.
fn plain(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}

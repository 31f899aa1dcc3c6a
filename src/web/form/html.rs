//! The form as HTML: labelled fields with what is recommended and the range as text, complete before any script runs.

use super::engines::{ENGINE, Engines, MORE, STEP};
use super::five::{FIVE, Input};
use super::{Choice, Field, Form, GIVEN, Kind, Law, NONE, Node};
use crate::oracle;
use crate::report::html::inline;
use crate::report::svg::escape;
use crate::web::problem::Problem;
use toml::Table;

/// Sections of the form below the five inputs: title, and the keys of the scene in it. Keys that are in none are in the last.
const SECTIONS: [(&str, &[&str]); 4] = [
    ("Shot", &["shot"]),
    ("Effects", &["effects", "simultaneous"]),
    ("Table and balls", &["table", "ball", "balls", "rack"]),
    ("Time, names and units", &[]),
];

/// What a page shows of a scene that may not be one yet.
#[derive(Clone, Copy, Debug)]
pub struct Filled<'a> {
    /// The scene as written.
    pub scene: &'a Table,
    /// Its text.
    pub text: &'a str,
    /// Which engines run.
    pub engines: &'a Engines,
    /// What is wrong, at the fields.
    pub problems: &'a [Problem],
}

/// The inside of the form.
pub fn html(filled: Filled<'_>) -> String {
    let form = Form::of(filled.scene);
    let page = Writer { filled };
    let mut html = page.summary(&form);
    html += "<div class=\"five\">\n";
    for input in &FIVE {
        html += &page.input(&form, input);
    }
    html += "</div>\n<p class=\"go\"><button type=\"submit\" class=\"start\" name=\"run\" value=\"form\">Start</button></p>\n";
    for (i, (title, _)) in SECTIONS.iter().enumerate() {
        let own: Vec<&Node> = form.nodes.iter().filter(|n| section(n) == i).collect();
        let inner: String = own.into_iter().map(|node| page.node(node)).collect();
        html += &page.section(title, &inner);
    }
    html += &page.section("Engines", &page.engines());
    html + &page.scene_file()
}

/// Rules that show the keys of the laws that are chosen and no others. The same for every scene.
pub fn rules() -> String {
    let form = Form::of(&Table::new());
    let mut css = String::new();
    for choice in form.choices() {
        for law in &choice.laws {
            let (box_, law) = (id(&choice.path), &law.id);
            css += &format!(
                "form:not(:has(#{box_} option[value=\"{law}\"]:checked)) [data-law=\"{} {law}\"]{{display:none}}",
                choice.path
            );
        }
    }
    for input in &FIVE {
        let laws = form.choices().into_iter().flat_map(|choice| {
            let own = choice.laws.iter().filter(|law| {
                let mut paths = input.paths.iter();
                paths.any(|path| path.starts_with(&format!("{}.", law.path)))
            });
            own.map(|law| (id(&choice.path), law.id.clone()))
                .collect::<Vec<_>>()
        });
        let no: String = laws
            .map(|(box_, law)| format!(":not(:has(#{box_} option[value=\"{law}\"]:checked))"))
            .collect();
        if !no.is_empty() {
            let field = id(input.name);
            css += &format!(
                "form{no} .unused-{field}{{display:block}}form{no} #{field}{{opacity:.55}}"
            );
        }
    }
    css
}

fn section(node: &Node) -> usize {
    let path = match node {
        Node::Field(field) => &field.path,
        Node::Choice(choice) => &choice.path,
        Node::Group(path, ..) => path,
    };
    let own = SECTIONS
        .iter()
        .position(|(_, keys)| keys.contains(&path.as_str()));
    own.unwrap_or(SECTIONS.len() - 1)
}

/// The id of the element of a field.
fn id(name: &str) -> String {
    let safe = |c: char| if c.is_ascii_alphanumeric() { c } else { '-' };
    format!("f-{}", name.chars().map(safe).collect::<String>())
}

struct Writer<'a> {
    filled: Filled<'a>,
}

impl Writer<'_> {
    fn problems<'s>(&'s self, name: &'s str) -> impl Iterator<Item = &'s Problem> {
        let own = |problem: &&Problem| problem.field.as_deref() == Some(name);
        self.filled.problems.iter().filter(own)
    }

    /// What is wrong, where it is of no field that is shown.
    fn summary(&self, form: &Form) -> String {
        let fields = form.fields(true);
        let choices = form.choices();
        let shown = |name: &str| {
            fields.iter().any(|field| field.name == name)
                || choices.iter().any(|choice| choice.path == name)
                || name == MORE
                || name.starts_with(STEP)
        };
        let items: String = self
            .filled
            .problems
            .iter()
            .filter(|problem| !problem.field.as_deref().is_some_and(shown))
            .map(|problem| format!("<li>{}</li>", sentence(problem)))
            .collect();
        format!("<ul class=\"errors\" role=\"alert\">{items}</ul>\n")
    }

    fn section(&self, title: &str, inner: &str) -> String {
        let open = if inner.contains("aria-invalid") {
            " open"
        } else {
            ""
        };
        format!(
            "<details class=\"part\" id=\"{}\"{open}><summary>{title}</summary>\n{inner}</details>\n",
            id(title)
        )
    }

    /// One of the five.
    fn input(&self, form: &Form, input: &Input) -> String {
        let chosen = form.fields(true);
        let held = chosen.iter().find(|field| field.name == input.name);
        let fields = form.fields(false);
        let Some(field) = held.or(fields.iter().find(|field| field.name == input.name)) else {
            return String::new();
        };
        let value = match held {
            Some(held) => held.value.clone(),
            None => input.recommended.to_string(),
        };
        let unit = match input.unit {
            "" => String::new(),
            unit => format!("{unit}; "),
        };
        let element = id(input.name);
        let used = match input.paths.iter().all(|path| !path.contains('.')) {
            true => String::new(),
            false => {
                format!("<p class=\"unused unused-{element}\">not used by what is chosen below</p>")
            }
        };
        format!(
            "<div class=\"field\"><label for=\"{element}\">{}</label>{}<p class=\"hint\" id=\"hint-{element}\">{unit}recommended {} by the report, {}</p>{used}{}</div>\n",
            input.label,
            self.number(&field.kind, input.name, &value),
            input.recommended,
            input.range,
            self.errors(input.name)
        )
    }

    fn node(&self, node: &Node) -> String {
        match node {
            Node::Field(field) => self.field(field),
            Node::Choice(choice) => self.choice(choice),
            Node::Group(path, meaning, nodes) => {
                let inner: String = nodes.iter().map(|node| self.node(node)).collect();
                // the choices of a group say themselves what they are
                if nodes.iter().all(|node| matches!(node, Node::Choice(_))) {
                    return inner;
                }
                format!(
                    "<fieldset><legend>{}</legend><p class=\"hint\">{}</p>{inner}</fieldset>\n",
                    escape(path),
                    inline(meaning)
                )
            }
        }
    }

    fn choice(&self, choice: &Choice) -> String {
        let word = |id: &str| match id {
            GIVEN => "as given here".to_owned(),
            other => other.replace('-', " "),
        };
        let option = |id: &str| {
            let selected = if id == choice.chosen { " selected" } else { "" };
            format!("<option value=\"{id}\"{selected}>{}</option>", word(id))
        };
        let laws: String = choice.laws.iter().map(|law| option(&law.id)).collect();
        let element = id(&choice.path);
        let panels: String = choice
            .laws
            .iter()
            .map(|law| self.law(choice, law))
            .collect();
        format!(
            "<fieldset><legend class=\"sr\">{label}</legend><div class=\"field\"><label for=\"{element}\">{label}</label>\
             <select id=\"{element}\" name=\"{path}\" {describe}>{none}{laws}</select>\
             <p class=\"hint\" id=\"hint-{element}\">{meaning}</p>{errors}</div>{panels}</fieldset>\n",
            label = escape(&choice.label),
            path = choice.path,
            describe = self.described(&choice.path),
            none = option(NONE),
            meaning = inline(&choice.meaning),
            errors = self.errors(&choice.path),
        )
    }

    fn law(&self, choice: &Choice, law: &Law) -> String {
        let inner: String = law.nodes.iter().map(|node| self.node(node)).collect();
        let what = match law.id.as_str() {
            GIVEN => String::new(),
            _ => format!("<p class=\"hint\">{}</p>", inline(&law.what)),
        };
        format!(
            "<div class=\"law\" data-law=\"{} {}\">{what}{inner}</div>",
            choice.path, law.id
        )
    }

    fn field(&self, field: &Field) -> String {
        if let Some(input) = FIVE.iter().find(|input| input.name == field.name) {
            return format!(
                "<p class=\"hint above\"><b>{}</b> is <a href=\"#{}\">{}</a> above.</p>",
                escape(&field.label),
                id(input.name),
                input.label
            );
        }
        let element = id(&field.name);
        let value = match (
            &field.value,
            super::proposed(&field.path, self.filled.scene),
        ) {
            (held, Some(proposed)) if held.is_empty() && field.required => super::shown(&proposed),
            (held, _) => held.clone(),
        };
        let control = match &field.kind {
            Kind::Number { .. } => self.number(&field.kind, &field.name, &value),
            Kind::Word(words) => {
                let option = |word: &String| {
                    let selected = if *word == value { " selected" } else { "" };
                    format!("<option{selected}>{}</option>", escape(word))
                };
                let options: String = words.iter().map(option).collect();
                self.element("select", &field.name, "", Some(&options))
            }
            Kind::Flag => {
                let yes = if value == "true" { " selected" } else { "" };
                let options = format!(
                    "<option value=\"off\">no</option><option value=\"on\"{yes}>yes</option>"
                );
                self.element("select", &field.name, "", Some(&options))
            }
            Kind::Rows(_) => self.element(
                "textarea",
                &field.name,
                "rows=\"6\" spellcheck=\"false\"",
                Some(&text_of_area(&value)),
            ),
            Kind::Text | Kind::Numbers(_) => {
                let value = format!(
                    "type=\"text\" autocomplete=\"off\" value=\"{}\"",
                    escape(&value)
                );
                self.element("input", &field.name, &value, None)
            }
        };
        format!(
            "<div class=\"field\"><label for=\"{element}\">{}</label>{control}<p class=\"hint\" id=\"hint-{element}\">{}</p>{}</div>\n",
            escape(&field.label),
            hint(field),
            self.errors(&field.name)
        )
    }

    fn number(&self, kind: &Kind, name: &str, value: &str) -> String {
        let Kind::Number { least, most, whole } = kind else {
            return String::new();
        };
        let bound = |name: &str, bound: &Option<f64>| match bound {
            Some(bound) => format!(" {name}=\"{bound}\""),
            None => String::new(),
        };
        let attributes = format!(
            "type=\"number\" inputmode=\"decimal\" step=\"{}\"{}{} value=\"{}\" autocomplete=\"off\"",
            if *whole { "1" } else { "any" },
            bound("min", least),
            bound("max", most),
            escape(value)
        );
        self.element("input", name, &attributes, None)
    }

    /// One control, with what describes it.
    fn element(&self, tag: &str, name: &str, attributes: &str, inner: Option<&str>) -> String {
        let end = inner.map(|inner| format!("{inner}</{tag}>"));
        format!(
            "<{tag} id=\"{}\" name=\"{}\" {} {attributes}>{}",
            id(name),
            escape(name),
            self.described(name),
            end.unwrap_or_default()
        )
    }

    /// What describes a control, and whether it is wrong.
    fn described(&self, name: &str) -> String {
        let element = id(name);
        match self.problems(name).next() {
            Some(_) => {
                format!("aria-invalid=\"true\" aria-describedby=\"error-{element} hint-{element}\"")
            }
            None => format!("aria-describedby=\"hint-{element}\""),
        }
    }

    fn errors(&self, name: &str) -> String {
        let words: Vec<String> = self.problems(name).map(sentence).collect();
        match words.is_empty() {
            true => String::new(),
            false => format!(
                "<p class=\"error\" id=\"error-{}\">{}</p>",
                id(name),
                words.join(" ")
            ),
        }
    }

    fn engines(&self) -> String {
        let engines = self.filled.engines;
        let mut html = "<fieldset><legend class=\"sr\">Engines to run</legend>\n".to_owned();
        for known in &engines.boxes {
            let element = id(&format!("{ENGINE}-{}", known.spec));
            let reference = known.spec == oracle::engine().id();
            let (ticked, always) = match (reference, known.ticked) {
                // a box that cannot be changed is not sent
                (true, _) => (" checked disabled", " · always runs: the reference"),
                (false, true) => (" checked", ""),
                (false, false) => ("", ""),
            };
            html += &format!(
                "<div class=\"tick\"><input type=\"checkbox\" id=\"{element}\" name=\"{ENGINE}\" value=\"{}\"{ticked} aria-describedby=\"hint-{element}\">\
                 <label for=\"{element}\">{}</label><p class=\"hint\" id=\"hint-{element}\">{}{always}</p></div>\n",
                escape(&known.spec),
                escape(&known.label),
                escape(known.method)
            );
        }
        html += &format!(
            "<input type=\"hidden\" name=\"{ENGINE}\" value=\"{}\">\n",
            oracle::engine().id()
        );
        for step in &engines.steps {
            let name = format!("{STEP}{}", step.engine);
            let kind = Kind::Number {
                least: Some(0.0),
                most: None,
                whole: false,
            };
            html += &self.line(
                &name,
                &format!("step of {}", step.engine),
                &self.number(&kind, &name, &step.value),
                &step.meaning,
            );
        }
        let more = format!(
            "type=\"text\" autocomplete=\"off\" spellcheck=\"false\" placeholder=\"rapier-f64:preset=stock\" value=\"{}\"",
            escape(&engines.more)
        );
        let what =
            "any other engine and setting, as in carom compare --engines; carom engines lists them";
        html += &self.line(
            MORE,
            "more engines",
            &self.element("input", MORE, &more, None),
            what,
        );
        html + "</fieldset>\n"
    }

    fn line(&self, name: &str, label: &str, control: &str, hint: &str) -> String {
        let element = id(name);
        format!(
            "<div class=\"field\"><label for=\"{element}\">{label}</label>{control}<p class=\"hint\" id=\"hint-{element}\">{}</p>{}</div>\n",
            inline(hint),
            self.errors(name)
        )
    }

    /// The scene as a file, which can be changed by hand: balls one by one are only here.
    fn scene_file(&self) -> String {
        let element = id("scene");
        format!(
            "<details class=\"part\" id=\"f-file\"><summary>Scene file</summary>\n<div class=\"field\"><label for=\"{element}\">The scene as a file</label>\
             <textarea id=\"{element}\" name=\"scene\" rows=\"24\" wrap=\"off\" spellcheck=\"false\" autocapitalize=\"off\" {}>{}</textarea>\
             <p class=\"hint\" id=\"hint-{element}\">Balls one by one are only here. What is changed here counts when it is run from here.</p>{}</div>\n\
             <p class=\"go\"><button type=\"submit\" name=\"run\" value=\"file\">Run this file</button></p></details>\n",
            self.described("scene"),
            text_of_area(self.filled.text),
            self.errors("scene")
        )
    }
}

/// Text as it stands in a `textarea`: lines and tabs are part of it.
fn text_of_area(text: &str) -> String {
    let marked = text.replace('&', "&amp;").replace('<', "&lt;");
    // a line break right after the tag is left out by browsers
    match marked.starts_with('\n') {
        true => format!("\n{marked}"),
        false => marked,
    }
}

fn hint(field: &Field) -> String {
    match (field.meaning == field.advice, field.advice.is_empty()) {
        (true, _) | (_, true) => inline(&field.meaning),
        _ => format!("{}; {}", inline(&field.meaning), inline(&field.advice)),
    }
}

/// What is wrong and what would be right.
fn sentence(problem: &Problem) -> String {
    let place = match (problem.line, problem.column) {
        (Some(line), Some(column)) if problem.field.is_none() => format!("{line}:{column}: "),
        _ => String::new(),
    };
    let help = match problem.help.is_empty() {
        true => String::new(),
        false => format!(" <span class=\"help\">{}</span>", inline(&problem.help)),
    };
    format!("{place}{}.{help}", inline(&problem.message))
}

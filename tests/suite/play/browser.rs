//! As much of a browser as it takes to fill in a form: tags, their attributes, and what a form sends.

/// One tag of a page, with the text after it up to the next tag.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tag {
    /// Such as `input`, or `/form`.
    pub name: String,
    /// Attributes with their values; empty for those without.
    pub attributes: Vec<(String, String)>,
    /// Text up to the next tag.
    pub text: String,
}

impl Tag {
    /// The value of an attribute.
    pub fn get(&self, name: &str) -> Option<&str> {
        let own = self.attributes.iter().find(|(known, _)| known == name);
        own.map(|(_, value)| value.as_str())
    }
}

/// The tags of a page, without the contents of scripts and styles.
pub fn tags(html: &str) -> Vec<Tag> {
    let mut tags = Vec::new();
    let mut rest = html;
    while let Some(start) = rest.find('<') {
        rest = &rest[start + 1..];
        let end = rest.find('>').expect("a tag that does not end");
        let (inside, after) = (&rest[..end], &rest[end + 1..]);
        let text = &after[..after.find('<').unwrap_or(after.len())];
        let mut tag = tag(inside);
        tag.text = unescaped(text);
        rest = after;
        for raw in ["script", "style"] {
            if tag.name == raw {
                let close = format!("</{raw}>");
                tag.text = after[..after.find(&close).unwrap()].to_owned();
                rest = &after[tag.text.len()..];
            }
        }
        tags.push(tag);
    }
    tags
}

fn tag(inside: &str) -> Tag {
    let (name, mut rest) = inside.split_once([' ', '\n']).unwrap_or((inside, ""));
    let mut attributes = Vec::new();
    loop {
        rest = rest.trim_start();
        if rest.is_empty() {
            break;
        }
        let end = rest.find([' ', '=']).unwrap_or(rest.len());
        let (key, after) = rest.split_at(end);
        match after.strip_prefix("=\"") {
            Some(value) => {
                let end = value.find('"').expect("a value that does not end");
                attributes.push((key.to_owned(), unescaped(&value[..end])));
                rest = &value[end + 1..];
            }
            None => {
                attributes.push((key.to_owned(), String::new()));
                rest = after;
            }
        }
    }
    Tag {
        name: name.to_owned(),
        attributes,
        text: String::new(),
    }
}

fn unescaped(text: &str) -> String {
    let marks = [
        ("&lt;", "<"),
        ("&gt;", ">"),
        ("&quot;", "\""),
        ("&#39;", "'"),
        ("&amp;", "&"),
    ];
    marks.iter().fold(text.to_owned(), |text, (mark, sign)| {
        text.replace(mark, sign)
    })
}

/// What the form of a shot, or the inside of one, sends when nobody has touched it: name and value pairs in order, without buttons.
pub fn sent(html: &str) -> Vec<(String, String)> {
    let form = html.split("<form id=\"shot\"").last().unwrap_or(html);
    let html = form.split("</form>").next().unwrap_or(form);
    let (mut pairs, mut select) = (Vec::new(), String::new());
    for tag in tags(html) {
        let value = |tag: &Tag| tag.get("value").map(str::to_owned);
        let named = tag.get("name").map(str::to_owned);
        match (tag.name.as_str(), named) {
            ("input", Some(name)) => {
                let ticked = tag.get("type") != Some("checkbox") || tag.get("checked").is_some();
                if ticked && tag.get("disabled").is_none() {
                    pairs.push((name, value(&tag).unwrap_or_default()));
                }
            }
            ("textarea", Some(name)) => {
                let text = tag.text.strip_prefix('\n').unwrap_or(&tag.text);
                pairs.push((name, text.to_owned()));
            }
            ("select", Some(name)) => select = name,
            ("option", _) => {
                let first = !pairs.iter().any(|(name, _)| *name == select);
                let word = value(&tag).unwrap_or(tag.text.clone());
                if first {
                    pairs.push((select.clone(), word));
                } else if tag.get("selected").is_some() {
                    pairs.pop();
                    pairs.push((select.clone(), word));
                }
            }
            _ => {}
        }
    }
    pairs
}

/// Pairs as the body of a form.
pub fn encoded(pairs: &[(String, String)]) -> String {
    let safe = |text: &str| -> String {
        let byte = |byte: u8| match byte {
            b'0'..=b'9' | b'A'..=b'Z' | b'a'..=b'z' | b'-' | b'.' | b'_' => {
                char::from(byte).to_string()
            }
            b' ' => "+".to_owned(),
            other => format!("%{other:02X}"),
        };
        text.bytes().map(byte).collect()
    };
    let pair = |(name, value): &(String, String)| format!("{}={}", safe(name), safe(value));
    pairs.iter().map(pair).collect::<Vec<_>>().join("&")
}

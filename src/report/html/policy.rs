//! What a page may load and run: its own style and its own script, each known by its hash, and nothing from any other place.

use super::super::svg;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use sha2::{Digest, Sha256};
use std::sync::LazyLock;

/// Sheet of the whole site.
const STYLE: &str = include_str!("style.css");
/// Sheet of the replay.
const REPLAY_STYLE: &str = include_str!("../../client/dist/replay.css");
/// Script of the replay.
const REPLAY_SCRIPT: &str = include_str!("../../client/dist/replay.js");

/// What stands in a page before its contents, and after them.
pub struct Shell {
    /// Content of the policy's `meta` element.
    pub policy: String,
    /// The `style` element.
    pub style: String,
    /// The `script` element; empty for a page without a replay.
    pub script: String,
}

/// The shell of a page without a replay, and of one with it: the same for every page of every report.
static SHELLS: LazyLock<[Shell; 2]> = LazyLock::new(|| [Shell::new(""), Shell::new(REPLAY_SCRIPT)]);

impl Shell {
    /// The shell of a page; `plays`: whether it has a replay.
    pub fn of(plays: bool) -> &'static Shell {
        &SHELLS[usize::from(plays)]
    }

    fn new(script: &str) -> Shell {
        let mut style = format!("\n{}", sheet());
        let mut policy = "default-src 'none'".to_owned();
        let mut element = String::new();
        if !script.is_empty() {
            let script = embeddable(script);
            style += REPLAY_STYLE;
            policy += &format!("; script-src '{}'", hash(&script));
            element = format!("<script>{script}</script>\n");
        }
        let style = embeddable(&style);
        policy += &format!(
            "; style-src '{}'; img-src data:; base-uri 'none'; form-action 'none'",
            hash(&style)
        );
        Shell {
            policy,
            style: format!("<style>{style}</style>"),
            script: element,
        }
    }
}

/// The sheet of pages and fragments without a replay.
pub fn sheet() -> String {
    format!("{STYLE}{}", svg::STYLE)
}

/// Text that ends no element and opens no comment, in strings of a script and in a sheet; what a browser reads is what was hashed.
pub fn embeddable(text: &str) -> String {
    text.replace("\r\n", "\n")
        .replace("</script", "<\\/script")
        .replace("</style", "<\\/style")
        .replace("<!--", "<\\!--")
}

/// A script or sheet as a policy names it.
pub fn hash(text: &str) -> String {
    format!(
        "sha256-{}",
        STANDARD.encode(Sha256::digest(text.as_bytes()))
    )
}

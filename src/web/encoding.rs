//! How a scene and the fields of a form travel: percent-encoded pairs, and a scene packed into a link.

use base64::Engine as _;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use miniz_oxide::deflate::compress_to_vec;
use miniz_oxide::inflate::decompress_to_vec_with_limit;

/// Longest scene that a link may unpack to, bytes.
const LARGEST_SCENE: usize = super::wire::LARGEST_BODY;

/// Longest packed scene, characters: what surely fits into a request line, and into what people paste links into.
const LONGEST_LINK: usize = 8 * 1024;

/// How hard a scene is packed, 0 to 10.
const EFFORT: u8 = 9;

/// Name and value pairs in order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Pairs(pub Vec<(String, String)>);

impl Pairs {
    /// The pairs of a query or of the body of a form. Bytes that are no text are replaced.
    pub fn parse(text: &str) -> Self {
        let pairs = text.split('&').filter(|pair| !pair.is_empty());
        let decoded = pairs.map(|pair| {
            let (name, value) = pair.split_once('=').unwrap_or((pair, ""));
            (decoded(name), decoded(value))
        });
        Pairs(decoded.collect())
    }

    /// The last value of a name: what stands later is what a person changed.
    pub fn last(&self, name: &str) -> Option<&str> {
        let named = self.0.iter().rev().find(|(known, _)| known == name);
        named.map(|(_, value)| value.as_str())
    }

    /// Every value of a name.
    pub fn all<'a>(&'a self, name: &'a str) -> impl Iterator<Item = &'a str> {
        let named = self.0.iter().filter(move |(known, _)| known == name);
        named.map(|(_, value)| value.as_str())
    }

    /// Takes every value of a name out, and answers the last of them.
    pub fn take(&mut self, name: &str) -> Option<String> {
        let last = self.last(name).map(str::to_owned);
        self.0.retain(|(known, _)| known != name);
        last
    }
}

fn decoded(text: &str) -> String {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, after @ ..] = rest {
        rest = after;
        let hex = |digit: Option<&u8>| char::from(*digit?).to_digit(16);
        match (first, hex(after.first()), hex(after.get(1))) {
            (b'%', Some(high), Some(low)) => {
                bytes.push((16 * high + low) as u8);
                rest = &after[2..];
            }
            (b'+', ..) => bytes.push(b' '),
            _ => bytes.push(*first),
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// The path and query that carry a whole scene. `None` if it is too long for a link.
///
/// The query and not the fragment, so that the form is filled in before any script runs, and without one; nothing of it is kept
/// anywhere, and the server that reads it is on the same machine.
pub fn link(scene: &str) -> Option<String> {
    let packed = URL_SAFE_NO_PAD.encode(compress_to_vec(scene.as_bytes(), EFFORT));
    (packed.len() <= LONGEST_LINK).then(|| format!("/?toml={packed}"))
}

/// The scene in a link. Errors: why there is none, in one sentence.
pub fn unpacked(packed: &str) -> Result<String, String> {
    let wrong = || "the link is damaged: its scene cannot be unpacked".to_owned();
    let bytes = URL_SAFE_NO_PAD.decode(packed).map_err(|_| wrong())?;
    let text = decompress_to_vec_with_limit(&bytes, LARGEST_SCENE).map_err(|_| wrong())?;
    String::from_utf8(text).map_err(|_| wrong())
}

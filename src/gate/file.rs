//! Accepted findings as a file that diffs well: what it is and why above, one finding a line below.

use super::Row;
use crate::finding::Verdict;
use crate::study::check::{DIGITS, is_digest};
use std::collections::BTreeSet;
use thiserror::Error;

/// The first line: what the file is, and the version of its format.
const TITLE: &str = "# carom accepted findings, format 1";

/// The columns.
const HEADER: [&str; 5] = ["engine", "check", "subject", "value", "verdict"];

/// The accepted findings of one scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Accepted {
    /// Name of the scene.
    pub scene: String,
    /// Fingerprint of the resolved scene: another scene has other findings.
    pub hash: String,
    /// Why they were accepted.
    pub reason: String,
    /// What gave them: names and versions.
    pub versions: Vec<(String, String)>,
    /// Digest of each engine's run, by label: equal ones mean equal bits. They only inform.
    pub bits: Vec<(String, String)>,
    /// The findings.
    pub rows: Vec<Row>,
}

impl Accepted {
    /// The line of a finding in its file, from 1; that of the column names for one that is not there.
    pub fn line(&self, address: [&str; 3]) -> usize {
        // a title, scene, hash and reason, the lists, the column names
        let header = 1 + 3 + self.versions.len() + self.bits.len() + 1;
        let row = self.rows.iter().position(|row| row.address() == address);
        row.map_or(header, |row| header + row + 1)
    }

    /// The version of something; empty where it is not known.
    pub fn version(&self, of: &str) -> &str {
        let own = self.versions.iter().find(|(name, _)| name == of);
        own.map_or("", |(_, version)| version)
    }
}

/// What is wrong with a file, and where.
#[derive(Clone, Debug, PartialEq, Error)]
#[error("line {line}: {why}")]
pub struct Malformed {
    /// Counted from 1.
    pub line: usize,
    /// What is wrong.
    pub why: String,
}

/// The file of accepted findings.
pub fn write(accepted: &Accepted) -> String {
    let mut text = format!("{TITLE}\n");
    let mut entry = |key: &str, value: &str| {
        text += &format!("# {key}: {}\n", one_line(value));
    };
    entry("scene", &accepted.scene);
    entry("hash", &accepted.hash);
    entry("reason", &accepted.reason);
    for (name, version) in &accepted.versions {
        entry(&format!("version of {name}"), version);
    }
    for (engine, digest) in &accepted.bits {
        entry(&format!("bits of {engine}"), digest);
    }
    // writing to memory does not fail, and a table of text is UTF-8
    text + &table(&accepted.rows).unwrap_or_default()
}

/// The column names and one line a finding.
fn table(rows: &[Row]) -> Option<String> {
    let mut sheet = csv::Writer::from_writer(Vec::new());
    sheet.write_record(HEADER).ok()?;
    for row in rows {
        let [engine, check, subject] = row.address().map(one_line);
        let value = row.value.map(shortest).unwrap_or_default();
        let verdict = row.verdict.map_or("", Verdict::id);
        let fields = [&engine[..], &check, &subject, &value, verdict];
        sheet.write_record(fields).ok()?;
    }
    String::from_utf8(sheet.into_inner().ok()?).ok()
}

/// Reads a file of accepted findings; says what is wrong with it, and in which line.
pub fn read(text: &str) -> Result<Accepted, Malformed> {
    let mut lines = text.lines().enumerate().peekable();
    match lines.next() {
        Some((_, TITLE)) => {}
        _ => return Err(wrong(0, format!("expected `{TITLE}`"))),
    }
    let mut accepted = Accepted::default();
    while let Some((line, text)) = lines.next_if(|(_, text)| text.starts_with('#')) {
        entry(text, &mut accepted).map_err(|why| wrong(line, why))?;
    }
    let (at, header) = lines.next().unwrap_or((0, ""));
    if header != HEADER.join(",") {
        return Err(wrong(at, format!("expected `{}`", HEADER.join(","))));
    }
    for (what, value) in [
        ("scene", &accepted.scene),
        ("hash", &accepted.hash),
        ("reason", &accepted.reason),
    ] {
        if value.is_empty() {
            return Err(wrong(at, format!("the lines above lack `# {what}: ...`")));
        }
    }
    let body = text.split_inclusive('\n').skip(at + 1).collect::<String>();
    let mut sheet = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .from_reader(body.as_bytes());
    let mut known = BTreeSet::new();
    for record in sheet.records() {
        let record = record.map_err(|error| wrong(at + 1, error.to_string()))?;
        // its first line in the body, from 1
        let line = at + record.position().map_or(1, |place| place.line() as usize);
        let row = row(&record).map_err(|why| wrong(line, why))?;
        if !known.insert(row.address().map(str::to_owned)) {
            return Err(wrong(
                line,
                format!("{} is listed twice", row.address().join(" ").trim_end()),
            ));
        }
        accepted.rows.push(row);
    }
    if !text.ends_with('\n') {
        return Err(wrong(
            text.lines().count().saturating_sub(1),
            "the file ends within a line".to_owned(),
        ));
    }
    Ok(accepted)
}

fn wrong(line: usize, why: String) -> Malformed {
    Malformed {
        line: line + 1,
        why,
    }
}

/// Reads `# KEY: VALUE`. Errors: what is wrong with it.
fn entry(text: &str, accepted: &mut Accepted) -> Result<(), String> {
    let entry = text.trim_start_matches("# ").split_once(": ");
    let (key, value) = entry.ok_or("expected `# KEY: VALUE`")?;
    let named = |list: &mut Vec<(String, String)>, name: &str| {
        if list.iter().any(|(of, _)| of == name) {
            return Err(format!("`{key}` is listed twice"));
        }
        list.push((name.to_owned(), value.to_owned()));
        Ok(())
    };
    match (
        key.strip_prefix("version of "),
        key.strip_prefix("bits of "),
    ) {
        (Some(name), _) => named(&mut accepted.versions, name),
        (None, Some(_)) if !is_digest(value) => Err(format!(
            "`{value}` is no digest: expected {DIGITS} hexadecimal digits"
        )),
        (None, Some(engine)) => named(&mut accepted.bits, engine),
        (None, None) => {
            let entry = match key {
                "scene" => &mut accepted.scene,
                "hash" => &mut accepted.hash,
                "reason" => &mut accepted.reason,
                other => return Err(format!("unknown entry `{other}`")),
            };
            if !entry.is_empty() {
                return Err(format!("`{key}` is listed twice"));
            }
            *entry = value.to_owned();
            Ok(())
        }
    }
}

fn row(record: &csv::StringRecord) -> Result<Row, String> {
    let fields: Vec<&str> = record.iter().collect();
    if fields.iter().any(|field| field.contains('\n')) {
        return Err("a quote is not closed".to_owned());
    }
    let [engine, check, subject, value, verdict] = fields[..] else {
        return Err(format!(
            "expected {} fields, not {}",
            HEADER.len(),
            fields.len()
        ));
    };
    let value = match value {
        "" => None,
        text => Some(
            text.parse()
                .map_err(|_| format!("`{text}` is not a number"))?,
        ),
    };
    let verdict = match verdict {
        "" => None,
        id => Some(Verdict::find(id).ok_or_else(|| {
            let known = Verdict::ALL.map(Verdict::id).join(", ");
            format!("`{id}` is no verdict; there are {known}")
        })?),
    };
    if engine.is_empty() || check.is_empty() {
        return Err("a finding needs an engine and a check".to_owned());
    }
    Ok(Row {
        engine: engine.to_owned(),
        check: check.to_owned(),
        subject: subject.to_owned(),
        value,
        verdict,
    })
}

/// The shortest decimal that reads back to the bit.
fn shortest(x: f64) -> String {
    format!("{x:?}")
}

/// Words without line breaks.
fn one_line(words: &str) -> String {
    words.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::{Accepted, read, write};
    use crate::finding::Verdict;
    use crate::gate::Row;

    fn accepted() -> Accepted {
        let row = |engine: &str, value, verdict| Row {
            engine: engine.to_owned(),
            check: "overlap".to_owned(),
            subject: "1-2".to_owned(),
            value,
            verdict,
        };
        Accepted {
            scene: "cradle".to_owned(),
            hash: "0123".to_owned(),
            reason: "first: as measured".to_owned(),
            bits: vec![("exact".to_owned(), "00ff00ff00ff00ff".to_owned())],
            versions: vec![("rapier-f64".to_owned(), "some name 0.36.1".to_owned())],
            rows: vec![
                row("exact", Some(0.1 + 0.2), Some(Verdict::Holds)),
                row("a | b, \"c\"", Some(5e-324), Some(Verdict::CannotExpress)),
                row("stepper dt=1e-3", None, None),
                row("rapier-f64", Some(f64::INFINITY), Some(Verdict::Breaks)),
            ],
        }
    }

    #[test]
    fn what_is_written_reads_back_to_the_bit() {
        let text = write(&accepted());
        assert_eq!(read(&text).unwrap(), accepted());
        assert_eq!(write(&read(&text).unwrap()), text);
    }

    #[test]
    fn a_finding_is_found_in_its_line() {
        let accepted = accepted();
        let text = write(&accepted);
        assert!(!accepted.rows.is_empty());
        for row in &accepted.rows {
            let line = text.lines().nth(accepted.line(row.address()) - 1).unwrap();
            assert!(line.contains(&row.check), "{row:?}: {line}");
        }
        let columns = accepted.line(["nobody", "", ""]);
        assert_eq!(
            text.lines().nth(columns - 1),
            Some(&super::HEADER.join(",")[..])
        );
    }

    #[test]
    fn a_malformed_file_names_its_line() {
        let good = write(&accepted());
        let header = good.lines().position(|l| l.starts_with("engine,")).unwrap();
        for (old, new, line, why) in [
            ("format 1", "format 2", 1, "expected `# carom"),
            ("# hash: 0123\n", "# hash\n", 3, "KEY: VALUE"),
            ("# hash:", "# hush:", 3, "unknown entry `hush`"),
            (
                "# reason: first: as measured\n",
                "",
                header,
                "lack `# reason",
            ),
            (
                "# hash: 0123\n",
                "# hash: 0123\n# hash: 0123\n",
                4,
                "`hash` is listed twice",
            ),
            ("00ff00ff00ff00ff", "00ff", 6, "no digest"),
            ("00ff00ff00ff00ff", "00FF00FF00FF00FF", 6, "no digest"),
            (
                "# bits of exact: 00ff00ff00ff00ff\n",
                "# bits of exact: 00ff00ff00ff00ff\n# bits of exact: 00ff00ff00ff00ff\n",
                7,
                "`bits of exact` is listed twice",
            ),
            (
                "engine,check",
                "engine,cheque",
                header + 1,
                "expected `engine",
            ),
            ("holds", "passes", header + 2, "no verdict"),
            ("5e-324", "five", header + 3, "not a number"),
            ("1-2,,\n", "1-2,,,\n", header + 4, "5 fields, not 6"),
            ("\"a | b", "a | b", header + 3, "5 fields, not 6"),
            ("c\"\"\"", "c\"\"", header + 3, "a quote is not closed"),
            (
                "rapier-f64,overlap",
                "exact,overlap",
                header + 5,
                "listed twice",
            ),
            (
                "rapier-f64,overlap",
                ",overlap",
                header + 5,
                "needs an engine",
            ),
            (
                "inf,breaks\n",
                "inf,breaks",
                header + 5,
                "ends within a line",
            ),
        ] {
            assert_eq!(good.matches(old).count(), 1, "{old}");
            let error = read(&good.replace(old, new)).unwrap_err();
            assert_eq!(error.line, line, "{new}: {error}");
            assert!(error.to_string().contains(why), "{new}: {error}");
        }
    }

    #[test]
    fn half_a_file_is_no_file() {
        let text = write(&accepted());
        let whole_lines: Vec<usize> = text.match_indices('\n').map(|(at, _)| at + 1).collect();
        let header = text.lines().position(|l| l.starts_with("engine,")).unwrap();
        let header_ends = whole_lines[header];
        for cut in 0..text.len() {
            let half = read(&text[..cut]);
            // a file cut between two lines below its heading is a shorter file: its missing findings appear in the diff
            let is_shorter = cut >= header_ends && whole_lines.contains(&cut);
            assert_eq!(half.is_ok(), is_shorter, "cut at {cut}: {half:?}");
        }
    }
}

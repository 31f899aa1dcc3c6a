//! The one diff: what of two lists of findings is not the same.

use super::Row;
use crate::finding::{Tolerance, Verdict};
use std::collections::BTreeMap;

/// One finding that is not as it was.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// How it changed.
    pub kind: Kind,
    /// As it was; `None` for one that appeared.
    pub old: Option<Row>,
    /// As it is; `None` for one that vanished.
    pub new: Option<Row>,
    /// How far the number may move, in its unit; `None` where it is not a number that moved.
    pub bound: Option<f64>,
}

/// How a finding changed. Each fails: an improvement that nobody explained as well.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// The verdict is worse.
    Worse,
    /// The verdict is better.
    Better,
    /// The number left its tolerance.
    Moved,
    /// It is no longer found.
    Vanished,
    /// It was not there.
    Appeared,
}

impl Kind {
    /// One word.
    pub fn id(self) -> &'static str {
        match self {
            Kind::Worse => "worse",
            Kind::Better => "better",
            Kind::Moved => "moved",
            Kind::Vanished => "vanished",
            Kind::Appeared => "appeared",
        }
    }
}

impl Change {
    /// The row by which it is named: as it is, or as it was.
    pub fn row(&self) -> Option<&Row> {
        self.new.as_ref().or(self.old.as_ref())
    }
}

/// Everything in which `new` differs from `old`, in the order of `new`; what vanished comes last.
///
/// `tolerance`: by how much the number of a row may move. A row with a verdict that changed is one change, whatever its number does.
pub fn diff(old: &[Row], new: &[Row], tolerance: impl Fn(&Row) -> Tolerance) -> Vec<Change> {
    let mut left: BTreeMap<[&str; 3], &Row> = old.iter().map(|row| (row.address(), row)).collect();
    let mut changes = Vec::new();
    for row in new {
        let change = match left.remove(&row.address()) {
            None => Some((Kind::Appeared, None)),
            Some(before) => moved(before, row, tolerance(row))
                .map(|(kind, bound)| (kind, Some((before.clone(), bound)))),
        };
        let Some((kind, before)) = change else {
            continue;
        };
        let (old, bound) = before.map_or((None, None), |(row, bound)| (Some(row), bound));
        changes.push(Change {
            kind,
            old,
            new: Some(row.clone()),
            bound,
        });
    }
    let vanished = old
        .iter()
        .filter(|row| left.get(&row.address()).is_some_and(|own| own == row));
    changes.extend(vanished.map(|row| Change {
        kind: Kind::Vanished,
        old: Some(row.clone()),
        new: None,
        bound: None,
    }));
    changes
}

/// How a row moved, and the bound that it left; `None` if it did not.
fn moved(old: &Row, new: &Row, tolerance: Tolerance) -> Option<(Kind, Option<f64>)> {
    if old.verdict != new.verdict {
        let rank = |verdict: Option<Verdict>| verdict.map_or(0, |v| v as u8 + 1);
        let worse = rank(new.verdict) > rank(old.verdict);
        return Some((if worse { Kind::Worse } else { Kind::Better }, None));
    }
    match (old.value, new.value) {
        (None, None) => None,
        (Some(a), Some(b)) if tolerance.holds(a, b) => None,
        (Some(a), Some(b)) => Some((Kind::Moved, Some(tolerance.bound(a, b)))),
        (None, Some(_)) | (Some(_), None) => Some((Kind::Moved, None)),
    }
}

#[cfg(test)]
mod tests {
    use super::{Kind, diff};
    use crate::finding::{Tolerance, Verdict};
    use crate::gate::Row;

    fn row(check: &str, value: f64, verdict: Verdict) -> Row {
        Row {
            engine: "exact".to_owned(),
            check: check.to_owned(),
            subject: String::new(),
            value: Some(value),
            verdict: Some(verdict),
        }
    }

    fn kinds(old: &[Row], new: &[Row]) -> Vec<Kind> {
        let changes = diff(old, new, |_| Tolerance::Absolute(1e-3));
        changes.iter().map(|change| change.kind).collect()
    }

    #[test]
    fn what_stays_within_its_tolerance_is_no_change() {
        let old = [row("overlap", 0.5, Verdict::Drifts)];
        assert_eq!(kinds(&old, &old), []);
        assert_eq!(kinds(&old, &[row("overlap", 0.5009, Verdict::Drifts)]), []);
    }

    #[test]
    fn every_kind_of_change_is_told_and_an_improvement_is_one() {
        let old = [row("overlap", 0.5, Verdict::Drifts)];
        let changed = |value, verdict| kinds(&old, &[row("overlap", value, verdict)]);
        assert_eq!(changed(0.502, Verdict::Drifts), [Kind::Moved]);
        assert_eq!(changed(0.498, Verdict::Drifts), [Kind::Moved]);
        assert_eq!(changed(0.5, Verdict::Breaks), [Kind::Worse]);
        assert_eq!(changed(0.5, Verdict::Holds), [Kind::Better]);
        let other = [row("momentum", 0.0, Verdict::Holds)];
        assert_eq!(kinds(&old, &other), [Kind::Appeared, Kind::Vanished]);
        assert_eq!(kinds(&old, &[]), [Kind::Vanished]);
        let mut empty = row("overlap", 0.5, Verdict::Drifts);
        empty.value = None;
        assert_eq!(kinds(&old, &[empty.clone()]), [Kind::Moved]);
        assert_eq!(kinds(&[empty], &old), [Kind::Moved]);
    }
}

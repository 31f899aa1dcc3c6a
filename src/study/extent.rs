//! How much of a plan was done before the user asked to stop, and what is said of it: one sentence, the same in every study.

/// Parts of a plan, and how many of them were done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Extent {
    /// Parts that were done; what was cut short is none of them.
    pub done: u64,
    /// Parts that were to be done.
    pub planned: u64,
}

impl Extent {
    /// `done` parts of `planned`.
    pub fn of(done: u64, planned: u64) -> Self {
        Extent { done, planned }
    }

    /// Counts one more part.
    pub fn count(&mut self, done: bool) {
        self.planned += 1;
        self.done += u64::from(done);
    }

    /// Counts the parts of another plan as well.
    pub fn add(&mut self, other: Extent) {
        self.done += other.done;
        self.planned += other.planned;
    }

    /// True where the user asked to stop before everything was done. A request that came after that stopped nothing.
    pub fn is_cut_short(self) -> bool {
        self.done < self.planned
    }

    /// What stands before everything else in whatever is printed or written; `None` where everything was done.
    ///
    /// `what`: the parts and what became of them, such as `samples were run in every engine`.
    pub fn stopped_early(self, what: &str) -> Option<String> {
        if !self.is_cut_short() {
            return None;
        }
        Some(match self.done {
            0 => format!("This was stopped early: none of {} {what}.", self.planned),
            done => format!(
                "This was stopped early: {done} of {} {what}, and what follows concludes from them alone.",
                self.planned
            ),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Extent;

    #[test]
    fn only_what_lacks_a_part_was_stopped_early() {
        let mut extent = Extent::default();
        assert_eq!(
            Extent::of(0, 2)
                .stopped_early("runs came to their end")
                .as_deref(),
            Some("This was stopped early: none of 2 runs came to their end.")
        );
        assert_eq!(extent.stopped_early("runs came to their end"), None);
        extent.count(true);
        assert!(!extent.is_cut_short());
        extent.count(false);
        extent.add(Extent::of(3, 4));
        assert_eq!(
            extent.stopped_early("runs came to their end").as_deref(),
            Some(
                "This was stopped early: 4 of 6 runs came to their end, and what follows concludes from them alone."
            )
        );
    }
}

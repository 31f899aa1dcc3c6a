//! What a run may count of its work: deterministic, so that a change of the counts is a change of the program.

/// One kind of work; its id is the key in `run.json`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Counter {
    /// Steps that were taken.
    Steps,
    /// Substeps of all steps.
    Substeps,
    /// Impulses of contacts, those below rounding as well: one a pair and step.
    Contacts,
    /// Exchanges that changed a velocity, of all contacts.
    Exchanges,
    /// Changes of a ball's velocity in a step that neither contacts nor the cloth explain: sleep and caps; 0 otherwise.
    Unattributed,
    /// Pairs that overlapped, one a pair and step.
    Overlaps,
    /// Most steps for which one pair overlapped without a break.
    LongestOverlap,
    /// Pairs that overlapped in the last step.
    OverlapsAtEnd,
    /// Events of an engine that solves for them.
    Events,
    /// Impacts of two balls.
    BallBall,
    /// Impacts on cushions.
    BallCushion,
    /// Times that a ball entered another cell of the plane.
    CellCrossings,
    /// Times that the plane was divided into cells.
    CellLayouts,
    /// Searches for the first root of a contact.
    RootCalls,
    /// Times that a scalar with more digits took over, until impacts that shrink were over.
    Handovers,
    /// Bits of the scalar in which the run was decided.
    Bits,
}

impl Counter {
    /// Every counter.
    pub const ALL: [Counter; 16] = [
        Counter::Steps,
        Counter::Substeps,
        Counter::Contacts,
        Counter::Exchanges,
        Counter::Unattributed,
        Counter::Overlaps,
        Counter::LongestOverlap,
        Counter::OverlapsAtEnd,
        Counter::Events,
        Counter::BallBall,
        Counter::BallCushion,
        Counter::CellCrossings,
        Counter::CellLayouts,
        Counter::RootCalls,
        Counter::Handovers,
        Counter::Bits,
    ];

    /// Its key.
    pub fn id(self) -> &'static str {
        match self {
            Counter::Steps => "steps",
            Counter::Substeps => "substeps",
            Counter::Contacts => "contacts",
            Counter::Exchanges => "exchanges",
            Counter::Unattributed => "unattributed",
            Counter::Overlaps => "overlaps",
            Counter::LongestOverlap => "longest_overlap_steps",
            Counter::OverlapsAtEnd => "pairs_overlapping_at_end",
            Counter::Events => "events",
            Counter::BallBall => "ball_ball",
            Counter::BallCushion => "ball_cushion",
            Counter::CellCrossings => "cell_crossings",
            Counter::CellLayouts => "cell_layouts",
            Counter::RootCalls => "root_calls",
            Counter::Handovers => "handovers",
            Counter::Bits => "bits",
        }
    }

    /// What it counts, in a few words.
    pub fn what(self) -> &'static str {
        match self {
            Counter::Steps => "steps that were taken",
            Counter::Substeps => "substeps of all steps",
            Counter::Contacts => {
                "impulses of contacts, one a pair and step, those below rounding as well"
            }
            Counter::Exchanges => "exchanges that changed a velocity, of all contacts",
            Counter::Unattributed => {
                "changes of a ball's velocity in a step that neither contacts nor the cloth explain: sleep and caps"
            }
            Counter::Overlaps => "pairs that overlapped, one a pair and step",
            Counter::LongestOverlap => "most steps for which one pair overlapped without a break",
            Counter::OverlapsAtEnd => "pairs that overlapped in the last step",
            Counter::Events => "events that were solved for",
            Counter::BallBall => "impacts of two balls",
            Counter::BallCushion => "impacts on cushions",
            Counter::CellCrossings => "times that a ball entered another cell of the plane",
            Counter::CellLayouts => "times that the plane was divided into cells",
            Counter::RootCalls => "searches for the first root of a contact",
            Counter::Handovers => {
                "times that a scalar with more digits took over, until impacts that shrink were over"
            }
            Counter::Bits => "bits of the scalar in which the run was decided",
        }
    }
}

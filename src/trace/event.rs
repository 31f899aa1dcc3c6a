//! What happened, when, to whom.

use crate::physics::Side;

/// One row of `events.csv`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// s, non-decreasing along a trace.
    pub time: f64,
    /// What happened to which balls (indices in scene order).
    pub kind: EventKind,
    /// How often velocities were exchanged in this contact episode: 1 for an ordinary hit, `None` where nothing is exchanged.
    pub exchanges: Option<u64>,
}

/// What happened to which balls. Balls are indices in scene order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EventKind {
    /// Two balls met; the first index is the smaller one.
    BallBall(u32, u32),
    /// A ball met a cushion.
    BallCushion(u32, Side),
    /// A ball's centre came to rest.
    Stop(u32),
    /// A sliding ball began to roll.
    SlideToRoll(u32),
    /// Spin about the vertical axis ended.
    SpinEnd(u32),
    /// A ball left play in pocket number ...
    Pocket(u32, u32),
    /// A ball came to press on another or on a cushion, or to move alongside it; the ball is the smaller one.
    ContactBegin(u32, Partner),
    /// Such a contact ended: nothing holds the two together any more.
    ContactEnd(u32, Partner),
}

/// What a ball is in contact with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Partner {
    /// A ball, by its index in scene order.
    Ball(u32),
    /// A cushion.
    Cushion(Side),
}

impl Partner {
    fn ball(self) -> Option<usize> {
        match self {
            Partner::Ball(ball) => Some(ball as usize),
            Partner::Cushion(_) => None,
        }
    }
}

impl EventKind {
    /// A meeting of two balls, in scene order.
    pub fn ball_ball(a: usize, b: usize) -> Self {
        EventKind::BallBall(a.min(b) as u32, a.max(b) as u32)
    }

    /// Name of the kind in files.
    pub fn id(self) -> &'static str {
        match self {
            EventKind::BallBall(..) => "ball-ball",
            EventKind::BallCushion(..) => "ball-cushion",
            EventKind::Stop(_) => "stop",
            EventKind::SlideToRoll(_) => "slide-to-roll",
            EventKind::SpinEnd(_) => "spin-end",
            EventKind::Pocket(..) => "pocket",
            EventKind::ContactBegin(..) => "contact-begin",
            EventKind::ContactEnd(..) => "contact-end",
        }
    }

    /// True for the events that make up the collision order: ball-ball and ball-cushion.
    pub fn is_collision(self) -> bool {
        matches!(self, EventKind::BallBall(..) | EventKind::BallCushion(..))
    }

    /// The balls that take part: one or two.
    pub fn balls(self) -> (usize, Option<usize>) {
        match self {
            EventKind::BallBall(a, b) => (a as usize, Some(b as usize)),
            EventKind::ContactBegin(a, partner) | EventKind::ContactEnd(a, partner) => {
                (a as usize, partner.ball())
            }
            EventKind::BallCushion(a, _)
            | EventKind::Stop(a)
            | EventKind::SlideToRoll(a)
            | EventKind::SpinEnd(a)
            | EventKind::Pocket(a, _) => (a as usize, None),
        }
    }

    /// The balls involved, one after the other.
    pub fn each_ball(self) -> impl Iterator<Item = usize> {
        let (a, b) = self.balls();
        [Some(a), b].into_iter().flatten()
    }

    /// True when both events involve a common ball.
    pub fn shares_ball(self, other: EventKind) -> bool {
        let ((a, b), (c, d)) = (self.balls(), other.balls());
        a == c || Some(a) == d || b == Some(c) || (b.is_some() && b == d)
    }

    /// Both parties by name, as in files: ball ids, `x0` ... for cushions, `p0` ... for pockets, empty for none.
    pub fn parties<'a>(self, id: impl Fn(usize) -> &'a str) -> (String, String) {
        let (a, b) = self.balls();
        let other = match self {
            EventKind::BallCushion(_, side)
            | EventKind::ContactBegin(_, Partner::Cushion(side))
            | EventKind::ContactEnd(_, Partner::Cushion(side)) => side.id().to_owned(),
            EventKind::Pocket(_, pocket) => format!("p{pocket}"),
            _ => b.map(|b| id(b).to_owned()).unwrap_or_default(),
        };
        (id(a).to_owned(), other)
    }
}

//! From numbers to places on the paper: ranges and axes, linear and logarithmic. Any finite input is safe.

/// The smallest and largest of the numbers seen so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    pub lo: f64,
    pub hi: f64,
}

impl Extent {
    /// Nothing seen.
    pub const NONE: Extent = Extent {
        lo: f64::INFINITY,
        hi: f64::NEG_INFINITY,
    };

    /// Takes in one number; NaN and infinities are not numbers to draw.
    pub fn add(&mut self, x: f64) {
        if x.is_finite() {
            self.lo = self.lo.min(x);
            self.hi = self.hi.max(x);
        }
    }

    /// True when no number was seen.
    pub fn is_empty(&self) -> bool {
        self.lo > self.hi
    }

    /// Half the distance between the ends, which never overflows.
    pub fn half(&self) -> f64 {
        self.hi * 0.5 - self.lo * 0.5
    }

    /// The range, at least `half` to both sides of its middle.
    pub fn at_least(self, half: f64) -> Extent {
        if self.half() >= half {
            return self;
        }
        let middle = self.lo * 0.5 + self.hi * 0.5;
        Extent {
            lo: (middle - half).max(-f64::MAX),
            hi: (middle + half).min(f64::MAX),
        }
    }

    /// A range with some distance between its ends, widened by `share` of it on both sides.
    pub fn widened(self, share: f64) -> Extent {
        if self.is_empty() {
            return Extent { lo: 0.0, hi: 1.0 };
        }
        let largest = self.lo.abs().max(self.hi.abs());
        // closer together than this, ticks could not be told apart
        let more = if self.half() <= 1e-9 * largest || largest < f64::MIN_POSITIVE {
            if largest < 1e-300 { 1.0 } else { 0.1 * largest }
        } else {
            2.0 * share * self.half()
        };
        Extent {
            lo: (self.lo - more).max(-f64::MAX),
            hi: (self.hi + more).min(f64::MAX),
        }
    }
}

/// One axis on the paper.
#[derive(Clone, Copy, Debug)]
pub struct Scale {
    /// Ends of the axis; of the decimal logarithm where it is logarithmic.
    pub range: Extent,
    /// True where the axis is logarithmic.
    pub log: bool,
    /// Where the small end is, px.
    pub from: f64,
    /// Where the large end is, px.
    pub to: f64,
}

impl Scale {
    /// Where a number is, px; `None` for what this axis cannot show.
    pub fn place(&self, x: f64) -> Option<f64> {
        let x = on_axis(x, self.log)?;
        let share = (x * 0.5 - self.range.lo * 0.5) / self.range.half();
        let place = self.from + share * (self.to - self.from);
        place.is_finite().then_some(place)
    }

    /// Length of the axis, px.
    pub fn length(&self) -> f64 {
        (self.to - self.from).abs()
    }
}

/// The number that an axis is linear in; `None` for what it cannot show.
pub fn on_axis(x: f64, log: bool) -> Option<f64> {
    if !x.is_finite() || (log && x <= 0.0) {
        return None;
    }
    Some(if log { x.log10() } else { x })
}

//! How far an event can be believed.

/// What an engine knows of the certainty of one event. A missing number is `None`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Certainty {
    /// Time from this event to the next other candidate of its balls, s, >= 0: had the event not happened, one of them would
    /// have met something else by then, or the run would have ended. An error of the event times beyond this could change the order.
    /// Infinite without one.
    pub margin: Option<f64>,
    /// Condition number, >= 1: relative speed over its normal part. What an error along the path is multiplied by in a graze.
    pub condition: Option<f64>,
    /// Estimated error of the event's time through all rounding so far, s.
    pub time_error: Option<f64>,
}

impl Certainty {
    /// False if the next candidate lies within the estimated error of the time.
    pub fn is_clear(&self) -> bool {
        match (self.margin, self.time_error) {
            (Some(margin), Some(error)) => margin > error,
            _ => true,
        }
    }
}

//! The price list: the cheapest setting for each error, and the settings that none beats in both error and time.

use super::{CostOutcome, Point, Quantity};
use crate::math::statistics::Distribution;

/// Errors that prices are given for, in the unit of the quantity.
pub const THRESHOLDS: [f64; 9] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9];

/// Errors from here on are the high accuracy of rankings; those before are the low.
pub const HIGH_FROM: usize = 3;

/// Differences of errors below this are rounding of the positions in a trace, R.
const ROUNDING: f64 = 1e-12;

/// The least noise of a time that is believed, relative.
const LEAST_NOISE: f64 = 0.01;

/// Part of the cells whose noise is below what is called the noise of a study.
const MOST_CELLS: f64 = 0.9;

/// One setting on offer.
#[derive(Clone, Copy, Debug)]
pub struct Offer<'a> {
    /// The setting.
    pub point: &'a Point,
    /// Its error, mean over the starts.
    pub error: f64,
    /// Its time, s.
    pub seconds: f64,
}

impl Offer<'_> {
    /// The engine's id.
    pub fn engine(&self) -> &str {
        self.point.level.column.engine.id()
    }
}

/// Every setting that has an error and a time, in the order of the families.
pub fn offers(outcome: &CostOutcome, quantity: Quantity) -> Vec<Offer<'_>> {
    let points = outcome
        .families
        .iter()
        .flat_map(|measured| &measured.points);
    points
        .filter_map(|point| {
            Some(Offer {
                point,
                error: point.error(quantity).filter(|error| error.is_finite())?,
                seconds: point.seconds()?,
            })
        })
        .collect()
}

/// The cheapest offer whose error is `error` or less; the first of equals.
pub fn cheapest<'a>(offers: impl IntoIterator<Item = Offer<'a>>, error: f64) -> Option<Offer<'a>> {
    let good = offers.into_iter().filter(|offer| offer.error <= error);
    good.min_by(|a, b| a.seconds.total_cmp(&b.seconds))
}

/// The Pareto front: offers that no other beats in error without taking longer, from the largest error to the smallest.
///
/// `noise`: times that differ by less, relative, are equal, so that a front is the same from run to run: an offer is beaten by
/// one that is as good and faster by more than the noise, or better and not slower by more than it.
pub fn front<'a>(offers: &[Offer<'a>], noise: f64) -> Vec<Offer<'a>> {
    let much_faster = |a: &Offer<'_>, b: &Offer<'_>| a.seconds * (1.0 + noise) < b.seconds;
    let better = |a: &Offer<'_>, b: &Offer<'_>| a.error + ROUNDING < b.error;
    let beats = |a: &Offer<'_>, b: &Offer<'_>| {
        (!better(b, a) && much_faster(a, b)) || (better(a, b) && !much_faster(b, a))
    };
    let mut front: Vec<Offer<'a>> = offers
        .iter()
        .filter(|offer| !offers.iter().any(|other| beats(other, offer)))
        .copied()
        .collect();
    front.sort_by(|a, b| {
        b.error
            .total_cmp(&a.error)
            .then(a.seconds.total_cmp(&b.seconds))
    });
    front
}

/// What times of this study are good to, relative: nine in ten cells have less noise.
pub fn noise(outcome: &CostOutcome) -> f64 {
    let points = outcome
        .families
        .iter()
        .flat_map(|measured| &measured.points);
    let noises = points.filter_map(|point| point.timed.as_ref()?.noise);
    Distribution::of(noises).map_or(LEAST_NOISE, |all| all.quantile(MOST_CELLS).max(LEAST_NOISE))
}

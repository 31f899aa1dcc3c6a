//! What was stopped before its end: no study concludes from part of a run, the program says so first and exits with 130, and every exit
//! code means what it is said to mean.

mod exits;
mod interrupted;
mod studies;
mod writers;

use carom::study::Watch;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Words that stand in the first line of what was stopped.
const STOPPED: &str = "stopped early";

/// What `work` makes of a watch whose user asks to stop when progress is told for the `k`th time, or before all if `k` is 0.
fn stopped_after<T>(k: usize, work: impl FnOnce(Watch<'_>) -> T) -> T {
    let (stop, told) = (AtomicBool::new(k == 0), AtomicUsize::new(0));
    let progress = |_: usize, _: usize, _: &str| {
        if told.fetch_add(1, Ordering::Relaxed) + 1 == k {
            stop.store(true, Ordering::Relaxed);
        }
    };
    work(Watch {
        progress: &progress,
        cancelled: &stop,
    })
}

/// How often progress is told while `work` runs to its end.
fn moments<T>(work: impl FnOnce(Watch<'_>) -> T) -> usize {
    let (never, told) = (AtomicBool::new(false), AtomicUsize::new(0));
    let progress = |_: usize, _: usize, _: &str| {
        told.fetch_add(1, Ordering::Relaxed);
    };
    work(Watch {
        progress: &progress,
        cancelled: &never,
    });
    told.into_inner()
}

/// What `work` makes of a watch whose user never asks to stop.
fn undisturbed<T>(work: impl FnOnce(Watch<'_>) -> T) -> T {
    stopped_after(usize::MAX, work)
}

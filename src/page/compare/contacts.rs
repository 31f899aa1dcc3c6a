//! Why an engine is off by the end of a contact that lasts, in words.

use super::scale::Scale;
use crate::study::compare::{ContactStanding, MOSTLY, OwnError};

/// What leaves more than this part of an error is not told as a part of its cause.
const MERELY: f64 = 0.75;

/// Where the error at the end comes from, in one sentence; empty where that was not asked.
pub fn why(standing: &ContactStanding, scale: &Scale) -> String {
    let Some(own) = &standing.own else {
        let words = match standing.is_short && standing.error_at_end.is_some() {
            true => "from before it: it is over before a step is",
            false => "",
        };
        return words.to_owned();
    };
    let of_itself = sentence(own, scale);
    match standing.error_at_end {
        Some(error) if own.error * MOSTLY <= error => {
            format!("mostly from before it; its own: {of_itself}")
        }
        _ => of_itself,
    }
}

/// What the error is made of, in one sentence: what was tried, what it left, and what else there is.
fn sentence(own: &OwnError, scale: &Scale) -> String {
    let besides = match own.alone.filter(|alone| alone * MOSTLY >= own.error) {
        Some(alone) => format!("a ball that meets nothing is off by {}", scale.words(alone)),
        None => match own.exchanges {
            0 => "no exchange in place of a force".to_owned(),
            1 => "1 exchange in place of a force".to_owned(),
            n => format!("{n} exchanges in place of a force"),
        },
    };
    let tried = || own.ablations.iter();
    let cure = tried().find(|ablated| ablated.explains(own.error));
    let least = || tried().min_by(|a, b| a.error.total_cmp(&b.error));
    let Some(best) = cure.or_else(least) else {
        return besides;
    };
    let what = &best.what;
    let left = format!("{} with {}", scale.words(best.error), best.setting);
    if best.explains(own.error) {
        format!("{what}: {left}")
    } else if best.error <= own.error * MERELY {
        format!("in part {what}: {left}; {besides}")
    } else {
        let tried: Vec<&str> = own.ablations.iter().map(|a| &*a.what).collect();
        format!("not {}: {left}; {besides}", tried.join(" or "))
    }
}

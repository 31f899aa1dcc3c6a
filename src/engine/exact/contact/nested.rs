//! Accumulations of several encounters together: balls that knock on others which are themselves pressed, or knock, in between.
//!
//! Between two knocks of one encounter the others run through whole accumulations of their own, so the sequence of knocks cannot be followed in
//! closed form as that of one encounter can. It shrinks all the same by one ratio, in speed and in time, because near the limit every cycle is the one before on a
//! smaller scale. So it is told by that: three ratios in a row equal, of approaches and of intervals, with the same encounters in each cycle. The
//! limit is then that of the geometric sequence of states, whose error is of second order in the approach at which it is left.

use crate::engine::exact::predict::Encounter;
use crate::engine::exact::spin::Moving;
use crate::math::Real;

/// Knocks that are remembered.
const REMEMBERED: usize = 512;

/// Cycles back to which an encounter belongs to the ones of now.
const CYCLES: usize = 2;

/// Two ratios are equal within this part.
const EQUAL: f64 = 1e-3;

/// A ratio nearer to 1 would be extrapolated too far for what is known of it.
const SLOWEST: f64 = 0.95;

/// Ratios that must be equal.
const RATIOS: usize = 3;

/// One slow impact.
#[derive(Clone, Debug)]
struct Knock<T> {
    time: T,
    closing: T,
    encounter: Encounter,
    /// Whether another encounter of these balls came before it.
    first: bool,
    /// How the balls move that took part lately.
    states: Vec<(usize, Moving<T>)>,
}

/// Where knocks lead together.
#[derive(Clone, Debug)]
pub struct Together<T> {
    /// When, s.
    pub time: T,
    /// Balls with how they move then.
    pub states: Vec<(usize, Moving<T>)>,
    /// The encounters of a cycle.
    pub encounters: Vec<Encounter>,
}

/// The slow impacts of late.
#[derive(Clone, Debug)]
pub struct Knocks<T> {
    knocks: Vec<Knock<T>>,
}

fn balls_of(encounter: Encounter) -> impl Iterator<Item = usize> {
    let (a, b) = match encounter {
        Encounter::Pair(a, b) => (a, Some(b)),
        Encounter::Cushion(a, _) => (a, None),
    };
    std::iter::once(a).chain(b)
}

impl<T: Real> Knocks<T> {
    /// No impacts yet.
    pub fn new() -> Self {
        Knocks { knocks: Vec::new() }
    }

    /// Notes an impact at `now`, s, with this approach, length/s; answers where it leads if it is one of a shrinking cycle of several encounters.
    pub fn observe(
        &mut self,
        now: T,
        encounter: Encounter,
        closing: T,
        state: impl Fn(usize) -> Moving<T>,
    ) -> Option<Together<T>> {
        if self.knocks.len() >= REMEMBERED {
            self.knocks.drain(..REMEMBERED / 2);
        }
        let own = self.knocks.iter().rev();
        let own = own.filter(|knock| knock.encounter == encounter && knock.first);
        let since = own.map(|knock| knock.time).nth(CYCLES - 1);
        let (balls, encounters) = self.connected(encounter, since.unwrap_or_else(T::zero));
        let before = self.knocks.iter().rev();
        let mut before = before.filter(|knock| encounters.contains(&knock.encounter));
        let first = before
            .next()
            .is_some_and(|knock| knock.encounter != encounter);
        self.knocks.push(Knock {
            time: now,
            closing,
            encounter,
            first,
            states: balls.iter().map(|ball| (*ball, state(*ball))).collect(),
        });
        if first && encounters.len() > 1 {
            self.limit(encounter, &encounters)
        } else {
            None
        }
    }

    /// The balls and encounters that are connected to one by what knocked since a time, s.
    fn connected(&self, encounter: Encounter, since: T) -> (Vec<usize>, Vec<Encounter>) {
        let mut balls: Vec<usize> = balls_of(encounter).collect();
        let mut encounters = vec![encounter];
        loop {
            let before = encounters.len();
            for knock in self.knocks.iter().filter(|knock| knock.time >= since) {
                let touches = balls_of(knock.encounter).any(|ball| balls.contains(&ball));
                if touches && !encounters.contains(&knock.encounter) {
                    encounters.push(knock.encounter);
                    for ball in balls_of(knock.encounter) {
                        if !balls.contains(&ball) {
                            balls.push(ball);
                        }
                    }
                }
            }
            if encounters.len() == before {
                balls.sort_unstable();
                return (balls, encounters);
            }
        }
    }

    /// Forgets everything: balls have gone on from where it led.
    pub fn clear(&mut self) {
        self.knocks.clear();
    }

    fn limit(&self, encounter: Encounter, encounters: &[Encounter]) -> Option<Together<T>> {
        let cycle = self.knocks.iter().rev();
        let cycle = cycle.filter(|knock| knock.encounter == encounter && knock.first);
        let cycle: Vec<&Knock<T>> = cycle.take(RATIOS + 2).collect();
        let [last, before, ..] = cycle.as_slice() else {
            return None;
        };
        if cycle.len() < RATIOS + 2 {
            return None;
        }
        let approaches = cycle
            .windows(2)
            .map(|pair| pair[0].closing / pair[1].closing);
        let approaches: Vec<T> = approaches.collect();
        let intervals: Vec<T> = cycle
            .windows(2)
            .map(|pair| pair[0].time - pair[1].time)
            .collect();
        let intervals = intervals.windows(2).map(|pair| pair[0] / pair[1]);
        let intervals: Vec<T> = intervals.take(RATIOS).collect();
        let ratio = approaches[0];
        let near = |other: &T| (*other - ratio).abs() <= ratio * T::lift(EQUAL);
        if ratio >= T::lift(SLOWEST)
            || !approaches[..RATIOS].iter().all(near)
            || !intervals.iter().all(near)
        {
            return None;
        }
        let rest = ratio / (T::one() - ratio);
        let states = last.states.iter().map(|(ball, now)| {
            let (_, then) = before.states.iter().find(|(other, _)| other == ball)?;
            let on = |now: T, then: T| now + (now - then) * rest;
            let moving = Moving {
                position: [0, 1].map(|i| on(now.position[i], then.position[i])),
                velocity: [0, 1].map(|i| on(now.velocity[i], then.velocity[i])),
                spin: [0, 1, 2].map(|i| on(now.spin[i], then.spin[i])),
            };
            Some((*ball, moving))
        });
        Some(Together {
            time: last.time + (last.time - before.time) * rest,
            states: states.collect::<Option<Vec<_>>>()?,
            encounters: encounters.to_vec(),
        })
    }
}

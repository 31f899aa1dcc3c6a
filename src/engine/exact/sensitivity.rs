//! What a run depends on: its growth, and the derivative of where every ball ends by each input.

use super::derived::{Found, LANES, PARTS, Seeds, Task, holds_balls};
use super::rerun::follow;
use super::spin::Moving;
use super::tangent::{Replay, Rough, Script};
use crate::engine::Limits;
use crate::math::{Dual, Real};
use crate::physics::{Contact, Cushion, Pockets};
use crate::scene::Scene;
use crate::trace::Trace;
use nalgebra::DMatrix;
use num_traits::Zero;

pub use super::derived::{Lost, Why};

/// Tangent maps are kept up to so many numbers at once; for more the run is taken again.
const KEPT: usize = 1 << 23;

/// Those of a ball that does not turn.
const PLANE: usize = 4;

/// Growth is not computed for more balls than this: it takes a matrix of four or seven rows and columns a ball, and its singular
/// values at every event.
pub const MOST_BALLS: usize = 64;

/// By how much a perturbation has grown.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Growth {
    /// Largest singular value of the tangent map from time 0 to just after each event, in the order of the events. Lengths are in
    /// R, speeds in the largest initial speed, spins in that over R. Shorter than the events if one of them has no derivative, or the
    /// user asked to stop.
    pub factors: Vec<f64>,
    /// The first event without a derivative.
    pub rough: Option<usize>,
    /// Balls that have none from an event on, where the others go on: the factors from there on are those of the others.
    pub lost: Vec<Lost>,
    /// Whether the run with derivatives went another way than the trace, at event `rough`.
    pub differs: bool,
}

impl Growth {
    /// The factor after the last event that has one; 1 where nothing happened.
    pub fn last(&self) -> f64 {
        self.factors.last().copied().unwrap_or(1.0)
    }
}

/// Growth of perturbations along a trace of the exact engine; `None` for more balls than [`MOST_BALLS`].
///
/// `whole`: at every event; else only after the last one.
pub fn growth(scene: &Scene, trace: &Trace, whole: bool, limits: &Limits<'_>) -> Option<Growth> {
    let balls = scene.balls.len();
    if balls > MOST_BALLS {
        return None;
    }
    let unit = units(scene);
    // a ball that rests on a cloth stays where it is when its velocity is changed by little
    let slides =
        |ball: usize| scene.effects.cloth.is_none() || scene.balls[ball].state.speed() > 0.0;
    let parts = if scene.effects.rotates() {
        PARTS
    } else {
        PLANE
    };
    let coordinates = |ball: usize| {
        (0..parts)
            .map(move |part| (ball, part))
            .filter(move |(_, part)| *part < 2 || slides(ball))
    };
    let columns: Vec<(usize, usize)> = (0..balls).flat_map(coordinates).collect();
    if holds_balls(trace, ulp(trace)) {
        return growth_through_contacts(scene, trace, whole, limits, &columns);
    }
    let script = Script::new(scene, trace);
    let effects = scene.effects.lift();
    let mut batches: Vec<Replay<'_, LANES>> = columns
        .chunks(LANES)
        .map(|chunk| {
            Replay::new(&script, &effects, |ball, moving| {
                for (lane, (of, part)) in chunk.iter().enumerate() {
                    if *of == ball {
                        moving.part(*part).partials[lane] = unit[*part];
                    }
                }
            })
        })
        .collect();
    let mut growth = Growth::default();
    for (index, event) in trace.events.iter().enumerate() {
        if limits.is_cancelled() {
            break;
        }
        for replay in &mut batches {
            if let Some(Err(Rough { index })) = replay.step() {
                growth.rough = Some(index);
            }
        }
        if growth.rough.is_some() {
            break;
        }
        if whole || index + 1 == trace.events.len() {
            let map = tangent_map(&batches, [parts, columns.len()], event.time, unit);
            growth.factors.push(map.singular_values().max());
        }
    }
    Some(growth)
}

/// Growth along a trace in which balls stay in contact; `columns`: the ball and the part of each input.
fn growth_through_contacts(
    scene: &Scene,
    trace: &Trace,
    whole: bool,
    limits: &Limits<'_>,
    columns: &[(usize, usize)],
) -> Option<Growth> {
    let (unit, events, balls) = (units(scene), trace.events.len(), scene.balls.len());
    let each = columns.len().div_ceil(LANES) * balls * PARTS * LANES;
    let at_once = (KEPT / each.max(1)).max(1);
    let mut growth = Growth::default();
    let mut from = if whole { 0 } else { events.saturating_sub(1) };
    while from < events && !limits.is_cancelled() {
        let until = events.min(from + at_once);
        let batches = columns.chunks(LANES).map(|chunk| {
            let seeds = chunk.iter().enumerate();
            let seeds = Seeds {
                start: seeds
                    .map(|(lane, (ball, part))| (*ball, *part, lane, unit[*part]))
                    .collect(),
                ..Seeds::default()
            };
            let task = Task::Maps {
                range: from..until,
                found: Vec::new(),
            };
            follow(scene, trace, ulp(trace), seeds, task, limits)
        });
        let batches: Vec<Found> = batches.collect::<Option<_>>()?;
        growth.lost = lost(&batches, balls);
        let same = batches.iter().map(|found| found.same).min().unwrap_or(0);
        for event in from..until {
            if event >= same || limits.is_cancelled() {
                growth.rough = Some(event);
                growth.differs = event >= same;
                break;
            }
            let maps: Vec<&[f64]> = batches.iter().filter_map(|b| b.map(event - from)).collect();
            if maps.len() < batches.len() {
                growth.rough = Some(event);
                growth.differs = true;
                break;
            }
            let goes_on = |ball: &usize| {
                let gone = growth.lost.iter().find(|lost| lost.ball == *ball);
                gone.is_none_or(|lost| lost.event > event)
            };
            let rows: Vec<usize> = (0..balls).filter(goes_on).collect();
            if rows.is_empty() {
                break;
            }
            growth
                .factors
                .push(largest_stretch(&maps, &rows, columns.len(), unit));
        }
        if growth.rough.is_some() {
            break;
        }
        from = until;
    }
    let first = growth.lost.iter().map(|lost| lost.event).min();
    growth.rough = growth.rough.into_iter().chain(first).min();
    Some(growth)
}

/// The balls that are lost in any lane, from the first on in which they are.
fn lost(batches: &[Found], balls: usize) -> Vec<Lost> {
    let all = batches
        .iter()
        .flat_map(|found| (0..LANES).flat_map(|lane| found.lost(lane)));
    let all: Vec<Lost> = all.collect();
    let first = |ball: usize| {
        let own = all.iter().filter(|lost| lost.ball == ball);
        own.min_by_key(|lost| lost.event).copied()
    };
    (0..balls).filter_map(first).collect()
}

/// The largest singular value of the map to these balls.
fn largest_stretch(maps: &[&[f64]], balls: &[usize], columns: usize, unit: [f64; PARTS]) -> f64 {
    let entry = |row: usize, column: usize| {
        let (ball, part) = (balls[row / PARTS], row % PARTS);
        let place = (ball * PARTS + part) * LANES + column % LANES;
        maps[column / LANES][place] / unit[part]
    };
    let map = DMatrix::from_fn(PARTS * balls.len(), columns, entry);
    // which would never end
    if map.iter().any(|x| !x.is_finite()) {
        return f64::NAN;
    }
    map.singular_values().max()
}

/// The spacing of the numbers of a run; f64 where it does not say.
fn ulp(trace: &Trace) -> f64 {
    match trace.provenance.ulp {
        0.0 => f64::EPSILON,
        ulp => ulp,
    }
}

/// Units of the coordinates of a ball: R, the largest initial speed, and that over R.
fn units(scene: &Scene) -> [f64; PARTS] {
    let length = scene.smallest_radius();
    let speed = match scene.largest_speed() {
        0.0 => 1.0,
        speed => speed,
    };
    std::array::from_fn(|part| match part {
        0 | 1 => length,
        2 | 3 => speed,
        _ => speed / length,
    })
}

/// The tangent map from time 0 to `t`: `parts` rows a ball, one column an input.
fn tangent_map(
    batches: &[Replay<'_, LANES>],
    [parts, columns]: [usize; 2],
    t: f64,
    unit: [f64; PARTS],
) -> DMatrix<f64> {
    let mut states: Vec<Vec<Moving<Dual<f64, LANES>>>> =
        batches.iter().map(|batch| batch.states_at(t)).collect();
    let balls = states.first().map_or(0, Vec::len);
    DMatrix::from_fn(parts * balls, columns, |row, column| {
        let (ball, part) = (row / parts, row % parts);
        let moving = &mut states[column / LANES][ball];
        moving.part(part).partials[column % LANES] / unit[part]
    })
}

/// Something that a person sets and never sets exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    /// Direction of the cue ball.
    Aim,
    /// Speed of the cue ball.
    Speed,
    /// A number of an effect, by its key.
    Effect(&'static str),
    /// Restitution of ball-ball impacts.
    BallRestitution,
    /// Restitution of cushions.
    CushionRestitution,
}

impl Input {
    /// Name for people.
    pub fn name(self) -> &'static str {
        match self {
            Input::Aim => "aim",
            Input::Speed => "speed",
            Input::Effect(key) => key.strip_prefix("cloth.translational.").unwrap_or(key),
            Input::BallRestitution => "restitution of balls",
            Input::CushionRestitution => "restitution of cushions",
        }
    }

    /// The change by which inputs are compared, in words: about what a good player or a good measurement leaves open.
    pub fn change(self) -> &'static str {
        match self {
            Input::Aim => "0.1 degree",
            Input::Speed | Input::Effect(_) => "1 %",
            Input::BallRestitution | Input::CushionRestitution => "0.01",
        }
    }

    /// Unit of a derivative of a length in R.
    pub fn unit(self) -> &'static str {
        match self {
            Input::Aim => "R/rad",
            Input::Speed
            | Input::Effect(_)
            | Input::BallRestitution
            | Input::CushionRestitution => "R",
        }
    }

    /// That change in the unit of the derivative: rad for the aim, a part of itself for speed and effects.
    fn size(self) -> f64 {
        match self {
            Input::Aim => 0.1_f64.to_radians(),
            Input::Speed
            | Input::Effect(_)
            | Input::BallRestitution
            | Input::CushionRestitution => 0.01,
        }
    }
}

/// How far one input moves the balls.
#[derive(Clone, Debug, PartialEq)]
pub struct Influence {
    /// The input.
    pub input: Input,
    /// Derivative of every position, length: by rad for the aim, by a relative change for speed and effects, by the number itself
    /// for a restitution. NaN of a ball that has none.
    pub derivative: Vec<[f64; 2]>,
    /// The balls that have none, and why.
    pub lost: Vec<Lost>,
}

impl Influence {
    /// The ball that the change of [`Input::change`] moves farthest, and how far at first order, length.
    pub fn largest(&self) -> Option<(usize, f64)> {
        let moved = |(ball, d): (usize, &[f64; 2])| (ball, d[0].hypot(d[1]) * self.input.size());
        self.derivative
            .iter()
            .enumerate()
            .map(moved)
            .filter(|(_, far)| !far.is_nan())
            .fold(None, |most, next| match most {
                Some((_, farthest)) if farthest >= next.1 => most,
                _ => Some(next),
            })
    }

    /// How far the change of [`Input::change`] moves ball `ball` at first order, length.
    pub fn moves(&self, ball: usize) -> f64 {
        let [x, y] = self.derivative[ball];
        x.hypot(y) * self.input.size()
    }
}

/// The derivative of every position at time `until`, s, or at the end of the run if that is earlier, by each input that the scene has.
///
/// Empty if an event before then has no derivative, unless balls stay in contact in the run (then the balls that it leaves without one say so), or the run
/// ended before without coming to an end that the scene asks for; and where the user asked to stop.
pub fn influences(scene: &Scene, trace: &Trace, until: f64, limits: &Limits<'_>) -> Vec<Influence> {
    if !trace.ending.is_complete() && until > trace.end_time {
        return Vec::new();
    }
    let inputs = inputs(scene);
    if holds_balls(trace, ulp(trace)) {
        return influences_through_contacts(scene, trace, until, limits, &inputs);
    }
    let script = Script::new(scene, trace);
    let lane = |input: Input| inputs.iter().position(|known| *known == input);
    let seeded = |input: Input, slope: f64| {
        let mut seed = Dual::<f64, LANES>::zero();
        if let Some(partial) = lane(input).and_then(|lane| seed.partials.get_mut(lane)) {
            *partial = slope;
        }
        seed
    };
    let effects = scene
        .effects
        .map(|key, value| Dual::lift(value) + seeded(Input::Effect(key), value));
    let cue = scene.cue_ball();
    let mut replay = Replay::new(&script, &effects, |ball, moving| {
        if ball == cue {
            let [vx, vy] = moving.velocity.map(|v| v.value);
            let [wx, wy, wz] = moving.spin.map(|w| w.value);
            // the whole motion turns about the vertical, or grows
            moving.velocity[0] += seeded(Input::Aim, -vy) + seeded(Input::Speed, vx);
            moving.velocity[1] += seeded(Input::Aim, vx) + seeded(Input::Speed, vy);
            moving.spin[0] += seeded(Input::Aim, -wy) + seeded(Input::Speed, wx);
            moving.spin[1] += seeded(Input::Aim, wx) + seeded(Input::Speed, wy);
            moving.spin[2] += seeded(Input::Speed, wz);
        }
    });
    replay.restitution =
        [Input::BallRestitution, Input::CushionRestitution].map(|e| seeded(e, 1.0));
    for _ in trace.events.iter().take_while(|event| event.time < until) {
        if limits.is_cancelled() || !matches!(replay.step(), Some(Ok(_))) {
            return Vec::new();
        }
    }
    let ends = replay.states_at(trace.end_time.min(until));
    let places = ends.iter();
    let places: Vec<_> = places.map(|m| m.position.map(|x| x.partials)).collect();
    by_lane(&inputs, &places, |_| Vec::new())
}

/// What each input does, by the lane of its place. `places`: derivatives of where each ball ends, length.
fn by_lane(
    inputs: &[Input],
    places: &[[[f64; LANES]; 2]],
    lost: impl Fn(usize) -> Vec<Lost>,
) -> Vec<Influence> {
    let of = |lane: usize| places.iter().map(|p| p.map(|x| x[lane])).collect();
    let influence = |(lane, input): (usize, &Input)| Influence {
        input: *input,
        derivative: of(lane),
        lost: lost(lane),
    };
    let lanes = inputs.iter().take(LANES).enumerate();
    lanes.map(influence).collect()
}

/// The same for a trace in which balls stay in contact: those that have no derivative say so, and the others have theirs.
fn influences_through_contacts(
    scene: &Scene,
    trace: &Trace,
    until: f64,
    limits: &Limits<'_>,
    inputs: &[Input],
) -> Vec<Influence> {
    let mut seeds = Seeds::default();
    let cue = scene.cue_ball();
    let state = Moving::<f64>::lifted(
        &trace.paths[cue]
            .state_at(0.0)
            .unwrap_or(scene.balls[cue].state),
    );
    let ([vx, vy], [wx, wy, wz]) = (state.velocity, state.spin);
    for (lane, input) in inputs.iter().take(LANES).enumerate() {
        let turned: &[(usize, f64)] = match input {
            // the whole motion turns about the vertical, or grows
            Input::Aim => &[(2, -vy), (3, vx), (4, -wy), (5, wx)],
            Input::Speed => &[(2, vx), (3, vy), (4, wx), (5, wy), (6, wz)],
            Input::Effect(key) => {
                scene.effects.map(|of, value| {
                    if of == *key {
                        seeds.effects.push((of, lane, value));
                    }
                });
                &[]
            }
            Input::BallRestitution => {
                seeds.restitution[0] = Some(lane);
                &[]
            }
            Input::CushionRestitution => {
                seeds.restitution[1] = Some(lane);
                &[]
            }
        };
        let turned = turned
            .iter()
            .map(|(part, slope)| (cue, *part, lane, *slope));
        seeds.start.extend(turned);
    }
    let found = follow(scene, trace, ulp(trace), seeds, Task::Places(until), limits);
    let due = trace
        .events
        .iter()
        .take_while(|event| event.time < until)
        .count();
    let Some(found) = found.filter(|found| found.same >= due && !limits.is_cancelled()) else {
        return Vec::new();
    };
    by_lane(inputs, &found.places, |lane| found.lost(lane))
}

/// The inputs that a scene has: a cue ball that moves, numbers of its effects, and the impacts that it calls for.
fn inputs(scene: &Scene) -> Vec<Input> {
    let mut inputs = Vec::new();
    if scene.balls[scene.cue_ball()].state.speed() > 0.0 {
        inputs.extend([Input::Aim, Input::Speed]);
    }
    scene.effects.map(|key, _| {
        // where pockets are moves no ball
        if !key.starts_with(Pockets::<f64>::ID) {
            inputs.push(Input::Effect(key));
        }
    });
    // a law with losses has a number for it
    if let Some(Contact::Elastic {}) = scene.effects.contact {
        inputs.push(Input::BallRestitution);
    }
    if let Some(Cushion::Elastic {}) = scene.effects.cushion {
        inputs.push(Input::CushionRestitution);
    }
    inputs
}

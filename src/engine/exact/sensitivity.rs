//! What a run depends on: its growth, and the derivative of where every ball ends by each input.

use super::tangent::{Motion2, Replay, Rough, Script};
use crate::math::{Dual, Real};
use crate::physics::Pockets;
use crate::scene::Scene;
use crate::trace::Trace;
use nalgebra::DMatrix;
use num_traits::Zero;

/// Derivatives that one pass over the events carries.
const LANES: usize = 16;

/// Growth is not computed for more balls than this: it takes a matrix of four rows and columns a ball, and its singular
/// values at every event.
pub const MOST_BALLS: usize = 64;

/// By how much a perturbation has grown.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Growth {
    /// Largest singular value of the tangent map from time 0 to just after each event, in the order of the events. Lengths are in
    /// R, speeds in the largest initial speed. Shorter than the events if one of them has no derivative.
    pub factors: Vec<f64>,
    /// The first event without a derivative.
    pub rough: Option<usize>,
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
pub fn growth(scene: &Scene, trace: &Trace, whole: bool) -> Option<Growth> {
    let balls = scene.balls.len();
    if balls > MOST_BALLS {
        return None;
    }
    let script = Script::new(scene, trace);
    let length = scene.smallest_radius();
    let speed = match scene.largest_speed() {
        0.0 => 1.0,
        speed => speed,
    };
    let unit = [length, speed];
    // a ball that rests on a cloth stays where it is when its velocity is changed by little
    let slides =
        |ball: usize| scene.effects.cloth.is_none() || scene.balls[ball].state.speed() > 0.0;
    let coordinates = |ball: usize| {
        let all = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(of, axis)| (ball, of, axis));
        all.into_iter()
            .filter(move |(_, of, _)| *of == 0 || slides(ball))
    };
    let columns: Vec<(usize, usize, usize)> = (0..balls).flat_map(coordinates).collect();
    let effects = scene.effects.lift();
    let mut batches: Vec<Replay<'_, LANES>> = columns
        .chunks(LANES)
        .map(|chunk| {
            Replay::new(&script, &effects, |ball, motion: &mut Motion2<LANES>| {
                for (lane, (of_ball, of, axis)) in chunk.iter().enumerate() {
                    if *of_ball == ball {
                        motion[*of][*axis].partials[lane] = unit[*of];
                    }
                }
            })
        })
        .collect();
    let mut growth = Growth::default();
    for (index, event) in trace.events.iter().enumerate() {
        for replay in &mut batches {
            if let Some(Err(Rough { index })) = replay.step() {
                growth.rough = Some(index);
            }
        }
        if growth.rough.is_some() {
            break;
        }
        if whole || index + 1 == trace.events.len() {
            let map = tangent_map(&batches, columns.len(), event.time, unit);
            growth.factors.push(map.singular_values().max());
        }
    }
    Some(growth)
}

/// The tangent map from time 0 to `t`: four rows a ball, one column an input.
fn tangent_map(
    batches: &[Replay<'_, LANES>],
    columns: usize,
    t: f64,
    unit: [f64; 2],
) -> DMatrix<f64> {
    let states: Vec<Vec<Motion2<LANES>>> = batches.iter().map(|b| b.states_at(t)).collect();
    let balls = states.first().map_or(0, Vec::len);
    DMatrix::from_fn(4 * balls, columns, |row, column| {
        let (ball, of, axis) = (row / 4, row % 4 / 2, row % 2);
        states[column / LANES][ball][of][axis].partials[column % LANES] / unit[of]
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
            Input::Effect(key) => key.rsplit_once('.').map_or(key, |(_, number)| number),
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
    /// for a restitution.
    pub derivative: Vec<[f64; 2]>,
}

impl Influence {
    /// The ball that the change of [`Input::change`] moves farthest, and how far at first order, length.
    pub fn largest(&self) -> Option<(usize, f64)> {
        let moved = |(ball, d): (usize, &[f64; 2])| (ball, d[0].hypot(d[1]) * self.input.size());
        self.derivative
            .iter()
            .enumerate()
            .map(moved)
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
/// Empty if an event before then has no derivative, or the run ended before without coming to an end that the scene asks for.
pub fn influences(scene: &Scene, trace: &Trace, until: f64) -> Vec<Influence> {
    if !trace.ending.is_complete() && until > trace.end_time {
        return Vec::new();
    }
    let inputs = inputs(scene);
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
    let mut replay = Replay::new(&script, &effects, |ball, motion| {
        if ball == cue {
            let [vx, vy] = motion[1].map(|v| v.value);
            motion[1][0] += seeded(Input::Aim, -vy) + seeded(Input::Speed, vx);
            motion[1][1] += seeded(Input::Aim, vx) + seeded(Input::Speed, vy);
        }
    });
    replay.restitution =
        [Input::BallRestitution, Input::CushionRestitution].map(|e| seeded(e, 1.0));
    for _ in trace.events.iter().take_while(|event| event.time < until) {
        if !matches!(replay.step(), Some(Ok(_))) {
            return Vec::new();
        }
    }
    let ends = replay.states_at(trace.end_time.min(until));
    let influence = |(lane, input): (usize, &Input)| Influence {
        input: *input,
        derivative: ends
            .iter()
            .map(|[position, _]| position.map(|x| x.partials[lane]))
            .collect(),
    };
    inputs
        .iter()
        .take(LANES)
        .enumerate()
        .map(influence)
        .collect()
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
    if scene.effects.contact.is_some() {
        inputs.push(Input::BallRestitution);
    }
    if scene.effects.cushion.is_some() {
        inputs.push(Input::CushionRestitution);
    }
    inputs
}

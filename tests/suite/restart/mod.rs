//! Any state can be a start: what rolls by its digits rolls, a run goes on from a knot of it as it did, a contact is found again from the
//! state alone, and a knot of one engine is a start for the others.

mod contact;
mod engines;
mod exact;
mod rule;

use crate::contact::catalogue;
use crate::references::text;
use carom::engine::{self, Limits, Refusal, Setting};
use carom::physics::Cloth;
use carom::scene::{Scene, parse};
use carom::trace::{Record, Trace};

/// The cases of `validation/references/contact`.
const CASES: [&str; 11] = {
    let mut names = [""; 11];
    let mut i = 0;
    while i < names.len() {
        names[i] = catalogue::CASES[i].1;
        i += 1;
    }
    names
};

fn case(name: &str) -> Scene {
    let toml = format!("{name}.toml");
    let scene = parse(&toml, &text(&format!("contact/{toml}")));
    scene.unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Which side of a jump.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Side {
    Near,
    Far,
}

/// The scene from `time` on, as a trace of it says; balls that have left play are left out. `None` where nothing is left of it.
fn from(scene: &Scene, trace: &Trace, time: f64, side: Side) -> Option<Scene> {
    let mut rest = scene.clone();
    rest.shot = None;
    rest.duration = scene.duration - time;
    for (i, ball) in rest.balls.iter_mut().enumerate() {
        let path = &trace.paths[i];
        let state = match side {
            Side::Near => path.before(time),
            Side::Far => path.state_at(time),
        };
        let state = state.unwrap_or_else(|| panic!("{}: no path", scene.name));
        // engines of three dimensions let a ball sink into the cloth
        (ball.state.position.x, ball.state.position.y) = (state.position.x, state.position.y);
        (ball.state.velocity.x, ball.state.velocity.y) = (state.velocity.x, state.velocity.y);
        ball.state.spin = state.spin;
    }
    for i in (0..rest.balls.len()).rev() {
        if trace.in_play_at(i, time).is_none() {
            rest.balls.remove(i);
        }
    }
    (rest.duration > 0.0 && !rest.balls.is_empty()).then_some(rest)
}

/// Runs a scene in an engine with its default setting; the events of the exact engine are bounded.
fn run(id: &str, scene: &Scene) -> Result<Trace, Refusal> {
    let found = crate::support::find(id).unwrap();
    let run = engine::prepare(found.as_ref(), scene, &Setting::default())?;
    let limits = Limits {
        max_events: 3000,
        ..Limits::NONE
    };
    Ok(run.simulate(Record::Events, &limits))
}

/// The times at which a ball has a knot before the end of the run, at most `most` of them, evenly chosen.
fn knots(trace: &Trace, most: usize) -> Vec<f64> {
    let paths = trace.paths.iter();
    let mut times: Vec<f64> = paths
        .flat_map(|path| path.knots.iter().map(|knot| knot.time))
        .filter(|time| *time < trace.end_time)
        .collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    let stride = times.len().div_ceil(most).max(1);
    times.into_iter().step_by(stride).collect()
}

/// The farthest that a ball ends apart in two runs, length.
fn apart(one: &Trace, other: &Trace) -> f64 {
    let ends = one.paths.iter().zip(&other.paths);
    let apart = ends.map(|(a, b)| (a.last().unwrap().position - b.last().unwrap().position).norm());
    apart.fold(0.0, f64::max)
}

/// What the exact engine's numbers are good to, by its own account (`World`).
struct Grain {
    /// A coordinate, length.
    place: f64,
    /// What that makes of an approach of balls that the cloth presses together, length/s.
    noise: f64,
    /// The largest acceleration by the cloth, length/s^2.
    pull: f64,
}

impl Grain {
    fn of(scene: &Scene) -> Self {
        let pull = match scene.effects.cloth {
            Some(Cloth::Rotational { mu_slide, .. }) => mu_slide * scene.gravity,
            Some(Cloth::Translational { mu }) => mu * scene.gravity,
            None => 0.0,
        };
        let bounded = scene.table.is_some() && scene.effects.cushion.is_some();
        let travel = if bounded {
            0.0
        } else {
            scene.fastest() * scene.duration
        };
        let place = 4.0 * f64::EPSILON * (scene.largest_coordinate() + travel);
        Grain {
            place,
            noise: (2.0 * place * pull).sqrt(),
            pull,
        }
    }

    /// An approach that a limit of impacts leaves out, length/s.
    fn nothing(&self) -> f64 {
        1e-4 * self.noise
    }

    /// An approach below which more digits take over, length/s.
    fn blurs(&self) -> f64 {
        100.0 * self.noise
    }

    /// Whether two balls, or a ball and a cushion, are between two impacts of a series that has a limit.
    fn is_within_limit(&self, scene: &Scene) -> bool {
        let shrinks = |gap: f64, rate: f64| {
            let bounces = rate.abs() > 1e-14 * scene.fastest() && rate.abs() < self.blurs();
            bounces && gap <= self.place + rate * rate / self.pull
        };
        let n = scene.balls.len();
        let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
        let mut pairs = pairs.map(|(i, j)| {
            let (a, b) = (&scene.balls[i].state, &scene.balls[j].state);
            let way = b.position - a.position;
            let gap = way.norm() - scene.contact_distance(i, j);
            (gap, way.dot(&(b.velocity - a.velocity)) / way.norm())
        });
        let walls = scene.effects.cushion.is_some();
        let mut cushions = scene.balls.iter().flat_map(|ball| {
            carom::physics::Side::ALL
                .into_iter()
                .filter_map(move |side| {
                    let (reach, axis) = (scene.reach(side, ball.radius)?, side.axis());
                    let gap = f64::from(side.sign()) * (reach - ball.state.position[axis]);
                    Some((gap, ball.state.velocity[axis]))
                })
        });
        pairs.any(|(gap, rate)| shrinks(gap, rate))
            || walls && cushions.any(|(gap, rate)| shrinks(gap, rate))
    }
}

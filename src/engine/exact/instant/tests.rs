//! Clusters with losses and friction: known answers, the law of a pair, and what holds of any cluster.

use super::super::world::World;
use super::*;
use crate::math::random::Draws;
use crate::math::{DoubleDouble, Octuple};
use crate::physics::{Body, Cloth, Motion, Side, contact};
use crate::scene::Scene;
use nalgebra::Vector3;

/// Radius of all balls, a number without rounding.
const R: f64 = 0.03125;

/// A ball: centre, velocity, spin and mass.
#[derive(Clone, Copy, Debug)]
struct Ball {
    at: [f64; 2],
    velocity: [f64; 2],
    spin: [f64; 3],
    mass: f64,
}

fn ball(at: [f64; 2], velocity: [f64; 2]) -> Ball {
    Ball {
        at,
        velocity,
        spin: [0.0; 3],
        mass: 1.0,
    }
}

/// Laws of balls and cushions.
#[derive(Clone, Copy, Debug)]
struct Laws {
    e: f64,
    friction: Option<Friction>,
    cushion: Option<Cushion>,
}

fn laws(e: f64, mu: f64) -> Laws {
    Laws {
        e,
        friction: (mu > 0.0).then_some(Friction::Constant { mu }),
        cushion: None,
    }
}

const ALCIATORE: Friction = Friction::Alciatore {
    a: 9.951e-3,
    b: 0.108,
    c: 1.088,
    length_in_metres: 1.0,
};

fn world<T: Real>(balls: &[Ball], laws: Laws) -> World<T> {
    let mut scene = Scene::builder("cluster", 1.0)
        .balls_of(R, 1.0)
        .gravity(9.81)
        .cloth(Cloth::Rotational {
            mu_slide: 0.2,
            mu_roll: 0.01,
            mu_spin: 0.0127,
        })
        .contact(Contact::Inelastic { e: laws.e });
    if let Some(friction) = laws.friction {
        scene = scene.friction(friction);
    }
    if let Some(cushion) = laws.cushion {
        scene = scene.table(2.0, 4.0, cushion);
    }
    for (i, ball) in balls.iter().enumerate() {
        scene = scene
            .moving(&i.to_string(), ball.at, ball.velocity)
            .with_mass(ball.mass)
            .with_spin(ball.spin);
    }
    World::new(&scene.unchecked())
}

/// Pairs that touch, and cushions.
fn touches<T: Real>(balls: &[Ball], cushions: bool) -> Vec<Touch<T>> {
    let mut found = Vec::new();
    let lift = |at: [f64; 2]| at.map(T::lift);
    for (a, one) in balls.iter().enumerate() {
        for (b, other) in balls.iter().enumerate().skip(a + 1) {
            let (p, q) = (lift(one.at), lift(other.at));
            let (x, y) = (q[0] - p[0], q[1] - p[1]);
            let apart = (x * x + y * y).sqrt();
            if apart.to_f64() < 2.0 * R + 1e-9 {
                found.push(Touch::Pair(
                    a,
                    b,
                    Vector3::new(x / apart, y / apart, T::zero()),
                ));
            }
        }
        for side in Side::ALL {
            let edges = [[R, R], [2.0 - R, 4.0 - R]];
            let edge = edges[usize::from(side.sign() > 0)][side.axis()];
            if cushions && (one.at[side.axis()] - edge).abs() < 1e-9 {
                found.push(Touch::Cushion(a, side));
            }
        }
    }
    found
}

/// Velocities and spins after, or a reason.
fn resolved<T: Real>(balls: &[Ball], laws: Laws) -> Resolved<T> {
    let world = world::<T>(balls, laws);
    let cluster = Cluster::of(
        &world,
        (0..balls.len()).collect(),
        balls.iter().map(|b| b.velocity.map(T::lift)).collect(),
        balls.iter().map(|b| b.spin.map(T::lift)).collect(),
        touches(balls, laws.cushion.is_some()),
    );
    let found = cluster.resolve();
    found.unwrap_or_else(|| panic!("no end: {balls:?}, {laws:?}"))
}

fn after(balls: &[Ball], laws: Laws) -> Vec<[f64; 2]> {
    resolved::<f64>(balls, laws).velocities
}

/// One ball at speed 1 along x on two that touch.
fn one_on_two() -> Vec<Ball> {
    let x = R * 3.0_f64.sqrt();
    vec![
        ball([0.0, 0.0], [1.0, 0.0]),
        ball([x, R], [0.0, 0.0]),
        ball([x, -R], [0.0, 0.0]),
    ]
}

fn near(got: [f64; 2], want: [f64; 2], tolerance: f64, what: &str) {
    let error = (got[0] - want[0]).hypot(got[1] - want[1]);
    assert!(
        error <= tolerance,
        "{what}: {got:?}, expected {want:?}, off by {error:e}"
    );
}

#[test]
fn a_cradle_keeps_what_the_projection_leaves_and_sends_the_rest_out() {
    let balls: Vec<Ball> = (0..5)
        .map(|i| {
            let speed = if i == 0 { 1.0 } else { 0.0 };
            ball([2.0 * R * f64::from(i), 0.0], [speed, 0.0])
        })
        .collect();
    for e in [1.0, 0.95, 0.8, 0.5, 0.0] {
        // all five together, and one alone
        for (i, got) in after(&balls, laws(e, 0.0)).into_iter().enumerate() {
            let want = (1.0 - e) / 5.0 + if i == 4 { e } else { 0.0 };
            near(
                got,
                [want, 0.0],
                4.0 * f64::EPSILON,
                &format!("e {e}, ball {i}"),
            );
        }
        // in line nothing slips, so that friction has nothing to do
        let rough = after(&balls, laws(e, 0.06));
        assert_eq!(rough, after(&balls, laws(e, 0.0)), "e {e}");
    }
}

#[test]
fn one_ball_on_two_is_the_closed_form_of_the_mix() {
    for e in [1.0, 0.95, 0.8, 0.3, 0.0] {
        // the projection leaves the first 2/5, the others 3/10 along its way; the reflections are twice that less the start
        let want = |v0: f64, v: f64| (1.0 - e) * v0 + e * (2.0 * v0 - v);
        let (ahead, across) = (want(0.3, 0.0), want(0.1 * 3.0_f64.sqrt(), 0.0));
        let got = after(&one_on_two(), laws(e, 0.0));
        for (i, want) in [[want(0.4, 1.0), 0.0], [ahead, across], [ahead, -across]]
            .into_iter()
            .enumerate()
        {
            near(got[i], want, 1e-15, &format!("e {e}, ball {i}"));
        }
    }
    // the table of the convention, to its digits
    let table = [
        (0.95, [-0.17, 0.585, 0.33775], 5e-6),
        (0.8, [-0.08, 0.54, 0.3118], 5e-5),
    ];
    for (e, [cue, ahead, across], digits) in table {
        let got = after(&one_on_two(), laws(e, 0.0));
        near(got[0], [cue, 0.0], digits, "cue");
        near(got[1], [ahead, across], digits, "struck");
    }
}

#[test]
fn friction_on_one_ball_on_two_is_the_path_worked_out_by_hand() {
    // e, cue, struck, impulse of friction: five, four and five digits by hand
    let table = [
        (1.0, -0.19437, [0.5972, 0.3294], 0.01334),
        (0.95, -0.16485, [0.5824, 0.3196], 0.01440),
    ];
    for (e, cue, struck, rubbed) in table {
        let found = resolved::<f64>(&one_on_two(), laws(e, 0.06));
        near(found.velocities[0], [cue, 0.0], 6e-6, "cue");
        near(found.velocities[1], struck, 7e-5, "struck");
        near(
            found.velocities[2],
            [struck[0], -struck[1]],
            7e-5,
            "the other",
        );
        // told by the spin that it gives, 5/2 of it over the radius
        let impulse = (found.spins[1][2] * R * 0.4).abs();
        assert!(
            (impulse - rubbed).abs() <= 6e-6,
            "e {e}: {impulse}, by hand {rubbed}"
        );
    }
}

#[test]
fn friction_on_one_ball_on_two_is_its_closed_form_to_rounding() {
    for (e, mu) in [(1.0, 0.06), (0.95, 0.06), (0.8, 0.03), (0.9, 0.1)] {
        let (n, t) = ([0.75_f64.sqrt(), 0.5], [-0.5, 0.75_f64.sqrt()]);
        let impulse = (1.0 + e) * 0.2 * 3.0_f64.sqrt();
        // by symmetry all is linear in tau while a slip keeps its sign: rates of the speed of the cue ball and of the struck one, and of the
        // closing speed and the slip, under a force f along t on the cue ball
        let rates = |f: f64| {
            let struck = [0, 1].map(|i| impulse * n[i] - f * t[i]);
            let cue = -2.0 * struck[0];
            let closing = cue * n[0] - struck[0] * n[0] - struck[1] * n[1];
            (cue, struck, closing, cue * t[0] + 3.5 * f)
        };
        let goal = n[0] + rates(0.0).2 / 2.0;
        // the surface of the cue ball first slips along -t; as it is stopped the slip ends and turns
        let (cue, struck, closing, slip) = rates(mu * impulse);
        let turns = -t[0] / slip;
        let done = n[0] * turns + closing * turns * turns / 2.0;
        let (cue, struck) = (1.0 + cue * turns, struck.map(|v| v * turns));
        let speed = n[0] + closing * turns;
        let (pull, push, closing, slip) = rates(-mu * impulse);
        assert!(slip > 0.0, "e {e}, mu {mu}: it sticks");
        // closing tau^2 / 2 + speed tau = goal - done, the later root
        let root = (speed * speed + 2.0 * closing * (goal - done)).sqrt();
        let tau = -(speed + root) / closing;
        let got = after(&one_on_two(), laws(e, mu));
        near(
            got[0],
            [cue + pull * tau, 0.0],
            2e-14,
            &format!("cue, e {e}, mu {mu}"),
        );
        let want = [0, 1].map(|i| struck[i] + push[i] * tau);
        near(got[1], want, 2e-14, "struck");
        near(got[2], [want[0], -want[1]], 2e-14, "the other");
    }
}

fn draw(draws: &mut Draws, size: f64) -> f64 {
    draws.between(-size, size)
}

#[test]
fn one_contact_along_the_path_is_the_law_of_a_pair() {
    let mut draws = Draws::new(4, 0);
    let mut stuck = 0;
    for case in 0..400 {
        let angle = draw(&mut draws, 3.0);
        let n = Vector3::new(angle.cos(), angle.sin(), 0.0);
        let turning = if case % 5 == 0 { 0.0 } else { 60.0 };
        let mut body = |speed: f64| Body {
            velocity: Vector3::new(draw(&mut draws, speed), draw(&mut draws, speed), 0.0),
            spin: Vector3::from_fn(|_, _| draw(&mut draws, turning)),
            mass: 1.0 + draw(&mut draws, 0.9),
            radius: R,
        };
        let (first, second) = (body(1.0), body(1.0));
        let closing = (first.velocity - second.velocity).dot(&n);
        if closing <= 0.0 {
            continue;
        }
        let e = draws.between(0.0, 1.0);
        let law = match case % 2 {
            0 => ALCIATORE,
            _ => Friction::Constant {
                mu: draws.between(0.0, 0.4),
            },
        };
        let slip = friction::slip_velocity(&first, &second, &n);
        let reduced = first.mass * second.mass / (first.mass + second.mass);
        let push = Push {
            constraint: Constraint {
                first: (0, [n.x, n.y]),
                second: Some((1, [-n.x, -n.y])),
            },
            impulse: (1.0 + e) * closing * reduced,
            closing: [closing, -e * closing],
            mu: friction::coefficient(law, slip.norm()),
            slip: [slip.y * n.x - slip.x * n.y, slip.z],
        };
        let unit = (first.velocity.amax()).max(R * first.spin.amax() + R * second.spin.amax());
        let mass = [first.mass, second.mass];
        let Some(found) = rub(&[push], &mass, unit.max(second.velocity.amax())) else {
            panic!("case {case} does not end");
        };
        let want = contact::impact(Contact::Inelastic { e }, Some(law), &first, &second, &n);
        let [across, up] = found.tangential[0];
        let tangential = Vector3::new(-n.y * across, n.x * across, up);
        let impulse = n * (-push.impulse * found.part) + tangential;
        let turn = n.cross(&tangential) * 2.5;
        let holds = |got: Motion, want: Motion| {
            let error = (got.velocity - want.velocity).amax();
            let spin = (got.spin - want.spin).amax() * R;
            assert!(
                error <= 4e-14 && spin <= 1e-13,
                "case {case}: {error:e} {spin:e}"
            );
        };
        let moved = |ball: &Body, sign: f64| Motion {
            velocity: ball.velocity + impulse * (sign / ball.mass),
            spin: ball.spin + turn / (ball.mass * R),
        };
        holds(moved(&first, 1.0), want.0);
        holds(moved(&second, -1.0), want.1);
        let left = slip + tangential * (3.5 / reduced);
        stuck += usize::from(left.norm() < 1e-12);
    }
    assert!((20..180).contains(&stuck), "{stuck} stuck");
}

/// Balls that hang together, some at rest, in places of a lattice or not.
fn random_cluster(draws: &mut Draws) -> Vec<Ball> {
    let mut places = vec![[0.0, 0.0]];
    let count = 2 + (draws.bits() % 6) as usize;
    let lattice = draws.uniform() < 0.4;
    while places.len() < count {
        let [x, y] = places[(draws.bits() % places.len() as u64) as usize];
        let angle = if lattice {
            (draws.bits() % 6) as f64 * std::f64::consts::FRAC_PI_3
        } else {
            draws.between(0.0, 7.0)
        };
        let next = [x + 2.0 * R * angle.cos(), y + 2.0 * R * angle.sin()];
        let apart = |p: &[f64; 2]| (p[0] - next[0]).hypot(p[1] - next[1]) > 2.0 * R * (1.0 - 1e-10);
        if places.iter().all(apart) {
            places.push(next);
        }
    }
    let equal = draws.uniform() < 0.5;
    places
        .into_iter()
        .map(|at| {
            let moves = draws.uniform() < 0.5;
            let speed = if moves { 1.0 } else { 0.0 };
            let turning = if draws.uniform() < 0.5 {
                speed / R
            } else {
                0.0
            };
            Ball {
                at,
                velocity: [draw(draws, speed), draw(draws, speed)],
                spin: [0, 1, 2].map(|_| draw(draws, turning)),
                mass: if equal { 1.0 } else { draws.between(0.3, 2.0) },
            }
        })
        .collect()
}

fn random_laws(draws: &mut Draws) -> Laws {
    let e = [1.0, 0.95, 0.5, 0.0][(draws.bits() % 4) as usize];
    let mu = [0.0, 0.02, 0.06, 0.3][(draws.bits() % 4) as usize];
    let friction = match draws.bits() % 4 {
        0 => Some(ALCIATORE),
        _ => (mu > 0.0).then_some(Friction::Constant { mu }),
    };
    Laws {
        e,
        friction,
        cushion: None,
    }
}

/// Kinetic energy does not grow beyond rounding.
fn gains_nothing(balls: &[Ball], found: &Resolved<f64>, what: &str) {
    let velocities: Vec<_> = balls.iter().map(|b| b.velocity).collect();
    let spins: Vec<_> = balls.iter().map(|b| b.spin).collect();
    let start = energy(balls, &velocities, &spins);
    let gained = energy(balls, &found.velocities, &found.spins) - start;
    assert!(
        gained <= 1e-13 * start,
        "{what}: gains {gained:e} of {start}"
    );
}

fn energy(balls: &[Ball], velocities: &[[f64; 2]], spins: &[[f64; 3]]) -> f64 {
    let square = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>();
    let each = balls.iter().zip(velocities.iter().zip(spins));
    each.map(|(ball, (v, w))| 0.5 * ball.mass * (square(v) + 0.4 * R * R * square(w)))
        .sum()
}

#[test]
fn momentum_is_kept_energy_never_grows_and_nothing_approaches() {
    let mut draws = Draws::new(8, 0);
    for case in 0..1500 {
        let balls = random_cluster(&mut draws);
        let laws = random_laws(&mut draws);
        let found = resolved::<f64>(&balls, laws);
        let before: Vec<_> = balls.iter().map(|b| b.velocity).collect();
        gains_nothing(&balls, &found, &format!("case {case}, {laws:?}"));
        for axis in 0..2 {
            let momentum = |v: &[[f64; 2]]| -> f64 {
                balls.iter().zip(v).map(|(b, v)| b.mass * v[axis]).sum()
            };
            let error = momentum(&found.velocities) - momentum(&before);
            assert!(
                error.abs() <= 1e-13,
                "case {case}: momentum changes by {error:e}"
            );
        }
        for touch in touches::<f64>(&balls, false) {
            let Touch::Pair(a, b, n) = touch else {
                continue;
            };
            let v = |i: usize| found.velocities[i];
            let closing = (v(a)[0] - v(b)[0]) * n.x + (v(a)[1] - v(b)[1]) * n.y;
            assert!(
                closing <= 1e-13,
                "case {case}: {a} and {b} approach at {closing:e}"
            );
        }
        // what the contacts did makes up what became of the balls
        let mut sum = before.clone();
        for change in found
            .exchanges
            .iter()
            .flat_map(|exchange| &exchange.changes)
        {
            let [x, y] = sum[change.member];
            sum[change.member] = [x + change.velocity[0], y + change.velocity[1]];
        }
        for (i, got) in sum.into_iter().enumerate() {
            near(
                got,
                found.velocities[i],
                1e-13,
                &format!("case {case}, ball {i}"),
            );
        }
        assert!(found.error <= 1e-11, "case {case}: {:e}", found.error);
    }
}

#[test]
fn mirror_images_and_other_orders_of_the_balls_leave_the_same() {
    let mut draws = Draws::new(9, 0);
    for case in 0..600 {
        let balls = random_cluster(&mut draws);
        let laws = random_laws(&mut draws);
        let found = resolved::<f64>(&balls, laws);
        let mirror: Vec<Ball> = balls
            .iter()
            .map(|b| Ball {
                at: [-b.at[0], b.at[1]],
                velocity: [-b.velocity[0], b.velocity[1]],
                spin: [b.spin[0], -b.spin[1], -b.spin[2]],
                ..*b
            })
            .collect();
        let mirrored = resolved::<f64>(&mirror, laws);
        let reversed: Vec<Ball> = balls.iter().rev().copied().collect();
        let other = resolved::<f64>(&reversed, laws);
        for (i, v) in found.velocities.iter().enumerate() {
            let what = format!("case {case}, ball {i}, {laws:?}");
            let of_mirror = mirrored.velocities[i];
            near([-of_mirror[0], of_mirror[1]], *v, 1e-12, &what);
            near(other.velocities[balls.len() - 1 - i], *v, 1e-12, &what);
            let spin = |w: [f64; 3]| Vector3::from(w) * R;
            let off = spin(other.spins[balls.len() - 1 - i]) - spin(found.spins[i]);
            assert!(off.amax() <= 1e-12, "{what}: spin off by {:e}", off.amax());
            let [x, y, z] = mirrored.spins[i];
            let off = spin([x, -y, -z]) - spin(found.spins[i]);
            assert!(off.amax() <= 1e-12, "{what}: spin off by {:e}", off.amax());
        }
    }
}

#[test]
fn more_digits_give_the_same_within_the_stated_error() {
    let mut draws = Draws::new(10, 0);
    for case in 0..60 {
        let balls = random_cluster(&mut draws);
        let laws = random_laws(&mut draws);
        let found = resolved::<f64>(&balls, laws);
        let finer = resolved::<DoubleDouble>(&balls, laws);
        for (i, v) in finer.velocities.iter().enumerate() {
            let what = format!("case {case}, ball {i}, {laws:?}");
            near(
                found.velocities[i],
                v.map(Real::to_f64),
                2e-13 + found.error,
                &what,
            );
        }
        if case % 30 == 0 {
            let finest = resolved::<Octuple>(&balls, laws);
            for (i, v) in finest.velocities.iter().enumerate() {
                let off = [0, 1]
                    .map(|axis| (v[axis] - finer.velocities[i][axis].widen::<Octuple>()).to_f64());
                near(
                    off,
                    [0.0; 2],
                    1e-27 + finer.error,
                    &format!("case {case}, ball {i}"),
                );
            }
        }
    }
}

/// A ball in the corner at x0, y0 that runs into both cushions.
fn cornered(velocity: [f64; 2], spin: [f64; 3]) -> Ball {
    Ball {
        spin,
        ..ball([R, R], velocity)
    }
}

#[test]
fn a_corner_of_smooth_cushions_is_both_laws_to_the_bit() {
    let v = [-0.3, -1.7];
    for e in [1.0, 0.85, 0.0] {
        let laws = Laws {
            cushion: Some(Cushion::Restitution { e }),
            ..laws(0.95, 0.06)
        };
        let got = after(&[cornered(v, [3.0, -4.0, 5.0])], laws);
        assert_eq!(got[0], v.map(|v| -(e * v)), "e {e}");
    }
}

#[test]
fn a_corner_of_rubbing_cushions_is_the_mean_of_both_orders() {
    let law = Cushion::Han2005 {
        e: 0.85,
        mu: 0.2,
        height: 1.28,
    };
    let laws = Laws {
        cushion: Some(law),
        ..laws(0.95, 0.0)
    };
    let start = cornered([-0.3, -1.7], [3.0, -40.0, 5.0]);
    let in_order = |sides: [Side; 2]| {
        let mut body = Body {
            velocity: Vector3::new(start.velocity[0], start.velocity[1], 0.0),
            spin: start.spin.into(),
            mass: 1.0,
            radius: R,
        };
        for side in sides {
            let motion = crate::physics::cushion::impact(law, &body, side).motion;
            body.velocity = motion.on_cloth().0.velocity;
            body.spin = motion.spin;
        }
        body
    };
    let (one, other) = (
        in_order([Side::X0, Side::Y0]),
        in_order([Side::Y0, Side::X0]),
    );
    assert!(
        (one.velocity - other.velocity).norm() > 1e-3,
        "the order does not matter"
    );
    let found = resolved::<f64>(&[start], laws);
    let mean = (one.velocity + other.velocity) / 2.0;
    near(found.velocities[0], [mean.x, mean.y], 1e-15, "the mean");
    let spin = (one.spin + other.spin) / 2.0;
    assert!((Vector3::from(found.spins[0]) - spin).norm() <= 1e-13);
    // the mirror image in the diagonal of the corner
    let ([vx, vy], [wx, wy, wz]) = (start.velocity, start.spin);
    let image = resolved::<f64>(&[cornered([vy, vx], [-wy, -wx, -wz])], laws);
    let [x, y] = image.velocities[0];
    near([y, x], found.velocities[0], 1e-15, "the mirror image");
}

#[test]
fn a_ball_against_a_cushion_takes_the_smallest_restitution_of_its_contacts() {
    // the reflections send the first back with its speed, the projection stops both
    let balls = [
        ball([3.0 * R, 1.0], [-1.0, 0.0]),
        ball([R, 1.0], [0.0, 0.0]),
    ];
    for (of_balls, of_cushion) in [(0.95, 0.8), (0.7, 0.9), (1.0, 1.0), (0.95, 1.0)] {
        let laws = Laws {
            cushion: Some(Cushion::Restitution { e: of_cushion }),
            ..laws(of_balls, 0.06)
        };
        let got = after(&balls, laws);
        near(
            got[0],
            [f64::min(of_balls, of_cushion), 0.0],
            1e-15,
            "the first",
        );
        near(got[1], [0.0, 0.0], 1e-15, "the second");
    }
}

#[test]
fn clusters_at_cushions_of_every_law_gain_nothing_and_come_apart() {
    let mut draws = Draws::new(12, 0);
    let cushions = [
        Cushion::Elastic {},
        Cushion::Restitution { e: 0.7 },
        Cushion::Han2005 {
            e: 0.85,
            mu: 0.2,
            height: 1.28,
        },
        Cushion::Mathavan2010 {
            e: 0.9,
            mu: 0.14,
            mu_cloth: 0.2,
            height: 1.4,
        },
    ];
    for case in 0..200 {
        let laws = Laws {
            cushion: Some(cushions[case % 4]),
            ..random_laws(&mut draws)
        };
        let root = 3.0_f64.sqrt();
        // two at the lower cushion, one on them, and one in the corner
        let places = [[R, R], [3.0 * R, R], [2.0 * R, R + root * R], [5.0 * R, R]];
        let balls: Vec<Ball> = places
            .into_iter()
            .map(|at| Ball {
                spin: [0, 1, 2].map(|_| draw(&mut draws, 1.0 / R)),
                ..ball(at, [draw(&mut draws, 1.0), draw(&mut draws, 1.0)])
            })
            .collect();
        let found = resolved::<f64>(&balls, laws);
        gains_nothing(&balls, &found, &format!("case {case}, {laws:?}"));
        for (a, v) in found.velocities.iter().enumerate() {
            for axis in 0..2 {
                let frozen = balls[a].at[axis] < R + 1e-9;
                assert!(
                    !frozen || v[axis] >= -1e-13,
                    "case {case}: ball {a} leaves {v:?}"
                );
            }
        }
    }
}

//! What balls that touch without closing in do next: which contacts carry a force, which part, which move alongside.
//!
//! The accelerations are those of a linear complementarity problem: forces `lambda >= 0`, openings `w = A lambda + b >= 0`, and one of each pair
//! zero. Every set of pressed contacts is tried; without friction all that answer give the same accelerations, and with it they mostly do. Where
//! they do not, nothing determines how the balls go on, and the run ends there.

use super::equations::Equations;
use super::group::{Change, Group, Hold, Member, Mode, Touch, Twist};
use crate::engine::exact::flight::Ground;
use crate::engine::exact::spin::Moving;
use crate::engine::exact::world::World;
use crate::math::Real;

/// Contacts of one group, at most: every set of them is tried.
pub const MOST_CONTACTS: usize = 10;

/// An acceleration below this part of those at work is none: what is left where they cancel.
const CANCELLED: f64 = 4096.0;

/// A ball whose slip or speed is no more than this many roundings of the fastest one has none.
const STILL: f64 = 256.0;

/// Rounds in which balls that turn out to move are let go.
const ROUNDS: usize = 16;

/// How balls that touch go on.
#[derive(Clone, Debug)]
pub struct Decision<T> {
    /// Members and contacts; those that part are left out of the contacts.
    pub group: Group<T>,
    /// Contacts that part.
    pub parting: Vec<Touch>,
}

/// Nothing determines how balls go on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Undetermined {
    /// The contacts, as positions in the list that was given.
    pub contacts: Vec<usize>,
    /// Why, in one sentence.
    pub why: &'static str,
}

/// How a ball that touches others moves: what is rounding of a slip or a speed is taken for none.
pub fn member<T: Real>(world: &World<T>, ball: usize, moving: Moving<T>) -> Member<T> {
    member_but_for(world, ball, moving, world.blur.speed * T::lift(STILL))
}

/// The same where a slip or a speed of no more than `still`, length/s, is none.
pub fn member_but_for<T: Real>(
    world: &World<T>,
    ball: usize,
    mut moving: Moving<T>,
    still: T,
) -> Member<T> {
    let zero = T::zero();
    let size = |[x, y]: [T; 2]| (x * x + y * y).sqrt();
    let radius = world.radius[ball];
    let twist = match world.rotation {
        Some(rotation) if rotation.spin > zero => {
            if moving.spin[2].abs() * radius <= still {
                moving.spin[2] = zero;
                Twist::Held
            } else {
                Twist::Falls(moving.spin[2] > zero)
            }
        }
        Some(_) => Twist::Free,
        None => Twist::Held,
    };
    let mode = match (world.rotation, world.ground) {
        (Some(rotation), _) if rotation.slide > zero => {
            let [x, y] = moving.velocity;
            let slip = [x - radius * moving.spin[1], y + radius * moving.spin[0]];
            if size(slip) > still {
                Mode::Slides
            } else {
                let part = T::lift(2.0) / T::lift(7.0);
                moving.velocity = [x - slip[0] * part, y - slip[1] * part];
                if size(moving.velocity) > still {
                    Mode::Rolls
                } else {
                    Mode::Rests
                }
            }
        }
        (Some(_), _) | (None, Ground::Frictionless) => Mode::Floats,
        (None, Ground::Coulomb(_)) => {
            if size(moving.velocity) > still {
                Mode::Drags
            } else {
                Mode::Rests
            }
        }
    };
    settle(radius, mode, &mut moving);
    Member {
        ball,
        moving,
        mode,
        twist,
    }
}

/// Sets what a mode makes of velocity and spin.
pub fn settle<T: Real>(radius: T, mode: Mode, moving: &mut Moving<T>) {
    let zero = T::zero();
    match mode {
        Mode::Rolls => {
            let [x, y] = moving.velocity;
            [moving.spin[0], moving.spin[1]] = [-y / radius, x / radius];
        }
        Mode::Rests => {
            moving.velocity = [zero; 2];
            [moving.spin[0], moving.spin[1]] = [zero; 2];
        }
        Mode::Slides | Mode::Drags | Mode::Floats => {}
    }
}

/// Decides how `members` go on that touch each other or cushions without closing in. `gone`: contacts whose force has just vanished; `changes`: what
/// else has just happened to members.
pub fn decide<T: Real>(
    world: &World<T>,
    mut members: Vec<Member<T>>,
    touches: &[Touch],
    gone: &[Touch],
    changes: &[Change],
) -> Result<Decision<T>, Undetermined> {
    let open: Vec<Touch> = touches
        .iter()
        .copied()
        .filter(|t| !gone.contains(t))
        .collect();
    let every = |why| Undetermined {
        contacts: (0..touches.len()).collect(),
        why,
    };
    if open.len() > MOST_CONTACTS {
        return Err(every(
            "too many contacts at once for every set of them to be tried",
        ));
    }
    let mut pushed = changes;
    for _ in 0..ROUNDS {
        let group = Group {
            members: members.clone(),
            holds: open
                .iter()
                .map(|touch| Hold {
                    touch: *touch,
                    pressed: false,
                })
                .collect(),
        };
        let states = contacts(world, &group)?;
        let group = Group {
            holds: open
                .iter()
                .zip(&states)
                .filter(|(_, state)| **state != State::Parts)
                .map(|(touch, state)| Hold {
                    touch: *touch,
                    pressed: *state == State::Presses,
                })
                .collect(),
            ..group
        };
        let equations = group.equations(world);
        if let Some(next) = let_go(world, &group, &equations, pushed) {
            pushed = &[];
            members = next;
            continue;
        }
        let parts = open
            .iter()
            .zip(&states)
            .filter(|(_, state)| **state == State::Parts);
        let parting = parts.map(|(touch, _)| *touch).chain(gone.iter().copied());
        return Ok(Decision {
            parting: parting.collect(),
            group,
        });
    }
    Err(every(
        "every state of the balls contradicts the forces that follow from it",
    ))
}

/// What becomes of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    Presses,
    Alongside,
    Parts,
}

/// Solves for the contacts of a group at its start.
fn contacts<T: Real>(world: &World<T>, group: &Group<T>) -> Result<Vec<State>, Undetermined> {
    let n = group.holds.len();
    let (matrix, free) = group.system(world);
    let scale = free.iter().fold(world.strongest().to_f64(), |most, b| {
        most.max(b.to_f64().abs())
    });
    let none = T::lift(CANCELLED * T::ULP * scale);
    let near = none * T::lift(8.0);
    let mut found: Option<(Vec<State>, Vec<T>)> = None;
    for set in 0_u32..1 << n {
        let pressed: Vec<usize> = (0..n).filter(|k| set & (1 << k) != 0).collect();
        let Some(force) = solved(&matrix, &free, &pressed) else {
            continue;
        };
        let opening: Vec<T> = (0..n)
            .map(|k| {
                let forced = (0..n).map(|l| matrix[k][l] * force[l]);
                forced.fold(free[k], |sum, part| sum + part)
            })
            .collect();
        // a force that is none belongs to the smaller set, which was tried
        let answers = (0..n).all(|k| {
            if pressed.contains(&k) {
                force[k] > none * smallest(world)
            } else {
                opening[k] >= -near
            }
        });
        if !answers {
            continue;
        }
        match &found {
            None => {
                let states = (0..n).map(|k| {
                    if pressed.contains(&k) {
                        State::Presses
                    } else if opening[k] > near {
                        State::Parts
                    } else {
                        State::Alongside
                    }
                });
                found = Some((states.collect(), opening));
            }
            Some((_, other)) => {
                let apart = other
                    .iter()
                    .zip(&opening)
                    .any(|(a, b)| (*a - *b).abs() > none * T::lift(16.0));
                if apart {
                    return Err(Undetermined {
                        contacts: (0..n).collect(),
                        why: "no single continuation",
                    });
                }
            }
        }
    }
    match found {
        Some((mut states, _)) => {
            tell_alongside(world, group, &mut states);
            Ok(states)
        }
        None => Err(Undetermined {
            contacts: (0..n).collect(),
            why: "no forces hold the balls together, and none let them part",
        }),
    }
}

/// A contact without force whose opening grows or shrinks parts or presses: what the opening itself does not tell, its rate does.
fn tell_alongside<T: Real>(world: &World<T>, group: &Group<T>, states: &mut [State]) {
    if !states.contains(&State::Alongside) {
        return;
    }
    let tried = Group {
        members: group.members.clone(),
        holds: group
            .holds
            .iter()
            .zip(states.iter())
            .map(|(hold, state)| Hold {
                pressed: *state == State::Presses,
                ..*hold
            })
            .collect(),
    };
    let mut equations = tried.equations(world);
    equations.tape.extend(1, T::one());
    let fastest = world.fastest.to_f64().max(f64::MIN_POSITIVE);
    let span = world.widest_distance() / fastest;
    // per second, where accelerations change within the time in which a ball crosses another
    let none = CANCELLED * T::ULP * world.strongest().to_f64() / span;
    for (k, state) in states.iter_mut().enumerate() {
        let Some(node) = equations.opening[k] else {
            continue;
        };
        if *state == State::Alongside {
            let rate = equations.tape.series(node)[1].to_f64();
            if rate > none {
                *state = State::Parts;
            } else if rate < -none {
                *state = State::Presses;
            }
        }
    }
}

/// The smallest mass.
fn smallest<T: Real>(world: &World<T>) -> T {
    let masses = world.mass.iter().copied();
    masses.reduce(T::at_most).unwrap_or_else(T::one)
}

/// The forces that keep the gaps of the `pressed` contacts closed; `None` where they do not follow from that.
fn solved<T: Real>(matrix: &[Vec<T>], free: &[T], pressed: &[usize]) -> Option<Vec<T>> {
    let n = pressed.len();
    let mut rows: Vec<Vec<T>> = pressed
        .iter()
        .map(|k| {
            let row = pressed.iter().map(|l| matrix[*k][*l]);
            row.chain([-free[*k]]).collect()
        })
        .collect();
    let largest = rows
        .iter()
        .flatten()
        .fold(T::zero(), |most, x| most.at_least(x.abs()));
    for pivot in 0..n {
        let best = (pivot..n).fold(pivot, |best, row| {
            if rows[row][pivot].abs() > rows[best][pivot].abs() {
                row
            } else {
                best
            }
        });
        rows.swap(pivot, best);
        if rows[pivot][pivot].abs() <= largest * T::lift(CANCELLED * T::ULP) {
            return None;
        }
        for row in 0..n {
            if row == pivot {
                continue;
            }
            let above = rows[pivot].clone();
            let factor = rows[row][pivot] / above[pivot];
            for (entry, above) in rows[row].iter_mut().zip(above).skip(pivot) {
                *entry -= factor * above;
            }
        }
    }
    let mut force = vec![T::zero(); free.len()];
    for (row, k) in pressed.iter().enumerate() {
        force[*k] = rows[row][n] / rows[row][row];
    }
    Some(force)
}

/// Members that do not stay as they are: one at rest pushed beyond its threshold, one that rolls without the grip for it, one that begins to turn
/// about the vertical. `None` if all stay.
fn let_go<T: Real>(
    world: &World<T>,
    group: &Group<T>,
    equations: &Equations<T>,
    pushed: &[Change],
) -> Option<Vec<Member<T>>> {
    let tape = &equations.tape;
    let mut members = group.members.clone();
    let mut any = false;
    for monitor in &equations.monitors {
        if tape.value(monitor.node) >= T::zero() && !pushed.contains(&monitor.change) {
            continue;
        }
        let creep = world.blur.speed * T::lift(4.0 * STILL);
        let (i, way) = match monitor.change {
            Change::Breaks(i) => (i, equations.pushed[i].map(|node| tape.value(node))),
            Change::Slips(i) => (i, equations.gripping[i].map(|node| -tape.value(node))),
            Change::Twists(i) => {
                let turn = tape.value(equations.couple[i]);
                members[i].twist = Twist::Falls(turn > T::zero());
                any = true;
                continue;
            }
            _ => continue,
        };
        let size = (way[0] * way[0] + way[1] * way[1]).sqrt();
        if size == T::zero() {
            continue;
        }
        any = true;
        let step = way.map(|x| x / size * creep);
        let member = &mut members[i];
        member.moving.velocity = [0, 1].map(|axis| member.moving.velocity[axis] + step[axis]);
        member.mode = match (monitor.change, member.mode) {
            (Change::Slips(_), _) => Mode::Slides,
            (_, Mode::Rests) if world.rotation.is_some() => {
                let radius = world.radius[member.ball];
                settle(radius, Mode::Rolls, &mut member.moving);
                Mode::Rolls
            }
            (_, Mode::Rests) => Mode::Drags,
            (_, mode) => mode,
        };
    }
    any.then_some(members)
}

//! What balls that touch without closing in do next: which contacts carry a force, which part, which move alongside.
//!
//! The accelerations are those of a linear complementarity problem: forces `lambda >= 0`, openings `w = A lambda + b >= 0`, and one of each pair
//! zero. Without friction all answers give the same accelerations, and with it they mostly do: there every set of pressed contacts is tried, unless
//! they are many. Where they do not, nothing determines how the balls go on, and the run ends there.

use super::equations::{Equations, Monitor, System};
use super::group::{Change, Group, Hold, Member, Mode, Touch, Twist, loudest};
use crate::engine::exact::flight::Ground;
use crate::engine::exact::spin::Moving;
use crate::engine::exact::world::World;
use crate::math::Real;
use crate::math::linear::Factors;

/// Contacts, at most, of which every set is tried where more than one answer is possible.
const TRIED: usize = 10;

/// Sets that are tried one after the other where there is one answer, for each contact.
const SETS: usize = 8;

/// An acceleration below this part of those at work is none: what is left where they cancel.
const CANCELLED: f64 = 4096.0;

/// A ball whose slip or speed is no more than this many roundings of how fast it moves and turns has none.
const STILL: f64 = 32.0;

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
    let still = world.grain(world.loudness(ball, &moving)) * T::lift(STILL);
    member_but_for(world, ball, moving, still)
}

/// The same, but its state is left as it is until [`tidy`].
pub fn member_as_is<T: Real>(world: &World<T>, ball: usize, moving: Moving<T>) -> Member<T> {
    Member {
        moving,
        ..member(world, ball, moving)
    }
}

/// Takes what is rounding of a slip, a speed or a spin out of a member that is going to be held.
pub fn tidy<T: Real>(world: &World<T>, m: &mut Member<T>) {
    let radius = world.radius[m.ball];
    if m.mode == Mode::Rolls {
        m.moving.end_slip(radius);
    }
    if m.twist == Twist::Held {
        m.moving.spin[2] = T::zero();
    }
    settle(radius, m.mode, &mut m.moving);
}

/// The same where a slip or a speed of no more than `still`, length/s, is none.
pub fn member_but_for<T: Real>(
    world: &World<T>,
    ball: usize,
    mut moving: Moving<T>,
    still: T,
) -> Member<T> {
    let zero = T::zero();
    let still = still.at_least(world.faint());
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
            if size(moving.slip(radius)) > still {
                Mode::Slides
            } else {
                moving.end_slip(radius);
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

/// A member whose velocity has been changed by what is nothing: what slips, rolls or drags no more has no direction in which it does. `none`: a slip of no
/// more than this, length/s, is over.
pub fn resettle<T: Real>(world: &World<T>, m: &mut Member<T>, none: T) {
    let radius = world.radius[m.ball];
    let is_over = |[x, y]: [T; 2]| x * x + y * y <= none * none;
    if m.mode == Mode::Slides && is_over(m.moving.slip(radius)) {
        m.moving.end_slip(radius);
        m.mode = Mode::Rolls;
    }
    let faint = world.faint();
    let stands = m.moving.velocity.iter().all(|v| v.abs() <= faint);
    if stands && matches!(m.mode, Mode::Rolls | Mode::Drags) {
        m.mode = Mode::Rests;
    }
    settle(radius, m.mode, &mut m.moving);
}

/// Sets what a mode makes of velocity and spin.
fn settle<T: Real>(radius: T, mode: Mode, moving: &mut Moving<T>) {
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
    let mut pushed = changes;
    for _ in 0..ROUNDS {
        let group = Group {
            members: members.clone(),
            holds: open.iter().map(|touch| Hold::open(*touch)).collect(),
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

/// Solves for the contacts of a group at its start: first those that move somebody, then those between members that rest, which hold them against
/// what pushes them.
fn contacts<T: Real>(world: &World<T>, group: &Group<T>) -> Result<Vec<State>, Undetermined> {
    let System {
        moving,
        free,
        loose,
    } = group.system(world);
    let scale = group.at_work(world).to_f64();
    let all = 0..group.holds.len();
    let rests = |k: &usize| group.rests(group.holds[*k].touch);
    let (held, loosened): (Vec<usize>, Vec<usize>) = all.clone().partition(rests);
    let complementary = |among: &[usize], matrix: &[Vec<T>], free: &[T]| {
        let part = |k: &usize| among.iter().map(|l| matrix[*k][*l]).collect();
        let matrix: Vec<Vec<T>> = among.iter().map(part).collect();
        let free: Vec<T> = among.iter().map(|k| free[*k]).collect();
        complementary(world, scale, &matrix, &free).map_err(|why| Undetermined {
            contacts: among.to_vec(),
            why,
        })
    };
    let mut states = vec![State::Alongside; group.holds.len()];
    let mut force = vec![T::zero(); group.holds.len()];
    let (found, forces) = complementary(&loosened, &moving, &free)?;
    for ((k, state), size) in loosened.iter().zip(found).zip(forces) {
        states[*k] = state;
        force[*k] = size;
    }
    let told = states.clone();
    tell_alongside(world, scale, group, &mut states);
    let pressed: Vec<usize> = all
        .clone()
        .filter(|k| states[*k] == State::Presses)
        .collect();
    if solved(&moving, &free, &pressed).is_none() {
        // one that presses there follows from the others
        states = told;
    }
    let pushed = all.map(|k| {
        let parts = force.iter().zip(&loose[k]);
        parts.fold(T::zero(), |sum, (force, part)| sum + *force * *part)
    });
    let pushed: Vec<T> = pushed.collect();
    let (found, _) = complementary(&held, &loose, &pushed)?;
    for (k, state) in held.iter().zip(found) {
        // who rests does not part
        if state == State::Presses {
            states[*k] = state;
        }
    }
    Ok(states)
}

/// A linear complementarity problem: forces and openings, none negative, and one of each pair zero.
struct Problem<'a, T> {
    /// What each force does to each opening.
    matrix: &'a [Vec<T>],
    /// The openings without forces.
    free: &'a [T],
    /// An opening is none up to this.
    none: T,
    /// A force is none up to this.
    weak: T,
}

/// What answers it.
struct Answer<T> {
    pressed: Vec<usize>,
    force: Vec<T>,
    opening: Vec<T>,
}

impl<T: Real> Problem<'_, T> {
    /// What follows if these contacts and no others carry forces.
    fn supposing(&self, pressed: Vec<usize>) -> Option<Answer<T>> {
        let force = solved(self.matrix, self.free, &pressed)?;
        let opening = (0..force.len()).map(|k| {
            let forced = self.matrix[k].iter().zip(&force);
            forced.fold(self.free[k], |sum, (a, f)| sum + *a * *f)
        });
        Some(Answer {
            opening: opening.collect(),
            pressed,
            force,
        })
    }

    /// Whether no force pulls and no gap closes. A force that is none belongs to the smaller set.
    fn is_met(&self, answer: &Answer<T>) -> bool {
        (0..self.free.len()).all(|k| {
            if answer.pressed.contains(&k) {
                answer.force[k] > self.weak
            } else {
                answer.opening[k] >= -self.near()
            }
        })
    }

    fn near(&self) -> T {
        self.none * T::lift(8.0)
    }

    /// By trying every set: finds whether there is more than one answer.
    fn every(&self) -> Result<Answer<T>, &'static str> {
        let n = self.free.len();
        let mut found: Option<Answer<T>> = None;
        for set in 0_u32..1 << n {
            let pressed = (0..n).filter(|k| set & (1 << k) != 0).collect();
            let Some(answer) = self.supposing(pressed) else {
                continue;
            };
            if !self.is_met(&answer) {
                continue;
            }
            let Some(known) = &found else {
                found = Some(answer);
                continue;
            };
            let mut both = known.opening.iter().zip(&answer.opening);
            if both.any(|(a, b)| (*a - *b).abs() > self.none * T::lift(16.0)) {
                return Err("no single continuation");
            }
        }
        found.ok_or(UNHELD)
    }

    /// By pressing the contact that closes most, again and again, and letting go of those that would pull (Lawson and Hanson): the accelerations that it ends
    /// at are the only ones wherever forces do work on their own contacts only, as without friction.
    fn one(&self) -> Result<Answer<T>, &'static str> {
        let n = self.free.len();
        let mut force = vec![T::zero(); n];
        let mut answer = self.supposing(Vec::new()).ok_or(UNHELD)?;
        for _ in 0..SETS * (n + 1) {
            let idle = (0..n).filter(|k| !answer.pressed.contains(k));
            let closing = idle.filter(|k| answer.opening[*k] < -self.near());
            let most = closing.reduce(|a, b| {
                if answer.opening[b] < answer.opening[a] {
                    b
                } else {
                    a
                }
            });
            let Some(most) = most else {
                break;
            };
            let mut pressed = answer.pressed.clone();
            pressed.push(most);
            loop {
                answer = self.supposing(pressed.clone()).ok_or(UNHELD)?;
                let pulls = pressed.iter().filter(|k| answer.force[**k] <= self.weak);
                // how far towards the forces of this set until the first vanishes
                let part = pulls.fold(T::one(), |part, k| {
                    let fall = force[*k] - answer.force[*k];
                    let reach = if fall > T::zero() {
                        force[*k] / fall
                    } else {
                        T::zero()
                    };
                    part.at_most(reach)
                });
                if pressed.iter().all(|k| answer.force[*k] > self.weak) {
                    force.clone_from(&answer.force);
                    break;
                }
                for k in &pressed {
                    let towards = answer.force[*k] - force[*k];
                    force[*k] += towards * part;
                }
                let before = pressed.len();
                pressed.retain(|k| answer.force[*k] > self.weak || force[*k] > self.weak);
                if pressed.len() == before {
                    return Err(UNHELD);
                }
                for k in (0..n).filter(|k| !pressed.contains(k)) {
                    force[k] = T::zero();
                }
            }
        }
        if self.is_met(&answer) {
            Ok(answer)
        } else {
            Err(UNHELD)
        }
    }
}

/// Why nothing is decided where no set of contacts answers.
const UNHELD: &str = "no forces hold the balls together, and none let them part";

/// Solves a linear complementarity problem; answers the states and the forces. `scale`: of the accelerations at work, length/s^2.
fn complementary<T: Real>(
    world: &World<T>,
    scale: f64,
    matrix: &[Vec<T>],
    free: &[T],
) -> Result<(Vec<State>, Vec<T>), &'static str> {
    let scale = free
        .iter()
        .fold(scale, |most, b| most.max(b.to_f64().abs()));
    let none = T::lift(CANCELLED * T::ULP * scale);
    let problem = Problem {
        matrix,
        free,
        none,
        weak: none * smallest(world),
    };
    let rubs = world.friction.is_some() && world.rotation.is_some();
    let answer = if rubs && free.len() <= TRIED {
        problem.every()?
    } else {
        problem.one()?
    };
    let states = (0..free.len()).map(|k| {
        if answer.pressed.contains(&k) {
            State::Presses
        } else if answer.opening[k] > problem.near() {
            State::Parts
        } else {
            State::Alongside
        }
    });
    Ok((states.collect(), answer.force))
}

/// A contact without force whose opening grows or shrinks parts or presses: what the opening itself does not tell, its rate does.
fn tell_alongside<T: Real>(world: &World<T>, scale: f64, group: &Group<T>, states: &mut [State]) {
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
    equations.tape.solve(1, T::one());
    let fastest = world.fastest.to_f64().max(f64::MIN_POSITIVE);
    let span = world.widest_distance() / fastest;
    // per second, where accelerations change within the time in which a ball crosses another
    let none = CANCELLED * T::ULP * scale / span;
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
    let row = |k: &usize| -> Vec<T> { pressed.iter().map(|l| matrix[*k][*l]).collect() };
    let rows: Vec<Vec<T>> = pressed.iter().map(row).collect();
    let entries = rows.iter().flatten();
    let largest = entries.fold(T::zero(), |most, x| most.at_least(x.abs()));
    let factors = Factors::of(rows, largest * T::lift(CANCELLED * T::ULP))?;
    let mut closing: Vec<T> = pressed.iter().map(|k| -free[*k]).collect();
    factors.solve(&mut closing);
    let mut force = vec![T::zero(); free.len()];
    for (k, size) in pressed.iter().zip(closing) {
        force[*k] = size;
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
    // who turns about the vertical moves nobody: whether it does is for the forces to say that are left when no one else is let go
    let twists = |monitor: &&Monitor| matches!(monitor.change, Change::Twists(_));
    let monitors = equations.monitors.iter();
    let (twisting, others): (Vec<&Monitor>, Vec<&Monitor>) = monitors.partition(twists);
    for monitor in others.into_iter().chain(twisting) {
        if tape.value(monitor.node) >= T::zero() && !pushed.contains(&monitor.change) {
            continue;
        }
        if any && matches!(monitor.change, Change::Twists(_)) {
            break;
        }
        let creep = world.grain(loudest(world, &group.members)) * T::lift(4.0 * STILL);
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
        let [x, y] = member.moving.velocity;
        let slips = matches!(monitor.change, Change::Slips(_));
        if slips && x * step[0] + y * step[1] > T::zero() {
            // the same slip by the spin, which takes energy where that of the centre would gain it
            let radius = world.radius[member.ball];
            member.moving.spin[0] += step[1] / radius;
            member.moving.spin[1] -= step[0] / radius;
        } else {
            member.moving.velocity = [x + step[0], y + step[1]];
        }
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

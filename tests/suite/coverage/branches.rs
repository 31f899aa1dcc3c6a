//! The branches of every law, from the code's own list of laws, and which of them a run went through.
//!
//! Every `match` is exhaustive, and [`laws`] is held against [`EFFECTS`]: a new law does not compile, or fails, until its branches stand
//! here. What a ball did is read from both sides of its events in the trace; what a law asks of two balls that meet is written anew.

use carom::math::Vec3;
use carom::physics::{Cloth, Contact, Cushion, EFFECTS, Effects, Friction, Pockets, Side, State};
use carom::scene::Scene;
use carom::trace::{EventKind, Trace};
use std::collections::BTreeSet;

/// A branch of a law in words, such as `friction.constant: sticks, equal masses, unequal radii`.
pub type Branch = String;

/// One law of the scene format, with numbers under which it acts.
#[derive(Clone, Debug)]
pub enum Law {
    /// Of the cloth.
    Cloth(Cloth),
    /// Of balls that meet.
    Contact(Contact),
    /// Of balls that rub.
    Friction(Friction),
    /// Of cushions.
    Cushion(Cushion),
    /// Of pockets.
    Pockets(Pockets),
}

/// Every law of [`EFFECTS`], in its order.
pub fn laws() -> Vec<Law> {
    let mut laws: Vec<Law> = vec![
        Law::Cloth(Cloth::Translational { mu: 0.2 }),
        Law::Cloth(Cloth::Rotational {
            mu_slide: 0.2,
            mu_roll: 0.01,
            mu_spin: 0.01,
        }),
        Law::Contact(Contact::Elastic {}),
        Law::Contact(Contact::Inelastic { e: 0.9 }),
        Law::Friction(Friction::Constant { mu: 0.06 }),
        Law::Friction(Friction::Alciatore {
            a: 9.951e-3,
            b: 0.108,
            c: 1.088,
            length_in_metres: 1.0,
        }),
        Law::Cushion(Cushion::Elastic {}),
        Law::Cushion(Cushion::Restitution { e: 0.7 }),
    ];
    laws.push(Law::Cushion(Cushion::Han2005 {
        e: 0.85,
        mu: 0.2,
        height: 1.28,
    }));
    laws.push(Law::Cushion(Cushion::Mathavan2010 {
        e: 0.98,
        mu: 0.14,
        mu_cloth: 0.212,
        height: 1.4,
    }));
    laws.push(Law::Pockets(Pockets {
        circles: vec![[0.5, 0.5, 0.1]],
    }));
    let ids: Vec<&str> = laws.iter().map(Law::id).collect();
    let listed: Vec<&str> = EFFECTS.iter().map(|entry| entry.id).collect();
    assert_eq!(ids, listed, "a law has no branches here");
    laws
}

const PAIRS: [&str; 4] = [
    "equal masses, equal radii",
    "unequal masses, equal radii",
    "equal masses, unequal radii",
    "unequal masses, unequal radii",
];

impl Law {
    fn id(&self) -> &'static str {
        match self {
            Law::Cloth(law) => law.id(),
            Law::Contact(law) => law.id(),
            Law::Friction(law) => law.id(),
            Law::Cushion(law) => law.id(),
            Law::Pockets(_) => Pockets::<f64>::ID,
        }
    }

    /// Its branches.
    pub fn branches(&self) -> Vec<Branch> {
        let ways: Vec<String> = match self {
            Law::Cloth(Cloth::Translational { .. }) => words(&["slides"]),
            Law::Cloth(Cloth::Rotational { .. }) => words(&[
                "slides",
                "rolls",
                "turns about the vertical on its way",
                "turns on the spot",
            ]),
            Law::Contact(Contact::Elastic {} | Contact::Inelastic { .. }) => {
                let rubs = ["smooth", "with friction"];
                let rubs = rubs.into_iter().map(str::to_owned);
                rubs.chain(words(&PAIRS)).collect()
            }
            Law::Friction(Friction::Constant { .. }) => rubbing(),
            Law::Friction(Friction::Alciatore { .. }) => {
                let mut ways = rubbing();
                ways.push("a length unit other than 1 m".to_owned());
                ways
            }
            Law::Cushion(Cushion::Elastic {} | Cushion::Restitution { .. }) => sides(),
            Law::Cushion(Cushion::Han2005 { .. }) => {
                let mut ways = sides();
                ways.extend(words(&["sticks", "slips"]));
                ways
            }
            Law::Cushion(Cushion::Mathavan2010 { .. }) => {
                let mut ways = sides();
                ways.extend(words(&[
                    "sticks to the nose, slips over the cloth",
                    "slips at both",
                    "sticks at both",
                    "slips at the nose, sticks to the cloth",
                ]));
                ways
            }
            Law::Pockets(Pockets { .. }) => words(&["a ball falls"]),
        };
        let id = self.id();
        ways.iter().map(|way| format!("{id}: {way}")).collect()
    }

    /// A scene with nothing but what the branch needs, to ask who can simulate it.
    pub fn smallest(&self, branch: &str, mut scene: Scene) -> Scene {
        let effects = &mut scene.effects;
        let contact = Some(Contact::Inelastic { e: 0.9 });
        *effects = Effects::default();
        match self.clone() {
            Law::Cloth(law) => effects.cloth = Some(law),
            Law::Contact(law) => effects.contact = Some(law),
            Law::Friction(law) => (effects.contact, effects.friction) = (contact, Some(law)),
            Law::Cushion(law) => effects.cushion = Some(law),
            Law::Pockets(law) => effects.pockets = Some(law),
        }
        if branch.contains("unequal masses") {
            scene.balls[0].mass *= 2.0;
        }
        if branch.contains("unequal radii") {
            scene.balls[0].radius *= 1.25;
            scene.balls[0].state.position.z *= 1.25;
        }
        scene
    }
}

fn words(ways: &[&str]) -> Vec<String> {
    ways.iter().map(|way| (*way).to_owned()).collect()
}

fn rubbing() -> Vec<String> {
    let both = ["sticks", "slips"].into_iter();
    both.flat_map(|way| PAIRS.map(|pair| format!("{way}, {pair}")))
        .collect()
}

fn sides() -> Vec<String> {
    Side::ALL.map(|side| format!("meets {}", side.id())).into()
}

/// A speed below this part of the largest of an impact is none: what solvers and steps leave of it.
const NONE: f64 = 1e-3;

/// Every branch that a run went through.
pub fn seen(scene: &Scene, trace: &Trace) -> BTreeSet<Branch> {
    let mut seen = BTreeSet::new();
    if let Some(law) = scene.effects.cloth {
        for (ball, path) in trace.paths.iter().enumerate() {
            for knots in path.knots.windows(2).filter(|k| k[1].time > k[0].time) {
                let way = on_cloth(law, &knots[0].state, scene.balls[ball].radius);
                seen.extend(way.map(|way| format!("{}: {way}", law.id())));
            }
        }
    }
    for (index, event) in trace.events.iter().enumerate() {
        let sides = |ball: u32| {
            let knots = &trace.paths[ball as usize].knots;
            let after = knots.iter().position(|k| k.after == Some(index as u32))?;
            let before = after.checked_sub(1)?;
            Some((knots[before].state, knots[after].state))
        };
        match event.kind {
            EventKind::BallBall(a, b) => {
                if let (Some((first, _)), Some((second, _))) = (sides(a), sides(b)) {
                    met(
                        scene,
                        [(a as usize, first), (b as usize, second)],
                        &mut seen,
                    );
                }
            }
            EventKind::BallCushion(ball, side) => {
                if let (Some(law), Some((before, after))) = (scene.effects.cushion, sides(ball)) {
                    let radius = scene.balls[ball as usize].radius;
                    let mut note = |way: &str| seen.insert(format!("{}: {way}", law.id()));
                    note(&format!("meets {}", side.id()));
                    if let Some(way) = at_nose(law, side, radius, &before, &after) {
                        note(way);
                    }
                }
            }
            EventKind::Pocket(..) => {
                seen.insert(format!("{}: a ball falls", Pockets::<f64>::ID));
            }
            EventKind::SlideToRoll(_)
            | EventKind::SpinEnd(_)
            | EventKind::Stop(_)
            | EventKind::ContactBegin(..)
            | EventKind::ContactEnd(..) => {}
        }
    }
    seen
}

fn on_cloth(law: Cloth, state: &State, radius: f64) -> Option<&'static str> {
    let (v, w) = (state.velocity, state.spin);
    let speed = v.norm();
    match law {
        Cloth::Translational { .. } => (speed > 0.0).then_some("slides"),
        Cloth::Rotational { .. } => {
            let slip = Vec3::new(v.x - radius * w.y, v.y + radius * w.x, 0.0).norm();
            let turning = radius * w.norm();
            if slip > NONE * speed.max(turning) && slip > 0.0 {
                Some("slides")
            } else if speed <= NONE * turning && w.z != 0.0 {
                Some("turns on the spot")
            } else if w.z != 0.0 {
                Some("turns about the vertical on its way")
            } else if speed > 0.0 {
                Some("rolls")
            } else {
                None
            }
        }
    }
}

/// What two balls ask of the laws, from how they came.
fn met(scene: &Scene, [(a, one), (b, two)]: [(usize, State); 2], seen: &mut BTreeSet<Branch>) {
    let Some(contact) = scene.effects.contact else {
        return;
    };
    let (first, second) = (&scene.balls[a], &scene.balls[b]);
    let pair =
        usize::from(first.mass != second.mass) + 2 * usize::from(first.radius != second.radius);
    let pair = PAIRS[pair];
    let rubs = match scene.effects.friction {
        None => "smooth",
        Some(_) => "with friction",
    };
    seen.insert(format!("{}: {rubs}", contact.id()));
    seen.insert(format!("{}: {pair}", contact.id()));
    let Some(friction) = scene.effects.friction else {
        return;
    };
    let e = match contact {
        Contact::Elastic {} => 1.0,
        Contact::Inelastic { e } => e,
    };
    let mut n = two.position - one.position;
    n.z = 0.0;
    let n = n.normalize();
    let relative = one.velocity - two.velocity;
    let closing = relative.dot(&n);
    let turning = one.spin * first.radius + two.spin * second.radius;
    let slip = (relative - n * closing + turning.cross(&n)).norm();
    if closing <= 0.0 || slip <= NONE * closing {
        return;
    }
    let mu = match friction {
        Friction::Constant { mu } => mu,
        Friction::Alciatore {
            a,
            b,
            c,
            length_in_metres,
        } => {
            if length_in_metres != 1.0 {
                seen.insert(format!("{}: a length unit other than 1 m", friction.id()));
            }
            a + b * (-c * slip * length_in_metres).exp()
        }
    };
    // per unit of the reduced mass: Coulomb's limit, and what ends the slip
    let slips = mu * (1.0 + e) * closing < 2.0 / 7.0 * slip;
    let way = if slips { "slips" } else { "sticks" };
    seen.insert(format!("{}: {way}, {pair}", friction.id()));
}

/// What a cushion with friction does; `None` for one without.
fn at_nose(
    law: Cushion,
    side: Side,
    radius: f64,
    before: &State,
    after: &State,
) -> Option<&'static str> {
    // x into the cushion, y along it
    let facing = |v: Vec3| match side {
        Side::X1 => v,
        Side::X0 => Vec3::new(-v.x, -v.y, v.z),
        Side::Y1 => Vec3::new(v.y, -v.x, v.z),
        Side::Y0 => Vec3::new(-v.y, v.x, v.z),
    };
    let nose = |height: f64| {
        let sin = height - 1.0;
        Vec3::new((1.0 - sin * sin).sqrt(), 0.0, sin)
    };
    let slip = |state: &State, n: Vec3| {
        let (v, w) = (facing(state.velocity), facing(state.spin));
        v - n * v.dot(&n) + w.cross(&n) * radius
    };
    match law {
        Cushion::Elastic {} | Cushion::Restitution { .. } => None,
        Cushion::Han2005 { e, mu, height } => {
            let n = nose(height);
            let closing = facing(before.velocity).dot(&n);
            let slips = mu * (1.0 + e) * closing < 2.0 / 7.0 * slip(before, n).norm();
            Some(if slips { "slips" } else { "sticks" })
        }
        Cushion::Mathavan2010 { height, .. } => {
            let none = NONE * before.velocity.norm();
            let cloth = Vec3::new(0.0, 0.0, -1.0);
            let [nose, cloth] = [nose(height), cloth].map(|n| slip(after, n).norm() > none);
            Some(match (nose, cloth) {
                (false, true) => "sticks to the nose, slips over the cloth",
                (true, true) => "slips at both",
                (false, false) => "sticks at both",
                (true, false) => "slips at the nose, sticks to the cloth",
            })
        }
    }
}

//! Holds what an engine says is inside it against the scene, before anything runs.
//!
//! A scene that did not arrive as written makes every later number worthless, and nothing later would notice.

use crate::math::within;
use crate::physics::{Cloth, Contact, Cushion, State, friction};
use crate::scene::{Ball, Scene};

/// What an engine holds, read back from inside it and not from what it was given.
#[derive(Clone, Debug, PartialEq)]
pub struct Inside {
    /// Every ball in scene order.
    pub balls: Vec<Ball>,
    /// Moment of inertia of every ball; `None` where the engine does not let it rotate.
    pub inertia: Vec<Option<f64>>,
    /// Kinetic energy as the engine computes it.
    pub energy: f64,
    /// Effective friction and restitution of every kind of pair, after any combination rule.
    pub materials: Vec<PairMaterial>,
    /// Spacing of the engine's numbers just above 1: 2.2e-16 in f64, 1.2e-7 in f32.
    pub ulp: f64,
    /// Contact time of the shot, s, where a setting replaces the scene's; the launch is then held against this one.
    pub contact_time: Option<f64>,
}

/// What a ball can meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Partner {
    /// Another ball.
    Ball,
    /// The cloth.
    Cloth,
    /// A cushion.
    Cushion,
}

/// Effective material of the contact of a ball with a partner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairMaterial {
    /// Index of the ball.
    pub ball: usize,
    /// What it meets.
    pub partner: Partner,
    /// Effective coefficient of friction.
    pub friction: f64,
    /// Effective coefficient of restitution.
    pub restitution: f64,
}

/// Every difference between a scene and what an engine holds, each in one sentence.
///
/// Numbers may differ by 4 ulp of the engine's scalar (a product and a quotient of rounded inputs), relative to the
/// larger of the two. The kinetic energy may differ by 8 ulp and one for every ball: rounding its inputs to the scalar
/// costs half an ulp each (squared velocity 1, mass 1/2), an engine that stores 1/m another 1, the six operations of
/// `m v^2 / 2` at most 2, so 4.5 on its side and 2 on ours, and each sum over n balls of one sign (n - 1) / 2.
///
/// A ball that rolls by the rule of [`Scene::start`] may also be held with the spin of natural roll to the last digit: of a component that is small
/// beside the velocity that is another number.
///
/// A velocity or spin whose square is smaller than the smallest number of the scalar may be 0: it carries no energy that the
/// scalar can hold, and engines that compute a speed from its square call it rest. A coordinate that is itself smaller may be 0.
pub fn differences(scene: &Scene, inside: &Inside) -> Vec<String> {
    match inside
        .contact_time
        .and_then(|contact_time| scene.launched_for(contact_time))
    {
        Some(launched) => differences_from(&launched, inside),
        None => differences_from(scene, inside),
    }
}

fn differences_from(scene: &Scene, inside: &Inside) -> Vec<String> {
    let mut check = Check {
        ulp: inside.ulp,
        found: Vec::new(),
    };
    if inside.balls.len() != scene.balls.len() {
        check.found.push(format!(
            "{} balls instead of {}",
            inside.balls.len(),
            scene.balls.len()
        ));
        return check.found;
    }
    let mut meant = Vec::with_capacity(scene.balls.len());
    for (i, (got, want)) in inside.balls.iter().zip(&scene.balls).enumerate() {
        let rolls = scene.rolling_start(i);
        let state = match check.is_as(&got.state, &rolls) && !check.is_as(&got.state, &want.state) {
            true => rolls,
            false => want.state,
        };
        meant.push(state);
        let at = |what: &str| format!("{what} of ball {}", want.id);
        if got.id != want.id {
            check
                .found
                .push(format!("ball {} is called {}", want.id, got.id));
        }
        let vectors = [
            ("position", got.state.position, state.position),
            ("velocity", got.state.velocity, state.velocity),
            ("spin", got.state.spin, state.spin),
        ];
        for (what, g, w) in vectors {
            for (axis, name) in ["x", "y", "z"].iter().enumerate() {
                let (g, w) = (g[axis], w[axis]);
                let size = if what == "position" { w.abs() } else { w * w };
                let lost = g == 0.0 && size < check.smallest();
                if !lost {
                    check.number(|| at(&format!("{what} {name}")), g, w);
                }
            }
        }
        check.number(|| at("mass"), got.mass, want.mass);
        check.number(|| at("radius"), got.radius, want.radius);
        check.inertia(
            || at("inertia"),
            inside.inertia.get(i).copied().flatten(),
            scene.inertia(i),
        );
    }
    let energy_ulps = 8.0 + scene.balls.len() as f64;
    let mass: f64 = scene.balls.iter().map(|ball| ball.mass).sum();
    let energies = [inside.energy, scene.kinetic_energy(&meant)];
    if energies
        .iter()
        .any(|energy| !within(*energy, mass * check.smallest()))
    {
        let [inside, energy] = energies;
        check.within(energy_ulps, || "kinetic energy".to_owned(), inside, energy);
    }
    check.materials(scene, inside);
    check.found
}

struct Check {
    ulp: f64,
    found: Vec<String>,
}

impl Check {
    /// The smallest normal number of the engine's scalar.
    fn smallest(&self) -> f64 {
        if self.ulp > f64::EPSILON {
            f64::from(f32::MIN_POSITIVE)
        } else {
            f64::MIN_POSITIVE
        }
    }

    fn number(&mut self, what: impl FnOnce() -> String, got: f64, want: f64) {
        self.within(4.0, what, got, want);
    }

    /// Whether velocity and spin are those of a state.
    fn is_as(&self, got: &State, want: &State) -> bool {
        let near = |(g, w): (&f64, &f64)| self.is_near(4.0, *g, *w);
        got.velocity.iter().zip(&want.velocity).all(near)
            && got.spin.iter().zip(&want.spin).all(near)
    }

    fn is_near(&self, ulps: f64, got: f64, want: f64) -> bool {
        let bound = ulps * self.ulp * got.abs().max(want.abs());
        // what is not finite is like itself alone, and a NaN like nothing
        got == want || within((got - want).abs(), bound)
    }

    /// `what` is put into words only if it differs.
    fn within(&mut self, ulps: f64, what: impl FnOnce() -> String, got: f64, want: f64) {
        if !self.is_near(ulps, got, want) {
            self.found
                .push(format!("{} is {got} instead of {want}", what()));
        }
    }

    fn inertia(&mut self, what: impl FnOnce() -> String, got: Option<f64>, want: Option<f64>) {
        match (got, want) {
            (Some(g), Some(w)) => self.number(what, g, w),
            (None, None) => {}
            (Some(g), None) => self.found.push(format!(
                "{} is {g}, but the scene calls for no rotation",
                what()
            )),
            (None, Some(w)) => {
                self.found
                    .push(format!("{} is locked instead of {w}", what()));
            }
        }
    }

    fn materials(&mut self, scene: &Scene, inside: &Inside) {
        let mut of_balls: Vec<Vec<&PairMaterial>> = vec![Vec::new(); scene.balls.len()];
        for material in &inside.materials {
            if let Some(of_ball) = of_balls.get_mut(material.ball) {
                of_ball.push(material);
            }
        }
        for (ball, of_ball) in of_balls.iter().enumerate() {
            for partner in expected_partners(scene) {
                let at = |what: &str| {
                    format!("{what} of ball {} with a {partner:?}", scene.balls[ball].id)
                };
                let (friction, restitution) = expected_material(scene, partner);
                let mut materials = of_ball.iter().filter(|m| m.partner == partner).peekable();
                if materials.peek().is_none() {
                    self.found.push(at("no material"));
                }
                for material in materials {
                    self.number(|| at("friction"), material.friction, friction);
                    self.number(|| at("restitution"), material.restitution, restitution);
                }
            }
        }
    }
}

fn expected_partners(scene: &Scene) -> Vec<Partner> {
    let mut partners = Vec::new();
    if scene.effects.contact.is_some() && scene.balls.len() > 1 {
        partners.push(Partner::Ball);
    }
    if scene.effects.cloth.is_some() {
        partners.push(Partner::Cloth);
    }
    if scene.effects.cushion.is_some() && scene.table.is_some() {
        partners.push(Partner::Cushion);
    }
    partners
}

/// Friction and restitution that the scene's laws mean for a partner.
fn expected_material(scene: &Scene, partner: Partner) -> (f64, f64) {
    match partner {
        Partner::Ball => {
            // where it depends on the slip speed, that of balls that stick
            let law = scene.effects.friction;
            let friction = law.map_or(0.0, |law| friction::coefficient(law, 0.0));
            match scene.effects.contact {
                Some(Contact::Elastic {}) => (friction, 1.0),
                Some(Contact::Inelastic { e }) => (friction, e),
                None => (0.0, 0.0),
            }
        }
        Partner::Cloth => match scene.effects.cloth {
            Some(Cloth::Translational { mu }) => (mu, 0.0),
            Some(Cloth::Rotational { mu_slide, .. }) => (mu_slide, 0.0),
            None => (0.0, 0.0),
        },
        Partner::Cushion => match scene.effects.cushion {
            Some(Cushion::Elastic {}) => (0.0, 1.0),
            Some(Cushion::Restitution { e }) => (0.0, e),
            Some(Cushion::Han2005 { e, mu, .. } | Cushion::Mathavan2010 { e, mu, .. }) => (mu, e),
            None => (0.0, 0.0),
        },
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::{Inside, PairMaterial, differences, expected_material, expected_partners};
    use crate::scene::{Scene, catalogue};

    /// What an engine holds that holds the scene as written.
    fn inside(scene: &Scene) -> Inside {
        let partners = expected_partners(scene);
        let materials = (0..scene.balls.len()).flat_map(|ball| {
            partners.iter().map(move |partner| {
                let (friction, restitution) = expected_material(scene, *partner);
                PairMaterial {
                    ball,
                    partner: *partner,
                    friction,
                    restitution,
                }
            })
        });
        Inside {
            balls: scene.balls.clone(),
            inertia: (0..scene.balls.len())
                .map(|ball| scene.inertia(ball))
                .collect(),
            energy: scene.initial_energy(),
            materials: materials.collect(),
            ulp: f64::EPSILON,
            contact_time: None,
        }
    }

    #[test]
    fn what_is_infinite_inside_an_engine_is_not_what_the_scene_says() {
        type Plant = fn(&mut Inside, f64);
        let plants: [(&str, Plant); 6] = [
            ("kinetic energy", |i, x| i.energy = x),
            ("mass of ball 1", |i, x| i.balls[1].mass = x),
            ("radius of ball cue", |i, x| i.balls[0].radius = x),
            ("position y of ball cue", |i, x| {
                i.balls[0].state.position.y = x
            }),
            ("velocity x of ball 1", |i, x| {
                i.balls[1].state.velocity.x = x
            }),
            ("restitution of ball cue", |i, x| {
                i.materials[0].restitution = x
            }),
        ];
        let scene = catalogue::scene("head-on").unwrap();
        assert_eq!(differences(&scene, &inside(&scene)), [""; 0]);
        for (what, plant) in plants {
            for x in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN, f64::MAX] {
                let mut inside = inside(&scene);
                plant(&mut inside, x);
                let found = differences(&scene, &inside);
                let told = matches!(&found[..], [one] if one.starts_with(what));
                assert!(told, "{what} {x}: {found:?}");
            }
        }
    }
}

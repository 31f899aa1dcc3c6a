//! A newcomer's engine, written by `World` alone: discs that slide, hit each other and are turned back by cushions.

use carom::engine::stepped::materials::{self, Material};
use carom::engine::stepped::{Load, Other, Push, World, WorldEngine};
use carom::engine::{Inside, Name, Partner};
use carom::math::Vec3;
use carom::physics::{Side, State};
use carom::scene::Scene;

pub struct Discs {
    scene: Scene,
    met: [(Partner, Option<Material>); 3],
    slowed: fn(Vec3, f64) -> Vec3,
    pushes: Vec<Push>,
}

pub fn along_the_motion() -> WorldEngine<Discs> {
    engine(|scene| discs(scene, |v, lost| v * (1.0 - (lost / v.norm()).min(1.0))))
}

/// Friction along each axis by itself: wrong.
pub fn along_each_axis() -> WorldEngine<Discs> {
    engine(|scene| discs(scene, |v, lost| v.map(|x| x - x.clamp(-lost, lost))))
}

fn engine(world: fn(&Scene) -> Discs) -> WorldEngine<Discs> {
    let discs = WorldEngine::new("discs", world);
    WorldEngine { missing, ..discs }
}

fn missing(scene: &Scene) -> Vec<Name> {
    let lacks = ["rotational", "friction.", "han-", "mathavan-", "pockets"];
    let named = scene.effects.named().into_iter();
    let missing = named.filter(|id| lacks.iter().any(|lacks| id.contains(lacks)));
    let radii = (!scene.equal_radii()).then_some("balls of unequal radii");
    missing.chain(radii).map(Name::from).collect()
}

fn discs(scene: &Scene, slowed: fn(Vec3, f64) -> Vec3) -> Discs {
    let effects = &scene.effects;
    Discs {
        scene: scene.clone(),
        met: [
            (
                Partner::Ball,
                effects.contact.map(|_| materials::balls(effects)),
            ),
            (Partner::Cloth, materials::cloth(effects)),
            (Partner::Cushion, materials::cushion(effects)),
        ],
        slowed,
        pushes: Vec::new(),
    }
}

impl Discs {
    fn push(&mut self, push: Push) {
        let ball = &mut self.scene.balls[push.ball];
        ball.state.velocity += push.impulse / ball.mass;
        if let Other::Ball(other) = push.other {
            let other = &mut self.scene.balls[other];
            other.state.velocity -= push.impulse / other.mass;
        }
        self.pushes.push(push);
    }
    fn hit(&mut self, a: usize, b: usize, e: f64) {
        let (one, two) = (&self.scene.balls[a], &self.scene.balls[b]);
        let apart = two.state.position - one.state.position;
        let normal = apart.normalize();
        let closing = (one.state.velocity - two.state.velocity).dot(&normal);
        let mass = one.mass * two.mass / (one.mass + two.mass);
        if apart.norm() < one.radius + two.radius && closing > 0.0 {
            let impulse = -(1.0 + e) * closing * mass * normal;
            self.push(Push::new(a, Other::Ball(b), impulse));
        }
    }
    fn bounce(&mut self, ball: usize, side: Side, e: f64) {
        let (body, mut normal) = (&self.scene.balls[ball], Vec3::zeros());
        normal[side.axis()] = f64::from(side.sign());
        let reach = self.scene.reach(side, body.radius).unwrap_or(f64::NAN);
        let beyond = normal.dot(&body.state.position) - normal[side.axis()] * reach;
        let closing = normal.dot(&body.state.velocity);
        if beyond > 0.0 && closing > 0.0 {
            let impulse = -(1.0 + e) * closing * body.mass * normal;
            self.push(Push::new(ball, Other::Cushion(side), impulse));
        }
    }
}

impl World for Discs {
    fn step(&mut self, dt: f64) {
        self.pushes.clear();
        let [e, mu, cushion] = self.met.map(|(_, material)| material);
        let lost = mu.map_or(0.0, |cloth| cloth.friction) * self.scene.gravity * dt;
        for ball in &mut self.scene.balls {
            ball.state.velocity = (self.slowed)(ball.state.velocity, lost);
            ball.state.position += ball.state.velocity * dt;
        }
        for a in 0..self.scene.balls.len() {
            if let Some(ball) = e {
                (a + 1..self.scene.balls.len()).for_each(|b| self.hit(a, b, ball.restitution));
            }
            if let Some(cushion) = cushion {
                (Side::ALL.iter()).for_each(|&side| self.bounce(a, side, cushion.restitution));
            }
        }
    }
    fn read(&self, states: &mut Vec<State>) {
        *states = self.scene.balls.iter().map(|ball| ball.state).collect();
    }
    fn pushes(&self, pushes: &mut Vec<Push>) {
        pushes.clone_from(&self.pushes);
    }
    fn inside(&self) -> Inside {
        materials::inside(&self.scene.balls, &self.met)
    }
    fn remove(&mut self, _: usize) {}
    fn load(&mut self, _ball: usize, _load: &Load) {}
    fn presses(&self, _presses: &mut Vec<f64>) {}
}

//! An engine by `World`: balls that slide to rest, half a step at a time, against the exact answer v^2 / (2 mu g).
#![allow(clippy::print_stdout)]

use carom::engine::stepped::{Load, Push, World, WorldEngine, materials};
use carom::engine::{Inside, Limits, Partner, Roster, Setting, prepare};
use carom::{physics::State, scene::Scene, trace::Record};

struct Sliding(Scene);

impl World for Sliding {
    fn step(&mut self, dt: f64) {
        let mu = materials::cloth(&self.0.effects).map_or(0.0, |cloth| cloth.friction);
        for State { position, velocity, .. } in self.0.balls.iter_mut().map(|ball| &mut ball.state) {
            let lost = (mu * self.0.gravity * dt / velocity.norm()).min(1.0);
            *position += *velocity * (1.0 - lost / 2.0) * dt;
            *velocity *= 1.0 - lost;
        }
    }
    fn read(&self, states: &mut Vec<State>) {
        *states = self.0.initial_states();
    }
    fn inside(&self) -> Inside {
        materials::inside(&self.0.balls, &[(Partner::Cloth, materials::cloth(&self.0.effects))])
    }
    fn pushes(&self, _: &mut Vec<Push>) {}
    fn remove(&mut self, _: usize) {}
    fn load(&mut self, _: usize, _: &Load) {}
    fn presses(&self, _: &mut Vec<f64>) {}
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let roster = Roster::built_in().with(WorldEngine::new("sliding", |scene| Sliding(scene.clone())))?;
    let scene = carom::scene::catalogue::scene("slide")?;
    for engine in &roster {
        let run = prepare(&**engine, &scene, &Setting::default())?;
        let trace = run.simulate(Record::events(), &Limits::NONE);
        println!("{:10} {:?}", engine.id(), trace.final_states()[0].map(|ball| ball.position));
    }
    Ok(())
}
